"""Reads many frames of one link and direction at once: their parts, their message, and the verdict of the codecs."""

from __future__ import annotations

import numpy as np

from fieldspec.codec.explain.row import unwrapped
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.escapes import EscapeError
from fieldspec.codec.layout.frame import original_parts
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.subcodes import Subcode, subcode
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.escape import CAN_REMOTE
from fieldspec.language.model.link import ExceptionResponse
from fieldspec.tools.captures.bodies import BodyReader, FieldRows, blame
from fieldspec.tools.captures.checksums import are_right
from fieldspec.tools.captures.columns import Bytes, Codes, Mask, Numbers, Verdicts, code_at, numbers, runs
from fieldspec.tools.captures.decoders import Decoders
from fieldspec.tools.captures.meanings import is_in
from fieldspec.tools.captures.part_numbers import lacks_digits, own_bytes, part_numbers
from fieldspec.tools.captures.verdicts import (
    INCOMPLETE,
    OK,
    REFUSED,
    UNKNOWN_CODE,
    UNKNOWN_VALUE,
    VERDICT_NUMBERS,
    WRONG_CHECKSUM,
    WRONG_LENGTH,
    WRONG_MARK,
)

NONE = -1


@dataclass(frozen=True, slots=True)
class Spans:
    """Spans of bytes in a buffer: their offsets and lengths."""

    buffer: Bytes
    at: Numbers
    length: Numbers


@dataclass(slots=True)
class ReadFrames:
    """Frames of one link and direction, one row each.

    Their parts are `length` bytes from `at` on in `buffer`, which differs from the buffer of the capture where the
    link encodes or escapes them; `sent` are the parts before escapes are undone. `message` is a place in the messages
    of the link, NONE for none; `body` and `body_size` are the bytes between header and trailer. `fields` are the
    values of messages without registers. `code` is a place among the codes of requests.
    """

    buffer: Bytes
    at: Numbers
    length: Numbers
    sent: Spans
    verdict: Verdicts
    unit_address: Numbers
    code: Numbers
    is_refused: Mask
    message: Numbers
    body: Numbers
    body_size: Numbers
    fields: list[FieldRows]


