"""Checksums of any width, by their parameters. A checksum is a function from bytes to a number."""

from __future__ import annotations

from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Literal

    from ._typing import Data


class Crc:
    """A CRC: its width in bits, its polynomial without the highest bit, and the other parameters of its algorithm.

    The register has the lowest bit first where bytes are reflected; else it has 64 bits, of which the highest are used.
    """

    __slots__ = ("final_xor", "reflect_in", "reflect_out", "register", "table", "width")

    def __init__(
        self, width: int, polynomial: int, initial: int, reflect_in: bool, reflect_out: bool, final_xor: int
    ) -> None:
        self.width, self.reflect_in, self.reflect_out, self.final_xor = width, reflect_in, reflect_out, final_xor
        self.register = reflected(initial, width) if reflect_in else initial << 64 - width
        self.table = _reflected_table(reflected(polynomial, width)) if reflect_in else _table(polynomial << 64 - width)

    def __call__(self, data: Data) -> int:
        """The CRC of some bytes."""
        crc, table = self.register, self.table
        if self.reflect_in:
            for byte in data:
                crc = crc >> 8 ^ table[(crc ^ byte) & 0xFF]
        else:
            for byte in data:
                crc = (crc << 8 & 0xFFFFFFFFFFFFFFFF) ^ table[crc >> 56 ^ byte]
            crc >>= 64 - self.width
        return (reflected(crc, self.width) if self.reflect_in != self.reflect_out else crc) ^ self.final_xor


def reflected(number: int, width: int) -> int:
    """A number of `width` bits with its bits in the opposite order."""
    return int(f"{number:0{width}b}"[::-1], 2)


def _reflected_table(term: int) -> list[int]:
    table = []
    for byte in range(256):
        for _ in range(8):
            byte = byte >> 1 ^ (term if byte & 1 else 0)
        table.append(byte)
    return table


def _table(term: int) -> list[int]:
    table = []
    for byte in range(256):
        register = byte << 56
        for _ in range(8):
            register = (register << 1 & 0xFFFFFFFFFFFFFFFF) ^ (term if register >> 63 else 0)
        table.append(register)
    return table


class Sum:
    """The sum of numbers of `unit` bytes; zeros are after the last one where its bytes are missing.

    `complement` is `ones`, `twos` or empty.
    """

    __slots__ = ("complement", "initial", "mask", "order", "unit")

    def __init__(self, width: int, initial: int, complement: str, unit: int, order: Literal["big", "little"]) -> None:
        self.mask, self.initial, self.complement = (1 << width) - 1, initial, complement
        self.unit = unit
        self.order: Literal["big", "little"] = order

    def __call__(self, data: Data) -> int:
        """The sum of some bytes."""
        number = self._total(data)
        if self.complement:
            number = ~number if self.complement == "ones" else -number
        return number & self.mask

    def _total(self, data: Data) -> int:
        return self.initial + (sum(data) if self.unit == 1 else sum(_numbers(data, self.unit, self.order)))


class Xor(Sum):
    """The same for numbers that are combined by exclusive or."""

    __slots__ = ()

    def _total(self, data: Data) -> int:
        total = self.initial
        for number in data if self.unit == 1 else _numbers(data, self.unit, self.order):
            total ^= number
        return total


class Fletcher:
    """A Fletcher checksum of numbers of `unit` bytes; zeros are after the last one where its bytes are missing.

    It has two sums modulo `modulus`: that of the numbers and, in the upper half of the bits, that of all values of the
    first one.
    """

    __slots__ = ("half", "initial", "modulus", "order", "unit")

    def __init__(self, width: int, initial: int, modulus: int, unit: int, order: Literal["big", "little"]) -> None:
        self.half, self.initial, self.modulus, self.unit = width // 2, initial, modulus, unit
        self.order: Literal["big", "little"] = order

    def __call__(self, data: Data) -> int:
        """The Fletcher checksum of some bytes."""
        upper, lower = divmod(self.initial, 1 << self.half)
        for number in data if self.unit == 1 else _numbers(data, self.unit, self.order):
            lower += number
            upper += lower
        return upper % self.modulus << self.half | lower % self.modulus


class Followed:
    """A checksum of some bytes and of more bytes after them."""

    __slots__ = ("function", "suffix")

    def __init__(self, function: Callable[[Data], int], suffix: bytes) -> None:
        self.function, self.suffix = function, suffix

    def __call__(self, data: Data) -> int:
        """The checksum of some bytes and of the suffix."""
        return self.function(bytes(data) + self.suffix)


class Swapped:
    """A checksum of numbers of `unit` bytes that takes the last byte of each first; zeros are after the last one."""

    __slots__ = ("function", "unit")

    def __init__(self, function: Callable[[Data], int], unit: int) -> None:
        self.function, self.unit = function, unit

    def __call__(self, data: Data) -> int:
        """The checksum of some bytes."""
        filled = bytes(data) + bytes(-len(data) % self.unit)
        swapped = bytearray(len(filled))
        for place in range(self.unit):
            swapped[place :: self.unit] = filled[self.unit - 1 - place :: self.unit]
        return self.function(swapped)


class Avoiding:
    """A checksum of `size` bytes in which other bytes take the place of those that must not occur."""

    __slots__ = ("function", "size", "table")

    def __init__(self, function: Callable[[Data], int], size: int, pairs: dict[int, int]) -> None:
        self.function, self.size = function, size
        self.table = bytes(pairs.get(byte, byte) for byte in range(256))

    def __call__(self, data: Data) -> int:
        """The checksum of some bytes as it is sent."""
        return int.from_bytes(self.function(data).to_bytes(self.size, "big").translate(self.table), "big")


def _numbers(data: Data, unit: int, order: Literal["big", "little"]) -> list[int]:
    filled = bytes(data) + bytes(-len(data) % unit)
    return [int.from_bytes(filled[offset : offset + unit], order) for offset in range(0, len(filled), unit)]
