"""The read plan: blocks of registers that one request each may read, from the limits of messages, gaps and hazards.

A block has readable values, and reserved words between them. It leaves out values that can only be written, that a
read clears, or of which the spec does not say whether they can be read. Two requests never divide a value. Each element
of a table whose count the device has is read by itself.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.observation import is_same_layout, observed_layout
from fieldspec.codec.layout.record import FieldLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.source import Span
from fieldspec.language.model.access import narrowed, readable
from fieldspec.language.model.address_space import BIT, WORD
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Citation
from fieldspec.language.model.record import Field, Message
from fieldspec.language.model.registers import Register
from fieldspec.language.model.value import Handling

WRITE_ONLY, CLEARED, ACCESS_UNKNOWN, TOO_LONG = (
    "can only be written",
    "is cleared by reading",
    "it is not stated whether it can be read",
    "it has more words than one request reads",
)


@dataclass(frozen=True, slots=True)
class ReadLimit:
    """The most words that one request of a message reads, None where the spec does not say, and the place of the limit.

    In a space of bits, `unit` is `bit`, and words are bits; in a space of bytes, words are bytes. The limit is
    `from_manual` where the spec of the device sets it, and not the protocol. `sources` are its citations.
    """

    message: str
    space: str
    words: int | None
    span: Span | None
    from_manual: bool
    sources: tuple[Citation, ...]
    notes: tuple[str, ...]
    unit: str = WORD


@dataclass(frozen=True, slots=True)
class ReadUnit:
    """Words that are read together or not at all; `refused` is why they cannot be read.

    `element` is the element of a table whose count the device has: what is not in it may be there where it is not.
    It is empty for everything else.
    """

    space: str
    first: int
    words: int
    name: str
    refused: str
    reserved: bool = False
    element: str = ""

    @property
    def end(self) -> int:
        """The address after the last word."""
        return self.first + self.words


@dataclass(frozen=True, slots=True)
class ReadBlock:
    """One request: its message, space and first address, its words, the names of its values, its reserved words."""

    message: str
    space: str
    start: int
    words: int
    names: tuple[str, ...]
    reserved: int

    @property
    def end(self) -> int:
        """The address after the last word."""
        return self.start + self.words


@dataclass(frozen=True, slots=True)
class ReadPlan:
    """How a device is read: the limits of its messages, the blocks, and the values that no block reads.

    The name of a space is empty where the device declares only one. Blocks stand in the order of their addresses, space
    by space.
    """

    limits: tuple[ReadLimit, ...]
    blocks: tuple[ReadBlock, ...]
    left_out: tuple[ReadUnit, ...]

    @property
    def spaces(self) -> tuple[str, ...]:
        """The address spaces that a message reads."""
        return tuple(dict.fromkeys(limit.space for limit in self.limits))

    def limit(self, space: str) -> ReadLimit | None:
        """The largest limit of a space: its message needs the fewest requests. None where no limit is known."""
        known = [limit for limit in self.limits if limit.words is not None and limit.space == space]
        return max(known, key=lambda limit: limit.words or 0, default=None)


def read_plan(layout: DeviceLayout) -> ReadPlan:
    """The longest reads of one request each that touch no hole, for all spaces of a device.

    Each block says which message reads it. There are no blocks where no message reads registers, or where nothing says
    how many words one request reads: `limits` then tells the two apart. Values that must not or cannot be read in a
    block are in `left_out`, each with the reason. Never raises for a device without findings.
    """
    device = layout.device
    limits = tuple(read_limit(device, message) for message in device.messages.values() if _is_read(device, message))
    plan = ReadPlan(limits, (), ())
    longest = [limit for space in plan.spaces if (limit := plan.limit(space)) is not None]
    requests = tuple((limit.space, limit.message, limit.words) for limit in longest if limit.words is not None)
    key = device.id, device.version
    earlier = _PLANNED.get(key)
    if earlier is None or earlier[1] != requests or not is_same_layout(earlier[0], layout):
        if len(_PLANNED) == _MOST_PLANNED:
            _PLANNED.clear()
        reading = observed_layout(layout)
        earlier = _PLANNED[key] = reading, requests, *_all_blocks(reading, requests)
    return ReadPlan(limits, *earlier[2:])


_Requests = tuple[tuple[str, str, int], ...]
"""For spaces, the message that reads it, and the most words of one request."""

_PLANNED: dict[tuple[str, str], tuple[DeviceLayout, _Requests, tuple[ReadBlock, ...], tuple[ReadUnit, ...]]] = {}
"""By device and version, the blocks of the last layout, which knows what they have read, and what is left out."""
_MOST_PLANNED = 64


def _all_blocks(layout: DeviceLayout, requests: _Requests) -> tuple[tuple[ReadBlock, ...], tuple[ReadUnit, ...]]:
    """The blocks of all spaces, and what is left out."""
    units = sorted(_units(layout), key=lambda unit: (unit.first, unit.words))
    blocks: list[ReadBlock] = []
    left_out: list[ReadUnit] = []
    for space, message, words in requests:
        space_blocks, rest = _blocks([unit for unit in units if unit.space == space], message, words)
        blocks += space_blocks
        left_out += rest
    return tuple(blocks), tuple(left_out)


def _blocks(units: Sequence[ReadUnit], message: str, limit: int) -> tuple[list[ReadBlock], list[ReadUnit]]:
    """The blocks of a space, and what is left out; a request reads at most `limit` words."""
    too_long = [
        ReadUnit(unit.space, unit.first, unit.words, unit.name, TOO_LONG)
        for unit in units
        if not unit.refused and unit.words > limit
    ]
    usable = [unit for unit in units if not unit.refused and unit.words <= limit]
    stops = [unit for unit in units if unit.refused]
    blocks = [block for run in _unit_runs(usable, stops) for block in _cut(run, message, limit)]
    return blocks, sorted([*stops, *too_long], key=lambda unit: unit.first)


def _is_read(device: Device, message: Message) -> bool:
    access = device.register_access(message) or device.bit_access(message)
    return access is not None and access.operation == "read"


def _space(device: Device, name: str) -> str:
    return device.space_name(name) if device.several_spaces else ""


def read_limit(device: Device, message: Message) -> ReadLimit:
    """The limit of a message: the range of its word count, how often its values repeat, or their size in bytes."""
    access = message.single_access
    assert access is not None
    space, unit = _space(device, access.space), device.space(access.space).unit
    if not access.count:
        return ReadLimit(message.name, space, 1, message.place["accesses"], True, message.sources, message.notes, unit)
    packed = 8 if unit == BIT else 1
    bounds: list[tuple[int, int, Field, str]] = []
    for field in (*message.request.fields, *message.response.fields):
        ranges = field.value.ranges if field.value is not None else None
        key = "unit_range" if "unit_range" in field.place else "range"
        if field.name == access.count and ranges is not None:
            bounds.append((ranges.high, 0, field, key))
        if field.name == access.values and field.repeat is not None:
            bounds.append((field.repeat.high * packed, 1, field, "repeat"))
        measured = field.measures
        if measured is not None and measured.field == access.values and ranges is not None:
            words = (ranges.high - measured.plus) * packed // (2 if measured.of == "bytes" and unit == WORD else 1)
            bounds.append((words, 2, field, key))
    if not bounds:
        return ReadLimit(message.name, space, None, None, False, (), message.notes, unit)
    words, _, field, key = min(bounds, key=lambda bound: bound[:2])
    span = field.place[key]
    own = _folder(span) == _folder(device.place.whole)
    return ReadLimit(message.name, space, words, span, own, field.sources if own else (), message.notes, unit)


def _folder(span: Span) -> str:
    return span.file.path.rpartition("/")[0]


def _units(layout: DeviceLayout) -> Iterator[ReadUnit]:
    for register in layout.device.registers():
        yield from _of_register(layout.device, register)
    for table in layout.tables.values():
        if not table.table.base_by:
            yield from _of_table(layout.device, table)


def _of_register(device: Device, register: Register) -> Iterator[ReadUnit]:
    refused = _refused(register.access, register.handling)
    space, width = _space(device, register.space), max(1, register.width)
    for number in range(register.count):
        name = f"{register.name}[{register.index_from + number}]" if register.count > 1 else register.name
        yield ReadUnit(space, register.address + number * register.stride, width, name, refused, register.reserved)


def _of_table(device: Device, table_layout: TableLayout) -> Iterator[ReadUnit]:
    """The fields of all elements. A reserved field between others is read with them."""
    table = table_layout.table
    space = _space(device, table.space)
    runs = [
        (first, words, ", ".join(map(_field_name, fields)), _of_fields(table_layout, fields), _reserved(fields))
        for first, words, fields in table_layout.word_runs()
    ]
    for number in range(table.count):
        address = table.base + number * table.stride
        for first, words, name, refused, reserved in runs:
            full_name = f"{table.name}[{table.index_from + number}].{name}"
            element = f"{table.name}[{table.index_from + number}]" if table.count_by else ""
            yield ReadUnit(space, address + first, words, full_name, refused, reserved, element)


def _field_name(field: FieldLayout) -> str:
    return f"{field.name}[{field.count}]" if field.is_list else field.name


def _reserved(fields: Sequence[FieldLayout]) -> bool:
    return all(field.field.reserved for field in fields)


def _of_fields(table: TableLayout, fields: Sequence[FieldLayout]) -> str:
    """Why fields that share words are not read; the first objection to one of them."""
    if _reserved(fields) and not any(field.field.access for field in fields):
        return ""
    refusals = (refusal for field in fields for refusal in _of_field(field, table.table.access))
    return next(filter(None, refusals), "")


def _of_field(field: FieldLayout, container: str) -> Iterator[str]:
    """Why a field, or a value in its record, is not read, of each; empty where it may be."""
    access = narrowed(container, field.field.access)
    if field.record is None or field.field.handling.clears_on_read:
        yield _refused(access, field.field.handling)
    for inner in field.record.fields if field.record is not None else ():
        if not inner.field.reserved or inner.field.access:
            yield from _of_field(inner, access)


def _refused(access: str, handling: Handling) -> str:
    """Why a value is not read in a block; empty where it may be."""
    if access == "wo":
        return WRITE_ONLY
    if handling.clears_on_read:
        return CLEARED
    return "" if readable(access) else ACCESS_UNKNOWN


def _unit_runs(usable: Sequence[ReadUnit], stops: Sequence[ReadUnit]) -> Iterator[list[ReadUnit]]:
    """Units without a hole between them; an address that cannot be read is a hole, even where a unit shares it."""
    closed = {address for unit in stops for address in range(unit.first, unit.end)}
    run: list[ReadUnit] = []
    end = 0
    for unit in usable:
        if any(address in closed for address in range(unit.first, unit.end)):
            continue
        if run and (unit.first > end or unit.element != run[-1].element):
            yield run
            run = []
        end = max(end, unit.end) if run else unit.end
        run.append(unit)
    if run:
        yield run


def _cut(run: Sequence[ReadUnit], message: str, limit: int) -> Iterator[ReadBlock]:
    """The longest blocks of a run, one after the other, without reserved words at their ends."""
    index = 0
    while index < len(run):
        if run[index].reserved:
            index += 1
            continue
        start = run[index].first
        stop = next((n for n in range(index, len(run)) if run[n].end - start > limit), len(run))
        # What overlaps may reach further than what follows it: the block ends where nothing is divided.
        units = run[index:stop]
        while len(units) > 1 and stop < len(run) and max(unit.end for unit in units) > run[stop].first:
            stop -= 1
            units = run[index:stop]
        index = stop
        while units[-1].reserved:
            units = units[:-1]
        words = max(unit.end for unit in units) - start
        names = tuple(unit.name for unit in units if not unit.reserved)
        yield ReadBlock(message, run[0].space, start, words, names, sum(unit.words for unit in units if unit.reserved))
