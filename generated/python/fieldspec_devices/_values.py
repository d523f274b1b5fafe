"""Single values in bytes: the codecs of registers and numbered parameters."""

from __future__ import annotations

from struct import Struct

from ._absent import absent_number, is_among, state_of
from ._conversions import Integer, counts, number_struct, text, turned
from ._digits import Digits, digits, no_digits
from ._error import CodecError, no_boolean, unknown_member, wrong_const
from ._flags import Flags
from ._refusals import (
    refused_bytes,
    refused_flags,
    refused_number,
    refused_text,
)
from ._typing import TYPE_CHECKING, Generic, T

if TYPE_CHECKING:
    from enum import IntEnum
    from typing import Any, TypeVar

    from ._refusals import BoundedBits
    from ._typing import Absent, Data, Quantity, Stated

    E = TypeVar("E", bound=IntEnum)
    F = TypeVar("F", bound=Flags)
else:
    E = F = None

_LIMITS = {
    "B": (0, 0xFF),
    "b": (-0x80, 0x7F),
    "H": (0, 0xFFFF),
    "h": (-0x8000, 0x7FFF),
    "I": (0, 0xFFFFFFFF),
    "i": (-0x80000000, 0x7FFFFFFF),
    "Q": (0, 0xFFFFFFFFFFFFFFFF),
    "q": (-0x8000000000000000, 0x7FFFFFFFFFFFFFFF),
}


class Value(Generic[T]):
    """A value of type T in `size` bytes: a Struct of `letters`, with the words turned before it is read.

    The letters of a number that no Struct has are the order and the type: `>u24`. Those of digits: see `Digits`.

    `ranges` are in counts. The scale, if there is one, is (a, b, c) of unit = (count * a + b) / c. `absent` are the
    states that counts stand for, each with its name, and `others` these counts: they may be outside the ranges, and are
    not a quantity. `stated` are the ranges for reading, and of bit fields, if they differ from the ranges for writing.
    """

    __slots__ = ("absent", "high", "low", "others", "ranges", "ratio", "size", "stated", "struct", "swapped", "unit")

    def __init__(
        self,
        letters: str,
        *,
        swapped: bool = False,
        ranges: tuple[tuple[int, int], ...] = (),
        unit: str = "",
        ratio: tuple[int, int, int] = (1, 0, 1),
        absent: Absent = (),
        stated: Stated | None = None,
    ) -> None:
        self.struct: Struct | Integer | Digits
        if " " in letters:
            self.struct = digits(letters)
        else:
            self.struct = number_struct(letters)
        self.swapped, self.size = swapped, self.struct.size
        if not isinstance(self.struct, Struct):
            self.low, self.high = self.struct.low, self.struct.high
        else:
            self.low, self.high = _LIMITS.get(letters[-1], (0, 0))
        self.ranges, self.unit, self.ratio = ranges, unit, ratio
        self.absent, self.others = absent, tuple([value for _, value in absent])
        self.stated: Stated = (ranges,) if stated is None else stated

    def decode(self, name: str, data: Data) -> T:
        """The value in exactly `size` bytes. Raises CodecError."""
        if len(data) != self.size:
            reason = "incomplete" if len(data) < self.size else "wrong_length"
            raise CodecError(reason, f"{name} has {self.size} bytes, not {len(data)}", min(len(data), self.size))
        raw = self.struct.unpack(turned(bytes(data)) if self.swapped else data)[0]
        if raw is None:
            raise no_digits(name, bytes(data), 0)
        return self.of_raw(name, raw)

    def encode(self, name: str, value: T) -> bytes:
        """The bytes of a value. Raises CodecError."""
        error = self.refused(name, value)
        if error is not None:
            raise error
        data = self.struct.pack(self.to_raw(value))
        return turned(data) if self.swapped else data

    def of_raw(self, name: str, raw: Any) -> T:
        """The value of a raw value from its Struct. Raises CodecError."""
        raise NotImplementedError

    def of_carried(self, name: str, raw: Any) -> T:
        """The value of a raw value in a message, which may be signed or unsigned. Raises CodecError."""
        if not isinstance(raw, int):
            raise CodecError("wrong_type", f"{name} is a whole number, not {raw!r}")
        span = self.high - self.low + 1
        has_magnitude = isinstance(self.struct, Integer) and self.struct.has_magnitude
        if has_magnitude and self.high < raw <= 2 * self.high + 1:
            raw = self.high + 1 - raw
        if not -span // 2 <= raw < span:
            raise CodecError("out_of_range", f"{name} is {raw}, not in {self.low}..{self.high}")
        if has_magnitude:
            return self.of_raw(name, raw)
        moved = raw % span
        return self.of_raw(name, moved - span if moved > self.high else moved)

    def to_raw(self, value: Any) -> Any:
        """The raw value for its Struct, of a value that `refused` accepts."""
        return value

    def in_unit(self, count: float, ratio: tuple[int, int, int] | None = None) -> float | None:
        """A count in the unit, by a different scale if it is stated; None where it is an absent value."""
        if is_among(count, self.others):
            return None
        a, b, c = ratio or self.ratio
        return (count * a + b) / c

    def from_unit(self, name: str, value: Quantity | None, ratio: tuple[int, int, int] | None = None) -> Any:
        """The count that is nearest to a value in the unit, of two the even one; `ratio` as in `in_unit`.

        None becomes the only absent value. Raises CodecError out of range, where that count stands for an absent value,
        and for None where several do, which it names.
        """
        if value is None:
            return absent_number(name, self.absent)
        count = counts(name, value, ratio or self.ratio, self.ranges or ((self.low, self.high),))
        if is_among(count, self.others):
            raise CodecError(
                "out_of_range", f"{name} is {value}, whose count {count} stands for {state_of(count, self.absent)}"
            )
        return count

    def state_of(self, value: T | float) -> str | None:
        """The name of the state that a value stands for, or `out_of_range`; None for any other value."""
        return state_of(value, self.absent, *self.stated)

    def refused(self, name: str, value: Any) -> CodecError | None:
        """Why a value cannot be encoded; None for one that can."""
        raise NotImplementedError


