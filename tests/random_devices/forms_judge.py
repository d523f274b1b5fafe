"""Forms of specs as a judge: all outputs of a device are those of the same device in other words, byte by byte."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.reading.project import read
from fieldspec.targets import OUTPUTS, Output
from random_devices.devices import text_of
from random_devices.draft import Spec
from random_devices.other_forms import DEVICE, Files, flat, overlaid, split, with_bits_from_most, with_frames

MOST_OUTPUTS = 4
"""The outputs that are compared of one device; others are those of the next."""
_TELLS_FORMS = ("docs",)
"""The outputs that say how the manual numbers bits, and which versions have a fact."""
_FORMS = re.compile(r"\b(Since|Until|Only)( in)? [0-9., ]*[0-9]\.|\"remark\": \"Bit 0 is the least[^\"]*\", ")
"""The words of other outputs that say so."""


def forms_agree(spec: Spec, layouts: list[DeviceLayout], dice: random.Random) -> Iterator[str]:
    """The outputs that differ between a spec and the same device in other words."""
    names = sorted(OUTPUTS)
    chosen = dice.sample(names, MOST_OUTPUTS)
    silent = [name for name in chosen if name not in _TELLS_FORMS]
    if "versions" in spec:
        for layout in layouts:
            version = layout.device.version
            yield from _differences(f"version {version}", layout, {DEVICE: flat(spec, version)}, silent)
        overlay = overlaid(spec, dice)
        if overlay is not None:
            files, changed = overlay
            version = layouts[-1].device.version
            own = read_layout({DEVICE: changed}, version)
            if isinstance(own, DeviceLayout):
                yield from _differences(f"overlay {version}", own, files, silent)
        return
    if flat(spec) != spec:
        yield from _differences("what is listed", layouts[0], {DEVICE: flat(spec)}, chosen)
    yield from _differences("the protocol", layouts[0], split(spec, dice), chosen)
    framed = with_frames(spec)
    if framed is not None:
        yield from _differences("frames that are stated once", layouts[0], {DEVICE: framed}, chosen)
    turned = with_bits_from_most(spec)
    if turned is not None:
        yield from _differences("bits counted from the other end", layouts[0], {DEVICE: turned}, silent)


def read_layout(files: Files, version: str) -> DeviceLayout | str:
    """The layout of a version of the device in some files; the first finding where they have some."""
    project = read({path: text_of(content).encode() for path, content in files.items()})
    if has_errors(project.findings):
        return next(
            f"{finding.code}: {finding.message}" for finding in project.findings if finding.severity.name == "ERROR"
        )
    return device_layout(project.devices["chance"].at(version)[0])


def _differences(form: str, layout: DeviceLayout, files: Files, names: list[str]) -> Iterator[str]:
    other = read_layout(files, layout.device.version)
    if isinstance(other, str):
        yield f"forms: {form} has a finding: {other}"
        return
    if layout.identity != other.identity:
        yield f"forms: {form} has another identity"
    for output in OUTPUTS.values():
        if output.name in names and (text := _difference(output, layout, other)):
            yield f"forms: {form} differs in {output.name}: {text}"
            return


def _difference(output: Output, layout: DeviceLayout, other: DeviceLayout) -> str:
    """The first line in which the files of two layouts differ; empty where none does."""
    refused = [has_errors(output.refusals([each])) for each in (layout, other)]
    if any(refused):
        return "" if all(refused) else "one of them is refused"
    own, theirs = (output.files([each]) for each in (layout, other))
    if own.keys() != theirs.keys():
        return f"the files {sorted(own.keys() ^ theirs.keys())}"
    for path, text in own.items():
        if not isinstance(text, str):
            continue
        lines, others = _bare(text), _bare(str(theirs[path]))
        pairs = zip(lines, others, strict=False)
        place = next((number for number, (left, right) in enumerate(pairs) if left != right), -1)
        if place >= 0 or len(lines) != len(others):
            return f"{path}: {_beside(lines[place], others[place])}"
    return ""


def _bare(text: str) -> list[str]:
    """The lines of a file without the words that say how the spec states it."""
    lines = (line.rstrip() for line in _FORMS.sub("", text).splitlines())
    return [line for line in lines if line.strip(" */#")]


def _beside(line: str, other: str) -> str:
    """Two lines from where they begin to differ."""
    place = next((at for at, (left, right) in enumerate(zip(line, other, strict=False)) if left != right), 0)
    return f"`{line[max(0, place - 60) : place + 60]}` and `{other[max(0, place - 60) : place + 60]}`"
