"""What to write instead of a text that is not a number: the same number as the language has it."""

from __future__ import annotations

import re

_WITH_H = re.compile(r"([0-9A-Fa-f]{1,16})[hH]")
_HEXADECIMAL = re.compile(r"(?:0X|[$#])?([0-9A-Fa-f]{1,16})")
_ZEROS = re.compile(r"[-+]?0+([1-9][0-9]*|0)")
_NUMBER = re.compile(r"[-+]?(0x[0-9A-Fa-f]{1,16}|[0-9]{1,20}(\.[0-9]{1,20})?)")
_WHOLE = re.compile(r"([-+]?[0-9]{1,20})\.0{1,20}")
_COMMA = re.compile(r"([-+]?[0-9]{1,20}),([0-9]{1,20})")
_NO_NUMBERS = ("nan", ".nan", "inf", ".inf", "null", "none", "true", "false", "yes", "no", "n/a")
"""Texts of other languages that are not characters of a frame."""
_MOST_CHARACTERS = 4


def number_help(text: str, quoted: bool, whole: bool) -> str:
    """`write it as `0x103``, or empty where nothing says which number is meant."""
    if quoted and _NUMBER.fullmatch(text) and not _ZEROS.fullmatch(text):
        return f"write it as `{text}`, without quotes"
    if (padded := _ZEROS.fullmatch(text)) is not None:
        if padded[1] == "0":
            return "numbers have no leading zeros: write it as `0`, without quotes"
        return (
            f"numbers have no leading zeros: write it as `{padded[1]}`, or as `0x{padded[1]}` where it is hexadecimal"
        )
    if (decimal := _COMMA.fullmatch(text)) is not None and not whole:
        return f"write it as `{decimal[1]}.{decimal[2]}`, with a point"
    if not whole:
        return ""
    if (integer := _WHOLE.fullmatch(text)) is not None:
        return f"write it as `{integer[1]}`"
    if (digits := _WITH_H.fullmatch(text)) is not None:
        return f"write it as `0x{digits[1].upper()}`"
    characters = _characters_help(text)
    digits = _HEXADECIMAL.fullmatch(text)
    if digits is None or text.isdecimal():
        return characters
    in_digits = f"write it as `0x{digits[1].upper()}`"
    if text[0] in "$#0123456789" or not characters:
        return in_digits
    return f"{in_digits} if these are hexadecimal digits; {characters}"


def _characters_help(text: str) -> str:
    if text.lower() in _NO_NUMBERS or re.fullmatch(r"[-+.,0-9]+", text):
        return ""
    if not 0 < len(text) <= _MOST_CHARACTERS or not text.isascii() or not text.isprintable() or text.isdecimal():
        return ""
    number = int.from_bytes(text.encode("ascii"), "big")
    subject = "the character is" if len(text) == 1 else "the characters are, the first one highest,"
    return f"{subject} the number `0x{number:02X}`: write that"
