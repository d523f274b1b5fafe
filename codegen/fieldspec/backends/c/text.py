"""Literals and comments of C. Text from a spec gets into an output through these functions only."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache

_ESCAPES = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\r": "\\r", "\t": "\\t", "?": "\\?"}
_ESCAPED = re.compile(r'[^ -~]|[\\"?]')
_MARKS = re.compile(r"[*/?<\\@]")
_TAG = re.compile(r"<(?=[A-Za-z/!])")
_WIDTH = 108
_KEPT = 1 << 14
"""How many texts are remembered as they were written: versions share most of theirs."""
_LONGEST = 120

# What may be folded, and the pieces of it, which end behind a comma or an operator, the weaker one if there are two.
_FOLDED = re.compile(r"\s*(static inline|if \(|\} else if \()")
_PIECES = re.compile(r".+?(?: \|\| |$)"), re.compile(r".+?(?:, | && |$)")


@lru_cache(maxsize=_KEPT)
def string(text: str) -> str:
    """A string literal in UTF-8. Octal escapes have three digits, so that no digit behind them joins in."""
    return f'"{_ESCAPED.sub(_escape, text)}"'


def _escape(found: re.Match[str]) -> str:
    char = found[0]
    return _ESCAPES.get(char) or "".join(f"\\{byte:03o}" for byte in char.encode("utf-8", "replace"))


def comment(*texts: str) -> list[str]:
    """A comment for documentation tools, one paragraph a text; empty texts are left out."""
    lines = [line for text in texts if text for line in wrapped(text)]
    if not lines:
        return []
    if len(lines) == 1:
        return [f"/** {lines[0]} */"]
    return ["/**", *(f" * {line}".rstrip() for line in lines), " */"]


def plain(text: str) -> str:
    """A text that ends no comment and starts none, on one line, without trigraphs, joined lines or marks of HTML."""
    if not text.isprintable():
        text = "".join(char if char.isprintable() else " " for char in text)
    if _MARKS.search(text):
        text = text.replace("*/", "* /").replace("/*", "/ *").replace("//", "/ /").replace("??", "? ?")
        text = _TAG.sub("< ", text).replace("\\", "\\ ").replace("@", "(at)")
    return " ".join(text.split())


@lru_cache(maxsize=_KEPT)
def wrapped(text: str) -> tuple[str, ...]:
    """A text in lines of a comment."""
    text = plain(text)
    lines = []
    while len(text) > _WIDTH:
        end = text.rfind(" ", 0, _WIDTH + 1)
        end = end if end > 0 else text.find(" ")
        if end < 0:
            break
        lines.append(text[:end])
        text = text[end + 1 :]
    return (*lines, text)


def integer(value: int, size: int = 4, signed: bool = True) -> str:
    """A constant of a width in bytes that every compiler takes, the least values of signed types included."""
    if not signed:
        return f"UINT64_C({value})" if size > 4 else f"{value}u"
    if value == -(1 << 63):
        return "(-INT64_C(9223372036854775807) - 1)"
    if value == -(1 << 31):
        return "(-2147483647 - 1)"
    if size > 4:
        return f"(-INT64_C({-value}))" if value < 0 else f"INT64_C({value})"
    return f"({value})" if value < 0 else str(value)


def hexadecimal(value: int, size: int) -> str:
    """An unsigned constant in hexadecimal, as wide as its type."""
    digits = f"0x{value:0{2 * size}X}"
    return f"UINT64_C({digits})" if size > 4 else f"{digits}u"


def array(data: bytes) -> str:
    """The bytes of an array's initializer."""
    return ", ".join(f"0x{byte:02X}" for byte in data)


def folded(lines: Iterable[str]) -> list[str]:
    """Lines of code, of which heads of functions and conditions that are too long go on in further lines."""
    return [part for line in lines for part in _folded(line)]


def _folded(line: str) -> list[str]:
    if len(line) <= _LONGEST or not _FOLDED.match(line):
        return [line]
    indent = " " * (len(line) - len(line.lstrip()))
    parts = [indent]
    for piece in _PIECES[" || " not in line].findall(line.lstrip()):
        if len(parts[-1]) + len(piece.rstrip()) > _LONGEST and parts[-1].strip():
            parts.append(f"{indent}        ")
        parts[-1] += piece
    return [part.rstrip() for part in parts]


def indented(lines: Iterable[str], depth: int = 1) -> list[str]:
    """Lines further to the right."""
    return [("    " * depth + line) if line else "" for line in lines]
