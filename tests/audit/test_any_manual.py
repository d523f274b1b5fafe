"""Whatever a text holds, an index of it is made or the text is refused; whatever a pattern says, nothing is raised."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

import gauge
from fieldspec.tools.audit.agreement import byte_pairs, has_word, numbers, readings, words
from fieldspec.tools.audit.manual_lines import ManualError, aligned, digest, index_line, index_of, index_text, parsed
from fieldspec.tools.audit.pattern import COLUMNS, FORMS, PatternError, row, template

PIECES = st.sampled_from(
    [
        "0x",
        "1F",
        "h",
        " H",
        "|",
        "\t",
        "~",
        "-",
        ".",
        ",",
        "…",
        "設",
        " ",
        "2^",
        "{",
        "}",
        "*",
        "AL.",
        "\x1c",
        "\x85",
        "^{*1}",
    ]
)
LINES = st.one_of(st.text(max_size=60), st.lists(PIECES, max_size=30).map("".join))
PATTERNS = st.one_of(
    st.text(max_size=60),
    st.lists(
        st.one_of(
            PIECES,
            st.builds("{{{}:{}}}".format, st.sampled_from([*COLUMNS]), st.sampled_from([*FORMS])),
        ),
        max_size=12,
    ).map("".join),
)


@given(st.lists(LINES, max_size=12).map("\n".join))
def test_an_index_is_read_as_it_is_written(text: str) -> None:
    try:
        index = index_of("manual", text.encode("utf-8", "replace"))
    except ManualError:
        return
    assert parsed("manual.index", index_text(index, "gauge")) == index


@given(st.binary(max_size=200))
def test_any_bytes_are_a_manual_or_refused(data: bytes) -> None:
    try:
        index = index_of("manual", data)
    except ManualError:
        return
    assert len(index.lines) == len(index.digests) >= 1


@given(LINES)
def test_any_line_is_reduced_to_one_line_that_stays_as_it_is(line: str) -> None:
    text = index_line(line)
    assert set(text) <= {"…", *map(chr, range(ord(" "), ord("~") + 1))}
    assert digest(line) == digest(f" {line} ")
    numbers(text)
    words(text)
    list(byte_pairs(text))


@given(LINES, LINES)
def test_any_words_and_numbers_are_looked_for(line: str, wanted: str) -> None:
    for word in words(index_line(wanted)):
        has_word(index_line(line), word)
    for number in readings(wanted):
        numbers(index_line(line)).holds(number)


@given(PATTERNS, LINES)
def test_any_pattern_is_refused_or_finds_pieces_of_the_line(pattern: str, line: str) -> None:
    try:
        compiled, cells = template(pattern), row(pattern.split("|"))
    except PatternError:
        return
    text = index_line(line)
    cells.find(text)
    compiled.whole(text)
    for match in compiled.each(text) if compiled.pieces else ():
        assert 0 <= match.start <= match.end <= len(text)


@given(st.lists(st.sampled_from([*gauge.MANUAL.splitlines(), "new", ""]), max_size=40).map("\n".join))
def test_any_edition_is_aligned(text: str) -> None:
    try:
        other = index_of("other", text.encode())
    except ManualError:
        return
    manual = aligned(gauge.index(), other)
    assert len(manual.known) == len(other.lines)
    assert manual.same + len(manual.changed) + len(manual.gone) == manual.whole
    assert all(1 <= here <= len(other.lines) for here in manual.here.values())