class FrameReader:
    """Reads the frames of a link in one direction. `message` is that of all frames without a code, or empty."""

    def __init__(self, layout: DeviceLayout, link: str, direction: str, decoders: Decoders, message: str = "") -> None:
        self.message = message
        self.layout, self.link, self.direction, self.decoders = layout, layout.links[link], direction, decoders
        self.shape = self.link.frame(direction)
        self.messages = list(self.link.messages.values())
        self.carried = self.link.carried(direction)
        self.has_code = self.shape.role("code") is not None
        self.is_bare = not (self.shape.is_marked or self.link.link.transmission != "binary" or self.shape.escape)
        self.bodies: dict[tuple[int, bool], BodyReader] = {}
        self.least = self.shape.header_size + self.shape.trailer_size
        self._remote = CAN_REMOTE if self.shape.escape is not None and self.shape.escape.remote is not None else 0

    def read(
        self,
        buffer: Bytes,
        offsets: Numbers,
        size: Numbers,
        request_messages: Numbers | None = None,
        judges_body: bool = True,
    ) -> ReadFrames:
        """Reads frames of `size` bytes, each from its offset on.

        `request_messages` are the messages of their requests, if these decide. Without `judges_body` only the parts are
        read, as long as it is open which message a frame is.
        """
        verdict = np.zeros(len(offsets), np.int8)
        parts = sent_parts = Spans(buffer, offsets, size)
        if not self.is_bare:
            parts, sent_parts = self._unwrapped(buffer, offsets, size, verdict)
        buffer, offsets, size = parts.buffer, parts.at, parts.length
        columns = [np.full(len(offsets), NONE) for _ in range(3)]
        frames = ReadFrames(
            buffer, offsets, size, sent_parts, verdict, columns[0], columns[1], np.zeros(len(offsets), np.bool_),
            columns[2], offsets + self.shape.header_size, np.maximum(size - self.least, 0), [],
        )  # fmt: skip
        blame(verdict, sent_parts.length < self.least, INCOMPLETE)
        for part in self.shape.digits:
            place, short = self._place(part, frames)
            blame(verdict, ~short & lacks_digits(part, buffer, place), UNKNOWN_VALUE)
        for part in self.shape.header:
            self._part(part, frames, request_messages, judges_body)
        if not self.has_code and judges_body:
            self._choose(frames, request_messages)
        if self.has_code or judges_body:
            self._read_bodies(frames)
        for part in self.shape.trailer:
            self._part(part, frames, request_messages, judges_body)
        return frames

    def _unwrapped(self, buffer: Bytes, offsets: Numbers, size: Numbers, verdict: Verdicts) -> tuple[Spans, Spans]:
        """The parts of frames with delimiters, characters or escapes, one by one, and these parts as they are sent."""
        originals, pieces = [], []
        own = self.link.link
        for row, (start, length) in enumerate(zip(offsets.tolist(), size.tolist(), strict=True)):
            frame = buffer[start : start + length].tobytes()
            parts = unwrapped(own, self.direction, frame)
            if parts.start[self.shape.surplus(frame) :] != self.shape.start:
                verdict[row] = WRONG_MARK
            data = parts.data
            pieces.append(data)
            try:
                data = original_parts(self.shape, data) if len(data) >= self.least else data
            except EscapeError:
                verdict[row] = verdict[row] or WRONG_MARK
            if not verdict[row] and (parts.reason or parts.end != self.shape.end):
                verdict[row] = VERDICT_NUMBERS.get(parts.reason, WRONG_MARK) if parts.reason else WRONG_MARK
            originals.append(data)
        sent_parts = _spans(pieces)
        return (_spans(originals) if self.shape.escape is not None else sent_parts), sent_parts

    def _part(self, part: PartLayout, frames: ReadFrames, request_messages: Numbers | None, judges_body: bool) -> None:
        """Judges a part, and copies its number to the column that the table has for it."""
        offsets, length, verdict = frames.at, frames.length, frames.verdict
        place, short = self._place(part, frames)
        blame(verdict, short, INCOMPLETE)
        if part.role == "checksum":
            covered = frames.sent if not part.before_escape else Spans(frames.buffer, offsets, length)
            blame(verdict, covered.length < self.least, INCOMPLETE)
            rows = np.flatnonzero(verdict == OK)
            if len(rows):
                right = are_right(part, covered.buffer, covered.at[rows], covered.length[rows])
                verdict[rows[~right]] = WRONG_CHECKSUM
            return
        if part.reserved or part.value is None:
            return
        number = part_numbers(part, frames.buffer, place)
        if part.role == "length":
            measured = length if part.before_escape else frames.sent.length
            blame(verdict, number * part.unit_size + part.base != measured, WRONG_LENGTH)
        elif part.role == "code":
            self._code(frames, number.view(np.uint64), request_messages, judges_body)
        elif part.role == "unit_address":
            frames.unit_address[:] = np.where(short, NONE, number)
        elif part.constant is not None or part.value.enum or part.value.flags or not part.part.same_as:
            self._own_value(part, frames, place)

    def _place(self, part: PartLayout, frames: ReadFrames) -> tuple[Numbers, Mask]:
        """Where a part begins in each frame, and which frames are too short for it."""
        if part.offset >= 0:
            return frames.at + part.offset, part.offset + part.size > frames.length
        return frames.at + frames.length + part.offset, self.least > frames.length

    def _own_value(self, part: PartLayout, frames: ReadFrames, place: Numbers) -> None:
        """A part with a value of its own, which is a value of the table unless it is always the same."""
        assert part.value is not None
        rows = np.flatnonzero(frames.verdict == OK)
        decoder = self.decoders.items[self.decoders.place(part.value, part.order, False)]
        values = decoder.decode(*own_bytes(part, frames.buffer, place[rows]))
        for number in REFUSED:
            frames.verdict[rows[values.verdict == number]] = number
        has_meaning = part.value.enum or part.value.flags or part.value.unit or part.value.scaled
        if part.constant is None and has_meaning:
            frames.fields.append(FieldRows(rows, part.name, part.value.unit, values))

    def _code(self, frames: ReadFrames, code: Codes, request_messages: Numbers | None, judges_body: bool) -> None:
        """The message of each frame by its code, and by its subcode or its request where several messages have it."""
        refusal = self.link.link.exception_response
        if refusal is not None and self.direction == "response":
            frames.is_refused[:] = self._refused(frames, code, refusal)
            code = np.where(frames.is_refused, code & ~np.uint64(refusal.flag), code)
        frames.code[:] = self._request_codes(code & ~np.uint64(self._remote))
        if refusal is not None and refusal.code is not None:
            frames.code[frames.is_refused] = NONE  # it answers any request
        places = {message.name: place for place, message in enumerate(self.messages)}
        is_open = np.zeros(len(code), np.bool_)
        for message in self.link.messages.values():
            number = message.message.code_of("response")
            if number is not None and self.link.refused_message(number) is message:
                frames.message[(code == number) & frames.is_refused] = places[message.name]
        for number in self.link.codes(self.direction):
            rows = np.flatnonzero((code == number) & ~frames.is_refused)
            messages = self.link.messages_with_code(number, self.direction)
            shared = subcode(messages, self.direction)
            if len(messages) == 1:
                frames.message[rows] = places[messages[0].name]
            elif shared is not None:
                self._by_subcode(frames, rows, shared, places)
            else:
                own = numbers([places[message.name] for message in messages])
                is_open[rows] = not judges_body
                if request_messages is not None:
                    frames.message[rows] = np.where(np.isin(request_messages[rows], own), request_messages[rows], NONE)
        blame(frames.verdict, (frames.message == NONE) & ~frames.is_refused & ~is_open, UNKNOWN_CODE)

    def _request_codes(self, code: Codes) -> Numbers:
        """The place of the code of each request, or of the request of each response; NONE for several requests."""
        places = np.full(len(code), NONE - 1)  # codes that no message has answer nothing
        own = [message.message for message in self.messages if message.message.code is not None]
        codes = list(dict.fromkeys(message.code for message in own))
        requests: dict[int | None, set[int]] = {}
        for message in own:
            number = message.code if self.direction == "request" else message.code_of("response")
            requests.setdefault(number, set()).add(codes.index(message.code))
        for number, indexes in requests.items():
            places[code == number] = indexes.pop() if len(indexes) == 1 else NONE
        return places

    def _refused(self, frames: ReadFrames, code: Codes, refusal: ExceptionResponse) -> Mask:
        """A mask of the frames that are exception responses."""
        if refusal.part:
            part = next(part for part in self.shape.header if part.name == refusal.part)
            number = part_numbers(part, frames.buffer, frames.at + part.offset)
            return np.zeros(len(code), np.bool_) if refusal.normal is None else ~is_in(number, refusal.normal.intervals)
        expected, mask = (refusal.flag, refusal.flag) if refusal.code is None else (refusal.code, 2**64 - 1)
        return np.isin(code & np.uint64(mask), [expected])

    def _by_subcode(self, frames: ReadFrames, rows: Numbers, shared: Subcode, places: dict[str, int]) -> None:
        """The messages of frames with one code. Bodies too short for a subcode count as bodies of the first message."""
        number = code_at(frames.buffer, frames.body[rows] + shared.offset, shared.size, shared.order)
        short = frames.body_size[rows] < shared.end
        for key, message in shared.messages.items():
            frames.message[rows[~short & (number == key)]] = places[message.name]
        frames.message[rows[short]] = places[next(iter(shared.messages.values())).name]

    def _choose(self, frames: ReadFrames, request_messages: Numbers | None) -> None:
        """The message of frames without a code: that of the request, or the only one with bodies of their size."""
        if request_messages is not None:
            frames.message[:] = request_messages
        self._find_marks(frames)
        open_rows = (frames.message == NONE) & ~frames.is_refused
        size = frames.body_size
        fitting = np.zeros(len(size), np.int64)
        for place, message in enumerate(self.messages):
            if message.name in self.carried and self.message in ("", message.name):
                record = message.data(self.direction)
                fits = (size >= record.least) & (True if record.most is None else size <= record.most)
                frames.message[open_rows & fits] = place
                fitting += fits
        frames.message[open_rows & (fitting != 1)] = NONE
        blame(frames.verdict, (frames.message == NONE) & ~frames.is_refused, UNKNOWN_CODE)

    def _find_marks(self, frames: ReadFrames) -> None:
        """Finds the exception responses among frames without a code, by another part or by their data."""
        refusal, mark = self.link.link.exception_response, self.link.mark
        if refusal is None or self.direction == "request":
            return
        if mark is None:
            frames.is_refused[:] = self._refused(frames, frames.code.view(np.uint64), refusal)
        else:
            rows = np.flatnonzero(frames.body_size >= mark.end)
            number = code_at(frames.buffer, frames.body[rows] + mark.offset, mark.size, mark.order)
            frames.is_refused[rows] = number == mark.number

    def _read_bodies(self, frames: ReadFrames) -> None:
        key = np.where(frames.verdict == OK, frames.message * 2 + frames.is_refused, -9)
        for number, rows in runs(key.astype(np.int16)):
            if number == -9:
                continue
            place, refused = number >> 1, bool(number & 1)
            reader = self._body(place, refused)
            if reader is None:
                continue
            verdict = frames.verdict[rows]
            for own, fields in reader.read(frames.buffer, frames.body[rows], frames.body_size[rows], verdict):
                name = "exception" if refused else self.messages[place].name
                frames.fields.append(FieldRows(rows[own], f"{name}.{fields.path}", fields.unit, fields.values))
            frames.verdict[rows] = verdict

    def _body(self, place: int, refused: bool) -> BodyReader | None:
        if (place, refused) not in self.bodies:
            refusal = self.link.link.exception_response
            if refused and refusal is not None:
                reader = BodyReader(self.layout.records[refusal.record], self.decoders, True)
            elif place >= 0:
                message = self.messages[place]
                emits = message.message.single_access is None
                reader = BodyReader(message.data(self.direction), self.decoders, emits)
            else:
                return None
            self.bodies[place, refused] = reader
        return self.bodies[place, refused]


def _spans(pieces: list[bytes]) -> Spans:
    """The spans of some pieces in a buffer that has them one after another."""
    sizes = numbers([len(piece) for piece in pieces])
    return Spans(np.frombuffer(b"".join(pieces) + b"\0", np.uint8), np.cumsum(sizes) - sizes, sizes)
