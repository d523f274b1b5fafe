"""Findings as SARIF 2.1.0, the form that code scanning takes."""

from __future__ import annotations

import json
from collections.abc import Sequence

from fieldspec.diagnostics import Diagnostic
from fieldspec.source import Span

SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"


def rendered(found: Sequence[Diagnostic]) -> str:
    """The SARIF text. Columns count UTF-16 code units from 1; the end column is exclusive."""
    codes = sorted({finding.code for finding in found})
    rules = [{"id": code, "name": code, "shortDescription": {"text": code.replace("_", " ")}} for code in codes]
    run = {
        "tool": {"driver": {"name": "fieldspec", "rules": rules}},
        "columnKind": "utf16CodeUnits",
        "results": [_result(finding, codes.index(finding.code)) for finding in found],
    }
    return json.dumps({"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}, ensure_ascii=False, indent=1) + "\n"


def _result(finding: Diagnostic, rule: int) -> dict[str, object]:
    text = finding.message + (f"\n{finding.help}" if finding.help else "")
    related = [
        {"id": number, "message": {"text": label.text}, **_location(label.span)}
        for number, label in enumerate(finding.labels, 1)
    ]
    return {
        "ruleId": finding.code,
        "ruleIndex": rule,
        "level": finding.severity.value,
        "message": {"text": text},
        "locations": [_location(finding.span)],
        **({"relatedLocations": related} if related else {}),
    }


def _location(span: Span) -> dict[str, object]:
    line, column = span.position()
    end_line, end_column = span.end_position()
    region = {
        "startLine": line,
        "startColumn": _units(span, line, column),
        "endLine": end_line,
        "endColumn": _units(span, end_line, end_column),
    }
    return {"physicalLocation": {"artifactLocation": {"uri": span.file.path}, "region": region}}


def _units(span: Span, line: int, column: int) -> int:
    """A column in UTF-16 code units."""
    before = span.file.line(line)[: column - 1]
    return len(before.encode("utf-16-le")) // 2 + 1
