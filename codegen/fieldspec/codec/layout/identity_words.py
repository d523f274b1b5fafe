"""The words of a value for identities: each key that affects programs, without keys that equal their defaults."""

from __future__ import annotations

from decimal import Decimal

from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.model import codecs
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_exact
from fieldspec.language.model.ranges import Ranges, merged
from fieldspec.language.model.raw_numbers import orders_of
from fieldspec.language.model.value import ParameterPart, Sentinel, Value

if TYPE_CHECKING:
    from fractions import Fraction

Words = tuple[object, ...]


def _last(sentinel: Sentinel) -> Words:
    if sentinel.is_nan:
        return ("NaN",)
    return () if sentinel.last is None else (sentinel.last,)


_WORDS: ByIdentity[Value, Words] = ByIdentity(limit=20_000)
"""The words of values, which versions share, and most of them the next build too."""


def value_words(value: Value | None) -> Words:
    """All of a value, empty for none."""
    return _WORDS.get_or_compute(value, _value_words) if value is not None else ()


def _value_words(value: Value) -> Words:
    sentinels = sorted((sentinel.value, sentinel.name, *_last(sentinel)) for sentinel in value.sentinels)
    scaled = (shortest(value.scale), shortest(value.offset), value.unit)
    ranges, write_ranges = (
        bounding(own, value.low, value.high, int(is_exact(value.encoding)))
        for own in (value.ranges, value.write_ranges)
    )
    return (
        value.type.name,
        value.size,
        *scaled,
        ranges,
        value.const,
        value.enum,
        value.flags,
        sentinels,
        _part(value.parameter),
        *((write_ranges,) if value.write_ranges is not None and write_ranges != ranges else ()),
        *((value.digits, value.places) if value.digits else ()),
        *((value.codec, codecs.number_codec(value.codec).version) if value.codec else ()),
        *(("blanks",) if value.has_blanks else ()),
        *(("packed", value.packed_bits) if value.packed_bits else ()),
        *(("low first",) if value.is_low_first else ()),
        *((value.text_form,) if value.text_form is not None else ()),
        *(("turned",) if value.text_form is not None and value.text_form.is_turned else ()),
        *(("width", value.width) if value.width else ()),
        *(("characters", value.characters) if value.characters not in (None, value.size) else ()),
        *(("default", value.default) if value.default is not None else ()),
    )


def bounding(ranges: Ranges | None, low: int, high: int, step: int = 1) -> list[tuple[int, int]] | None:
    """The intervals of ranges that leave out a number; None where they have all that the wire can carry."""
    intervals = merged(ranges.intervals, step) if ranges is not None else [(low, high)]
    return None if intervals == [(low, high)] else intervals


def order_of(value: Value | None, order: str) -> str:
    """The order of the bytes of a value; empty where it has none, whatever is stated."""
    return order if value is None or value.has_order else ""


def shortest(number: Decimal | Fraction) -> Decimal | Fraction | str:
    """The digits of a number without zeros at the end."""
    return f"{number.normalize():f}" if isinstance(number, Decimal) else number


def _part(part: ParameterPart | None) -> str | None:
    """The part that a value has in an access to parameters: number, subindex or value."""
    if part is None:
        return None
    text = f"ParameterPart(set={part.set!r}, part={part.part!r}, number={part.number!r})"
    if part.sizes is None:
        return text
    return f"{text} by {part.sizes.by}: {[(case.bytes, case.when) for case in part.sizes.cases]}"


def orders_in(device: Device, value: Value) -> tuple[str, bool]:
    """The byte order of a value, and whether its words are swapped; always the same where it has no order."""
    return orders_of(value, device.byte_order, device.word_order) if value.has_order else ("big", False)
