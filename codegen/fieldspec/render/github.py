"""Findings as workflow commands, which GitHub shows beside the lines of a change."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.diagnostics import Diagnostic


def rendered(findings: Sequence[Diagnostic]) -> str:
    """A command for each finding."""
    return "".join(_command(finding) for finding in findings)


def _command(finding: Diagnostic) -> str:
    line, column = finding.span.position()
    end_line, end_column = finding.span.end_position()
    properties = {
        "file": finding.span.file.path,
        "line": line,
        "col": column,
        "endLine": end_line,
        "endColumn": max(column, end_column - 1),
        "title": finding.code,
    }
    text = finding.message + (f"\n{finding.help}" if finding.help else "")
    properties_text = ",".join(f"{key}={_property(str(value))}" for key, value in properties.items())
    return f"::{finding.severity.value} {properties_text}::{_data(text)}\n"


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")
