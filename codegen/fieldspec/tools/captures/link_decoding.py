"""Decodes the frames of one link of one source: cuts payloads, tells directions, pairs, and places the registers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.record import FieldLayout
from fieldspec.codec.layout.repeated_parts import repeated_parts
from fieldspec.foundation.classes import dataclass
from fieldspec.tools.captures.columns import Mask, Numbers, Verdicts, number_at, numbers, runs
from fieldspec.tools.captures.cutting import Cutter, Piece
from fieldspec.tools.captures.frame_reading import FrameReader, ReadFrames
from fieldspec.tools.captures.pairing import NO_EXCHANGES, NONE, Exchanges, joined, paired, still_open
from fieldspec.tools.captures.part_numbers import field_numbers, part_numbers, with_word_bytes
from fieldspec.tools.captures.payloads import DATAGRAM, REQUEST, RESPONSE, STREAM, UNKNOWN, Payloads, payloads_of
from fieldspec.tools.captures.register_columns import Accesses
from fieldspec.tools.captures.verdicts import MISMATCH, NO_FRAME, NO_REQUEST, OK

_FACTOR = 0x9E3779B97F4A7C15 - (1 << 64)
"""An odd number without a pattern, by which several numbers become one, modulo 2^64."""


@dataclass(frozen=True, slots=True)
class Reading:
    """How payloads read in one direction: `rows` are those that may go in it, `frames` has one row for each."""

    rows: Numbers
    frames: ReadFrames


@dataclass(slots=True)
class Frames:
    """The frames of a batch on one link. `noise` marks runs of bytes that are not a frame."""

    payloads: Payloads
    noise: Mask
    readings: dict[int, Reading] | None = None


class LinkDecoder:
    """Decodes one link of one source. `readers` are the readers of both directions, by direction."""

    def __init__(self, link: LinkLayout, readers: dict[int, FrameReader], cutter: Cutter, spaces: list[str]) -> None:
        self.link, self.readers, self.cutter, self.spaces = link, readers, cutter, spaces
        self.open = NO_EXCHANGES
        self.last: dict[int, tuple[int, int, int]] = {}
        self.repeated = repeated_parts(link)
        names_nothing = readers[REQUEST].has_code and not readers[RESPONSE].has_code
        self.asks = names_nothing or bool(link.ambiguous_codes("response"))

    def state(self) -> dict[str, Any]:
        """What another object needs to go on."""
        last = [[stream, *values] for stream, values in self.last.items()]
        columns = [column.tolist() for column in self.open.columns()]
        return {"open": columns, "cutter": self.cutter.state(), "last": last}

    def restore(self, state: dict[str, Any]) -> None:
        """Goes on where another object was."""
        self.open = Exchanges(*(numbers(column) for column in state["open"]))
        self.cutter.restore(state["cutter"])
        self.last = {stream: (direction, unit, code) for stream, direction, unit, code in state["last"]}

    def frames(self, payloads: Payloads) -> Frames:
        """The frames in payloads. Those that are one frame each are taken as columns, others are cut one by one."""
        readings = self._readings(payloads)
        whole = _whole(payloads, readings)
        cut = ~whole & (payloads.carrier != DATAGRAM)
        if not self.cutter.pending and not (cut.any() and self.cutter.cuts):
            return Frames(payloads, np.zeros(len(payloads), np.bool_), readings)
        return self._cut(payloads, cut)

    def whole(self, payloads: Payloads) -> Mask:
        """Which payloads are a valid frame."""
        return _whole(payloads, self._readings(payloads))

    def frames_anywhere(self, payloads: Payloads) -> tuple[Payloads, ...]:
        """The valid frames in payloads, in which they may begin and end anywhere. Waiting payloads keep waiting."""
        if not len(payloads):
            return ()
        own, self.cutter = self.cutter, self.cutter.another()
        try:
            parts = self.frames(payloads), self.rest()
        finally:
            self.cutter = own
        return tuple(part.payloads.at_rows(self.whole(part.payloads) & ~part.noise) for part in parts)

    def _readings(self, payloads: Payloads) -> dict[int, Reading]:
        readings = {}
        for direction, reader in self.readers.items():
            rows = np.flatnonzero((payloads.direction == direction) | (payloads.direction == UNKNOWN))
            frames = reader.read(payloads.buffer, payloads.at[rows], payloads.size[rows], judges_body=not self.asks)
            readings[direction] = Reading(rows, frames)
        return readings

    def _cut(self, payloads: Payloads, cut: Mask) -> Frames:
        """Hands payloads to the cutter where they are not a frame, and where bytes before them still wait."""
        pieces: list[tuple[int, Piece]] = []
        keep = ~cut
        keys = payloads.stream * 4 + payloads.direction + 1
        for _, own in runs(keys):
            stream, direction = int(payloads.stream[own[0]]), int(payloads.direction[own[0]])
            odd = np.flatnonzero(cut[own])
            index = 0
            while index < len(own):
                if not self.cutter.is_waiting(stream, direction):
                    following = int(np.searchsorted(odd, index))
                    if following == len(odd):
                        break
                    index = int(odd[following])
                row = int(own[index])
                keep[row] = False
                pieces += [(row, piece) for piece in self._pieces(payloads, row)]
                index += 1
        return _with_pieces(payloads, keep, pieces)

    def _pieces(self, payloads: Payloads, row: int) -> list[Piece]:
        stream, direction = int(payloads.stream[row]), int(payloads.direction[row])
        time, packet = int(payloads.time[row]), int(payloads.packet[row])
        data, follows_loss = payloads.data(row), bool(payloads.follows_loss[row])
        return self.cutter.feed(stream, direction, data, time, packet, follows_loss, payloads.carrier[row] == STREAM)

    def rest(self) -> Frames:
        """The remaining payloads at the end of the source."""
        nothing = payloads_of([])
        return _with_pieces(nothing, np.zeros(0, np.bool_), [(0, piece) for piece in self.cutter.finish()])

    def decoded(self, frames: Frames, first: Numbers) -> LinkFrames:
        """Frames with their directions, requests and registers. `first` has the number of each frame in the source."""
        payloads = frames.payloads
        readings = frames.readings or self._readings(payloads)
        rows = _Rows(payloads, frames.noise)
        direction = self._directions(payloads, readings, frames.noise)
        for side, reading in readings.items():
            own = np.flatnonzero(direction[reading.rows] == side)
            rows.take(side, reading, own)
        for side in (REQUEST, RESPONSE):  # payloads whose direction nothing tells keep the verdict that comes closest
            reading = readings[side]
            lost = np.flatnonzero(direction[reading.rows] == UNKNOWN)
            closer = reading.frames.verdict[lost] > rows.verdict[reading.rows[lost]]
            rows.verdict[reading.rows[lost[closer]]] = reading.frames.verdict[lost[closer]]
        rows.verdict[frames.noise] = NO_FRAME
        self._exchange(rows, direction, first, readings)
        return rows.result(direction)

    def _directions(self, payloads: Payloads, readings: dict[int, Reading], noise: Mask) -> Numbers:
        """The direction of each payload: what the medium says, or what the bytes allow, or what came before."""
        direction: Numbers = payloads.direction.copy()
        fits = {}
        for side, reading in readings.items():
            fits[side] = np.zeros(len(payloads), np.bool_)
            fits[side][reading.rows] = reading.frames.verdict == OK
        is_open = (direction == UNKNOWN) & ~noise
        direction[is_open & fits[REQUEST] & ~fits[RESPONSE]] = REQUEST
        direction[is_open & fits[RESPONSE] & ~fits[REQUEST]] = RESPONSE
        ambiguous = np.flatnonzero(is_open & fits[REQUEST] & fits[RESPONSE])
        if not len(ambiguous):
            return direction
        unit, code = np.full((2, len(payloads)), NONE), np.full((2, len(payloads)), NONE)
        for side, reading in readings.items():
            unit[side, reading.rows], code[side, reading.rows] = reading.frames.unit_address, reading.frames.code
        last = dict(self.last)
        undecided = set(ambiguous.tolist())
        fitting = np.flatnonzero(fits[REQUEST] | fits[RESPONSE]).tolist()
        for row in fitting:
            stream = int(payloads.stream[row])
            if row in undecided:
                before = last.get(stream, (RESPONSE, NONE, NONE))
                answered_code = int(unit[RESPONSE, row]), int(code[RESPONSE, row])
                is_answer = before[0] == REQUEST and all(map(_fits, before[1:], answered_code))
                direction[row] = RESPONSE if is_answer else REQUEST
            side = int(direction[row])
            last[stream] = side, int(unit[side, row]), int(code[side, row])
        self.last = last
        return direction

    def _exchange(self, rows: _Rows, direction: Numbers, first: Numbers, readings: dict[int, Reading]) -> None:
        """Pairs the valid frames, and gives responses what only their requests say."""
        self._own_accesses(rows, direction)
        own_accord = [place for place, own in enumerate(self.link.messages.values()) if not own.message.is_requested]
        is_exchange = ~(np.isin(rows.message, own_accord) & (direction == RESPONSE))
        valid = np.flatnonzero((rows.verdict == OK) & (direction != UNKNOWN) & is_exchange)
        repeated = np.full(len(valid), NONE)
        payloads = rows.payloads
        for request_part, response_part in self.repeated:
            repeated *= _FACTOR
            for side, part in ((REQUEST, request_part), (RESPONSE, response_part)):
                own = direction[valid] == side
                repeated[own] += part_numbers(part, rows.buffer(side), rows.parts[valid[own]] + part.offset)
        current = Exchanges(
            payloads.stream[valid], direction[valid], repeated, rows.unit_address[valid], rows.code[valid],
            rows.message[valid], first[valid], payloads.time[valid], rows.address[valid], rows.count[valid],
        )  # fmt: skip
        exchanges = joined(self.open, current)
        requests = paired(exchanges)
        before = len(self.open.stream)
        self.open = still_open(exchanges, requests)
        own = requests[before:]
        answers = np.flatnonzero(own != NONE)
        asked_rows, targets = own[answers], valid[answers]
        rows.request[targets] = exchanges.number[asked_rows]
        delays = exchanges.time[before:][answers] - exchanges.time[asked_rows]
        timed = (exchanges.time[before:][answers] >= 0) & (exchanges.time[asked_rows] >= 0)
        rows.delay[targets[timed]] = delays[timed]
        if self.asks:
            asked_message = np.full(len(payloads), NONE)
            asked_message[targets] = exchanges.message[asked_rows]
            self._reread(rows, direction, readings, asked_message)
        nameless = rows.is_refused[targets] & (rows.message[targets] == NONE)
        rows.message[targets[nameless]] = exchanges.message[asked_rows[nameless]]
        self._place(rows, direction, targets, exchanges.address[asked_rows], exchanges.count[asked_rows])

    def _reread(self, rows: _Rows, direction: Numbers, readings: dict[int, Reading], asked_message: Numbers) -> None:
        """Reads bodies again: bodies of responses by the message of the request."""
        for side, reader in self.readers.items():
            own = np.flatnonzero((direction == side) & (rows.verdict == OK))
            offsets, size = rows.payloads.at[own], rows.payloads.size[own]
            request_messages = asked_message[own] if side == RESPONSE else None
            frames = reader.read(rows.payloads.buffer, offsets, size, request_messages=request_messages)
            rows.take(side, Reading(own, frames), np.arange(len(own)))
        self._own_accesses(rows, direction)

    def _own_accesses(self, rows: _Rows, direction: Numbers) -> None:
        """The address and the number of registers that frames state themselves."""
        for place, message in enumerate(self.link.messages.values()):
            access = message.message.single_access
            if access is None:
                continue
            for side, name in ((REQUEST, "request"), (RESPONSE, "response")):
                own = np.flatnonzero((rows.message == place) & (direction == side) & (rows.verdict == OK))
                own = own[~rows.is_refused[own]]
                if not len(own):
                    continue
                record = message.data(name)
                for field_name, column in ((access.start, rows.address), (access.count, rows.count)):
                    field = record.named(field_name) if field_name else None
                    if field is not None:
                        column[own] = field_numbers(field, rows.buffer(side), rows.body[own])
                if not access.count:
                    values = record.named(access.values)
                    holder = message.request if access.operation == "write" else message.response
                    carried = holder.named(access.values)
                    if values is not None and values.field.repeat is not None:
                        rows.count[own] = np.maximum((rows.body_size[own] - values.offset) // values.size, 1)
                    elif carried is None or carried.field.repeat is None:
                        rows.count[own] = 1

    def _place(self, rows: _Rows, direction: Numbers, targets: Numbers, address: Numbers, count: Numbers) -> None:
        """Gives responses the registers of their requests, and finds the data of all frames that carry some."""
        requested = np.full((2, len(direction)), NONE)
        requested[0, targets], requested[1, targets] = address, count
        for place, message in enumerate(self.link.messages.values()):
            access = message.message.single_access
            if access is None:
                continue
            is_bits = access.space in self.spaces
            for side, name in ((REQUEST, "request"), (RESPONSE, "response")):
                own = np.flatnonzero((rows.message == place) & (direction == side) & (rows.verdict == OK))
                if side == RESPONSE:
                    self._compare(rows, own, requested)
                    own = own[rows.verdict[own] == OK]
                own = own[~rows.is_refused[own]]
                field = message.data(name).named(access.values)
                if not len(own) or field is None or (side == RESPONSE and access.operation == "write"):
                    continue
                rows.verdict[own[rows.address[own] == NONE]] = NO_REQUEST
                own = own[rows.address[own] != NONE]
                rows.data[own] = rows.body[own] + field.offset
                sizes = np.maximum(rows.body_size[own] - field.offset, 0)
                if field.count is not None:
                    sizes = np.minimum(sizes, field.size * field.count)
                rows.data_size[own] = sizes
                if side == RESPONSE:
                    count_of = rows.count[own]
                    size = 0 if field.value is None else field.value.size
                    expected = (count_of + 7) // 8 if is_bits else size * count_of
                    rows.verdict[own[(sizes != expected)]] = MISMATCH
                if access.set is not None:  # another number than those of 1 and 0 says nothing about the bit
                    number = number_at(rows.buffer(side), rows.data[own], field.size, field.order)
                    rows.data[own[(number != access.set) & (number != access.clear)]] = NONE
                    rows.set_bit[own] = number == access.set

    @staticmethod
    def _compare(rows: _Rows, own: Numbers, requested: Numbers) -> None:
        """Completes responses by their requests; one that states another address or number does not fit."""
        for column, stated in ((rows.address, requested[0, own]), (rows.count, requested[1, own])):
            differs = (stated != NONE) & (column[own] != NONE) & (column[own] != stated) & ~rows.is_refused[own]
            rows.verdict[own[differs]] = MISMATCH
            column[own] = np.where(stated != NONE, stated, column[own])


class _Rows:
    """The columns of frames while they are decoded."""

    def __init__(self, payloads: Payloads, noise: Mask) -> None:
        size = len(payloads)
        self.payloads, self.noise = payloads, noise
        self.verdict: Verdicts = np.zeros(size, np.int8)
        none = (np.full(size, NONE) for _ in range(12))
        self.parts, self.body, self.unit_address, self.code, self.message, self.address, self.count = (
            next(none) for _ in range(7)
        )
        self.request, self.delay, self.data, self.data_size, self.set_bit = (next(none) for _ in range(5))
        self.body_size = np.zeros(size, np.int64)
        self.is_refused = np.zeros(size, np.bool_)
        self.readings: dict[int, list[tuple[Reading, Numbers]]] = {REQUEST: [], RESPONSE: []}

    def buffer(self, direction: int) -> npt.NDArray[np.uint8]:
        """The buffer with the parts of the frames in one direction."""
        return self.readings[direction][-1][0].frames.buffer if self.readings[direction] else self.payloads.buffer

    def take(self, direction: int, reading: Reading, own: Numbers) -> None:
        """Takes over some rows of a reading."""
        frames, rows = reading.frames, reading.rows[own]
        self.verdict[rows], self.parts[rows], self.body[rows] = frames.verdict[own], frames.at[own], frames.body[own]
        self.unit_address[rows], self.code[rows] = frames.unit_address[own], frames.code[own]
        self.message[rows], self.body_size[rows] = frames.message[own], frames.body_size[own]
        self.is_refused[rows] = frames.is_refused[own]
        self.readings[direction] = [(reading, own)]

    def result(self, direction: Numbers) -> LinkFrames:
        """The frames as columns."""
        return LinkFrames(self.payloads, direction, self)


@dataclass(frozen=True, slots=True)
class LinkFrames:
    """Decoded frames of one link, one row each, in the order of the capture."""

    payloads: Payloads
    direction: Numbers
    rows: _Rows

    def accesses(self, messages: Mapping[int, FieldLayout], is_write: bool) -> tuple[npt.NDArray[np.uint8], Accesses]:
        """The registers that frames of some messages carry, and the buffer with their bytes. `messages` are the fields
        with the words, by the place of the message.
        """
        rows = self.rows
        direction = REQUEST if is_write else RESPONSE
        own = np.flatnonzero((rows.verdict == OK) & (rows.data != NONE) & np.isin(rows.message, list(messages)))
        own = own[self.direction[own] == direction]
        buffer, data, available = rows.buffer(direction), rows.data[own], rows.data_size[own]
        single = rows.set_bit[own] != NONE
        if single.any():
            bits = (rows.set_bit[own] == 1).astype(np.uint8)
            data = np.where(single, len(buffer) + np.arange(len(own)), data)
            buffer, available = np.concatenate([buffer, bits]), np.where(single, 1, available)
        buffer = with_word_bytes(messages, rows.message[own], buffer, data, available)
        writes = np.full(len(own), is_write)
        return buffer, Accesses(own, rows.address[own], rows.count[own], data, available, writes)


def _whole(payloads: Payloads, readings: dict[int, Reading]) -> Mask:
    """Which payloads are a valid frame in a direction that they may have."""
    whole = np.zeros(len(payloads), np.bool_)
    for reading in readings.values():
        whole[reading.rows] |= reading.frames.verdict == OK
    return whole


def _with_pieces(payloads: Payloads, keep: Mask, pieces: list[tuple[int, Piece]]) -> Frames:
    """The payloads that stay, and what the others have been cut into, in the order of the payloads."""
    own = payloads.at_rows(keep)
    cut = payloads_of(
        [(piece.data, piece.time, piece.packet, piece.stream, piece.direction) for _, piece in pieces],
        is_datagram=False,
    )
    noise = np.concatenate(
        [
            np.zeros(len(own), np.bool_),
            np.array([not (piece.is_frame or piece.is_payload) for _, piece in pieces], np.bool_),
        ]
    )
    order = np.argsort(np.concatenate([own.packet, cut.packet]), kind="stable")
    columns = [
        np.concatenate(pair)[order]
        for pair in (
            (own.at, cut.at + len(own.buffer)),
            (own.size, cut.size),
            (own.time, cut.time),
            (own.packet, cut.packet),
            (own.stream, cut.stream),
            (own.direction, cut.direction),
        )
    ]
    carrier = np.concatenate([own.carrier, cut.carrier])[order]
    lost = np.concatenate([own.follows_loss, cut.follows_loss])[order]
    joined_buffer = np.concatenate([own.buffer, cut.buffer])
    return Frames(Payloads.of_columns(joined_buffer, columns, carrier, lost), noise[order])


def _fits(request_number: int, response_number: int) -> bool:
    """Whether a unit address, or a code, of a response is that of a request, or one of them carries none."""
    return request_number == response_number or NONE in (request_number, response_number)
