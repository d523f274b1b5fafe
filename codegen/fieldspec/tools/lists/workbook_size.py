"""Bounds the contents of a workbook while it is unpacked, before any of it is in memory.

A cell far away from the others, or an area of merged cells, is a few characters in the file and millions of cells in
memory. So the parts are read as a stream, and the first number that is too great ends it.
"""

from __future__ import annotations

import io
import re
import zipfile
from typing import IO
from xml.parsers import expat

from fieldspec.tools.lists.sheet import MOST_CELLS, MOST_COLUMNS, MOST_ROWS, ListError, column_of

_MOST_UNPACKED = 128 << 20
_MOST_PARTS = 2_000
_MOST_ELEMENTS = 2_000_000
_DEEPEST = 64
_PIECE = 1 << 16
_ENTRY = b"PK\x01\x02"
"""The first bytes of an entry in the table of contents."""
_PLACE = re.compile(r"\$?([A-Za-z]{1,3})\$?([0-9]{1,7})")


def used_area(content: bytes) -> tuple[int, int]:
    """The last row and the last column with contents in any sheet of a workbook.

    Raises ListError for a workbook that has more than a list needs, or declares entities.
    """
    if content.count(_ENTRY) > _MOST_PARTS:
        raise ListError(f"has more than {_MOST_PARTS} parts; a list of registers has fewer")
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as packed:
            parts = packed.infolist()
            if sum(part.file_size for part in parts) > _MOST_UNPACKED:
                raise ListError("unpacks to more than a list of registers holds")
            if "xl/workbook.xml" not in packed.namelist():
                kind = "an OpenDocument file" if "content.xml" in packed.namelist() else "an archive and not a workbook"
                raise ListError(f"is {kind}; save its table as CSV or XLSX")
            counts = _Counts()
            for part in parts:
                if part.filename.lower().endswith((".xml", ".rels", ".vml")):
                    with packed.open(part) as file:
                        counts.count(file)
            return counts.area
    except (zipfile.BadZipFile, zipfile.LargeZipFile, EOFError, RuntimeError, ValueError, OSError, expat.ExpatError):
        raise ListError("is a truncated or protected workbook; save it again as .xlsx, or as CSV") from None
    except ListError:
        raise
    except MemoryError:
        raise ListError("unpacks to more than a list of registers holds") from None
    except Exception:  # zipfile lets pass whatever its decompressors raise
        raise ListError("is a damaged workbook; save it again as .xlsx, or as CSV") from None


class _Counts:
    """Counts over all parts: their elements, and the cells that each sheet needs."""

    def __init__(self) -> None:
        self._elements = 0
        self._depth = 0
        self._row = self._column = 0
        self._rows = self._columns = self._cells = self._merged = 0
        self.area = (0, 0)

    def count(self, file: IO[bytes]) -> None:
        """Adds the counts of a part of the workbook."""
        self._depth = self._row = self._column = self._rows = self._columns = 0
        parser = expat.ParserCreate(namespace_separator=" ")
        parser.buffer_text = False
        parser.StartElementHandler = self._begin
        parser.EndElementHandler = self._end
        parser.StartDoctypeDeclHandler = _refuse_declaration
        while piece := file.read(_PIECE):
            parser.Parse(piece)
        parser.Parse(b"", True)

    def _begin(self, name: str, attributes: dict[str, str]) -> None:
        self._depth += 1
        self._elements += 1
        if self._elements > _MOST_ELEMENTS or self._depth > _DEEPEST:
            raise ListError("unpacks to more than a list of registers holds")
        short = name.rpartition(" ")[2]
        if short == "row":
            self._row, self._column = int(attributes.get("r", self._row + 1)), 0
        elif short == "c":
            self._cells += 1
            if self._cells > MOST_CELLS:
                raise ListError(f"has more than {MOST_CELLS} cells; a list of registers has fewer")
            place = _PLACE.fullmatch(attributes.get("r", ""))
            self._row, self._column = (int(place[2]), column_of(place[1])) if place else (self._row, self._column + 1)
        elif short in ("v", "f", "is"):
            self._reach()
        elif short == "mergeCell":
            self._merge(attributes.get("ref", ""))

    def _end(self, name: str) -> None:
        self._depth -= 1

    def _reach(self) -> None:
        """Takes a cell with contents into account: memory is needed for all cells up to it."""
        self._rows, self._columns = max(self._rows, self._row), max(self._columns, self._column)
        self.area = max(self.area[0], self._rows), max(self.area[1], self._columns)
        if self._rows > MOST_ROWS:
            raise ListError(f"has more than {MOST_ROWS} rows; a list of registers has fewer")
        if self._columns > MOST_COLUMNS:
            raise ListError(f"has more than {MOST_COLUMNS} columns")
        if self._rows * self._columns > MOST_CELLS:
            raise ListError(
                f"has {self._rows} rows with {self._columns} columns, which is more than {MOST_CELLS} cells; "
                f"remove what is far away from the list"
            )

    def _merge(self, area: str) -> None:
        places = [_PLACE.fullmatch(part) for part in area.split(":")]
        rows = [int(place[2]) for place in places if place]
        columns = [column_of(place[1]) for place in places if place]
        if len(rows) < len(places):
            raise ListError("has merged cells without a place; save it again as .xlsx, or as CSV")
        self._merged += (max(rows) - min(rows) + 1) * (max(columns) - min(columns) + 1)
        if self._merged > MOST_CELLS or max(rows) > MOST_ROWS or max(columns) > MOST_COLUMNS:
            raise ListError(f"has merged cells as far as {area}; a list of registers has no such area")


def _refuse_declaration(*_: object) -> None:
    raise ListError("declares entities, which no workbook needs; save it as CSV")
