"""Findings as SARIF 2.1.0, for code scanning."""

from __future__ import annotations

import json
from collections.abc import Sequence
from urllib.parse import quote

from fieldspec.diagnostics import Diagnostic
from fieldspec.rules import rule
from fieldspec.source import Span

SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"


def rendered(findings: Sequence[Diagnostic]) -> str:
    """The SARIF text. Columns count UTF-16 code units from 1; the end column is exclusive."""
    codes = sorted({finding.code for finding in findings})
    run = {
        "tool": {"driver": {"name": "fieldspec", "rules": [_rule(code) for code in codes]}},
        "columnKind": "utf16CodeUnits",
        "results": [_result(finding, codes.index(finding.code)) for finding in findings],
    }
    return json.dumps({"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}, ensure_ascii=False, indent=1) + "\n"


def _rule(code: str) -> dict[str, object]:
    known = rule(code)
    if known is None:
        return {"id": code}
    return {
        "id": code,
        "shortDescription": {"text": known.what},
        "fullDescription": {"text": known.why},
        "help": {"text": f"{known.cure}\n\nExample: {known.example}"},
    }


def _result(finding: Diagnostic, number: int) -> dict[str, object]:
    text = finding.message + (f"\n{finding.help}" if finding.help else "")
    related = [
        {"id": at, "message": {"text": label.text}, **_location(label.span)}
        for at, label in enumerate(finding.labels, 1)
    ]
    return {
        "ruleId": finding.code,
        "ruleIndex": number,
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
    return {"physicalLocation": {"artifactLocation": {"uri": _uri(span.file.path)}, "region": region}}


def _uri(path: str) -> str:
    """A path as a URI: relative, or of a file."""
    if path.startswith("/") or path[1:2] == ":":
        return "file:///" + quote(path.lstrip("/"), safe="/:")
    return quote(path)


def _units(span: Span, line: int, column: int) -> int:
    """A column in UTF-16 code units."""
    before = span.file.line(line)[: column - 1]
    return len(before.encode("utf-16-le")) // 2 + 1
