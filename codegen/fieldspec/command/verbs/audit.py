"""`fieldspec audit`: the evidence that the spec of a device is right, and the judgement of register dumps."""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.audit_inputs import audit_files
from fieldspec.command.console.streams import print_document, print_line, print_note
from fieldspec.command.console.terminal import print_blocks, print_findings
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.files import list_files
from fieldspec.command.files.storage import write, write_or_print
from fieldspec.command.sources import specs
from fieldspec.foundation.source import SourceFile
from fieldspec.language.diagnostics import Diagnostic, has_errors, in_order
from fieldspec.tools.audit.register_dump import compared, judged, section
from fieldspec.tools.lists.dump import dump, dump_sheet
from fieldspec.tools.lists.list_file import content_sheet
from fieldspec.tools.lists.sheet import ListError, Sheet
from fieldspec.tools.lists.text_sheet import decoded
from fieldspec.tools.lists.workbook_reader import MAGIC

if TYPE_CHECKING:
    from fieldspec.language.model.device import Device
    from fieldspec.tools.audit.section import Report, Section


COLUMNS = ("address", "value", "words", "space")
"""The columns that an option names."""


def register_dump(arguments: argparse.Namespace, layout: DeviceLayout) -> tuple[Section, tuple[Diagnostic, ...]]:
    """The section about a dump, and its findings. Raises UsageError for a file that cannot be used."""
    columns = list_files.column_options(arguments, COLUMNS)
    encoding = arguments.encoding or ""
    data = list_files.content(arguments.dump)
    try:
        sheet = dump_sheet(data, encoding) or content_sheet(data, encoding, arguments.sheet or "")
        dump_rows = dump(sheet, columns, arguments.base or "")
        file, rows = _file(arguments.dump, data, encoding, sheet)
    except ListError as error:
        raise UsageError(f"{_quote(arguments.dump)} {error}") from None
    comparison = compared(layout, dump_rows, arguments.offset or 0)
    if comparison.unknown and not (comparison.read or comparison.holes or comparison.too_great):
        raise UsageError(
            f"{_quote(arguments.dump)} has no address that {layout.device.name} has; if it is a dump of this device, "
            "say with --base or --offset how its addresses are counted"
        )
    wrong = tuple(in_order(judged(comparison, file, rows)))
    return section(comparison, wrong, len(dump_rows.skipped)), wrong


def _quote(name: str) -> str:
    return "standard input" if name == "-" else name


def _file(name: str, data: bytes, encoding: str, sheet: Sheet) -> tuple[SourceFile, Mapping[int, int]]:
    """The text that findings show, and the offset of each row in it: the file, or the rows of a workbook."""
    label = _quote(name)
    if not data.startswith(MAGIC):
        text = decoded(data, encoding)
        lines = text.splitlines(keepends=True)
        if len(lines) == sheet.lines:
            starts = [0]
            for line in lines:
                starts.append(starts[-1] + len(line))
            return SourceFile(label, text), dict(enumerate(starts, 1))
    rows: dict[int, int] = {}
    parts = []
    start = 0
    for row in sheet.rows:
        rows[row.number] = start
        parts.append("\t".join(row.cells) + "\n")
        start += len(parts[-1])
    return SourceFile(label, "".join(parts)), rows


OF_DUMPS = ("address", "value", "words", "space", "base", "offset", "encoding", "sheet")
"""The options that say how a dump is read."""

ALONE = ("sign", "dump", "record", "as_printed", "captures", "evidence")
"""The options that ask for something other than the audit; each excludes the others."""

FORMED = ("sign", "record")
"""Those that write a file of the spec and print no report."""

WHOLE = ("sarif", "html")
"""The formats of the whole report."""

LISTS = ("csv", "xlsx")
"""The formats of a single table."""


def run(arguments: argparse.Namespace) -> int:
    """Prints the audit, or one table of it. Exit code 1 where a section has a finding that is an error.

    Findings in the printed values, with `--as-printed`, do not affect the exit code, which is then 0. Raises
    UsageError.
    """
    from fieldspec.command.packages.plugin_loading import load_checks
    from fieldspec.tools.audit.report import printed_report, report
    from fieldspec.tools.audit.section import Subject
    from fieldspec.tools.facts import of_versions
    from fieldspec.tools.proofs.running import errata_proofs

    _refuse_exclusive_options(arguments)
    if arguments.format in LISTS and not arguments.table:
        raise UsageError(f"{arguments.format} holds a single table; name it with --table, such as --table ledger")
    if arguments.table and arguments.format in WHOLE:
        raise UsageError(f"{arguments.format} shows the whole audit; use --table with text, json, csv or xlsx")
    if arguments.out and not arguments.table and arguments.format not in ("html", "parquet"):
        raise UsageError("--out writes a page or a table; give --format html, or --table, such as --table ledger")
    if arguments.format == "parquet" and not (arguments.captures and arguments.out):
        raise UsageError("parquet holds the tables of captures; give --captures FOLDER and --out FOLDER")
    options = [option for option in ("by", "on", "how") if getattr(arguments, option) is not None]
    if options and not arguments.sign:
        raise UsageError(f"--{options[0]} goes with --sign SECTION")
    options = [option for option in OF_DUMPS if getattr(arguments, option) is not None]
    if options and not arguments.dump:
        raise UsageError(f"--{options[0]} goes with --dump FILE")
    if arguments.baseline and not arguments.evidence:
        raise UsageError("--baseline goes with --evidence FOLDER")
    if arguments.captures:
        return _print_captures(arguments)
    load_checks()
    spec, version = specs.spec_at(arguments.specs, arguments.device)
    layouts = {
        each_version: specs.layout_of(spec, each_version) for each_version in dict.fromkeys((*spec.versions(), version))
    }
    layout = layouts[version]
    audit_files.refuse_without_lines(layout.device, arguments)
    if arguments.sign:
        return audit_files.sign(arguments, spec, [layouts[each_version] for each_version in spec.versions()])
    if arguments.dump:
        return _print_dump(arguments, layout)
    if arguments.evidence:
        return _print_evidence(arguments, layout, layouts)
    if arguments.record:
        return audit_files.record(arguments.specs, layout.device, arguments.manual)
    index, manual = audit_files.compared(arguments.specs, spec.id, arguments.manual)
    proofs = errata_proofs(spec)
    all_layouts = tuple(layouts.values())
    subject = Subject(spec, layout, all_layouts, of_versions(all_layouts), proofs, index, manual)
    if arguments.as_printed:
        audit_report, findings = printed_report(subject)
    else:
        audit_report = report(subject)
        findings = tuple(in_order(audit_report.findings()))
    _print_report(audit_report, findings, arguments, layout.device)
    return 1 if has_errors(findings) and not arguments.as_printed else 0


