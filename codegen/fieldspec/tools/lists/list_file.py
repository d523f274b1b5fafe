"""The list in a file of any kind that is taken: a table, a workbook, JSON, or a file of another program."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.foundation.classes import attributes, replace
from fieldspec.tools.lists.assumption import Options
from fieldspec.tools.lists.formats.recognition import formatted_list
from fieldspec.tools.lists.listing import Listing, listing
from fieldspec.tools.lists.sheet import ListError, Sheet
from fieldspec.tools.lists.text_sheet import decoded, text_sheet
from fieldspec.tools.lists.workbook_reader import MAGIC, workbook_sheet


def content_sheet(content: bytes, encoding: str = "", sheet_name: str = "") -> Sheet:
    """The rows of a table. Its first bytes, not its name, decide whether it is a workbook. Raises ListError."""
    if content.startswith(MAGIC):
        return workbook_sheet(content, sheet_name)
    if sheet_name:
        raise ListError("is not a workbook, so --sheet has no effect; leave it out")
    return text_sheet(content, encoding)


def file_list(
    content: bytes, encoding: str, sheet_name: str, names: Mapping[str, str], options: Options
) -> tuple[Sheet, Listing]:
    """The rows of a file, and the list in them. Its content, not its name, decides what it is. Raises ListError."""
    is_text = not content.startswith(MAGIC) and not sheet_name
    formatted = formatted_list(decoded(content, encoding), options.node) if is_text else None
    if formatted is None:
        sheet = content_sheet(content, encoding, sheet_name)
        result = listing(sheet, names, options)
        lines = max(sheet.lines, *(row.number for row in result.columns.rows))  # a matrix has more rows than the file
        return replace(sheet, lines=lines), result
    idle = [*names, *(key for key in attributes(Options) if key != "node" and getattr(options, key))]
    if idle:
        raise ListError(f"says that itself, so --{idle[0].replace('_', '-')} has no effect; leave it out")
    return formatted
