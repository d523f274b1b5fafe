"""Bytes as people spell them: `01 06`, `0106`, `01:06`, `0x01, 0x06`, `09H+00H`, `16#01`, or the characters sent."""

from __future__ import annotations

import re
from collections.abc import Iterable

from fieldspec.model.link import Link

# Patterns are texts, which `re` compiles when they are first used: plain bytes need none of them.
_EACH_ENCLOSED = r"(?:\[[0-9A-Fa-f]{2}\]\s*)+|(?:<[0-9A-Fa-f]{2}>\s*)+"
_QUOTED = r"""(?s)b?(["'])(.*)\1[,;]?|\[(.*)\]|\{(.*)\}|\((.*)\)"""
_SEPARATOR = r"[\s,;:+_|-]+|(?<=[0-9A-Fa-f])(?=\\x)"
_PIECE = r"(?i)(?:0x|\\x|16#|&h|\$)?(?P<digits>[0-9a-f]+)|(?P<behind>[0-9a-f]+)h"

_LAST = r"(?i)(?:\\x(?P<code>[0-9a-f]{2})|[<\[]?(?P<name>crlf|cr|lf|\\r|\\n)[>\]]?|(?P<real>[\r\n]))\Z"
_CHARACTERS = {"\\r": "\r", "\\n": "\n", "cr": "\r", "lf": "\n", "crlf": "\r\n"}
_CONTROLS = {0x02: "STX", 0x03: "ETX", 0x0A: "LF", 0x0D: "CR"}


class Unreadable(ValueError):
    """A text that cannot be understood as bytes; says why."""


def is_spelled(word: str) -> bool:
    """Whether a word without blanks may be bytes."""
    pieces = [piece for piece in re.split(_SEPARATOR, word) if piece]
    return bool(pieces) and all(re.fullmatch(_PIECE, piece) for piece in pieces)


def is_each_enclosed(text: str) -> bool:
    """Whether every byte stands in brackets of its own."""
    return re.fullmatch(_EACH_ENCLOSED, text.strip()) is not None


def unquoted(text: str) -> str:
    """A text without the quotes, brackets or braces around it; brackets around each byte are left."""
    match = None if is_each_enclosed(text) else re.fullmatch(_QUOTED, text.strip())
    return next(inner for inner in match.groups()[1:] if inner is not None) if match else text


def spelled(text: str) -> bytes:
    """The bytes of a text. Raises Unreadable."""
    text = unquoted(text)
    if is_each_enclosed(text):
        text = re.sub(r"[\[\]<>]+", " ", text)
    data = b""
    for piece in re.split(_SEPARATOR, text):
        if not piece:
            continue
        match = re.fullmatch(_PIECE, piece)
        if match is None:
            raise Unreadable(f"`{piece}` is no byte in hexadecimal digits")
        digits = match["digits"] or match["behind"]
        if len(digits) % 2 and len(digits) > 1:
            raise Unreadable(f"`{piece}` has an odd number of digits")
        data += bytes.fromhex(digits.zfill(2))
    if not data:
        raise Unreadable("there are no bytes in it")
    return data


def in_characters(text: str, links: Iterable[Link]) -> tuple[bytes, tuple[str, ...]] | None:
    """A frame that is written as its characters, with remarks on what the text lacks of its end.

    None where the text does not begin as the frames of one of the links that send characters.
    """
    text = unquoted(text).lstrip()
    for link in links:
        mark = link.start.decode("latin-1")
        if link.encoding == "hex_ascii" and mark.isprintable() and mark and text.startswith(mark):
            body, end = _ended(text)
            return _closed("".join(body.split()).encode("latin-1", "replace"), end.encode("latin-1"), link)
    return None


def _ended(text: str) -> tuple[str, str]:
    """The text without the control characters at its end, and these, which may be spelled."""
    end = ""
    while match := re.search(_LAST, text.rstrip(" \t")[-8:]):
        text = text.rstrip(" \t")
        text = text[: len(text) - len(match[0])]
        if match["code"]:
            end = chr(int(match["code"], 16)) + end
        else:
            end = (match["real"] or _CHARACTERS[match["name"].lower()]) + end
    return text, end


def _closed(body: bytes, end: bytes, link: Link) -> tuple[bytes, tuple[str, ...]]:
    """A frame with its whole end mark: what the text has of it, and what it lacks."""
    if end.endswith(link.end):
        return body + link.end, ()
    if not link.end.startswith(end):
        return body + end, ()
    lacking = link.end[len(end) :]
    named = " ".join(_CONTROLS.get(byte, f"{byte:02X}") for byte in lacking)
    return body + link.end, (f"the text lacks {named} at the end of the frame, which is taken as sent",)
