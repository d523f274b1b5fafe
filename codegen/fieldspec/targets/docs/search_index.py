"""The data of the search box: the facts of all versions of a device, each with its names, numbers, text and anchor."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.html_text import clean
from fieldspec.targets.docs.changes import page_name
from fieldspec.targets.docs.context import address
from fieldspec.targets.docs.document import (
    Cell,
    Document,
    DocumentTable,
    Facts,
    Line,
    Paragraph,
    Section,
    TableColumn,
    TableRow,
)
from fieldspec.targets.pieces import piece

NAME = "search-index.js"
"""The file of a device."""

_CALL = "fieldspecSearch.add("
_END = ");\n"
_NAME_TERM = "Name"
_NUMBER_TERMS = ("Number", "Code", "Addresses")
_LEADS = ("See: ", "Erratum: ")
"""The beginnings of lines that lead to other facts, which the search has by themselves."""
_FIRST = ("registers", "tables", "parameters", "words", "messages", "codes")
"""The sections whose facts stand first among equal results."""
_NUMBER = re.compile(r"(?:0x([0-9A-Fa-f]+)|([0-9A-Fa-f]+)h|([0-9]+))(?=\.\.|\Z)")
_UNSEARCHED = ("device", "examples", "sources")
"""The sections that repeat facts of others."""


@dataclass(frozen=True, slots=True)
class Entry:
    """A fact that the search has: `names` begins with its identifier, labels of the manual follow."""

    kind: str
    section: str
    anchor: str
    names: tuple[str, ...]
    keys: tuple[str, ...]
    text: str


def index_file(layouts: Sequence[DeviceLayout], pages: Mapping[str, Document]) -> str:
    """The file of a device: a call with one object, in JSON.

    `id`, `name`, `vendor`, `title`, `language` (of the labels) and `identity` describe the newest version; `pages` has
    the file, the name and the counts of each version, the newest first. Each group is a kind, a section's title, and
    what its anchors begin with; each of its entries has the end of the anchor (0 where it is the name), names, keys,
    text and the versions that have it, as bits; what is empty at the end is left out.
    """
    newest = layouts[-1].device
    versions: dict[Entry, int] = {}
    for number, layout in enumerate(reversed(layouts)):
        for entry in _entries(pages[layout.device.version], _table_keys(layout)):
            versions[entry] = versions.get(entry, 0) | 1 << number
    all_versions = (1 << len(layouts)) - 1
    groups: dict[tuple[str, str, str], list[list[object]]] = {}
    for entry in sorted(versions, key=lambda entry: _order(entry.kind)):
        start = entry.anchor.rpartition("/")[0]
        group = groups.setdefault((entry.kind, entry.section, start), [])
        group.append(_entry_row(entry, versions[entry] if versions[entry] != all_versions else 0))
    data = {
        "id": newest.id,
        "name": clean(newest.name),
        "vendor": clean(newest.vendor),
        "title": pages[newest.version].subtitle,
        "language": newest.manual.language,
        "identity": layouts[-1].identity,
        "pages": [
            [page_name(layout.device.version), layout.device.version, _counts(layout)] for layout in reversed(layouts)
        ],
        "groups": [[*group, rows] for group, rows in groups.items()],
    }
    return f"{_CALL}{json.dumps(data, ensure_ascii=False, separators=(',', ':'))}{_END}"


def parsed(text: str) -> dict[str, object]:
    """The object in the text of an index file."""
    data: dict[str, object] = json.loads(text.removeprefix(_CALL).removesuffix(_END))
    return data


def _counts(layout: DeviceLayout) -> str:
    device = layout.device
    counts = (
        (sum(register.count for register in device.registers()), "registers"),
        (len(device.messages), "messages"),
        (sum(len(parameter_set.parameters) for parameter_set in device.parameters.values()), "parameters"),
    )
    return ", ".join(f"{number} {noun}" for number, noun in counts if number)


def _order(kind: str) -> int:
    return _FIRST.index(kind) if kind in _FIRST else len(_FIRST)


def _entry_row(entry: Entry, versions: int) -> list[object]:
    """An entry of the file, without what is empty at its end."""
    end = entry.anchor.rpartition("/")[2]
    row: list[object] = [
        0 if end == entry.names[0] else end,
        "\n".join(entry.names),
        " ".join(entry.keys),
        entry.text,
        versions,
    ]
    while not row[-1] and len(row) > 2:
        row.pop()
    return row


def _entries(document: Document, table_keys: Mapping[str, str]) -> Iterator[Entry]:
    """The facts of a page: sections, and the rows of their tables."""
    words = tuple(table_keys.items())
    for section in document.sections:
        if section.anchor not in _UNSEARCHED:
            for inner in section.sections or (section,):
                make = partial(_of_section, section.anchor, inner, table_keys)
                yield from piece("search entries", (inner,), (section.anchor, words), make)


def _of_section(kind: str, section: Section, table_keys: Mapping[str, str]) -> tuple[Entry, ...]:
    return tuple(_section_entries(kind, section, table_keys))


def _section_entries(kind: str, section: Section, table_keys: Mapping[str, str]) -> Iterator[Entry]:
    terms = {term: _texts(lines) for block in section.blocks if isinstance(block, Facts) for term, lines in block.rows}
    title = _line_text(section.title)
    keys = [word for term in _NUMBER_TERMS for text in terms.get(term, ()) for word in text.split() if word[0] != "("]
    titles = [piece for piece in _pieces(section.title) if piece not in keys]
    names = dict.fromkeys([*terms.get(_NAME_TERM, ()), *titles])
    lines = [block.line for block in section.blocks if isinstance(block, Paragraph) and not block.style]
    paragraphs = [_line_text(line) for line in lines if line[0].text not in _LEADS]
    yield Entry(kind, title, section.anchor, tuple(names) or (title,), tuple(dict.fromkeys(keys)), " ".join(paragraphs))
    for block in section.blocks:
        if isinstance(block, DocumentTable):
            for row in block.rows:
                if row.anchor or kind == "lookups":
                    yield _of_row(kind, title, section.anchor, block, row, table_keys)
    for inner in section.sections:
        yield from _section_entries(kind, inner, table_keys)


def _of_row(
    kind: str, title: str, anchor: str, table: DocumentTable, row: TableRow, table_keys: Mapping[str, str]
) -> Entry:
    heading = row.cells[max(table.heading, 0)]
    names = [piece for line in heading.lines for piece in _pieces(line)]
    keys = [
        key
        for column, cell in zip(table.columns, row.cells, strict=True)
        if column.search == "key"
        for key in _keys(cell)
    ]
    if row.anchor in table_keys:
        keys.append(table_keys[row.anchor])
    texts = [
        text
        for column, cell in zip(table.columns, row.cells, strict=True)
        if cell is not heading and _is_text(kind, column)
        for text in _cell_texts(cell)
    ]
    return Entry(kind, title, row.anchor or anchor, tuple(dict.fromkeys(names)) or ("",), tuple(keys), " ".join(texts))


def _is_text(kind: str, column: TableColumn) -> bool:
    """Whether the words of a column are searched."""
    return column.search == "text" or column.style == "wide" or (kind == "lookups" and column.style != "source")


def _keys(cell: Cell) -> Iterator[str]:
    """The numbers of a cell; a decimal number only where it is not the hexadecimal one before it."""
    known: set[int] = set()
    for key in " ".join(_texts(cell.lines)).replace(" to ", "..").split():
        match = _NUMBER.match(key)
        number = -1 if match is None else int(match[3]) if match[3] else int(match[1] or match[2], 16)
        if number not in known:
            yield key
        if match is not None:
            known.add(number)


def _table_keys(layout: DeviceLayout) -> dict[str, str]:
    """The addresses of the fields of record tables by anchor: the first one, the distance and the count."""
    keys = {}
    for table_layout in layout.tables.values():
        table = table_layout.table
        for field in table_layout.record.stated_fields:
            first = table.base + field.offset // 2
            words = (field.offset % 2 + field.size * (field.count or 1) + 1) // 2
            span = f"{address(first)}..{address(first + words - 1)}" if words > 1 else address(first)
            keys[field.field.place.path] = f"{span}+{table.stride}*{table.count}"
    return keys


def _texts(lines: Iterable[Line]) -> list[str]:
    return [_line_text(line) for line in lines]


def _cell_texts(cell: Cell) -> list[str]:
    lines = [line for line in cell.lines if line[0].text not in _LEADS]
    return [*_texts(lines), *(text for item in cell.items for text in _texts((item.line, *item.inner)))]


def _line_text(line: Line) -> str:
    return "".join([piece.text for piece in line if piece.style != "mark"]).strip()


def _pieces(line: Line) -> list[str]:
    return [text for piece in line if piece.style != "mark" and (text := piece.text.strip())]
