"""The permitted values in both devices: of numbers, lengths of texts, repetitions, unit addresses and parameters."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from fieldspec.foundation.classes import dataclass
from fieldspec.language.changes.comparison import Comparison, Pair, ValuePair
from fieldspec.language.changes.descriptions import named
from fieldspec.language.model.encoding import is_exact
from fieldspec.language.model.enums import Bit, Flags
from fieldspec.language.model.link import Link
from fieldspec.language.model.primitives import Primitive
from fieldspec.language.model.ranges import Ranges, bound_text, merged, uncovered
from fieldspec.language.model.record import Field
from fieldspec.language.model.registers import ParameterSet
from fieldspec.language.model.value import Value


@dataclass(frozen=True, slots=True)
class BoundsPair:
    """Bounds in both devices. `what` says of what, `name` of which object; `key` is their key in the spec."""

    pair: Pair[Any] | ValuePair
    name: str
    what: str
    key: str
    old: Ranges
    new: Ranges


def bounds_pairs(comparison: Comparison) -> Iterator[BoundsPair]:
    """The bounds that differ. A type that differs brings its own bounds; these are not a further change."""
    for value_pair in comparison.values:
        name = named(value_pair.of.new)
        old, new = _of_values(value_pair)
        if old is not None and new is not None:
            yield BoundsPair(value_pair, name, "the range", "range", old, new)
        old, new = value_pair.old.writable_ranges, value_pair.new.writable_ranges
        if (
            (value_pair.old.write_ranges or value_pair.new.write_ranges)
            and (old or new)
            and value_pair.old.type == value_pair.new.type
        ):
            old, new = old or _all(value_pair.old), new or _all(value_pair.new)
            yield BoundsPair(value_pair, name, "the range of writing", "write_range", old, new)
        old, new = _length(value_pair.old), _length(value_pair.new)
        if old != new and value_pair.old.size == value_pair.new.size:
            yield BoundsPair(value_pair, name, "the number of characters", "characters", old, new)
    for field in comparison.of(Field):
        before, after = field.old.repeat, field.new.repeat
        if before is not None and after is not None:
            yield BoundsPair(field, named(field.new), "the number of elements", "repeat", before, after)
    for link in comparison.of(Link):
        before, after = (side.unit_addresses.ranges if side.unit_addresses else None for side in (link.old, link.new))
        if before is not None or after is not None:
            yield BoundsPair(link, named(link.new), "the unit address", "unit_addresses", before or ANY, after or ANY)
    for word in comparison.of(Flags):
        if word.old.type == word.new.type and (word.old.ranges is not None or word.new.ranges is not None):
            whole = _whole(word.new.type)
            before, after = word.old.ranges or whole, word.new.ranges or whole
            yield BoundsPair(word, named(word.new), "the range", "range", before, after)
    for bit in comparison.of(Bit):
        if bit.old.width == bit.new.width and bit.old.signed == bit.new.signed and (bit.old.ranges or bit.new.ranges):
            before, after = (side.as_value.ranges or NONE for side in (bit.old, bit.new))
            yield BoundsPair(bit, named(bit.new), "the range", "range", before, after)
    for numbered in comparison.of(ParameterSet):
        before, after = numbered.old.numbers or NONE, numbered.new.numbers or NONE
        yield BoundsPair(numbered, named(numbered.new), "the numbers that there are", "numbers", before, after)


NONE = Ranges(())
ANY = Ranges(((0, 0xFFFFFFFF),))
_ENDLESS: tuple[Any, Any] = (-math.inf, math.inf)


def _of_values(value_pair: ValuePair) -> tuple[Ranges | None, Ranges | None]:
    old, new = value_pair.old, value_pair.new
    if old.ranges is None and new.ranges is None:
        return None, None
    if not (is_exact(old.encoding) and is_exact(new.encoding)):
        return old.ranges or Ranges((_ENDLESS,)), new.ranges or Ranges((_ENDLESS,))
    if old.type != new.type and (old.ranges is None or new.ranges is None):
        return None, None
    return old.ranges or _all(old), new.ranges or _all(new)


def _all(value: Value) -> Ranges:
    """All numbers of a value."""
    return Ranges(((value.low, value.high),))


def _whole(primitive: Primitive) -> Ranges:
    """All numbers of a type."""
    return Ranges(((primitive.low, primitive.high),))


def _length(value: Value) -> Ranges:
    return Ranges(((0, value.size if value.characters is None else value.characters),))


def without(ranges: Ranges, excluded: Ranges) -> Ranges:
    """The numbers of some intervals that are in none of the others, in order."""
    ends = (end for interval in (*ranges.intervals, *excluded.intervals) for end in interval)
    step = 0 if any(isinstance(end, float) for end in ends) else 1
    merged_others = merged(excluded.intervals, step)
    rest = [part for low, high in sorted(ranges.intervals) for part in uncovered(low, high, merged_others, step)]
    return Ranges(tuple(dict.fromkeys(rest)))


def text(ranges: Ranges) -> str:
    """The text of intervals as the spec writes them."""
    if ranges == ANY or _ENDLESS in ranges.intervals:
        return "anything"
    return ", ".join(_text(low, high) for low, high in ranges.intervals)


def _text(low: int, high: int) -> str:
    """One interval, which may have no end below or above."""
    if math.isinf(low):
        return f"less than {bound_text(high)}"
    return f"more than {bound_text(low)}" if math.isinf(high) else Ranges(((low, high),)).text()
