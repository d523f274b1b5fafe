"""Parameters that are addressed by number."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.docs.context import Context, cited, names, sources
from fieldspec.backends.docs.document import (
    Cell,
    Column,
    Facts,
    Line,
    Row,
    Section,
    cell,
    code,
    joined,
    plain,
    styled,
    table,
)
from fieldspec.backends.docs.inferences import Inferences
from fieldspec.backends.docs.value_cells import (
    VALUE_COLUMNS,
    access_cell,
    default_cell,
    meaning_cell,
    restart_cell,
    spoken,
    value_cells,
)
from fieldspec.model.parameter import Parameter, ParameterSet, Subindex

COLUMNS = (
    Column("Number", "number", kept=True),
    Column("On the wire", "number"),
    Column("Name", kept=True),
    VALUE_COLUMNS[0],
    Column("Access", "short", kept=True),
    *VALUE_COLUMNS[1:],
    Column("Default"),
    Column("Restart", "short"),
    Column("For"),
    Column("With"),
    Column("Meaning", "wide"),
    Column("Source", "source"),
)


def parameters(context: Context) -> Section:
    """All sets of parameters."""
    inner = tuple(_set(context, held) for held in context.device.parameters.values())
    return Section("parameters", (plain("Parameters"),), (), inner)


def _set(context: Context, held: ParameterSet) -> Section:
    path = held.place.path
    blocks = context.opening(held)
    if numbering := tuple(_numbering(held)):
        blocks.append(Facts(numbering))
    marks = Inferences(path)
    restart = any(parameter.restart is not None for parameter in held.parameters)
    rows = [row for parameter in held.parameters for row in _rows(context, held, parameter, marks, restart)]
    title = held.title or held.name
    blocks.append(table(title, COLUMNS, rows, marks.footnotes(), heading=2))
    if held.sources:
        blocks.append(Facts((("Source", (cited(held.sources),)),)))
    return Section(path, context.section_title(title, held), tuple(blocks))


def _numbering(held: ParameterSet) -> Iterator[tuple[str, tuple[Line, ...]]]:
    """How the numbers of a set are those on the wire, and which it has besides its rows."""
    if held.space != held.name:
        yield "Numbers are those of", ((code(held.space),),)
    if held.base:
        yield "On the wire", ((plain("its number + "), code(f"0x{held.base:X}")),)
    if held.numbers is not None:
        first, last = held.written(held.numbers.low), held.written(held.numbers.high)
        yield (
            "All numbers",
            ((code(first), plain(" to "), code(last), plain("; the table has those that are described")),),
        )


def _rows(
    context: Context, held: ParameterSet, parameter: Parameter, marks: Inferences, restart: bool
) -> Iterator[Row]:
    inferred, value = parameter.inferred, parameter.value
    kind, unit, bounds = value_cells(value, inferred, marks)
    last = parameter.number + parameter.count - 1
    yield Row(
        (
            cell(*_numbers(held.written(parameter.number), held.written(last))),
            _wire(held, parameter.number, last),
            names(parameter, parameter.name, mark=marks.marks(inferred)),
            kind,
            access_cell(parameter.access, inferred, marks),
            unit,
            bounds,
            default_cell(value, inferred, marks),
            restart_cell(parameter.restart, inferred, marks) if restart else Cell(),
            cell(joined((plain(" ".join(name.split("_"))),) for name in parameter.applies_to)),
            cell(joined((code(name, f"#messages/{name}"),) for name in parameter.messages)),
            meaning_cell(context, parameter, value, *_special(parameter)),
            sources(parameter),
        ),
        parameter.place.path,
    )
    for inner in parameter.subindices:
        yield _subindex(context, parameter, inner, marks)


def _numbers(first: str, last: str) -> list[Line]:
    return [(code(first),)] if first == last else [(code(first), plain(" to ")), (code(last),)]


def _wire(held: ParameterSet, first: int, last: int) -> Cell:
    """The numbers on the wire in both notations, where frames have these and not others."""
    if not held.base and held.space == held.name:
        return Cell()
    low, high = held.base + first, held.base + last
    return cell(*_numbers(f"0x{low:04X}", f"0x{high:04X}"), styled(str(low), "quiet"))


def _special(parameter: Parameter) -> Iterator[Line]:
    if parameter.reserved:
        yield (styled("reserved", "badge"),)
    if parameter.trigger:
        text = " Writing has an effect; reading does not give back what was written."
        yield (styled("trigger", "badge"), plain(text))
    if parameter.elements is not None:
        yield (plain(f"{parameter.elements} elements, sub-index 0 to {parameter.elements - 1}"),)


def _subindex(context: Context, parameter: Parameter, inner: Subindex, marks: Inferences) -> Row:
    """The row of an element with a meaning of its own."""
    kind, unit, bounds = value_cells(inner.value, inner.inferred, marks)
    special: list[Line] = [(styled("reserved", "badge"),)] if inner.reserved else []
    index = spoken(inner.indices.text())
    shown = f"{parameter.name}[{index}]" + (f" {inner.name}" if inner.name else "")
    return Row(
        (
            Cell(),
            Cell(),
            names(inner, shown, mark=marks.all_marks(inner.inferred)),
            kind,
            Cell(),
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
