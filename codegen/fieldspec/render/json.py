"""Findings as JSON: a list of objects with code, severity, message, place, labels and help."""

from __future__ import annotations

import json
from collections.abc import Sequence

from fieldspec.diagnostics import Diagnostic
from fieldspec.source import Span


def rendered(findings: Sequence[Diagnostic]) -> str:
    """The JSON text; lines and columns count from 1, the end column is exclusive."""
    data = [
        {
            "code": finding.code,
            "severity": finding.severity.value,
            "message": finding.message,
            **_place(finding.span),
            "labels": [{"message": label.text, **_place(label.span)} for label in finding.labels],
            "help": finding.help,
        }
        for finding in findings
    ]
    return json.dumps(data, ensure_ascii=False, indent=1) + "\n"


def _place(span: Span) -> dict[str, object]:
    line, column = span.position()
    end_line, end_column = span.end_position()
    return {"file": span.file.path, "line": line, "column": column, "end_line": end_line, "end_column": end_column}
