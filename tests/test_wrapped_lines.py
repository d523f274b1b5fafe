"""Texts in lines of a width, beside the standard library's."""

from __future__ import annotations

import textwrap

from hypothesis import given
from hypothesis import strategies as st

from fieldspec.foundation.line_text import wrapped

WORDS = st.lists(st.text("ab-é", min_size=1, max_size=12), min_size=1, max_size=12)


@given(WORDS, st.integers(9, 30), st.sampled_from([("", ""), ("    ", "        ")]))
def test_lines_are_broken_where_the_standard_library_breaks_them(
    words: list[str], width: int, indentation: tuple[str, str]
) -> None:
    first, rest = indentation
    text = " ".join(words)
    expected = textwrap.wrap(
        text, width, initial_indent=first, subsequent_indent=rest, break_long_words=False, break_on_hyphens=False
    )
    assert wrapped(text, width, first, rest) == expected


def test_a_text_without_words_is_one_empty_line() -> None:
    assert wrapped("", 9) == [""]
