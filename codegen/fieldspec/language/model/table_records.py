"""The tables in which records are, as that of an element or within it."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.access import narrowed
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Place
from fieldspec.language.model.record import Record
from fieldspec.language.model.registers import Table


@dataclass(frozen=True, slots=True)
class TableRecord:
    """A record that a table has: that of an element, or one in it.

    `name` is that of the table, with the names of the fields that lead to the record. `access` is what the table and
    these fields allow, and `place` that of the innermost of them that states an access, or of the table.
    """

    table: Table
    record: str
    name: str
    access: str
    place: Place


def table_records(device: Device) -> dict[str, list[TableRecord]]:
    """Where tables have records, by the names of these, in the order of the tables.

    One place of a record in a table for each access.
    """
    result: dict[str, list[TableRecord]] = {}
    for table in device.tables.values():
        outer = TableRecord(table, table.record, table.name, table.access, table.place)
        for use in (outer, *_inner(device, outer, {(outer.record, outer.access)})):
            result.setdefault(use.record, []).append(use)
    return result


def _inner(device: Device, outer: TableRecord, visited: set[tuple[str, str]]) -> Iterator[TableRecord]:
    record: Record | None = device.records.get(outer.record)
    for field in record.fields if record is not None else ():
        access = narrowed(outer.access, field.access)
        if not field.record or (field.record, access) in visited:
            continue
        visited.add((field.record, access))
        place = field.place if field.access else outer.place
        use = TableRecord(outer.table, field.record, f"{outer.name}.{field.name}", access, place)
        yield use
        yield from _inner(device, use, visited)
