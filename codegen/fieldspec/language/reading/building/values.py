"""Builds values, signals and conversions."""

from __future__ import annotations

from decimal import Context, Decimal
from math import ceil, floor

from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.model.digits import CODEC
from fieldspec.language.model.encoding import is_array, is_real, is_signed, is_text
from fieldspec.language.model.fact import ScalarValue
from fieldspec.language.model.primitives import PRIMITIVES, Primitive
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.text_form import text_form
from fieldspec.language.model.value import (
    Conversion,
    ParameterPart,
    ParameterSizes,
    Sentinel,
    Signal,
    SizeCase,
    Value,
    exact_scale,
    power_of_ten,
)
from fieldspec.language.reading.building.codecs import number_codec_name
from fieldspec.language.reading.building.context import Entry
from fieldspec.language.schema import schema

if TYPE_CHECKING:
    from fractions import Fraction

UNTYPED = PRIMITIVES["u16"]

_ZERO, _UNITY = Decimal(0), Decimal(1)

_EXACT = Context(prec=120)

VALUE_KEYS = frozenset(schema()["$defs"]["value"]["properties"])
"""The keys for the encoding of a value and its meaning."""


def value(entry: Entry, type_name: str = "") -> Value:
    """The value that an entry describes. A missing type is a finding; the value is then a `u16`."""
    codec = number_codec_name(entry)
    digits = CODEC if codec else entry.text("digits")
    primitive = PRIMITIVES.get(entry.text("type") or type_name)
    if primitive is None:
        entry.refuse("type_present", "type", "this value has no type", "add a `type`")
        primitive = UNTYPED
    scale = scale_of(entry)
    offset = entry.decimal("offset") or _ZERO
    scale = scale if scale is not None else _UNITY
    part = entry.entry("parameter")
    scale_by, unit = entry.text("scale_by"), entry.text("unit")
    for key in ("unit_range", "unit_default") if scale_by else ():
        if entry.value(key) is not None:
            text = f"a quantity depends on what the device has in {scale_by}"
            entry.refuse("wrong_form", key, text, f"state `{key.removeprefix('unit_')}`, in counts")
    size = _size(entry, primitive, digits)
    varies = entry.flag("varies")
    return entry.built(
        Value,
        type=primitive,
        size=size + (varies and is_signed(primitive.encoding) and digits == "decimal"),
        scale=scale,
        scale_text=scale_text(entry.value("scale")),
        offset=offset,
        unit=f"{power_of_ten(scale_by)} {unit}".rstrip() if scale_by else unit,
        ranges=_real_ranges(entry) if is_real(primitive.encoding) else counts_of(entry, scale, offset),
        default=default_of(entry, scale, offset),
        parameter=_parameter_part(part) if part else None,
        sentinels=tuple(_sentinel(inner) for inner in entry.entries("sentinels")),
        write_ranges=entry.whole_ranges("write_range"),
        digits=digits,
        scale_by=scale_by,
        text_form=text_form(
            entry.text("encoding"),
            entry.text("padding"),
            entry.text("align"),
            entry.integer("terminator"),
            entry.text("byte_order"),
        )
        if is_text(primitive.encoding)
        else None,
        width=size if varies else 0,
        codec=codec,
        has_blanks=digits == "decimal" and entry.text("padding") == "space" and not varies,
    )


def _parameter_part(entry: Entry) -> ParameterPart:
    sizes = entry.entry("sizes")
    return entry.built(
        ParameterPart,
        sizes=ParameterSizes(
            sizes.text("by"),
            tuple(SizeCase(case.texts("when"), case.integer("bytes") or 0) for case in sizes.entries("cases")),
        )
        if sizes
        else None,
    )


def _sentinel(entry: Entry) -> Sentinel:
    bits, number, ranges = entry.integer("bits"), entry.integer("value"), entry.whole_ranges("range")
    stated = [key for key, of_key in (("value", number), ("bits", bits), ("range", ranges)) if of_key is not None]
    if len(stated) != 1:
        key = stated[0] if stated else "name"
        text = "a special value has either a `value`, a `range` or `bits`"
        entry.refuse("missing_key", key, text, "use one of them")
    if ranges is not None and len(ranges.intervals) > 1:
        text = "a special value has one interval"
        entry.refuse("wrong_form", "range", text, "state each interval as a special value with a name of its own")
    low, high = ranges.intervals[0] if ranges is not None and number is None else (number or 0, None)
    is_nan = bits is not None and number is None and ranges is None
    value = bits if bits is not None and is_nan else low
    last = None if high == value else high
    return entry.built(Sentinel, value=value, is_nan=is_nan, last=last)


