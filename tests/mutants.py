"""Counts which slips in the specs of the devices are noticed: `make mutants`, or `python mutants.py [EACH] [SEED]`.

Each slip is judged alone, by what is in the repository beside the outputs: checks, proofs of examples and errata, the
index of the manual, and the vectors. The outputs would differ in any case, and so would the hashes of reviews; neither
is asked.
"""

from __future__ import annotations

import json
import sys
from collections import Counter
from collections.abc import Iterator, Mapping
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.codec.reference import CodecError, codec
from fieldspec.language.changes.table import changes
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.model.device import Device
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import read
from fieldspec.tools.audit.coverage import coverage
from fieldspec.tools.audit.manual_lines import NAME, ManualIndex, parsed
from fieldspec.tools.audit.section import Subject
from fieldspec.tools.facts import rows
from fieldspec.tools.proofs.running import EXAMPLE_PROOFS, Outcome, outcome
from spec_mutants import KINDS, Slip, slips

ROOT = Path(__file__).resolve().parent.parent
SPECS, VECTORS = ROOT / "specs", ROOT / "generated" / "vectors"
DEVICES = ("ck10", "esc11", "hiwin-e", "tc100")
PROCESSES = 2
EACH = 40

JUDGES = ("checks", "examples", "errata", "manual", "vectors")
"""In the order in which they are asked; the last two are asked where the ones before find nothing."""


@dataclass(frozen=True)
class Verdict:
    """The judge that notices a slip, or none. `wire` is whether the identity of the device differs, or it has none."""

    device: str
    slip: Slip
    wire: bool
    judge: str
    rules: tuple[str, ...] = ()


@cache
def files() -> dict[str, bytes]:
    return {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in sorted(SPECS.glob("*/*.yaml"))}


@cache
def right(device: str) -> DeviceSpec:
    return read(files(), frozenset({device})).devices[device]


@cache
def right_layouts(device: str) -> dict[str, DeviceLayout]:
    return {version: device_layout(right(device).at(version)[0]) for version in right(device).versions()}


@cache
def index(device: str) -> ManualIndex:
    path = SPECS / device / NAME
    return parsed(str(path), path.read_text("utf-8"))


@cache
def recorded(device: str) -> list[dict[str, Any]]:
    vectors: list[dict[str, Any]] = json.loads((VECTORS / f"{device}.json").read_text("utf-8"))["vectors"]
    return vectors


def judged(device: str, slip: Slip) -> Verdict | None:
    """The verdict about a slip; None where it changes nothing that the spec means."""
    project = read(slip.applied(files()), frozenset({device}))
    if has_errors(project.findings) or device not in project.devices:
        return Verdict(device, slip, True, "checks", _codes(project.findings))
    spec = project.devices[device]
    models = {version: spec.at(version)[0] for version in spec.versions()}
    proven = outcome(spec)
    if not proven.findings and not any(_differences(device, models)):
        return None
    wire = not _same_identities(device, models, proven)
    if proven.findings:
        codes = {finding.code for finding in proven.findings}
        examples = codes & {*EXAMPLE_PROOFS, "example_decodes"}
        errata = {code for code in codes if code.startswith("errata")}
        judge = "checks" if codes - examples - errata else "examples" if examples else "errata"
        return Verdict(device, slip, wire, judge, _codes(proven.findings))
    layouts = tuple(proven.layouts[version] for version in spec.versions())
    section = coverage(Subject(spec, layouts[-1], layouts, tuple(map(rows, layouts)), (), index(device), None))
    if section.findings:
        return Verdict(device, slip, wire, "manual", _codes(section.findings))
    return Verdict(device, slip, wire, "vectors" if _vectors_differ(device, proven.layouts) else "")


def _codes(findings: Any) -> tuple[str, ...]:
    return tuple(sorted({finding.code for finding in findings}))


def _differences(device: str, models: Mapping[str, Device]) -> Iterator[bool]:
    for version, model in models.items():
        if version not in right(device).versions():
            yield True
        else:
            yield bool(changes(right(device).at(version)[0], model))


def _same_identities(device: str, models: Mapping[str, Device], proven: Outcome) -> bool:
    """Whether all versions still have the bytes of the right spec. A device with findings may have no layout."""
    for version, model in models.items():
        known = right_layouts(device).get(version)
        if known is None:
            return False
        try:
            layout = proven.layouts.get(version) or device_layout(model)
        except (AssertionError, KeyError, IndexError, ValueError):
            return False
        if layout.identity != known.identity:
            return False
    return True


def _vectors_differ(device: str, layouts: Mapping[str, DeviceLayout]) -> bool:
    """Whether a recorded frame is read differently."""
    codecs = {version: codec(layout) for version, layout in layouts.items()}
    for vector in recorded(device):
        for version in vector["versions"]:
            try:
                link = codecs[version].links[vector["link"]]
                decoded = link.decode(bytes.fromhex(vector["right"]), vector["direction"], vector["message"] or "")
                values, refused = {**decoded.head, **decoded.values}, None
            except CodecError as error:
                values, refused = None, error.reason
            if refused != vector["refused"] or _as_json(values) != vector["values"]:
                return True
    return False


def _as_json(raw: Any) -> Any:
    """A raw value as the vectors have it."""
    if isinstance(raw, bytes):
        return raw.hex()
    if isinstance(raw, list):
        return [_as_json(item) for item in raw]
    return {name: _as_json(item) for name, item in raw.items()} if isinstance(raw, dict) else raw


def verdicts(each: int, seed: int, processes: int = PROCESSES) -> list[Verdict]:
    """The verdicts about some slips of each kind in each device."""
    sample = [(device, slip) for device in DEVICES for slip in slips(right(device), each, seed)]
    if processes == 1:
        results = [judged(*item) for item in sample]
    else:
        with ProcessPoolExecutor(processes) as pool:
            results = list(pool.map(judged, *zip(*sample, strict=True), chunksize=8))
    return [verdict for verdict in results if verdict is not None]


def table(results: list[Verdict]) -> Iterator[str]:
    """The share of slips that are noticed, as rows of Markdown, by kind."""
    yield "| slip in | on the wire | noticed | others | noticed | " + " | ".join(JUDGES) + " |"
    yield "|---" * (5 + len(JUDGES)) + "|"
    for kind in (*KINDS, "all"):
        own = [verdict for verdict in results if kind in ("all", verdict.slip.kind)]
        wire, others = [v for v in own if v.wire], [v for v in own if not v.wire]
        judges = Counter(verdict.judge for verdict in own)
        cells = [*_share(wire), *_share(others), *(str(judges[judge]) for judge in JUDGES)]
        yield f"| {kind} | " + " | ".join(cells) + " |"


def _share(some: list[Verdict]) -> tuple[str, str]:
    noticed = sum(bool(verdict.judge) for verdict in some)
    return str(len(some)), f"{noticed} ({100 * noticed / len(some):.1f} %)" if some else ""


def main(each: int = EACH, seed: int = 1) -> int:
    """Prints the table and every slip that nobody notices."""
    results = verdicts(each, seed)
    print("\n".join(table(results)))
    print()
    for verdict in results:
        if not verdict.judge:
            slip = verdict.slip
            on = "wire" if verdict.wire else "other"
            print(f"{on}: {slip.kind}: specs/{slip.path}:{slip.line}: {slip.key}: {slip.right} -> {slip.wrong}")
    return 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
