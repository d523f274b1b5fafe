"""Findings as JSON, SARIF 2.1.0, JUnit XML and workflow commands of GitHub."""

from __future__ import annotations

from collections.abc import Sequence
from urllib.parse import quote
from xml.sax.saxutils import escape, quoteattr

from fieldspec.command.rendering.finding_text import concise, place
from fieldspec.command.rules import rule
from fieldspec.foundation.line_text import visible_json, visible_lines, visible_text
from fieldspec.foundation.source import Span
from fieldspec.language.diagnostics import Diagnostic


def json_text(findings: Sequence[Diagnostic]) -> str:
    """JSON: a list of objects with code, severity, message, place, labels and help.

    Lines and columns count from 1; the end column is exclusive.
    """
    data = [
        {
            "code": finding.code,
            "severity": finding.severity.value,
            "message": finding.message,
            **_json_place(finding.span),
            "labels": [{"message": label.text, **_json_place(label.span)} for label in finding.labels],
            "help": finding.help,
        }
        for finding in findings
    ]
    return visible_json(data, 1) + "\n"


def _json_place(span: Span) -> dict[str, object]:
    line, column = span.position()
    end_line, end_column = span.end_position()
    return {"file": span.file.path, "line": line, "column": column, "end_line": end_line, "end_column": end_column}


_SARIF_SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"


def sarif_text(findings: Sequence[Diagnostic]) -> str:
    """SARIF, for code scanning. Columns count UTF-16 code units from 1; the end column is exclusive."""
    codes = sorted({finding.code for finding in findings})
    run = {
        "tool": {"driver": {"name": "fieldspec", "rules": [_sarif_rule(code) for code in codes]}},
        "columnKind": "utf16CodeUnits",
        "results": [_sarif_result(finding, codes.index(finding.code)) for finding in findings],
    }
    log = {"$schema": _SARIF_SCHEMA, "version": "2.1.0", "runs": [run]}
    return visible_json(log, 1) + "\n"


def _sarif_rule(code: str) -> dict[str, object]:
    known = rule(code)
    if known is None:
        return {"id": code}
    return {
        "id": code,
        "shortDescription": {"text": known.what},
        "fullDescription": {"text": known.why},
        "help": {"text": f"{known.fix}\n\nExample: {known.example}"},
    }


def _sarif_result(finding: Diagnostic, number: int) -> dict[str, object]:
    text = finding.message + (f"\n{finding.help}" if finding.help else "")
    related = [
        {"id": number, "message": {"text": label.text}, **_sarif_location(label.span)}
        for number, label in enumerate(finding.labels, 1)
    ]
    return {
        "ruleId": finding.code,
        "ruleIndex": number,
        "level": finding.severity.value,
        "message": {"text": text},
        "locations": [_sarif_location(finding.span)],
        **({"relatedLocations": related} if related else {}),
    }


def _sarif_location(span: Span) -> dict[str, object]:
    line, column = span.position()
    end_line, end_column = span.end_position()
    region = {
        "startLine": line,
        "startColumn": _sarif_units(span, line, column),
        "endLine": end_line,
        "endColumn": _sarif_units(span, end_line, end_column),
    }
    return {"physicalLocation": {"artifactLocation": {"uri": _sarif_uri(span.file.path)}, "region": region}}


def _sarif_uri(path: str) -> str:
    """A path as a URI: relative, or of a file."""
    if path.startswith("/") or path[1:2] == ":":
        return "file:///" + quote(path.lstrip("/"), safe="/:", errors="surrogateescape")
    return quote(path, errors="surrogateescape")


def _sarif_units(span: Span, line: int, column: int) -> int:
    """A column in UTF-16 code units."""
    before = span.file.line(line)[: column - 1]
    return len(before.encode("utf-16-le")) // 2 + 1


def junit_xml(findings: Sequence[Diagnostic]) -> str:
    """JUnit XML: a failed test case for each finding, one passed case where there is none."""
    cases = "".join(_junit_case(finding) for finding in findings)
    if not findings:
        cases = '  <testcase classname="fieldspec" name="check"/>\n'
    head = f'<testsuite name="fieldspec" tests="{max(1, len(findings))}" failures="{len(findings)}" errors="0">'
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{head}\n{cases}</testsuite>\n'


def _junit_case(finding: Diagnostic) -> str:
    name, path = f"{finding.code} {place(finding.span)}", visible_text(finding.span.file.path)
    return (
        f"  <testcase classname={_junit_attribute(path)} name={_junit_attribute(name)}>\n"
        f"    <failure type={_junit_attribute(finding.code)} message={_junit_attribute(finding.message)}>"
        f"{escape(visible_lines(concise([finding])))}</failure>\n"
        f"  </testcase>\n"
    )


def _junit_attribute(text: str) -> str:
    return quoteattr(visible_lines(text))


def github_commands(findings: Sequence[Diagnostic]) -> str:
    """Workflow commands, which GitHub shows beside the lines of a change: one for each finding."""
    return "".join(_github_command(finding) for finding in findings)


def _github_command(finding: Diagnostic) -> str:
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
    properties_text = ",".join(
        f"{key}={_github_property(visible_text(str(value)))}" for key, value in properties.items()
    )
    return f"::{finding.severity.value} {properties_text}::{_github_data(text)}\n"


def _github_data(text: str) -> str:
    return visible_lines(text).replace("%", "%25").replace("\n", "%0A")


def _github_property(text: str) -> str:
    return _github_data(text).replace(":", "%3A").replace(",", "%2C")


_FORMATS = {"json": json_text, "sarif": sarif_text, "junit": junit_xml, "github": github_commands}


def format_findings(findings: Sequence[Diagnostic], form: str) -> str:
    """Findings as `json`, `sarif`, `junit` or `github`."""
    return _FORMATS[form](findings)
