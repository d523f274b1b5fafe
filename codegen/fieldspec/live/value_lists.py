"""Values of a device as rows of a list: the elements of a record table, or everything that can be set."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TypeAlias

from fieldspec.classes import dataclass
from fieldspec.explain.registers import Occupant
from fieldspec.layout.device import DeviceLayout
from fieldspec.live.reading import Reading, all_occupants
from fieldspec.live.writing import WriteError, assignment
from fieldspec.model.access import readable, writable

Cell: TypeAlias = "int | str | None"
Placed: TypeAlias = "tuple[str, Occupant]"
"""The name of a space, and what is at an address there."""

DEVICE, VERSION, TABLE, INDEX, NAME, VALUE = "Device", "Version", "Table", "Index", "Name", "Value"
"""The headings that are no names of fields. They begin with a capital, which no name of a spec does."""

COMMANDS = {
    *("command", "control_request", "coast_stop_released", "quick_stop_released", "switch_on", "servo_enable"),
    *("homing_start", "move_start", "move_enable", "pause_released", "stop", "quick_stop", "jog_positive"),
    *("jog_negative", "jog_start", "point_start", "alarm_reset", "save", "save_points", "restart"),
}
"""The roles of what commands a device. No list has them: to write them back would move something."""


@dataclass(frozen=True, slots=True)
class ValueList:
    """Headings, and rows of as many cells. An empty cell is None."""

    columns: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]


def objection(layout: DeviceLayout, occupant: Occupant) -> str:
    """Why a value is in no list that is written to a device; empty where it may be."""
    if occupant.reserved or getattr(occupant.fact, "reserved", False):
        return "is reserved"
    if occupant.trigger or COMMANDS.intersection(_roles(layout, occupant)):
        return "commands the device; write it by its name, with the verb write"
    if not writable(occupant.access):
        return "can only be read" if occupant.access else "is not stated to be writable"
    handling = getattr(occupant.fact, "handling", None)
    if not readable(occupant.access) or (handling is not None and handling.clears_on_read):
        return "cannot be read back, so that nothing could be verified; write it by its name, with the verb write"
    return ""


def _roles(layout: DeviceLayout, occupant: Occupant) -> Iterable[str]:
    yield from occupant.fact.roles
    if occupant.value.flags:
        for bit in layout.device.flags[occupant.value.flags].bits:
            yield from bit.roles


def settings(layout: DeviceLayout) -> list[Placed]:
    """Everything that a list of all settings has."""
    return [pair for pair in all_occupants(layout) if not objection(layout, pair[1])]


def elements(layout: DeviceLayout, table: str) -> list[Placed]:
    """The fields of all elements of a table that a list of them has."""
    return [pair for pair in settings(layout) if pair[1].path.startswith(f"{table}[")]


def left_out(layout: DeviceLayout, table: str) -> list[str]:
    """The fields of a table that its list does not have, each with the reason, without reserved ones."""
    first = f"{table}[{layout.tables[table].table.index_from}]."
    return [
        f"{occupant.path.removeprefix(first)} {objection(layout, occupant)}"
        for _, occupant in all_occupants(layout)
        if occupant.path.startswith(first) and objection(layout, occupant) not in ("", "is reserved")
    ]


def table_list(layout: DeviceLayout, table: str, values: Sequence[Reading]) -> ValueList:
    """The elements of a table: one row for each, one column for each field."""
    cells: dict[int, dict[str, Cell]] = {}
    for value in values:
        index, _, field = value.occupant.path.removeprefix(f"{table}[").partition("].")
        cells.setdefault(int(index), {})[field] = cell(layout, value)
    fields = list(dict.fromkeys(field for row in cells.values() for field in row))
    head = (layout.device.id, layout.device.version, table)
    rows = tuple((*head, index, *(cells[index].get(field) for field in fields)) for index in sorted(cells))
    return ValueList((DEVICE, VERSION, TABLE, INDEX, *fields), rows)


def settings_list(layout: DeviceLayout, values: Sequence[Reading]) -> ValueList:
    """All settings: one row for each."""
    head = (layout.device.id, layout.device.version)
    rows = tuple((*head, value.occupant.path, cell(layout, value)) for value in values)
    return ValueList((DEVICE, VERSION, NAME, VALUE), rows)


def cell(layout: DeviceLayout, value: Reading) -> Cell:
    """A value as people write it: a member, a quantity with its unit, or a count. It means the same words when read.

    None for a value that the device refused.
    """
    decoded = value.decoded
    if decoded is None or decoded.number is None:
        return None
    number = decoded.number
    if isinstance(number, bytes):
        return number.hex() or None
    if isinstance(number, bool):
        return str(number).lower()
    names = [meaning.name for meaning in decoded.meanings if not meaning.bits]
    texts = [*names, decoded.text] if isinstance(number, int) else [decoded.text]
    for text in texts:
        if text and _words_of(layout, value, text) == value.words:
            return text
    return number if isinstance(number, int) else repr(number) if isinstance(number, float) else str(number)


def _words_of(layout: DeviceLayout, value: Reading, text: str) -> tuple[int, ...]:
    """The words that a text means for a value; none where it means none."""
    try:
        return assignment(layout, "", value.occupant, text).words
    except WriteError:
        return ()
