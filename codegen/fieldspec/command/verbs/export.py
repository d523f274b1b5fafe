"""`fieldspec export`: the registers and parameters of a device as a list for people and other programs."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Collection, Sequence

from fieldspec.codec.layout.bases import base_refusals
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.omissions import expressed
from fieldspec.command.console.streams import print_document, print_note
from fieldspec.command.console.usage import UsageError
from fieldspec.command.files.storage import write_or_print
from fieldspec.command.sources import layout_cache
from fieldspec.foundation.classes import replace
from fieldspec.foundation.line_text import plural
from fieldspec.tools.lists.item import MESSAGES, Item, items


def run(arguments: argparse.Namespace) -> int:
    """Writes the list to a file or to standard output, and what it leaves out to standard error. Raises UsageError."""
    from fieldspec.tools.lists.export import as_csv, as_json, as_xlsx

    stated = layout_cache.requested_layout(arguments)
    remaining = expressed(stated, base_refusals(stated, "a list"))
    if remaining.findings:
        from fieldspec.command.rendering.finding_text import rendered

        help = "it is left out; name its values in `fieldspec live`, which reads where they are"
        print_document(rendered([replace(finding, help=help) for finding in remaining.findings]), sys.stderr)
    layout = remaining.layout
    entries = items(layout, arguments.messages)
    if not entries:
        hint = "; --messages exports its messages" if layout.messages and not arguments.messages else ""
        raise UsageError(f"{layout.device.id} has no registers and no parameters{hint}")
    if arguments.to == "xlsx":
        data = as_xlsx(entries, layout.device.id)
    else:
        data = (as_csv(entries) if arguments.to == "csv" else as_json(entries)).encode("utf-8")
    write_or_print(data, arguments.to, arguments.out)
    if absent := _left_out(layout, entries):
        print_note(f"not in the list: {absent}; `fieldspec facts {layout.device.id}` has everything")
    return 0


def _left_out(layout: DeviceLayout, entries: Sequence[Item]) -> str:
    """What of a device its list does not have, by name; empty if it has all."""
    absent = [f"the frames of {_named('link', layout.links)}"] if layout.links else []
    exported = {item.name.partition(".")[0] for item in entries if item.space == MESSAGES}
    messages = [name for name in layout.messages if name not in exported]
    absent += [_named("message", messages)] if messages else []
    return ", and ".join(absent)


def _named(noun: str, names: Collection[str]) -> str:
    return f"{plural(len(names), noun)} ({', '.join(names)})"
