"""Register groups and record tables: words to structs and back."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from fieldspec.layout.device import DeviceLayout, TableLayout
from fieldspec.layout.record import RecordLayout, RegisterLayout
from fieldspec.model.access import readable, writable
from fieldspec.model.registers import RegisterGroup
from fieldspec.plc.routines.expressions import (
    BOOL,
    INT,
    UDINT,
    UINT,
    ArrayType,
    Call,
    Conversion,
    Element,
    Expression,
    Member,
    Operation,
    Truth,
    Type,
    Variable,
    Whole,
    compared,
    either,
    every,
    number,
    plus,
    sequence,
)
from fieldspec.plc.routines.holders import Words
from fieldspec.plc.routines.records import members_of, read_fields, write_fields
from fieldspec.plc.routines.routine import Assignment, Declared, Draft, Loop, Routine, Statement, when
from fieldspec.plc.routines.values import Wire, order_remark, read, word_order, write
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


def table_order(record: RecordLayout) -> str:
    """The order of words of a record, as the names of its functions say it."""
    return word_order(wires(record))


def _order_comment(world: World, record: RecordLayout) -> str:
    return order_remark(world.layout, "words", bool(table_order(record)))


def wires(record: RecordLayout) -> list[Wire]:
    """The values of a record and of those within it."""
    values = []
    for field in record.fields:
        if field.record is not None:
            values += wires(field.record)
        elif field.value is not None:
            values.append(Wire.of_field(field))
    return values


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
        world.routine("unpack", record.name, table_order(record)),
        f"record {record.name}",
        world.status,
        f"Registers to struct: {words} words of {record.name}. {_order_comment(world, record)}".strip(),
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
        world.routine("pack", record.name, table_order(record)),
        f"record {record.name}",
        world.status,
        f"Struct to registers: {words} words of {record.name}. {_order_comment(world, record)}".strip(),
        "Where a value is refused, some of the words may have been changed: do not send them.",
        *(f"The elements of {name} cannot be written." for name in read_only),
    )
    struct = draft.declare("stData", world.struct(record.name), "in_out", "is read only")
    holder, _ = _words(world, draft, record, "receives the words")
    draft.add(write_fields(draft, world, record, holder, members_of(world, record, struct)))
    return draft.finished()


def _address(world: World, table_layout: TableLayout) -> Routine:

    table = table_layout.table
    draft = Draft(
        world.routine(table.name, "address"),
        f"table {table.name}",
        world.status,
        f"The address of an element of {table.name}: {table.index_from}..{table.index_from + table.count - 1}. "
        f"{world.comment(table, None)}".strip(),
    )
    index = draft.declare("iNumber", INT, "input", "number of the element as the manual counts")
    address = draft.declare("uiAddress", UINT, "output")
    first, last = table.index_from, table.index_from + table.count - 1
    draft.add([Assignment(address, Whole(0, UINT))])
    draft.refuse(either([compared(index, "<", number(first)), compared(index, ">", number(last))]), "out_of_range")
    steps = Operation("*", (Conversion(plus(index, -first), UINT), Whole(table.stride, UINT)), UINT)
    draft.add([Assignment(address, Operation("+", (Whole(table.base, UINT), steps), UINT))])
    return draft.finished()


def group_routines(world: World) -> Iterator[Routine]:
    """The functions of all groups: of what can be read, and of what can be written."""
    if world.layout.registers:
        yield _holds(world)
    for group in world.layout.device.groups:
        registers = registers_of(world.layout, group)
        read_registers = [register for register in registers if readable(register.register.access)]
        # Where no access is printed, writing is what a trigger is for.
        writable_registers = [
            register for register in registers if writable(register.register.access) or register.register.trigger
        ]
        if read_registers:
            yield _words_to_group(world, group, read_registers)
        if writable_registers:
            yield _group_to_words(world, group, writable_registers)


def registers_of(layout: DeviceLayout, group: RegisterGroup) -> list[RegisterLayout]:
    """The registers of a group."""
    own = {id(register) for register in group.registers}
    return [register for register in layout.registers if id(register.register) in own]


def _holds(world: World) -> Routine:
    """Whether a register lies wholly in the words that begin at an address."""
    address, words = Variable("uiAddress", UINT), Variable("iCount", INT)
    register, size = Variable("uiRegister", UINT), Variable("uiSize", UINT)
    name = world.routine("holds")
    end = _sum(register, size)
    inside = every(
        [
            compared(register, ">=", address),
            compared(end, "<=", Operation("+", (Conversion(address, UDINT), Conversion(words, UDINT)), UDINT)),
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
            when(compared(words, ">", number(0)), [Assignment(Variable(name, BOOL), inside)]),
        ),
        ("Whether all words of a register are among some words.",),
    )


def _sum(left: Expression, right: Expression) -> Expression:
    return Operation("+", (Conversion(left, UDINT), Conversion(right, UDINT)), UDINT)


def register_type(world: World, register: RegisterLayout) -> Type:
    """The type of a register's variable; an array where there are several equal ones."""
    return _each(register, world.type_of(register.register.value))


def answer_type(world: World, register_layout: RegisterLayout) -> Type | None:
    """The type of a variable of its own for what the device answers, where that of the register does not hold it.

    An enumeration holds what may be written to start something, but not any number that reading may give. So what is
    read never changes what is to be written either.
    """
    register = register_layout.register
    own, answer = world.type_of(register.value), world.type_of(register.answer)
    return _each(register_layout, answer) if readable(register.access) and own != answer else None


