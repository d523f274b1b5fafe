"""Patterns find what specs declare, say what is wrong with them, and take no longer than the line is long."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from fieldspec.tools.audit.pattern import COLUMNS, FORMS, Match, PatternError, row, template


def texts(match: Match | None) -> list[str] | None:
    """The values of what is found."""
    return None if match is None else [value.text for value in match.values]


ROWS = [
    ("numbers and a name", ["{address:hex4} H", "{words}", "{name}"], "1000 H | 1 | State | …", ["1000", "1", "State"]),
    ("blanks may be missing", ["{address:hex4} H"], "1000H | 1", ["1000"]),
    ("a star skips", ["*", "* {code:decimal} *"], "a | … 12 … | b", ["12"]),
    ("an empty cell", ["", "{code:decimal}"], " | 7 | …", ["7"]),
    ("a mask", ["{bit:mask}"], "0x00000400 | …", ["0x00000400"]),
    ("a range", ["{range}"], "-9999.99~9999.99", ["-9999.99~9999.99"]),
    ("thousands", ["{max}"], "800,000", ["800,000"]),
    ("a name to the end of the cell", ["{name}"], "PT A5 / User IN 6 | 1", ["PT A5 / User IN 6"]),
]  # fmt: skip


@pytest.mark.parametrize(("cells", "line", "values"), [case[1:] for case in ROWS], ids=[case[0] for case in ROWS])
def test_a_row_is_found(cells: list[str], line: str, values: list[str]) -> None:
    assert texts(row(cells).find(line)) == values


NO_ROWS = [
    ("a cell that must be empty is not", ["", "{code:decimal}"], "1 | 7"),
    ("a cell holds more", ["{words}"], "1 word"),
    ("there are too few cells", ["{words}", "*"], "1"),
    ("four digits are not five", ["{address:hex4}"], "12345"),
    ("a number is not a range of two", ["{range:span}"], "5"),
]


@pytest.mark.parametrize(("cells", "line"), [case[1:] for case in NO_ROWS], ids=[case[0] for case in NO_ROWS])
def test_another_row_is_not_found(cells: list[str], line: str) -> None:
    assert row(cells).find(line) is None


EACH = [
    ("every value of a remark", "{code:decimal} :", "0 : OFF 1 : ON", [["0"], ["1"]]),
    ("not the number of a word", "{code:decimal} :", "Bit0 : OFF", []),
    ("a frame", "{frame}", "… : 07H+00H+12H+F5H", [["07H+00H+12H+F5H"]]),
    ("a frame in cells", "{frame}", "… | 01 | 06 | 20 | …", [["01 | 06 | 20"]]),
    ("one byte is not a frame", "{frame}", "01 H", []),
    ("pairs of cells", "{name:text} | {bit:mask}", "Stop | 0x02 | Jog | 0x04", [["Stop", "0x02"], ["Jog", "0x04"]]),
]


@pytest.mark.parametrize(("pattern", "line", "values"), [case[1:] for case in EACH], ids=[case[0] for case in EACH])
def test_all_pieces_of_a_line_are_found(pattern: str, line: str, values: list[list[str]]) -> None:
    assert [texts(match) for match in template(pattern).each(line)] == values


@pytest.mark.parametrize(
    ("pattern", "message"),
    [
        ("{adress}", "nothing is called `adress`"),
        ("{address:hexa}", "there is no form `hexa`"),
        ("{address", "a placeholder is written as"),
        ("}", "a placeholder is written as"),
        ("{Address}", "a placeholder is written as"),
    ],
)
def test_a_pattern_that_is_not_understood_says_why(pattern: str, message: str) -> None:
    with pytest.raises(PatternError, match=message):
        template(pattern)


@pytest.mark.parametrize("text", ["(a+)+$", "[", "\\", ".*", "a|b", "(?P<x>", "^$"])
def test_signs_of_regular_expressions_are_themselves(text: str) -> None:
    assert template(text.replace("*", "")).whole(text.replace("*", "")) is not None
    assert template(text.replace("*", "")).whole("aaaa") is None


HOSTILE = "*".join("{name:text}" for _ in range(18))


@pytest.mark.parametrize("pattern", [HOSTILE, "*".join("{code:decimal}" * 2 for _ in range(12)), "*" * 200, "*a" * 100])
@pytest.mark.parametrize("line", ["a" * 4000, "1" * 4000, "1 " * 2000, "a b " * 1000 + "|"])
def test_no_pattern_takes_long(pattern: str, line: str) -> None:
    compiled = template(pattern)
    before = time.process_time()
    compiled.whole(line)
    list(compiled.each(line)) if compiled.pieces else None
    assert time.process_time() - before < 3


def test_the_language_describes_every_column_and_form() -> None:
    page = (Path(__file__).resolve().parents[2] / "docs" / "language-proof.md").read_text("utf-8")
    section = page.partition("### Patterns of the manual")[2].partition("\n## ")[0]
    assert [word for word in (*COLUMNS, *FORMS) if f"`{word}`" not in section] == []
