"""A register list, row by row."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal

from fieldspec.foundation.classes import dataclass, replace
from fieldspec.tools.lists import cells
from fieldspec.tools.lists.cells import (
    DECIMAL,
    HEXADECIMAL,
    HIGHEST,
    REFERENCE,
    AddressRange,
    AddressText,
    address_range,
    base_of_heading,
)
from fieldspec.tools.lists.column_roles import Columns, columns
from fieldspec.tools.lists.sheet import ListError, Sheet, SheetRow

_MOST_WORDS = 5


@dataclass(frozen=True, slots=True)
class ListRow:
    """A row of a list. `address` is that of the list, `row` is its number in the file.

    Cells that are empty, or cannot be understood, are None or empty. `texts` are the cells by role.
    """

    row: int
    address: int
    words: int | None
    names: tuple[str, ...]
    type: cells.Typed | None
    access: str
    low: Decimal | None
    high: Decimal | None
    default: Decimal | None
    const: Decimal | None
    count: int
    stride: int
    texts: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class Listing:
    """A list. `skipped` are the numbers of rows without an address.

    `bases` are the ways in which the addresses can be read, the likeliest first.
    """

    columns: Columns
    addresses: tuple[tuple[SheetRow, AddressRange], ...]
    skipped: tuple[int, ...]
    bases: tuple[str, ...]

    def rows(self, base: str) -> list[ListRow]:
        """The rows, with the addresses read in one of the ways of `bases`."""
        return [_list_row(self.columns, row, addresses, base) for row, addresses in self.addresses]

    def heading(self, role: str) -> str:
        """The heading of a role's column."""
        return self.columns.heading(role)


def listing(sheet: Sheet, names: Mapping[str, str], base: str = "") -> Listing:
    """The list in a sheet. `names` has the columns of some roles, `base` says how addresses are written.

    Raises ListError if the sheet is no list.
    """
    columns_of_sheet = columns(sheet, names)
    rows: list[tuple[SheetRow, AddressRange]] = []
    skipped: list[int] = []
    wrong: list[SheetRow] = []
    for row in columns_of_sheet.rows:
        text = columns_of_sheet.cell(row, "address")
        addresses = address_range(text, row.number) if text else None
        if addresses is not None:
            rows.append((row, addresses))
        elif text and sum(map(bool, row.cells)) > 1 and row.cells != columns_of_sheet.headings:
            wrong.append(row)
        else:
            skipped.append(row.number)
    heading = columns_of_sheet.heading("address")
    if wrong:
        places = "; ".join(
            f"`{columns_of_sheet.cell(row, 'address')[:40]}` in row {row.number}" for row in wrong[:_MOST_WORDS]
        )
        rest_text = f"; and {len(wrong) - _MOST_WORDS} more" if len(wrong) > _MOST_WORDS else ""
        raise ListError(f"has no address under {heading}: {places}{rest_text}; name the column with --address")
    if not rows:
        alone = len(columns_of_sheet.headings) == 1 and len(heading.split()) > 1
        parted = "; if spaces separate its columns, use tabs, commas or bars instead" if alone else ""
        raise ListError(f"has no address under {heading}{parted}")
    result = Listing(
        columns_of_sheet, tuple(rows), tuple(skipped), _bases([addresses for _, addresses in rows], base, heading)
    )
    for base_name in result.bases:
        _within(result.rows(base_name), heading)
    return result


def _bases(ranges: Sequence[AddressRange], base: str, heading: str) -> tuple[str, ...]:
    """The ways to read digits without a mark: only one if the user or the heading says it."""
    ends = [end for address_range in ranges for end in (address_range.first, address_range.last) if end is not None]
    stated = base or base_of_heading(heading)
    if not stated and any(end.lettered for end in ends):
        stated = HEXADECIMAL
    if stated:
        wrong = [end.digits for end in ends if end.number(stated) is None]
        if wrong:
            raise ListError(f"has the address `{wrong[0]}` under {heading}, which cannot be read as {stated}")
        return (stated,)
    bare = [end for end in ends if not end.mark]
    if not bare:
        return (HEXADECIMAL,)
    ways = [DECIMAL, HEXADECIMAL]
    if all(_is_reference(end) for end in bare):
        ways.append(REFERENCE)
    return tuple(ways)


def _is_reference(end: AddressText) -> bool:
    return end.reference() is not None


def _within(rows: Sequence[ListRow], heading: str) -> None:
    for row in rows:
        if row.address > HIGHEST:
            raise ListError(f"has the address {row.address} under {heading} in row {row.row}, which is too great")


def _list_row(columns: Columns, row: SheetRow, address: AddressRange, base: str) -> ListRow:
    texts = {role: text for role in columns.places if (text := columns.cell(row, role))}
    first = address.first.number(base) or 0
    last = address.last.number(base) if address.last is not None else None
    words = cells.whole(texts.get("words", ""))
    if words is None and last is not None and last >= first:
        words = last - first + 1
    low, high = cells.number(texts.get("min", "")), cells.number(texts.get("max", ""))
    bounds = cells.bounds(texts.get("range", ""))
    if low is None and high is None and bounds is not None:
        low, high = bounds
    count = cells.whole(texts.get("count", "")) or 1
    return ListRow(
        row=row.number,
        address=first,
        words=words if words is not None and words > 0 else None,
        names=tuple(texts[role] for role in ("name", "printed_name", "label") if role in texts),
        type=cells.typed(texts.get("type", "")),
        access=cells.access(texts.get("access", "")),
        low=low,
        high=high,
        default=cells.number(texts.get("default", "")),
        const=cells.number(texts.get("const", "")),
        count=count if 1 <= count <= HIGHEST else 1,
        stride=max(cells.whole(texts.get("stride", "")) or 0, 0),
        texts=texts,
    )


def moved(rows: Sequence[ListRow], offset: int) -> Iterator[ListRow]:
    """The rows with the addresses on the wire, which are lower than those of the list by an offset."""
    for row in rows:
        yield replace(row, address=row.address - offset)
