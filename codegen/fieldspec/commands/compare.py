"""`fieldspec compare`: a device beside a register list that someone else has made."""

from __future__ import annotations

import argparse
import json

from fieldspec.commands import compiled, list_files
from fieldspec.commands.output import print_blocks
from fieldspec.commands.usage import UsageError, unknown

COLUMNS = ("address", "space", "name", "words", "type", "access")
"""The columns that an option names."""


def run(arguments: argparse.Namespace) -> int:
    """Prints what agrees, differs and is missing. Exit code 1 where there is any difference."""
    from fieldspec.lists.comparison import ASPECTS, compared
    from fieldspec.lists.item import items
    from fieldspec.lists.listing import listing
    from fieldspec.lists.sheet import ListError
    from fieldspec.render import comparison

    ignored = frozenset(filter(None, (arguments.ignore or "").split(",")))
    for aspect in sorted(ignored - {*ASPECTS}):
        raise unknown("thing that is compared", aspect, ASPECTS)
    layout = compiled.asked(arguments)
    given = {role: text for role in COLUMNS if (text := getattr(arguments, role)) is not None}
    try:
        held = list_files.sheet(list_files.content(arguments.file), arguments.encoding or "", arguments.sheet or "")
        found = listing(held, given, arguments.base or "")
    except ListError as error:
        raise UsageError(f"{arguments.file} {error}") from None
    result = compared(items(layout), found, arguments.offset, ignored)
    if arguments.format == "json":
        print(json.dumps(comparison.as_data(result, found), ensure_ascii=False, indent=1))
    elif arguments.format == "csv":
        print(comparison.as_csv(result), end="")
    else:
        print_blocks(comparison.blocks(result, found))
    return 0 if result.same else 1
