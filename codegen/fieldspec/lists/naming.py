"""Names for what a list calls something: its English words, or else the address."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable

from fieldspec.schema import schema

_NAME = schema()["$defs"]["name"]
_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|[0-9]+")
_ASIDE = re.compile(r"\([^()]*\)|\[[^\[\]]*\]")
_LONGEST = 48


def named(texts: Iterable[str], address: int) -> str:
    """The first text that is English as a name, `register_2000` where none is."""
    for text in texts:
        name = snake(text)
        if name:
            return name
    return f"register_{address:04x}"


def snake(text: str) -> str:
    """`Target Position (0.01 mm)` as `target_position`; nothing where the words are not English."""
    plain = unicodedata.normalize("NFKD", _ASIDE.sub(" ", text))
    plain = "".join(sign for sign in plain if not unicodedata.combining(sign))
    if any(sign.isalpha() and not sign.isascii() for sign in plain):
        return ""
    name = ""
    for word in _WORD.findall(plain):
        longer = f"{name}_{word}".strip("_").lower()
        if len(longer) > _LONGEST:
            break
        name = longer
    return name if re.fullmatch(_NAME["pattern"], name) and len(name) > 1 else ""
