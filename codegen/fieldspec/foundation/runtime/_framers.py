"""Framers find the frames in a stream of bytes that arrives in pieces of any size, with garbage between frames.

A framer is for one direction: requests and responses look alike, and the bytes of the other direction are garbage to
it. It keeps at most the bytes of one frame. If bytes look like a frame but are not, it drops one byte and tries again,
so each byte is examined at most once per byte of a frame. A regular expression skips bytes that cannot begin a frame.

Garbage may look like the beginning of a frame. Then the frames after it wait until that frame would be complete, or
until the line has been silent and `idle` is called. Garbage with the right checksum by chance counts as a frame;
with an 8-bit checksum that happens once in 256 times. `pause` shows what `idle` would return, and drops nothing: a
sender may be slow.
"""

from __future__ import annotations

from ._conversions import turned
from ._frames import Frames
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Any, Literal

    from ._digits import Digits
    from ._typing import Data

    Bits = tuple[int, int]
    Extent = tuple[int, int, int, int] | tuple[int, int, int, int, Literal["big", "little"], bool]

_NO_DIGITS = 1 << 64
"""The number of a part without digits: not a code, unit address, flag of a code or length of a frame."""


class Intervals:
    """More numbers than a set is for, by the first and the last one of each interval."""

    def __init__(self, *bounds: tuple[int, int]) -> None:
        self._bounds = bounds

    def __contains__(self, number: int) -> bool:
        return any(low <= number <= high for low, high in self._bounds)


