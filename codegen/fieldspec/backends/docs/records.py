"""Record tables in the register space, and records."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.docs.context import Context, address
from fieldspec.backends.docs.document import (
    Cell,
    DocumentTable,
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
from fieldspec.backends.docs.links import elements_text, field_cells
from fieldspec.backends.docs.sources import Inferences
from fieldspec.backends.docs.value_cells import VALUE_COLUMNS, access_cell, default_cell, restart_cell
from fieldspec.classes import replace
from fieldspec.layout.device import TableLayout
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.model.registers import PrintedElement
from fieldspec.model.registers import Table as TableOfRecords

# So many of the first elements have their addresses written out, and the last one.
FIRST = 3

FIELD = (
    TableColumn("Name", unbroken=True),
    *VALUE_COLUMNS,
    TableColumn("Meaning", "wide"),
    TableColumn("Source", "source"),
)
OF_TABLE = (
    TableColumn("Word", "number", unbroken=True),
    TableColumn("Words", "number", unbroken=True),
    *FIELD[:2],
    TableColumn("Access", "short", unbroken=True),
    *FIELD[2:4],
    TableColumn("Default"),
    TableColumn("Restart", "short"),
    *FIELD[4:],
)
OF_RECORD = (TableColumn("Byte", "number", unbroken=True), TableColumn("Bytes", "number", unbroken=True), *FIELD)


def tables(context: Context) -> Section:
    """All tables."""
    done: set[str] = set()
    inner = tuple(_table(context, laid, done) for laid in context.layout.tables.values())
    return Section("tables", (text_piece("Tables"),), (), inner)


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
        columns = (
            TableColumn("Element"),
            TableColumn("Printed addresses"),
            TableColumn("Printed words"),
            TableColumn("Source"),
        )
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
        ("Elements", ((text_piece(f"{held.count}, numbered {first} to {last}"),),)),
        ("Address of element n", ((code(formula),),)),
        (
            "Words of an element",
            ((text_piece(f"{laid.words}; one element begins {held.stride} words after the other"),),),
        ),
        ("Addresses", ((code(f"{address(held.base)}..{address(held.address(last) + laid.words - 1)}"),),)),
        ("Record", ((code(record.name, f"#{record.place.path}"), text_piece(" "), *printed),)),
    ]


def _space(context: Context, table: TableOfRecords) -> Iterator[tuple[str, tuple[Line, ...]]]:
    """The address space, where the device declares some."""
    if context.device.spaces:
        space = context.device.space(table.space)
        yield "Address space", ((text_piece(space.title or space.name, f"#{space.place.path}"),),)


def _fields(context: Context, laid: TableLayout, anchored: bool) -> DocumentTable:
    record = laid.record.record
    marks = Inferences(f"{laid.table.place.path}/fields")
    rows = [_table_row(context, field, laid.access(field.field), marks) for field in laid.record.fields]
    caption = f"Fields of an element, the record {record.name}"
    if not anchored:
        rows = [row._replace(anchor="") for row in rows]
    made = table(caption, OF_TABLE, rows, marks.footnotes(), heading=2)
    return replace(made, anchor=record.place.path if anchored else "")


def _table_row(context: Context, field: FieldLayout, access: str, marks: Inferences) -> TableRow:
    inferred, value = field.field.inferred, field.value
    many = elements_text(field, "k") if field.is_list else ""
    path = f"{field.name}[k]" if field.is_list else field.name
    name, kind, unit, bounds, meaning, source = field_cells(context, field, path, many, marks)
    return TableRow(
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


def _addresses(laid: TableLayout) -> DocumentTable:
    """The addresses of each field in the first elements and in the last one."""
    held = laid.table
    shown = [*held.indexes[:FIRST], *held.indexes[max(FIRST, held.count - 1) :]]
    columns = [
        TableColumn("Field", unbroken=True),
        *(TableColumn(f"Element {index}", "number", unbroken=True) for index in shown),
    ]
    rows = [
        TableRow(
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


def _printed(element: PrintedElement) -> TableRow:
    first, last = element.first, element.last
    spans = [address(bound) for bound in (first, last) if bound is not None]
    return TableRow(
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
    return Section("records", (text_piece("Records"),), (), inner)


def _record(context: Context, laid: RecordLayout) -> Section:
    record = laid.record
    path = record.place.path
    blocks = context.opening(record)
    users = context.users(path)
    facts: list[tuple[str, tuple[Line, ...]]] = [("Size", ((text_piece(_size(laid)),),))]
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


def _record_row(context: Context, field: FieldLayout, marks: Inferences) -> TableRow:
    many = elements_text(field, "k") if field.is_list else ""
    path = f"{field.name}[k]" if field.is_list else field.name
    step = f" + {field.size}k" if field.is_list else ""
    cells = field_cells(context, field, path, many, marks)
    return TableRow((cell(code(f"{field.offset}{step}")), cell(str(field.size)), *cells), field.field.place.path)
