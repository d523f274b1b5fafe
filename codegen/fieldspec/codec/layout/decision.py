"""The number that decides the bytes of a field with several types."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.codec.layout.presence import masked
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass

if TYPE_CHECKING:
    from typing import Literal


@dataclass(frozen=True, slots=True)
class Decision:
    """The number that decides how many bytes an element has: the field `name`, `size` bytes at `offset` in the image.

    `sizes` are the bytes of the element by that number, or by its bits in a `mask`; another one decides nothing. A size
    below zero is that of a text of varying length, whose most bytes it is without the sign; another number counts them.
    """

    name: str
    offset: int
    size: int
    order: str
    sizes: Mapping[int, int]
    mask: int | None = None

    def size_in(self, image: bytes) -> int | None:
        """The bytes of the element, as an image that has the number says; None where it decides nothing."""
        order: Literal["big", "little"] = "big" if self.order == "big" else "little"
        return self.sizes.get(masked(int.from_bytes(image[self.offset : self.offset + self.size], order), self.mask))

    def sent_bytes(self, image: bytes, element: bytes) -> bytes:
        """The sent bytes of an element, as an image decides them."""
        size = self.size_in(image) or 0
        return element[:size] if size >= 0 else element[:-size].rstrip(b"\0")
