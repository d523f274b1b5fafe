"""Reads lists of values: what each row asks for, and all that is wrong with a list."""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Mapping

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.tools.lists.sheet import Sheet, SheetRow
from fieldspec.tools.live.value_lists import DEVICE, INDEX, NAME, TABLE, VALUE, VERSION
from fieldspec.tools.live.writing import WriteError

if TYPE_CHECKING:
    from fieldspec.tools.live.access import Access, Assignment, Item

_CAPITALS = (DEVICE, VERSION, TABLE, INDEX, NAME, VALUE)


@dataclass(frozen=True, slots=True)
class ListFinding:
    """The fault of a cell. Rows and columns count from 1; a column 0 means the whole row."""

    row: int
    column: int
    text: str


@dataclass(frozen=True, slots=True)
class _Demand:
    """A cell with a value for a path. `whole` is the column of the value, `name` that of the path."""

    row: int
    name: int
    whole: int
    path: str
    text: str


def entries(
    access: Access, sheet: Sheet, table: str = "", any_version: bool = False
) -> tuple[list[Assignment], list[ListFinding]]:
    """The values that a list asks for, in its order, and all findings. Nothing may be written where there are any.

    A list has the headings `Name` and `Value`, or `Index` and names of fields. Then the table is `table`, the one that
    the column `Table` names, or the only one of the device. An empty cell asks for nothing.
    """
    layout = access.layout
    head, *rows = sheet.rows
    columns = {text: number for number, text in enumerate(head.cells) if text}
    findings = list(_of_head(head, columns))
    if findings:
        return [], findings
    for row in rows:
        findings += _of_device(layout, row, columns, any_version)
    findings += [
        ListFinding(row, column, "is a formula; save the list with values")
        for row, column in sorted(sheet.formulas)
        if row != head.number
    ]
    known = {access.path(item): item for item in access.items()}
    demands: list[_Demand] = []
    for row in rows:
        new, wrong = _of_row(layout, row, columns, table)
        demands += new
        findings += wrong
    result: list[Assignment] = []
    rows_by_path: dict[str, int] = {}
    for demand in demands:
        text = _problem(access, demand, known, rows_by_path)
        if text:
            findings.append(ListFinding(demand.row, demand.name + 1, text))
            continue
        rows_by_path[demand.path] = demand.row
        try:
            result.append(access.assignment(known[demand.path], demand.text))
        except WriteError as error:
            findings.append(ListFinding(demand.row, demand.whole + 1, str(error)))
    result, problems = access.together(result)
    findings += [
        ListFinding(demand.row, demand.whole + 1, problems[demand.path])
        for demand in demands
        if demand.path in problems
    ]
    if not result and not findings:
        findings.append(ListFinding(head.number, 0, "no row below has a value"))
    return result, sorted(set(findings), key=lambda finding: (finding.row, finding.column, finding.text))


def _of_head(head: SheetRow, columns: Mapping[str, int]) -> Iterator[ListFinding]:
    if not ({NAME, VALUE} <= columns.keys() or INDEX in columns):
        yield ListFinding(
            head.number, 0, f"the headings are {NAME} and {VALUE} for settings, {INDEX} and names of fields for a table"
        )
    for number, text in enumerate(head.cells):
        if text and columns[text] != number:
            yield ListFinding(head.number, number + 1, f"the heading {text} stands here twice")
        elif text and text not in _CAPITALS and text.capitalize() in _CAPITALS and text.capitalize() not in columns:
            yield ListFinding(head.number, number + 1, f"write the heading as {text.capitalize()}")
        elif text and INDEX not in columns and text not in (DEVICE, VERSION, NAME, VALUE):
            yield ListFinding(head.number, number + 1, f"a list of settings has no column {text}")


def _of_device(
    layout: DeviceLayout, row: SheetRow, columns: Mapping[str, int], any_version: bool
) -> Iterator[ListFinding]:
    """A list that comes from another device, or from another version."""
    device = layout.device
    for heading, own, free in ((DEVICE, device.id, False), (VERSION, device.version, any_version)):
        text = row.cell(columns[heading]) if heading in columns else ""
        if text and text != own and not free:
            hint = "; --any-version takes it nevertheless" if heading == VERSION else ""
            yield ListFinding(row.number, columns[heading] + 1, f"is for the {heading.lower()} {text}, not {own}{hint}")


def _of_row(
    layout: DeviceLayout, row: SheetRow, columns: Mapping[str, int], table: str
) -> tuple[list[_Demand], list[ListFinding]]:
    if INDEX not in columns:
        path, text = row.cell(columns[NAME]), row.cell(columns[VALUE])
        if not path and text:
            return [], [ListFinding(row.number, columns[NAME] + 1, "a value without a name")]
        return [_Demand(row.number, columns[NAME], columns[VALUE], path, text)] if text else [], []
    name = table or (row.cell(columns[TABLE]) if TABLE in columns else "")
    name = name or (next(iter(layout.tables)) if len(layout.tables) == 1 else "")
    if name not in layout.tables:
        if not layout.tables:
            text = f"{layout.device.id} has no tables; write Name and Value in each row"
        else:
            names = ", ".join(layout.tables)
            missing = f"the row names no table: add a column Table, or --table with one of {names}"
            text = f"there is no table {name}; choose from {names}" if name else missing
        return [], [ListFinding(row.number, columns.get(TABLE, -1) + 1, text)]
    index, indexes = row.cell(columns[INDEX]), layout.tables[name].table.indexes
    if not index.isascii() or not index.isdecimal() or int(index) not in indexes:
        text = f"there is no {name}[{index}]; choose from {indexes[0]}..{indexes[-1]}"
        return [], [ListFinding(row.number, columns[INDEX] + 1, text)]
    demands = [
        _Demand(row.number, column, column, f"{name}[{int(index)}].{field}", row.cell(column))
        for field, column in columns.items()
        if field not in (DEVICE, VERSION, TABLE, INDEX) and row.cell(column)
    ]
    return demands, []


def _problem(access: Access, demand: _Demand, known: Mapping[str, Item], rows_by_path: Mapping[str, int]) -> str:
    """Why a path cannot be set by a list; empty where it can."""
    if demand.path not in known:
        matches = difflib.get_close_matches(demand.path, known, 1, 0.6)
        return f"there is no {demand.path}" + (f"; did you mean {matches[0]}?" if matches else "")
    if demand.path in rows_by_path:
        return f"{demand.path} stands in row {rows_by_path[demand.path]} too"
    objection = access.objection(known[demand.path])
    return f"{demand.path} {objection}" if objection else ""
