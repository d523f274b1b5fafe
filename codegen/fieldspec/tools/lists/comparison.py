"""Compares a device with a list: what agrees, what differs, and what only one of them has."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterator, Sequence

from fieldspec.foundation.classes import dataclass
from fieldspec.tools.lists.addresses import BASES
from fieldspec.tools.lists.assumption import Refusal
from fieldspec.tools.lists.differences import ASPECTS, Difference, bit_differences, differences, names_of
from fieldspec.tools.lists.halves import with_halves_joined
from fieldspec.tools.lists.item import MESSAGES, REGISTERS, Item
from fieldspec.tools.lists.listing import Listing
from fieldspec.tools.lists.row_reading import REGISTER, ListRow, moved
from fieldspec.tools.lists.sheet import ListError
from fieldspec.tools.lists.words import folded

_OFFSETS = (0, 1, -1)
_ENOUGH = 0.25

Place = tuple[str, int]


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
    """Whether a list is an export with fields of messages, with which the fields of the device are compared."""
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
    names = "name" in aspects and names_of(item, row) & {folded(name) for name in row.names}
    wrong = sum(difference.aspect in ("type", "access", "words") for difference in differences(item, row, aspects))
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
            pairs.append(Pair(holder, row, tuple(bit_differences(holder, row)) if "bits" in aspects else ()))
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
        difference_list = list(differences(item, row, aspects))
        whole = len(following) == row.count - 1 > 0
        pairs.append(
            Pair(
                item,
                row,
                tuple(difference for difference in difference_list if not (whole and difference.aspect == "count")),
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
