"""Names of facts from the texts of a list, in the Latin letters that code takes."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable
from functools import lru_cache

from fieldspec.language.schema import schema
from fieldspec.tools.lists.brackets import without_brackets
from fieldspec.tools.lists.words import meanings

_NAME = re.compile(schema()["$defs"]["name"]["pattern"])
_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|[0-9]+")
_BETWEEN = re.compile(r"\s*[/|]\s*")
"""What stands between the same words in two languages."""

_LONGEST = 48
_ORDINALS = {"1st": "first", "2nd": "second", "3rd": "third", "4th": "fourth", "5th": "fifth", "6th": "sixth"}
_GREEK = re.compile(r"GREEK (?:SMALL|CAPITAL) LETTER (?:FINAL )?([A-Z]+)(?: .*)?")


def named(texts: Iterable[str], address: int, kind: str = "register") -> str:
    """A name from the first text in Latin letters, of one letter if there is no longer one, else `register_2000`."""
    names = [name for text in texts if (name := snake(text))]
    return next((name for name in names if len(name) > 1), names[0] if names else f"{kind}_{address:04x}")


@lru_cache(maxsize=20_000)  # rows have most texts in common, and each is read several times
def snake(text: str) -> str:
    """`Target Position (0.01 mm)` as `target_position`; empty if the words are in letters that have no Latin ones."""
    if len(text) <= _LONGEST and _NAME.fullmatch(text):
        return text
    bare = without_brackets(text)
    parts = (bare if re.search(r"[^\W\d_]", bare) else text, text, *_BETWEEN.split(bare))
    return next((name for part in parts if (name := _snake(part))), "")


def _snake(text: str) -> str:
    latin = "".join(map(_letter, unicodedata.normalize("NFC", text)))
    ascii_text = "".join(sign for sign in unicodedata.normalize("NFKD", latin) if not unicodedata.combining(sign))
    if any(sign.isalpha() and not sign.isascii() for sign in ascii_text):
        return ""
    for ordinal, word in _ORDINALS.items():
        ascii_text = re.sub(rf"\b{ordinal}\b", word, ascii_text, flags=re.IGNORECASE)
    name_words = _WORD.findall(ascii_text)
    leading = next((n for n, word in enumerate(name_words) if not word.isdecimal()), len(name_words))
    name = ""
    for word in [*name_words[leading:], *name_words[:leading]]:
        longer = f"{name}_{word}".strip("_").lower()
        if len(longer) > _LONGEST:
            break
        name = longer
    return name if _NAME.fullmatch(name) else ""


def _letter(sign: str) -> str:
    """A sign as Latin letters, where it has some: `ß`, the sound of Cyrillic and the names of Greek letters."""
    if sign.isascii():
        return sign
    if (latin := meanings("letters").get(sign.lower())) is not None:
        return latin.upper() if sign.isupper() else latin
    greek = _GREEK.fullmatch(unicodedata.name(sign, ""))
    return f" {greek[1].lower()} " if greek is not None else sign


def fresh(name: str, suffix: str, names: dict[str, int]) -> str:
    """A name that is not among some, which it is added to: with a suffix where it has to be, then with a number.

    `names` has the last number after each name, so that many equal names take no longer each than a few.
    """
    fresh_name, stem = name, f"{name}_{suffix}"
    while fresh_name in names:
        if stem not in names:
            fresh_name = stem
        else:
            names[stem] += 1
            fresh_name = f"{stem}_{names[stem]}"
    names[fresh_name] = 1
    return fresh_name
