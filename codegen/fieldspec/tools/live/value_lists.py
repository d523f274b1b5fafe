"""Values of a device as rows of a list: the elements of a record table, or everything that can be set."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from fieldspec.codec.explain.hazards import COMMANDING
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.tools.live.writing import WriteError

if TYPE_CHECKING:
    from fieldspec.tools.live.access import Access, Item, Reading

Cell: TypeAlias = "int | str | None"

DEVICE, VERSION, TABLE, INDEX, NAME, VALUE = "Device", "Version", "Table", "Index", "Name", "Value"
"""The headings that are not names of fields. They begin with a capital, which no name of a spec does."""

COMMANDS = {*COMMANDING, "stop", "quick_stop"}
"""The roles of what commands a device. No list has them: to write them back would move something."""


@dataclass(frozen=True, slots=True)
class ValueList:
    """Headings, and rows with the same number of cells. An empty cell is None."""

    columns: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]


def settings(access: Access) -> list[Item]:
    """Everything that a list of all settings has."""
    return [item for item in access.items() if not access.objection(item)]


def elements(access: Access, table: str) -> list[Item]:
    """The fields of all elements of a table that a list of them has."""
    return [item for item in settings(access) if access.path(item).startswith(f"{table}[")]


def left_out(access: Access, table: str) -> list[str]:
    """The fields of a table that its list does not have, each with the reason, without reserved ones."""
    first = f"{table}[{access.layout.tables[table].table.index_from}]."
    return [
        f"{access.path(item).removeprefix(first)} {access.objection(item)}"
        for item in access.items()
        if access.path(item).startswith(first) and access.objection(item) not in ("", "is reserved")
    ]


def table_list(access: Access, table: str, values: Sequence[Reading]) -> ValueList:
    """The elements of a table: one row for each, one column for each field."""
    cells: dict[int, dict[str, Cell]] = {}
    for value in values:
        index, _, field = value.path.removeprefix(f"{table}[").partition("].")
        cells.setdefault(int(index), {})[field] = cell(access, value)
    fields = list(dict.fromkeys(field for row in cells.values() for field in row))
    device = access.layout.device
    head = (device.id, device.version, table)
    rows = tuple((*head, index, *(cells[index].get(field) for field in fields)) for index in sorted(cells))
    return ValueList((DEVICE, VERSION, TABLE, INDEX, *fields), rows)


def settings_list(access: Access, values: Sequence[Reading]) -> ValueList:
    """A list with a row for each setting."""
    device = access.layout.device
    head = (device.id, device.version)
    rows = tuple((*head, value.path, cell(access, value)) for value in values)
    return ValueList((DEVICE, VERSION, NAME, VALUE), rows)


def cell(access: Access, value: Reading) -> Cell:
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
        if text and _words_of(access, value, text) == value.words:
            return text
    return number if isinstance(number, int) else repr(number) if isinstance(number, float) else str(number)


def _words_of(access: Access, value: Reading, text: str) -> tuple[int, ...]:
    """The words that a text means for a value; none where it means none."""
    try:
        return access.words_of(value, text)
    except WriteError:
        return ()
