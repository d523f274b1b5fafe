"""Conversions between raw values and attributes that `struct` cannot do alone."""

from __future__ import annotations

from struct import Struct, pack, unpack
from struct import error as StructError

from ._error import CodecError, no_boolean, unknown_member, wrong_const
from ._typing import TYPE_CHECKING, R

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any, Literal, Protocol, TypeVar

    from typing_extensions import Self

    from ._typing import Data, Quantity

    class _Decodes(Protocol):
        @classmethod
        def decode(cls, data: Data) -> Self: ...

    Part = TypeVar("Part", bound=_Decodes)

new = object.__new__
UNFIT = (StructError, TypeError, AttributeError, OverflowError, ValueError, IndexError)
"""The exceptions of generated code for values that cannot be encoded; `CodecError` is a ValueError."""


UNREAD = (StructError, IndexError)
"""The exceptions of generated code for frames that it does not read: of another length, or with greater numbers."""


def packing(letters: str) -> tuple[Callable[..., bytes], Callable[[Data], tuple[Any, ...]]]:
    """`pack` and `unpack` of a Struct. Looking them up at each call would take a tenth of the time."""
    struct = Struct(letters)
    return struct.pack, struct.unpack


class Repeated(dict[int, Struct]):
    """The Structs of a record whose last field is repeated, by the number of elements."""

    __slots__ = ("element", "fixed")

    def __init__(self, fixed: str, element: str) -> None:
        self.fixed, self.element = fixed, element

    def __missing__(self, number: int) -> Struct:
        struct = self[number] = Struct(self.fixed + self.element * number)
        return struct


class Integer:
    """A Struct of a whole number that has no letter: `letters` are the order and the type, as in `>u24`.

    The highest bit of `sm16` alone says that a number is below zero.
    """

    __slots__ = ("has_magnitude", "high", "low", "order", "signed", "size")

    def __init__(self, letters: str) -> None:
        self.has_magnitude, self.signed = letters[1:3] == "sm", letters[1] == "i"
        bits = int(letters[3 if self.has_magnitude else 2 :])
        half = 1 << (bits - 1)
        self.order: Literal["big", "little"] = "big" if letters[0] == ">" else "little"
        self.size = bits // 8
        self.low, self.high = (-half, half - 1) if self.signed else (0, 2 * half - 1)
        if self.has_magnitude:
            self.low, self.high = 1 - half, half - 1

    def unpack(self, data: Data) -> tuple[int]:
        """The number in exactly its bytes."""
        if self.has_magnitude:
            return (magnitude_of(data, self.order),)
        return (int.from_bytes(data, self.order, signed=self.signed),)

    def pack(self, number: int) -> bytes:
        """The bytes of a number."""
        if self.has_magnitude:
            return magnitude_bytes(number, self.size, self.order)
        return number.to_bytes(self.size, self.order, signed=self.signed)


def number_struct(letters: str) -> Struct | Integer:
    """The Struct of one number: of its letter, or of its type where it has none."""
    return Integer(letters) if letters[-1].isdigit() else Struct(letters)


def float_of(raw: bytes, letters: str, words_turned: bool) -> float:
    """A floating-point number in a byte order that the Struct of its record cannot read."""
    number: float = unpack(letters, turned(raw) if words_turned else raw)[0]
    return number


def float_bytes(number: float, letters: str, words_turned: bool) -> bytes:
    """The bytes of a floating-point number in such a byte order."""
    data = pack(letters, number)
    return turned(data) if words_turned else data


def magnitude_of(data: Data, order: Literal["big", "little"]) -> int:
    """The whole number of some bytes, whose highest bit alone says that it is below zero."""
    bits, half = int.from_bytes(data, order), 1 << (8 * len(data) - 1)
    return bits if bits < half else half - bits


def magnitude_bytes(number: int, size: int, order: Literal["big", "little"]) -> bytes:
    """The bytes of such a number. Raises OverflowError for one that has more of them."""
    half = 1 << (8 * size - 1)
    if not -half < number < half:
        raise OverflowError
    return (half - number if number < 0 else number).to_bytes(size, order)


