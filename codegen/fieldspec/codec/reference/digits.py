"""Numbers that are sent as digits, as the reference codec has them: each form is one regular expression."""

from __future__ import annotations

import re

from fieldspec.language.model import codecs
from fieldspec.language.model.encoding import is_signed
from fieldspec.language.model.value import Value

_DIGIT = {"upper_hex": "[0-9A-F]", "lower_hex": "[0-9a-f]"}


def number_of_digits(value: Value, data: bytes) -> int | None:
    """The number of digits, the most significant first; None for any other bytes."""
    if value.codec:
        return codecs.decoded(value.codec, data)
    if value.digits in ("bcd", "packed_decimal"):
        return _number_of_nibbles(value, [nibble for byte in data for nibble in (byte >> 4, byte & 15)])
    text = _turned(value, data.decode("latin-1"))
    if len(text) != value.size or re.fullmatch(_pattern(value), text) is None:
        return None
    if value.digits != "decimal":
        number, turn = int(text, 16), 16**value.size
        return number - turn if is_signed(value.encoding) and number >= turn // 2 else number
    return int(text.replace(".", ""))


def digits_of_number(value: Value, number: int) -> bytes:
    """The digits of a number that fits them, the most significant first."""
    if value.codec:
        return codecs.encoded(value.codec, number)
    if value.digits == "bcd":
        return bytes.fromhex(
            str(number).replace("-", "f" + "0" * (2 * value.size - len(str(number)))).zfill(2 * value.size)
        )
    if value.digits == "packed_decimal":
        last = ("d" if number < 0 else "c") if is_signed(value.encoding) else "f"
        return bytes.fromhex(str(abs(number)).zfill(2 * value.size - 1) + last)
    if value.digits != "decimal":
        text = format(number % 16**value.size, "x").zfill(value.size)
        return _turned(value, text.upper() if value.digits == "upper_hex" else text).encode()
    sign = "-" if number < 0 else "+" if _has_sign(value) else ""
    digits = str(abs(number)).zfill(value.places + 1)
    fraction_digits = f".{digits[len(digits) - value.places :]}" if value.places else ""
    before = digits[: len(digits) - value.places]
    if value.has_blanks:
        return (sign + before + fraction_digits).rjust(value.size).encode()
    return (sign + before.zfill(value.size - len(sign) - len(fraction_digits)) + fraction_digits).encode()


def _number_of_nibbles(value: Value, nibbles: list[int]) -> int | None:
    """The number of nibbles, of which the first or the last one may be a sign."""
    sign = 1
    if value.digits == "packed_decimal":
        last = nibbles.pop()
        if last not in ((0xC, 0xD) if is_signed(value.encoding) else (0xF,)):
            return None
        sign = -1 if last == 0xD else 1
    elif nibbles[0] == 0xF and is_signed(value.encoding):
        sign, nibbles[0] = -1, 0
    if max(nibbles, default=0) > 9:
        return None
    return sign * int("".join(map(str, nibbles)) or "0")


def _turned(value: Value, text: str) -> str:
    """Hexadecimal digits with the pairs of the bytes in the order of the wire, or back."""
    if not value.is_low_first:
        return text
    return "".join(reversed([text[place : place + 2] for place in range(0, len(text), 2)]))


def _has_sign(value: Value) -> bool:
    return is_signed(value.encoding) and not value.has_blanks


def _pattern(value: Value) -> str:
    if value.digits != "decimal":
        return f"{_DIGIT[value.digits]}*"
    fraction_digits = rf"\.[0-9]{{{value.places}}}" if value.places else ""
    if value.has_blanks:
        return f" *{'-?' if is_signed(value.encoding) else ''}(0|[1-9][0-9]*){fraction_digits}"
    return f"{'[+-]' if is_signed(value.encoding) else ''}[0-9]+{fraction_digits}"
