"""Decodes payloads of one device into the columns of the tables of frames and of values."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np
import numpy.typing as npt

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.address_space import BIT
from fieldspec.tools.captures.columns import Numbers, Texts, Verdicts, gathered, numbers, runs
from fieldspec.tools.captures.cutting import Cutter
from fieldspec.tools.captures.decoders import Decoders, ValueColumns
from fieldspec.tools.captures.detection import Detection
from fieldspec.tools.captures.frame_reading import FrameReader
from fieldspec.tools.captures.link_decoding import LinkDecoder, LinkFrames
from fieldspec.tools.captures.pairing import NONE
from fieldspec.tools.captures.payloads import DIRECTION_CODES, REQUEST, RESPONSE, UNKNOWN, Names, Payloads
from fieldspec.tools.captures.register_columns import RegisterMap, spaces_of
from fieldspec.tools.captures.text_list import TextList
from fieldspec.tools.captures.verdicts import MISMATCH, OK

DIRECTIONS = {REQUEST: "request", RESPONSE: "response"}
MOST_TEXTS = 1 << 17
"""The texts that are remembered from one part of the tables to the next."""

FOREIGN = "packets of connections without a frame of the device"


@dataclass(frozen=True, slots=True)
class FrameTable:
    """The columns of the table of frames. Columns of texts have places in the list of texts, or -1."""

    number: Numbers
    packet: Numbers
    time: Numbers
    stream: Texts
    link: Texts
    direction: Texts
    message: Texts
    exception: Texts
    unit_address: Numbers
    space: Texts
    address: Numbers
    count: Numbers
    request: Numbers
    delay: Numbers
    verdict: Verdicts
    bytes: tuple[npt.NDArray[np.uint8], Numbers]
    data: tuple[npt.NDArray[np.uint8], Numbers]
    has_data: npt.NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class ValueTable:
    """The columns of the table of values. `frame` is the row of the frame in the same batch."""

    frame: Numbers
    operation: Texts
    space: Texts
    address: Numbers
    register: Texts
    unit: Texts
    values: ValueColumns


@dataclass(frozen=True, slots=True)
class Batch:
    """The tables of frames and of their values."""

    frames: FrameTable
    values: ValueTable


@dataclass(frozen=True, slots=True)
class Choices:
    """The user's options: the link, empty to detect it; the message of frames without a code; the unit addresses, empty
    for all; and the direction of payloads for which the source tells none.
    """

    link: str = ""
    message: str = ""
    direction: str = ""
    units: frozenset[int] = frozenset()


class DeviceDecoder:
    """What all sources of one device share: readers, register maps, and the list of texts."""

    def __init__(self, layout: DeviceLayout, choices: Choices) -> None:
        self.layout, self.choices = layout, choices
        self.links = [choices.link] if choices.link else list(layout.links)
        self.reset()

    def reset(self) -> None:
        """Forgets all texts."""
        layout, choices = self.layout, self.choices
        self.texts = TextList()
        self.decoders = Decoders(layout.device, self.texts)
        self.readers = {
            link: {
                direction: FrameReader(layout, link, name, self.decoders, choices.message)
                for direction, name in DIRECTIONS.items()
            }
            for link in self.links
        }
        self.spaces = spaces_of(layout)
        self.maps = {space: RegisterMap(layout, space, self.decoders) for space in self.spaces}
        self.bit_spaces = [space for space in self.spaces if layout.device.space(space).unit == BIT]
        self.names: dict[str, Texts] = {}
        self.units: dict[str, Texts] = {}

    def place(self, text: str) -> int:
        """The place of a text; -1 for an empty one."""
        return self.texts.place(text) if text else NONE

    def register_names(self, space: str, places: Numbers) -> tuple[Texts, Texts]:
        """The places of the texts with the names and the units of registers."""
        own = self.maps[space]
        if space not in self.names:
            self.names[space] = np.full(len(own.address), -2, np.int32)
            self.units[space] = np.full(len(own.address), -1, np.int32)
        names, units = self.names[space], self.units[space]
        result = names[places]
        if (result == -2).any():
            for place in np.unique(places[result == -2]).tolist():
                names[place] = self.texts.place(own.name(place))
                units[place] = self.place(own.unit(place))
            result = names[places]
        return result, units[places]


class SourceDecoder:
    """Decodes one source. `names` are its connections; `skipped` counts what is left out."""

    def __init__(self, device: DeviceDecoder, names: Names) -> None:
        self.device, self.names = device, names
        layout = device.layout
        self.links = {
            link: LinkDecoder(layout.links[link], device.readers[link], Cutter(layout, link), device.bit_spaces)
            for link in device.links
        }
        self.detection = Detection(self.links)
        self.number = 0
        self.skipped: dict[str, int] = {}

    def state(self) -> dict[str, Any]:
        """The state from which another decoder continues."""
        return {
            "number": self.number,
            "detection": self.detection.state(),
            "links": {name: link.state() for name, link in self.links.items()},
        }

    def restore(self, state: dict[str, Any]) -> None:
        """Continues from the state of another decoder."""
        self.number = state["number"]
        self.detection.restore(state["detection"])
        for name, link in self.links.items():
            link.restore(state["links"][name])

    def refresh(self) -> None:
        """Takes the readers of the device again, after it has forgotten its texts."""
        for name, link in self.links.items():
            link.readers = self.device.readers[name]

    def decode(self, payloads: Payloads) -> list[Batch]:
        """The frames in payloads and their values, a batch for each link."""
        batches = []
        if self.device.choices.direction:
            open_rows = payloads.direction == UNKNOWN
            payloads.direction[open_rows] = DIRECTION_CODES[self.device.choices.direction]
        if self.device.choices.link:
            places = np.zeros(len(payloads), np.int64)
        else:
            payloads, places = self.detection.with_links(payloads)
        for place, rows in runs(places):
            if place < 0:
                self._skip_foreign(len(rows))
                continue
            link = self.links[self.device.links[place]]
            own = payloads if len(rows) == len(payloads) else payloads.at_rows(rows)
            batches += self._batch(link, link.frames(own))
        return batches

    def rest(self) -> list[Batch]:
        """The batches of the payloads that are pending at the end of the source."""
        self._skip_foreign(self.detection.rest())
        return [batch for link in self.links.values() for batch in self._batch(link, link.rest())]

    def _skip_foreign(self, count: int) -> None:
        if count:
            self.skipped[FOREIGN] = self.skipped.get(FOREIGN, 0) + count

    def _batch(self, link: LinkDecoder, frames: Any) -> list[Batch]:
        if not len(frames.payloads):
            return []
        first = np.arange(self.number + 1, self.number + 1 + len(frames.payloads))
        self.number += len(first)
        decoded = link.decoded(frames, first)
        return [tables(self.device, link, decoded, first, self.names)]


def tables(device: DeviceDecoder, link: LinkDecoder, decoded: LinkFrames, numbers_of: Numbers, names: Names) -> Batch:
    """The tables of frames and of values of the decoded frames of a link."""
    rows, payloads = decoded.rows, decoded.payloads
    messages = list(link.link.messages.values())
    message_places = np.array([*(device.texts.place(message.name) for message in messages), NONE], np.int32)
    own_device = device.layout.device
    accesses = [message.message.single_access for message in messages]
    spaces = [NONE if access is None else device.place(own_device.space_name(access.space)) for access in accesses]
    space_places = np.array([*spaces, NONE], np.int32)
    words = np.array([device.place(DIRECTIONS[REQUEST]), device.place(DIRECTIONS[RESPONSE]), NONE], np.int32)
    stream_places = np.array([device.texts.place(text) for text in names.texts], np.int32)
    is_selected = np.ones(len(numbers_of), np.bool_)
    if device.choices.units:
        is_selected = (rows.unit_address == NONE) | np.isin(rows.unit_address, sorted(device.choices.units))
    values = _values(device, link, decoded, is_selected)
    accessed = rows.address != NONE
    is_valid = np.isin(rows.verdict, (OK, MISMATCH))
    data_at = np.where(rows.data != NONE, rows.data, rows.body)
    data_size = np.where(rows.data != NONE, rows.data_size, rows.body_size)
    has_data = is_valid & (rows.message != NONE) & ((rows.data != NONE) | ~accessed) & ~rows.is_refused
    exception = np.full(len(numbers_of), NONE, np.int32)
    for direction in (REQUEST, RESPONSE):
        for reading, _ in rows.readings[direction]:
            for fields in reading.frames.fields:
                if fields.path.startswith("exception."):
                    own_rows = reading.rows[fields.frame]
                    exception[own_rows] = np.where(
                        fields.values.text >= 0, fields.values.text, _numbers_as_text(device, fields.values)
                    )
    table = FrameTable(
        numbers_of, payloads.packet, payloads.time, stream_places[payloads.stream],
        np.full(len(numbers_of), device.texts.place(link.link.name), np.int32), words[decoded.direction],
        message_places[rows.message], exception, rows.unit_address, space_places[rows.message], rows.address,
        np.where(accessed, rows.count, NONE), rows.request, rows.delay, rows.verdict,
        gathered(payloads.buffer, payloads.at, payloads.size),
        _data(decoded, data_at, np.where(has_data, data_size, 0)), has_data,
    )  # fmt: skip
    return Batch(table, values)


def _numbers_as_text(device: DeviceDecoder, values: ValueColumns) -> Texts:
    """The texts of numbers that have no names."""
    return np.array([device.texts.place(str(number)) for number in values.raw.tolist()], np.int32)


def _data(decoded: LinkFrames, starts: Numbers, size: Numbers) -> tuple[npt.NDArray[np.uint8], Numbers]:
    """The bytes of the data of each frame. The parts of the two directions may be in buffers of their own."""
    buffers = [decoded.rows.buffer(direction) for direction in (REQUEST, RESPONSE)]
    if buffers[0] is buffers[1]:
        return gathered(buffers[0], starts, size)
    shift = np.where(decoded.direction == RESPONSE, len(buffers[0]), 0)
    return gathered(np.concatenate(buffers), starts + shift, size)


def _values(
    device: DeviceDecoder, link: LinkDecoder, decoded: LinkFrames, is_selected: npt.NDArray[np.bool_]
) -> ValueTable:
    """All values of frames, in the order of the frames."""
    parts: list[ValueTable] = []
    rows = decoded.rows
    messages = list(link.link.messages.values())
    for operation in ("read", "write"):
        by_space: dict[str, dict[int, FieldLayout]] = {}
        for place, message in enumerate(messages):
            access = message.message.single_access
            record = message.request if operation == "write" else message.response
            field = record.named(access.values) if access is not None and access.operation == operation else None
            if access is not None and field is not None:
                by_space.setdefault(device.layout.device.space_name(access.space), {})[place] = field
        for space, fields_by_message in by_space.items():
            if space not in device.maps:
                continue
            buffer, accesses = decoded.accesses(fields_by_message, operation == "write")
            if not len(accesses.frame):
                continue
            registers = device.maps[space].rows(buffer, accesses)
            names, units = device.register_names(space, registers.register)
            size = len(names)
            parts.append(
                ValueTable(
                    registers.frame,
                    np.full(size, device.place(operation), np.int32),
                    np.full(size, device.place(space), np.int32),
                    registers.address,
                    names,
                    units,
                    registers.values,
                )
            )
    for direction in (REQUEST, RESPONSE):
        for reading, own in rows.readings[direction]:
            is_own = np.zeros(len(reading.rows), np.bool_)
            is_own[own] = True
            for fields in reading.frames.fields:
                frame = reading.rows[fields.frame]
                good = np.flatnonzero(is_own[fields.frame] & (rows.verdict[frame] == OK))
                if len(good):
                    parts.append(_of_fields(device, fields, frame[good], good))
    table = _joined(parts)
    if not is_selected.all():
        table = _value_rows(table, np.flatnonzero(is_selected[table.frame]))
    return table


def _of_fields(device: DeviceDecoder, fields: Any, frame: Numbers, good: Numbers) -> ValueTable:
    size = len(frame)
    none = np.full(size, NONE, np.int32)
    values = ValueColumns(*(column[good] for column in _columns(fields.values)))
    name = np.full(size, device.texts.place(fields.path), np.int32)
    unit = np.full(size, device.place(fields.unit), np.int32)
    return ValueTable(frame, none, none, np.full(size, NONE), name, unit, values)


def _columns(values: ValueColumns) -> tuple[npt.NDArray[Any], ...]:
    return values.raw, values.has_raw, values.quantity, values.has_quantity, values.text, values.verdict


def _joined(parts: Collection[ValueTable]) -> ValueTable:
    """Several tables as one, in the order of the frames."""
    own = list(parts)
    if len(own) == 1 and bool((np.diff(own[0].frame) >= 0).all()):
        return own[0]
    if not own:
        none = np.zeros(0, np.int32)
        return ValueTable(numbers([]), none, none, numbers([]), none, none, ValueColumns.empty(0))
    frame = np.concatenate([part.frame for part in own])
    order = np.argsort(frame, kind="stable")
    operation, space, address, register, unit = (
        np.concatenate([getattr(part, name) for part in own])[order]
        for name in ("operation", "space", "address", "register", "unit")
    )
    values = ValueColumns(
        *(np.concatenate(pieces)[order] for pieces in zip(*(_columns(part.values) for part in own), strict=True))
    )
    return ValueTable(frame[order], operation, space, address, register, unit, values)


def _value_rows(table: ValueTable, rows: Numbers) -> ValueTable:
    values = ValueColumns(*(column[rows] for column in _columns(table.values)))
    return ValueTable(
        table.frame[rows],
        table.operation[rows],
        table.space[rows],
        table.address[rows],
        table.register[rows],
        table.unit[rows],
        values,
    )
