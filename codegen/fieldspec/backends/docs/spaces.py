"""Address spaces: what an address holds, how the manual numbers it, and which messages reach it."""

from __future__ import annotations

from fieldspec.backends.docs.context import Context, address, names, sources
from fieldspec.backends.docs.document import Line, Section, TableColumn, TableRow, cell, code, joined, table, text_piece
from fieldspec.backends.docs.sources import Inferences
from fieldspec.model.address_space import AddressSpace

COLUMNS = (
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
    """All address spaces in one table."""
    address_spaces = context.device.spaces
    marks = Inferences("spaces")
    rows = [_row(context, space, marks) for space in address_spaces.values()]
    blocks = (table("Address spaces", COLUMNS, rows, marks.footnotes()),) if rows else ()
    return Section("spaces", (text_piece("Address spaces"),), blocks)


def _row(context: Context, space: AddressSpace, marks: Inferences) -> TableRow:
    bounds = joined(((code(f"{address(low)}..{address(high)}"),) for low, high in space.bounds.intervals), ", ")
    return TableRow(
        (
            names(space, space.name, mark=marks.all_marks(space.inferred)),
            cell(f"a {space.unit}"),
            cell(bounds),
            cell(str(space.first_number)),
            cell(_messages(context, space, "read")),
            cell(_messages(context, space, "write")),
            cell(*context.about(space)),
            sources(space),
        ),
        space.place.path,
    )


def _messages(context: Context, space: AddressSpace, operation: str) -> Line:
    device = context.device
    messages = [
        message
        for message in device.messages.values()
        if message.accesses is not None
        and message.accesses.operation == operation
        and device.space_name(message.accesses.space) == space.name
    ]
    return joined(((code(message.name, f"#{message.place.path}"),) for message in messages), ", ")
