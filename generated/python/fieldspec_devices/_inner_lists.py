"""Records with a list that has other fields behind it.

They are read and written as an image, in which the list comes last.
"""

from __future__ import annotations

from ._error import CodecError
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any


class InnerList:
    """A list that begins `first` bytes behind the start of a record, and that `behind` bytes follow."""

    __slots__ = ("behind", "first", "fixed")

    def __init__(self, first: int, behind: int) -> None:
        self.first, self.behind, self.fixed = first, behind, first + behind

    def decoded(self, function: Callable[[bytes], Any], data: bytes) -> Any:
        """What a function makes of the image of some data. Raises CodecError with the place in the data."""
        first, stop = self.first, len(data) - self.behind
        image = data if stop < first else data[:first] + data[stop:] + data[first:stop]
        try:
            return function(image)
        except CodecError as error:
            raise CodecError(error.reason, error.detail, self._place(len(data), error.offset)) from None

    def encoded(self, image: bytes) -> bytes:
        """What is sent of an image."""
        return image[: self.first] + image[self.fixed :] + image[self.first : self.fixed]

    def _place(self, size: int, at: int | None) -> int | None:
        """The byte in data of a size for a byte of their image."""
        if at is None or at < self.first or size < self.fixed:
            return at
        return at - self.behind if at >= self.fixed else at + size - self.fixed