class Number(Value[int]):
    """A count."""

    __slots__ = ()

    def of_raw(self, name: str, raw: int) -> int:
        if not self.low <= raw <= self.high:
            raise CodecError("unknown_value", f"{name} is {raw}, not in {self.low}..{self.high}", 0)
        return raw

    def refused(self, name: str, value: Any) -> CodecError | None:
        return refused_number(name, value, self.low, self.high, self.ranges, self.others)


class Constant(Number):
    """A count that is always the same."""

    __slots__ = ("const",)

    def __init__(self, letters: str, const: int, *, swapped: bool = False, stated: Stated | None = None) -> None:
        super().__init__(letters, swapped=swapped, stated=stated)
        self.const = const

    def of_raw(self, name: str, raw: int) -> int:
        if raw != self.const:
            raise wrong_const(name, raw, self.const, 0)
        return raw

    def refused(self, name: str, value: Any) -> CodecError | None:
        if value != self.const:
            return CodecError("wrong_const", f"{name} is {value}, not {self.const}")
        return None


class Setting(Constant):
    """A count with only one value to write; the device may answer any."""

    __slots__ = ()

    def __init__(self, letters: str, const: int, *, swapped: bool = False, stated: Stated = ()) -> None:
        super().__init__(letters, const, swapped=swapped, stated=stated)

    of_raw = Number.of_raw


class Closed(Value[E]):
    """A member of a closed enum."""

    __slots__ = ("enum", "members")

    def __init__(self, letters: str, enum: str, members: dict[int, E], **common: Any) -> None:
        super().__init__(letters, **common)
        self.enum, self.members = enum, members

    def of_raw(self, name: str, raw: int) -> E:
        member = self.members.get(raw)
        if member is None:
            raise unknown_member(name, raw, self.enum, 0)
        return member

    def refused(self, name: str, value: Any) -> CodecError | None:
        return refused_number(name, value, self.low, self.high, self.ranges, (), self.members, self.enum)


