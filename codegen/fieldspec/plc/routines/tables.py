"""Records of a table in the register space: words to struct and back."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.layout.device import TableLayout
from fieldspec.layout.record import RecordLayout
from fieldspec.plc.routines.draft import Draft
from fieldspec.plc.routines.expressions import (
    Conversion,
    Operation,
    Variable,
    Whole,
    compared,
    either,
    number,
    plus,
)
from fieldspec.plc.routines.holders import Words
from fieldspec.plc.routines.orders import order_remark, word_order
from fieldspec.plc.routines.records import members_of, read_fields, write_fields
from fieldspec.plc.routines.routine import Routine
from fieldspec.plc.routines.statements import Assignment
from fieldspec.plc.routines.types import INT, UINT
from fieldspec.plc.routines.values import Wire
from fieldspec.plc.routines.world import World


def table_routines(world: World) -> Iterator[Routine]:
    """The functions of all records that tables hold, and those that give the address of an element."""
    tables = list(world.layout.tables.values())
    records = {table.record.name: table.record for table in tables}
    for record in records.values():
        yield _unpacked(world, record)
        alike = [table for table in tables if table.record.name == record.name]
        if any(table.writable for table in alike):
            yield _packed(world, record, [table.name for table in alike if not table.writable])
    for table in world.layout.tables.values():
        yield _address(world, table)


def _order(record: RecordLayout) -> str:
    return word_order(wires(record))


def _order_told(world: World, record: RecordLayout) -> str:
    return order_remark(world.layout, "words", bool(_order(record)))


def wires(record: RecordLayout) -> list[Wire]:
    """The values of a record and of those within it."""
    found = []
    for field in record.fields:
        if field.record is not None:
            found += wires(field.record)
        elif field.value is not None:
            found.append(Wire.of_field(field))
    return found


def _words(world: World, draft: Draft, record: RecordLayout, remark: str) -> tuple[Words, int]:
    first = draft.declare("iFirst", INT, "input", "index of the first word in aWords")
    array = draft.declare("aWords", world.words, "in_out", remark)
    words = (record.size or 0) // 2
    bounds = [compared(first, "<", number(0)), compared(first, ">", number(world.words.high + 1 - words))]
    draft.refuse(either(bounds), "no_room")
    return Words(array, first, world.layout.device.byte_order), words


def _unpacked(world: World, record: RecordLayout) -> Routine:
    words = (record.size or 0) // 2
    draft = Draft(
        world.routine("unpack", record.name, _order(record)),
        f"record {record.name}",
        world.status,
        f"Registers to struct: {words} words of {record.name}. {_order_told(world, record)}".strip(),
    )
    count = draft.declare("iCount", INT, "input", "how many words of aWords were read")
    holder, words = _words(world, draft, record, "is read only")
    assert isinstance(holder.first, Variable)
    struct = draft.declare("stData", world.struct(record.name), "in_out", "receives the values")
    draft.refuse(compared(plus(holder.first, words), ">", count), "incomplete")
    draft.add(read_fields(draft, world, record, holder, members_of(world, record, struct)))
    return draft.finished()


def _packed(world: World, record: RecordLayout, read_only: list[str]) -> Routine:
    """The words of an element; `read_only` are the tables whose elements must not be written."""
    words = (record.size or 0) // 2
    draft = Draft(
        world.routine("pack", record.name, _order(record)),
        f"record {record.name}",
        world.status,
        f"Struct to registers: {words} words of {record.name}. {_order_told(world, record)}".strip(),
        "Where a value is refused, some of the words may have been changed: do not send them.",
        *(f"The elements of {name} cannot be written." for name in read_only),
    )
    struct = draft.declare("stData", world.struct(record.name), "in_out", "is read only")
    holder, _ = _words(world, draft, record, "receives the words")
    draft.add(write_fields(draft, world, record, holder, members_of(world, record, struct)))
    return draft.finished()


def _address(world: World, laid: TableLayout) -> Routine:

    table = laid.table
    draft = Draft(
        world.routine(table.name, "address"),
        f"table {table.name}",
        world.status,
        f"The address of an element of {table.name}: {table.index_from}..{table.index_from + table.count - 1}. "
        f"{world.told(table, None)}".strip(),
    )
    index = draft.declare("iNumber", INT, "input", "number of the element as the manual counts")
    address = draft.declare("uiAddress", UINT, "output")
    first, last = table.index_from, table.index_from + table.count - 1
    draft.add([Assignment(address, Whole(0, UINT))])
    draft.refuse(either([compared(index, "<", number(first)), compared(index, ">", number(last))]), "out_of_range")
    steps = Operation("*", (Conversion(plus(index, -first), UINT), Whole(table.stride, UINT)), UINT)
    draft.add([Assignment(address, Operation("+", (Whole(table.base, UINT), steps), UINT))])
    return draft.finished()
