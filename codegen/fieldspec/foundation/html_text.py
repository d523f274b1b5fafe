"""Texts of specs in HTML pages: which characters a page may have, and their escapes."""

from __future__ import annotations

import re
import unicodedata
from functools import lru_cache

_BLANKS = re.compile(r"\s+")
_CACHED = 1 << 16


def clean(text: str) -> str:
    """A text in one line, with a picture for every other control character."""
    if text.isprintable() and "  " not in text:
        return text
    text = _BLANKS.sub(" ", text)
    return "".join(_picture(char) if _is_forbidden(char) else char for char in text)


BIDIRECTIONAL = frozenset("\u061c\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069")
"""The characters with the property Bidi_Control of Unicode, which change the order in which others are shown."""


def _is_forbidden(char: str) -> bool:
    """Whether a page must not have a character.

    HTML forbids control characters, half a character, and code points that are not characters. A change of the order of
    letters could make a page show a wrong fact.
    """
    code = ord(char)
    is_no_character = code & 0xFFFE == 0xFFFE or 0xFDD0 <= code <= 0xFDEF
    return unicodedata.category(char) in ("Cc", "Cs") or is_no_character or char in BIDIRECTIONAL


def _picture(char: str) -> str:
    return chr(0x2400 + ord(char)) if ord(char) < 0x20 else "\ufffd"


@lru_cache(maxsize=_CACHED)
def escaped(text: str) -> str:
    """A text that means itself, in an element or in an attribute."""
    text = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return text.replace("'", "&#39;").replace('"', "&#34;")
