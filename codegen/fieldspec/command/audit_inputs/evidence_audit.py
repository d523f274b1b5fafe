"""`fieldspec audit --evidence`: what dumps, scans and captures of real units show of the facts of a spec."""

from __future__ import annotations

import argparse
import json
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from fieldspec.command.console.streams import print_error
from fieldspec.command.console.usage import UsageError
from fieldspec.command.files import list_files, regular_file
from fieldspec.foundation.spreadsheet import csv_text
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.tools.audit.register_dump import compared
from fieldspec.tools.evidence.capture_values import add_dump, add_scan
from fieldspec.tools.evidence.observables import Observables
from fieldspec.tools.evidence.report import Baseline, BaselineError, baseline, evidence_report
from fieldspec.tools.evidence.unit_evidence import FILE, UnitEvidence, UnitNote, unit_note
from fieldspec.tools.lists.dump import dump, dump_sheet
from fieldspec.tools.lists.list_file import content_sheet
from fieldspec.tools.lists.sheet import ListError
from fieldspec.tools.lists.workbook_reader import MAGIC

if TYPE_CHECKING:
    from fieldspec.codec.layout.device import DeviceLayout
    from fieldspec.tools.audit.section import Report

_MOST_BYTES = 16 << 20
_HEAD = 4096
_FILES = 40
"""The bits of the number of a moment that number the frames of a file."""


def report(
    arguments: argparse.Namespace, layout: DeviceLayout, layouts: Mapping[str, DeviceLayout]
) -> tuple[Report, tuple[Diagnostic, ...]]:
    """The report that the options ask for, and its findings. Raises UsageError."""
    old = _baseline(arguments.baseline) if arguments.baseline else None
    return folder_report(Path(arguments.evidence), old, layout, layouts)


def folder_report(
    folder: Path, old: Baseline | None, layout: DeviceLayout, layouts: Mapping[str, DeviceLayout]
) -> tuple[Report, tuple[Diagnostic, ...]]:
    """The report on a folder of units, and its findings; those in the notes alone where there are any.

    `layouts` are the layouts of all versions. Raises UsageError.
    """
    notes, findings = _notes(folder)
    if findings:
        return evidence_report(layout, (), (), None)[0], tuple(findings)
    observables = Observables(layout)
    units: list[UnitEvidence] = []
    other_rows: list[tuple[str, ...]] = []
    for path, note in notes:
        other = layouts.get(note.firmware)
        if other is not None and other.identity != layout.identity:
            remark = f"not counted: audit {layout.device.id}@{note.firmware}"
            other_rows.append((note.name, note.model, note.firmware, "", remark))
        else:
            units.append(_unit_evidence(path, note, layout, observables))
    return evidence_report(layout, units, other_rows, old)


def _baseline(name: str) -> Baseline:
    try:
        with regular_file.reading(name, _MOST_BYTES, "a baseline"):
            return baseline(name, regular_file.content(name, _MOST_BYTES).decode("utf-8"))
    except UnicodeDecodeError:
        raise UsageError(f"{name} is not UTF-8") from None
    except BaselineError as error:
        raise UsageError(f"{name} {error}") from None


def _notes(folder: Path) -> tuple[list[tuple[Path, UnitNote]], list[Diagnostic]]:
    """The folder and the note of each unit, and what is wrong with the notes. Raises UsageError."""
    if not folder.is_dir():
        raise UsageError(f"there is no folder {folder}")
    paths = sorted(entry for entry in folder.iterdir() if entry.is_dir() and not entry.name.startswith("."))
    if not paths:
        raise UsageError(f"{folder} has no folder of a unit: put the files of each unit into one, with a {FILE}")
    notes: list[tuple[Path, UnitNote]] = []
    findings: list[Diagnostic] = []
    for path in paths:
        name = path / FILE
        with regular_file.reading(name, _MOST_BYTES, "a note"):
            try:
                data = regular_file.content(name, _MOST_BYTES)
            except FileNotFoundError:
                text = f"{path} has no {FILE}; write one with model, firmware and serial_number: redacted"
                raise UsageError(text) from None
        note, wrong = unit_note(path.name, f"{path.name}/{FILE}", data)
        findings += wrong
        if note is not None:
            notes.append((path, note))
    return notes, findings