class Framer:
    """Takes bytes as they arrive and returns whole frames: all parts and the checksum are right, the address is valid.

    `shortest` and `longest` are the sizes of frames in bytes. `unit_addresses` are the valid unit addresses; empty for
    all. `dropped` counts the bytes that belong to no frame. `unit_address_bits`, as `length_bits` and `code_bits`, are
    the first bit and the number of bits of a part that shares its bytes with others.
    """

    def __init__(
        self,
        frames: Frames,
        *,
        shortest: int,
        longest: int,
        unit_address_offset: int = 0,
        unit_address_size: int = 0,
        unit_addresses: frozenset[int] | Intervals = frozenset(),
        unit_address_bits: Bits | None = None,
        order: str = "big",
    ) -> None:
        self.frames, self.shortest, self.longest = frames, shortest, longest
        self.unit_address_offset, self.unit_address_size = unit_address_offset, unit_address_size
        self.unit_addresses = unit_addresses
        self._address_form = unit_address_bits or frames.forms.get(unit_address_offset)
        self._address_is_byte = unit_address_size == 1 and self._address_form is None
        self.little = order == "little"
        self.dropped = 0
        self._buffer = bytearray()
        self._lead = 0  # the bytes dropped last that may belong to a preamble
        self._marked = bool(frames.start or frames.end or frames.preamble)
        self._prepare()

    def _prepare(self) -> None:
        """Compiles the search for the next byte that may begin a frame."""
        from re import DOTALL, compile  # takes longer to import than a device, and few programs need it

        known = self._known()
        self._width = max(known, default=0) + 1
        pattern = b"".join(_class(known[place]) if place in known else b"." for place in range(self._width))
        self._search = compile(pattern, DOTALL).search

    def _known(self) -> dict[int, frozenset[int]]:
        """The possible values of single bytes at the beginning of a frame, by their place."""
        start = self.frames.start
        known = {place: frozenset((byte,)) for place, byte in enumerate(start)}
        if self.unit_addresses and self._address_is_byte and isinstance(self.unit_addresses, frozenset):
            known[len(start) + self.unit_address_offset] = self.unit_addresses
        return known

    def feed(self, data: Data) -> list[bytes]:
        """The frames that these bytes complete, each with its delimiters and checksum."""
        buffer = self._buffer
        buffer += data
        frames: list[bytes] = []
        offset, size, shortest = 0, len(buffer), self.shortest
        while size - offset >= shortest:
            extent = self._extent(buffer, offset)
            if offset + extent > size:
                break
            if extent < 0:
                if size - offset <= self.longest:
                    break
            elif extent and self._holds(frame := bytes(buffer[offset : offset + extent])):
                frames.append(self._led(frame) if self._lead else frame)
                offset += extent
                continue
            match = self._search(buffer, offset + 1)
            next_start = max(offset, size - self._width) + 1 if match is None else match.start()
            self._drop(buffer, offset, next_start)
            offset = next_start
        del buffer[:offset]
        return frames

    def _drop(self, buffer: bytearray, offset: int, next_start: int) -> None:
        """Counts bytes that belong to no frame, without the last ones that may belong to a preamble."""
        self.dropped += next_start - offset
        if self.frames.preamble is not None:
            byte, _, _, spare = self.frames.preamble
            before, data = self._lead, bytes(buffer[offset:next_start])
            run = len(data) - len(data.rstrip(bytes((byte,))))
            self._lead = min(run + (before if run == len(data) else 0), spare)
            self.dropped += before - self._lead

    def _led(self, frame: bytes) -> bytes:
        """A frame with the bytes of its preamble that were dropped."""
        preamble, lead, self._lead = self.frames.preamble, self._lead, 0
        return frame if preamble is None else bytes((preamble[0],)) * lead + frame

    def idle(self) -> list[bytes]:
        """Call it when the line has been silent: it returns the frames in the bytes so far, and drops the rest."""
        frames: list[bytes] = []
        while self._buffer:
            whole = bytes(self._buffer)
            if len(whole) >= self.shortest and self._extent(self._buffer, 0) < 0 and self._holds(whole):
                self._buffer.clear()
                frames.append(whole)
                break
            self._drop(self._buffer, 0, 1)
            del self._buffer[:1]
            frames += self.feed(b"")
        self.dropped, self._lead = self.dropped + self._lead, 0
        return frames

    def pause(self) -> list[bytes]:
        """The frames that `idle` would return. It drops nothing, so that a frame that has begun can still go on."""
        buffer, dropped, lead = bytes(self._buffer), self.dropped, self._lead
        frames = self.idle()
        self._buffer[:], self.dropped, self._lead = buffer, dropped, lead
        return frames

    def reset(self) -> None:
        """Drops all bytes so far."""
        self._buffer.clear()
        self._lead = 0

    @property
    def missing(self) -> int:
        """How many bytes the next frame still needs, as far as its beginning shows it; 1 at the least."""
        size = len(self._buffer)
        expected_size = self.shortest if size < self.shortest else self._extent(self._buffer, 0)
        return max(1, expected_size - size)

    @property
    def ends_with_silence(self) -> bool:
        """Whether a silence may show a frame in the bytes so far.

        A checksum or an end delimiter confirms one after garbage that looks like the beginning of another one. Without
        them, silence shows only the end of a frame whose length nothing determines.
        """
        frames = self.frames
        if frames.end or frames.has_checksum:
            return True
        size = len(self._buffer)
        return size >= self.shortest and self._extent(self._buffer, 0) < 0

    def _extent(self, buffer: bytearray, offset: int) -> int:
        """The length of the frame that seems to begin at a byte: 0 for none, -1 where it is unknown.

        Where too few bytes are there, it is the number of those that are needed to determine it.
        """
        raise NotImplementedError

    def _goes_on(self, buffer: bytearray, offset: int) -> bool:
        """Whether a preamble continues after its least bytes, so that no frame begins with the first bytes."""
        preamble = self.frames.preamble
        return preamble is not None and buffer[offset + preamble[1]] == preamble[0]

    @staticmethod
    def _number(buffer: bytearray, offset: int, size: int, little: bool) -> int:
        if size == 1:
            return buffer[offset]
        return int.from_bytes(buffer[offset : offset + size], "little" if little else "big")

    def _read(self, buffer: bytearray, offset: int, size: int, form: Digits | Bits | None, little: bool) -> int:
        """The number of some bytes, or of some bits; for bytes that are not digits, one that no part of a frame has."""
        if form is None:
            return self._number(buffer, offset, size, little)
        if isinstance(form, tuple):
            return self._number(buffer, offset, size, little) >> form[0] & (1 << form[1]) - 1
        (number,) = form.unpack(buffer[offset : offset + size])
        return _NO_DIGITS if number is None else number

    def _foreign(self, buffer: bytearray, offset: int) -> bool:
        """Whether the parts that begin at a byte have an invalid unit address."""
        if not self.unit_addresses:
            return False
        offset += self.unit_address_offset
        # Nearly all addresses are one byte; a call for each would take as long as all the rest.
        if self._address_is_byte:
            return buffer[offset] not in self.unit_addresses
        number = self._read(buffer, offset, self.unit_address_size, self._address_form, self.little)
        return number not in self.unit_addresses

    def _holds(self, frame: bytes) -> bool:
        """Whether the end delimiter and the checksum are right."""
        frames = self.frames
        if self._marked:
            if not frame.endswith(frames.end):
                return False
            frame = frame[len(frames.start) : len(frame) - len(frames.end)]
        return frames.agrees(frame)