def carried_bits(carrier: str, own: object, size: int, raw: Any) -> Any:
    """The bits of a number below zero in a carrier of the same size, where either has a bit for the sign alone.

    `own` is the Struct of the value. Any other raw value is returned as it is.
    """
    if not carrier or not isinstance(raw, int) or raw >= 0:
        return raw
    half = 1 << (8 * size - 1)
    if carrier[1:3] == "sm":
        return half - raw
    return 2 * half + raw if isinstance(own, Integer) and own.has_magnitude else raw


def turned(data: bytes) -> bytes:
    """16-bit words with the two bytes of each exchanged."""
    mixed = bytearray(data)
    mixed[0::2], mixed[1::2] = data[1::2], data[0::2]
    return bytes(mixed)


def text(name: str, raw: bytes, offset: int) -> str:
    """The ASCII characters before the zeros that fill the field. Raises CodecError."""
    try:
        return raw.rstrip(b"\0").decode("ascii")
    except UnicodeDecodeError:
        raise CodecError("unknown_value", f"{name} holds bytes that are not ASCII", offset) from None


def texts(name: str, raws: Sequence[bytes], offset: int, size: int) -> list[str]:
    """The texts of a list, whose elements have `size` bytes each from byte `offset` on. Raises CodecError."""
    return [text(name, raw, offset + number * size) for number, raw in enumerate(raws)]


def members(name: str, raws: Sequence[int], table: dict[int, R], enum: str, offset: int, size: int) -> list[R]:
    """The members of a closed enum. Raises CodecError."""
    try:
        return [table[raw] for raw in raws]
    except KeyError:
        number = next(number for number, raw in enumerate(raws) if raw not in table)
        raise unknown_member(name, raws[number], enum, offset + number * size) from None


def booleans(name: str, raws: Sequence[int], offset: int, size: int) -> list[bool]:
    """Booleans. Raises CodecError for numbers above 1."""
    for number, raw in enumerate(raws):
        if raw > 1:
            raise no_boolean(name, raw, offset + number * size)
    return [raw == 1 for raw in raws]


def constants(name: str, raws: Sequence[int], const: int, offset: int, size: int) -> None:
    """Raises CodecError unless all elements are equal to a constant."""
    for number, raw in enumerate(raws):
        if raw != const:
            raise wrong_const(name, raw, const, offset + number * size)


def decoded_at(record: type[Part], data: Data, offset: int) -> Part:
    """The record at byte `offset` of another one. Raises CodecError with the offset in the whole."""
    try:
        return record.decode(data)
    except CodecError as error:
        raise error.shifted(offset) from None


def decoded_each(record: type[Part], raws: Sequence[bytes], offset: int, size: int) -> list[Part]:
    """Consecutive records of `size` bytes from byte `offset` on. Raises CodecError with the offset in the whole."""
    return [decoded_at(record, raw, offset + number * size) for number, raw in enumerate(raws)]


def counts(name: str, value: Quantity, ratio: tuple[int, int, int], ranges: tuple[tuple[int, int], ...]) -> int:
    """The count that is nearest to a value in the unit; of two equally near ones the even one.

    `ratio` is (a, b, c) of value = (count * a + b) / c. The computation is exact: the float
    0.015 is a little less than its digits say. Raises CodecError outside of `ranges`, and for what is not a number.
    """
    a, b, c = ratio
    try:
        numerator, under = value.as_integer_ratio()
    except (ValueError, OverflowError):
        raise CodecError("out_of_range", f"{name} is {value}") from None
    except AttributeError:
        raise CodecError("wrong_type", f"{name} is a number, not {value!r}") from None
    whole, rest = divmod(numerator * c - b * under, under * a)
    double = 2 * rest - under * a
    if a < 0:
        double = -double
    raw = whole + (double > 0 or (double == 0 and whole % 2 == 1))
    for low, high in ranges:
        if low <= raw <= high:
            return raw
    lows = sorted((low * a + b) / c for low, _ in ranges)
    highs = sorted((high * a + b) / c for _, high in ranges)
    raise CodecError("out_of_range", f"{name} is {value}, not in {min(lows + highs)}..{max(lows + highs)}")
