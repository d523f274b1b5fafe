"""Markdown pages hold no markup but their own."""

from __future__ import annotations

import re
from functools import cache

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from markdown_it import MarkdownIt
from markdown_it.token import Token

from docs_output.documented import documentation, resolved, visible_text, with_ending
from fieldspec.foundation.html_text import clean
from fieldspec.targets.docs.markdown import escaped
from layouts import TEST_SPECS, newest

PAGES = with_ending(".md")
# The scope of a module has all tests of a page run after each other, and in one process, which parses it once.
OWN = re.compile(r'<br>|<a id="[\w/.-]+">|</a>|<!-- Written by fieldspec .* -->')


@cache
def tokens(path: str) -> list[Token]:
    return MarkdownIt("commonmark").enable("table").parse(documentation()[path])


def inline(tokens: list[Token]) -> list[Token]:
    return [child for token in tokens for child in token.children or ()]


def flowing(tokens: list[Token]) -> str:
    return visible_text(
        "".join(token.content for token in inline(tokens) if token.type in ("text", "code_inline", "softbreak"))
    )


@pytest.mark.proof(15)
@pytest.mark.parametrize("path", PAGES, scope="module")
def test_a_page_has_no_html_but_its_own(path: str) -> None:
    every = [*tokens(path), *inline(tokens(path))]
    html = [token.content.strip() for token in every if token.type in ("html_inline", "html_block")]
    assert [piece for piece in html if not OWN.fullmatch(piece)] == []


@pytest.mark.proof(40)
@pytest.mark.parametrize("path", PAGES, scope="module")
def test_links_lead_to_anchors_and_pages_that_are_there(path: str) -> None:
    for token in inline(tokens(path)):
        page, _, anchor = str(token.attrGet("href") or "").partition("#") if token.type == "link_open" else ("", "", "")
        target = resolved(path, page) if page else path
        assert target in documentation(), page
        if anchor:
            assert f'<a id="{anchor}">' in documentation()[target], anchor


@pytest.mark.parametrize("path", PAGES, scope="module")
def test_rows_of_a_table_are_as_wide_as_its_head(path: str) -> None:
    widths: list[int] = []
    for token in tokens(path):
        if token.type == "tr_open":
            widths.append(0)
        elif token.type in ("th_open", "td_open"):
            widths[-1] += 1
        elif token.type == "table_close":
            assert len(set(widths)) == 1
            widths = []


@pytest.mark.parametrize("path", PAGES, scope="module")
def test_every_table_of_the_text_is_a_table_of_the_page(path: str) -> None:
    rules = sum(bool(re.fullmatch(r"\|(---\|)+", line)) for line in documentation()[path].splitlines())
    assert rules == sum(token.type == "table_open" for token in tokens(path))


def test_labels_arrive_as_the_text_that_they_are() -> None:
    device = newest(TEST_SPECS, "hostile").device
    page = flowing(tokens("hostile/1.md"))
    for enum in device.enums.values():
        for member in enum.members:
            assert visible_text(member.label) in page


def test_labels_do_not_begin_headings_or_lists() -> None:
    headings = [token for token in tokens("hostile/1.md") if token.type == "heading_open"]
    text = [line for line in documentation()["hostile/1.md"].splitlines() if line.startswith("#")]
    assert len(headings) == len(text)


@settings(deadline=None)
@given(st.text(alphabet=st.characters(exclude_categories=["Cs"]), max_size=30))
def test_any_text_means_itself(text: str) -> None:
    wanted = clean(text).strip(" ")
    tokens = MarkdownIt("commonmark").enable("table").parse(f"before {escaped(wanted)} after")
    visible_text = "".join(token.content for token in inline(tokens))
    assert visible_text == f"before {wanted} after" if wanted else visible_text.startswith("before")


@settings(deadline=None)
@given(st.text(alphabet="#+-=>*_`|\\<&1.) ab~[]!:", max_size=12))
def test_any_text_means_itself_at_the_start_of_a_line_and_in_a_table(text: str) -> None:
    wanted = clean(text).strip(" ")
    if wanted:
        lone = MarkdownIt("commonmark").enable("table").parse(escaped(wanted))
        assert [token.type for token in lone] == ["paragraph_open", "inline", "paragraph_close"]
        assert "".join(token.content for token in inline(lone)) == wanted
        tokens = MarkdownIt("commonmark").enable("table").parse(f"| a | b |\n|---|---|\n| {escaped(wanted)} | end |\n")
        cells = [token for token in tokens if token.type == "inline"]
        assert "".join(child.content for child in cells[2].children or ()) == wanted
        assert cells[3].content == "end"


def test_bits_are_drawn_in_characters() -> None:
    (drawn,) = [
        token.content
        for token in tokens("widget/2.0.md")
        if token.type == "fence" and "packet" not in token.content and "lap" in token.content
    ]
    assert drawn == DRAWN


DRAWN = """\
 15  14  13  12  11  10   9   8   7   6   5   4   3   2   1   0
+---+---+---+---+---+---+---+---+---+---+---+---+---+---+---+---+
|   | x |   |   | x | x | x | x |   |   | x | x |   | x | x | x |
+---+---+---+---+---+---+---+---+---+---+---+---+---+---+---+---+
      |                       |               |       |   |   +- 0 ready
      |                       |               |       |   +- 1 start
      |                       |               |       +- 2 brake
      |                       |               +- 4..5 level
      |                       +- 8..11 lap
      +- 14 overlay
"""