class LengthFramer(Framer):
    """For frames with a length, whose byte order is `length_order` where it is not that of the unit address."""

    def __init__(
        self,
        frames: Frames,
        *,
        length_size: int,
        length_order: str = "",
        length_bits: Bits | None = None,
        **common: Any,
    ) -> None:
        self.length_offset, self.length_size = frames.length_offset, length_size
        self._length_form = length_bits or frames.forms.get(frames.length_offset)
        super().__init__(frames, **common)
        self._length_is_little = length_order == "little" if length_order else self.little

    def _known(self) -> dict[int, frozenset[int]]:
        known = super()._known()
        if self.length_size == 1:
            start, end = len(self.frames.start), len(self.frames.end)
            minimum, maximum = self.shortest - start - end, min(self.longest - start - end, 255)
            known[start + self.length_offset] = frozenset(range(minimum, maximum + 1))
        return known

    def _extent(self, buffer: bytearray, offset: int) -> int:
        extent = 0
        if self._marked:
            start = self.frames.start
            if not buffer.startswith(start, offset) or self._goes_on(buffer, offset):
                return 0
            offset += len(start)
            extent = len(start) + len(self.frames.end)
        if self._foreign(buffer, offset):
            return 0
        place, size = offset + self.length_offset, self.length_size
        extent += buffer[place] if size == 1 else self._number(buffer, place, size, self._length_is_little)
        return extent if self.shortest <= extent <= self.longest else 0


class CodeFramer(Framer):
    """For frames whose code determines their length.

    `extents` has for each code: the length of the whole frame without its repeated part; then the offset and the
    size of the part or field that measures the repeated part, and the bytes for each unit of the measure; a size
    of 0 where the length is fixed, and of -1 where nothing measures the repeated part. Such a frame ends with the
    silence after it. With a size of -2, the frame ends with the next end delimiter, and has at least that length.
    After these four are the order of a measure, where it is not that of the unit address, and whether the bytes of its
    words have the opposite one.

    `subcodes` has the codes that messages of several lengths share: the offset, the size and the order of the number
    that tells these messages apart, and the extents by this number. `code_order` is the byte order of the code where it
    is not that of the unit address.
    """

    def __init__(
        self,
        frames: Frames,
        *,
        code_size: int,
        extents: dict[int, Extent],
        code_order: str = "",
        code_bits: Bits | None = None,
        subcodes: dict[int, tuple[int, int, str, dict[int, Extent]]] | None = None,
        flag: int = 0,
        refusal: Extent = (0, 0, 0, 0),
        **common: Any,
    ) -> None:
        self.code_offset, self.code_size = frames.code_offset, code_size
        self.extents, self.flag, self.refusal = extents, flag, refusal
        self.subcodes = subcodes or {}
        self._code_form = code_bits or frames.forms.get(frames.code_offset)
        self._code_is_byte = code_size == 1 and self._code_form is None
        super().__init__(frames, **common)
        self._code_is_little = code_order == "little" if code_order else self.little

    def _known(self) -> dict[int, frozenset[int]]:
        known = super()._known()
        if self._code_is_byte:
            codes = frozenset((*(code for code in range(256) if code & self.flag), *self.extents, *self.subcodes))
            known[len(self.frames.start) + self.code_offset] = codes
        return known

    def _extent(self, buffer: bytearray, offset: int) -> int:
        frame_start = offset
        if self._marked:
            if not buffer.startswith(self.frames.start, offset):
                return 0
            offset += len(self.frames.start)
        place = offset + self.code_offset
        if self._code_is_byte:
            code = buffer[place]
        else:
            code = self._read(buffer, place, self.code_size, self._code_form, self._code_is_little)
        extent: Extent | None = self.refusal if code & self.flag else self.extents.get(code)
        if extent is None and code in self.subcodes:
            subcode_offset, size, order, extents = self.subcodes[code]
            place = offset + subcode_offset
            if place + size > len(buffer):
                return 0 if self._foreign(buffer, offset) else place + size - frame_start
            extent = extents.get(self._number(buffer, place, size, order == "little"))
        if extent is None or self._foreign(buffer, offset):
            return 0
        length, size = extent[0], extent[2]
        if size == 0:
            return length
        if size == -2:
            end = buffer.find(self.frames.end, frame_start + length - len(self.frames.end))
            return end - frame_start + len(self.frames.end) if end >= 0 else -1
        if size < 0:
            return -1
        place = offset + extent[1]
        if place + size > len(buffer):
            return place + size - frame_start
        length += (buffer[place] if size == 1 else self._measure(buffer, place, extent)) * extent[3]
        return length if self.shortest <= length <= self.longest else 0

    def _measure(self, buffer: bytearray, place: int, extent: Extent) -> int:
        """The number that measures the repeated part, of several bytes."""
        if len(extent) == 4:
            return self._number(buffer, place, extent[2], self.little)
        own = bytes(buffer[place : place + extent[2]])
        return int.from_bytes(turned(own) if extent[5] else own, extent[4])


def _class(values: frozenset[int]) -> bytes:
    """The regular expression for one byte of some values, each written so that it has no meaning of its own."""
    if not values:
        return b"(?!)"
    return b"[" + b"".join(b"\\x%02x" % value for value in sorted(values)) + b"]"
