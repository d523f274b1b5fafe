"""Register groups and record tables: words to structs and back."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.record import RecordLayout, RegisterLayout
from fieldspec.language.model.access import readable, writable
from fieldspec.language.model.address_space import BIT as BIT_UNIT
from fieldspec.language.model.device import Device
from fieldspec.language.model.registers import RegisterGroup, Table
from fieldspec.targets.controllers.routines.bits import bits_to_group, group_to_bits, single_bit_routines
from fieldspec.targets.controllers.routines.drafts import Draft
from fieldspec.targets.controllers.routines.holders import Words
from fieldspec.targets.controllers.routines.records import members_of, read_fields, write_fields
from fieldspec.targets.controllers.routines.register_range import RegisterRange, answer_type
from fieldspec.targets.controllers.routines.values import Wire, order_remark, read, word_order, write
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    INT,
    UDINT,
    UINT,
    Expression,
    Truth,
    Variable,
    Whole,
    either,
    every,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Declared, Routine, Statement, when


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


def table_order(record: RecordLayout) -> str:
    """The order of words of a record, as the names of its functions say it."""
    return word_order(wires(record))


def _order_comment(world: World, record: RecordLayout) -> str:
    return order_remark(world.layout, "words", bool(table_order(record)))


def wires(record: RecordLayout) -> list[Wire]:
    """The wire values of a record and of the records in it."""
    values = []
    for field in record.fields:
        if field.record is not None:
            values += wires(field.record)
        elif field.value is not None:
            values.append(Wire.of_field(field))
    return values


def _words(draft: Draft, record: RecordLayout, remark: str) -> tuple[Words, int]:
    first = draft.declare("iFirst", INT, "input", "index of the first word in aWords")
    array = draft.declare("aWords", draft.world.words, "in_out", remark)
    words = (record.size or 0) // 2
    bounds = [first.compared("<", 0), first.compared(">", draft.world.words.high + 1 - words)]
    draft.refuse(either(bounds), "no_room")
    return Words(array, first, draft.world.layout.device.byte_order), words


def _unpacked(world: World, record: RecordLayout) -> Routine:
    words = (record.size or 0) // 2
    draft = Draft(
        world,
        world.routine("unpack", record.name, table_order(record)),
        f"record {record.name}",
        f"Registers to struct: {words} words of {record.name}. {_order_comment(world, record)}".strip(),
    )
    count = draft.declare("iCount", INT, "input", "how many words of aWords were read")
    holder, words = _words(draft, record, "is read only")
    assert isinstance(holder.first, Variable)
    struct = draft.declare("stData", world.struct(record.name), "in_out", "receives the values")
    draft.refuse(holder.first.plus(words).compared(">", count), "incomplete")
    draft.add(read_fields(draft, record, holder, members_of(world, record, struct)))
    return draft.finished()


def _packed(world: World, record: RecordLayout, read_only: list[str]) -> Routine:
    """The words of an element; `read_only` are the tables whose elements must not be written."""
    words = (record.size or 0) // 2
    draft = Draft(
        world,
        world.routine("pack", record.name, table_order(record)),
        f"record {record.name}",
        f"Struct to registers: {words} words of {record.name}. {_order_comment(world, record)}".strip(),
        "If a value is refused, some words may have changed: do not send them.",
        *(f"The elements of {name} cannot be written." for name in read_only),
    )
    struct = draft.declare("stData", world.struct(record.name), "in_out", "is read only")
    holder, _ = _words(draft, record, "receives the words")
    draft.add(write_fields(draft, record, holder, members_of(world, record, struct)))
    return draft.finished()


def count_text(table: Table) -> str:
    """The sentence about the number of elements that a device has, where a register has it."""
    return f"The register {table.count_by} has how many there are. " if table.count_by else ""


def _address(world: World, table_layout: TableLayout) -> Routine:

    table = table_layout.table
    draft = Draft(
        world,
        world.routine(table.name, "address"),
        f"table {table.name}",
        f"The address of an element of {table.name}: {table.index_from}..{table.index_from + table.count - 1}. "
        f"{count_text(table)}{world.comment(table, None)}".strip(),
    )
    index = draft.declare("iNumber", INT, "input", "number of the element as the manual counts")
    address = draft.declare("uiAddress", UINT, "output")
    first, last = table.index_from, table.index_from + table.count - 1
    draft.add([Assignment(address, Whole(0, UINT))])
    draft.refuse(either([index.compared("<", first), index.compared(">", last)]), "out_of_range")
    steps = index.plus(-first).converted(UINT).combined("*", table.stride)
    draft.add([Assignment(address, Whole(table.base, UINT).combined("+", steps))])
    return draft.finished()


def group_routines(world: World) -> Iterator[Routine]:
    """The functions that unpack and pack the registers of each group."""
    device = world.layout.device
    groups = [(group, registers_of(world.layout, group)) for group in device.groups]
    if any(registers for _, registers in groups):
        yield _holds(world)
    if has_bits(device):
        yield from single_bit_routines(world)
    for group, registers in groups:
        is_bits = device.space(group.space).unit == BIT_UNIT
        read_registers = [register for register in registers if readable(register.register.access)]
        # Where no access is printed, writing is what a trigger is for.
        writable_registers = [
            register for register in registers if writable(register.register.access) or register.register.trigger
        ]
        if read_registers:
            yield (bits_to_group if is_bits else _words_to_group)(world, group, read_registers)
        if writable_registers:
            yield (group_to_bits if is_bits else _group_to_words)(world, group, writable_registers)


def has_bits(device: Device) -> bool:
    """Whether the device has registers of single bits."""
    return any(group.registers and device.space(group.space).unit == BIT_UNIT for group in device.groups)


def registers_of(layout: DeviceLayout, group: RegisterGroup) -> list[RegisterLayout]:
    """The registers of a group in the layout."""
    own = {id(register) for register in group.registers}
    return [register for register in layout.registers if id(register.register) in own]


def _holds(world: World) -> Routine:
    """Whether a register lies wholly in the words that begin at an address."""
    address, words = Variable("uiAddress", UINT), Variable("iCount", INT)
    register, size = Variable("uiRegister", UINT), Variable("uiSize", UINT)
    name = world.routine("holds")
    end = register.converted(UDINT).combined("+", size.converted(UDINT))
    is_within = every(
        [
            register.compared(">=", address),
            end.compared("<=", address.converted(UDINT).combined("+", words.converted(UDINT))),
        ]
    )
    return Routine(
        name,
        "registers",
        BOOL,
        (
            Declared(address, "input", "address of the first word"),
            Declared(words, "input", "how many words there are"),
            Declared(register, "input", "address of the register"),
            Declared(size, "input", "its words"),
        ),
        (
            Assignment(Variable(name, BOOL), Truth(False)),
            when(words.compared(">", 0), [Assignment(Variable(name, BOOL), is_within)]),
        ),
        ("Whether all words of a register are among some words.",),
    )


def _about(world: World, group: RegisterGroup, registers: list[RegisterLayout], function: str) -> str:
    first = min(register.address for register in registers)
    last = max(register.register.end for register in registers) - 1
    section = f" [{group.section}]" if group.section else ""
    title = group.title or group.name.replace("_", " ")
    turned = function == "pack" and any(register.register.value.write_word_order for register in registers)
    remark = order_remark(world.layout, "words", bool(_order(registers, function)) and not turned)
    return f"{title}{section}: addresses {first}..{last}. {remark}"


def group_order(world: World, group: RegisterGroup, function: str) -> str:
    """The order of words of a group, as the name of its function, `pack` or `unpack`, says it."""
    return _order(registers_of(world.layout, group), function)


def _order(registers: list[RegisterLayout], function: str) -> str:
    wire_of = Wire.of_answer if function == "unpack" else Wire.of_register
    return word_order(map(wire_of, registers))


def _range(group: RegisterGroup, draft: Draft, remark: str) -> RegisterRange:
    return RegisterRange(
        draft.world, group, draft, Variable("aWords", draft.world.words), draft.world.words.high + 1, "word", remark
    )


def _words_to_group(world: World, group: RegisterGroup, registers: list[RegisterLayout]) -> Routine:
    draft = Draft(
        world,
        world.routine("unpack", group.name, _order(registers, "unpack")),
        f"registers {group.name}",
        f"Registers to struct: {_about(world, group, registers, 'unpack')}",
        "Each register that lies wholly in the words is put into the struct; the others stay as they are.",
    )
    words_range = _range(group, draft, "is read only")
    struct = draft.declare("stData", world.struct(group.name), "in_out", "receives the values")
    for register in registers:

        def register_statements(
            index: Expression, variable: Expression, register: RegisterLayout = register
        ) -> list[Statement]:
            words = Words(words_range.array, index, world.layout.device.byte_order)
            return read(draft, Wire.of_answer(register), words, variable)

        draft.add(words_range.each(register, struct, answer_type(world, register), register_statements))
    draft.refuse(words_range.taken.compared("=", 0), "not_covered")
    return draft.finished()


def _group_to_words(world: World, group: RegisterGroup, registers: list[RegisterLayout]) -> Routine:
    draft = Draft(
        world,
        world.routine("pack", group.name, _order(registers, "pack")),
        f"registers {group.name}",
        f"Struct to registers: {_about(world, group, registers, 'pack')}",
        "All requested words must belong to writable registers.",
        "If a value is refused, some words may have changed: do not send them.",
    )
    struct = draft.declare("stData", world.struct(group.name), "in_out", "is read only")
    words_range = _range(group, draft, "receives the words")
    for register in registers:

        def register_statements(
            index: Expression, variable: Expression, register: RegisterLayout = register
        ) -> list[Statement]:
            words = Words(words_range.array, index, world.layout.device.byte_order)
            return write(draft, Wire.of_register(register), words, variable)

        draft.add(words_range.each(register, struct, None, register_statements))
    wrong = [words_range.count.compared("<=", 0), words_range.taken.compared("<>", words_range.count)]
    draft.refuse(either(wrong), "not_covered")
    return draft.finished()
