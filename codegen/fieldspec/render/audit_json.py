"""The audit of a device as JSON."""

from __future__ import annotations

import json

from fieldspec.audit.section import Cell, Report, Section, SectionTable
from fieldspec.model.fact import Citation
from fieldspec.render import json as findings_json
from fieldspec.source import Span


def rendered(report: Report) -> str:
    """An object with the device and its sections; a table is a list of objects, by the names of its columns."""
    data = {
        "device": report.device,
        "version": report.version,
        "identity": report.identity,
        "sections": {section.name: _section(section) for section in report.sections},
    }
    return json.dumps(data, ensure_ascii=False, indent=1) + "\n"


def _section(section: Section) -> dict[str, object]:
    return {
        "title": section.title,
        "says": list(section.says),
        "figures": [
            {"what": figure.what, "number": figure.number, "of": figure.whole, "good": figure.good}
            for figure in section.figures
        ],
        "tables": {table.name: rows(table) for table in section.tables},
        "findings": json.loads(findings_json.rendered(section.findings)),
    }


def rows(table: SectionTable) -> list[dict[str, object]]:
    """The rows of a table as objects."""
    return [dict(zip(table.columns, map(_cell, row), strict=True)) for row in table.rows]


def _cell(cell: Cell) -> object:
    """Places are objects: of a file with line and column, of the manual with section and intervals of lines."""
    if isinstance(cell, Span):
        line, column = cell.position()
        return {"file": cell.file.path, "line": line, "column": column}
    if isinstance(cell, Citation):
        return {"section": cell.section, "lines": [list(pair) for pair in cell.lines]}
    return cell
