"""Findings as text for people: the source line with carets under the place, and every other place involved."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

from fieldspec.command.rendering.blocks import width
from fieldspec.foundation.line_text import plural, visible_text
from fieldspec.foundation.source import Span
from fieldspec.language.diagnostics import Diagnostic, Severity

_Paint: TypeAlias = Callable[[str, str], str]

LONGEST_LINE = 160

_STYLES = {
    "error": "1;31",
    "warning": "1;33",
    "place": "1",
    "mark": "1;31",
    "other": "1;34",
    "help": "1;32",
    "dim": "2",
}


def rendered(findings: Sequence[Diagnostic], *, coloured: bool = False) -> str:
    """All findings, and how many errors and warnings they are."""
    paint = _painted if coloured else _unstyled
    blocks = [_block(finding, paint) for finding in findings]
    errors = sum(finding.severity is Severity.ERROR for finding in findings)
    counts = ((errors, "error"), (len(findings) - errors, "warning"))
    return "\n".join(blocks) + "\n" + ", ".join(plural(*count) for count in counts if count[0]) + "\n"


def _unstyled(style: str, text: str) -> str:
    return text


def _painted(style: str, text: str) -> str:
    return f"\x1b[{_STYLES[style]}m{text}\x1b[0m"


def _block(finding: Diagnostic, paint: _Paint) -> str:
    severity = finding.severity.value
    lines = [
        f"{paint('place', place(finding.span))}: {paint(severity, f'{severity}[{finding.code}]')}: "
        f"{visible_text(finding.message)}",
        *_marked_lines(finding.span, "^", paint, "mark"),
    ]
    for label in finding.labels:
        lines.append(f"  {paint('other', place(label.span))}: {visible_text(label.text)}")
        lines += _marked_lines(label.span, "-", paint, "other")
    if finding.help:
        lines.append(f"  {paint('help', 'help')}: {visible_text(finding.help)}")
    return "\n".join(lines) + "\n"


def _marked_lines(span: Span, mark: str, paint: _Paint, style: str) -> list[str]:
    """The source line with marks under the span; of a long line, only the part around the span."""
    number, column = span.position()
    source = span.file.line(number)
    if not source.strip():
        return []
    first = column - 1
    last = first + marked_characters(span)
    start = max(0, first - 20) if len(source) > LONGEST_LINE else 0
    excerpt = source[start : start + LONGEST_LINE]
    before = visible_text(("..." if start else "") + source[start:first])
    under = visible_text(source[first : min(last, start + LONGEST_LINE)]) or " "
    gutter = f"{number:>6} | "
    after = "..." if start + LONGEST_LINE < len(source) else ""
    return [
        paint("dim", gutter) + ("..." if start else "") + visible_text(excerpt) + after,
        paint("dim", " " * 6 + " | ") + " " * width(before) + paint(style, mark * max(1, width(under))),
    ]


def marked_characters(span: Span) -> int:
    """The number of underlined characters of the source line: the span in its first line, or one."""
    number, column = span.position()
    return max(1, min(len(span.file.line(number)) - column + 1, span.end - span.start))


def place(span: Span) -> str:
    """`gadget/points.yaml:12:7`"""
    line, column = span.position()
    return visible_text(f"{span.file.path}:{line}:{column}")


def concise(findings: Sequence[Diagnostic]) -> str:
    """A line for each finding, each label and each help."""
    text = ""
    for finding in findings:
        text += f"{place(finding.span)}: {finding.code}: {visible_text(finding.message)}\n"
        for label in finding.labels:
            text += f"  label {place(label.span)}: {visible_text(label.text)}\n"
        if finding.help:
            text += f"  help: {visible_text(finding.help)}\n"
    return text
