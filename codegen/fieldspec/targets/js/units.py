"""Quantities: counts with a scale and a unit, and shares of a reference."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from fieldspec.codec.layout.accepted import StatedNumbers, stated_numbers
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.foundation.names import Name
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import Digits, Octets, Real, Text, Truth, Whole
from fieldspec.language.model.enums import Bit
from fieldspec.language.model.value import Conversion, Sentinel, Value
from fieldspec.targets.js.declaration import Declaration, Names
from fieldspec.targets.js.text import comment, flag, literal, runs_of
from fieldspec.targets.runtime_values import is_wide

POWER_UNIT = 'import("../runtime/index.js").PowerUnit'
"""The type of units with an exponent, which few modules need."""

ABSENT_VALUES = 'import("../runtime/index.js").AbsentValues'
"""The type of the states of a value that is read."""


def unit_of(value: Value) -> str:
    """The call that makes the `Unit` of a value; empty where its counts have neither scale nor unit."""
    encoding = value.encoding
    match encoding:
        case Real():
            return _real_unit(value) if value.sentinels else ""
        case Whole() | Digits():
            return "" if value.flags or value.enum else _count_unit(value, is_wide(encoding))
        case Truth() | Text() | Octets():
            return ""
        case _:
            assert_never(encoding)


def unit_of_bits(bit: Bit) -> str:
    """The same for a field of bits of a word, whose number is never a bigint."""
    return "" if bit.enum else _count_unit(bit.as_value, False)


def _count_unit(value: Value, wide: bool) -> str:
    if not (value.unit or value.scaled):
        return ""
    scale, offset = Fraction(value.scale), Fraction(value.offset)
    divisor = scale.denominator * offset.denominator // _common(scale.denominator, offset.denominator)
    ranges = value.writable_ranges
    intervals = ranges.intervals if ranges is not None else ((value.type.low, value.type.high),)
    rows = [
        f"unit: {literal(value.unit)}",
        f"factor: {scale * divisor}n",
        f"shift: {offset * divisor}n",
        f"divisor: {divisor}n",
        f"absent: {_counts(value.special_intervals, 'n')}",
        f"ranges: [{', '.join(f'[{low}n, {high}n]' for low, high in intervals)}]",
        f"wide: {flag(wide)}",
    ]
    return f"/* @__PURE__ */ unit({{ {', '.join(rows)} }})"


def _real_unit(value: Value) -> str:
    """The call that makes the `Unit` of a floating-point number that may stand for a state."""
    ranges = value.writable_ranges
    rows = [
        f"unit: {literal(value.unit)}",
        f"absent: [{', '.join(_sentinel_number(value, sentinel) for sentinel in value.sentinels)}]",
        f"ranges: {'null' if ranges is None else [list(interval) for interval in ranges.intervals]}",
        f"size: {value.size}",
    ]
    return f"/* @__PURE__ */ realUnit({{ {', '.join(rows)} }})"


def absent_of(device: Device, value: Value, trigger: bool = False) -> str:
    """The call that makes the `AbsentValues` of a value that is read; empty where it has no states."""
    stated = stated_numbers(device, value, trigger)
    if not value.sentinels and stated is None:
        return ""
    wide = is_wide(value.encoding)
    suffix = "n" if wide else ""
    rows = [f"{s.name}: {_sentinel_number(value, s)}{suffix}" for s in value.sentinels]
    lasts = [f"{s.name}: {s.last}{suffix}" for s in value.sentinels if s.last is not None]
    tables = [f"{{ {', '.join(['__proto__: null', *rows])} }}"]
    tables += [f"{{ {', '.join(['__proto__: null', *lasts])} }}"] if lasts or stated is not None else []
    tables += [_stated(stated, suffix)] if stated is not None else []
    return f"/* @__PURE__ */ absentValues({', '.join(tables)})"


def _stated(stated: StatedNumbers, suffix: str) -> str:
    """The stated numbers without special values: `{ ranges: [[1, 10]], bits: [[0xen, [[0n, 10n]]]] }`"""
    ranges = ", ".join(f"[{low}{suffix}, {high}{suffix}]" for low, high in stated.intervals)
    images = ((bit, ", ".join(f"[{low}n, {high}n]" for low, high in bit.images)) for bit in stated.bits)
    bits = ", ".join(
        f"[{bit.mask:#x}n, [{intervals}]{f', {runs_of(bit)}' if bit.pieces else ''}]" for bit, intervals in images
    )
    parts = [*([f"ranges: [{ranges}]"] * bool(ranges)), *([f"bits: [{bits}]"] * bool(bits))]
    return f"{{ {', '.join(parts)} }}"


def _counts(intervals: Iterable[tuple[int, int]], suffix: str = "") -> str:
    """Counts, and intervals of counts, as a list: `[3n, [65024n, 65279n]]`"""
    texts = (f"{low}{suffix}" if low == high else f"[{low}{suffix}, {high}{suffix}]" for low, high in intervals)
    return f"[{', '.join(texts)}]"


def _sentinel_number(value: Value, sentinel: Sentinel) -> str:
    return "NaN" if sentinel.is_nan else str(sentinel.value)


def power_unit_of(value: Value, exponent: Value) -> str:
    """The call that makes the `PowerUnit` of a value, by the value with the exponent of its scale."""
    ranges = value.writable_ranges
    intervals = ranges.intervals if ranges is not None else ((value.low, value.high),)
    exponents = exponent.ranges.intervals if exponent.ranges is not None else ()
    rows = [
        f"unit: {literal(value.quantity_unit)}",
        f"exponents: [{', '.join(f'[{low}, {high}]' for low, high in exponents)}]",
        f"unknown: {_counts(exponent.special_intervals)}",
        f"absent: {_counts(value.special_intervals, 'n')}",
        f"ranges: [{', '.join(f'[{low}n, {high}n]' for low, high in intervals)}]",
        f"wide: {flag(is_wide(value.encoding))}",
    ]
    return f"/* @__PURE__ */ powerUnit({{ {', '.join(rows)} }})"


def _common(first: int, second: int) -> int:
    while second:
        first, second = second, first % second
    return first


def declare_conversion(conversion: Conversion, names: Names) -> Declaration:
    """The object with the two directions of a conversion."""
    name = names.scope.take(Name.of(conversion.name).camel(), f"{Name.of(conversion.name).camel()}Conversion")
    device = names.layout.device
    ranges = [device.signals[signal].value.ranges for signal in conversion.signals if signal in device.signals]
    low, high = conversion.type.low, conversion.type.high
    known = [intervals for intervals in ranges if intervals is not None]
    if known and len(known) == len(ranges):
        low, high = max(low, min(r.low for r in known)), min(high, max(r.high for r in known))
    share = f"raw / {conversion.full_scale}"
    formula = f"reference * (1 - {share})" if conversion.complement else f"reference * {share}"
    code = [
        f"export const {name} = /* @__PURE__ */ conversion({{ full: {conversion.full_scale}n,"
        f" complement: {'true' if conversion.complement else 'false'}, low: {low}n, high: {high}n }});",
        "",
    ]
    paragraphs = [f"{conversion.title or Name.of(conversion.name).title()} = {formula}.", conversion.doc]
    if conversion.references:
        paragraphs.append(f"Reference: {', '.join(conversion.references)}.")
    return Declaration(code, [*comment(paragraphs), f"export declare const {name}: Conversion;", ""])
