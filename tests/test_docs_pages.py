"""The pages are as long as their readers can bear, each in its group, and in plain English."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from english_patterns import hits

ROOT = Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"
INDEX = (DOCS / "index.md").read_text("utf-8")
README = (ROOT / "README.md").read_text("utf-8")
GROUPS = {caption: pages.split() for caption, pages in re.findall(r":caption: (\w+)\n\n(.*?)```", INDEX, re.DOTALL)}
DOORS = ("add-a-device", "versions", "plc", "program", "unit")
GENERATED = (
    *("api-c", "api-python", "api-typescript", "capabilities", "changes", "checks", "command-line", "language"),
    *(f"language-{page}" for page in ("structure", "evidence", "operation", "proof", "limits")),
)
"""Reference pages that are written from the code, the schema and the checks."""

MOST_WORDS_OF_A_DOOR = 1200
MOST_WORDS = 45_000
"""The words of all guides and reference pages that people write."""

CEILINGS = {"Guides": 0, "Reference": 0, "Proof": 0}
"""The hits of the expressions in each group. They can only fall: lower a ceiling with the page that improves."""


def text_of(page: str) -> str:
    return (DOCS / f"{page}.md").read_text("utf-8")


def test_the_pages_are_guides_reference_and_proof() -> None:
    assert list(GROUPS) == ["Guides", "Reference", "Proof"]
    assert set(GENERATED) <= set(GROUPS["Reference"])


@pytest.mark.parametrize("text", [README, INDEX.replace("](", "](docs/")], ids=["README", "index"])
def test_five_doors_are_named(text: str) -> None:
    rows = re.findall(r"^\| [^|]*\*\*[^|]+\*\*[^|]* \|.*\]\(docs/([\w-]+)\.md\) \|$", text, re.MULTILINE)
    assert rows == list(DOORS)


@pytest.mark.parametrize("page", DOORS)
def test_a_door_is_short_and_ends_in_a_result_with_links_to_reference(page: str) -> None:
    text = text_of(page)
    headings = re.findall(r"^## (.*)$", re.sub(r"```.*?```", "", text, flags=re.DOTALL), re.MULTILINE)
    links = re.findall(r"\]\(([\w-]+)\.md", text.rpartition("\n## ")[2])
    assert len(text.split()) <= MOST_WORDS_OF_A_DOOR
    assert any(re.fullmatch(r"\d\. The result", heading) for heading in headings[-3:])
    assert headings[-1] in ("Next", "Reference")
    assert set(links) & set(GROUPS["Reference"])


def test_guides_and_reference_that_people_write_have_a_bound() -> None:
    pages = [page for group in ("Guides", "Reference") for page in GROUPS[group] if page not in GENERATED]
    count = sum(len(text.split()) for text in (README, INDEX, *map(text_of, pages)))
    assert count <= MOST_WORDS


@pytest.mark.parametrize("group", GROUPS)
def test_a_group_is_in_plain_english(group: str) -> None:
    all_hits = [f"{page}.md:{hit}" for page in GROUPS[group] for hit in hits(text_of(page))]
    assert len(all_hits) <= CEILINGS[group], "\n".join(all_hits)


@pytest.mark.parametrize("text", [README, INDEX], ids=["README", "index"])
def test_the_first_pages_are_in_plain_english(text: str) -> None:
    assert list(hits(text)) == []


@pytest.mark.parametrize(
    ("line", "name"),
    [
        ("Nobody knows it.", "nobody"),
        ("What is read stays.", "'What is"),
        ("A byte tells which it is.", "tell"),
        ("They are written anew.", "a rare word"),
        ("The byte behind it.", "behind"),
        ("This is no frame.", "is no X"),
        ("It goes on.", "goes on"),
        ("Of registers, this holds.", "a fronted Of"),
    ],
)
def test_an_expression_finds_what_it_is_for(line: str, name: str) -> None:
    assert [hit for hit in hits(line) if hit.startswith(f"1: {name}")]


def test_code_is_not_judged() -> None:
    assert list(hits("`nobody` waits\n```\nnobody waits\n```\n")) == []
