"""The words of headings: which roles a heading names as a whole, in a row of its own, or in a part."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Mapping, Sequence

from fieldspec.tools.lists.brackets import without_brackets
from fieldspec.tools.lists.words import folded, whole_words, words

NOTE = "note"

_SHORT_WORDS = ((r"^reg(?![a-z])", "register"), (r"\badr\b", "address"), (r"\bfc\b", "function code"))
"""Patterns of words that headings shorten, and the whole words."""

_BETWEEN = re.compile(r"\s*[/|\n]\s*")
_WORD = re.compile(r"[A-Z]+(?![^\W\d_A-Z])|[A-Z]?[^\W\d_A-Z]+|[0-9]+")
_ANNOTATIONS = {NOTE, "label", "values"}
"""The roles of the second word of a heading such as `Values / Notes`."""


def _variants(texts: Sequence[str]) -> Iterator[str]:
    """A heading as a whole, its rows, each without what is in brackets, and what means the same in two languages."""
    for text in (" ".join(texts), *texts):
        yield text
        if bare := without_brackets(text).strip():
            yield bare
        for pattern, word in _SHORT_WORDS:
            if (whole := re.sub(pattern, word, text, flags=re.IGNORECASE)) != text:
                yield whole
        pieces = _BETWEEN.split(text)
        roles = {whole_words().get(folded(piece)) for piece in pieces}
        is_annotated = bool(roles) and {whole_words().get(folded(piece)) for piece in pieces[1:]} <= _ANNOTATIONS
        if len(pieces) > 1 and (len(roles - {None}) == 1 or is_annotated) and roles != {None}:
            yield next(piece for piece in pieces if folded(piece) in whole_words())


def is_of_station(heading: str) -> bool:
    """Whether a heading is that of addresses of stations, networks or chips."""
    stations = words("stations")["address"]
    return folded(heading).startswith(stations) or folded(heading).endswith(stations)


def heads_of(texts: Sequence[str]) -> dict[str, frozenset[int]]:
    """The variants of a heading, folded, each with the places at which its words begin and end."""
    return {folded(text): frozenset(_ends_of_words(text)) for text in _variants(texts)}


def _ends_of_words(text: str) -> Iterator[int]:
    place = 0
    yield place
    for word in _WORD.findall(unicodedata.normalize("NFKC", text)):
        place += len(folded(word))
        yield place


def ranked(
    heads: Sequence[Mapping[str, frozenset[int]]], role_words: Sequence[str], used_columns: set[int]
) -> list[int]:
    """The columns whose headings fit a role, the likeliest first. No part counts of a heading that is another word."""
    whole = whole_words()
    ranked_columns: dict[int, None] = {}
    for word in role_words:
        for column, texts in enumerate(heads):
            if (
                column not in used_columns
                and any(_fits(text, ends, word) for text, ends in texts.items())
                and (
                    not word.startswith("*")
                    or whole.keys().isdisjoint(texts)
                    or not whole.keys().isdisjoint({*texts} & {*role_words})
                )
            ):
                ranked_columns.setdefault(column)
    return list(ranked_columns)


def _fits(head: str, ends: frozenset[int], word: str) -> bool:
    """Whether a heading is a word, or has a part that begins or ends with a word and is not made of two: neither the
    `values` of `My Value Slave` are one, nor the `min` of `Nominal`."""
    if not word.startswith("*"):
        return head == word
    part = word[1:]
    place = head.find(part)
    while place >= 0:
        end = place + len(part)
        touches = (place in ends, end in ends)
        if not part.isascii() or all(touches) or (any(touches) and not any(place < inner < end for inner in ends)):
            return True
        place = head.find(part, place + 1)
    return False
