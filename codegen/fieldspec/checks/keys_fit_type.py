"""A value has no key that means nothing for its type: members of enums, bits and constants are whole numbers; a
floating-point number is counted in its unit; texts and bytes have no order of bytes, no range and no scale.

Why: what no output can obey must not look as if it held. A reader would trust a limit or a name that no codec knows.

Example: `enum: mode` on an `f32`, or `byte_order: little` on a `text`.

Cure: Take the key away, or put the type right.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.facts import values
from fieldspec.checks.finding import finding, range_key
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.fact import Place
from fieldspec.model.value import Kind, Value

_NAMED = ("enum", "flags", "const")
_SCALED = ("scale", "offset")
_UNFIT = {
    Kind.FLOAT: (*_NAMED, *_SCALED),
    Kind.BOOLEAN: ("flags", *_SCALED, "sentinels"),
    Kind.TEXT: (*_NAMED, *_SCALED, "byte_order", "range", "sentinels", "unit"),
    Kind.BYTES: (*_NAMED, *_SCALED, "byte_order", "range", "sentinels", "unit"),
}
_HELP = {
    Kind.FLOAT: "take it away, or give the type of a whole number",
    Kind.BOOLEAN: "take it away, or give the type of a whole number",
    Kind.TEXT: "take it away; bytes follow each other as they are sent",
    Kind.BYTES: "take it away; bytes follow each other as they are sent",
}


def keys_fit_type(device: Device) -> Iterator[Diagnostic]:
    for fact, value in values(device):
        kind = value.type.kind
        for key in _UNFIT.get(kind, ()):
            if _has(value, key):
                text = f"{fact.name} is {value.type.name}, for which `{_key(fact.place, key)}` means nothing"
                yield finding("keys_fit_type", fact.place, _key(fact.place, key), text, _HELP[kind])
        if kind is Kind.INTEGER and value.absent_nan:
            text = f"{fact.name} is {value.type.name}, and the `bits` of a sentinel are those of an f32"
            yield finding("keys_fit_type", fact.place, "sentinels", text, "give the count under `value`")


def _key(place: Place, key: str) -> str:
    return range_key(place) if key == "range" else key


def _has(value: Value, key: str) -> bool:
    values = {
        "enum": value.enum,
        "flags": value.flags,
        "const": value.const is not None,
        "scale": value.scale != 1,
        "offset": value.offset,
        "byte_order": value.byte_order,
        "range": value.ranges is not None,
        "sentinels": value.sentinels,
        "unit": value.unit,
    }
    return bool(values[key])