class Open(Value["E | int"], Generic[E]):
    """A member of an enum, or a count: any one, or, where the enum is closed, one of `others`."""

    __slots__ = ("closed", "enum", "members")

    def __init__(self, letters: str, enum: str, members: dict[int, E], *, closed: bool = False, **common: Any) -> None:
        super().__init__(letters, **common)
        self.enum, self.members, self.closed = enum, members, closed

    def of_raw(self, name: str, raw: int) -> E | int:
        member = self.members.get(raw)
        if member is not None:
            return member
        if self.closed and not is_among(raw, self.others):
            raise unknown_member(name, raw, self.enum, 0)
        return raw

    def refused(self, name: str, value: Any) -> CodecError | None:
        members = self.members if self.closed else None
        return refused_number(name, value, self.low, self.high, self.ranges, self.others, members, self.enum)


class Trigger(Open[E]):
    """A member of a closed enum that starts an action when it is written; the device may answer any count."""

    __slots__ = ()

    def __init__(self, letters: str, enum: str, members: dict[int, E], **common: Any) -> None:
        super().__init__(letters, enum, members, closed=True, stated=(), **common)

    def of_raw(self, name: str, raw: int) -> E | int:
        return self.members.get(raw, raw)


class Word(Value[F]):
    """A word of flags. `bits` are those with a range: name, mask, what may be in the mask, and a text of the range."""

    __slots__ = ("bits", "flags")

    def __init__(
        self,
        letters: str,
        flags: type[F],
        *,
        ranges: tuple[tuple[int, int], ...] = (),
        bits: tuple[BoundedBits, ...] = (),
        stated: Stated | None = None,
        **common: Any,
    ) -> None:
        super().__init__(letters, ranges=ranges, stated=(ranges, bits) if stated is None else stated, **common)
        self.flags, self.bits = flags, bits

    def of_raw(self, name: str, raw: int) -> F:
        return self.flags(raw)

    def to_raw(self, value: F) -> int:
        return value.raw

    def refused(self, name: str, value: Any) -> CodecError | None:
        return refused_flags(name, value, self.high, self.ranges, self.bits)


class Boolean(Value[bool]):
    """0 for false, 1 for true."""

    __slots__ = ()

    def of_raw(self, name: str, raw: int) -> bool:
        if raw > 1:
            raise no_boolean(name, raw, 0)
        return raw == 1

    def refused(self, name: str, value: Any) -> CodecError | None:
        return refused_number(name, value, 0, 1)


class _Sequence(Value[T]):
    """Characters or bytes. `length` is how many there may be."""

    __slots__ = ("length",)

    def __init__(self, letters: str, length: int) -> None:
        super().__init__(letters)
        self.length = length

    def of_carried(self, name: str, raw: Any) -> T:
        """The value of the bytes that a message carries. Raises CodecError."""
        return self.decode(name, raw)


MARK = b"\1"
"""What follows bytes of varying length in an image, so that zeros may be their last ones."""


class Text(_Sequence[str]):
    """ASCII characters, filled up with zeros. `length` is how many there may be."""

    __slots__ = ()

    def of_raw(self, name: str, raw: bytes) -> str:
        return text(name, raw, 0)

    def to_raw(self, value: str) -> bytes:
        return value.encode("ascii")

    def refused(self, name: str, value: Any) -> CodecError | None:
        return refused_text(name, value, self.length)


class Bytes(_Sequence[bytes]):
    """Bytes as they are. `length` is how many there are."""

    __slots__ = ()

    def of_raw(self, name: str, raw: bytes) -> bytes:
        return raw

    def refused(self, name: str, value: Any) -> CodecError | None:
        return refused_bytes(name, value, self.length)


class MarkedBytes(Bytes):
    """Up to `length` bytes, in an image with a mark and zeros after them."""

    __slots__ = ()

    def of_raw(self, name: str, raw: bytes) -> bytes:
        return raw[: raw.rindex(MARK)]

    def to_raw(self, value: bytes) -> bytes:
        return bytes(value) + MARK

    def refused(self, name: str, value: Any) -> CodecError | None:
        return refused_bytes(name, value, self.length, minimum=0)
