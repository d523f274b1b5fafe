"""Numbers that are sent as digits: characters, or two decimal digits in each byte."""

from __future__ import annotations

from ._codecs import NUMBERS
from ._conversions import turned
from ._error import CodecError
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Container, Sequence

    from ._typing import Data

LETTERS = {
    "decimal": b"0123456789",
    "blank_decimal": b"0123456789",
    "bcd": b"0123456789",
    "packed_decimal": b"0123456789",
    "upper_hex": b"0123456789ABCDEF",
    "lower_hex": b"0123456789abcdef",
}


class Digits:
    """What reads and writes a number as digits.

    `letters` are the order of the bytes and the type of the number, the form of the digits, the number of bytes, and
    how many digits follow a point: `>i32 decimal 8 2` are a sign, four digits, a point and two digits. The form
    `blank_decimal` has blanks in place of leading zeros, and a sign below zero only, which takes the place of a digit.
    Any other form is the name of a codec.
    """

    __slots__ = (
        "codec",
        "count",
        "form",
        "has_nibbles",
        "has_sign",
        "high",
        "is_reversed",
        "letters",
        "low",
        "places",
        "signed",
        "size",
    )

    def __init__(self, letters: str) -> None:
        kind, self.form, size, places = letters.split()
        self.letters, self.size, self.places = letters, int(size), int(places)
        self.is_reversed, self.signed = kind[0] == "<", kind[1] == "i"
        self.has_sign = self.signed and self.form == "decimal"
        self.count = self.size - self.has_sign - (self.places > 0)
        self.has_nibbles = self.form in ("bcd", "packed_decimal")
        if self.has_nibbles:
            self.count = 2 * self.size - (self.form == "packed_decimal")
        self.codec = NUMBERS.get(self.form)
        if self.codec is not None:
            self.low, self.high = self.codec[:2]
            return
        bits = int(kind[2:])
        high = (16 if self.form.endswith("hex") else 10) ** self.count - 1
        if self.signed:
            self.high = min(high, (1 << (bits - 1)) - 1)
            self.low = -self.high if self.has_sign or self.form == "packed_decimal" else -self.high - 1
            if self.form in ("blank_decimal", "bcd"):
                self.low = 1 - 10 ** (self.count - 1) if self.count - 1 > self.places else 0
        else:
            self.low, self.high = 0, min(high, (1 << bits) - 1)

    def number(self, name: str, raw: bytes, offset: int, words_turned: bool = False) -> int:
        """The number in exactly its bytes, which are at byte `offset` of the whole. Raises CodecError."""
        (number,) = self.unpack(turned(raw) if words_turned else raw)
        if number is None:
            raise no_digits(name, raw, offset)
        return number

    def numbers(
        self,
        name: str,
        raws: Sequence[bytes],
        offset: int,
        words_turned: bool = False,
        accepted: Container[int] | None = None,
    ) -> list[int]:
        """The numbers of a list that begins at byte `offset` of the whole, up to the first that is not `accepted`.

        The caller refuses that one, which comes before bytes after it that are not digits. Raises CodecError.
        """
        numbers = []
        for index, raw in enumerate(raws):
            numbers.append(self.number(name, raw, offset + index * self.size, words_turned))
            if accepted is not None and numbers[-1] not in accepted:
                break
        return numbers

    def data(self, number: int, words_turned: bool = False) -> bytes:
        """The digits of a number. Raises OverflowError for one that has more of them."""
        data = self.pack(number)
        return turned(data) if words_turned else data

    def unpack(self, data: Data) -> tuple[int | None]:
        """The number in exactly its bytes, None for anything but its digits."""
        return (self._parsed(bytes(data)),)

    def pack(self, number: int) -> bytes:
        """The same, before the bytes of words are turned."""
        if not self.low <= number <= self.high:
            raise OverflowError
        if self.codec is not None:
            return self.codec[3](number)
        if self.has_nibbles:
            data = bytes.fromhex(self._nibbles(number))
            return data[::-1] if self.is_reversed else data
        if self.form.endswith("hex"):
            text = f"{number % 16**self.count:0{self.count}{'X' if self.form == 'upper_hex' else 'x'}}"
            return self._in_order(text.encode("ascii"))
        has_blanks = self.form == "blank_decimal"
        text = f"{abs(number):0{self.places + 1 if has_blanks else self.count}d}"
        if self.places:
            text = f"{text[: -self.places]}.{text[-self.places :]}"
        if has_blanks:
            return f"{'-' * (number < 0)}{text}".rjust(self.size).encode("ascii")
        if self.has_sign:
            text = ("-" if number < 0 else "+") + text
        return text.encode("ascii")

    def _parsed(self, raw: bytes) -> int | None:
        """The number of digits; None for anything else."""
        if self.codec is not None:
            read = self.codec[2](raw)
            return read if read is not None and self.low <= read <= self.high else None
        if self.has_nibbles:
            return self._of_nibbles((raw[::-1] if self.is_reversed else raw).hex())
        if self.form == "blank_decimal":
            return self._behind_blanks(raw)
        characters = raw[1:] if self.has_sign else raw
        if self.has_sign and raw[:1] not in (b"+", b"-"):
            return None
        if self.places:
            point = len(characters) - self.places - 1
            if characters[point : point + 1] != b".":
                return None
            characters = characters[:point] + characters[point + 1 :]
        if characters.strip(LETTERS[self.form]):
            return None
        if self.form == "decimal":
            return -int(characters) if raw[:1] == b"-" else int(characters)
        number = int(self._in_order(characters), 16)
        return number - 16**self.count if number > self.high else number

    def _in_order(self, characters: bytes) -> bytes:
        """Hexadecimal digits, possibly with the lowest byte first."""
        if not self.is_reversed:
            return characters
        return b"".join(characters[place : place + 2] for place in range(len(characters) - 2, -1, -2))

    def _nibbles(self, number: int) -> str:
        """The digits of a number, with a sign in the first or in the last nibble."""
        if self.form == "packed_decimal":
            return f"{abs(number):0{self.count}d}{('d' if number < 0 else 'c') if self.signed else 'f'}"
        return f"f{-number:0{self.count - 1}d}" if number < 0 else f"{number:0{self.count}d}"

    def _of_nibbles(self, nibbles: str) -> int | None:
        """The number of such digits; None for anything else."""
        digits, sign = nibbles, 1
        if self.form == "packed_decimal":
            digits, last = nibbles[:-1], nibbles[-1]
            if last not in ("cd" if self.signed else "f"):
                return None
            sign = -1 if last == "d" else 1
        elif self.signed and nibbles[0] == "f":
            digits, sign = nibbles[1:], -1
        return sign * int(digits) if digits.isdecimal() else None

    def _behind_blanks(self, raw: bytes) -> int | None:
        """The number of ` -1.25`, whose first digit is a zero only before the point; None for anything else."""
        text = raw.lstrip(b" ")
        is_negative = self.signed and text[:1] == b"-"
        fraction_size = self.places + 1 if self.places else 0
        whole = text[is_negative : max(len(text) - fraction_size, 0)]
        fraction = text[is_negative + len(whole) :]
        digits = whole + fraction[1:]
        if not whole or (whole[:1] == b"0" and len(whole) > 1) or fraction[:1] != b"."[: self.places]:
            return None
        if digits.strip(LETTERS[self.form]):
            return None
        return -int(digits) if is_negative else int(digits)


def no_digits(name: str, raw: bytes, offset: int) -> CodecError:
    """The error of bytes that are not the digits of a number."""
    return CodecError("unknown_value", f"{name} is {raw!r}, which are not the digits of a number", offset)


def size_in(data: bytes, order: str) -> int | None:
    """The number in a field with the size of another one: binary in an `order`, or digits of that form; None for other
    bytes.
    """
    if order in ("big", "little"):
        return int.from_bytes(data, "big" if order == "big" else "little")
    return digits(f">u64 {order} {len(data)} 0").unpack(data)[0]


def size_data(number: int, length: int, order: str) -> bytes:
    """The bytes of a field with such a number. Raises OverflowError for a number that it cannot have."""
    if order in ("big", "little"):
        return number.to_bytes(length, "big" if order == "big" else "little")
    return digits(f">u64 {order} {length} 0").pack(number)


_FORMS: dict[str, Digits] = {}


def digits(letters: str) -> Digits:
    """What reads and writes digits, made once for each form."""
    form = _FORMS.get(letters)
    if form is None:
        form = _FORMS[letters] = Digits(letters)
    return form
