"""`fieldspec compare`: a device beside a register list from another source."""

from __future__ import annotations

import argparse

from fieldspec.command.console.streams import print_document, print_json
from fieldspec.command.console.terminal import print_blocks
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.files import list_files
from fieldspec.command.sources import layout_cache


def run(arguments: argparse.Namespace) -> int:
    """Prints what agrees, differs and is missing. Exit code 1 where there is any difference. Raises UsageError."""
    from fieldspec.command.rendering import comparison
    from fieldspec.tools.lists.comparison import compared, has_messages
    from fieldspec.tools.lists.differences import ASPECTS
    from fieldspec.tools.lists.item import items
    from fieldspec.tools.lists.list_file import file_list
    from fieldspec.tools.lists.sheet import ListError

    ignored = frozenset(filter(None, (arguments.ignore or "").split(",")))
    for aspect in sorted(ignored - {*ASPECTS}):
        raise unknown("aspect to compare", aspect, ASPECTS)
    layout = layout_cache.requested_layout(arguments)
    columns = list_files.column_options(arguments)
    try:
        data, options = list_files.content(arguments.file), list_files.reading_options(arguments)
        _, register_list = file_list(data, arguments.encoding or "", arguments.sheet or "", columns, options)
        result = compared(items(layout, has_messages(register_list)), register_list, arguments.offset, ignored)
    except ListError as error:
        raise UsageError(f"{arguments.file} {error}") from None
    if arguments.format == "json":
        print_json(comparison.as_data(result, register_list), indent=1)
    elif arguments.format == "csv":
        print_document(comparison.as_csv(result))
    else:
        print_blocks(comparison.blocks(result, register_list))
    return 0 if result.same else 1
