"""Numbers that are sent as digits, as the reference codec has them: each form is one regular expression."""

from __future__ import annotations

import re

from fieldspec.language.model.encoding import is_signed
from fieldspec.language.model.value import Value

_DIGIT = {"upper_hex": "[0-9A-F]", "lower_hex": "[0-9a-f]"}


def number_of_digits(value: Value, data: bytes) -> int | None:
    """The number of digits, the most significant first; None for any other bytes."""
    if value.digits == "bcd":
        nibbles = [nibble for byte in data for nibble in (byte >> 4, byte & 15)]
        return None if max(nibbles) > 9 else int("".join(map(str, nibbles)))
    text = data.decode("latin-1")
    if len(text) != value.size or re.fullmatch(_pattern(value), text) is None:
        return None
    if value.digits != "decimal":
        number, turn = int(text, 16), 16**value.size
        return number - turn if is_signed(value.encoding) and number >= turn // 2 else number
    return int(text.replace(".", ""))


def digits_of_number(value: Value, number: int) -> bytes:
    """The digits of a number that fits them, the most significant first."""
    if value.digits == "bcd":
        return bytes.fromhex(str(number).zfill(2 * value.size))
    if value.digits != "decimal":
        text = format(number % 16**value.size, "x").zfill(value.size)
        return (text.upper() if value.digits == "upper_hex" else text).encode()
    sign = "-" if number < 0 else "+" if _has_sign(value) else ""
    digits = str(abs(number)).zfill(value.places + 1)
    fraction_digits = f".{digits[len(digits) - value.places :]}" if value.places else ""
    before = digits[: len(digits) - value.places]
    if value.has_blanks:
        return (sign + before + fraction_digits).rjust(value.size).encode()
    return (sign + before.zfill(value.size - len(sign) - len(fraction_digits)) + fraction_digits).encode()


def _has_sign(value: Value) -> bool:
    return is_signed(value.encoding) and not value.has_blanks


def _pattern(value: Value) -> str:
    if value.digits != "decimal":
        return f"{_DIGIT[value.digits]}*"
    fraction_digits = rf"\.[0-9]{{{value.places}}}" if value.places else ""
    if value.has_blanks:
        return f" *{'-?' if is_signed(value.encoding) else ''}(0|[1-9][0-9]*){fraction_digits}"
    return f"{'[+-]' if is_signed(value.encoding) else ''}[0-9]+{fraction_digits}"
