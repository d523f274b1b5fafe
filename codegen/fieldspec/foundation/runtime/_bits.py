"""Registers of single bits, such as coils. Messages pack their bits into bytes, or carry a single one as a number.

A bit is a word with 0 or 1 where a register counts words.
"""

from __future__ import annotations

from ._error import CodecError
from ._registers import Register, RegisterArray, spans
from ._typing import TYPE_CHECKING
from ._values import Value

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from ._typing import Data


class Bits(Value["list[bool]"]):
    """Several bits, each in a word of its own."""

    __slots__ = ("count",)

    def __init__(self, order: str, count: int) -> None:
        super().__init__(f"{order}{count}H")
        self.count = count

    def decode(self, name: str, data: Data) -> list[bool]:
        """The bits in exactly `size` bytes. Raises CodecError."""
        if len(data) != self.size:
            reason = "incomplete" if len(data) < self.size else "wrong_length"
            raise CodecError(reason, f"{name} has {self.size} bytes, not {len(data)}", min(len(data), self.size))
        return [word != 0 for word in self.struct.unpack(data)]

    def encode(self, name: str, value: list[bool]) -> bytes:
        """The bytes of all bits. Raises CodecError."""
        error = self.refused(name, value)
        if error is not None:
            raise error
        return self.struct.pack(*map(int, value))

    def refused(self, name: str, value: Any) -> CodecError | None:
        """Why bits cannot be encoded; None if the number is right, and each is true or false."""
        if not isinstance(value, (list, tuple)):
            return CodecError("wrong_type", f"{name} is a list of truth values, not {value!r}")
        if len(value) != self.count:
            return CodecError("wrong_length", f"{name} has {self.count} bits, not {len(value)}")
        for place, bit in enumerate(value):
            if bit not in (0, 1):
                return CodecError("wrong_type", f"{name}[{place}] is a truth value, not {bit!r}")
        return None


class BitArray(RegisterArray[bool]):
    """Neighbouring registers of one bit, by their numbers in the manual; `all` is one register with all bits."""

    __slots__ = ("all",)

    def __init__(
        self, name: str, address: int, words: int, value: Value[bool], access: str = "", *, count: int, **options: Any
    ) -> None:
        super().__init__(name, address, words, value, access, count=count, **options)
        single = self[self.first]
        self.all = Register(
            name,
            address,
            count,
            Bits(single.order, count),
            access,
            trigger=single.trigger,
            number=self.number,
            copy_of=self.copy_of,
            order=single.order,
            space=self.space,
        )


def packed_bits(bits: Sequence[int]) -> list[int]:
    """Bytes with bits, the first one in the least significant bit of the first byte."""
    number = sum(bit << place for place, bit in enumerate(bits))
    return list(number.to_bytes((len(bits) + 7) // 8, "little"))


def unpacked_bits(register: Register[Any], maximum: int, groups: Sequence[Sequence[int]]) -> list[int]:
    """The bits of a register from the bytes of responses with at most `maximum` bits each. Raises CodecError."""
    parts = spans(register, maximum)
    if len(groups) != len(parts):
        raise CodecError("wrong_length", f"{register.name} takes {len(parts)} responses, not {len(groups)}")
    bits: list[int] = []
    for (_, count), group in zip(parts, groups, strict=True):
        if len(group) != (count + 7) // 8:
            text = f"{count} bits of {register.name} take {(count + 7) // 8} bytes, not {len(group)}"
            raise CodecError("wrong_length", text)
        number = int.from_bytes(group, "little")
        bits += [number >> place & 1 for place in range(count)]
    return bits


def single_bit(name: str, number: int, set_number: int, clear_number: int) -> int:
    """The bit for which a number stands. Raises CodecError."""
    if number not in (set_number, clear_number):
        raise CodecError("unknown_value", f"{name} is {number}, neither {set_number} nor {clear_number}")
    return int(number == set_number)
