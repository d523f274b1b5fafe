"""Random streams of bytes for framers, and the frames that the documentation promises for them.

A stream of right frames says which frames come out of it: those that went in. Where an end delimiter ends frames, and
a part of one is a right frame itself, the shorter one comes out; what comes after it is open.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.first_bytes import first_bytes
from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.reference import CodecError, codec
from random_devices.inputs import header_values, record_values, sealed, spoiled

FRAMES = 10
"""The frames of each message in one direction, at most."""
_LONGEST = 400
"""The bytes of the frames that are drawn: each is cut at every byte."""


@dataclass(frozen=True)
class RightFrame:
    """A frame that the reference decodes. `is_sized`: its beginning says how long it is."""

    data: bytes
    is_sized: bool


@dataclass(frozen=True)
class Stream:
    """Pieces of bytes for the framer of a link in one direction; None is a silence, in which `idle` is called.

    `expected` are the frames that come out, None where nothing is promised. With `goes_on` they are the first ones.
    `noise` are the bytes of no frame, None where nothing says how many there are. `ends` are the places in the stream
    at which frames end, where it has no silence and no noise.
    """

    link: str
    direction: str
    pieces: tuple[bytes | None, ...]
    expected: tuple[bytes, ...] | None = None
    goes_on: bool = False
    noise: int | None = None
    ends: tuple[int, ...] = ()


@dataclass
class Line:
    """A link in one direction with its right frames."""

    layout: DeviceLayout
    link: LinkLayout
    direction: str
    frames: list[RightFrame] = field(default_factory=list)

    @property
    def frame(self) -> FrameLayout:
        """The parts of the frames."""
        return self.link.frame(self.direction)

    @property
    def ending(self) -> str:
        """What ends frames, as the table of `docs/python.md` has it; empty where a link has no framer."""
        frame = self.frame
        is_whole = frame.escape is not None and (frame.escape_start, frame.escape_stop) == (0, None)
        if self.link.link.transmission == "hex_ascii" or is_whole:
            return "delimiters" if frame.end and (frame.start or is_whole) else ""
        length = frame.role("length")
        if frame.escape is not None and (length is None or length.before_escape):
            return ""
        if length is not None:
            return "length"
        if frame.end:
            return "end"
        return "code" if frame.role("code") is not None else ""

    def decodes(self, data: bytes) -> bool:
        """Whether the link decodes some bytes as a frame of any message, and the unit address is one of the line."""
        reference = codec(self.layout).links[self.link.name]
        for message in ("", *self.link.carried(self.direction)):
            try:
                decoded = reference.decode(data, self.direction, message)
            except CodecError:
                continue
            return self.is_addressed(decoded.head)
        return False

    def is_addressed(self, head: dict[str, int]) -> bool:
        """Whether frames in this direction have the unit address of a head."""
        part, addresses = self.frame.role("unit_address"), self.link.link.unit_addresses
        if part is None or addresses is None or addresses.ranges is None:
            return True
        return any(low <= head[part.name] <= high for low, high in addresses.intervals(self.direction))

    def is_sized(self, message: str, is_exception: bool) -> bool:
        """Whether the code, a subcode or a count in the data determines the size of a frame."""
        error = self.link.link.exception_response if self.direction == "response" else None
        if is_exception:
            assert error is not None
            record = self.layout.records[error.record]
            return not error.part and _has_size(record)
        own = self.link.messages[message]
        code = own.message.code_of(self.direction)
        same = self.link.messages_with_code(code, self.direction) if code is not None else []
        records = [other.data(self.direction) for other in same]
        if error is not None and error.part:
            records.append(self.layout.records[error.record])
        has_subcode = len(records) == len(same) and code in self.link.subcodes(self.direction)
        is_same = all(record.size is not None and record.size == records[0].size for record in records[1:])
        return bool(records) and (is_same or has_subcode) and _has_size(own.data(self.direction))


def _has_size(record: RecordLayout) -> bool:
    """Whether a record has one size, or a count of the only part of it that has more."""
    if record.size is not None:
        return True
    last = record.fields[-1]
    if record.spans:
        return record.count_of_text is not None
    measures = [f for f in record.fields if f.field.measures is not None and f.field.measures.field == last.name]
    return any(map(record.has_place, measures)) and record.has_single_list and not last.cases


def lines(layout: DeviceLayout, dice: random.Random) -> Iterator[Line]:
    """The links of a device in both directions, with right frames of all their messages."""
    for link in layout.links.values():
        for direction in ("request", "response"):
            line = Line(layout, link, direction)
            for message in link.carried(direction):
                line.frames += _right_frames(line, message, False, dice)
            if direction == "response" and link.link.exception_response is not None:
                for message in link.exchanged:
                    line.frames += _right_frames(line, message, True, dice)
            yield line


def _right_frames(line: Line, message: str, is_exception: bool, dice: random.Random) -> Iterator[RightFrame]:
    error = line.link.link.exception_response
    layout, name, frame = line.layout, line.link.name, line.frame
    record = layout.messages[message].data(line.direction)
    if is_exception and error is not None:
        record = layout.records[error.record]
    reference = codec(layout).links[name]
    own = layout.messages[message].message
    code = own.code_of(line.direction) if frame.role("code") is not None else None
    is_sized = line.is_sized(message, is_exception)
    for _ in range(FRAMES):
        values = {**header_values(layout, name, frame, dice), **record_values(layout, record, dice)}
        try:
            data = reference.encode(line.direction, message, values, error=is_exception, code=code)
        except CodecError:
            continue
        if dice.random() < 0.5:
            data = _salted(line, data, message, dice)
        try:
            head = reference.decode(data, line.direction, message).head
        except CodecError:
            continue
        if line.is_addressed(head) and len(data) <= _LONGEST:
            yield RightFrame(data, is_sized)


def _salted(line: Line, data: bytes, message: str, dice: random.Random) -> bytes:
    """A frame with bytes of delimiters in its body, if the link decodes it; else the same frame."""
    reference = codec(line.layout).links[line.link.name]
    marks = line.frame.end or b"\r\n", line.frame.end + line.frame.start or b"\r"
    parts = bytearray(reference.original_parts(data, line.direction))
    first, stop = line.frame.header_size, len(parts) - line.frame.trailer_size
    for _ in range(dice.randint(1, 2) if stop > first else 0):
        mark, at = dice.choice(marks), dice.randrange(first, stop)
        parts[at:stop] = (mark + parts[at + len(mark) : stop])[: stop - at]
    changed = sealed(line.layout, line.link.name, line.frame, bytes(parts), dice)
    try:
        before = reference.decode(data, line.direction, message)
        after = reference.decode(changed, line.direction, message)
    except CodecError:
        return data
    same = (before.error, before.message) == (after.error, after.message)
    return changed if same else data


def streams(layout: DeviceLayout, dice: random.Random) -> Iterator[Stream]:
    """Streams for all framers of a device."""
    for line in lines(layout, dice):
        if not line.ending or not line.frames:
            continue
        sized = [each for each in line.frames if each.is_sized]
        if line.ending != "code" or len(sized) == len(line.frames):
            yield from _right_streams(line, line.frames, False, dice)
        else:
            yield from _right_streams(line, line.frames, True, dice)
            if sized:
                yield from _right_streams(line, sized, False, dice)
        yield from _damaged_streams(line, dice)


def _right_streams(line: Line, choices: list[RightFrame], is_silent: bool, dice: random.Random) -> Iterator[Stream]:
    """Right frames, whole, byte by byte and in random pieces, without noise and with it.

    With `is_silent`, each frame ends with a silence.
    """
    noise = _noise(line)
    for has_noise in (False, True) if noise else (False,):
        frames = [each.data for each in dice.choices(choices, k=dice.randint(2, 8))]
        expected, goes_on = _expected(line, frames)
        gaps = [
            _some(noise, dice) if has_noise and not (number and dice.random() < 0.5) else b""
            for number in range(len(frames))
        ]
        blocks = [gap + frame for gap, frame in zip(gaps, frames, strict=True)]
        for cut in (_whole, _single_bytes, _random_pieces):
            pieces: list[bytes | None] = []
            for block in blocks if is_silent else [b"".join(blocks)]:
                pieces += cut(block, dice)
                pieces += [None] * is_silent
            pieces += [None]
            lengths = [sum(map(len, frames[:number])) for number in range(1, len(frames) + 1)]
            is_even = not (has_noise or is_silent or goes_on)
            yield Stream(
                line.link.name,
                line.direction,
                tuple(pieces),
                expected=tuple(expected),
                goes_on=goes_on,
                noise=None if goes_on else sum(map(len, gaps)),
                ends=tuple(lengths) if is_even else (),
            )


def _expected(line: Line, frames: list[bytes]) -> tuple[list[bytes], bool]:
    """The frames that come out of right ones: at each end delimiter, the first one with which the link decodes them.

    Also whether other frames may come after these, since the last one is only a part of that which went in.
    """
    if line.ending != "end":
        return frames, False
    expected: list[bytes] = []
    end = line.frame.end
    for frame in frames:
        at = frame.find(end)
        while at >= 0 and not line.decodes(frame[: at + len(end)]):
            at = frame.find(end, at + 1)
        expected.append(frame[: at + len(end)])
        if expected[-1] != frame:
            return expected, True
    return expected, False


def _noise(line: Line) -> list[bytes]:
    """Noise with which no frame begins, and after which frames are recognized; empty where there is none."""
    frame, preamble = line.frame, line.link.link.preamble
    if preamble is not None:
        others = {preamble.byte, *frame.start, *line.link.link.opening(line.direction)}
        return [bytes([byte]) for byte in range(256) if byte not in others]
    if frame.start:
        return [bytes([byte]) for byte in range(256) if byte != frame.start[0]]
    if line.ending == "delimiters":
        return [] if line.decodes(frame.end) else [frame.end]  # an empty frame is one where data may be empty
    if line.ending == "length" and frame.header[0].role == "code":
        return []  # a length is not a sign of a code that no message has
    known = first_bytes(line.link, line.direction).get(0)
    return [] if known is None else [bytes([byte]) for byte in range(256) if byte not in known]


def _some(noise: list[bytes], dice: random.Random) -> bytes:
    return b"".join(dice.choices(noise, k=dice.randint(1, 4)))


def _whole(block: bytes, dice: random.Random) -> list[bytes]:
    return [block]


def _single_bytes(block: bytes, dice: random.Random) -> list[bytes]:
    return [bytes([byte]) for byte in block]


def _random_pieces(block: bytes, dice: random.Random) -> list[bytes]:
    cuts = sorted(dice.choices(range(len(block) + 1), k=dice.randint(0, 8)))
    return [block[first:last] for first, last in pairwise([0, *cuts, len(block)])]


def _damaged_streams(line: Line, dice: random.Random) -> Iterator[Stream]:
    """Whole and damaged frames, random bytes and silences, of which nothing is promised."""
    for _ in range(3):
        pieces: list[bytes | None] = []
        for _ in range(dice.randint(2, 8)):
            block = dice.choice(line.frames).data
            draw = dice.random()
            if draw < 0.3:
                block = spoiled(block, dice)
            elif draw < 0.5:
                marks = line.frame.start + line.frame.end + block[:3]
                block = bytes(dice.choice((*marks, dice.randrange(256))) for _ in range(dice.randint(1, 20)))
            pieces += _random_pieces(block, dice)
            pieces += [None] * (dice.random() < 0.25)
        yield Stream(line.link.name, line.direction, (*pieces, None))
