"""Reads lists from text: CSV, tables with bars, numbered lines, pages in HTML, JSON and YAML."""

from __future__ import annotations

import codecs
import csv
import io
import re
from collections import Counter
from collections.abc import Iterator
from itertools import zip_longest

from fieldspec.foundation.spreadsheet import clean
from fieldspec.tools.lists.columns_by_place import numbered_sheet, placed_sheet
from fieldspec.tools.lists.formats.yaml_items import data_of, tree
from fieldspec.tools.lists.html_tables import is_page, page_sheet
from fieldspec.tools.lists.json_text import json_data
from fieldspec.tools.lists.known_formats import is_yaml, refuse_known_format
from fieldspec.tools.lists.object_groups import objects_sheet
from fieldspec.tools.lists.sheet import MOST_COLUMNS, MOST_ROWS, ListError, Sheet, SheetRow

_MARKS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF32_LE, "utf-32"),
    (codecs.BOM_UTF32_BE, "utf-32"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
WESTERN = "cp1252"
"""The encoding of a text that is not UTF-8, whose other letters stand alone and belong to western languages."""

_WESTERN_SIGNS = frozenset(
    "°²³µ±§·\u00d7÷½¼¾ºª®©™€\u2013\u2014\u2018\u2019“”…«»¿¡äöüÄÖÜßéèêëàâáíóúñçôîïìòùûåøæÅØÆÉÀÈÊÍÓÚÑÇãõÃÕ"
)
_KNOWN_BINARIES = (
    (b"\xd0\xcf\x11\xe0", "an old workbook of Excel; save it as .xlsx"),
    (b"%PDF", "a PDF; save its table as CSV"),
    (b"\x1f\x8b", "compressed; unpack it first"),
    (b"{\\rtf", "a document; save its table as CSV"),
)
_SEPARATORS = ("\t", ";", ",", "|")
_LOOKED_AT = 60
_LONGEST_ROW = 1 << 20
_MOST_BORDERS = 3
"""The lines of plus signs of a table that has them around its heading and its end alone."""

_BOLD, _CODE = re.compile(r"\*\*(?=\S)(.+?)\*\*"), re.compile(r"`+([^`]+)`+")
_LINK, _SLANTED = re.compile(r"\[([^\[\]]+)\]\([^()\s]*\)"), re.compile(r"\*(?=\S)([^*]+)\*")
_FORMULA, _NAMED_SIGN = re.compile(r"\$([^$]+)\$"), re.compile(r"\^?\\(?:([A-Za-z]+)|(.))")
_SIGNS_OF_FORMULAS = {
    "circ": "°",
    "mu": "µ",
    "Omega": "Ω",
    "times": "\u00d7",
    "cdot": "·",
    "div": "÷",
    "%": "%",
    "text": "",
    "mathrm": "",
}
"""The signs of formulas in Markdown by their names; others are blanks."""

_RULE = re.compile(r"[|+\s]*[-:=][|+:=\s-]*")
_DELIMITER = re.compile(r"^[ \t]*(?:\|[ \t]*)?:?-+:?[ \t]*(?:\|[ \t]*:?-+:?[ \t]*)+(?:\|[ \t]*)?\r?$", re.MULTILINE)
"""The line below the heading of a table in Markdown."""


def text_sheet(content: bytes, encoding: str = "") -> Sheet:
    """The sheet in a text file. The default encoding is that of the byte order mark, else UTF-8. Raises ListError."""
    text = decoded(content, encoding)
    if not text.strip():
        raise ListError("is empty")
    delimiter = _DELIMITER.search(text)
    if delimiter is None:
        if is_page(text):
            return page_sheet(text)
        refuse_known_format(text)
        if text.lstrip()[0] in "[{":
            lines = [line for line in text.splitlines() if line.strip()]
            are_objects = len(lines) > 1 and all(line.startswith("{") and line.rstrip().endswith("}") for line in lines)
            return objects_sheet(json_data(f"[{','.join(lines)}]" if are_objects else text), "JSON")
        if is_yaml(text):
            return objects_sheet(data_of(tree(text)), "YAML of no program that is known", only_with_addresses=True)
        if (numbered := numbered_sheet(text)) is not None:
            return numbered
    guessed = WESTERN if not encoding and _is_western(content) else ""
    first_lines = [line for line, _ in zip(io.StringIO(text, newline=None), range(_LOOKED_AT), strict=False)]
    separator = "|" if delimiter is not None else _separator(first_lines)
    if not separator:
        placed = placed_sheet(text)
        if placed is not None:
            return placed
        separator = ","
    bars = separator == "|"
    heads: set[int] = set()
    above = text[: delimiter.start()].splitlines() if delimiter is not None else text.splitlines()
    heading = next((line.strip() for line in (above[::-1] if delimiter is not None else above) if "|" in line), "")
    is_bordered = bars and heading.startswith("|")
    is_grid = bars and sum(line.startswith("+") for line in text.splitlines()) > _MOST_BORDERS
    is_first = True
    rows: list[SheetRow] = []
    size = [0]
    reader = csv.reader(
        _bounded_lines(text, size),
        delimiter=separator,
        quoting=csv.QUOTE_NONE if bars else csv.QUOTE_MINIMAL,
        escapechar="\\" if bars and "\\|" in text else None,
    )
    number = 0
    try:
        for cells in reader:
            number += 1
            size[0] = 0
            if number > MOST_ROWS:
                raise ListError(f"has more than {MOST_ROWS} rows; a list of registers has fewer")
            if len(cells) > MOST_COLUMNS:
                raise ListError(f"has a row {number} with more than {MOST_COLUMNS} cells")
            if bars and _RULE.fullmatch(separator.join(cells)):
                is_first = True
                if len(cells) > 1 and rows and rows[-1].number == number - 1 and not is_grid:
                    heads.add(number - 1)
                continue
            if is_bordered and cells and not cells[0].strip():
                cells = cells[1:]
            row = tuple(clean(_without_markup(cell) if bars else cell) for cell in cells)
            if is_grid and not is_first:
                last = rows.pop()
                pairs = zip_longest(last.cells, row, fillvalue="")
                rows.append(SheetRow(last.number, tuple(" ".join(filter(None, pair)) for pair in pairs)))
            elif any(row):
                rows.append(SheetRow(number, row))
            is_first = False
    except csv.Error as error:
        raise ListError(f"cannot be read as a table at row {number + 1}: {error}") from None
    return Sheet(tuple(rows), number, encoding=guessed, heads=frozenset(heads))


def _without_markup(cell: str) -> str:
    """A cell of a table with bars without the signs of Markdown for bold, code and links."""
    cell = _LINK.sub(r"\1", _CODE.sub(r"\1", _BOLD.sub(r"\1", _FORMULA.sub(_signs_of_formula, cell))))
    slanted = _SLANTED.fullmatch(cell.strip())
    return slanted[1] if slanted else cell


def _signs_of_formula(formula: re.Match[str]) -> str:
    """The text of a formula in a cell: `0.1 °C` for `$0.1\\ ^\\circ\\text{C}$`."""
    text = _NAMED_SIGN.sub(lambda sign: _SIGNS_OF_FORMULAS.get(sign[1] or sign[2], " "), formula[1])
    return " ".join(re.sub("[{}]", "", text).split())


def _bounded_lines(text: str, size: list[int]) -> Iterator[str]:
    """The lines of a text. `size` counts the characters of a row, which may have several lines, and is bounded."""
    for line in io.StringIO(text, newline=""):
        size[0] += len(line)
        if size[0] > _LONGEST_ROW:
            raise ListError(f"has a row with more than {_LONGEST_ROW} characters; a list of registers has shorter ones")
        yield line


def decoded(content: bytes, encoding: str = "") -> str:
    """The text of a file. Raises ListError if the file is not a text."""
    for mark, kind in _KNOWN_BINARIES:
        if content.startswith(mark):
            raise ListError(f"is {kind}")
    marked = next((name for mark, name in _MARKS if content.startswith(mark)), "")
    encoding_name = encoding or marked
    try:
        if encoding_name:
            codec = codecs.lookup(encoding_name)
            if not getattr(codec, "_is_text_encoding", True):
                raise LookupError
        text = content.decode(encoding_name or "utf-8")
    except LookupError:
        raise ListError(
            f"cannot be read: there is no encoding {encoding_name}; some are gbk, big5, utf-16, cp1252"
        ) from None
    except UnicodeError:
        if encoding_name:
            raise ListError(f"is not in the encoding {encoding_name}; use another --encoding") from None
        if b"\0" in content:
            raise ListError("is binary: use a CSV or XLSX file, or add --encoding utf-16-le") from None
        if _is_western(content):
            return content.decode(WESTERN)
        raise ListError("is not UTF-8; state its encoding, such as --encoding gbk or --encoding big5") from None
    if "\0" in text:
        hint = "use a CSV or XLSX file" if encoding_name else "use a CSV or XLSX file, or add --encoding utf-16-le"
        raise ListError(f"is binary: {hint}")
    return text.removeprefix("\ufeff")


def _is_western(content: bytes) -> bool:
    """Whether bytes are not UTF-8, and a text with western letters, of which no more than two stand together."""
    try:
        content.decode("utf-8")
    except UnicodeError:
        text = content.decode(WESTERN, "replace")
        runs = re.findall(r"[^\x00-\x7f]+", text)
        return all(len(run) <= 2 and _WESTERN_SIGNS.issuperset(run) for run in runs)
    return False


def _separator(lines: list[str]) -> str:
    """The separator that gives the most rows of equal length; bars for a table with bars around it.

    It is empty where none parts half of the rows.
    """
    looked_at = [line for line in lines if line.strip()]
    if all(line.strip().startswith("|") or _RULE.fullmatch(line) for line in looked_at):
        return "|"
    best, best_score, rows = ",", (0, 0), 0
    for separator in _SEPARATORS:
        try:
            widths = Counter(map(len, csv.reader(looked_at, delimiter=separator)))
        except csv.Error:
            continue
        parted = [(count, width) for width, count in widths.items() if width > 1]
        if (score := max(parted, default=(0, 0))) > best_score:
            best, best_score, rows = separator, score, widths.total()
    return best if 0 < rows <= best_score[0] * 2 else ""
