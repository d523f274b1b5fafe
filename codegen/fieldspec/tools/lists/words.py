"""The words of lists, from `words.json`: headings by role, accesses, types, spaces, answers, orders of bytes, units,
and patterns of texts.

All but the patterns are folded. A heading that begins with `*` is a part of one; a role lists its likeliest first.
"""

from __future__ import annotations

import json
import re
import unicodedata
from collections.abc import Mapping
from functools import cache
from importlib import resources

_ACCENTS = re.compile("(?<=[a-z])[\u0300-\u036f]+")


@cache
def words(table: str) -> Mapping[str, tuple[str, ...]]:
    """The words of a table by what they stand for."""
    text = resources.files("fieldspec.tools.lists").joinpath("words.json").read_text("utf-8")
    return {key: tuple(entries) for key, entries in json.loads(text)[table].items()}


@cache
def meanings(table: str) -> Mapping[str, str]:
    """The meaning of each word of a table."""
    return {word: key for key, entries in words(table).items() for word in entries}


@cache
def folded(text: str) -> str:
    """A text without case, width, blanks, punctuation, and accents of Latin letters, for comparisons."""
    parts = unicodedata.normalize("NFD", unicodedata.normalize("NFKC", text).casefold())
    wide = unicodedata.normalize("NFC", _ACCENTS.sub("", parts))
    return "".join(sign for sign in wide if sign.isalnum())


def meaning(table: str, text: str) -> str:
    """The meaning of a text in a table; empty if it is not there."""
    return meanings(table).get(folded(text) or text.strip(), "")


def alternatives(name: str) -> str:
    """The part of a pattern that has what texts of all languages write for something."""
    return f"(?:{'|'.join(words('patterns')[name])})"


@cache
def pattern(name: str) -> re.Pattern[str]:
    """The pattern of what texts of all languages write for something."""
    return re.compile(alternatives(name), re.IGNORECASE)


@cache
def whole_words() -> Mapping[str, str]:
    """The headings that are whole words of a role, with the first such role."""
    return {
        word: role
        for role, role_words in reversed([*words("headings").items()])
        for word in role_words
        if not word.startswith("*")
    }
