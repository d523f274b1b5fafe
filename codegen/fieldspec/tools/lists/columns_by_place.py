"""Reads tables whose columns are parted by blanks, as texts copied from documents have them: by where cells begin."""

from __future__ import annotations

import re

from fieldspec.tools.lists.cells import space
from fieldspec.tools.lists.sheet import MOST_COLUMNS, MOST_ROWS, Sheet, SheetRow
from fieldspec.tools.lists.words import folded, whole_words

_NUMBERED = re.compile(
    r"\s*(?:[-*\u2022]\s+)?`?((?:0x|x)?[0-9a-f]{1,6}h?(?:\s?(?:-|\u2013|\.\.|~)\s?(?:0x)?[0-9a-f]{1,6}h?)?)`?"
    r"(?:\s*[:=]\s*|\s+[-\u2013\u2014]\s+|\s+\((?:0x)?[0-9a-f]{1,6}h?\)\s+)(\S[^\t;|]*?)(?:\s*\((R/?W?|W|[RW]O)\))?",
    re.IGNORECASE,
)
_SPACED = re.compile(
    r"\s*(0x[0-9a-f]{1,4}|[0-9]{1,6}(?:-[0-9]{1,6})?) (?!.*  )([^\W\d_][^\t;|,]*?)(?: \((R/?W?|W|[RW]O)\))?",
    re.IGNORECASE,
)
"""A line with only a blank between the address and the name."""

_CELL = re.compile(r"\S+(?: \S+)*")
_VALUE = re.compile(r"(?:bits?|b)?\s*\.?[0-9]", re.IGNORECASE)
"""The beginning of a line that may be a value or a bit of the row above."""

_FEWEST, _HEADED_BY = 3, 40
_QUOTED = re.compile(r'(?:^|[,;\t|])"[^"]*$')
"""The beginning of a cell in quotes that the line does not end."""


def numbered_sheet(text: str) -> Sheet | None:
    """The sheet of lines such as `30001 - Frequency (Hz x 100)` or `300 Power`; None for others, and a longer text."""
    lines = text.splitlines()[: MOST_ROWS + 1]
    if _has_cells_of_lines(lines) or any(map(_is_heading, lines[:_HEADED_BY])):
        return None
    filled = sum(bool(line.strip()) for line in lines)
    for pattern in (_NUMBERED, _SPACED):
        matches = [pattern.fullmatch(line.rstrip()) for line in lines]
        numbered = [match for match in matches if match and any(map(str.isdecimal, match[1]))]
        if len(numbered) * 2 > filled:
            break
    if len(lines) > MOST_ROWS or len(numbered) < _FEWEST or len(numbered) * 2 <= filled:
        return None
    rows = [SheetRow(0, ("Address", "", "Name", "Access"))]
    indent = min(len(line) - len(line.lstrip()) for line, match in zip(lines, matches, strict=True) if match)
    for number, (line, match) in enumerate(zip(lines, matches, strict=True), 1):
        if line.strip():
            is_beneath = len(line) - len(line.lstrip()) > indent + 1
            texts = ((match[1], "") if not is_beneath else ("", match[1])) if match else ()
            rows.append(SheetRow(number, (*texts, match[2].strip(), match[3] or "") if match else (line.strip(),)))
    return Sheet(tuple(rows), len(lines))


def _has_cells_of_lines(lines: list[str]) -> bool:
    """Whether cells in quotes go over several lines, as `"1=off` and `2=on"` of a column of values do."""
    return any('"' in line and line.count('"') % 2 and _QUOTED.search(line) is not None for line in lines)


def _is_heading(line: str) -> bool:
    """Whether a line has the headings of several columns, one of them of addresses."""
    roles = [whole_words().get(folded(word)) for word in re.split(r"[\s,;|]+", line.strip())]
    return "address" in roles and len({*roles} - {None}) >= _FEWEST


def placed_sheet(text: str) -> Sheet | None:
    """The sheet of a text in which columns are parted by two blanks or more; None if the text differs.

    The heading is the first line with most cells. `refused` has the lines with a cell that stands under no heading, or
    under two, or with another one under its heading.
    """
    lines = [list(_CELL.finditer(line.expandtabs())) for line in text.splitlines()[: MOST_ROWS + 1]]
    width = max(map(len, lines), default=0)
    if not 1 < width <= MOST_COLUMNS or len(lines) > MOST_ROWS or sum(len(cells) > 1 for cells in lines) < _FEWEST:
        return None
    heading = next(number for number, cells in enumerate(lines) if len(cells) == width)
    spans = [cell.span() for cell in lines[heading]]
    starts = {first for first, _ in spans}
    rows, refused = [], dict[int, str]()
    for number, cells in enumerate(lines, 1):
        texts = [""] * width
        for cell in cells:
            under = [n for n, (first, last) in enumerate(spans) if cell.start() < last and first < cell.end()]
            nearest = max((n for n, (first, _) in enumerate(spans) if first <= cell.start()), default=0)
            if len(under) != 1 or texts[under[0]]:
                refused[number] = "has cells that do not stand under the headings"
            column = under[0] if len(under) == 1 else nearest
            texts[column] = f"{texts[column]} {cell[0]}".strip()
        if cells:
            rows.append(SheetRow(number, tuple(texts)))
    places = [n for n, cell in enumerate(lines[heading]) if whole_words().get(folded(cell[0])) == "address"]
    below = [row for row in rows if row.number > heading + 1]
    aligned = {number for number, cells in enumerate(lines, 1) if starts.issuperset(cell.start() for cell in cells)}
    whole, wrapped = _unwrapped(below, places[0], aligned - {*refused}) if places else (below, [])
    above = rows[: len(rows) - len(below)]
    return Sheet((*above, *whole), max(len(lines), 1), refused=refused, wrapped=tuple(wrapped))


def _unwrapped(rows: list[SheetRow], column: int, aligned: set[int]) -> tuple[list[SheetRow], list[tuple[int, int]]]:
    """The rows, each with the lines next to it that have no address, as long cells go on; and the numbers of these
    lines, each with that of its row.

    A line belongs to the row above, but to the one below if only that one has none of its cells. A line that may be
    a value, a bit or a title stays apart, and one that is not `aligned` with the headings, as the number of a page is.
    """
    result: list[SheetRow] = []
    wrapped: list[tuple[int, int]] = []
    last = 0
    for n, row in enumerate(rows):
        filled = [place for place, text in enumerate(row.cells) if text]
        text = row.cells[filled[0]]
        is_part = not row.cell(column) and row.number in aligned and not _VALUE.match(text) and not space(text)
        above = result[-1] if result and last == row.number - 1 and result[-1].cell(column) else None
        below = next((other for other in rows[n + 1 : n + 2] if other.number == row.number + 1), None)
        lacks_above, lacks_below = (
            other is not None and bool(other.cell(column)) and not any(map(other.cell, filled))
            for other in (above, below)
        )
        last = row.number
        if is_part and below is not None and lacks_below and not lacks_above:
            rows[n + 1] = _joined(row, below, below.number)
            wrapped.append((row.number, below.number))
        elif is_part and above is not None and not lacks_below:
            result[-1] = _joined(above, row, above.number)
            wrapped.append((row.number, above.number))
        else:
            result.append(row)
    return result, wrapped


def _joined(first: SheetRow, second: SheetRow, number: int) -> SheetRow:
    pairs = zip(first.cells, second.cells, strict=True)
    return SheetRow(number, tuple(" ".join(filter(None, pair)) for pair in pairs))
