"""Reads a dump of a device's memory from a file: the words at each address."""

from __future__ import annotations

import json
import re
import unicodedata
from collections.abc import Mapping, Sequence

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.spreadsheet import clean
from fieldspec.tools.lists.cells import HEXADECIMAL, address_text, base_of_heading
from fieldspec.tools.lists.column_roles import headings_text
from fieldspec.tools.lists.json_text import json_data
from fieldspec.tools.lists.listing import Listing, listing
from fieldspec.tools.lists.sheet import MOST_ROWS, ListError, Sheet, SheetRow
from fieldspec.tools.lists.text_sheet import decoded

_GROUPED = re.compile(r"[-+]?(?:[0-9]{1,3}(?:[,'][0-9]{3})+|[1-9][0-9]{0,2}(?:\.[0-9]{3})+)")
_BETWEEN = re.compile(r"[\s,;]+")
_NUMBER = re.compile(r"([-+]?)(?:(?:0x|&h|\$)([0-9a-f]{1,16})|([0-9a-f]{1,16})h|([0-9a-f]{1,20}))", re.IGNORECASE)
_POINTLESS = re.compile(r"([-+]?[0-9]+)\.0+")
_WORDS = {"true": "1", "on": "1", "false": "0", "off": "0"}
_NOT_READ = ("", "-", "--", "n/a", "none", "null", "timeout", "error")
_LIMIT = 1 << 64


@dataclass(frozen=True, slots=True)
class Entry:
    """What was read at an address: one number, or several words from there on. `row` is its number in the file.

    `words` is the size of the number in words, None if the file does not say it. `space` is the name of the address
    space in the file, empty if it has none.
    """

    row: int
    address: int
    values: tuple[int, ...]
    words: int | None
    space: str


@dataclass(frozen=True, slots=True)
class Dump:
    """A dump. `skipped` are the rows without a value or an address."""

    listing: Listing
    values: Mapping[int, tuple[int, ...]]
    skipped: tuple[int, ...]

    @property
    def bases(self) -> tuple[str, ...]:
        """The ways in which the addresses can be read, the likeliest first."""
        return self.listing.bases

    def entries(self, base: str) -> list[Entry]:
        """What was read, with the addresses read in one of the ways of `bases`."""
        return [
            Entry(row.row, row.address, self.values[row.row], row.words, row.texts.get("space", ""))
            for row in self.listing.rows(base)
            if row.row in self.values
        ]


def object_sheet(content: bytes, encoding: str = "") -> Sheet | None:
    """The sheet in a JSON object of addresses and values; None if the file is no object. Raises ListError."""
    if not content.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"{"):
        return None
    pairs = json_data(decoded(content, encoding), list)
    if len(pairs) > MOST_ROWS:
        raise ListError(f"has more than {MOST_ROWS} addresses; a dump has fewer")
    rows = [SheetRow(1, ("address", "value"))]
    rows += [SheetRow(number, (clean(key), _cell(value))) for number, (key, value) in enumerate(pairs, 2)]
    return Sheet(tuple(rows), len(pairs) + 1)


def _cell(value: object) -> str:
    text = value if isinstance(value, str) else "" if value is None else json.dumps(value, ensure_ascii=False)
    return clean(text)


def dump(sheet: Sheet, names: Mapping[str, str], base: str = "") -> Dump:
    """The dump in a sheet. `names` has the columns of some roles, `base` says how addresses are written. Raises
    ListError.

    A sheet of two columns without headings has the addresses in the first one.
    """
    if not {"address", "value"} & names.keys() and _bare(sheet):
        names = {**names, "address": "1", "value": "2"}
    register_list = listing(sheet, names, base)
    if "value" not in register_list.columns.places:
        headings = headings_text(register_list.columns.headings)
        raise ListError(
            f"has no column that looks like values ({headings}); name it with --value, by heading or number"
        )
    texts = {row.number: register_list.columns.cell(row, "value") for row, _ in register_list.addresses}
    lettered = any(_lettered(piece) for text in texts.values() for piece in _pieces(text))
    hexadecimal = lettered or base_of_heading(register_list.columns.heading("value")) == HEXADECIMAL
    values = {row: _values(text, row, hexadecimal) for row, text in texts.items() if text.lower() not in _NOT_READ}
    if not values:
        raise ListError(f"has no value under {register_list.columns.heading('value')}")
    skipped = (*register_list.skipped, *(row for row in texts if row not in values))
    return Dump(register_list, values, tuple(sorted(skipped)))


def _bare(sheet: Sheet) -> bool:
    """Whether all rows are two cells, the first of which is an address."""
    first = sheet.rows[0].cells[0] if sheet.rows else ""
    return first[:1].isdigit() and all(
        len(row.cells) == 2 and address_text(row.cells[0]) is not None for row in sheet.rows
    )


def _pieces(text: str) -> Sequence[str]:
    """The numbers in a cell."""
    normalized = unicodedata.normalize("NFKC", text).replace("\u2212", "-").strip().strip("[]()").strip()
    return [piece for piece in _BETWEEN.split(normalized) if piece]


def _lettered(piece: str) -> bool:
    """Whether there are letters among digits without a mark, so that they are hexadecimal."""
    match = _NUMBER.fullmatch(piece)
    return match is not None and bool(match[4]) and not match[4].isdecimal()


def _values(text: str, row: int, hexadecimal: bool) -> tuple[int, ...]:
    if _GROUPED.fullmatch(unicodedata.normalize("NFKC", text).strip()):
        raise ListError(f"has the value `{text}` in row {row}, with thousands separators; remove them")
    return tuple(_cell_number(_WORDS.get(piece.lower(), piece), text, row, hexadecimal) for piece in _pieces(text))


def _cell_number(piece: str, text: str, row: int, hexadecimal: bool) -> int:
    pointless = _POINTLESS.fullmatch(piece)
    match = _NUMBER.fullmatch(pointless[1] if pointless else piece)
    if match is None:
        raise ListError(f"has the value `{text[:40]}` in row {row}, which is not a whole number of counts")
    sign, marked, ended, decimal = match.groups()
    number = int(marked or ended, 16) if marked or ended else int(decimal, 16 if hexadecimal else 10)
    if number >= _LIMIT:
        raise ListError(f"has the value `{text[:40]}` in row {row}, which is too great")
    return -number if sign == "-" else number
