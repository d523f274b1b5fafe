"""`fieldspec show`: a device or one of its items, with its bits drawn."""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterator
from itertools import islice

from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.command.console.streams import print_line
from fieldspec.command.console.terminal import print_blocks
from fieldspec.command.console.usage import UsageError, not_at, unknown
from fieldspec.command.frames.frame_options import number_of
from fieldspec.command.rendering.item import Item, ParameterNumber, fact_of, handles, items, numbered, unnamed
from fieldspec.command.rendering.item_blocks import blocks
from fieldspec.command.rendering.overview import overview
from fieldspec.command.sources import layout_cache
from fieldspec.language.model.registers import Register, Table


def run(arguments: argparse.Namespace) -> int:
    """Prints an overview of the device, or every item that a text names. Raises UsageError."""
    layout = layout_cache.requested_layout(arguments)
    if arguments.item is None:
        print_blocks(overview(layout))
        return 0
    number = number_of(arguments.item)
    names, users = layout_cache.index(
        arguments.specs, arguments.device, arguments.no_cache, lambda: [_names(item) for item in items(layout)]
    )
    places = _named(names, arguments.item)
    first_items = list(islice(items(layout), places[-1] + 1)) if places else []
    chosen_items = [first_items[place] for place in places] or _numbered(layout, arguments.item, number)
    for index, item in enumerate(chosen_items):
        if index:
            print_line("")
        path = fact_of(item).place.path
        print_blocks(blocks(layout, item, _address_in(layout, item, number), users.get(path, ())))
    return 0


def _names(item: Item) -> list[str]:
    """The path of an item and its handles."""
    return [fact_of(item).place.path, *handles(item)]


def _named(names: list[list[str]], text: str) -> list[int]:
    """The places of the items with a path, else of those with a name. Names of the spec come before printed ones."""
    for exact, kind in ((True, 0), *((exact, kind) for exact in (True, False) for kind in (1, 2, 3))):
        matches = [place for place, own in enumerate(names) if text and _called(own, text, kind, exact)]
        if matches:
            return matches
    return []


def _numbered(layout: DeviceLayout, text: str, number: int | None) -> list[Item]:
    """The items with an address or a number. Raises UsageError where there is none."""
    known = list(items(layout))
    matches = [item for item in known if number is not None and numbered(item, number)]
    matches = matches or [item for item in known if _printed_address(layout, item, number) is not None]
    matches = matches or list(unnamed(layout, text, number))
    if not matches:
        places = {place: name for item in known for place, name in _addressed(item)}
        if number is not None and places:
            raise not_at(f"item of {layout.device.id}", number, places.items())
        if re.fullmatch("[0-9A-Fa-f]+", text) and any(numbered(item, int(text, 16)) for item in known):
            raise UsageError(f"there is no item of {layout.device.id} {text}; did you mean 0x{text}?")
        names = {handle for item in known for handle in handles(item) if handle}
        raise unknown(f"item of {layout.device.id}", text, names)
    return matches


def _addressed(item: Item) -> Iterator[tuple[int, str]]:
    """The address of a register or a table, and the number of a parameter, each with its name."""
    match item:
        case Register():
            yield item.address, item.name
        case TableLayout():
            yield item.table.base, item.table.name
        case ParameterNumber():
            yield item.parameter_set.base + item.number, "".join(handles(item)[:1])
        case _:
            return


def _address_in(layout: DeviceLayout, item: Item, number: int | None) -> int | None:
    """The address or number within an item that a number means: itself, or the address for which it is printed."""
    return number if number is None or numbered(item, number) else _printed_address(layout, item, number)


def _printed_address(layout: DeviceLayout, item: Item, number: int | None) -> int | None:
    """The address within an item for which the manual prints a number, such as 40003; None where it prints none."""
    fact = item.table if isinstance(item, TableLayout) else item
    if number is None or not isinstance(fact, (Register, Table)):
        return None
    address = layout.device.space(fact.space).address_of(number)
    return address if address is not None and numbered(item, address) else None


def _called(names: list[str], text: str, kind: int, exact: bool) -> bool:
    """Whether a text is one of the names of an item; upper and lower case differ only where it is `exact`."""
    name = "".join(names[kind : kind + 1])
    return name == text if exact else name.lower() == text.lower()
