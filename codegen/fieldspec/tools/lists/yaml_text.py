"""Texts and numbers as YAML writes them within brackets."""

from __future__ import annotations

import json
import re
from fractions import Fraction

_BARE_SCALAR = re.compile(r"[A-Za-z][A-Za-z0-9_./-]*")
_OTHER_MEANING = ("true", "false", "yes", "no", "on", "off", "null", "y", "n")


def quoted(text: str) -> str:
    """A text, without quotes if it is a word."""
    if _BARE_SCALAR.fullmatch(text) and text.casefold() not in _OTHER_MEANING:
        return text
    escaped = (sign if sign.isprintable() or sign == " " else f"\\U{ord(sign):08X}" for sign in text)
    return '"' + "".join(json.dumps(sign)[1:-1] if sign in '"\\' else sign for sign in escaped) + '"'


def commented(text: str) -> str:
    """A text in a comment."""
    return "# " + "".join(sign if sign.isprintable() else "?" for sign in text)


def exact(number: Fraction) -> str:
    """An exact number: a decimal one where it has one, else a fraction."""
    rest = number.denominator
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    if rest != 1:
        return f"{number.numerator}/{number.denominator}"
    places = 0
    while (number * 10**places).denominator != 1:
        places += 1
    whole = abs(int(number * 10**places))
    digits = str(whole).rjust(places + 1, "0")
    sign = "-" if number < 0 else ""
    return sign + (f"{digits[:-places]}.{digits[-places:]}" if places else digits)
