"""Reads a dump of a device's memory from a file: the words at each address."""

from __future__ import annotations

import json
import re
import unicodedata
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.spreadsheet import clean
from fieldspec.tools.lists.addresses import DECIMAL, HEXADECIMAL, address_text, base_of_heading
from fieldspec.tools.lists.assumption import Options
from fieldspec.tools.lists.column_roles import headings_text
from fieldspec.tools.lists.json_text import json_data
from fieldspec.tools.lists.listing import Listing, listing
from fieldspec.tools.lists.sheet import MOST_ROWS, ListError, Sheet, SheetRow
from fieldspec.tools.lists.text_sheet import decoded
from fieldspec.tools.lists.workbook_reader import MAGIC

_GROUPED = re.compile(r"[-+]?(?:[0-9]{1,3}(?:[,'][0-9]{3})+|[1-9][0-9]{0,2}(?:\.[0-9]{3})+)")
_BETWEEN = re.compile(r"[\s,;]+")
_NUMBER = re.compile(r"([-+]?)(?:(?:0x|&h|\$)([0-9a-f]{1,16})|([0-9a-f]{1,16})h|([0-9a-f]{1,20}))", re.IGNORECASE)
_POINTLESS = re.compile(r"([-+]?[0-9]+)\.0+")
_WORDS = {"true": "1", "on": "1", "false": "0", "off": "0"}
_NOT_READ = ("", "-", "--", "n/a", "none", "null", "timeout", "error")
_LIMIT = 1 << 64
_HEADING = SheetRow(1, ("space", "address", "value"))
_VALUE = r"[-+0-9a-fA-Fx.]+"
_LINE = re.compile(
    r"\s*(?:\[\s*(?P<marked>[0-9a-fA-Fx]{1,10})\s*\]\s*[:=]?|(?:[Rr]eg(?:ister)?s?\s*)?(?P<bare>(?:0x)?[0-9a-fA-F]{1,6})\s*[:=])"
    rf"\s*(?P<values>{_VALUE}(?:[ ,]+{_VALUE})*)(?:\s*\([^()]*\))?\s*"
)
_STEP = re.compile(r"\+?(?:[0-9]{1,2}|[a-fA-F])")
_STARTS = ("start", "address", "first", "base", "start_address", "startaddress", "offset")
_VALUES = ("values", "value", "registers", "words", "data")
_LOOKED_AT = 10


