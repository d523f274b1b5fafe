"""Parameters that are addressed by number."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.model.registers import Parameter, ParameterSet, Subindex
from fieldspec.targets.docs.context import Context, cited, fact_row
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
    styled,
    table,
    text_piece,
)
from fieldspec.targets.docs.sources import Inferences
from fieldspec.targets.docs.value_cells import SETTING_COLUMNS, effect_lines, meaning_cell, setting_cells, spoken

COLUMNS = (
    TableColumn("Number", "number", unbroken=True, search="key"),
    TableColumn("On the wire", "number", search="key"),
    *SETTING_COLUMNS,
    TableColumn("For"),
    TableColumn("With"),
    TableColumn("Meaning", "wide"),
    TableColumn("Source", "source"),
)


def parameters(context: Context) -> Section:
    """The section of all sets of parameters."""
    inner = tuple(_set_section(context, parameter_set) for parameter_set in context.device.parameters.values())
    return Section("parameters", (text_piece("Parameters"),), (), inner)


def _set_section(context: Context, parameter_set: ParameterSet) -> Section:
    path = parameter_set.place.path
    blocks = context.opening(parameter_set)
    if numbering := tuple(_numbering(parameter_set)):
        blocks.append(Facts(numbering))
    marks = Inferences(path)
    restart = any(parameter.restart is not None for parameter in parameter_set.parameters)
    rows = [
        row
        for parameter in parameter_set.parameters
        for row in _rows(context, parameter_set, parameter, marks, restart)
    ]
    title = parameter_set.title or parameter_set.name
    blocks.append(table(title, COLUMNS, rows, marks.footnotes(), heading=2))
    if parameter_set.sources:
        blocks.append(Facts((("Source", (cited(parameter_set.sources),)),)))
    return Section(path, context.section_title(title, parameter_set), tuple(blocks))


def _numbering(parameter_set: ParameterSet) -> Iterator[tuple[str, tuple[Line, ...]]]:
    """How the numbers of a set are those on the wire, and which it has besides its rows."""
    if parameter_set.space != parameter_set.name:
        yield "Numbers belong to", ((code(parameter_set.space),),)
    if parameter_set.base:
        yield "On the wire", ((text_piece("its number + "), code(f"0x{parameter_set.base:X}")),)
    if parameter_set.numbers is not None:
        numbers = parameter_set.numbers
        first, last = parameter_set.number_text(numbers.low), parameter_set.number_text(numbers.high)
        remark = text_piece("; the table has those that the manual describes")
        yield "All numbers", ((code(first), text_piece(" to "), code(last), remark),)


def _rows(
    context: Context, parameter_set: ParameterSet, parameter: Parameter, marks: Inferences, restart: bool
) -> Iterator[TableRow]:
    last = parameter.number + parameter.count - 1
    yield fact_row(
        parameter,
        cell(*_numbers(parameter_set.number_text(parameter.number), parameter_set.number_text(last))),
        _wire(parameter_set, parameter.number, last),
        *setting_cells(parameter, parameter.name, marks, restart),
        cell(joined((text_piece(" ".join(name.split("_"))),) for name in parameter.applies_to)),
        cell(joined((code(name, f"#messages/{name}"),) for name in parameter.messages)),
        meaning_cell(context, parameter, parameter.value, *_special(parameter)),
    )
    for inner in parameter.subindices:
        yield _subindex(context, parameter, inner, marks)


def _numbers(first: str, last: str) -> list[Line]:
    return [(code(first),)] if first == last else [(code(first), text_piece(" to ")), (code(last),)]


def _wire(parameter_set: ParameterSet, first: int, last: int) -> Cell:
    """The numbers on the wire in both notations, where frames have these and not others."""
    if not parameter_set.base and parameter_set.space == parameter_set.name:
        return Cell()
    low, high = parameter_set.base + first, parameter_set.base + last
    return cell(*_numbers(f"0x{low:04X}", f"0x{high:04X}"), styled(str(low), "quiet"))


def _special(parameter: Parameter) -> Iterator[Line]:
    yield from effect_lines(parameter)
    if parameter.elements is not None:
        yield (text_piece(f"{parameter.elements} elements, subindex 0 to {parameter.elements - 1}"),)


def _subindex(context: Context, parameter: Parameter, inner: Subindex, marks: Inferences) -> TableRow:
    """The row of an element with a meaning of its own."""
    special: list[Line] = [(styled("reserved", "badge"),)] if inner.reserved else []
    index = spoken(inner.indices.text())
    subindex_name = f"{parameter.name}[{index}]" + (f" {inner.name}" if inner.name else "")
    return fact_row(
        inner,
        Cell(),
        Cell(),
        *setting_cells(inner, subindex_name, marks, restart=False),
        Cell(),
        Cell(),
        meaning_cell(context, inner, inner.value, *special),
        element=True,
    )
