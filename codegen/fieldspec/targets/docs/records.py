"""Record tables in the register space, and records."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import TableLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.model.access import narrowed
from fieldspec.language.model.registers import PrintedElement
from fieldspec.language.model.registers import Table as TableOfRecords
from fieldspec.targets.docs.context import Context, address
from fieldspec.targets.docs.document import (
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
from fieldspec.targets.docs.links import element_position, elements_text, field_cells, separator
from fieldspec.targets.docs.positions import Position, placed_fields
from fieldspec.targets.docs.sources import Inferences
from fieldspec.targets.docs.value_cells import SETTING_COLUMNS, VALUE_COLUMNS, access_cell, default_cell, restart_cell

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
    *SETTING_COLUMNS,
    *FIELD[4:],
)
OF_RECORD = (TableColumn("Byte", "number", unbroken=True), TableColumn("Bytes", "number", unbroken=True), *FIELD)


def tables(context: Context) -> Section:
    """The section of all tables of records."""
    done: set[str] = set()
    inner = tuple(_table(context, table_layout, done) for table_layout in context.layout.tables.values())
    return Section("tables", (text_piece("Tables"),), (), inner)


def _table(context: Context, table_layout: TableLayout, done: set[str]) -> Section:
    """A table with the fields of its record; `done` are the records whose fields have their anchors already."""
    model = table_layout.table
    path = model.place.path
    blocks = context.opening(model)
    blocks.append(Facts(tuple(_facts(context, table_layout))))
    blocks += context.opening(table_layout.record.record)
    blocks.append(_fields(context, table_layout, table_layout.record.name not in done))
    done.add(table_layout.record.name)
    blocks.append(_addresses(table_layout))
    if model.elements:
        columns = (
            TableColumn("Element"),
            TableColumn("Printed addresses"),
            TableColumn("Printed words"),
            TableColumn("Source"),
        )
        blocks.append(table("Elements as printed", columns, [_printed(element) for element in model.elements]))
    return Section(path, context.section_title(model.title or model.name, model), tuple(blocks))


def _facts(context: Context, table_layout: TableLayout) -> list[tuple[str, tuple[Line, ...]]]:
    model = table_layout.table
    first, last = model.indexes[0], model.indexes[-1]
    formula = f"address(n) = {model.base_by or address(model.base)} + {model.stride} * (n - {model.index_from})"
    record = table_layout.record.record
    printed = joined(((label(text),) for text in (record.printed_name, record.label) if text), " ")
    return [
        ("Name", ((code(model.name),),)),
        *_space(context, model),
        *separator(table_layout.record),
        ("Elements", (_elements_text(context, model, f"{model.count}, numbered {first} to {last}"),)),
        ("Address of element n", ((code(formula), *_base_text(context, model)),)),
        (
            "Words of an element",
            ((text_piece(f"{table_layout.words}; one element begins {model.stride} words after the other"),),),
        ),
        (
            "Usual addresses" if model.base_by else "Addresses",
            ((code(f"{address(model.base)}..{address(model.address(last) + table_layout.words - 1)}"),),),
        ),
        ("Record", ((code(record.name, f"#{record.place.path}"), text_piece(" "), *printed),)),
    ]


def _elements_text(context: Context, table: TableOfRecords, text: str) -> Line:
    """How many elements there are, or can be where a register has their number."""
    register = context.device.register(table.count_by) if table.count_by else None
    if register is None:
        return (text_piece(text),)
    return text_piece(f"up to {text}; the number is in "), code(register.name, f"#{register.place.path}")


def _base_text(context: Context, table: TableOfRecords) -> Line:
    """Where the address of the first element is, of a table of which a register has it."""
    register = context.device.register(table.base_by) if table.base_by else None
    if register is None:
        return ()
    return (
        text_piece("; the register "),
        code(register.name, f"#{register.place.path}"),
        text_piece(f" has the address of the first element, usually {address(table.base)}"),
    )


def _space(context: Context, table: TableOfRecords) -> Iterator[tuple[str, tuple[Line, ...]]]:
    """The address space, where the device declares some."""
    if context.device.spaces:
        space = context.device.space(table.space)
        yield "Address space", ((text_piece(space.title or space.name, f"#{space.place.path}"),),)


def _fields(context: Context, table_layout: TableLayout, anchored: bool) -> DocumentTable:
    record = table_layout.record.record
    marks = Inferences(f"{table_layout.table.place.path}/fields")
    holder = _Holder(context, marks, table_layout.table.access)
    rows = [row for field in table_layout.record.stated_fields for row in _table_rows(holder, field)]
    caption = f"Fields of an element, the record {record.name}"
    if not anchored:
        rows = [row._replace(anchor="") for row in rows]
    field_table = table(caption, OF_TABLE, rows, marks.footnotes(), heading=2)
    return replace(field_table, anchor=record.place.path if anchored else "")


@dataclass(frozen=True, slots=True)
class _Holder:
    """The place of fields in an element of a table: its access, the bytes before it, and the path that leads to it.

    `steps` are the sizes in bytes of the elements of the lists that it is in, whose numbers are k, l and so on.
    """

    context: Context
    marks: Inferences
    access: str
    restart: bool | None = None
    offset: int = 0
    path: str = ""
    steps: tuple[int, ...] = ()


def _table_rows(holder: _Holder, field: FieldLayout) -> Iterator[TableRow]:
    """The row of a field, and the rows of its record's fields, which have their anchors at that record."""
    row = _table_row(holder, field)
    yield row._replace(anchor="") if holder.path else row
    if field.record is None:
        return
    inner = replace(
        holder,
        access=narrowed(holder.access, field.field.access),
        restart=_restart(holder, field),
        offset=holder.offset + field.offset,
        path=f"{holder.path}{_indexed_name(holder, field)}.",
        steps=(*holder.steps, field.size) if field.is_list else holder.steps,
    )
    for own in field.record.stated_fields:
        yield from _table_rows(inner, own)