def scale_of(entry: Entry) -> Decimal | Fraction | None:
    """The scale as an exact number; an invalid fraction, and 0, are findings."""
    text = entry.value("scale")
    scale = exact_scale(text) if isinstance(text, str) else entry.decimal("scale")
    if scale == 0:
        entry.refuse("wrong_value", "scale", "a scale of 0 makes all values equal", "state the quantity of one count")
        return None
    if scale is None and isinstance(text, str):
        help = "use a divisor other than 0, and numbers of at most 18 digits"
        entry.refuse("wrong_form", "scale", f"`{text}` is not an exact number", help)
    return scale


def scale_text(scale: ScalarValue) -> str:
    """A scale as the spec writes it; empty where it has none."""
    if isinstance(scale, Decimal):
        return f"{scale:f}"
    return "" if scale is None else str(scale)


def _size(entry: Entry, primitive: Primitive, digits: str) -> int:
    if not is_array(primitive.encoding) and not digits:
        return primitive.size
    length = entry.integer("length")
    if length is None:
        text = f"`type: {primitive.name}` {'with `digits` ' if digits else ''}has no fixed size"
        entry.refuse("type_present", "type", text, "add its `length` in bytes")
        return 2
    return length


def _states_in_unit(entry: Entry, key: str) -> bool:
    """Whether a value states the key in its unit; what it states itself comes before the defaults of its group."""
    in_unit = f"unit_{key}"
    if key in entry.own and in_unit in entry.own:
        text = f"`{key}` has no effect beside `{in_unit}`"
        entry.refuse("wrong_form", key, text, "state one of them; what the manual prints again goes under `restated`")
    return in_unit in entry.own or (key not in entry.own and entry.value(in_unit) is not None)


def _real_ranges(entry: Entry) -> Ranges | None:
    """The range of a floating-point number, which is in its unit."""
    return entry.real_ranges("unit_range" if _states_in_unit(entry, "range") else "range")


def counts_of(entry: Entry, scale: Decimal | Fraction, offset: Decimal) -> Ranges | None:
    """The range in counts, which the entry states in counts or in the unit."""
    in_unit = entry.ranges("unit_range") if _states_in_unit(entry, "range") else None
    if in_unit is None:
        return entry.whole_ranges("range")
    from fractions import Fraction

    counts = []
    for bounds in in_unit:
        if bounds[0] > bounds[1]:
            entry.refuse("wrong_form", "unit_range", "an interval ends before it starts", "write the lower bound first")
        raw = [(Fraction(bound) - Fraction(offset)) / Fraction(scale) for bound in bounds]
        for bound, count in zip(dict.fromkeys(bounds), raw, strict=False):
            if count.denominator != 1:
                text = f"{bound:f} is not a whole number of counts"
                entry.refuse("wrong_form", "unit_range", text, _nearest("unit_range", count, scale, offset))
        low, high = sorted(raw)
        counts.append((int(low), int(high)))
    return Ranges(tuple(sorted(counts)))


def default_of(entry: Entry, scale: Decimal | Fraction, offset: Decimal) -> int | str | None:
    """The default in counts, which the entry states in counts or in the unit; a text for a text."""
    in_unit = entry.decimal("unit_default") if _states_in_unit(entry, "default") else None
    if in_unit is None:
        default = entry.value("default")
        return default if isinstance(default, int | str) else None
    from fractions import Fraction

    raw = (Fraction(in_unit) - Fraction(offset)) / Fraction(scale)
    if raw.denominator != 1:
        text = f"{in_unit:f} is not a whole number of counts"
        entry.refuse("wrong_form", "unit_default", text, _nearest("unit_default", raw, scale, offset))
    return int(raw)


def _nearest(key: str, count: Fraction, scale: Decimal | Fraction, offset: Decimal) -> str:
    """The help for a quantity between two counts: the quantities of these, where they are decimal numbers."""
    if not isinstance(scale, Decimal):
        return f"state `{key.removeprefix('unit_')}`, in counts, or compare it with `scale`"
    quantities = sorted(
        _EXACT.add(_EXACT.multiply(Decimal(whole), scale), offset) for whole in (floor(count), ceil(count))
    )
    return (
        f"write {' or '.join(f'{quantity.normalize(_EXACT):f}' for quantity in quantities)}, or compare it with `scale`"
    )


def signal(entry: Entry) -> Signal:
    """The signal, a value that is placed by its name, that an entry states."""
    return entry.built(Signal, value=value(entry))


def conversion(entry: Entry, types: dict[str, str]) -> Conversion:
    """A conversion; `types` are the types of the signals by name."""
    signals = entry.texts("signals")
    name = entry.text("type") or next((types[signal] for signal in signals if signal in types), "")
    if name not in PRIMITIVES:
        entry.refuse("type_present", "type", "the count has no type", "add a `type`")
    return entry.built(
        Conversion,
        signals=signals,
        type=PRIMITIVES.get(name, PRIMITIVES["i32"]),
        full_scale=entry.integer("full_scale") or 1,
    )
