"""Records with lists that have other fields after them, and with records that differ in size.

They are read and written as an image: first all other fields, then the lists.
"""

from __future__ import annotations

from struct import Struct

from ._digits import size_data, size_in
from ._error import CodecError
from ._list_parts import Decision, More, Packing
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any


class InnerList:
    """A list after `first` bytes of other fields; in the image, and in refusals of it, its place is `room`.

    It has `minimum` to `maximum` elements of `size` bytes, which the Struct has as `letters`. The field that counts
    them is at `at` in the image, with `length` bytes in an order, or of digits; its number, less `plus`, is that of
    units of `unit` bytes. `length` is 0 for a list that always has `maximum` elements, and for the one whose size the
    data decide. `parts` tell the size of an element where elements differ in size, and a `decision` that of the only
    element; these have `size` bytes in the image. With a `packing`, numbers are sent in fewer bits. With a `presence`,
    a mask and numbers, the only element is sent if these bits of the number are one of the numbers; without numbers,
    these bits are the count. With a `sent_plus`, what is sent is the number of the sent bytes and this number more; the
    bits of a `presence` are the same in the image. With `continuation`, elements say which of them is the last, and the
    count is one.
    """

    __slots__ = (
        "at",
        "decision",
        "first",
        "length",
        "letters",
        "more",
        "order",
        "packing",
        "parts",
        "plus",
        "presence",
        "room",
        "sent_plus",
        "size",
        "sizes",
        "unit",
    )

    def __init__(
        self,
        letters: str,
        size: int,
        bounds: tuple[int, int],
        first: int,
        room: int,
        count: tuple[int, int, str, int, int] = (0, 0, "big", 1, 0),
        parts: Parts | None = None,
        decision: Decision | None = None,
        packing: Packing | None = None,
        presence: tuple[int, tuple[int, ...] | range] | None = None,
        sent_plus: int | None = None,
        continuation: More | None = None,
    ) -> None:
        self.letters, self.size, self.first, self.room = letters, size, first, room
        self.sizes = range(bounds[0] * size, bounds[1] * size + 1, size)
        self.at, self.length, self.order, self.unit, self.plus = count
        self.parts, self.decision, self.packing, self.presence = parts, decision, packing, presence
        self.sent_plus = sent_plus
        self.more = continuation

    def number(self, data: bytes) -> int:
        """The number in the field that counts the list, in some data."""
        return size_in(data[self.at : self.at + self.length], self.order) or 0

    def count_size(self, data: bytes) -> int:
        """The bytes of the list in the image, as its count in some data says."""
        if self.decision is not None:
            return self.size
        if not self.length:
            return self.sizes[-1] if self.more is None else self.size
        number = self.number(data)
        if self.presence is not None:
            mask, numbers = self.presence
            if numbers:
                return self.size if number & mask in numbers else 0
            number = (number & mask) // (mask & -mask)
        return (number - self.plus) * self.unit

    def image_size(self, image: bytes, start: int) -> int:
        """The same, in an image in which the list is at a start."""
        size, continuation = self.count_size(image), self.more
        if continuation is not None and size:
            while continuation.follows(image[start + size - self.size : start + size]):
                size += self.size
        return size

    def checked_size(self, data: bytes, offset: int) -> int:
        """The same, refused at the count if the number is not possible."""
        size = self.count_size(data)
        if size not in self.sizes:
            limits = f"{self.sizes[0]} to {self.sizes[-1]} bytes in steps of {self.size}"
            raise CodecError("wrong_measure", f"a list has {size} bytes, not {limits}", offset)
        return size

    def sent_number(self, data: bytes, plus: int) -> int:
        """The sent bytes that a number in some data counts, or bits of it."""
        number = self.number(data)
        mask = -1 if self.presence is None else self.presence[0]
        return (number & mask) // (mask & -mask) - plus

    def measured_bytes(self, data: bytes, plus: int, offset: int) -> int:
        """The same, refused at the number if it is not possible."""
        size = self.sent_number(data, plus)
        if not 0 <= size <= self.sizes[-1]:
            raise CodecError("wrong_measure", f"a list has {size} bytes, not 0 to {self.sizes[-1]}", offset)
        return size

    def decided_bytes(self, decision: Decision, data: bytes, place: Callable[[int], int]) -> int:
        """The sent bytes of the element that a number in some data decides, which another one may count.

        Refused at their `place` if one of them is not possible.
        """
        size = decision.size(data, place(decision.at))
        if self.sent_plus is None:
            return size
        number = self.sent_number(data, self.sent_plus)
        if not max(size, 0) <= number <= abs(size):
            raise CodecError("wrong_measure", f"a value has {abs(size)} bytes, not {number}", place(self.at))
        return number

    def with_number(self, data: bytes, number: int) -> bytes:
        """Some bytes with another number in the field that counts the list; bits that count it stay."""
        if self.presence is not None:
            return data
        try:
            own = size_data(number, self.length, self.order)
        except OverflowError:
            raise CodecError("out_of_range", f"a field of {self.length} bytes cannot be {number}") from None
        return data[: self.at] + own + data[self.at + self.length :]

    def sent_size(self, size: int) -> int:
        """The bytes that are sent for `size` bytes of the image, of elements that do not differ in size."""
        return size if self.packing is None else self.packing.sent_size(size // self.size)

    def numbers_in(self, packing: Packing, size: int) -> int:
        """How many numbers fit into `size` bytes, at most the greatest number of the list."""
        return min(8 * size // packing.bits, self.sizes[-1] // self.size)

    def elements(self, parts: Parts, data: bytes, size: int | None, start: int) -> list[int]:
        """The bytes of each element: of the elements within `size` bytes of the image, or of all to the end of the
        data.
        """
        sizes: list[int] = []
        offset, minimum, maximum, continuation = 0, self.sizes[0], self.sizes[-1], self.more
        while offset < len(data) if size is None else len(sizes) * self.size < size:
            if len(sizes) * self.size == maximum:
                raise CodecError("wrong_length", f"a list has more than {len(sizes)} elements", start + offset)
            try:
                own = parts.sent_size(data[offset:])
            except CodecError as error:
                raise error.shifted(start + offset) from None
            if offset + own > len(data):
                raise CodecError("incomplete", "an element has more bytes", start + len(data))
            sizes.append(own)
            if continuation is not None and size is not None and continuation.follows(data[offset : offset + own]):
                if size == maximum:
                    raise CodecError(
                        "wrong_measure", f"more than {len(sizes)} elements follow", start + offset + continuation.at
                    )
                size += self.size
            offset += own
        if len(sizes) * self.size < minimum:
            raise CodecError("incomplete", f"a list has {len(sizes)} elements", start + offset)
        return sizes

    def sent_sizes(
        self, fields: bytes, data: bytes, start: int, stop: int, place: Callable[[int], int], is_last: bool
    ) -> list[int]:
        """The sent bytes of each element in data from `start` on, or of all elements, which may be more than to `stop`.

        The last list ends there. Refused at the `place` of a number, or at the byte at which it shows.
        """
        sent_data = fields[self.at : self.at + self.length]
        if self.length and size_in(sent_data, self.order) is None:
            raise CodecError(
                "unknown_value", f"the size of a list is {sent_data!r}, which is not in digits", place(self.at)
            )
        if self.decision is not None:
            return [self.decided_bytes(self.decision, fields, place)]
        is_open = is_last and self.more is None
        if self.sent_plus is not None:
            measured = self.measured_bytes(fields, self.sent_plus, place(self.at))
            if is_last and start + measured != stop:
                raise CodecError("wrong_measure", f"a list has {stop - start} bytes, not {measured}", place(self.at))
            if self.parts is None or start + measured > stop:
                return [measured]
            try:
                return self.elements(self.parts, data[start : start + measured], None, start)
            except CodecError as error:
                if error.reason not in ("incomplete", "wrong_length"):
                    raise
                detail = f"{measured} bytes do not end with an element of a list"
                raise CodecError("wrong_measure", detail, place(self.at)) from None
        size = None if is_open else self.checked_size(fields, place(self.at))
        if self.parts is not None:
            return self.elements(self.parts, data[start:stop], size, start)
        return [stop - start if size is None else self.sent_size(size)]

    def sent(self, image: bytes) -> bytes:
        """The sent bytes of a list whose bytes in the image are these."""
        if self.packing is not None:
            return self.packing.packed(image)
        if self.parts is None:
            return image
        elements = [image[offset : offset + self.size] for offset in range(0, len(image), self.size)]
        return b"".join([element[: self.parts.sent_size(element)] for element in elements])


class Parts:
    """What tells the size of a record from its bytes: `fixed` bytes of fields, and lists in the order of the wire."""

    __slots__ = ("fixed", "lists")

    def __init__(self, fixed: int, *lists: InnerList) -> None:
        self.fixed, self.lists = fixed, lists

    def sent_size(self, data: bytes) -> int:
        """The bytes of a record that data begin with, maybe more than there are. Raises CodecError for wrong counts."""
        fields, before = b"", 0
        extents: list[tuple[int, int]] = []
        for inner in self.lists:
            start = inner.first + before
            if len(data) < start:
                break
            fields += data[len(fields) + before : start]
            own = inner.sent_sizes(fields, data, start, len(data), lambda offset: _place_after(extents, offset), False)
            extents.append((inner.first, sum(own)))
            before += sum(own)
        return self.fixed + before


def _place_after(extents: Sequence[tuple[int, int]], offset: int) -> int:
    """The sent byte for a byte of other fields, after lists that begin after some of these and have some bytes."""
    return offset + sum([size for first, size in extents if first <= offset])


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
        """The result of a function for the image of some data, and the numbers of elements.

        Raises CodecError with the place in the data.
        """
        fields, lists, before = b"", b"", 0
        extents: list[list[int]] = []
        numbers: list[int] = []
        zero_at: int | None = None

        def place(start: int) -> int:
            return self._place(extents, start)

        for inner in self.lists:
            start = inner.first + before
            fields += data[len(fields) + before : start]
            stop = len(data) - self.fixed + inner.first
            if stop < start:
                raise self._incomplete(len(data))
            is_last = inner is self.lists[-1]
            sizes = inner.sent_sizes(fields, data, start, stop, place, is_last)
            byte_count = sum(sizes)
            if start + byte_count > stop:
                raise self._incomplete(len(data))
            if inner.decision is not None:
                if inner.decision.has_text(fields) and 0 in data[start : start + byte_count]:
                    zero_at = start if zero_at is None else zero_at
                numbers.append(1)
            elif inner.parts is not None:
                numbers.append(len(sizes))
            else:
                if is_last:
                    self._check(inner, byte_count, start)
                packing = inner.packing
                numbers.append(byte_count // inner.size if packing is None else inner.numbers_in(packing, byte_count))
            if start + byte_count < stop and is_last:
                raise CodecError(
                    "wrong_length", f"{self.name} has more than its {start + byte_count} bytes", start + byte_count
                )
            extents.append(sizes)
            for own in sizes:
                piece = data[inner.first + before : inner.first + before + own]
                is_filled = inner.parts is not None or inner.decision is not None
                piece = inner.packing.unpacked(piece, numbers[-1]) if inner.packing is not None else piece
                piece = piece if inner.decision is None else piece + inner.decision.mark(fields)
                lists += piece.ljust(inner.size, b"\0") if is_filled else piece
                before += own
        if zero_at is not None:
            raise CodecError("unknown_value", f"a text of {self.name} has a zero", zero_at)
        image = fields + data[len(fields) + before :] + lists
        for inner, number in zip(self.lists, numbers, strict=True):
            image = image if inner.sent_plus is None else inner.with_number(image, number)
        try:
            return function(image, tuple(numbers))
        except CodecError as error:
            offset = None if error.offset is None else place(error.offset)
            raise CodecError(error.reason, error.detail, offset) from None

    def encoded(self, image: bytes) -> bytes:
        """The sent form of an image."""
        data, offset, start, fields = b"", 0, self.fixed, image
        pieces: list[bytes] = []
        for inner in self.lists:
            size = len(image) - start if inner is self.lists[-1] else inner.image_size(image, start)
            piece = image[start : start + size]
            pieces.append(inner.sent(piece) if inner.decision is None else inner.decision.sent(image, piece))
            if inner.sent_plus is not None:
                byte_count = len(pieces[-1])
                if inner.presence is not None and inner.sent_number(fields, inner.sent_plus) != byte_count:
                    raise CodecError(
                        "wrong_measure", f"bits of {self.name} do not count the {byte_count} bytes of a text"
                    )
                fields = inner.with_number(fields, byte_count + inner.sent_plus)
            start += size
        for inner, piece in zip(self.lists, pieces, strict=True):
            data += fields[offset : inner.first] + piece
            offset = inner.first
        return data + fields[offset : self.fixed]

    def elements(self, number: int, images: Sequence[bytes]) -> list[bytes]:
        """The sent form of the images of a list's elements."""
        inner = self.lists[number]
        return [inner.sent(image) for image in images]

    def _check(self, inner: InnerList, size: int, offset: int) -> None:
        """Refuses a wrong number of bytes of the list whose size the data decide."""
        minimum, maximum = inner.sent_size(inner.sizes[0]), inner.sent_size(inner.sizes[-1])
        if inner.packing is not None and size >= minimum:
            maximum = inner.packing.sent_size(inner.numbers_in(inner.packing, size))
            if maximum < size:
                raise CodecError("wrong_length", f"a list of {self.name} has bits after its numbers", offset + maximum)
        elif size < minimum:
            raise CodecError(
                "incomplete", f"{self.name} ends in a list of {size} bytes, at least {minimum}", offset + size
            )
        elif size > maximum:
            raise CodecError(
                "wrong_length", f"a list of {self.name} has at most {maximum} bytes, not {size}", offset + maximum
            )
        elif size not in inner.sizes:
            raise CodecError("wrong_length", f"a list of {self.name} ends within an element", offset + size)

    def _incomplete(self, offset: int) -> CodecError:
        return CodecError("incomplete", f"{self.name} has more bytes", offset)

    def _place(self, extents: list[list[int]], offset: int) -> int:
        """The byte in data for a byte of the image, in which each list has its `room`."""
        before = 0
        for inner, sizes in zip(self.lists, [*extents, *[[]] * (len(self.lists) - len(extents))], strict=True):
            if offset >= inner.room and (inner is self.lists[-1] or offset < inner.room + inner.sizes[-1]):
                if inner.packing is not None:
                    return inner.first + before + (offset - inner.room) // inner.size * inner.packing.bits // 8
                index, rest = (
                    divmod(offset - inner.room, inner.size) if inner.parts is not None else (0, offset - inner.room)
                )
                return inner.first + before + sum(sizes[:index]) + rest
            if offset < inner.first:
                return offset + before
            before += sum(sizes)
        return offset + before
