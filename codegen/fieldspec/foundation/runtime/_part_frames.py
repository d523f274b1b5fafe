"""Frames with unusual parts: after the checksum, or with a checksum or a length over other parts than all before."""

from __future__ import annotations

from ._conversions import magnitude_bytes, magnitude_of
from ._digits import digits, no_digits
from ._error import CodecError, wrong_const
from ._framers import LengthFramer
from ._frames import Frames
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from typing import Literal

    from ._typing import Data

    Order = Literal["big", "little"]
    Form = Literal["decimal", "upper_hex", "lower_hex"]
    Part = tuple[str, int, Order | Form, bool | None, int | None, bool]
    Check = tuple[int, Callable[[Data], int], int, int | None, str]
    Length = tuple[int, int, str, int, int, int]


_FORMS = ("decimal", "upper_hex", "lower_hex")
_NO_DIGITS = -1


class PartFrames(Frames):
    """The frames of one link in one direction, as rows of parts: those before the body, and those after it.

    A row is the name, the size in bytes, the order, whether it has a sign, the constant, and whether any other number
    is refused. It is None in place of a sign that is the highest bit alone. In place of an order, a part that is sent
    as digits has their form. `checks` are the checksums in the order in which they are computed: the place in these
    rows, the function, the bounds of the bytes that it covers, and the digits of one that is sent as characters. A
    length of n means that the parts have `unit` * n + `base` bytes. `lengths` are the other ones: the place, the
    offset, the name, the greatest number, the unit and the base. `bits` are the first bit and the number of bits of
    parts before the body that share their bytes with neighbours, by their place.
    """

    __slots__ = ("base", "bits", "checks", "digits", "lengths", "offsets", "rows", "tail", "unit")

    def __init__(
        self,
        head: tuple[Part, ...],
        tail: tuple[Part, ...],
        checks: tuple[Check, ...],
        *,
        code: int = -1,
        code_offset: int = 0,
        length: int = -1,
        length_offset: int = 0,
        length_name: str = "",
        longest: int = 0,
        unit: int = 1,
        base: int = 0,
        lengths: tuple[Length, ...] = (),
        bits: dict[int, tuple[int, int]] | None = None,
        start: bytes = b"",
        end: bytes = b"",
        hexadecimal: bool = False,
        preamble: tuple[int, int, int, int] | None = None,
    ) -> None:
        super().__init__(
            "",
            "",
            code=code,
            code_offset=code_offset,
            length=length,
            length_offset=length_offset,
            length_name=length_name,
            longest=longest,
            start=start,
            end=end,
            hexadecimal=hexadecimal,
            preamble=preamble,
        )
        self.rows, self.tail, self.checks, self.unit, self.base = head, tail, checks, unit, base
        self.bits = bits or {}
        first = ((length, length_offset, length_name, longest, unit, base),) if length >= 0 else ()
        self.lengths: tuple[Length, ...] = (*first, *lengths)
        self.offsets: list[int] = []
        position = filled = 0
        for place, row in enumerate(head):
            self.offsets.append(position)
            filled += self.bits[place][1] if place in self.bits else 8 * row[1]
            if filled == 8 * row[1]:
                position, filled = position + row[1], 0
        self.head_size = position
        self.tail_size = sum(row[1] for row in tail)
        rows = (*head, *tail)
        self.digits = {
            place: digits(f">u64 {form} {size} 0")
            for place, (_, size, form, _, _, _) in enumerate(rows)
            if form in _FORMS
        }
        self.forms = {offset: self.digits[place] for place, offset in enumerate(self.offsets) if place in self.digits}

    def _numbers(self, data: Data) -> list[tuple[Part, int, int]]:
        """The row, the offset and the number of each part of a frame that is long enough; -1 if not digits."""
        numbers = []
        end = len(data) - self.tail_size
        for place, row in enumerate((*self.rows, *self.tail)):
            offset = self.offsets[place] if place < len(self.rows) else end
            _, size, order, signed, _, _ = row
            if order == "big" or order == "little":
                number = _whole(data[offset : offset + size], order, signed)
                if place in self.bits:
                    shift, width = self.bits[place]
                    number = number >> shift & (1 << width) - 1
            else:
                (digits_number,) = self.digits[place].unpack(data[offset : offset + size])
                number = _NO_DIGITS if digits_number is None else digits_number
            numbers.append((row, offset, number))
            end += size if place >= len(self.rows) else 0
        return numbers

    def _wrong_checksum(
        self, data: Data, numbers: list[tuple[Part, int, int]], places: frozenset[int] | None = None
    ) -> CodecError | None:
        """The error of the first wrong checksum, of all or of those at some places; None where they are right."""
        for place, function, start, stop, form in self.checks:
            if places is not None and place not in places:
                continue
            (_, size, order, _, _, _), offset, received = numbers[place]
            want = _number(function(data[start:stop]), size, _order(order), form)
            if received != want:
                text = f"the check is {received:0{2 * size}X}, not {want:0{2 * size}X}"
                return CodecError("wrong_checksum", text, offset)
        return None

    def _no_digits(self, data: Data, numbers: list[tuple[Part, int, int]], places: Iterable[int]) -> CodecError | None:
        """The error of the first part of some that is not sent as its digits, although not everything is accepted."""
        for place in places:
            (name, size, _, _, constant, compared), offset, number = numbers[place]
            if number == _NO_DIGITS and (compared or constant is None):
                return no_digits(name, bytes(data[offset : offset + size]), offset)
        return None

    def _wrong(self, data: Data, numbers: list[tuple[Part, int, int]]) -> CodecError | None:
        """The error of the first wrong checksum, or else of the first wrong constant; None where all are right."""
        wrong = self._wrong_checksum(data, numbers, self._own)
        if wrong is not None:
            return wrong
        for (name, _, _, _, constant, compared), offset, number in numbers:
            if compared and constant is not None and number != constant:
                return wrong_const(name, number, constant, offset)
        return None

    @property
    def has_checksum(self) -> bool:
        """Whether frames have a checksum."""
        return bool(self.checks)

    def agrees(self, data: Data) -> bool:
        """Whether all lengths, checksums and constants are right."""
        try:
            self.split(data)
        except CodecError:
            return False
        return True

    def split(self, data: Data) -> tuple[tuple[int, ...], Data]:
        """The header and the body of the parts of a frame. Raises CodecError."""
        size = len(data)
        if size < self.head_size + self.tail_size:
            minimum = self.head_size + self.tail_size
            raise CodecError("incomplete", f"a frame has at least {minimum} bytes, not {size}", size)
        numbers = self._numbers(data)
        wrong = self._no_digits(data, numbers, self.digits)
        if wrong is not None:
            raise wrong
        self._compare_lengths(numbers, size, self._own)
        wrong = self._wrong(data, numbers)
        if wrong is not None:
            raise wrong
        head = tuple(number for _, _, number in numbers[: len(self.rows)])
        return head, data[self.head_size : size - self.tail_size]

    @property
    def _own(self) -> frozenset[int] | None:
        """The places of the lengths and checksums over the bytes of the parts; None for all."""
        return None

    def _sent(self, data: bytes) -> bytes:
        """The sent form of the bytes of the parts."""
        return data

    def _compare_lengths(self, numbers: list[tuple[Part, int, int]], size: int, places: frozenset[int] | None) -> None:
        """Refuses the first wrong length, of all or of those at some places. Raises CodecError."""
        for place, offset, name, _, unit, base in self.lengths:
            units = numbers[place][2]
            extent = units * unit + base
            if extent != size and (places is None or place in places):
                text = f"{name} is {units}, for a frame of {extent} bytes, but there are {size}"
                raise CodecError("wrong_length", text, offset)

    def joined(self, head: list[int], body: bytes) -> bytes:
        """The whole frame of a header and a body; it fills in length and checksum. Raises CodecError."""
        numbers = [*head, *(row[4] or 0 for row in self.tail)]
        # What is escaped comes first: how many bytes are sent depends on all of its bytes.
        self._complete(numbers, body, False)
        if self._own is not None:
            self._complete(numbers, body, True)
        return self.marked(self._sent(self._packed(numbers, body)))

    def _complete(self, numbers: list[int], body: bytes, of_sent: bool) -> None:
        """Fills in the lengths and checksums of the bytes that are sent, or of those before they are escaped."""
        own = self._own
        for place, _, name, longest, unit, base in self.lengths:
            if (own is not None and place not in own) == of_sent:
                total = self.head_size + len(body) + self.tail_size
                if of_sent:
                    total = len(self._sent(self._packed(numbers, body)))
                units, rest = divmod(total - base, unit)
                if rest or not 0 <= units <= longest:
                    raise CodecError("wrong_length", f"{name} cannot say that the frame has {total} bytes")
                numbers[place] = units
        for place, function, start, stop, form in self.checks:
            if (own is not None and place not in own) == of_sent:
                _, size, order, _, _, _ = (*self.rows, *self.tail)[place]
                data = self._packed(numbers, body)
                if of_sent:
                    data = self._sent(data)
                numbers[place] = _number(function(data[start:stop]), size, _order(order), form)

    def _packed(self, numbers: list[int], body: bytes) -> bytes:
        packed: list[bytes] = []
        shared = 0
        for place, (number, (_, size, order, signed, _, _)) in enumerate(
            zip(numbers, (*self.rows, *self.tail), strict=True)
        ):
            if place == len(self.rows):
                packed.append(body)
            if order != "big" and order != "little":
                packed.append(self.digits[place].data(number))
            elif place not in self.bits:
                packed.append(_bytes(number, size, order, signed))
            else:
                shared |= number << self.bits[place][0]
                if self.offsets[place + 1 : place + 2] != [self.offsets[place]]:
                    packed.append(_bytes(shared, size, order, False))
                    shared = 0
        if not self.tail:
            packed.append(body)
        return b"".join(packed)


