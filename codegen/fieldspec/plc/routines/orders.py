"""The order of words and bytes, in names of routines and in comments."""

from __future__ import annotations

from collections.abc import Iterable

from fieldspec.layout.device import DeviceLayout
from fieldspec.model.primitive import Kind
from fieldspec.plc.routines.values import Wire

_FIRST = {True: "high_word_first", False: "low_word_first"}


def word_order(wires: Iterable[Wire]) -> str:
    """`high_word_first` or `low_word_first` where values of several words have that order; else empty."""
    found = {
        _FIRST[(wire.order == "big") != wire.swapped]
        for wire in wires
        if wire.kind in (Kind.INTEGER, Kind.FLOAT) and wire.value.size > 2
    }
    return found.pop() if len(found) == 1 else "both_word_orders" if found else ""


def order_remark(layout: DeviceLayout, unit: str, needed: bool = True) -> str:
    """What a comment says of the order in which a value lies in its bytes or words; nothing where none has several."""
    if not needed:
        return ""
    device = layout.device
    byte = "high" if device.byte_order == "big" else "low"
    word = "high" if device.word_order == "big" else "low"
    if unit == "bytes":
        return f"Of several bytes, the {byte} one comes first on the wire."
    return f"Of several words, the {word} one comes first; a word is a number, whatever the order of bytes in memory."
