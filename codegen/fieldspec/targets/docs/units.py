"""Units that the spec declares: symbol, quantity, code and factor."""

from __future__ import annotations

from fieldspec.language.model.units import DeclaredUnit
from fieldspec.targets.docs.context import Context, fact_row, names
from fieldspec.targets.docs.document import Section, TableColumn, TableRow, cell, code, table, text_piece
from fieldspec.targets.docs.sources import Inferences

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
