"""Workbooks as bytes, for programs that import them: every cell is there, and texts are in a table of their own.

openpyxl is not used here: its import alone takes longer than a build has for all workbooks of a device.
"""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Iterable, Iterator
from html import escape

from fieldspec.lists import parts
from fieldspec.lists.sheet import letters
from fieldspec.spreadsheet import Cell, Workbook, Worksheet, clean

LONGEST = 32_767
"""The most characters of a cell."""

_HEAD = '<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\n'
_FORMULAS = ("=", "+", "-", "@")
_NOT_XML = re.compile("[\ufffe\uffff]")


def packed(held: Workbook) -> bytes:
    """The bytes of a workbook. The same cells give the same bytes: no times, and no compression.

    An empty cell is an empty text. A text that begins like a formula is marked as a text.
    """
    return zipped(_parts(held))


def zipped(parts_of: Iterable[tuple[str, str]]) -> bytes:
    """The parts of a workbook by name, XML each without its first line, in one file."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_STORED) as package:
        for name, text in parts_of:
            part = zipfile.ZipInfo(name)
            part.create_system = 3
            part.external_attr = 0o644 << 16
            package.writestr(part, _HEAD + text)
    return made.getvalue()


def _parts(held: Workbook) -> Iterator[tuple[str, str]]:
    texts = _Texts()
    sheets = [_sheet(sheet, texts) for sheet in held.sheets]
    described = bool(held.properties)
    yield "docProps/app.xml", parts.APP
    yield "docProps/core.xml", parts.CORE
    yield "xl/theme/theme1.xml", parts.theme()
    if described:
        yield "docProps/custom.xml", parts.properties(held.properties)
    for number, sheet in enumerate(sheets, 1):
        yield f"xl/worksheets/sheet{number}.xml", sheet
    yield "xl/styles.xml", parts.styles(texts.quoted)
    yield "_rels/.rels", parts.relations(described)
    yield "xl/workbook.xml", parts.workbook([sheet.title for sheet in held.sheets])
    yield "xl/_rels/workbook.xml.rels", parts.workbook_relations(len(sheets))
    yield "[Content_Types].xml", parts.contents(len(sheets), described)
    uses = sum(not isinstance(cell, int) for sheet in held.sheets for row in sheet.rows for cell in row)
    items = "".join(f'<si><t xml:space="preserve">{text}</t></si>' for text in texts.numbers)
    yield (
        "xl/sharedStrings.xml",
        f'<sst xmlns="{parts.MAIN}" count="{uses}" uniqueCount="{len(texts.numbers)}">{items}</sst>',
    )


class _Texts(dict[Cell, str]):
    """What a cell has behind its place, by its value.

    `numbers` has the place of each different text in their table, `quoted` says that one looks like a formula.
    """

    def __init__(self) -> None:
        self.numbers: dict[str, int] = {}
        self.quoted = False

    def __missing__(self, value: Cell) -> str:
        if isinstance(value, int):
            return f'" t="n"><v>{value}</v></c>'
        shown = clean(value or "")
        quoted = shown.startswith(_FORMULAS)
        self.quoted |= quoted
        text = escape(_NOT_XML.sub("", shown[:LONGEST]), quote=False)
        number = self.numbers.setdefault(text, len(self.numbers))
        style = '" s="1"' if quoted else '"'
        self[value] = made = f'{style} t="s"><v>{number}</v></c>'
        return made


def _sheet(sheet: Worksheet, texts: _Texts) -> str:
    columns = [letters(number) for number in range(1, len(sheet.rows[0]) + 1)]
    rows = "".join(
        f'<row r="{number}">'
        + "".join([f'<c r="{column}{number}{texts[cell]}' for column, cell in zip(columns, row, strict=True)])
        + "</row>"
        for number, row in enumerate(sheet.rows, 1)
    )
    return (
        f'<worksheet xmlns="{parts.MAIN}"><sheetPr><outlinePr summaryBelow="1" summaryRight="1"></outlinePr>'
        f'<pageSetUpPr></pageSetUpPr></sheetPr><dimension ref="A1:{columns[-1]}{len(sheet.rows)}"></dimension>'
        '<sheetViews><sheetView workbookViewId="0"><selection activeCell="A1" sqref="A1"></selection></sheetView>'
        '</sheetViews><sheetFormatPr baseColWidth="8" defaultRowHeight="15"></sheetFormatPr>'
        f"<sheetData>{rows}</sheetData>"
        '<pageMargins bottom="1" footer="0.5" header="0.5" left="0.75" right="0.75" top="1"></pageMargins></worksheet>'
    )