def _refuse_exclusive_options(arguments: argparse.Namespace) -> None:
    """Refuses options that exclude each other. Raises UsageError."""
    chosen = [option for option in ALONE if getattr(arguments, option)]
    if len(chosen) > 1:
        raise UsageError(
            f"{_option_text(chosen[0])} and {_option_text(chosen[1])} cannot be combined; use one at a time"
        )
    report_options = [option for option in ("table", "out", "all") if getattr(arguments, option)]
    report_options += ["format"] if arguments.format != "text" else []
    if chosen and chosen[0] in FORMED and report_options:
        raise UsageError(
            f"{_option_text(chosen[0])} prints no report, so {_option_text(report_options[0])} has no effect; "
            "leave it out"
        )
    if chosen and chosen[0] in ("sign", "dump", "captures", "evidence") and arguments.manual:
        raise UsageError(f"{_option_text(chosen[0])} reads no manual, so --manual has no effect; leave it out")


def _option_text(option: str) -> str:
    return "--" + option.replace("_", "-")


def _print_dump(arguments: argparse.Namespace, layout: DeviceLayout) -> int:
    """Prints the report on a dump. Exit code 1 where a finding is an error."""
    from fieldspec.tools.audit.report import dump_report

    section, findings = register_dump(arguments, layout)
    report = dump_report(layout, section)
    _print_report(report, findings, arguments, layout.device)
    return 1 if has_errors(findings) else 0


def _print_evidence(arguments: argparse.Namespace, layout: DeviceLayout, layouts: Mapping[str, DeviceLayout]) -> int:
    """Prints the report on the evidence of real units. Exit code 1 where a finding is an error."""
    from fieldspec.command.audit_inputs import evidence_audit

    report, findings = evidence_audit.report(arguments, layout, layouts)
    findings = tuple(in_order(findings))
    _print_report(report, findings, arguments, layout.device)
    return 1 if has_errors(findings) else 0


def _print_captures(arguments: argparse.Namespace) -> int:
    """Prints the report on captures. Exit code 1 where they contradict the spec."""
    from fieldspec.command.audit_inputs import capture_audit

    if arguments.format == "sarif":
        raise UsageError("sarif shows findings in specs, and --captures has none; use text, json, html or parquet")
    spec, version = specs.spec_at(arguments.specs, arguments.device)
    layout = specs.layout_of(spec, version)
    report, is_wrong = capture_audit.capture_report(arguments, layout)
    if arguments.format == "parquet":
        capture_audit.write_tables(report, Path(arguments.out))
    else:
        _print_report(report, (), arguments, layout.device)
    return int(is_wrong)


def _print_report(
    report: Report, findings: tuple[Diagnostic, ...], arguments: argparse.Namespace, device: Device
) -> None:
    """Prints one table or the whole audit, or writes it to a file."""
    form = arguments.format
    if arguments.table:
        _print_table(report, arguments)
    elif form == "html":
        from fieldspec.command.rendering.audit_html import rendered as page

        text = page(report, device, {})
        if arguments.out:
            write(Path(arguments.out), text.encode("utf-8"))
        else:
            print_document(text)
    elif form == "json":
        from fieldspec.command.rendering.audit_formats import rendered

        print_document(rendered(report))
    elif form == "sarif":
        print_findings(findings, "sarif", "")
    else:
        from fieldspec.command.rendering.audit_formats import blocks

        print_blocks(blocks(report, arguments.all or arguments.as_printed))
        if findings:
            print_line("")
            print_findings(findings, "text", "")


def _print_table(report: Report, arguments: argparse.Namespace) -> None:
    """Prints one table, or writes it to a file."""
    from fieldspec.command.rendering.audit_formats import as_csv, as_json, as_xlsx, table_blocks

    tables = {table.name: table for section in report.sections for table in section.tables}
    if arguments.table not in tables:
        raise unknown("table", arguments.table, tables, limit=len(tables))
    table = tables[arguments.table]
    if arguments.format == "text":
        if arguments.out:
            raise UsageError("--out needs a format for the table; give --format csv, xlsx or json")
        if not table.rows:
            print_note(f"the table {table.name} has no rows")
            return
        print_blocks(table_blocks(table))
        return
    data = {"csv": as_csv, "xlsx": as_xlsx, "json": as_json}[arguments.format](table)
    write_or_print(data, arguments.format, arguments.out or None)