def _whole(data: Data, order: Order, signed: bool | None) -> int:
    return magnitude_of(data, order) if signed is None else int.from_bytes(data, order, signed=signed)


def _bytes(number: int, size: int, order: Order, signed: bool | None) -> bytes:
    return magnitude_bytes(number, size, order) if signed is None else number.to_bytes(size, order, signed=signed)


def _number(checksum: int, size: int, order: Literal["big", "little"], digits: str) -> int:
    """The number in the bytes of a checksum, which may be sent as digits."""
    if not digits:
        return checksum
    text = f"{checksum:0{size}d}" if digits == "decimal" else f"{checksum:0{size}x}"
    return int.from_bytes((text.upper() if digits == "upper_hex" else text).encode(), order)


def _order(order: Order | Form) -> Order:
    """The byte order of a checksum, whose digits are not a concern of its row."""
    return "little" if order == "little" else "big"


class CountFramer(LengthFramer):
    """For frames whose length counts other units than all bytes of their parts."""

    def _known(self) -> dict[int, frozenset[int]]:
        known = super()._known()
        known.pop(len(self.frames.start) + self.length_offset, None)
        return known

    def _extent(self, buffer: bytearray, offset: int) -> int:
        frames = self.frames
        assert isinstance(frames, PartFrames)
        marks = len(frames.start) + len(frames.end)
        if not buffer.startswith(frames.start, offset) or self._goes_on(buffer, offset):
            return 0
        offset += len(frames.start)
        if self._foreign(buffer, offset):
            return 0
        units = self._read(
            buffer, offset + self.length_offset, self.length_size, self._length_form, self._length_is_little
        )
        extent = units * frames.unit + frames.base + marks
        return extent if self.shortest <= extent <= self.longest else 0