def _unit_evidence(path: Path, note: UnitNote, layout: DeviceLayout, observables: Observables) -> UnitEvidence:
    """The evidence in the folder of a unit. Raises UsageError."""
    unit = UnitEvidence(note, layout)
    files = sorted(
        file_path for file_path in path.rglob("*") if file_path.is_file() and not file_path.name.startswith(".")
    )
    files = [file_path for file_path in files if file_path != path / FILE]
    if not files:
        raise UsageError(f"{path} has no dump, scan or capture")
    for number, file_path in enumerate(files):
        source = file_path.relative_to(path).as_posix()
        with regular_file.reading(file_path), open(file_path, "rb") as file:
            head = file.read(_HEAD)
        if is_dump(head):
            _add_dump(unit, observables, file_path, source, number << _FILES)
        else:
            _add_capture(unit, observables, file_path, source, number << _FILES)
        unit.sources.append(source)
    return unit


def is_dump(head: bytes) -> bool:
    """Whether a file holds values of one moment: a workbook, JSON, or rows of addresses and values without times."""
    if head.startswith(MAGIC) or head.lstrip(b"\xef\xbb\xbf \t\r\n")[:1] in (b"{", b"["):
        return True
    first = head.removeprefix(b"\xef\xbb\xbf").partition(b"\n")[0].decode("utf-8", "replace").lower()
    cells = [cell.strip(' "\r') for separator in ",;\t" for cell in first.split(separator)]
    has_time = any(cell.startswith(("time", "date")) for cell in cells)
    return not has_time and any(cell.startswith("addr") for cell in cells)


def _add_dump(unit: UnitEvidence, observables: Observables, path: Path, source: str, moment: int) -> None:
    data = list_files.content(str(path))
    scan = _scan(data)
    try:
        if scan is not None:
            data, refused = scan
            for space, addresses in refused.items():
                add_scan(unit, observables, space, addresses)
            if not data:
                return
        sheet = dump_sheet(data) or content_sheet(data)
        add_dump(unit, observables, compared(observables.layout, dump(sheet, {})), source, moment)
    except ListError as error:
        raise UsageError(f"{path} {error}") from None


def _scan(data: bytes) -> tuple[bytes, dict[str, frozenset[int]]] | None:
    """What `scan --format json` prints, as a dump and the refused addresses by space; None for other files.

    The dump is empty where nothing has answered.
    """
    try:
        content = json.loads(data)
        if not isinstance(content, dict) or "spaces" not in content:
            return None
        rows, refused = [], {}
        for part in content["spaces"]:
            space = str(part["space"])
            refused[space] = frozenset(int(address, 16) for address in part["refused"])
            for address, value in part["words"].items():
                counts = value if isinstance(value, list) else [value]
                rows.append((space, f"0x{int(address, 16):04X}", " ".join(str(int(count)) for count in counts)))
        text = csv_text([("space", "address", "value"), *rows])
        return (text.encode() if rows else b""), refused
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return None


def _add_capture(unit: UnitEvidence, observables: Observables, path: Path, source: str, moment: int) -> None:
    """Adds the values in a capture. Raises UsageError for one without any frame of the device."""
    from fieldspec.command.bulk.bulk_decoding import require_captures

    require_captures()
    from fieldspec.tools.captures.capture_files import CaptureError
    from fieldspec.tools.captures.conversion import Conversion
    from fieldspec.tools.captures.decoding import Choices, DeviceDecoder
    from fieldspec.tools.evidence.capture_values import CaptureValues

    address = unit.note.unit_address
    units = frozenset() if address is None else frozenset((address,))
    decoder = DeviceDecoder(observables.layout, Choices(units=units))
    values = CaptureValues(unit, observables, decoder, source, moment)
    try:
        with regular_file.reading(path), open(path, "rb") as file:
            conversion = Conversion(file, decoder, ())
            for batches in conversion.batches():
                for batch in batches:
                    values.add(batch)
            for remark, count in sorted(conversion.counters().items()):
                print_error(f"{path}: {remark}: {count}")
    except CaptureError as error:
        raise UsageError(f"{path} could not be read: {error}") from None
    values.finish()
    if not values.frames:
        raise UsageError(f"{path} has no frame of {observables.layout.device.id}")
