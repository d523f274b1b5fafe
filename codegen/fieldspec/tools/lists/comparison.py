"""Compares a device with a list: what agrees, what differs, and what only one of them has."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Callable, Collection, Iterator, Sequence
from decimal import Decimal
from fractions import Fraction

from fieldspec.foundation.classes import dataclass
from fieldspec.tools.lists.addresses import BASES
from fieldspec.tools.lists.assumption import Refusal
from fieldspec.tools.lists.halves import with_halves_joined
from fieldspec.tools.lists.item import MESSAGES, REGISTERS, Item
from fieldspec.tools.lists.listing import Listing, moved
from fieldspec.tools.lists.quantities import known_unit
from fieldspec.tools.lists.row_reading import REGISTER, ListRow
from fieldspec.tools.lists.sheet import ListError
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
"""What is compared if both state it."""

_OFFSETS = (0, 1, -1)
_ENOUGH = 0.25

Place = tuple[str, int]

_POWER = re.compile(r"10\s*(\^|\*\*)")


@dataclass(frozen=True, slots=True)
class Difference:
    """An aspect in which the device and the list differ, as each writes it."""

    aspect: str
    ours: str
    theirs: str


@dataclass(frozen=True, slots=True)
class Pair:
    """An item and the row about it, with their differences."""

    item: Item
    row: ListRow
    differences: tuple[Difference, ...]


@dataclass(frozen=True, slots=True)
class Missing:
    """An item that the list does not have, or its elements with the numbers from `first` to `last`."""

    item: Item
    first: int
    last: int

    @property
    def address(self) -> int:
        """The first address that is missing."""
        return self.item.address + (self.first - self.item.first) * self.item.stride


@dataclass(frozen=True, slots=True)
class Extra:
    """A row that the device does not have. `remark` says what the device has there, if anything."""

    row: ListRow
    remark: str


@dataclass(frozen=True, slots=True)
class Compared:
    """The result. The addresses of the list are higher by `offset`; `guessed` if the user has not said so.

    `unreadable` are the rows and cells of the list that could not be compared.
    """

    base: str
    offset: int
    guessed: bool
    pairs: tuple[Pair, ...]
    extras: tuple[Extra, ...]
    missing: tuple[Missing, ...]
    unreadable: tuple[Refusal, ...] = ()

    @property
    def agreeing(self) -> list[Pair]:
        """The pairs without differences."""
        return [pair for pair in self.pairs if not pair.differences]

    @property
    def differing(self) -> list[Pair]:
        """The pairs with differences."""
        return [pair for pair in self.pairs if pair.differences]

    @property
    def shifted(self) -> bool:
        """Whether all addresses of the list are shifted, and the user has not said so."""
        return self.guessed and self.offset != 0

    @property
    def same(self) -> bool:
        """Whether the device and the list agree in everything."""
        return not (self.shifted or self.differing or self.extras or self.missing or self.unreadable)


def has_messages(register_list: Listing) -> bool:
    """Whether a list is an export with fields of messages, with which those of the device are compared."""
    return register_list.own and any(row.space == MESSAGES for row in register_list.read)


class _Known:
    """The items by the address of each element, and by every further word."""

    def __init__(self, items: Sequence[Item]) -> None:
        self.spaces = {folded(item.space): item.space for item in items}
        self.starts: dict[Place, list[Item]] = defaultdict(list)
        self.inside: dict[Place, Item] = {}
        for item in items:
            for address in item.addresses():
                self.starts[item.space, address].append(item)
                for word in range(1, item.words or 1):
                    self.inside[item.space, address + word] = item

    def space(self, row: ListRow) -> str:
        """The space of a row: the one that it names or that its list shows, else the registers, else the first one."""
        for space_name in (row.texts.get("space", ""), row.space):
            if (known := folded(space_name)) in self.spaces:
                return self.spaces[known]
        if row.kind != REGISTER:
            return row.space
        return self.spaces.get(REGISTERS) or next(iter(self.spaces.values()), REGISTERS)

    def at(self, row: ListRow) -> Sequence[Item]:
        """The items that begin at the address of a row, with its subindices."""
        candidates = self.starts.get((self.space(row), row.address), ())
        return [item for item in candidates if item.subindices == row.subindices]


def compared(
    items: Sequence[Item], listing: Listing, offset: int | None = None, ignored: Collection[str] = ()
) -> Compared:
    """Compares a device with a list. Without `offset`, an offset of 1 of the whole list is recognised.

    Raises ListError for a list of which no row can be read.
    """
    known = _Known(items)
    aspects = [aspect for aspect in ASPECTS if aspect not in ignored]
    ways = [
        (base, shift, list(moved(rows, shift)))
        for shift in ((offset,) if offset is not None else _OFFSETS)
        for base in sorted(listing.bases, key=lambda base: listing.bases.index(base))
        for rows in _with_halves(listing.rows(base))
    ]
    base, best, rows = _likeliest(known, ways, aspects)
    assert base in BASES
    pairs, extras, covered = _paired(known, rows, aspects)
    missing = tuple(gap for item in items for gap in _gaps(item, covered[id(item)]))
    unreadable = (*listing.refused, *listing.numbered(base)[1])
    if not rows:
        raise ListError(f"has no row that can be compared: {unreadable[0].text()}")
    return Compared(base, best, offset is None, tuple(pairs), tuple(extras), missing, unreadable)


def _with_halves(rows: list[ListRow]) -> Iterator[list[ListRow]]:
    """The rows, and those with the two words of a value as one, where the list has such rows."""
    yield rows
    joined = with_halves_joined(rows, [])
    if len(joined) < len(rows):
        yield joined


def _likeliest(
    known: _Known, ways: Sequence[tuple[str, int, list[ListRow]]], aspects: Collection[str]
) -> tuple[str, int, list[ListRow]]:
    """The way to read addresses with which most rows fit. An offset must explain clearly more than none."""
    best, best_total = ways[0], -1.0
    for reading in ways:
        rows = reading[2]
        fits = [max((_fit(item, row, aspects) for item in known.at(row)), default=0.0) for row in rows]
        total = sum(fits)
        if reading[1] == best[1] or best_total < 0:
            better = total > best_total
        else:
            better = total > best_total and (all(fits) or total - best_total >= _ENOUGH * len(rows))
        if better:
            best, best_total = reading, total
    return best


def _fit(item: Item, row: ListRow, aspects: Collection[str]) -> float:
    """How well a row fits an item: 1 for the address, more for the name, less for differences."""
    names = "name" in aspects and _names(item, row) & {folded(name) for name in row.names}
    wrong = sum(difference.aspect in ("type", "access", "words") for difference in _differences(item, row, aspects))
    return max(1 + (3 if names else 0) - 0.2 * wrong, 0.1)


def _paired(
    known: _Known, rows: Sequence[ListRow], aspects: Collection[str]
) -> tuple[list[Pair], list[Extra], dict[int, set[int]]]:
    pairs: list[Pair] = []
    extras: list[Extra] = []
    covered: dict[int, set[int]] = defaultdict(set)
    paired_rows: dict[tuple[int, int], int] = {}
    for row in rows:
        candidates = known.at(row)
        if row.bits is not None and (holder := next((candidate for candidate in candidates if candidate.bits), None)):
            covered[id(holder)].add(0)
            pairs.append(Pair(holder, row, tuple(_bit_differences(holder, row)) if "bits" in aspects else ()))
            continue
        if not candidates:
            holder = known.inside.get((known.space(row), row.address))
            extras.append(Extra(row, f"inside {holder.name}" if holder else ""))
            continue
        fresh = [item for item in candidates if (id(item), row.address) not in paired_rows]
        item = max(fresh or candidates, key=lambda item: _fit(item, row, aspects))
        if not fresh:
            extras.append(Extra(row, f"listed before in row {paired_rows[id(item), row.address]}"))
            continue
        paired_rows[id(item), row.address] = row.row
        first = (row.address - item.address) // item.stride if item.stride else 0
        covered[id(item)].update(range(first, min(first + row.count, item.count) if item.stride else item.count))
        following = _following_items(known, item, row)
        for next_item in following:
            covered[id(next_item)].add(0)
        differences = _differences(item, row, aspects)
        whole = len(following) == row.count - 1 > 0
        pairs.append(
            Pair(
                item,
                row,
                tuple(difference for difference in differences if not (whole and difference.aspect == "count")),
            )
        )
    return pairs, extras, covered


def _following_items(known: _Known, item: Item, row: ListRow) -> list[Item]:
    """The further items that a row with a count stands for, which are equal registers."""
    step = row.stride or row.words or item.words or 1
    if item.count > 1:
        return []
    places = ((item.space, row.address + number * step) for number in range(1, min(row.count, len(known.starts) + 1)))
    items = [other for place in places for other in known.starts.get(place, ())[:1]]
    return [other for other in items if (other.type, other.words) == (item.type, item.words)]


def _gaps(item: Item, covered: Collection[int]) -> Iterator[Missing]:
    """The runs of elements of an item that no row is about."""
    start: int | None = None
    for number in range(item.count + 1):
        absent = number < item.count and number not in covered
        if absent and start is None:
            start = number
        elif not absent and start is not None:
            yield Missing(item, item.first + start, item.first + number - 1)
            start = None


def _names(item: Item, row: ListRow) -> set[str]:
    """The names of an item; of a field of a table, with the number of the element at the address of a row too."""
    table, _, name = item.name.rpartition(".")
    number = item.first + (row.address - item.address) // item.stride if item.stride else item.first
    names = (item.name, name, item.printed_name, item.label, f"{table}{number}{name}")
    return {folded(name) for name in names} - {""}


def _differences(item: Item, row: ListRow, aspects: Collection[str]) -> Iterator[Difference]:
    texts, value = row.texts, item.value
    yield from _unread(item, row, aspects)
    if "name" in aspects and row.names and _names(item, row).isdisjoint(map(folded, row.names)):
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
    """The cells that were not understood: nobody knows whether they agree."""
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


def _bit_differences(item: Item, row: ListRow) -> Iterator[Difference]:
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
