"""A device compared with somebody's list, as text, as data for JSON, and as CSV."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.command.rendering.blocks import Block, Line, Table
from fieldspec.foundation.spreadsheet import Cell, csv_text
from fieldspec.tools.lists.addresses import DECIMAL, HEXADECIMAL
from fieldspec.tools.lists.comparison import Compared, Missing
from fieldspec.tools.lists.listing import Listing
from fieldspec.tools.lists.row_reading import ListRow
from fieldspec.tools.lists.words import folded

COLUMNS = ("result", "address", "row", "name", "what", "ours", "theirs")
_ADDRESSES = {HEXADECIMAL: "hexadecimal", DECIMAL: "decimal"}
_MOST_SKIPPED = 10
"""The most numbers of rows without an address that are printed."""

_MOST_ROWS = 200
"""The most rows of a table for people."""


def blocks(result: Compared, listing: Listing) -> Iterator[Block]:
    """The comparison as lines and tables, with its base and columns first."""
    yield Line(f"addresses: {listing.heading('address')}, {_ADDRESSES.get(result.base, result.base)}")
    roles = [role for role in listing.columns.places if role != "address"]
    if roles:
        yield Line("columns: " + ", ".join(_column(role, listing.heading(role)) for role in roles))
    if left := [listing.columns.heading_at(place) for place in listing.columns.unused()]:
        yield Line("columns not compared: " + ", ".join(left))
    if listing.assumptions:
        yield Line("assumed: " + "; ".join(entry.text() for entry in listing.assumptions))
    if listing.skipped:
        rows = ", ".join(map(str, listing.skipped[:_MOST_SKIPPED]))
        rest_text = f" and {len(listing.skipped) - _MOST_SKIPPED} more" if len(listing.skipped) > _MOST_SKIPPED else ""
        yield Line(f"rows without an address: {rows}{rest_text}")
    if result.shifted:
        yield Line("")
        yield Line(_shift(result), "bold")
    yield from _section("differs", ("address", "row", "name", "what", "ours", "theirs"), _differing(result))
    yield from _section("only in the list", ("address", "row", "name", "remark"), _extras(result))
    yield from _section("only in the device", ("address", "name"), _missing_rows(result))
    yield from _section("not compared", ("row", "cell", "reason"), _unreadable(result))
    yield Line("")
    yield Line(
        f"{len(result.agreeing)} agree, {len(result.differing)} differ, {len(result.extras)} only in the list, "
        f"{len(result.missing)} only in the device"
        + (f", {len(result.unreadable)} not compared" if result.unreadable else "")
    )


def as_data(result: Compared, listing: Listing) -> dict[str, object]:
    """The comparison as data for JSON."""
    return {
        "same": result.same,
        "base": result.base,
        "offset": result.offset,
        "offset_is_a_difference": result.shifted,
        "columns": {role: listing.heading(role) for role in listing.columns.places},
        "rows_without_an_address": list(listing.skipped),
        "columns_not_compared": [listing.columns.heading_at(place) for place in listing.columns.unused()],
        "not_compared": [{"row": entry.row, "cell": entry.cell, "reason": entry.reason} for entry in result.unreadable],
        "agree": [
            {"address": pair.row.address, "row": pair.row.row, "name": pair.item.name} for pair in result.agreeing
        ],
        "differ": [
            {
                "address": pair.row.address,
                "row": pair.row.row,
                "name": pair.item.name,
                "differences": [
                    {"what": difference.aspect, "ours": difference.ours, "theirs": difference.theirs}
                    for difference in pair.differences
                ],
            }
            for pair in result.differing
        ],
        "only_in_list": [
            {"address": extra.row.address, "row": extra.row.row, "name": _name(extra.row), "remark": extra.remark}
            for extra in result.extras
        ],
        "only_in_device": [
            {"address": gap.address, "name": gap.item.name, "elements": _elements(gap)} for gap in result.missing
        ],
    }


def as_csv(result: Compared) -> str:
    """The comparison as CSV: a row for each agreement, each difference, and each address that only one has."""
    rows: list[Sequence[Cell]] = [COLUMNS]
    if result.shifted:
        rows.append(("differs", "", "", "", "offset", 0, result.offset))
    rows += [
        ("agrees", _address(pair.row.address), str(pair.row.row), pair.item.name, "", "", "")
        for pair in result.agreeing
    ]
    rows += [("differs", *cells) for cells in _differing(result)]
    rows += [("only in the list", *cells[:3], "", "", cells[3]) for cells in _extras(result)]
    rows += [("not compared", "", row, cell, reason, "", "") for row, cell, reason in _unreadable(result)]
    rows += [("only in the device", address, "", name, "", "", "") for address, name in _missing_rows(result)]
    return csv_text(rows, "\n")


def _column(role: str, heading: str) -> str:
    """A role, with the heading of its column where that is another word."""
    return role if folded(heading) == folded(role) else f"{role} from {heading}"


def _shift(result: Compared) -> str:
    if result.offset == 1:
        return "The whole list counts from 1: each address is one higher than on the wire. --offset 1 accepts that."
    return "Each address of the whole list is one lower than on the wire. --offset -1 accepts that."


def _section(title: str, headings: tuple[str, ...], rows: list[tuple[str, ...]]) -> Iterator[Block]:
    if rows:
        yield Line("")
        yield Line(f"{title}:", "bold")
        yield Table(headings, tuple(rows[:_MOST_ROWS]))
        if len(rows) > _MOST_ROWS:
            yield Line(f"and {len(rows) - _MOST_ROWS} more; --format csv or json has all of them")


def _differing(result: Compared) -> list[tuple[str, ...]]:
    return [
        (
            _address(pair.row.address),
            str(pair.row.row),
            pair.item.name,
            difference.aspect,
            difference.ours,
            difference.theirs,
        )
        for pair in result.differing
        for difference in pair.differences
    ]


def _extras(result: Compared) -> list[tuple[str, ...]]:
    return [
        (_address(extra.row.address), str(extra.row.row), _name(extra.row), extra.remark) for extra in result.extras
    ]


def _unreadable(result: Compared) -> list[tuple[str, ...]]:
    return [(str(refusal.row), refusal.cell, refusal.reason) for refusal in result.unreadable]


def _missing_rows(result: Compared) -> list[tuple[str, ...]]:
    return [(_address(gap.address), f"{gap.item.name}{_of(gap)}") for gap in result.missing]


def _of(gap: Missing) -> str:
    return f" of {_elements(gap)}" if _elements(gap) else ""


def _elements(gap: Missing) -> str:
    """`3..126`, or empty for a single item."""
    if gap.item.count == 1 or not gap.item.stride:
        return ""
    return str(gap.first) if gap.first == gap.last else f"{gap.first}..{gap.last}"


def _name(row: ListRow) -> str:
    return row.names[0] if row.names else ""


def _address(number: int) -> str:
    return f"0x{number:04X}" if number >= 0 else str(number)
