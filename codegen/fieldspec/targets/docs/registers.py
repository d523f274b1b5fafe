"""The registers by group, and the address spaces: what an address holds and which messages reach it."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import replace
from fieldspec.language.model.address_space import BIT, AddressSpace
from fieldspec.language.model.registers import Gap, Register, RegisterGroup
from fieldspec.targets.docs.context import Context, address, cited, fact_row, names
from fieldspec.targets.docs.document import (
    Cell,
    Facts,
    Line,
    Section,
    TableColumn,
    TableRow,
    cell,
    code,
    joined,
    label,
    styled,
    table,
    text_piece,
)
from fieldspec.targets.docs.sources import Inferences
from fieldspec.targets.docs.value_cells import SETTING_COLUMNS, effect_lines, meaning_cell, setting_cells

COLUMNS = (
    TableColumn("No.", "number", search="key"),
    TableColumn("Address", "number", unbroken=True, search="key"),
    TableColumn("Words", "number", unbroken=True),
    *SETTING_COLUMNS,
    TableColumn("Meaning", "wide"),
    TableColumn("Source", "source"),
)


def _columns(unit: str) -> tuple[TableColumn, ...]:
    """The columns of registers in a space of words, bytes or bits."""
    title = f"{unit.capitalize()}s"
    return tuple(replace(column, title=title) if column.title == "Words" else column for column in COLUMNS)


def registers(context: Context) -> Section:
    """The section of all groups of registers."""
    inner = tuple(_group(context, group) for group in context.device.groups)
    return Section("registers", (text_piece("Registers"),), (), inner)


def _group(context: Context, group: RegisterGroup) -> Section:
    blocks = context.opening(group)
    path = group.place.path
    if any(register.place.path == path for register in context.device.registers()):
        path += "/group"
    marks = Inferences(path)
    restart = any(register.restart is not None for register in group.registers)
    rows = [row for register in group.registers for row in _rows(context, register, marks, restart)]
    title = group.title or group.name
    columns = _columns(context.device.space(group.space).unit)
    blocks.append(table(title, columns, rows, marks.footnotes(), heading=3))
    if context.device.spaces:
        space = context.device.space(group.space)
        blocks.append(Facts((("Address space", ((text_piece(space.title or space.name, f"#{space.place.path}"),),)),)))
    if group.gaps:
        blocks.append(Facts(tuple(_gaps(group.gaps))))
    if group.sources:
        blocks.append(Facts((("Source", (cited(group.sources),)),)))
    return Section(path, context.section_title(title, group), tuple(blocks))


def _gaps(gaps: tuple[Gap, ...]) -> Iterator[tuple[str, tuple[Line, ...]]]:
    """The gaps between registers as facts: one for each reason, with all its addresses."""
    for reason in dict.fromkeys(gap.reason for gap in gaps):
        bounds = [bound for gap in gaps if gap.reason == reason for bound in gap.addresses.intervals]
        spans = (address(low) if low == high else f"{address(low)}..{address(high)}" for low, high in bounds)
        yield "No registers at", (joined(((code(span),) for span in spans), ", "), (text_piece(reason),))


def _rows(context: Context, register: Register, marks: Inferences, restart: bool) -> Iterator[TableRow]:
    yield fact_row(
        register,
        cell("" if register.number is None else str(register.number)),
        _address(register, context.device.space(register.space).first_number),
        cell(str(register.width)),
        *setting_cells(register, register.name, marks, restart),
        meaning_cell(context, register, register.value, *_special(register)),
    )
    if register.count > 1:
        first = context.device.space(register.space).first_number
        yield from (_element(register, number, first) for number in range(register.count))


def _address(register: Register, first_number: int) -> Cell:
    number = first_number + register.address
    last = register.address + (register.count - 1) * register.stride
    if register.count == 1:
        return cell(code(address(register.address)), styled(str(number), "quiet"))
    return cell(
        code(f"{address(register.address)}..{address(last)}"), styled(f"{number}..{first_number + last}", "quiet")
    )


def _special(register: Register) -> Iterator[Line]:
    """The hazards of reading and writing a register."""
    if register.count > 1:
        units = "bits" if register.value.type.name == BIT else "words" if register.unit_size > 1 else "bytes"
        apart = "" if register.stride == register.width else f", {register.stride} {units} apart"
        last = register.index_from + register.count - 1
        yield (text_piece(f"{register.count} registers, numbered {register.index_from} to {last}{apart}."),)
    yield from effect_lines(register)
    if register.atomic:
        yield (styled("atomic", "badge"), text_piece(" All of its words must be accessed in one request."))
    if register.copy_of:
        yield (text_piece("Another copy of "), code(register.copy_of, f"#registers/{register.copy_of}"))
    if register.same_as:
        yield (text_piece("The same as "), code(register.same_as, f"#registers/{register.same_as}"))


def _element(register: Register, number: int, first_number: int) -> TableRow:
    """The row of one of several equal registers: where it lies, and what the manual calls it."""
    index = register.index_from + number
    element_address = register.address + number * register.stride
    printed = register.element_name.format(n=index) if register.element_name else ""
    source = register.element_sources[number : number + 1]
    blank = (Cell(),) * 7
    return TableRow(
        (
            Cell(),
            cell(code(address(element_address)), styled(str(first_number + element_address), "quiet")),
            Cell(),
            cell((code(f"{register.name}[{index}]"),), (label(printed),)),
            *blank,
            cell(cited(source)),
        ),
        f"{register.place.path}/{index}",
        element=True,
    )


_SPACE_COLUMNS = (
    TableColumn("Name", unbroken=True),
    TableColumn("Address holds", "short", unbroken=True),
    TableColumn("Addresses", unbroken=True),
    TableColumn("First number", "number"),
    TableColumn("Read by"),
    TableColumn("Written by"),
    TableColumn("Meaning", "wide"),
    TableColumn("Source", "source"),
)


def spaces(context: Context) -> Section:
    """The section of all address spaces in one table."""
    address_spaces = context.device.spaces
    marks = Inferences("spaces")
    rows = [_space_row(context, space, marks) for space in address_spaces.values()]
    blocks = (table("Address spaces", _SPACE_COLUMNS, rows, marks.footnotes()),) if rows else ()
    return Section("spaces", (text_piece("Address spaces"),), blocks)


def _space_row(context: Context, space: AddressSpace, marks: Inferences) -> TableRow:
    bounds = joined(((code(f"{address(low)}..{address(high)}"),) for low, high in space.bounds.intervals), ", ")
    return fact_row(
        space,
        names(space, space.name, mark=marks.all_marks(space.inferred)),
        cell(f"a {space.unit}"),
        cell(bounds),
        cell(str(space.first_number)),
        cell(_space_messages(context, space, "read")),
        cell(_space_messages(context, space, "write")),
        cell(*context.about(space)),
    )


def _space_messages(context: Context, space: AddressSpace, operation: str) -> Line:
    device = context.device
    messages = [
        message
        for message in device.messages.values()
        if message.single_access is not None
        and message.single_access.operation == operation
        and device.space_name(message.single_access.space) == space.name
    ]
    return joined(((code(message.name, f"#{message.place.path}"),) for message in messages), ", ")
