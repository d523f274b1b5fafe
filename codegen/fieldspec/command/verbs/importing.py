"""`fieldspec import`: a first spec of a device, written from a register list of another source."""

from __future__ import annotations

import argparse
import hashlib
import re
from collections.abc import Iterator
from pathlib import Path

from fieldspec.command.console.streams import print_document, print_line, print_note
from fieldspec.command.console.usage import UsageError
from fieldspec.command.files import list_files, storage
from fieldspec.command.sources import specs
from fieldspec.foundation.reserved import file_name_fault
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.reading.findings import MAIN
from fieldspec.language.schema import schema

_FOLDER = re.compile(r"[^a-z0-9]+")


def run(arguments: argparse.Namespace) -> int:
    """Writes the file, or prints it for `-`. It overwrites no file, and writes none with errors. Raises UsageError."""
    from fieldspec.tools.lists.cells import REFERENCE
    from fieldspec.tools.lists.listing import listing, moved
    from fieldspec.tools.lists.sheet import ListError
    from fieldspec.tools.lists.skeleton import Origin, skeleton

    path = Path(arguments.to)
    device = _device(path)
    if arguments.to != "-" and path.exists():
        raise UsageError(f"the file {path} already exists")
    data = list_files.content(arguments.file)
    file = Path(arguments.file).name if arguments.file != "-" else "list.txt"
    columns = list_files.column_options(arguments)
    try:
        sheet = list_files.sheet(data, arguments.encoding or "", arguments.sheet or "")
        register_list = listing(sheet, columns, arguments.base or "")
        base = REFERENCE if REFERENCE in register_list.bases else register_list.bases[0]
        rows = list(moved(register_list.rows(base), arguments.offset or 0))
        low = next((row for row in rows if row.address < 0), None)
        if low is not None:
            raise ListError(f"has an address below 0 in row {low.row}, with the offset {arguments.offset}")
        origin = Origin(file, hashlib.sha256(data).hexdigest(), max(sheet.lines, 1))
        text = specs.editor_line() + skeleton(device, origin, rows)
    except ListError as error:
        raise UsageError(f"{arguments.file} {error}") from None
    _passes(device, text, arguments.file)
    if arguments.to == "-":
        print_document(text)
        return 0
    if path.name == MAIN:
        specs.bring_schema(path.resolve().parent.parent)
    storage.write(path, text.encode("utf-8"), new=True)
    skipped = f", {len(register_list.skipped)} rows without an address" if register_list.skipped else ""
    print_line(f"{specs.relative_path(path)}: {len(rows)} registers, addresses read as {base}{skipped}")
    for remark in _remarks(text):
        print_note(remark)
    return 0


def _remarks(text: str) -> Iterator[str]:
    """What to look at in a spec that was written from a list, without which a cell would go unnoticed."""
    rows = [line for line in text.splitlines() if line.lstrip().startswith("- {")]
    doubtful = sum("notes: [" in row for row in rows)
    if doubtful:
        yield f"fieldspec: cells of {_registers(doubtful)} are no facts that the spec can have; see `notes`"
    scaled = sum(" scale: " in row and " range: " in row for row in rows)
    if scaled:
        help = "where the list has them in the unit, write `unit_range`"
        yield f"fieldspec: the bounds of {_registers(scaled)} with a scale are taken as counts; {help}"


def _registers(number: int) -> str:
    return "1 register" if number == 1 else f"{number} registers"


def _device(path: Path) -> str:
    """The identity of the device: the name of the folder, or of the file."""
    name = path.resolve().parent.name if path.name == MAIN else path.stem
    form = schema()["$defs"]["device_id"]
    identity = name if re.fullmatch(form["pattern"], name) else _FOLDER.sub("-", name.lower()).strip("-") or "device"
    if path.name == MAIN and identity != name:
        raise UsageError(f"the folder {name} is not a valid name of a device: {form['description']}")
    if fault := file_name_fault(path.name) or file_name_fault(identity):
        raise UsageError(f"the name in {path} {fault}; choose another one")
    if not re.fullmatch(form["pattern"], identity) or len(identity) > form["maxLength"]:
        raise UsageError(f"{identity} is not a valid name of a device: {form['description']}")
    return str(identity)


def _passes(device: str, text: str, name: str) -> None:
    """Refuses a spec that would not pass the check, because the list contradicts itself. Raises UsageError."""
    from fieldspec.command import pipeline
    from fieldspec.command.packages.plugin_loading import load_checks

    load_checks()
    findings = pipeline.checked(pipeline.load({f"{device}/{MAIN}": text.encode("utf-8")}))
    if has_errors(findings):
        messages = "; ".join(
            dict.fromkeys(finding.message for finding in findings if finding.severity.value == "error")
        )
        raise UsageError(f"{name} contradicts itself: {messages[:400]}")
