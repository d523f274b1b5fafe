"""`fieldspec show`: a device, or one item of it, with its bits drawn."""

from __future__ import annotations

import argparse

from fieldspec.commands import specs
from fieldspec.commands.output import print_blocks
from fieldspec.commands.usage import unknown
from fieldspec.layout.device import DeviceLayout
from fieldspec.render.item import Item, blocks, handles, items, numbered
from fieldspec.render.overview import overview


def run(arguments: argparse.Namespace) -> int:
    """Prints an overview of the device, or every item that the given text means."""
    layout = specs.layout(arguments.specs, arguments.device)
    if arguments.item is None:
        print_blocks(overview(layout))
        return 0
    number = _number(arguments.item)
    for at, item in enumerate(_meant(layout, arguments.item, number)):
        if at:
            print()
        print_blocks(blocks(layout, item, number))
    return 0


def _meant(layout: DeviceLayout, text: str, number: int | None) -> list[Item]:
    """The items with a name, else those with an address or a code; our names go before the manual's words."""
    known = list(items(layout))
    for place in range(3):
        found = [item for item in known if text and text in handles(item)[place : place + 1]]
        if found:
            return found
    found = [item for item in known if number is not None and numbered(item, number)]
    if not found:
        names = {handle for item in known for handle in handles(item) if handle}
        raise unknown(f"item of {layout.device.id}", text, names)
    return found


def _number(text: str) -> int | None:
    """`0x2011`, `2011h` or `8209` as a number."""
    digits = text[:-1] if text[-1:] in ("h", "H") else text
    try:
        return int(digits, 16) if digits != text else int(text, 0)
    except ValueError:
        return None
