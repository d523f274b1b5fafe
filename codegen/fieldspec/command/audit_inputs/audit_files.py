"""The files of an audit: the text of a manual, its index beside the spec, and the reviews that `--sign` records."""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterable, Mapping
from pathlib import Path

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.console.streams import print_line
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.files import regular_file, storage
from fieldspec.command.files.storage import exclusive_folder, replace
from fieldspec.command.sources import specs
from fieldspec.language.model.device import Device
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.findings import LARGEST_FILE
from fieldspec.language.reading.project import read
from fieldspec.tools.audit.manual_lines import NAME, ManualError, ManualIndex, index_of, index_text, parsed
from fieldspec.tools.audit.review import FILE, State, is_day, review_entry, states
from fieldspec.tools.audit.sources import section_order
from fieldspec.tools.facts import of_versions

MOST_BYTES = 32 << 20
_LEAST_SHARE = 10
"""The least percentage of lines that a text must share with the manual to be compared with it."""


def recorded(specs_option: str | None, device: str) -> ManualIndex | None:
    """The index beside the spec of a device, None where there is none. Raises UsageError."""
    folder = specs.folder(specs_option)
    path = folder / device / NAME
    try:
        text = regular_file.content(path, MOST_BYTES).decode("utf-8")
    except FileNotFoundError:
        return None
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is not UTF-8"
        raise UsageError(f"cannot read {path}: {reason}") from None
    label = "/".join(filter(None, (specs.relative_path(folder), device, NAME)))
    try:
        return parsed(label, text.replace("\r\n", "\n"))
    except ManualError as error:
        raise UsageError(f"{path} {error}") from None


def at_hand(name: str) -> ManualIndex:
    """The index of the text of a manual that the user has. Raises UsageError."""
    with regular_file.reading(name, MOST_BYTES, "the text of a manual"):
        content = regular_file.content(name, MOST_BYTES)
    try:
        return index_of(name, content)
    except ManualError as error:
        raise UsageError(f"{name} {error}") from None


def compared(specs_option: str | None, device: str, name: str | None) -> tuple[ManualIndex | None, ManualIndex | None]:
    """The recorded index of a device's manual, and that of the text at hand.

    Raises UsageError for a text that has next to nothing in common with the manual.
    """
    index = recorded(specs_option, device)
    manual = at_hand(name) if name else None
    if name and index is not None and manual is not None:
        digests = {*manual.digests}
        whole = [digest for digest in index.digests if digest]
        same = sum(digest in digests for digest in whole)
        if same * 100 < _LEAST_SHARE * len(whole):
            raise UsageError(
                f"{name} is not this manual: {same} of its {len(whole)} lines that are not empty are there; "
                "give the text from which the spec was transcribed, or another edition of it"
            )
    return index, manual


def refuse_without_lines(device: Device, arguments: argparse.Namespace) -> None:
    """Refuses options for which the manual of a device would have to be a text, or a file. Raises UsageError."""
    manual = device.manual
    if not manual.lines and (arguments.manual or arguments.record):
        option = "--record" if arguments.record else "--manual"
        raise UsageError(
            f"the manual of {device.id} is {manual.extent}: without lines, {option} has no effect; leave it out"
        )
    if not manual.sha256 and arguments.sign:
        raise UsageError(
            f"the manual of {device.id} is {manual.extent}: save it as a file, whose hash a signature can state"
        )


def record(specs_option: str | None, device: Device, name: str | None) -> int:
    """Writes the index of a manual beside the spec of a device, which must cite that very text. Raises UsageError."""
    if not name:
        raise UsageError("--record needs the text of the manual: --manual FILE --record")
    manual, cited = at_hand(name), device.manual
    if manual.sha256 != cited.sha256 or len(manual.lines) != cited.lines:
        raise UsageError(
            f"{name} is not the text that the spec cites; if you have compared the spec with it, first put its "
            f"hash and number of lines into the spec: sha256: {manual.sha256}, lines: {len(manual.lines)}"
        )
    folder = specs.writable_folder(specs_option)
    storage.write(folder / device.id / NAME, index_text(manual, device.id).encode())
    label = "/".join(filter(None, (specs.relative_path(folder), device.id, NAME)))
    print_line(f"wrote {label}: {len(manual.lines)} lines")
    return 0


ALL = "all"


def sign(arguments: argparse.Namespace, spec: DeviceSpec, layouts: Iterable[DeviceLayout]) -> int:
    """Appends an entry to the reviews of a device. Raises UsageError, and writes nothing, where that cannot be done."""
    if not arguments.by or not arguments.by.strip():
        raise UsageError('--sign records who made the comparison; add a name or a role, such as --by "second reader"')
    today = time.strftime("%Y-%m-%d")
    day = arguments.on or today
    if not is_day(day):
        raise UsageError(f"--on {day} is not a date; write it like 2026-01-31")
    if day > today:
        raise UsageError(f"--on {day} is in the future; today is {today}; use the date of the comparison")
    all_layouts = list(layouts)
    signed = _picked(states(of_versions(all_layouts)), arguments.sign)
    manual = all_layouts[-1].device.manual
    entry = review_entry(spec, signed, arguments.by.strip(), day, manual.sha256, manual.edition, arguments.how or "")
    folder = specs.writable_folder(arguments.specs)
    path = folder / spec.id / FILE
    with exclusive_folder(path.parent):  # from reading to writing, so that no entry of another process is lost
        text = (_before(path) or f"{specs.editor_line()}reviews:\n") + entry
        _must_be_sound(folder, spec.id, text)
        specs.bring_schema(folder)
        replace(path, text.encode("utf-8"))
    facts = sum(len(state.digests) for state in signed.values())
    counts = " with ".join(
        f"{count} {noun}{'s'[count == 1 :]}" for count, noun in ((len(signed), "section"), (facts, "fact"))
    )
    print_line(f"{specs.relative_path(path)}: {counts}, by {arguments.by.strip()} on {day}")
    return 0


def _picked(now: Mapping[str, State], name: str) -> dict[str, State]:
    """The sections that a name means: a section, a chapter with its sections, or all. Raises UsageError."""
    if name == ALL:
        return {section: now[section] for section in sorted(now, key=section_order)}
    matches = [section for section in now if section == name or section.startswith(f"{name}.")]
    if not matches:
        raise unknown("section of the manual that facts cite", name, sorted(now, key=section_order))
    return {section: now[section] for section in sorted(matches, key=section_order)}


def _before(path: Path) -> str:
    """The text of the file, empty where there is none. Raises UsageError."""
    try:
        text = regular_file.content(path, LARGEST_FILE).decode("utf-8")
    except FileNotFoundError:
        return ""
    except OSError as error:
        raise UsageError(f"cannot read {path}: {error.strerror}") from None
    except UnicodeError:
        raise UsageError(f"{path} is not UTF-8; nothing was changed") from None
    return text if not text or text.endswith("\n") else text + "\n"


def _must_be_sound(folder: Path, device: str, text: str) -> None:
    """Reads the spec with the new file before anything is written. Raises UsageError."""
    files = specs.with_protocols(specs.files(folder, frozenset([device])))
    files[f"{device}/{FILE}"] = text.encode("utf-8")
    if read(files, frozenset([device])).findings:
        raise UsageError(
            f"an entry cannot follow in {device}/{FILE}, which must end with the list `reviews`; nothing was written"
        )
