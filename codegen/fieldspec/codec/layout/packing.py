"""Lists of whole numbers that follow each other in a number of bits, which need not be one of whole bytes."""

from __future__ import annotations

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.model.encoding import Whole, whole_bits, whole_number

if TYPE_CHECKING:
    from typing import Any, Literal

    from fieldspec.language.model.value import Value


@dataclass(frozen=True, slots=True)
class Packing:
    """How numbers are packed: the bits of each have the encoding `number`, and an image has `size` bytes for each.

    In the order `big`, the first number begins with the highest bit of the first byte; in the order `little`, with the
    lowest. The bits after the last number are 0.
    """

    number: Whole
    size: int
    order: Literal["big", "little"]

    def sent_size(self, numbers: int) -> int:
        """The bytes of some numbers."""
        return (numbers * self.number.bits + 7) // 8

    def numbers_in(self, size: int, limit: int) -> int:
        """How many numbers fit into `size` bytes, at most `limit`."""
        return min(8 * size // self.number.bits, limit)

    def place(self, index: int) -> tuple[int, int]:
        """The first byte with bits of a number, and the one after the last."""
        return index * self.number.bits // 8, self.sent_size(index + 1)

    def shared_bytes(self, index: int) -> int:
        """1 if the first byte with bits of a number has some of the number before it, too; else 0."""
        return int(index * self.number.bits % 8 != 0)

    def number_in(self, data: bytes, index: int) -> int:
        """A number, from the bytes with bits of it."""
        before = index * self.number.bits % 8
        shift = before if self.order == "little" else 8 * len(data) - before - self.number.bits
        return whole_number(self.number, int.from_bytes(data, self.order) >> shift & (1 << self.number.bits) - 1)

    def unpacked(self, data: bytes, numbers: int) -> bytes:
        """The image of some numbers."""
        places = [self.place(index) for index in range(numbers)]
        contents = [self.number_in(data[first:stop], index) for index, (first, stop) in enumerate(places)]
        return b"".join(content.to_bytes(self.size, self.order, signed=content < 0) for content in contents)

    def packed(self, image: bytes) -> bytes:
        """The bytes that are sent for an image."""
        numbers = len(image) // self.size
        size, bits = self.sent_size(numbers), 0
        for index in range(numbers):
            element = image[index * self.size : (index + 1) * self.size]
            content = int.from_bytes(element, self.order, signed=self.number.sign.is_signed)
            before = index * self.number.bits
            shift = before if self.order == "little" else 8 * size - before - self.number.bits
            bits |= whole_bits(self.number, content) << shift
        return bits.to_bytes(size, self.order)


def packing_of(value: Value | None, order: str) -> Packing | None:
    """How the numbers of a list are packed; None for other values."""
    if value is None or value.packed_number is None:
        return None
    return Packing(value.packed_number, value.size, "little" if order == "little" else "big")


def packing_data(packing: Packing) -> dict[str, Any]:
    """A packing as programs in JavaScript have it."""
    is_little = {"little": True} if packing.order == "little" else {}
    is_signed = {"signed": True} if packing.number.sign.is_signed else {}
    return {"bits": packing.number.bits, **is_little, **is_signed}
