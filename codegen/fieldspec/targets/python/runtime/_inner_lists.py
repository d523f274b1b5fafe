"""Records with lists that have other fields behind them.

They are read and written as an image: first all other fields, then the lists.
"""

from __future__ import annotations

from struct import Struct

from ._error import CodecError
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any, Literal


class InnerList:
    """A list behind `first` bytes of other fields; in the image, and in refusals of it, its place is `room`.

    It has `least` to `most` elements of `size` bytes, which the Struct has as `letters`. The field that counts them is
    at `at` in the image, with `length` bytes in an order; its number, less `plus`, is that of units of `unit` bytes.
    `length` is 0 for the list whose size the data decide. `tail` is the list at the end of each element whose elements
    differ in size; these have `size` bytes in the image.
    """

    __slots__ = ("at", "first", "length", "letters", "order", "plus", "room", "size", "sizes", "tail", "unit")

    def __init__(
        self,
        letters: str,
        size: int,
        bounds: tuple[int, int],
        first: int,
        room: int,
        count: tuple[int, int, Literal["big", "little"], int, int] = (0, 0, "big", 1, 0),
        tail: InnerList | None = None,
    ) -> None:
        self.letters, self.size, self.first, self.room = letters, size, first, room
        self.sizes = range(bounds[0] * size, bounds[1] * size + 1, size)
        self.at, self.length, _, self.unit, self.plus = count
        self.order: Literal["big", "little"] = count[2]
        self.tail = tail

    def count_size(self, data: bytes) -> int:
        """The bytes of the list in the image, as its count in some data says."""
        return (int.from_bytes(data[self.at : self.at + self.length], self.order) - self.plus) * self.unit

    def element_size(self, data: bytes) -> int | None:
        """The bytes of an element that data begin with, where this is its tail; None for a wrong count."""
        if len(data) < self.room:
            return self.room
        size = self.count_size(data)
        return self.room + size if size in self.sizes else None

    def sent(self, image: bytes) -> bytes:
        """What is sent of the list in an image."""
        if self.tail is None:
            return image
        elements = [image[at : at + self.size] for at in range(0, len(image), self.size)]
        return b"".join([element[: self.tail.element_size(element)] for element in elements])


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
        fields, lists, before = b"", b"", 0
        extents: list[list[int]] = []
        numbers: list[int] = []
        for inner in self.lists:
            at = inner.first + before
            fields += data[len(fields) + before : at]
            left = len(data) - at - self.fixed + inner.first
            if left < 0:
                raise self._incomplete(len(data))
            size = self._size_of_count(inner, fields, extents) if inner.length else None
            if inner.tail is not None:
                sizes = self._elements(inner, inner.tail, data[at : at + left], size, at)
                numbers.append(len(sizes))
            else:
                size = self._checked(inner, left, at) if size is None else size
                if size > left:
                    raise self._incomplete(len(data))
                sizes = [size]
                numbers.append(size // inner.size)
            extents.append(sizes)
            for own in sizes:
                piece = data[inner.first + before : inner.first + before + own]
                lists += piece if inner.tail is None else piece.ljust(inner.size, b"\0")
                before += own
        image = fields + data[len(fields) + before :] + lists
        try:
            return function(image, tuple(numbers))
        except CodecError as error:
            raise CodecError(error.reason, error.detail, self._place(extents, error.offset)) from None

    def encoded(self, image: bytes) -> bytes:
        """What is sent of an image."""
        data, at, start = b"", 0, self.fixed
        for inner in self.lists:
            size = inner.count_size(image) if inner.length else len(image) - start
            data += image[at : inner.first] + inner.sent(image[start : start + size])
            at, start = inner.first, start + size
        return data + image[at : self.fixed]

    def elements(self, number: int, images: Sequence[bytes]) -> list[bytes]:
        """What is sent of the images of the elements of a list."""
        inner = self.lists[number]
        return [inner.sent(image) for image in images]

    def _size_of_count(self, inner: InnerList, image: bytes, extents: list[list[int]]) -> int:
        """The bytes of a list in the image as its count says, refused where there cannot be so many."""
        size = inner.count_size(image)
        if size not in inner.sizes:
            limits = f"{inner.sizes[0]} to {inner.sizes[-1]} bytes in steps of {inner.size}"
            at = self._place(extents, inner.at)
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

    def _elements(self, inner: InnerList, tail: InnerList, data: bytes, size: int | None, start: int) -> list[int]:
        """The bytes of each element: of as many as have `size` bytes in the image, or of all to the end of the data."""
        sizes: list[int] = []
        at, least, most = 0, inner.sizes[0], inner.sizes[-1]
        while at < len(data) if size is None else len(sizes) * inner.size < size:
            if len(sizes) * inner.size == most:
                raise CodecError(
                    "wrong_length", f"a list of {self.name} has more than {len(sizes)} elements", start + at
                )
            own = tail.element_size(data[at : at + tail.room])
            if own is None:
                raise CodecError("wrong_measure", f"an element of {self.name} has a wrong size", start + at + tail.at)
            if at + own > len(data):
                raise self._incomplete(start + len(data))
            sizes.append(own)
            at += own
        if len(sizes) * inner.size < least:
            raise CodecError("incomplete", f"{self.name} ends in a list of {len(sizes)} elements", start + at)
        return sizes

    def _incomplete(self, at: int) -> CodecError:
        return CodecError("incomplete", f"{self.name} has more bytes", at)

    def _place(self, extents: list[list[int]], at: int | None) -> int | None:
        """The byte in data for a byte of the image, in which each list has its `room`."""
        if at is None:
            return None
        before = 0
        for inner, sizes in zip(self.lists, [*extents, *[[]] * (len(self.lists) - len(extents))], strict=True):
            if at >= inner.room and (not inner.length or at < inner.room + inner.sizes[-1]):
                index, rest = divmod(at - inner.room, inner.size) if inner.tail is not None else (0, at - inner.room)
                return inner.first + before + sum(sizes[:index]) + rest
            if at < inner.first:
                return at + before
            before += sum(sizes)
        return at + before
