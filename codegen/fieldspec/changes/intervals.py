"""The values that may be, on both sides: of numbers, of texts, and of how often something is repeated."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from fieldspec.changes.comparing import Comparison, Pair, Values
from fieldspec.changes.finding import named
from fieldspec.classes import dataclass
from fieldspec.model.enums import Flags
from fieldspec.model.link import Link
from fieldspec.model.record import Field
from fieldspec.model.registers import ParameterSet
from fieldspec.model.value import Kind, Primitive, Ranges, Value, merged, uncovered


@dataclass(frozen=True, slots=True)
class Bounded:
    """Something with bounds on both sides. `key` is where the spec has them."""

    pair: Pair[Any] | Values
    name: str
    what: str
    key: str
    old: Ranges
    new: Ranges


def bounded(both: Comparison) -> Iterator[Bounded]:
    """Everything whose bounds differ. Where a type differs, its own bounds are no further change."""
    for held in both.values:
        name = named(held.of.new)
        old, new = _of_values(held)
        if old is not None and new is not None:
            yield Bounded(held, name, "the range", "range", old, new)
        old, new = held.old.writable_ranges, held.new.writable_ranges
        if (held.old.write_ranges or held.new.write_ranges) and (old or new) and held.old.type == held.new.type:
            whole = _whole(held.new.type)
            yield Bounded(held, name, "the range of writing", "write_range", old or whole, new or whole)
        old, new = _length(held.old), _length(held.new)
        if old != new and held.old.size == held.new.size:
            yield Bounded(held, name, "the number of characters", "characters", old, new)
    for field in both.of(Field):
        before, after = field.old.repeat, field.new.repeat
        if before is not None and after is not None:
            yield Bounded(field, named(field.new), "the number of elements", "repeat", before, after)
    for link in both.of(Link):
        before, after = (side.unit_addresses.ranges if side.unit_addresses else None for side in (link.old, link.new))
        if before is not None or after is not None:
            what = "the address of a station"
            yield Bounded(link, named(link.new), what, "unit_addresses", before or ANY, after or ANY)
    for word in both.of(Flags):
        if word.old.type == word.new.type and (word.old.ranges is not None or word.new.ranges is not None):
            whole = _whole(word.new.type)
            before, after = word.old.ranges or whole, word.new.ranges or whole
            yield Bounded(word, named(word.new), "the range", "range", before, after)
    for numbered in both.of(ParameterSet):
        before, after = numbered.old.numbers or NONE, numbered.new.numbers or NONE
        yield Bounded(numbered, named(numbered.new), "the numbers that there are", "numbers", before, after)


NONE = Ranges(())
ANY = Ranges(((0, 0xFFFFFFFF),))


def _of_values(held: Values) -> tuple[Ranges | None, Ranges | None]:
    old, new = held.old, held.new
    if old.ranges is None and new.ranges is None:
        return None, None
    if old.type.kind not in _COUNT_TYPES or new.type.kind not in _COUNT_TYPES:
        return old.ranges, new.ranges
    if old.type != new.type and (old.ranges is None or new.ranges is None):
        return None, None
    return old.ranges or _whole(old.type), new.ranges or _whole(new.type)


_COUNT_TYPES = (Kind.INTEGER, Kind.BOOLEAN)


def _whole(primitive: Primitive) -> Ranges:
    """All numbers that a type holds."""
    return Ranges(((primitive.low, primitive.high),))


def _length(value: Value) -> Ranges:
    return Ranges(((0, value.size if value.characters is None else value.characters),))


def without(some: Ranges, others: Ranges) -> Ranges:
    """The numbers of some intervals that lie in none of the others, in order."""
    taken = merged(others.intervals)
    holes = (hole for low, high in sorted(some.intervals) for hole in uncovered(low, high, taken))
    return Ranges(tuple(dict.fromkeys(holes)))


def text(ranges: Ranges) -> str:
    """The intervals as the spec writes them."""
    return "anything" if ranges == ANY else ranges.text()
