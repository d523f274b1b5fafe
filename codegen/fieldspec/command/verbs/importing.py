"""`fieldspec import`: a first spec of a device, written from a register list of another source."""

from __future__ import annotations

import argparse
import hashlib
import re
from pathlib import Path
from typing import TYPE_CHECKING

from fieldspec.command.console.streams import print_document, print_line, print_note
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.files import list_files, storage
from fieldspec.command.sources import protocol_entries, spec_files, specs
from fieldspec.foundation.reserved import file_name_fault
from fieldspec.language.diagnostics import Diagnostic, Severity
from fieldspec.language.reading.findings import MAIN, PROTOCOLS
from fieldspec.language.schema import schema

if TYPE_CHECKING:
    from fieldspec.tools.lists.imported import Imported
    from fieldspec.tools.lists.skeleton import Origin, Spec

NO_PROTOCOL = "none"

_FOLDER = re.compile(r"[^a-z0-9]+")
_MOST_ROUNDS = 12
_ABOUT_TEXTS = (
    "bits_match_range",
    "descriptions_differ",
    "enum_contiguous",
    "enum_names_unique",
    "enum_within_range",
    "identifiers_consistent",
    "labels_consistent",
    "labels_unique",
    "printed_names_whole",
    "range_within_enum",
    "senses_differ",
    "series_regular",
    "siblings_agree",
    "sources_ascending",
    "switches_readable",
)
"""The rules that a list may break: they are about its texts, and not about what is on the wire."""


def run(arguments: argparse.Namespace) -> int:
    """Writes the file, or prints it for `-`. It overwrites no file, and writes none with errors. Raises UsageError."""
    from fieldspec.command.rendering import import_report
    from fieldspec.tools.lists.imported import imported
    from fieldspec.tools.lists.list_file import file_list
    from fieldspec.tools.lists.sheet import ListError
    from fieldspec.tools.lists.skeleton import Origin

    path = Path(arguments.to)
    device = _device(path)
    if arguments.to != "-" and path.exists():
        raise UsageError(f"the file {path} already exists")
    data = list_files.content(arguments.file)
    file = Path(arguments.file).name if arguments.file != "-" else "list.txt"
    columns, options = list_files.column_options(arguments), list_files.reading_options(arguments)
    try:
        sheet, register_list = file_list(data, arguments.encoding or "", arguments.sheet or "", columns, options)
        result = imported(register_list, sheet, arguments.offset or 0)
        origin = Origin(file, hashlib.sha256(data).hexdigest(), max(sheet.lines, 1))
        spec, result = _passing(arguments, device, origin, result)
    except ListError as error:
        raise UsageError(f"{arguments.file} {error}") from None
    if arguments.strict and (lacking := import_report.lacking(result, spec.noted)):
        raise UsageError(f"{arguments.file} is not taken whole, which --strict demands: {lacking}")
    say = print_note if arguments.to == "-" else print_line
    if arguments.to == "-":
        print_document(spec.text)
    else:
        if path.name == MAIN:
            specs.bring_schema(path.resolve().parent.parent)
        storage.write(path, spec.text.encode("utf-8"), new=True)
    name = "standard output" if arguments.to == "-" else specs.relative_path(path)
    for line in import_report.lines(name, result, spec.noted):
        say(line)
    if arguments.preview is not None:
        for line in import_report.preview(result, arguments.preview):
            say(line)
    return 0


