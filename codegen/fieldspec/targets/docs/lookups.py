"""Lookup tables, limits and notes, and the units that the spec declares."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.model.fact import ScalarValue
from fieldspec.language.model.texts import Limit, Lookup, LookupColumn, LookupRow, Note
from fieldspec.language.model.units import DeclaredUnit
from fieldspec.targets.docs.context import Context, cited, fact_row, names
from fieldspec.targets.docs.document import (
    Block,
    Cell,
    Facts,
    Line,
    Paragraph,
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

KINDS = {
    "timing": "Timings",
    "limit": "Limits",
    "electrical": "Electrical data",
    "link": "The line",
    "capacity": "Capacities",
}
LIMITS = (
    TableColumn("Name", unbroken=True),
    TableColumn("Value", "number", unbroken=True),
    TableColumn("Meaning", "wide"),
    TableColumn("Source", "source"),
)

STATEMENTS = (
    TableColumn("Subject", unbroken=True),
    TableColumn("Is so", unbroken=True),
    TableColumn("What that place states", "wide"),
    TableColumn("Source", "source"),
)


def lookups(context: Context) -> Section:
    """The section of all lookup tables: pins, lamps, priorities and the like."""
    inner = tuple(_lookup(context, lookup) for lookup in context.device.lookups)
    return Section("lookups", (text_piece("Pins, LEDs and other tables"),), (), inner)


def _lookup(context: Context, lookup: Lookup) -> Section:
    blocks = context.opening(lookup)
    columns = [
        *(TableColumn(_title(column), unbroken=True) for column in lookup.columns),
        TableColumn("Notes", "wide"),
        TableColumn("Source", "source"),
    ]
    rows = [_lookup_row(context, lookup.columns, row) for row in lookup.rows]
    title = lookup.title or lookup.name
    blocks.append(table(title, columns, rows))
    if lookup.sources:
        blocks.append(Facts((("Source", (cited(lookup.sources),)),)))
    return Section(lookup.place.path, context.section_title(title, lookup), tuple(blocks))


def _title(column: LookupColumn) -> str:
    title = column.title or " ".join(column.name.split("_")).capitalize()
    return f"{title} {column.label}".strip()


def _lookup_row(context: Context, columns: tuple[LookupColumn, ...], row: LookupRow) -> TableRow:
    notes: list[Line] = [(styled(f"only {', '.join(row.only)}", "badge"),)] if row.only else []
    notes += [(text_piece(row.notes),)] if row.notes else []
    cells = [_lookup_cell(context, column, value) for column, value in zip(columns, row.cells, strict=True)]
    source_cell = cell(cited(row.sources))
    return TableRow((*cells, cell(*notes, *context.beside(row.place)), source_cell), row.place.path)


def _lookup_cell(context: Context, column: LookupColumn, value: ScalarValue) -> Cell:
    if value is None:
        return Cell()
    text = {True: "yes", False: "no"}[value] if isinstance(value, bool) else str(value)
    if column.enum:
        return cell(code(text, f"#enums/{column.enum}/{text}"))
    return cell(text)


def limits(context: Context) -> Section:
    """All single numbers, by what they are about."""
    inner = []
    for kind, title in KINDS.items():
        limits_of_kind = [limit for limit in context.device.limits if limit.kind == kind]
        if limits_of_kind:
            path = f"limits-{kind}"
            marks = Inferences(path)
            rows = [_limit(context, limit, marks) for limit in limits_of_kind]
            blocks = (table(title, LIMITS, rows, marks.footnotes()),)
            inner.append(Section(path, (text_piece(title),), blocks))
    return Section("limits", (text_piece("Timings and limits"),), (), tuple(inner))


def _limit(context: Context, limit: Limit, marks: Inferences) -> TableRow:
    return fact_row(
        limit,
        names(limit, limit.name, mark=marks.all_marks(limit.inferred)),
        cell(*_limit_lines(limit)),
        cell(*context.about(limit)),
    )


def _limit_lines(limit: Limit) -> Iterator[str]:
    unit = f" {limit.unit}" if limit.unit else ""
    if limit.value is not None:
        yield f"{limit.value:f}{unit}"
    if limit.low is not None and limit.high is not None:
        yield f"{limit.low:f} to {limit.high:f}{unit}"
    elif limit.low is not None:
        yield f"at least {limit.low:f}{unit}"
    elif limit.high is not None:
        yield f"at most {limit.high:f}{unit}"
    if limit.text:
        yield limit.text
    if limit.sum_of:
        yield f"the sum of {', '.join(_short(path) for path in limit.sum_of)}"
    if limit.transmits:
        yield f"before the longest {limit.transmits}"
    if limit.within:
        yield f"within {_short(limit.within)}"


def _short(path: str) -> str:
    """The name at the end of a path."""
    return path.rpartition("/")[2]


def notes(context: Context) -> Section:
    """The section of caveats that belong to no single fact."""
    inner = tuple(_note(context, note) for note in context.device.notes)
    return Section("notes", (text_piece("Notes"),), (), inner)


def _note(context: Context, note: Note) -> Section:
    facts: list[tuple[str, tuple[Line, ...]]] = []
    if note.about:
        facts.append(("About", (joined((context.link_to(path),) for path in note.about),)))
    if note.sources:
        facts.append(("Source", (cited(note.sources),)))
    blocks: list[Block] = [Paragraph((text_piece(note.text),))]
    if note.statements:
        rows = [
            TableRow(
                (
                    cell(code(statement.subject)),
                    cell(statement.says),
                    cell(statement.text),
                    cell(cited(statement.sources)),
                ),
                statement.place.path,
            )
            for statement in note.statements
        ]
        blocks.append(table("General statements of the manual", STATEMENTS, rows))
    blocks += [Paragraph(line) for line in context.holding.badges(note.place.path)]
    if facts:
        blocks.append(Facts(tuple(facts)))
    title: Line = (text_piece(note.title),) if note.title else (code(note.name),)
    return Section(note.place.path, title, tuple(blocks))


COLUMNS = (
    TableColumn("Symbol", unbroken=True),
    TableColumn("Name", unbroken=True),
    TableColumn("Quantity", "short"),
    TableColumn("SI units", "number"),
    TableColumn("UCUM", "short"),
    TableColumn("Meaning", "wide"),
    TableColumn("Source", "source"),
)


def units(context: Context) -> Section:
    """The section of all declared units in one table."""
    marks = Inferences("units")
    rows = [_unit_row(context, unit, marks) for unit in context.device.units.values()]
    blocks = (table("Units", COLUMNS, rows, marks.footnotes()),) if rows else ()
    return Section("units", (text_piece("Units"),), blocks)


def _unit_row(context: Context, unit: DeclaredUnit, marks: Inferences) -> TableRow:
    return fact_row(
        unit,
        cell(unit.symbol),
        names(unit, unit.title or unit.name, mark=marks.all_marks(unit.inferred)),
        cell(unit.quantity.replace("_", " ")),
        cell(unit.factor),
        cell((code(unit.ucum),)) if unit.ucum else cell(""),
        cell(*context.about(unit)),
    )