@dataclass(frozen=True, slots=True)
class Entry:
    """The result of reading an address: one number, or several words from there on. `row` is its number in the file.

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
        """The rows, with the addresses interpreted in one of the ways of `bases`."""
        return [
            Entry(row.row, row.address, self.values[row.row], row.words, row.texts.get("space", ""))
            for row in self.listing.rows(base)
            if row.row in self.values
        ]


def dump_sheet(content: bytes, encoding: str = "") -> Sheet | None:
    """The sheet in JSON with addresses and values in any form, or in lines such as `[264]: 0`; None for other files.

    Raises ListError.
    """
    start = content.lstrip(b"\xef\xbb\xbf \t\r\n")[:1]
    if start in (b"{", b"["):
        text = decoded(content, encoding)
        lines = _lines(text)
        if lines:
            return Sheet((_HEADING, *lines), len(text.splitlines()))
        data = json_data(text, _Pairs)
        rows = list(_rows(data, ""))
        are_lists = all(isinstance(item, list) and not isinstance(item, _Pairs) for item in data)
        has_lists = (data and are_lists) or any(isinstance(value, list) for item in data for _, value in _pairs(item))
        if start == b"[" and not has_lists:
            return None
        if len(rows) > MOST_ROWS:
            raise ListError(f"has more than {MOST_ROWS} addresses; a dump has fewer")
        return Sheet((_HEADING, *(SheetRow(number, cells) for number, cells in enumerate(rows, 2))), len(rows) + 1)
    if content.startswith(MAGIC):
        return None
    text = decoded(content, encoding)
    lines = _lines(text)
    return Sheet((_HEADING, *lines), len(text.splitlines())) if lines else None


class _Pairs(list[tuple[str, Any]]):
    """The pairs of an object of JSON, in which a key may occur twice."""


def _pairs(item: object) -> _Pairs:
    return item if isinstance(item, _Pairs) else _Pairs()


def _lines(text: str) -> list[SheetRow]:
    """The rows of lines with an address and what was read there: `[100]: 7`. The others say how it was read.

    Where no brackets are around the addresses, half of the lines have one.
    """
    lines = [(number, line) for number, line in enumerate(text.splitlines(), 1) if line.strip()]
    matches = [(number, match) for number, line in lines if (match := _LINE.fullmatch(line))]
    if not any(match["marked"] for _, match in matches) and len(matches) * 2 < len(lines):
        return []
    return [SheetRow(number, ("", match["marked"] or match["bare"], match["values"])) for number, match in matches]


def _rows(data: object, space: str) -> Iterator[tuple[str, str, str]]:
    """The space, the address and the value of all in JSON: pairs of both, and lists of values with their start."""
    if not isinstance(data, _Pairs):
        for item in data if isinstance(data, list) else ():
            is_pair = isinstance(item, list) and len(item) == 2 and all(isinstance(part, int | str) for part in item)
            if is_pair and not isinstance(item, _Pairs):
                yield space, clean(str(item[0])), _cell(item[1])
            else:
                yield from _rows(item, space)
        return
    by_key = {key.casefold(): value for key, value in data}
    own_space = by_key.get("space") or by_key.get("type") or space
    start = next((by_key[key] for key in _STARTS if key in by_key), None)
    values = next((by_key[key] for key in _VALUES if key in by_key), None)
    if start is not None and values is not None:
        first = address_text(str(start))
        number = first.number(DECIMAL) if first is not None else None
        for offset, value in enumerate(
            values if isinstance(values, list) and not isinstance(values, _Pairs) else [values]
        ):
            yield str(own_space), str(start) if number is None else str(number + offset), _cell(value)
        return
    for key, value in data:
        if isinstance(value, list) and address_text(key) is None:
            yield from _rows(value, key)
        else:
            yield str(space), clean(key), _cell(value)


def _cell(value: object) -> str:
    text = value if isinstance(value, str) else "" if value is None else json.dumps(value, ensure_ascii=False)
    return clean(text)


def _unfolded(sheet: Sheet) -> Sheet:
    """A sheet with one cell for the values of rows that have several, under headings such as `+0`, `+1`.

    Raises ListError.
    """
    heading = next((row for row in sheet.rows[:_LOOKED_AT] if _has_steps(row)), None)
    if heading is None:
        return sheet
    steps = {column: _step(text) for column, text in enumerate(heading.cells) if _STEP.fullmatch(text)}
    place = next((column for column, text in enumerate(heading.cells) if column not in steps), 0)
    rows = [SheetRow(heading.number, ("", "address", "value"))]
    for row in sheet.rows:
        first = address_text(row.cell(place)) if row.number > heading.number else None
        base = HEXADECIMAL if first is not None and first.lettered else DECIMAL
        number = first.number(base) if first is not None else None
        if number is not None:
            texts = [row.cell(column) for column in steps]
            filled = [text for text in texts if text]
            if texts[: len(filled)] != filled:
                raise ListError(f"has an empty cell among the values of row {row.number}; give each address a row")
            rows.append(SheetRow(row.number, ("", f"0x{number:X}", " ".join(filled))))
    return Sheet(tuple(rows), sheet.lines, sheet.name)


def _has_steps(row: SheetRow) -> bool:
    """Whether a row is a heading over values at neighbouring addresses."""
    steps = [_step(text) for text in row.cells if _STEP.fullmatch(text)]
    return len(steps) > 1 and steps == list(range(len(steps))) and any(map(str.isalpha, row.cells))


def _step(text: str) -> int:
    digits = text.lstrip("+")
    return int(digits, 16) if digits.isalpha() else int(digits)


def dump(sheet: Sheet, names: Mapping[str, str], base: str = "") -> Dump:
    """The dump in a sheet. `names` has the columns of some roles, `base` says how addresses are written. Raises
    ListError.

    A sheet of two columns without headings has the addresses in the first one.
    """
    sheet = _unfolded(sheet)
    if not {"address", "value"} & names.keys() and _bare(sheet):
        names = {**names, "address": "1", "value": "2"}
    register_list = listing(sheet, names, Options(base=base))
    if "value" not in register_list.columns.places:
        headings = headings_text(register_list.columns.headings)
        raise ListError(
            f"has no column that looks like values ({headings}); name it with --value, by heading or number"
        )
    texts = {row.number: register_list.columns.cell(row, "value") for row, _ in register_list.places.rows}
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
