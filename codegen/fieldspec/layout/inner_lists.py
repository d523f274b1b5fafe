"""Lists with other fields behind them, which another field counts: where everything is in some data.

Codecs work on the image of such a record, in which the list comes last, as it does in records where it goes on to the
end of the data.
"""

from __future__ import annotations

from fieldspec.classes import dataclass


@dataclass(frozen=True, slots=True)
class InnerList:
    """The list `name` begins `first` bytes behind the start of a record, and `behind` bytes follow it."""

    name: str
    first: int
    behind: int

    @property
    def fixed(self) -> int:
        """The bytes of all other fields. Data with fewer bytes are their own image."""
        return self.first + self.behind

    def image_of(self, data: bytes) -> bytes:
        """The image of some data."""
        stop = len(data) - self.behind
        return data if stop < self.first else data[: self.first] + data[stop:] + data[self.first : stop]

    def data_of(self, image: bytes) -> bytes:
        """What is sent of an image."""
        return image[: self.first] + image[self.fixed :] + image[self.first : self.fixed]

    def place_in_data(self, size: int, at: int) -> int:
        """The byte in data of a size for a byte of their image."""
        if at < self.first or size < self.fixed:
            return at
        return at - self.behind if at >= self.fixed else at + size - self.fixed