def answer_name(register: RegisterLayout) -> str:
    """What the variable of an answer is called in the language."""
    return f"{register.name}_answer"


def _each(register: RegisterLayout, element_type: Type) -> Type:
    return sequence(register.count, element_type) if register.count > 1 else element_type


# The statements for one register, from its words and its variable.
_RegisterHolder = Callable[[Words, Expression], list[Statement]]


class _Range:
    """The parameters that say which words there are, of a function for a group."""

    def __init__(self, world: World, group: RegisterGroup, draft: Draft, remark: str) -> None:
        self.world, self.group, self.draft = world, group, draft
        self.address = draft.declare("uiAddress", UINT, "input", "address of aWords[0]")
        self.count = draft.declare("iCount", INT, "input", "how many words there are")
        self.array = draft.declare("aWords", world.words, "in_out", remark)
        self.taken = draft.local("iTaken")
        self.at = draft.local("iAt")
        draft.refuse(compared(self.count, ">", number(world.words.high + 1)), "no_room")
        draft.add([Assignment(self.taken, number(0))])

    def each(
        self, register: RegisterLayout, struct: Variable, answer: Type | None, statements_of: _RegisterHolder
    ) -> list[Statement]:
        """The statements for a register, or for each of several equal ones, if it lies in the words.

        `answer` is the type of the variable that receives what is read, where that is one of its own.
        """
        kind, name = answer or register_type(self.world, register), answer_name(register) if answer else register.name
        member = Member(struct, self.world.member(self.group.name, name), kind)
        if register.count == 1:
            return [self._if_there(register, Whole(register.address, UINT), member, statements_of)]
        index = self.draft.local("iElement")
        assert isinstance(kind, ArrayType)
        element = Element(member, index, kind.of)
        steps: Expression = Conversion(index, UINT)
        if register.stride > 1:
            steps = Operation("*", (steps, Whole(register.stride, UINT)), UINT)
        address = self.draft.local("uiRegister", UINT)
        inner = [
            Assignment(address, Operation("+", (Whole(register.address, UINT), steps), UINT)),
            self._if_there(register, address, element, statements_of),
        ]
        return [Loop(index, number(0), number(register.count - 1), tuple(inner))]

    def _if_there(
        self, register: RegisterLayout, address: Expression, variable: Expression, statements_of: _RegisterHolder
    ) -> Statement:
        call = Call(
            self.world.routine("holds"),
            (
                ("uiAddress", self.address),
                ("iCount", self.count),
                ("uiRegister", address),
                ("uiSize", Whole(register.words, UINT)),
            ),
            (),
            BOOL,
        )
        place = Conversion(Operation("-", (address, self.address), UINT), INT)
        words = Words(self.array, self.at, self.world.layout.device.byte_order)
        return when(
            call,
            [
                Assignment(self.at, place),
                *statements_of(words, variable),
                Assignment(self.taken, plus(self.taken, register.words)),
            ],
        )


def _about(world: World, group: RegisterGroup, registers: list[RegisterLayout]) -> str:
    first = min(register.address for register in registers)
    last = max(register.register.end for register in registers) - 1
    section = f" [{group.section}]" if group.section else ""
    title = group.title or group.name.replace("_", " ")
    return (
        f"{title}{section}: addresses {first}..{last}. {order_remark(world.layout, 'words', bool(_order(registers)))}"
    )


def group_order(world: World, group: RegisterGroup) -> str:
    """The order of words of a group, as the name of its function says it."""
    return _order(registers_of(world.layout, group))


def _order(registers: list[RegisterLayout]) -> str:
    return word_order(Wire.of_register(register) for register in registers)


def _words_to_group(world: World, group: RegisterGroup, registers: list[RegisterLayout]) -> Routine:
    draft = Draft(
        world.routine("unpack", group.name, _order(registers)),
        f"registers {group.name}",
        world.status,
        f"Registers to struct: {_about(world, group, registers)}",
        "Each register that lies wholly in the words is put into the struct; the others stay as they are.",
    )
    words_range = _Range(world, group, draft, "is read only")
    struct = draft.declare("stData", world.struct(group.name), "in_out", "receives the values")
    for register in registers:

        def register_statements(
            words: Words, variable: Expression, register: RegisterLayout = register
        ) -> list[Statement]:
            return read(draft, world, Wire.of_answer(register), words, 0, variable)

        draft.add(words_range.each(register, struct, answer_type(world, register), register_statements))
    draft.refuse(compared(words_range.taken, "=", number(0)), "not_covered")
    return draft.finished()


def _group_to_words(world: World, group: RegisterGroup, registers: list[RegisterLayout]) -> Routine:
    draft = Draft(
        world.routine("pack", group.name, _order(registers)),
        f"registers {group.name}",
        world.status,
        f"Struct to registers: {_about(world, group, registers)}",
        "All words that are asked for must belong to registers that may be written.",
        "Where a value is refused, some of the words may have been changed: do not send them.",
    )
    struct = draft.declare("stData", world.struct(group.name), "in_out", "is read only")
    words_range = _Range(world, group, draft, "receives the words")
    for register in registers:

        def register_statements(
            words: Words, variable: Expression, register: RegisterLayout = register
        ) -> list[Statement]:
            return write(draft, world, Wire.of_register(register), words, 0, variable)

        draft.add(words_range.each(register, struct, None, register_statements))
    wrong = [compared(words_range.count, "<=", number(0)), compared(words_range.taken, "<>", words_range.count)]
    draft.refuse(either(wrong), "not_covered")
    return draft.finished()
