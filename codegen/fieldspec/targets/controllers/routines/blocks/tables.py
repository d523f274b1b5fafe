"""Blocks that read and write groups of registers, and the elements of tables: one of them, or some in a row."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.codec.layout.device import TableLayout
from fieldspec.foundation.names import Name
from fieldspec.language.model.address_space import WORD
from fieldspec.language.model.registers import RegisterGroup
from fieldspec.targets.controllers.routines.blocks.lines import LineDraft
from fieldspec.targets.controllers.routines.blocks.ports import AXIS
from fieldspec.targets.controllers.routines.blocks.standard import TRANSFER_ERRORS, chain
from fieldspec.targets.controllers.routines.exchanges import meanings
from fieldspec.targets.controllers.routines.registers import count_text, group_order, table_order
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import (
    INT,
    UINT,
    ArrayType,
    Expression,
    Truth,
    Variable,
    number,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Routine, Statement, when

_WAYS = {"read": "unpack", "write": "pack"}


def group_blocks(world: World, by_name: Mapping[str, Routine]) -> Iterator[Routine]:
    """The blocks that read registers of a group into its struct, and those that write them."""
    device = world.layout.device
    if device.space("").unit != WORD:
        return
    for group in device.groups:
        if device.space_name(group.space) != device.space_name(""):
            continue
        for direction, function in _WAYS.items():
            routine = by_name.get(world.routine(function, group.name, group_order(world, group, function)))
            if routine is not None:
                yield _group_block(world, group, direction, routine)


def _group_block(world: World, group: RegisterGroup, direction: str, routine: Routine) -> Routine:
    block = LineDraft.executed(world, world.block(direction, group.name), f"registers {group.name}", AXIS)
    address = block.declare("Address", UINT, "input", "of the first register")
    count = block.declare("Count", INT, "input", f"how many words, 1..{world.words.high + 1}")
    kind = world.struct(group.name)
    data = block.declare("Data", kind, "in_out")
    block.limit()
    port = block.of_port
    call = routine.called(uiAddress=address, iCount=count, aWords=port("words"), stData=data)
    ask: list[Statement] = [
        Assignment(port("write"), Truth(direction == "write")),
        Assignment(port("address"), address),
        Assignment(port("count"), count),
    ]
    _add(block, direction, call, ask, [block.end()], count.compared("<", 1), count)
    title = group.title or Name.of(group.name).title()
    block.remarks += [
        f"{direction.title()}s registers: {title}. {world.comment(group, None)}".strip(),
        meanings(world, TRANSFER_ERRORS),
    ]
    return block.block()


def _add(
    block: LineDraft,
    direction: str,
    call: Expression,
    ask: list[Statement],
    success: list[Statement],
    few: Expression,
    count: Expression,
) -> None:
    """Adds the step that reads or writes registers; it refuses a number of words that no request can have."""
    if direction == "write":
        block.request(block.attempts([call], tuple(block.ask(*ask)), "request"), success)
        return
    status = block.status
    too_many = count.compared(">", block.world.words.high + 1)
    refused: list[Statement] = [Assignment(block.result, status.of("no_room")), block.fail("request")]
    block.request(
        [chain([(few, refused), (too_many, refused)], block.ask(*ask))],
        block.attempts([call], tuple(success), "damaged"),
    )


def table_blocks(world: World, by_name: Mapping[str, Routine]) -> Iterator[Routine]:
    """The blocks of all tables whose elements fit into one request."""
    device = world.layout.device
    if device.space("").unit != WORD:
        return
    records = [table.record.name for table in world.layout.tables.values()]
    for table in world.layout.tables.values():
        if device.space_name(table.table.space) != device.space_name(""):
            continue
        words = (table.record.size or 0) // 2
        if not 0 < words <= world.words.high + 1:
            continue
        element_name = table.record.name if records.count(table.record.name) == 1 else f"{table.name}_element"
        for direction, function in _WAYS.items():
            routine = by_name.get(world.routine(function, table.record.name, table_order(table.record)))
            if routine is not None and (direction == "read" or table.writable):
                yield _element_block(world, table, direction, routine, by_name, element_name)
                if element_name != table.name:
                    yield _table_block(world, table, direction, routine, by_name)


def _element_block(
    world: World, table: TableLayout, direction: str, routine: Routine, by_name: Mapping[str, Routine], name: str
) -> Routine:
    """The block that reads or writes one element of a table."""
    block = LineDraft.executed(world, world.block(direction, name), f"table {table.name}", AXIS)
    kind = world.struct(table.record.name)
    index = block.declare("Number", INT, "input", _numbers(table))
    data = block.declare("Data", kind, "in_out")
    block.limit()
    _transfer(block, table, direction, routine, by_name, index, data, [block.end()])
    _about(block, world, table, f"{direction.title()}s one element of {table.name}.")
    return block.block()


def _table_block(
    world: World, table: TableLayout, direction: str, routine: Routine, by_name: Mapping[str, Routine]
) -> Routine:
    """The block that reads or writes consecutive elements of a table."""
    first = table.table.index_from
    last = first + table.table.count - 1
    block = LineDraft.executed(world, world.block(direction, table.name), f"table {table.name}", AXIS)
    kind = world.struct(table.record.name)
    low = block.declare("First", INT, "input", f"first element: {_numbers(table)}", str(first))
    high = block.declare("Last", INT, "input", "last element", str(last))
    array = ArrayType(first, last, kind)
    data = block.declare("Data", array, "in_out")
    index = block.declare("Number", INT, "output", "the element that is being transferred, or was last")
    copied = block.declare(world.variable("element", kind), kind, "local")
    block.limit()
    block.at_start.append(Assignment(index, low))
    element = data.element(index)
    ready: list[Statement] = [Assignment(copied, element)] if direction == "write" else []
    after: list[Statement] = [Assignment(element, copied)] if direction == "read" else []
    following = when(index.compared("<", high), [Assignment(index, index.plus(1))], [block.end()])
    _transfer(block, table, direction, routine, by_name, index, copied, [*after, following], ready)
    _about(block, world, table, f"{direction.title()}s elements of {table.name}, one after the other.")
    return block.block()


def _numbers(table: TableLayout) -> str:
    first = table.table.index_from
    return f"{first}..{first + table.table.count - 1}"


def _about(block: LineDraft, world: World, table: TableLayout, text: str) -> None:
    block.remarks += [
        f"{text} {count_text(table.table)}{world.comment(table.table, None)}".strip(),
        meanings(world, TRANSFER_ERRORS),
    ]


def _transfer(
    block: LineDraft,
    table: TableLayout,
    direction: str,
    routine: Routine,
    by_name: Mapping[str, Routine],
    index: Variable,
    data: Variable,
    success: list[Statement],
    ready: list[Statement] | None = None,
) -> None:
    """Adds the step that reads or writes an element, by the address that its number gives."""
    world = block.world
    port = block.of_port
    words = (table.record.size or 0) // 2
    of_address = by_name[world.routine(table.name, "address")]
    address = block.declare("uiAddress", UINT, "local")
    address_call = of_address.called(iNumber=index, uiAddress=address)
    arguments: dict[str, Expression] = {"iFirst": number(0), "aWords": port("words"), "stData": data}
    if direction == "read":
        arguments["iCount"] = number(words)
    call = routine.called(**arguments)
    ask: list[Statement] = block.ask(
        Assignment(port("write"), Truth(direction == "write")),
        Assignment(port("address"), address),
        Assignment(port("count"), number(words)),
    )
    if direction == "read":
        block.request(
            block.attempts([address_call], tuple(ask), "request"), block.attempts([call], tuple(success), "damaged")
        )
        return
    packed = block.attempts([call], tuple(ask), "request")
    block.request(block.attempts([address_call], (*(ready or ()), *packed), "request"), success)
