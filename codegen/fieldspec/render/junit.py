"""Findings as JUnit XML: a failed test case for each finding, one passed case where there is none."""

from __future__ import annotations

from collections.abc import Sequence
from xml.sax.saxutils import escape, quoteattr

from fieldspec.diagnostics import Diagnostic
from fieldspec.render.blocks import visible_text
from fieldspec.render.text import concise, place


def rendered(findings: Sequence[Diagnostic]) -> str:
    """The XML text."""
    cases = "".join(_case(finding) for finding in findings)
    if not findings:
        cases = '  <testcase classname="fieldspec" name="check"/>\n'
    head = f'<testsuite name="fieldspec" tests="{max(1, len(findings))}" failures="{len(findings)}" errors="0">'
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{head}\n{cases}</testsuite>\n'


def _case(finding: Diagnostic) -> str:
    name = f"{finding.code} {place(finding.span)}"
    return (
        f"  <testcase classname={_attribute(finding.span.file.path)} name={_attribute(name)}>\n"
        f"    <failure type={_attribute(finding.code)} message={_attribute(finding.message)}>"
        f"{escape(_visible(concise([finding])))}</failure>\n"
        f"  </testcase>\n"
    )


def _attribute(text: str) -> str:
    return quoteattr(_visible(text))


def _visible(text: str) -> str:
    """A text with escapes for the characters that XML does not allow."""
    return "\n".join(visible_text(line) for line in text.split("\n"))
