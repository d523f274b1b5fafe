"""Lists with other fields after them, and records that differ in size, in lists and by themselves: where everything is
in some data.

Codecs work on the image of such a record: first all other fields, then the lists. Each list except the last has room
there for its greatest number of elements. An element that differs in size is there as it is sent, with zeros after it
up to the most bytes that it may have, so that everything in the image has its place. The last list extends to the end
of the image. A record that differs in size and occurs a fixed number of times is a list with that number of elements.
A field whose type another one decides is a list of one element, in the image with zeros after it in the same way.
"""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.continuation import Continuation
from fieldspec.codec.layout.decision import Decision
from fieldspec.codec.layout.list_extents import ListExtent, ListFault
from fieldspec.codec.layout.packing import Packing
from fieldspec.codec.layout.presence import PresenceLayout
from fieldspec.codec.layout.widths import WidthError
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.runtime._digits import size_data, size_in


@dataclass(frozen=True, slots=True)
class InnerList:
    """The list `name` begins after `first` bytes of other fields, not counting lists, and at `room` in the image.

    It has `least` to `most` bytes in the image, `element` for each element. The field `count` is at `count_at` in the
    image and has `count_size` bytes in the order, or of the digits, `count_order`; its number, less `plus`, counts
    units of `unit` bytes. `count` is empty where the number is always the same, and where the data end with the list
    and the fields after it. `parts` tell the size of an element from its bytes, a `decision` from a field before it;
    both are None where all have the same size. Elements with a `packing` are sent in fewer bits than they have in the
    image. With a `presence`, bits of the number say whether the only element is sent, or have the count. With a
    `sent_plus`, the number is that of elements only in the image: what is sent is the number of their sent bytes and
    this number more. Bits with that number are the same in the image. With a `continuation`, each element says whether
    another one follows, wherever the list is, and a number whether there is a first one.
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
    parts: InnerLists | None = None
    decision: Decision | None = None
    packing: Packing | None = None
    presence: PresenceLayout | None = None
    sent_plus: int | None = None
    continuation: Continuation | None = None

    def size_of(self, number: int | None) -> int | None:
        """The bytes in the image if the count is a number, None if it may not be that number."""
        if number is None:
            return None
        if self.decision is not None:
            size = self.element
        elif self.presence is not None:
            elements = self.presence.elements(number)
            size = -1 if elements is None else elements * self.element
        else:
            size = (number - self.plus) * self.unit
        return size if self.takes(size) else None

    def takes(self, size: int) -> bool:
        """Whether the list can have a number of bytes in the image."""
        return size % self.element == 0 and self.least <= size <= self.most

    def count_in(self, image: bytes) -> int | None:
        """The number of the field that counts the list, in an image that goes that far; None for no digits."""
        return size_in(image[self.count_at : self.count_at + self.count_size], self.count_order)

    def size_in(self, image: bytes) -> int | None:
        """The bytes in the image of a list that does not end with the data, None for a wrong count.

        For a list whose elements say which is the last, it is the size of one element.
        """
        if self.continuation is not None and not self.count:
            return self.element
        return self.size_of(self.count_in(image)) if self.count else self.most

    def sent_number_in(self, data: bytes) -> int:
        """The sent bytes that a number counts which is sent in place of the one in the image, or some of its bits."""
        number = self.count_in(data) or 0
        return (number if self.presence is None else self.presence.bits_in(number)) - (self.sent_plus or 0)

    def sent_bytes_in(self, data: bytes) -> int | None:
        """The same; None for a number that cannot be right."""
        size = self.sent_number_in(data)
        return size if 0 <= size <= self.most else None

    def with_number(self, image: bytes, number: int) -> bytes:
        """An image or data with another number in the field that counts the list, unless its bits do.

        Raises OverflowError.
        """
        if self.presence is not None:
            return image
        stop = self.count_at + self.count_size
        return image[: self.count_at] + size_data(number, self.count_size, self.count_order) + image[stop:]

    def room_size_in(self, image: bytes) -> int | None:
        """The same, in an image that has the elements as well."""
        size = self.size_in(image)
        if self.continuation is not None and size:
            while size < self.most and self.continuation.follows(
                image[self.room + size - self.element : self.room + size]
            ):
                size += self.element
        return size

    def sent_size(self, size: int) -> int:
        """The bytes that are sent for `size` bytes of the image, of elements that do not differ in size."""
        return size if self.packing is None else self.packing.sent_size(size // self.element)


@dataclass(frozen=True, slots=True)
class InnerLists:
    """The lists of a record in the order of the wire; all other fields have `fixed` bytes."""

    lists: tuple[InnerList, ...]
    fixed: int

    @property
    def last(self) -> InnerList:
        """The list that comes last, whose size the data decide."""
        return self.lists[-1]

    def extents_in(self, data: bytes) -> tuple[list[ListExtent], ListFault | None]:
        """The bytes of each list in some data; up to the first one for which they are not known, and why."""
        extents: list[ListExtent] = []
        image, before = b"", 0
        for inner in self.lists:
            start = inner.first + before
            left = len(data) - start - (self.fixed - inner.first)
            if left < 0:
                return extents, ListFault("incomplete", len(data))
            image += data[len(image) + before : start]
            is_last = inner is self.last
            extent = self._extent(inner, image, data[start : start + left], extents, is_last)
            if isinstance(extent, ListExtent) and extent.size > left:
                extent = ListFault("incomplete", len(data))
            elif isinstance(extent, ListExtent) and is_last and extent.size < left:
                extent = ListFault("wrong_length", start + extent.size)
            if isinstance(extent, ListFault):
                return extents, extent
            extents.append(extent)
            before += extent.size
        return extents, None

    def _extent(
        self, inner: InnerList, image: bytes, data: bytes, extents: list[ListExtent], is_last: bool
    ) -> ListExtent | ListFault:
        """The bytes of a list with which data begin, maybe more than these have; of the last one, to their end."""
        start = inner.first + sum(extent.size for extent in extents)
        if inner.count and inner.count_in(image) is None:
            return ListFault("unknown_value", self.place_in_data(extents, inner.count_at))
        if inner.decision is not None:
            size = inner.decision.size_in(image)
            if size is None:
                return ListFault("unknown_value", self.place_in_data(extents, inner.decision.offset))
            number = size if inner.sent_plus is None else inner.sent_number_in(image)
            is_right = max(size, 0) <= number <= abs(size)
            return ListExtent(number, (number,)) if is_right else self._wrong_number(inner, extents)
        is_open = is_last and inner.continuation is None
        if inner.sent_plus is not None:
            size = inner.sent_bytes_in(image)
            if size is None or (is_last and size != len(data)):
                return self._wrong_number(inner, extents)
            if inner.parts is None or size > len(data):
                return ListExtent(size)
            extent = _elements(inner, inner.parts, data[:size], None, start)
            ends_otherwise = isinstance(extent, ListFault) and extent.reason in ("incomplete", "wrong_length")
            return self._wrong_number(inner, extents) if ends_otherwise else extent
        if is_open and inner.parts is None:
            return (
                ListExtent(len(data))
                if inner.packing is None
                else _packed_numbers(inner, inner.packing, len(data), start)
            )
        size = None if is_open else inner.size_in(image)
        if size is None and not is_open:
            return self._wrong_number(inner, extents)
        if inner.parts is not None:
            return _elements(inner, inner.parts, data, size, start)
        assert size is not None
        sent_size = inner.sent_size(size)
        numbers = 0 if inner.packing is None else inner.packing.numbers_in(sent_size, inner.most // inner.element)
        return ListExtent(sent_size, numbers=numbers)

    def sent_size(self, data: bytes) -> int | ListFault:
        """The bytes of an element that data begin with, which may be more than the data have."""
        extents: list[ListExtent] = []
        fields, before = b"", 0
        for inner in self.lists:
            start = inner.first + before
            if len(data) < start:
                break
            fields += data[len(fields) + before : start]
            extent = self._extent(inner, fields, data[start:], extents, False)
            if isinstance(extent, ListFault):
                return extent
            extents.append(extent)
            before += extent.size
        return self.fixed + before

    def _wrong_number(self, inner: InnerList, extents: list[ListExtent]) -> ListFault:
        """The fault of a number that counts what cannot be."""
        return ListFault("wrong_measure", self.place_in_data(extents, inner.count_at))

    def image_of(self, data: bytes, extents: Sequence[ListExtent]) -> bytes:
        """The image of data whose lists have some extents; it has zeros for fields after a list without one."""
        lists, fields, before = b"", b"", 0
        for inner, extent in zip(self.lists, extents, strict=False):
            start = inner.first + before
            fields += data[len(fields) + before : start]
            piece = data[start : start + extent.size]
            if inner.decision is not None:
                piece = inner.decision.image_of(fields, piece).ljust(inner.element, b"\0")
            elif inner.parts is not None:
                offset, pieces = 0, []
                for size in extent.elements:
                    pieces.append(piece[offset : offset + size].ljust(inner.element, b"\0"))
                    offset += size
                piece = b"".join(pieces)
            if inner.packing is not None:
                piece = inner.packing.unpacked(piece, extent.numbers)
            lists += piece if inner is self.last else piece.ljust(inner.most, b"\0")
            before += extent.size
        stop = None if len(extents) == len(self.lists) else self.lists[len(extents)].first + before
        image = (fields + data[len(fields) + before : stop]).ljust(self.fixed, b"\0") + lists
        for inner, extent in zip(self.lists, extents, strict=False):
            if inner.sent_plus is not None:
                image = inner.with_number(image, len(extent.elements))
        return image

    def text_with_zero(self, data: bytes, extents: Sequence[ListExtent]) -> tuple[str, int] | None:
        """The first text, whose type a field decides, that has a zero in some data, and the byte at which it begins.

        None where the last list has a wrong number of bytes, which is wrong before that.
        """
        image, before, last = self.image_of(data, extents), 0, self.last
        if last.decision is None and last.parts is None and last.packing is None and not last.takes(extents[-1].size):
            return None
        for inner, extent in zip(self.lists, extents, strict=True):
            start = inner.first + before
            is_text = inner.decision is not None and inner.decision.has_text(image)
            if is_text and 0 in data[start : start + extent.size]:
                return inner.name, start
            before += extent.size
        return None

    def data_of(self, image: bytes) -> bytes:
        """The bytes that are sent for an image.

        Raises OverflowError if a field cannot count them, and WidthError if bits do not.
        """
        fields, pieces = image, []
        for inner in self.lists:
            pieces.append(self._sent_bytes(inner, image))
            if inner.sent_plus is not None:
                if inner.presence is not None and inner.sent_number_in(image) != len(pieces[-1]):
                    raise WidthError("wrong_measure", inner.count, inner.count_at)
                fields = inner.with_number(fields, len(pieces[-1]) + inner.sent_plus)
        data, offset = b"", 0
        for inner, piece in zip(self.lists, pieces, strict=True):
            data += fields[offset : inner.first] + piece
            offset = inner.first
        return data + fields[offset : self.fixed]

    def _sent_bytes(self, inner: InnerList, image: bytes) -> bytes:
        """The bytes that are sent for a list in an image."""
        piece = image[inner.room :]
        if inner is not self.last:
            piece = piece[: inner.room_size_in(image)]
        if inner.decision is not None:
            return inner.decision.sent_bytes(image, piece)
        if inner.packing is not None:
            return inner.packing.packed(piece)
        if inner.parts is None:
            return piece
        elements = [piece[offset : offset + inner.element] for offset in range(0, len(piece), inner.element)]
        return b"".join(inner.parts.sent_bytes(element) for element in elements)

    def sent_bytes(self, element: bytes) -> bytes:
        """The sent bytes of an element in an image."""
        size = self.sent_size(element)
        assert isinstance(size, int)
        return element[:size]

    def place_in_data(self, extents: Sequence[ListExtent], offset: int) -> int:
        """The byte in data, whose lists have some extents, for a byte of their image."""
        before = 0
        unknown = [ListExtent(0)] * (len(self.lists) - len(extents))
        for inner, extent in zip(self.lists, [*extents, *unknown], strict=True):
            if offset >= inner.room and (inner is self.last or offset < inner.room + inner.most):
                return inner.first + before + _place_in_list(inner, extent, offset - inner.room)
            if offset < inner.first:
                return offset + before
            before += extent.size
        return offset + before


def _place_in_list(inner: InnerList, extent: ListExtent, offset: int) -> int:
    if inner.packing is not None:
        return inner.packing.place(offset // inner.element)[0]
    if inner.parts is None and inner.decision is None:
        return offset
    index, rest = divmod(offset, inner.element)
    return sum(extent.elements[:index]) + rest


def _elements(inner: InnerList, parts: InnerLists, data: bytes, size: int | None, start: int) -> ListExtent | ListFault:
    """The elements of a list whose elements differ in size: those within `size` bytes of the image, or all.

    They may say that more follow.
    """
    sizes: list[int] = []
    offset, continuation = 0, inner.continuation
    while offset < len(data) if size is None else len(sizes) * inner.element < size:
        if len(sizes) * inner.element == inner.most:
            return ListFault("wrong_length", start + offset)
        element_size = parts.sent_size(data[offset:])
        if isinstance(element_size, ListFault):
            return ListFault(element_size.reason, start + offset + element_size.at)
        if offset + element_size > len(data):
            return ListFault("incomplete", start + len(data))
        sizes.append(element_size)
        if continuation is not None and size is not None and continuation.follows(data[offset : offset + element_size]):
            if size == inner.most:
                return ListFault("wrong_measure", start + offset + continuation.offset)
            size += inner.element
        offset += element_size
    if len(sizes) * inner.element < inner.least:
        return ListFault("incomplete", start + offset)
    return ListExtent(offset, tuple(sizes))


def _packed_numbers(inner: InnerList, packing: Packing, size: int, start: int) -> ListExtent | ListFault:
    """The extent of packed numbers to which all of `size` bytes belong."""
    numbers = packing.numbers_in(size, inner.most // inner.element)
    sent_size = packing.sent_size(numbers)
    if numbers * inner.element < inner.least:
        return ListFault("incomplete", start + size)
    fault = ListFault("wrong_length", start + sent_size)
    return fault if sent_size < size else ListExtent(size, numbers=numbers)
