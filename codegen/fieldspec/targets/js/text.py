"""Spec texts as literals of JavaScript and as comments."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence

from fieldspec.foundation.line_text import wrapped
from fieldspec.language.model.enums import Bit
from fieldspec.targets.explainer.literals import EXACT
from fieldspec.targets.explainer.wire import PURE as PURE
from fieldspec.targets.pieces import piece

WIDTH = 110


def literal(text: str) -> str:
    """A text in double quotes, in ASCII, which also stands safely within HTML."""
    return json.dumps(text).replace("</", "<\\/").replace("<!--", "<\\u0021--")


def object_of(rows: Mapping[str, str]) -> str:
    """An object on one line, of expressions by property."""
    return f"{{ {', '.join(f'{key}: {expression}' for key, expression in rows.items())} }}" if rows else "{}"


def flag(condition: bool) -> str:
    """`true` or `false`."""
    return "true" if condition else "false"


def function(name: str, parameters: str, lines: Iterable[str]) -> list[str]:
    """The function of a module. A constant is called faster than a declared function, which might be replaced."""
    return [f"const {name} = ({parameters}) => {{", *(f"  {line}" for line in lines), "};"]


def plus(expression: str, number: int) -> str:
    """The sum of an expression and a number."""
    return f"{expression} {'+' if number > 0 else '-'} {abs(number)}" if number else expression


def comment(paragraphs: Iterable[str], indent: int = 0) -> list[str]:
    """The lines of a documentation comment, none where all paragraphs are blank.

    Characters that are invisible, or that change the direction of a line, are written as escapes.
    """
    texts = tuple(paragraph for paragraph in paragraphs if paragraph.strip())
    return [*piece("comment of JavaScript", (), (texts, indent), lambda: _comment(texts, indent))]


def _comment(texts: Sequence[str], indent: int) -> list[str]:
    lines: list[str] = []
    for number, text in enumerate(texts):
        if number:
            lines.append("")
        lines += wrapped(_visible(" ".join(text.split())), WIDTH - indent)
    margin = " " * indent
    if not lines:
        return []
    if len(lines) == 1:
        return [f"{margin}/** {lines[0]} */"]
    return [f"{margin}/**", *(f"{margin} * {line}".rstrip() for line in lines), f"{margin} */"]


def _visible(text: str) -> str:
    if not text.isprintable():
        text = "".join(char if char.isprintable() else f"\\u{{{ord(char):x}}}" for char in text)
    # `@` would begin a tag, and `*/` would end the comment.
    return text.replace("*/", "*\\/").replace("@", "\\@")


def runs_of(bit: Bit) -> str:
    """The first bit and the number of bits of each run of a field of bits: `[[8, 7], [0, 1]]`"""
    return f"[{', '.join(f'[{run.first}, {run.width}]' for run in bit.runs)}]"


def integer_literal(number: float, wide: bool) -> str:
    """The literal of a number: a bigint where its type is `wide`, since other numbers of that size are inexact."""
    return f"{number}n" if wide else str(number)


def code_literal(number: int, digits: int = 0) -> str:
    """The literal of a code or a subcode, in hexadecimal with `digits`: a bigint only where a number is inexact."""
    return (f"0x{number:0{digits}X}" if digits else str(number)) + "n" * (number > EXACT)


def pairs_literal(intervals: Iterable[tuple[float, float]], wide: bool) -> str:
    """The first and the last number of each interval as an array of arrays."""
    pairs = (f"[{integer_literal(low, wide)}, {integer_literal(high, wide)}]" for low, high in intervals)
    return f"[{', '.join(pairs)}]"
