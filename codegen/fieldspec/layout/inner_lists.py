"""Lists with other fields behind them, which other fields count: where everything is in some data.

Codecs work on the image of such a record: first all other fields, then the lists. Each list but the last one has room
there for as many elements as it may have, so that everything in the image has its place. The last list goes on to the
end of the image.
"""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.classes import TYPE_CHECKING, dataclass

if TYPE_CHECKING:
    from typing import Any, Literal


@dataclass(frozen=True, slots=True)
class InnerList:
    """The list `name` begins behind `first` bytes of other fields, not counting lists, and at `room` in the image.

    It has `least` to `most` bytes, `element` for each element. The field `count` is at `count_at` in the image and
    has `count_size` bytes in the order `count_order`; its number, less `plus`, is that of units of `unit` bytes.
    `count` is empty where the number is not needed, since the data end with the list and the fields behind it.
    """

    name: str
    first: int
    room: int
    element: int
    least: int
    most: int
    count: str = ""
    count_at: int = 0
    count_size: int = 0
    count_order: str = "big"
    unit: int = 1
    plus: int = 0

    def size_of(self, number: int) -> int | None:
        """The bytes of the list if its count is a number, None if it may not be that number."""
        size = (number - self.plus) * self.unit
        return None if size % self.element or not self.least <= size <= self.most else size

    def count_in(self, image: bytes) -> int:
        """The number of the field that counts the list, in an image that goes that far."""
        order: Literal["big", "little"] = "big" if self.count_order == "big" else "little"
        return int.from_bytes(image[self.count_at : self.count_at + self.count_size], order)


@dataclass(frozen=True, slots=True)
class ListFault:
    """Why some data have no image: the reason, and the byte at which it shows."""

    reason: str
    at: int


@dataclass(frozen=True, slots=True)
class InnerLists:
    """The lists of a record in the order of the wire; all other fields have `fixed` bytes."""

    lists: tuple[InnerList, ...]
    fixed: int

    @property
    def last(self) -> InnerList:
        """The list that comes last, whose size the data decide."""
        return self.lists[-1]

    def sizes_in(self, data: bytes) -> tuple[list[int], ListFault | None]:
        """The bytes of each list in some data; up to the first one for which they are not known, and why."""
        sizes: list[int] = []
        image = b""
        for inner in self.lists:
            at = inner.first + sum(sizes)
            left = len(data) - at - (self.fixed - inner.first)
            if left < 0:
                return sizes, ListFault("incomplete", len(data))
            image += data[len(image) + sum(sizes) : at]
            if inner is self.last:
                sizes.append(left)
                break
            size = inner.size_of(inner.count_in(image))
            if size is None:
                return sizes, ListFault("wrong_measure", self.place_in_data(sizes, inner.count_at))
            if size > left:
                return sizes, ListFault("incomplete", len(data))
            sizes.append(size)
        return sizes, None

    def image_of(self, data: bytes, sizes: Sequence[int]) -> bytes:
        """The image of data whose lists have some sizes; it has zeros for fields behind a list of unknown size."""
        lists, fields, at = b"", b"", 0
        for inner, size in zip(self.lists, sizes, strict=False):
            start = inner.first + at
            fields += data[len(fields) + at : start]
            piece = data[start : start + size]
            lists += piece if inner is self.last else piece.ljust(inner.most, b"\0")
            at += size
        stop = None if len(sizes) == len(self.lists) else self.lists[len(sizes)].first + at
        return (fields + data[len(fields) + at : stop]).ljust(self.fixed, b"\0") + lists

    def data_of(self, image: bytes) -> bytes:
        """What is sent of an image."""
        data, at = b"", 0
        for inner in self.lists:
            stop = None if inner is self.last else inner.room + self._size_in_image(inner, image)
            data += image[at : inner.first] + image[inner.room : stop]
            at = inner.first
        return data + image[at : self.fixed]

    @staticmethod
    def _size_in_image(inner: InnerList, image: bytes) -> int:
        size = inner.size_of(inner.count_in(image))
        assert size is not None
        return size

    def place_in_data(self, sizes: Sequence[int], at: int) -> int:
        """The byte in data, whose lists have some sizes, for a byte of their image."""
        before = 0
        for inner, size in zip(self.lists, [*sizes, *[0] * (len(self.lists) - len(sizes))], strict=True):
            if at >= inner.room and (inner is self.last or at < inner.room + inner.most):
                return inner.first + before + at - inner.room
            if at < self.fixed and at < inner.first:
                return at + before
            before += size
        return at + before


def inner_lists_data(inner: InnerLists) -> dict[str, Any]:
    """The lists as programs in JavaScript have them."""
    rows: list[dict[str, Any]] = []
    for row in inner.lists:
        bounds = {"element": row.element, "least": row.least, "most": row.most}
        count = {"at": row.count_at, "length": row.count_size if row.count else 0, "unit": row.unit}
        plus = {"plus": row.plus} if row.plus else {}
        is_little = {"little": True} if row.count_order == "little" else {}
        names = {"name": row.name} | ({"countName": row.count} if row.count else {})
        rows.append({**names, "first": row.first, "room": row.room, **bounds, **count, **plus, **is_little})
    return {"fixed": inner.fixed, "lists": rows}
