"""Records with lists that have other fields behind them.

They are read and written as an image: first all other fields, then the lists.
"""

from __future__ import annotations

from struct import Struct

from ._error import CodecError
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any, Literal


class InnerList:
    """A list behind `first` bytes of other fields; in refusals of the image, its place is `room`.

    It has `least` to `most` elements of `size` bytes, which the Struct has as `letters`. The field that counts them is
    at `at` in the image, with `length` bytes in an order; its number, less `plus`, is that of units of `unit` bytes.
    `length` is 0 for the list whose size the data decide.
    """

    __slots__ = ("at", "first", "length", "letters", "order", "plus", "room", "size", "sizes", "unit")

    def __init__(
        self,
        letters: str,
        size: int,
        bounds: tuple[int, int],
        first: int,
        room: int,
        count: tuple[int, int, Literal["big", "little"], int, int] = (0, 0, "big", 1, 0),
    ) -> None:
        self.letters, self.size, self.first, self.room = letters, size, first, room
        self.sizes = range(bounds[0] * size, bounds[1] * size + 1, size)
        self.at, self.length, self.order, self.unit, self.plus = count


class InnerLists(dict[tuple[int, ...], Struct]):
    """The lists of a record, and its Structs by the numbers of their elements: first the other fields, then the lists.

    `fixed` are the letters of the other fields with the order of their bytes.
    """

    __slots__ = ("fixed", "letters", "lists", "name")

    def __init__(self, name: str, fixed: str, *lists: InnerList) -> None:
        self.name, self.letters, self.lists = name, fixed, lists
        self.fixed = Struct(fixed).size

    def __missing__(self, numbers: tuple[int, ...]) -> Struct:
        pairs = zip(self.lists, numbers, strict=True)
        struct = self[numbers] = Struct(self.letters + "".join(inner.letters * number for inner, number in pairs))
        return struct

    def decoded(self, function: Callable[[bytes, tuple[int, ...]], Any], data: bytes) -> Any:
        """What a function makes of the image of some data, and of the numbers of elements.

        Raises CodecError with the place in the data.
        """
        fields, lists = b"", b""
        sizes: list[int] = []
        for inner in self.lists:
            at = inner.first + len(lists)
            fields += data[len(fields) + len(lists) : at]
            left = len(data) - at - self.fixed + inner.first
            if left < 0:
                raise self._incomplete(inner, data)
            size = self._size_of_count(inner, fields, sizes) if inner.length else self._checked(inner, left, at)
            if size > left:
                raise self._incomplete(inner, data)
            lists += data[at : at + size]
            sizes.append(size)
        image = fields + data[len(fields) + len(lists) :] + lists
        try:
            return function(image, tuple([size // inner.size for inner, size in zip(self.lists, sizes, strict=True)]))
        except CodecError as error:
            raise CodecError(error.reason, error.detail, self._place(sizes, error.offset)) from None

    def encoded(self, image: bytes) -> bytes:
        """What is sent of an image."""
        data, at, start = b"", 0, self.fixed
        for inner in self.lists:
            size = self._number(inner, image) if inner.length else len(image) - start
            data += image[at : inner.first] + image[start : start + size]
            at, start = inner.first, start + size
        return data + image[at : self.fixed]

    @staticmethod
    def _number(inner: InnerList, image: bytes) -> int:
        """The bytes of a list, as its count says."""
        return (int.from_bytes(image[inner.at : inner.at + inner.length], inner.order) - inner.plus) * inner.unit

    def _size_of_count(self, inner: InnerList, image: bytes, sizes: list[int]) -> int:
        """The same, refused where there cannot be so many."""
        size = self._number(inner, image)
        if size not in inner.sizes:
            limits = f"{inner.sizes[0]} to {inner.sizes[-1]} bytes in steps of {inner.size}"
            at = self._place(sizes, inner.at)
            raise CodecError("wrong_measure", f"a list has {size} bytes, not {limits}", at)
        return size

    def _checked(self, inner: InnerList, size: int, at: int) -> int:
        """The bytes of the list whose size the data decide, refused where there cannot be so many."""
        least, most = inner.sizes[0], inner.sizes[-1]
        if size < least:
            raise CodecError("incomplete", f"{self.name} ends in a list of {size} bytes, at least {least}", at + size)
        if size > most:
            raise CodecError("wrong_length", f"a list of {self.name} has at most {most} bytes, not {size}", at + most)
        if size not in inner.sizes:
            raise CodecError("wrong_length", f"a list of {self.name} ends within an element", at + size)
        return size

    def _incomplete(self, inner: InnerList, data: bytes) -> CodecError:
        return CodecError("incomplete", f"{self.name} has more than {len(data)} bytes", len(data))

    def _place(self, sizes: list[int], at: int | None) -> int | None:
        """The byte in data for a byte of the image, in which each list has its `room`."""
        if at is None:
            return None
        before = 0
        for inner, size in zip(self.lists, [*sizes, *[0] * (len(self.lists) - len(sizes))], strict=True):
            if at >= inner.room and (not inner.length or at < inner.room + inner.sizes[-1]):
                return inner.first + before + at - inner.room
            if at < inner.first:
                return at + before
            before += size
        return at + before
