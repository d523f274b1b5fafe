"""Lists of values as files: CSV, XLSX, JSON and YAML."""

from __future__ import annotations

import json
from pathlib import PurePath

from fieldspec.foundation.spreadsheet import clean, csv_text
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence
from fieldspec.language.reading.yaml_reader import decoded, parsed
from fieldspec.tools.lists.sheet import MOST_COLUMNS, MOST_ROWS, ListError, Sheet, SheetRow
from fieldspec.tools.lists.text_sheet import text_sheet
from fieldspec.tools.lists.workbook_reader import MAGIC, workbook_sheet
from fieldspec.tools.lists.workbook_writer import workbook
from fieldspec.tools.live.value_lists import ValueList

SUFFIXES = (".csv", ".xlsx", ".json", ".yaml", ".yml")
"""The forms of files, by the end of their names."""

_YAML = (".yaml", ".yml")


def suffix(name: str) -> str:
    """The end of a file's name that says its form. Raises ListError for any other one."""
    own = PurePath(name).suffix.lower()
    if own not in SUFFIXES:
        raise ListError(f"must end in one of {', '.join(SUFFIXES)}, which says its form")
    return own


def file_content(name: str, values: ValueList) -> bytes:
    """The content of a file with a list; the same list gives the same bytes. Raises ListError."""
    own = suffix(name)
    if own == ".xlsx":
        return workbook("values", values.columns, values.rows)
    if own == ".csv":
        return csv_text([values.columns, *values.rows]).encode()
    rows = [
        {head: item for head, item in zip(values.columns, row, strict=True) if item is not None} for row in values.rows
    ]
    if own == ".json":
        return (json.dumps(rows, ensure_ascii=False, indent=1) + "\n").encode()
    return "".join(_yaml_row(row) for row in rows).encode()


def _yaml_row(row: dict[str, int | str]) -> str:
    """An item of a YAML list. Every text is in quotes, so that none is read as something else."""
    lines = [f"{head}: {json.dumps(item)}" for head, item in row.items()]
    return "- " + "\n  ".join(lines) + "\n"


def file_sheet(name: str, content: bytes) -> Sheet:
    """The rows of a file. Raises ListError."""
    own = suffix(name)
    if content.startswith(MAGIC):
        return _filled(workbook_sheet(content))
    if own in _YAML:
        return _of_yaml(name, content)
    return _filled(text_sheet(content))


def _filled(sheet: Sheet) -> Sheet:
    if not sheet.rows:
        raise ListError("is empty")
    return sheet


def _of_yaml(name: str, content: bytes) -> Sheet:
    """The sheet of a YAML list of mappings. Its columns are their keys, and the number of a row is its line."""
    file, problems = decoded(name, content)
    node: Node | None = None
    if not problems:
        node, problems = parsed(file)
    if problems:
        raise ListError(f"is not YAML: {problems[0].message}")
    items = [item for item in node.items if isinstance(item, Mapping)] if isinstance(node, Sequence) else []
    if not isinstance(node, Sequence) or not items or len(items) != len(node.items):
        raise ListError("is YAML but not a list of mappings")
    heads = list(dict.fromkeys(key for item in items for key in item.values))
    if len(items) > MOST_ROWS or len(heads) > MOST_COLUMNS:
        raise ListError(f"has more than {MOST_ROWS} rows or {MOST_COLUMNS} columns")
    rows = [SheetRow(0, tuple(map(clean, heads)))]
    rows += [
        SheetRow(item.span.position()[0], tuple(_yaml_cell(item.values.get(head)) for head in heads)) for item in items
    ]
    return Sheet(tuple(rows), len(items) + 1)


def _yaml_cell(node: Node | None) -> str:
    if node is None:
        return ""
    if not isinstance(node, Scalar):
        raise ListError(f"has a list or a mapping in line {node.span.position()[0]}, where a value is expected")
    return "" if not node.quoted and node.text in ("", "~", "null") else clean(node.text)
