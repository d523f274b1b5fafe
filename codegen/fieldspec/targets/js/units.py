"""Quantities: counts with a scale and a unit, and shares of a reference."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import lcm

from fieldspec.codec.layout.accepted import StatedNumbers, stated_numbers
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.foundation.names import Name
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import Digits, Octets, Real, Text, Truth, Whole
from fieldspec.language.model.enums import Bit
from fieldspec.language.model.value import Conversion, Sentinel, Value
from fieldspec.targets.js.declaration import Declaration, Names
from fieldspec.targets.js.text import PURE, comment, flag, literal, object_of, pairs_literal, runs_of
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
    divisor = lcm(scale.denominator, offset.denominator)
    numbers = {"factor": f"{scale * divisor}n", "shift": f"{offset * divisor}n", "divisor": f"{divisor}n"}
    return f"{PURE} unit({object_of({'unit': literal(value.unit)} | numbers | _limits(value, wide))})"


def _limits(value: Value, wide: bool) -> dict[str, str]:
    """The counts that stand for no quantity, those that may be written, and whether they are bigints."""
    ranges = value.writable_ranges
    intervals = ranges.intervals if ranges is not None else ((value.low, value.high),)
    absent = _counts(value.special_intervals, "n")
    return {"absent": absent, "ranges": pairs_literal(intervals, True), "wide": flag(wide)}


def _real_unit(value: Value) -> str:
    """The call that makes the `Unit` of a floating-point number that may stand for a state."""
    ranges = value.writable_ranges
    rows = {
        "unit": literal(value.unit),
        "absent": f"[{', '.join(_sentinel_number(value, sentinel) for sentinel in value.sentinels)}]",
        "ranges": "null" if ranges is None else pairs_literal(ranges.intervals, False),
        "size": str(value.size),
    }
    return f"{PURE} realUnit({object_of(rows)})"


def absent_of(device: Device, value: Value, trigger: bool = False) -> str:
    """The call that makes the `AbsentValues` of a value that is read; empty where it has no states."""
    stated = stated_numbers(device, value, trigger)
    if not value.sentinels and stated is None:
        return ""
    wide = is_wide(value.encoding)
    suffix = "n" if wide else ""
    rows = {s.name: f"{_sentinel_number(value, s)}{suffix}" for s in value.sentinels}
    lasts = {s.name: f"{s.last}{suffix}" for s in value.sentinels if s.last is not None}
    tables = [object_of({"__proto__": "null"} | rows)]
    tables += [object_of({"__proto__": "null"} | lasts)] if lasts or stated is not None else []
    tables += [_stated(stated, wide)] if stated is not None else []
    return f"{PURE} absentValues({', '.join(tables)})"


def _stated(stated: StatedNumbers, wide: bool) -> str:
    """The stated numbers without special values: `{ ranges: [[1, 10]], bits: [[0xen, [[0n, 10n]]]] }`"""
    bits = ", ".join(
        f"[{bit.mask:#x}n, {pairs_literal(bit.images, True)}{f', {runs_of(bit)}' * bool(bit.pieces)}]"
        for bit in stated.bits
    )
    ranges = {"ranges": pairs_literal(stated.intervals, wide)} if stated.intervals else {}
    return object_of(ranges | ({"bits": f"[{bits}]"} if bits else {}))


def _counts(intervals: Iterable[tuple[int, int]], suffix: str = "") -> str:
    """Counts, and intervals of counts, as a list: `[3n, [65024n, 65279n]]`"""
    texts = (f"{low}{suffix}" if low == high else f"[{low}{suffix}, {high}{suffix}]" for low, high in intervals)
    return f"[{', '.join(texts)}]"


def _sentinel_number(value: Value, sentinel: Sentinel) -> str:
    return "NaN" if sentinel.is_nan else str(sentinel.value)


def power_unit_of(value: Value, exponent: Value) -> str:
    """The call that makes the `PowerUnit` of a value, by the value with the exponent of its scale."""
    exponents = exponent.ranges.intervals if exponent.ranges is not None else ()
    rows = {
        "unit": literal(value.quantity_unit),
        "exponents": pairs_literal(exponents, False),
        "unknown": _counts(exponent.special_intervals),
    }
    return f"{PURE} powerUnit({object_of(rows | _limits(value, is_wide(value.encoding)))})"


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
    bounds = {"full": f"{conversion.full_scale}n", "complement": flag(conversion.complement)}
    row = object_of(bounds | {"low": f"{low}n", "high": f"{high}n"})
    code = [f"export const {name} = {PURE} conversion({row});", ""]
    paragraphs = [f"{conversion.title or Name.of(conversion.name).title()} = {formula}.", conversion.doc]
    if conversion.references:
        paragraphs.append(f"Reference: {', '.join(conversion.references)}.")
    return Declaration(code, [*comment(paragraphs), f"export declare const {name}: Conversion;", ""])
