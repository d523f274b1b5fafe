"""Collects the objects of a file as rows of a list: every key of an object is used, a note, or named as not used."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from decimal import Decimal

from fieldspec.foundation.classes import dataclass, field, replace
from fieldspec.foundation.spreadsheet import clean
from fieldspec.tools.lists.addresses import DECIMAL, AddressText, Place
from fieldspec.tools.lists.assumption import Assumption, Refusal
from fieldspec.tools.lists.column_roles import Columns
from fieldspec.tools.lists.heading_words import NOTE
from fieldspec.tools.lists.listing import Listing
from fieldspec.tools.lists.numbering import Placed
from fieldspec.tools.lists.row_reading import ListRow
from fieldspec.tools.lists.sheet import MOST_COLUMNS, MOST_ROWS, CellError, ListError, Sheet, SheetRow

_LONGEST_NOTE = 400
_LONGEST_NUMBER = 60


@dataclass(frozen=True, slots=True)
class _Item:
    """An object of a file: its line, its keys as cells, its row if it was taken, and what was not."""

    line: int
    cells: Mapping[str, str]
    row: ListRow | None = None
    refusals: tuple[tuple[str, str], ...] = ()


@dataclass(slots=True)
class FormatRows:
    """The objects of a file of a format, in its order.

    `roles` are what its keys say, `notes` the keys that are kept as notes.
    """

    format: str
    roles: Mapping[str, str]
    notes: Collection[str] = ()
    assumptions: list[Assumption] = field(default_factory=list)
    items: list[_Item] = field(default_factory=list)

    def add(self, line: int, cells: Mapping[str, str], row: ListRow) -> None:
        """Adds an object that is taken."""
        self._append(_Item(line, cells, row))

    def refuse(self, line: int, cells: Mapping[str, str], reason: str, key: str = "") -> None:
        """Adds an object that is not taken, for the reason, which is about a key."""
        self._append(_Item(line, cells, None, ((key, reason),)))

    def take(self, line: int, cells: Mapping[str, str], read: Callable[[], ListRow]) -> None:
        """Adds an object with the row that is read of it, or refuses it for the reason of a CellError."""
        try:
            self.add(line, cells, read())
        except CellError as error:
            self.refuse(line, cells, str(error), error.key)

    def _append(self, item: _Item) -> None:
        if len(self.items) >= MOST_ROWS:
            raise ListError(f"has more than {MOST_ROWS} rows; a list of registers has fewer")
        self.items.append(item)

    def listing(self, lines: int) -> tuple[Sheet, Listing]:
        """The list of all objects, whose rows are numbered by their lines where no line has two. Raises ListError."""
        if not self.items:
            raise ListError("has no object that can be a row of a list")
        heads = tuple(dict.fromkeys(key for item in self.items for key in item.cells))
        if len(heads) > MOST_COLUMNS:
            raise ListError(f"has more than {MOST_COLUMNS} columns")
        is_by_line = len({item.line for item in self.items}) == len(self.items)
        rows: list[SheetRow] = []
        read: list[ListRow] = []
        places: list[tuple[SheetRow, Place]] = []
        refused: list[Refusal] = []
        for number, item in enumerate(self.items, 1):
            row_number = item.line if is_by_line else number
            sheet_row = SheetRow(row_number, tuple(clean(item.cells.get(head, "")) for head in heads))
            rows.append(sheet_row)
            for key, reason in item.refusals:
                refused.append(Refusal(row_number, key, clean(item.cells.get(key, "")), reason))
            if item.row is not None:
                read.append(replace(item.row, row=row_number, doubts=(*item.row.doubts, *self._notes(item))))
                places.append((sheet_row, Place(AddressText(str(item.row.address)))))
        if not read:
            raise ListError(f"has no object that can be taken: {refused[0].text()}")
        roles = {role: heads.index(key) for key, role in self.roles.items() if key in heads}
        noted = tuple(heads.index(key) for key in self.notes if key in heads)
        columns = Columns({"address": 0, **roles}, heads, tuple(rows), {NOTE: noted})
        last = max(lines, rows[-1].number)
        return Sheet(tuple(rows), last, format=self.format), Listing(
            columns,
            Placed(tuple(places), (), ()),
            tuple(read),
            (),
            tuple(refused),
            (DECIMAL,),
            tuple(self.assumptions),
            (),
            False,
        )

    def _notes(self, item: _Item) -> list[str]:
        noted = ((key, clean(item.cells.get(key, ""))) for key in self.notes)
        return [f"{key} in the list: {text[:_LONGEST_NOTE].rstrip('.')}." for key, text in noted if text]


def decimal(text: str) -> Decimal | None:
    """A number as programs write it, a whole number in any base; None if a text is not a number."""
    bare = text.strip().replace("_", "")
    if len(bare) > _LONGEST_NUMBER:
        return None
    try:
        return Decimal(int(bare, 0))
    except ValueError:
        pass
    try:
        number = Decimal(bare)
    except ArithmeticError:
        return None
    return number if number.is_finite() and abs(number.adjusted()) < 40 else None
