"""Spec texts as Python literals and docstrings, and long statements over several lines."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from functools import lru_cache

from fieldspec.foundation.line_text import wrapped

WIDTH = 110
# Characters that are invisible, or that change how the rest of a line is displayed.
_HIDDEN = (
    *((code, code) for code in (0xAD, 0x61C, 0xFEFF)),
    (0x00, 0x1F),
    (0x7F, 0x9F),
    (0x200B, 0x200F),
    (0x2028, 0x202E),
    (0x2060, 0x206F),
    (0xD800, 0xDFFF),
    (0xFFF9, 0xFFFB),
    (0xE0000, 0xE007F),
)


_ESCAPED = re.compile("[" + "".join(f"{chr(low)}-{chr(high)}" for low, high in _HIDDEN) + r"\\]")


def _escape(match: re.Match[str]) -> str:
    if match[0] == "\\":
        return "\\\\"
    code = ord(match[0])
    return f"\\x{code:02x}" if code < 0x100 else f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}"


def literal(text: str) -> str:
    """A text in double quotes on one line."""
    return '"' + _ESCAPED.sub(_escape, text).replace('"', '\\"') + '"'


def docstring(paragraphs: Iterable[str], indent: int = 0) -> list[str]:
    """The lines of a docstring of some paragraphs; those that begin with a blank are kept as one line each.

    An empty list where all paragraphs are blank.
    """
    texts = [paragraph for paragraph in paragraphs if paragraph.strip()]
    if not texts:
        return []
    lines: list[str] = []
    for number, text in enumerate(texts):
        if number and not (text.startswith(" ") and texts[number - 1].startswith(" ")):
            lines.append("")
        lines += _wrapped(text, WIDTH - indent)
    escaped = [_within_quotes(line) for line in lines[:-1]]
    # A quotation mark at the very end would be taken for the first of those that close the docstring.
    last = lines[-1]
    escaped.append(_within_quotes(last[:-1]) + '\\"' if last.endswith('"') else _within_quotes(last))
    margin = " " * indent
    if len(escaped) == 1:
        return [f'{margin}"""{escaped[0]}"""']
    body = [f"{margin}{line}" if line else "" for line in escaped[1:]]
    return [f'{margin}"""{escaped[0]}', *body, f'{margin}"""']


def _within_quotes(line: str) -> str:
    return _ESCAPED.sub(_escape, line).replace('"""', '\\"\\"\\"')


@lru_cache(maxsize=20_000)  # versions of a device have most texts in common
def _wrapped(text: str, width: int) -> tuple[str, ...]:
    """A text in lines; a leading blank marks an indented line, whose continuation is indented further."""
    is_item = text.startswith(" ")
    return tuple(wrapped(" ".join(text.split()), width - 8, *(("    ", "        ") if is_item else ())))


def filled(start: str, items: Sequence[str], end: str, indent: int) -> list[str]:
    """`start`, items with commas, and `end` on one line if they fit; otherwise filled, indented rows.

    `indent` is the indentation of the statement, which the lines do not include.
    """
    line = f"{start}{', '.join(items)}{end}"
    if len(line) + indent <= WIDTH or not items:
        return [line]
    rows = [f"    {items[0]},"]
    for item in items[1:]:
        if len(rows[-1]) + len(item) + 2 + indent > WIDTH:
            rows.append(f"    {item},")
        else:
            rows[-1] += f" {item},"
    return [start, *rows, end]


def unpacked(names: Sequence[str], source: str, indent: int) -> list[str]:
    """The statement that unpacks a source into names; the source alone where there are none."""
    if not names:
        return [source]
    line = f"({names[0]},) = {source}" if len(names) == 1 else f"{', '.join(names)} = {source}"
    return [line] if len(line) + indent <= WIDTH else filled("(", names, f") = {source}", indent + WIDTH)


def item_lines(start: str, items: Sequence[str], end: str, indent: int) -> list[str]:
    """The same as `filled`, but one item a line where they do not all fit on one."""
    line = f"{start}{', '.join(items)}{end}"
    if len(line) + indent <= WIDTH or not items:
        return [line]
    return [start, *(f"    {item}," for item in items), end]


def chained(start: str, items: Sequence[str], joint: str, empty: str, indent: int) -> list[str]:
    """Expressions joined by a `joint` such as `and`; in parentheses, one a line, where they do not fit on one line."""
    line = f"{start}{f' {joint} '.join(items) or empty}"
    if len(line) + indent <= WIDTH or len(items) < 2:
        return [line]
    return [f"{start}(", f"    {items[0]}", *(f"    {joint} {item}" for item in items[1:]), ")"]


def union(name: str, types: Sequence[str]) -> list[str]:
    """The statement that names a union of types."""
    return chained(f"{name}: _TypeAlias = ", types, "|", "", 0)