def _passing(arguments: argparse.Namespace, device: str, origin: Origin, result: Imported) -> tuple[Spec, Imported]:
    """The spec that passes the check: what breaks a rule about texts is allowed, what breaks another one is refused."""
    from fieldspec.command.rendering import import_report
    from fieldspec.tools.lists.skeleton import Surroundings, skeleton

    uses, names = _uses(arguments, result)
    allowed: dict[int | str, list[str]] = {}
    idle_before: set[tuple[int | str, str]] = set()
    for _ in range(_MOST_ROUNDS):
        surroundings = Surroundings(import_report.head(result, bool(uses)), uses, names, allowed)
        spec = skeleton(device, origin, result.registers, result.refused, surroundings)
        spec = _with_editor_line(spec)
        wrong = _errors(device, spec.text)
        if all(finding.code == "too_many_findings" for finding in wrong):
            return spec, result
        refused: dict[int, str] = {}
        for finding in wrong:
            line = finding.span.position()[0]
            row = spec.rows.get(line, 0)
            holder = spec.declared.get(line, row)
            idle = [rule for rule in allowed.get(holder, ()) if f"`{rule}`" in finding.message]
            if idle and finding.code == "allowances_used":
                allowed[holder] = [rule for rule in allowed[holder] if rule not in idle]
                idle_before.update((holder, rule) for rule in idle)
            elif row and finding.code in _ABOUT_TEXTS and (holder, finding.code) not in idle_before:
                allowed.setdefault(holder, []).append(finding.code)
            elif row:
                refused.setdefault(row, f"would break {finding.code}: {finding.message}")
            elif finding.code != "too_many_findings":
                raise UsageError(f"{arguments.file} contradicts itself: {finding.message[:400]}")
        result = result.without(refused)
        if not result.registers:
            raise UsageError(f"{arguments.file} contradicts itself: {wrong[0].message[:400]}")
    raise UsageError(f"{arguments.file} contradicts itself: {wrong[0].message[:400]}")


def _with_editor_line(spec: Spec) -> Spec:
    from fieldspec.tools.lists.skeleton import Spec

    line = specs.editor_line()
    shift = line.count("\n")
    rows = {number + shift: row for number, row in spec.rows.items()}
    declared = {number + shift: beginning for number, beginning in spec.declared.items()}
    return Spec(line + spec.text, rows, spec.noted, declared)


def _uses(
    arguments: argparse.Namespace, result: Imported
) -> tuple[dict[str, list[str]], dict[tuple[int, int | None], str]]:
    """The sections of the protocol that carries the list, and its names for objects: the protocol that is named, or the
    only one that reads what the list has. Lists with spaces of their own have none."""
    has_objects = result.has_objects()
    if not (result.has_usual_spaces() or has_objects) or arguments.protocol == NO_PROTOCOL:
        return {}, {}
    places = {name: Path(path) for name, path in spec_files.installed_protocols().items()}
    folder = (
        spec_files.folder_or_none(arguments.specs)
        if arguments.specs is None or Path(arguments.specs).is_dir()
        else None
    )
    if folder is not None:
        places |= {path.stem: path for path in (Path(folder) / PROTOCOLS).glob("*.yaml")}
    if arguments.protocol is not None and arguments.protocol not in places:
        raise unknown("protocol", arguments.protocol, [*sorted(places), NO_PROTOCOL])
    reads = protocol_entries.reads_objects if has_objects else protocol_entries.reads_words
    known = [arguments.protocol] if arguments.protocol else [name for name in sorted(places) if reads(places[name])]
    if len(known) != 1:
        names = ", ".join(known) or "none"
        read = "objects" if has_objects else "words"
        raise UsageError(
            f"the protocols that read {read} are {names}; name one with --protocol, or --protocol {NO_PROTOCOL}"
        )
    if has_objects:
        return protocol_entries.object_uses(places[known[0]])
    return protocol_entries.uses(places[known[0]], result.spaces()), {}


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


def _errors(device: str, text: str) -> list[Diagnostic]:
    """The facts that would fail the check, because the list contradicts itself."""
    from fieldspec.command import pipeline
    from fieldspec.command.packages.plugin_loading import load_checks

    load_checks()
    files = spec_files.with_protocols({f"{device}/{MAIN}": text.encode("utf-8")})
    return [finding for finding in pipeline.checked(pipeline.load(files)) if finding.severity is Severity.ERROR]
