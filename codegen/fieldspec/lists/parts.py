"""The parts of a packed workbook: its list of contents, its relations, and what is the same in all of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from html import escape
from pathlib import Path

_FORMATS = "http://schemas.openxmlformats.org"
_OFFICE = f"{_FORMATS}/officeDocument/2006"
_PACKAGE = f"{_FORMATS}/package/2006"
MAIN = f"{_FORMATS}/spreadsheetml/2006/main"
"""The name space of sheets and of their texts."""

_SHEETS = "application/vnd.openxmlformats-officedocument.spreadsheetml"
_DOCUMENT = "application/vnd.openxmlformats-officedocument"
_RELATIONS = "application/vnd.openxmlformats-package.relationships+xml"
_QUOTED = '<xf borderId="0" fillId="0" fontId="0" numFmtId="0" pivotButton="0" quotePrefix="1" xfId="0"></xf></cellXfs>'

# Neither the program that has written it nor the time.
APP = f'<Properties xmlns="{_OFFICE}/extended-properties"/>'
CORE = (
    f'<cp:coreProperties xmlns:cp="{_PACKAGE}/metadata/core-properties" '
    'xmlns:dcterms="http://purl.org/dc/terms/" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">'
    '<dcterms:created xsi:type="dcterms:W3CDTF">1980-01-01T00:00:00Z</dcterms:created>'
    '<dcterms:modified xsi:type="dcterms:W3CDTF">1980-01-01T00:00:00Z</dcterms:modified></cp:coreProperties>'
)


@cache
def theme() -> str:
    """The colours and the fonts of a plain workbook."""
    return _text("theme.xml")


@cache
def styles(quoted: bool) -> str:
    """The formats of cells: the plain one, and where some are `quoted`, one of texts that look like formulas."""
    text = _text("styles.xml")
    return text.replace('<cellXfs count="1">', '<cellXfs count="2">').replace("</cellXfs>", _QUOTED) if quoted else text


def _text(name: str) -> str:
    return Path(__file__).with_name(name).read_text("utf-8").rstrip("\n")


def properties(named: Mapping[str, str]) -> str:
    """What a workbook says of itself."""
    kind = 'fmtid="{D5CDD505-2E9C-101B-9397-08002B2CF9AE}"'
    texts = "".join(
        f'<property {kind} name="{name}" pid="{number}">'
        f'<vt:lpwstr xmlns:vt="{_OFFICE}/docPropsVTypes">{escape(text, quote=False)}</vt:lpwstr></property>'
        for number, (name, text) in enumerate(named.items(), 2)
    )
    return f'<Properties xmlns="{_OFFICE}/custom-properties">{texts}</Properties>'


def workbook(titles: Sequence[str]) -> str:
    """The list of sheets."""
    sheets = "".join(
        f'<sheet xmlns:r="{_OFFICE}/relationships" name="{title}" sheetId="{number}" state="visible" '
        f'r:id="rId{number}"></sheet>'
        for number, title in enumerate(titles, 1)
    )
    return (
        f'<workbook xmlns="{MAIN}"><workbookPr></workbookPr><workbookProtection></workbookProtection><bookViews>'
        '<workbookView activeTab="0" autoFilterDateGrouping="1" firstSheet="0" minimized="0" '
        'showHorizontalScroll="1" showSheetTabs="1" showVerticalScroll="1" tabRatio="600" visibility="visible">'
        f"</workbookView></bookViews><sheets>{sheets}</sheets><definedNames></definedNames>"
        '<calcPr calcId="124519" fullCalcOnLoad="1"></calcPr></workbook>'
    )


def workbook_relations(sheets: int) -> str:
    """Where the parts lie that a workbook is made of."""
    places = [(f"rId{number}", f"/xl/worksheets/sheet{number}.xml", "worksheet") for number in range(1, sheets + 1)]
    places += [(f"rId{sheets + 1}", "styles.xml", "styles"), (f"rId{sheets + 2}", "theme/theme1.xml", "theme")]
    places.append(("rIdStrings", "/xl/sharedStrings.xml", "sharedStrings"))
    return _relations((name, place, f"{_OFFICE}/relationships/{kind}") for name, place, kind in places)


def relations(described: bool) -> str:
    """Where the workbook lies, and what is said of it; where it is `described`, by properties of its own too."""
    places = [
        ("rId1", "xl/workbook.xml", f"{_OFFICE}/relationships/officeDocument"),
        ("rId2", "docProps/core.xml", f"{_PACKAGE}/relationships/metadata/core-properties"),
        ("rId3", "docProps/app.xml", f"{_OFFICE}/relationships/extended-properties"),
    ]
    if described:
        places.append(("rId4", "docProps/custom.xml", f"{_OFFICE}/relationships/custom-properties"))
    return _relations(places)


def _relations(places: Iterable[tuple[str, str, str]]) -> str:
    held = "".join(
        f'<Relationship Id="{name}" Target="{place}" Type="{kind}"></Relationship>' for name, place, kind in places
    )
    return f'<Relationships xmlns="{_PACKAGE}/relationships">{held}</Relationships>'


def contents(sheets: int, described: bool) -> str:
    """The kinds of all parts."""
    kinds = [
        ("/xl/styles.xml", f"{_SHEETS}.styles"),
        ("/xl/theme/theme1.xml", f"{_DOCUMENT}.theme"),
        ("/docProps/core.xml", "application/vnd.openxmlformats-package.core-properties"),
        ("/docProps/app.xml", f"{_DOCUMENT}.extended-properties"),
        *([("/docProps/custom.xml", f"{_DOCUMENT}.custom-properties")] if described else []),
        *((f"/xl/worksheets/sheet{number}.xml", f"{_SHEETS}.worksheet") for number in range(1, sheets + 1)),
        ("/xl/workbook.xml", f"{_SHEETS}.sheet.main"),
        ("/xl/sharedStrings.xml", f"{_SHEETS}.sharedStrings"),
    ]
    held = "".join(f'<Override ContentType="{kind}+xml" PartName="{place}"></Override>' for place, kind in kinds)
    return (
        f'<Types xmlns="{_PACKAGE}/content-types"><Default ContentType="{_RELATIONS}" Extension="rels"></Default>'
        f'<Default ContentType="application/xml" Extension="xml"></Default>{held}</Types>'
    )
