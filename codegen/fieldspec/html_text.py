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


def _is_forbidden(char: str) -> bool:
    """Whether HTML forbids a character: a control character, half a character, or a code point that is no character."""
    code = ord(char)
    return unicodedata.category(char) in ("Cc", "Cs") or code & 0xFFFE == 0xFFFE or 0xFDD0 <= code <= 0xFDEF


def _picture(char: str) -> str:
    return chr(0x2400 + ord(char)) if ord(char) < 0x20 else "\ufffd"


@lru_cache(maxsize=_CACHED)
def escaped(text: str) -> str:
    """A text that means itself, in an element or in an attribute."""
    text = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    return text.replace("'", "&#39;").replace('"', "&#34;")
