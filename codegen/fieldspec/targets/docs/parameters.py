"""Parameters that are addressed by number."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.model.registers import Parameter, ParameterSet, Subindex
from fieldspec.targets.docs.context import Context, cited, names, sources
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
from fieldspec.targets.docs.value_cells import (
    VALUE_COLUMNS,
    access_cell,
    default_cell,
    meaning_cell,
    restart_cell,
    spoken,
    value_cells,
)

COLUMNS = (
    TableColumn("Number", "number", unbroken=True, search="key"),
    TableColumn("On the wire", "number", search="key"),
    TableColumn("Name", unbroken=True),
    VALUE_COLUMNS[0],
    TableColumn("Access", "short", unbroken=True),
    *VALUE_COLUMNS[1:],
    TableColumn("Default"),
    TableColumn("Restart", "short"),
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
    inferred, value = parameter.inferred, parameter.value
    kind, unit, bounds = value_cells(value, inferred, marks)
    last = parameter.number + parameter.count - 1
    yield TableRow(
        (
            cell(*_numbers(parameter_set.number_text(parameter.number), parameter_set.number_text(last))),
            _wire(parameter_set, parameter.number, last),
            names(parameter, parameter.name, mark=marks.marks(inferred)),
            kind,
            access_cell(parameter.access, inferred, marks),
            unit,
            bounds,
            default_cell(value, inferred, marks),
            restart_cell(parameter.restart, inferred, marks) if restart else Cell(),
            cell(joined((text_piece(" ".join(name.split("_"))),) for name in parameter.applies_to)),
            cell(joined((code(name, f"#messages/{name}"),) for name in parameter.messages)),
            meaning_cell(context, parameter, value, *_special(parameter)),
            sources(parameter),
        ),
        parameter.place.path,
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
    if parameter.reserved:
        yield (styled("reserved", "badge"),)
    if parameter.trigger:
        text = " Writing has an effect; reading does not return the written value."
        yield (styled("trigger", "badge"), text_piece(text))
    if parameter.elements is not None:
        yield (text_piece(f"{parameter.elements} elements, subindex 0 to {parameter.elements - 1}"),)


def _subindex(context: Context, parameter: Parameter, inner: Subindex, marks: Inferences) -> TableRow:
    """The row of an element with a meaning of its own."""
    kind, unit, bounds = value_cells(inner.value, inner.inferred, marks)
    special: list[Line] = [(styled("reserved", "badge"),)] if inner.reserved else []
    index = spoken(inner.indices.text())
    subindex_name = f"{parameter.name}[{index}]" + (f" {inner.name}" if inner.name else "")
    return TableRow(
        (
            Cell(),
            Cell(),
            names(inner, subindex_name, mark=marks.all_marks(inner.inferred)),
            kind,
            access_cell(inner.access, inner.inferred, marks) if inner.access else Cell(),
            unit,
            bounds,
            default_cell(inner.value, inner.inferred, marks),
            Cell(),
            Cell(),
            Cell(),
            meaning_cell(context, inner, inner.value, *special),
            sources(inner),
        ),
        inner.place.path,
        element=True,
    )
