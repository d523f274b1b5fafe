"""Tables of records in the register space, and records."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.docs.context import Context, address
from fieldspec.backends.docs.document import (
    Cell,
    Column,
    Facts,
    Line,
    Row,
    Section,
    Table,
    cell,
    code,
    joined,
    label,
    plain,
    styled,
    table,
)
from fieldspec.backends.docs.frames import elements_text, field_cells
from fieldspec.backends.docs.inferences import Inferences
from fieldspec.backends.docs.value_cells import VALUE_COLUMNS, access_cell, default_cell, restart_cell
from fieldspec.classes import replace
from fieldspec.layout.device import TableLayout
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.model.table import PrintedElement
from fieldspec.model.table import Table as TableOfRecords

# So many of the first elements have their addresses written out, and the last one.
FIRST = 3

FIELD = (
    Column("Name", kept=True),
    *VALUE_COLUMNS,
    Column("Meaning", "wide"),
    Column("Source", "source"),
)
OF_TABLE = (
    Column("Word", "number", kept=True),
    Column("Words", "number", kept=True),
    *FIELD[:2],
    Column("Access", "short", kept=True),
    *FIELD[2:4],
    Column("Default"),
    Column("Restart", "short"),
    *FIELD[4:],
)
OF_RECORD = (Column("Byte", "number", kept=True), Column("Bytes", "number", kept=True), *FIELD)


def tables(context: Context) -> Section:
    """All tables."""
    done: set[str] = set()
    inner = tuple(_table(context, laid, done) for laid in context.layout.tables.values())
    return Section("tables", (plain("Tables"),), (), inner)


def _table(context: Context, laid: TableLayout, done: set[str]) -> Section:
    """A table with the fields of its record; `done` are the records whose fields have their anchors already."""
    held = laid.table
    path = held.place.path
    blocks = context.opening(held)
    blocks.append(Facts(tuple(_facts(context, laid))))
    blocks += context.opening(laid.record.record)
    blocks.append(_fields(context, laid, laid.record.name not in done))
    done.add(laid.record.name)
    blocks.append(_addresses(laid))
    if held.elements:
        columns = (Column("Element"), Column("Printed addresses"), Column("Printed words"), Column("Source"))
        blocks.append(table("Elements as printed", columns, [_printed(element) for element in held.elements]))
    return Section(path, context.section_title(held.title or held.name, held), tuple(blocks))


def _facts(context: Context, laid: TableLayout) -> list[tuple[str, tuple[Line, ...]]]:
    held = laid.table
    first, last = held.indexes[0], held.indexes[-1]
    formula = f"address(n) = {address(held.base)} + {held.stride} * (n - {held.index_from})"
    record = laid.record.record
    printed = joined(((label(text),) for text in (record.printed_name, record.label) if text), " ")
    return [
        ("Name", ((code(held.name),),)),
        *_space(context, held),
        ("Elements", ((plain(f"{held.count}, numbered {first} to {last}"),),)),
        ("Address of element n", ((code(formula),),)),
        ("Words of an element", ((plain(f"{laid.words}; one element begins {held.stride} words after the other"),),)),
        ("Addresses", ((code(f"{address(held.base)}..{address(held.address(last) + laid.words - 1)}"),),)),
        ("Record", ((code(record.name, f"#{record.place.path}"), plain(" "), *printed),)),
    ]


def _space(context: Context, table: TableOfRecords) -> Iterator[tuple[str, tuple[Line, ...]]]:
    """The address space, where the device declares some."""
    if context.device.spaces:
        space = context.device.space(table.space)
        yield "Address space", ((plain(space.title or space.name, f"#{space.place.path}"),),)


def _fields(context: Context, laid: TableLayout, anchored: bool) -> Table:
    record = laid.record.record
    marks = Inferences(f"{laid.table.place.path}/fields")
    rows = [_table_row(context, field, laid.access(field.field), marks) for field in laid.record.fields]
    caption = f"Fields of an element, the record {record.name}"
    if not anchored:
        rows = [row._replace(anchor="") for row in rows]
    made = table(caption, OF_TABLE, rows, marks.footnotes(), heading=2)
    return replace(made, anchor=record.place.path if anchored else "")


def _table_row(context: Context, field: FieldLayout, access: str, marks: Inferences) -> Row:
    inferred, value = field.field.inferred, field.value
    many = elements_text(field, "k") if field.listed else ""
    path = f"{field.name}[k]" if field.listed else field.name
    name, kind, unit, bounds, meaning, source = field_cells(context, field, path, many, marks)
    return Row(
        (
            cell(_word(field)),
            cell(str((field.size * (field.count or 1) + 1) // 2)),
            name,
            kind,
            access_cell(access, inferred, marks) if not field.field.reserved else Cell(),
            unit,
            bounds,
            default_cell(value, inferred, marks) if value else Cell(),
            restart_cell(field.field.restart, inferred, marks) if field.field.restart is not None else Cell(),
            meaning,
            source,
        ),
        field.field.place.path,
    )


def _word(field: FieldLayout) -> Line:
    """`+3`, with the half of the word where the field begins in its middle."""
    half: Line = (styled(" second byte", "quiet"),) if field.offset % 2 else ()
    return (code(f"+{field.offset // 2}"), *half)


def _addresses(laid: TableLayout) -> Table:
    """The addresses of each field in the first elements and in the last one."""
    held = laid.table
    shown = [*held.indexes[:FIRST], *held.indexes[max(FIRST, held.count - 1) :]]
    columns = [Column("Field", kept=True), *(Column(f"Element {index}", "number", kept=True) for index in shown)]
    rows = [
        Row(
            (
                cell(code(field.name)),
                *(cell(_span(held.address(index) + field.offset // 2, field)) for index in shown),
            )
        )
        for field in laid.record.fields
    ]
    return table("Addresses", columns, rows)


def _span(first: int, field: FieldLayout) -> Line:
    last = first + (field.offset % 2 + field.size * (field.count or 1) - 1) // 2
    return (code(address(first) if first == last else f"{address(first)}..{address(last)}"),)


def _printed(element: PrintedElement) -> Row:
    first, last = element.first, element.last
    spans = [address(bound) for bound in (first, last) if bound is not None]
    return Row(
        (
            cell(str(element.index)),
            cell(code("..".join(spans))),
            cell("" if element.words is None else str(element.words)),
            cell("; ".join(citation.text() for citation in element.sources)),
        )
    )


def records(context: Context) -> Section:
    """The records that no table shows."""
    shown = {laid.record.name for laid in context.layout.tables.values()}
    inner = tuple(_record(context, laid) for laid in context.layout.records.values() if laid.name not in shown)
    return Section("records", (plain("Records"),), (), inner)


def _record(context: Context, laid: RecordLayout) -> Section:
    record = laid.record
    path = record.place.path
    blocks = context.opening(record)
    users = context.users(path)
    facts: list[tuple[str, tuple[Line, ...]]] = [("Size", ((plain(_size(laid)),),))]
    if users:
        facts.append(("Used by", (users,)))
    blocks.append(Facts(tuple(facts)))
    marks = Inferences(path)
    rows = [_record_row(context, field, marks) for field in laid.fields]
    blocks.append(table(f"Fields of {record.name}", OF_RECORD, rows, marks.footnotes(), heading=2))
    return Section(path, (code(record.name), *context.section_title("", record)[1:]), tuple(blocks))


def _size(laid: RecordLayout) -> str:
    if laid.size is not None:
        return f"{laid.size} bytes"
    return f"{laid.least} to {laid.most} bytes"


def _record_row(context: Context, field: FieldLayout, marks: Inferences) -> Row:
    many = elements_text(field, "k") if field.listed else ""
    path = f"{field.name}[k]" if field.listed else field.name
    step = f" + {field.size}k" if field.listed else ""
    cells = field_cells(context, field, path, many, marks)
    return Row((cell(code(f"{field.offset}{step}")), cell(str(field.size)), *cells), field.field.place.path)
