"""What differs between an item of a device and a row of a list, aspect by aspect."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator
from decimal import Decimal
from fractions import Fraction

from fieldspec.foundation.classes import dataclass
from fieldspec.tools.lists.item import Item
from fieldspec.tools.lists.quantities import known_unit
from fieldspec.tools.lists.row_reading import ListRow
from fieldspec.tools.lists.words import folded
from fieldspec.tools.lists.yaml_text import exact

ASPECTS = (
    "name",
    "type",
    "access",
    "words",
    "unit",
    "scale",
    "offset",
    "min",
    "max",
    "default",
    "const",
    "count",
    "stride",
    "order",
    "values",
    "bits",
)
"""The keys that are compared if both state them."""

_POWER = re.compile(r"10\s*(\^|\*\*)")


@dataclass(frozen=True, slots=True)
class Difference:
    """An aspect in which the device and the list differ, as each writes it."""

    aspect: str
    ours: str
    theirs: str


def names_of(item: Item, row: ListRow) -> set[str]:
    """The names of an item; of a field of a table, with the number of the element at the address of a row too."""
    table, _, name = item.name.rpartition(".")
    number = item.first + (row.address - item.address) // item.stride if item.stride else item.first
    names = (item.name, name, item.printed_name, item.label, f"{table}{number}{name}")
    return {folded(name) for name in names} - {""}


def differences(item: Item, row: ListRow, aspects: Collection[str]) -> Iterator[Difference]:
    texts, value = row.texts, item.value
    yield from _unread(item, row, aspects)
    if "name" in aspects and row.names and names_of(item, row).isdisjoint(map(folded, row.names)):
        yield Difference("name", item.name, row.names[0])
    if "type" in aspects and "type" in texts and not _is_of_type(item, row):
        yield Difference("type", item.type, texts["type"])
    if "access" in aspects and "access" in texts and item.access and row.access != item.access:
        yield Difference("access", item.access, texts["access"])
    if "words" in aspects and row.words is not None and item.words is not None and row.words != item.words:
        yield Difference("words", str(item.words), str(row.words))
    if "count" in aspects and "count" in texts and row.count != item.count:
        yield Difference("count", str(item.count), texts["count"])
    if "stride" in aspects and row.stride and item.stride and row.stride != item.stride:
        yield Difference("stride", str(item.stride), texts["stride"])
    if value is None:
        return
    unit = value.quantity_unit
    if "unit" in aspects and row.unit and unit and not _same_unit(unit, row.unit):
        yield Difference("unit", unit, texts.get("unit", row.unit))
    if "scale" in aspects and row.scale is not None and (row.scale != Fraction(value.scale) or value.scale_by):
        own_scale = f"10^{value.scale_by}" if value.scale_by else exact(Fraction(value.scale))
        yield Difference("scale", own_scale, exact(row.scale))
    if "offset" in aspects and "value_offset" in texts and row.offset != value.offset:
        yield Difference("offset", f"{value.offset:f}", f"{row.offset:f}")
    if "order" in aspects and row.order and value.has_words and row.order != (item.order or "ABCD"):
        yield Difference("order", item.order or "ABCD", row.order)
    if "values" in aspects:
        yield from _value_differences(item, row)
    if "bits" in aspects:
        for bit in row.meanings.bits:
            yield from _bit_difference(item, bit.low, bit.name)
    default = value.default if value.const is None else value.const  # what never changes begins as it is
    ranges = value.writable_ranges
    bounds = (
        ("min", ranges.low if ranges else None, row.low),
        ("max", ranges.high if ranges else None, row.high),
        ("default", default if isinstance(default, int) else None, row.default),
        ("const", value.const, row.const),
    )
    for aspect, ours, theirs in bounds:
        if aspect in aspects and ours is not None and theirs is not None and not _is_same_value(item, ours, theirs):
            yield Difference(aspect, str(ours), f"{theirs:f}")


_READ: dict[str, Callable[[ListRow], object]] = {
    "access": lambda row: row.access,
    "words": lambda row: row.length is not None,
    "min": lambda row: row.low is not None,
    "max": lambda row: row.high is not None,
    "default": lambda row: row.default is not None,
    "const": lambda row: row.const is not None,
    "scale": lambda row: row.scale is not None or _POWER.match(row.texts["scale"]),
    "range": lambda row: row.low is not None or row.meanings.members or row.meanings.bits,
    "values": lambda row: row.meanings.members or row.meanings.bits,
    "unit": lambda row: not any(doubt.startswith("Unit in the list") for doubt in row.doubts),
}
"""The roles whose cells may be unreadable, and whether that of a row was read."""


def _is_of_type(item: Item, row: ListRow) -> bool:
    """Whether the type of a row is that of an item, with the form in which an export has it."""
    return row.texts["type"] == item.type or (row.type is not None and row.type.fits(item.type))


def _unread(item: Item, row: ListRow, aspects: Collection[str]) -> Iterator[Difference]:
    """The cells that were not understood: it is unknown whether they agree."""
    for role, is_read in _READ.items():
        text = row.texts.get(role, "")
        if (
            text
            and ("min" if role == "range" else role) in aspects
            and not is_read(row)
            and not _is_own_scale(item, text)
            and not (item.value is not None and item.value.default == text)
        ):
            yield Difference(role, "", f"{text} (not read)")


def _is_own_scale(item: Item, text: str) -> bool:
    value = item.value
    return value is not None and bool(value.scale_by) and text.endswith(value.scale_by)


def _value_differences(item: Item, row: ListRow) -> Iterator[Difference]:
    """The values whose texts differ, and those that only one of both has, where the list has any."""
    theirs = dict(row.meanings.members)
    if not theirs:
        return
    ours = {int(number): name for number, name in item.members if number.lstrip("-").isdecimal()}
    for number in sorted({*ours, *theirs}):
        name, text = ours.get(number, ""), theirs.get(number, "")
        if not _is_same_name(item, name, text):
            yield Difference("values", f"{number} {name}" if name else "", f"{number} {text}" if text else "")


def bit_differences(item: Item, row: ListRow) -> Iterator[Difference]:
    """What differs of a row about a bit."""
    assert row.bits is not None
    is_named = any(
        _is_same_name(item, name, text) for first, last, name in item.bits if first == row.bits[0] for text in row.names
    )
    if not is_named:
        yield from _bit_difference(item, row.bits[0], row.names[0] if row.names else "")


def _bit_difference(item: Item, number: int, text: str) -> Iterator[Difference]:
    name = next((name for first, _, name in item.bits if first == number), "")
    if not _is_same_name(item, name, text):
        yield Difference("bits", f"{number} {name}" if name else "", f"{number} {text}")


def _is_same_name(item: Item, name: str, text: str) -> bool:
    return folded(text) in {folded(known) for known in (name, *item.other_names.get(name, ()))}


def _is_same_value(item: Item, ours: int, theirs: Decimal) -> bool:
    """Whether a number of a list is the raw value, or the quantity that it stands for."""
    return theirs == ours or (item.value is not None and item.value.in_unit(ours) == theirs)


def _same_unit(ours: str, theirs: str) -> bool:
    return (known_unit(theirs) or theirs).replace(" ", "").casefold() == ours.replace(" ", "").casefold()
