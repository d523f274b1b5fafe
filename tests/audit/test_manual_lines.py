"""What an index keeps of a line, and what numbers, words and bytes are read from it."""

from __future__ import annotations

from decimal import Decimal

import pytest

from fieldspec.tools.audit.agreement import byte_pairs, has_printed_value, has_word, numbers, readings
from fieldspec.tools.audit.manual_lines import LONGEST, digest, index_line, index_of
from fieldspec.tools.audit.pattern import PieceValue
from fieldspec.tools.facts.row import COLUMNS

INDEX_LINES = [
    ("words of prose are left out", "Set the speed before you start the motor.", "Set …."),
    ("so is what is not written in Latin letters", "設定速度 ServoOn 之前", "… ServoOn …"),
    ("a row keeps its cells", "| 1000 H | 1 | ActionStatus | the state |", "1000 H | 1 | ActionStatus | …"),
    ("a tab is a new cell, also at the beginning", "\t0\tabs\t", " | 0 | abs"),
    ("a cell of one word keeps it", "ro | rw only", "ro | …"),
    ("full-width digits and signs are plain ones", "\uff11\uff12\uff28\uff1a\uff08\uff15\uff09", "12H:(5)"),
    ("a unit that hangs on a number stays", "600ms later", "600ms …"),
    ("a suffix after a blank stays", "0x10 and 2000 h", "0x10 … 2000 h"),
    ("circled digits do not run into numbers", "①600ms", "(1) 600ms"),
    ("raised digits are powers", "2¹⁵", "2^15"),
    ("marks of footnotes are left out", "Digital outputs ^{*1}", "Digital …"),
    ("cells of HTML are cells", "<td>7</td><td>8</td>", " | 7 |  | 8"),
    ("a ruled line is nothing", "|---|:--:|", ""),
    ("a multiplication is not a footnote", "PT32*32+10000", "PT32*32+10000"),
]


@pytest.mark.parametrize(("line", "text"), [row[1:] for row in INDEX_LINES], ids=[row[0] for row in INDEX_LINES])
def test_an_index_keeps_what_can_be_a_fact(line: str, text: str) -> None:
    assert index_line(line) == text


def test_an_index_keeps_no_sentence() -> None:
    text = index_line(
        "When the motor has come to a stop, wait until the controller answers, and write the value again."
    )
    assert [word for word in text.split() if word.isalpha()] == ["When"]


def test_a_line_without_an_end_is_cut() -> None:
    assert len(index_line("9" * 10 * LONGEST)) == LONGEST


def test_the_hash_of_a_line_does_not_know_its_blanks() -> None:
    assert digest("1000 H | 1") == digest("  1000H|1\t") != digest("1001 H | 1")
    assert digest(" \t") == ""


READINGS = [
    ("0x10", [16]),
    ("10h", [16]),
    ("10 H", [16]),
    ("&H10", [16]),
    ("10", [10, 16]),
    ("3E8", [1000]),
    ("1,000", [1000]),
    ("-5", [-5, -5]),
    ("0.01", [Decimal("0.01")]),
    ("2^15", [32768]),
    ("2^{31}-1", [2147483647]),
    ("x", []),
]


@pytest.mark.parametrize(("text", "means"), READINGS, ids=[row[0] for row in READINGS])
def test_a_number_is_read_in_every_spelling(text: str, means: list[int]) -> None:
    assert list(readings(text)) == means


def test_a_form_says_how_a_bare_number_is_read() -> None:
    assert readings("10", "decimal") == (10,)
    assert readings("10", "hex") == (16,)


HAS_NUMBERS = [
    ("0..5 is an interval", "Bits 0~5", 3),
    ("so is -5 to -2", "-5 ~ -2", -3),
    ("so is what an ellipsis leaves out", "Bit0 = … - ... - Bit8 = …", 4),
    ("hexadecimal bounds", "0x0001~0x0080", 0x40),
    ("the number of a word", "PZD7", 7),
    ("a number after a prefix", "Pt53A", 0x53A),
    ("an alarm", "AL.EE0", 0xEE0),
    ("a voltage", "DC24V", 24),
    ("a bit of a word", "STW1.8 = 1", 8),
    ("digits that stand one by one", "0 | 1 | 1 | 0 | 9 | 9 | 9 | B", 0x999B),
]


@pytest.mark.parametrize(("line", "number"), [row[1:] for row in HAS_NUMBERS], ids=[row[0] for row in HAS_NUMBERS])
def test_a_line_holds_a_number_in_any_way_to_print_it(line: str, number: int) -> None:
    assert numbers(line).holds(number)


@pytest.mark.parametrize(("line", "number"), [("1~5", 6), ("0x10", 10), ("0.5", 5), ("", 0), ("1000", 100)])
def test_a_line_does_not_hold_other_numbers(line: str, number: int) -> None:
    assert not numbers(line).holds(number)


@pytest.mark.parametrize(
    ("ranges", "column", "text", "is_printed"),
    [
        ("-5..100", "min", "-5", True),
        ("-5..100", "min", "-0.5", True),
        ("-5..100", "min", "FFFBh", True),
        ("-5..100", "max", "FFFBh", False),
        ("-5..100", "max", "100", True),
        ("-5..100", "max", "10.0", True),
        ("0..100", "min", "0", True),
        ("0..100", "min", "10000h", False),
    ],
)
def test_a_bound_is_printed_as_a_number_as_a_quantity_or_as_its_bytes(
    ranges: str, column: str, text: str, is_printed: bool
) -> None:
    row = {**dict.fromkeys(COLUMNS), "ranges": ranges, "type": "i16", "bytes": 2, "scale": Decimal("0.1")}
    assert has_printed_value(row, PieceValue(column, "number", text), ()) == is_printed


def test_a_series_of_words_holds_those_between() -> None:
    assert has_word("IN1 ~ IN14", "in5")
    assert has_word("ALM_LOG0", "log")
    assert not has_word("IN1, IN14", "in5")
    assert not has_word("IN1 ~ IN14", "in15")


@pytest.mark.parametrize("line", ["01 | 06 | 20", "01H+06H+20H", "0x01, 0x06, 0x20", "01 06 20"])
def test_bytes_are_read_from_every_way_to_print_a_frame(line: str) -> None:
    assert bytes(byte_pairs(line)) == bytes([1, 6, 0x20])


def test_nothing_is_kept_of_programs_that_a_manual_prints() -> None:
    index = index_of("m.txt", b"Code 05H\n```\nCRC = 65535\n```\nCode 06H\n")
    assert list(index.lines) == ["Code 05H", "", "", "", "Code 06H"]
    assert all(index.digests)


def test_a_finding_encloses_the_whole_line_of_the_manual() -> None:
    index = index_of("m.txt", b"Code 05H\nSpeed 1..100\n\nForce 0..9\n")
    spans = [index.span(number) for number in (1, 2, 3, 4)]
    assert [span.file.text[span.start : span.end] for span in spans] == ["Code 05H", "Speed 1..100", "\n", "Force 0..9"]
