"""Signals and conversions."""

from __future__ import annotations

from fieldspec.model.primitive import PRIMITIVES
from fieldspec.model.signal import Conversion, Signal
from fieldspec.reading.building.context import Entry
from fieldspec.reading.building.values import value


def signal(entry: Entry) -> Signal:
    """A value that is placed by name."""
    return Signal(**entry.fact(), value=value(entry), direction=entry.text("direction"))


def conversion(entry: Entry, types: dict[str, str]) -> Conversion:
    """A conversion; `types` are those of the signals by name."""
    signals = entry.texts("signals")
    name = entry.text("type") or next((types[one] for one in signals if one in types), "")
    if name not in PRIMITIVES:
        entry.refuse("type_given", "type", "nothing says how the count lies on the wire", "give it a `type`")
    return Conversion(
        **entry.fact(),
        title=entry.text("title"),
        signals=signals,
        type=PRIMITIVES.get(name, PRIMITIVES["i32"]),
        full_scale=entry.integer("full_scale") or 1,
        complement=entry.flag("complement"),
        references=entry.texts("references"),
        printed=entry.text("printed"),
    )