def _restart(holder: _Holder, field: FieldLayout) -> bool | None:
    """Whether a change takes effect after a restart, as the field or else its holder states it."""
    return holder.restart if field.field.restart is None else field.field.restart


def _letter(holder: _Holder) -> str:
    """The letter of the numbers of a list in the holder."""
    return chr(ord("k") + len(holder.steps))


def _indexed_name(holder: _Holder, field: FieldLayout) -> str:
    return f"{field.name}[{_letter(holder)}]" if field.is_list else field.name


def _table_row(holder: _Holder, field: FieldLayout) -> TableRow:
    context, marks = holder.context, holder.marks
    inferred, value = field.field.inferred, field.value
    elements = elements_text(field, _letter(holder)) if field.is_list else ""
    path = f"{holder.path}{_indexed_name(holder, field)}"
    access = narrowed(holder.access, field.field.access)
    restart = _restart(holder, field)
    name, kind, unit, bounds, meaning, source = field_cells(context, field, path, elements, marks)
    return TableRow(
        (
            cell(_word(holder, field)),
            cell(str((field.size * (field.count or 1) + 1) // 2)),
            name,
            kind,
            access_cell(access, inferred, marks) if not field.field.reserved else Cell(),
            unit,
            bounds,
            default_cell(value, inferred, marks) if value else Cell(),
            restart_cell(restart, inferred, marks) if restart is not None and value is not None else Cell(),
            meaning,
            source,
        ),
        field.field.place.path,
    )


def _word(holder: _Holder, field: FieldLayout) -> Line:
    """`+3`, or `+3 + 2k` in a list, with the half of the word where the field begins in its middle.

    In a list of elements with odd sizes, it is `byte 6 + 5k`.
    """
    offset = holder.offset + field.offset
    unit = 1 if any(step % 2 for step in holder.steps) else 2
    terms = "".join(f" + {step // unit}{chr(ord('k') + number)}" for number, step in enumerate(holder.steps))
    if unit == 1:
        return (code(f"byte {offset}{terms}"),)
    half: Line = (styled(" second byte", "quiet"),) if offset % 2 else ()
    return (code(f"+{offset // 2}{terms}"), *half)


def _addresses(table_layout: TableLayout) -> DocumentTable:
    """The addresses of each field in the first elements and in the last one."""
    model = table_layout.table
    indexes = [*model.indexes[:FIRST], *model.indexes[max(FIRST, model.count - 1) :]]
    columns = [
        TableColumn("Field", unbroken=True),
        *(TableColumn(f"Element {index}", "number", unbroken=True) for index in indexes),
    ]
    rows = [
        TableRow(
            (
                cell(code(field.name)),
                *(cell(_span(model.address(index) + field.offset // 2, field)) for index in indexes),
            )
        )
        for field in table_layout.record.stated_fields
    ]
    return table("Usual addresses" if model.base_by else "Addresses", columns, rows)


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
    """The section of the records that no table shows."""
    in_tables = {table_layout.record.name for table_layout in context.layout.tables.values()}
    inner = tuple(
        _record(context, record_layout)
        for record_layout in context.layout.records.values()
        if record_layout.name not in in_tables
    )
    return Section("records", (text_piece("Records"),), (), inner)


def _record(context: Context, record_layout: RecordLayout) -> Section:
    record = record_layout.record
    path = record.place.path
    blocks = context.opening(record)
    users = context.users(path)
    facts: list[tuple[str, tuple[Line, ...]]] = [("Size", ((text_piece(_size(record_layout)),),))]
    facts += separator(record_layout)
    if users:
        facts.append(("Used by", (users,)))
    blocks.append(Facts(tuple(facts)))
    marks = Inferences(path)
    rows = [_record_row(context, field, start, marks) for field, start in placed_fields(record_layout)]
    blocks.append(table(f"Fields of {record.name}", OF_RECORD, rows, marks.footnotes(), heading=2))
    return Section(path, (code(record.name), *context.section_title("", record)[1:]), tuple(blocks))


def _size(record_layout: RecordLayout) -> str:
    if record_layout.least == record_layout.most:
        return f"{record_layout.least} bytes"
    return f"{record_layout.least} to {record_layout.most} bytes"


def _record_row(context: Context, field: FieldLayout, start: Position, marks: Inferences) -> TableRow:
    elements = elements_text(field, "k") if field.is_list else ""
    path = f"{field.name}[k]" if field.is_list else field.name
    place = (element_position(field, start, "k") if field.is_list else start).text(1)
    size = str(field.size) if field.least_size == field.size else f"{field.least_size} to {field.size}"
    size = size if field.packing is None else f"{field.packing.number.bits} / 8"
    cells = field_cells(context, field, path, elements, marks)
    return TableRow((cell(code(place)), cell(size), *cells), field.field.place.path)
