"""Elements of lists: the number that decides their size, their packing, and whether another one follows."""

from __future__ import annotations

from ._error import CodecError
from ._typing import TYPE_CHECKING
from ._values import MARK

if TYPE_CHECKING:
    from typing import Literal


class Decision:
    """The number that decides how many bytes an element has: the field `name`, `length` bytes at `offset` in the image.

    Only its bits in the `mask` decide. A size below zero is that of a text, whose most bytes it is without the sign;
    another number counts them. For `marked` numbers these are bytes, which have a mark after them in the image.
    """

    __slots__ = ("at", "length", "marked", "mask", "name", "order", "sizes")

    def __init__(
        self,
        name: str,
        offset: int,
        length: int,
        order: Literal["big", "little"],
        sizes: dict[int, int],
        mask: int = -1,
        marked: tuple[int, ...] = (),
    ) -> None:
        self.name, self.at, self.length, self.sizes, self.mask, self.marked = name, offset, length, sizes, mask, marked
        self.order: Literal["big", "little"] = order

    def number(self, fields: bytes) -> int:
        """The bits that decide."""
        return int.from_bytes(fields[self.at : self.at + self.length], self.order) & self.mask

    def size(self, fields: bytes, offset: int) -> int:
        """The bytes of the element, refused with the place of a number that decides nothing."""
        number = self.number(fields)
        size = self.sizes.get(number)
        if size is None:
            raise CodecError("unknown_value", f"{self.name} is {number}, which chooses nothing that may follow", offset)
        return size

    def has_text(self, fields: bytes) -> bool:
        """Whether the element is a text, whose bytes another number counts."""
        number = self.number(fields)
        return self.sizes[number] < 0 and number not in self.marked

    def mark(self, fields: bytes) -> bytes:
        """What follows the sent bytes of the element in the image, before zeros."""
        return MARK if self.number(fields) in self.marked else b""

    def sent(self, image: bytes, element: bytes) -> bytes:
        """The sent bytes of the element, as an image decides them."""
        size = self.size(image, 0)
        if self.number(image) in self.marked:
            return element[: element.rindex(MARK)]
        return element[:size] if size >= 0 else element.rstrip(b"\0")


class Packing:
    """Numbers of `bits` bits that follow each other, from the highest or in the order `little` from the lowest bit on;
    in the image each has `size` bytes.
    """

    __slots__ = ("bits", "order", "signed", "size")

    def __init__(self, bits: int, size: int, order: Literal["big", "little"], *, signed: bool = False) -> None:
        self.bits, self.size, self.signed = bits, size, signed
        self.order: Literal["big", "little"] = order

    def sent_size(self, numbers: int) -> int:
        """The bytes of some numbers."""
        return (numbers * self.bits + 7) // 8

    def unpacked(self, data: bytes, numbers: int) -> bytes:
        """The image of some numbers."""
        packed, half = int.from_bytes(data, self.order), 1 << self.bits - 1
        image = []
        for index in range(numbers):
            low = index * self.bits if self.order == "little" else 8 * len(data) - (index + 1) * self.bits
            number = packed >> low & 2 * half - 1
            number -= 2 * half if self.signed and number >= half else 0
            image.append(number.to_bytes(self.size, self.order, signed=number < 0))
        return b"".join(image)

    def packed(self, image: bytes) -> bytes:
        """The bytes that are sent for an image, which ends with zeros up to a whole byte."""
        numbers, packed = len(image) // self.size, 0
        size = self.sent_size(numbers)
        for index in range(numbers):
            number = int.from_bytes(image[index * self.size : (index + 1) * self.size], self.order)
            low = index * self.bits if self.order == "little" else 8 * size - (index + 1) * self.bits
            packed |= (number & (1 << self.bits) - 1) << low
        return packed.to_bytes(size, self.order)


class More:
    """Another element follows one whose number, `length` bytes at `offset` in it, has in `mask` one of some numbers."""

    __slots__ = ("at", "following", "length", "mask", "order")

    def __init__(
        self, offset: int, length: int, order: Literal["big", "little"], mask: int, following: tuple[int, ...] | range
    ) -> None:
        self.at, self.length, self.mask, self.following = offset, length, mask, following
        self.order: Literal["big", "little"] = order

    def follows(self, element: bytes) -> bool:
        """Whether another element follows this one."""
        number = int.from_bytes(element[self.at : self.at + self.length], self.order)
        return number & self.mask in self.following
