"""The number that decides the bytes of a field with several types."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.codec.layout.presence import masked
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass

if TYPE_CHECKING:
    from typing import Final, Literal

MARK: Final = b"\1"
"""What follows bytes of varying length in an image, so that zeros may be their last ones."""


@dataclass(frozen=True, slots=True)
class Decision:
    """The number that decides how many bytes an element has: the field `name`, `size` bytes at `offset` in the image.

    `sizes` are the bytes of the element by that number, or by its bits in a `mask`; another one decides nothing. A size
    below zero is that of a text of varying length, whose most bytes it is without the sign; another number counts them.
    For `marked` numbers these are bytes with any content, which the image has with a mark and zeros after them.
    """

    name: str
    offset: int
    size: int
    order: str
    sizes: Mapping[int, int]
    mask: int | None = None
    marked: frozenset[int] = frozenset()

    def number_in(self, image: bytes) -> int:
        """The number that decides, in an image that has it."""
        order: Literal["big", "little"] = "big" if self.order == "big" else "little"
        return masked(int.from_bytes(image[self.offset : self.offset + self.size], order), self.mask)

    def size_in(self, image: bytes) -> int | None:
        """The bytes of the element, as an image that has the number says; None where it decides nothing."""
        return self.sizes.get(self.number_in(image))

    def has_text(self, image: bytes) -> bool:
        """Whether the element is a text of varying length, as an image decides it."""
        return (self.size_in(image) or 0) < 0 and self.number_in(image) not in self.marked

    def image_of(self, image: bytes, data: bytes) -> bytes:
        """The sent bytes of an element as an image has them, which decides it, without zeros after them."""
        return data + MARK if self.number_in(image) in self.marked else data

    def sent_bytes(self, image: bytes, element: bytes) -> bytes:
        """The sent bytes of an element, as an image decides them."""
        size = self.size_in(image) or 0
        if self.number_in(image) in self.marked:
            return element[: element.rindex(MARK)]
        return element[:size] if size >= 0 else element.rstrip(b"\0")
