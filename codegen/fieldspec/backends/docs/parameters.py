"""Parameters that are addressed by number."""

from __future__ import annotations

from fieldspec.backends.docs.context import Context, cited, names, sources
from fieldspec.backends.docs.document import (
    Cell,
    Column,
    Facts,
    Line,
    Row,
    Section,
    cell,
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
    value_cells,
)
from fieldspec.model.parameter import Parameter, ParameterSet

COLUMNS = (
    Column("Number", "number", kept=True),
    Column("Name", kept=True),
    VALUE_COLUMNS[0],
    Column("Access", "short", kept=True),
    *VALUE_COLUMNS[1:],
    Column("Default"),
    Column("Restart", "short"),
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
    marks = Inferences(path)
    restart = any(parameter.restart is not None for parameter in held.parameters)
    rows = [_row(context, parameter, marks, restart) for parameter in held.parameters]
    title = held.title or held.name
    blocks.append(table(title, COLUMNS, rows, marks.footnotes(), heading=1))
    if held.sources:
        blocks.append(Facts((("Source", (cited(held.sources),)),)))
    return Section(path, context.section_title(title, held), tuple(blocks))


def _row(context: Context, parameter: Parameter, marks: Inferences, restart: bool) -> Row:
    inferred, value = parameter.inferred, parameter.value
    kind, unit, bounds = value_cells(value, inferred, marks)
    special: list[Line] = [(styled("reserved", "badge"),)] if parameter.reserved else []
    return Row(
        (
            cell(str(parameter.number)),
            names(parameter, parameter.name, mark=marks.marks(inferred)),
            kind,
            access_cell(parameter.access, inferred, marks),
            unit,
            bounds,
            default_cell(value, inferred, marks),
            restart_cell(parameter.restart, inferred, marks) if restart else Cell(),
            meaning_cell(context, parameter, value, *special),
            sources(parameter),
        ),
        parameter.place.path,
    )
