"""Signals that are sent as digits, which functions for programmable controllers do not convert."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import replace
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.language.model.value import Value


def without_digits(layout: DeviceLayout) -> DeviceLayout:
    """The layout without the digits of signals: bytes hold them, and other facts about them are left out."""
    if not any(signal.value.digits for signal in layout.device.signals.values()):
        return layout
    signals = {name: replace(signal, value=_bytes(signal.value)) for name, signal in layout.device.signals.items()}
    return replace(layout, device=replace(layout.device, signals=signals))


def _bytes(value: Value) -> Value:
    if not value.digits:
        return value
    kind = PRIMITIVES["bytes"]
    scale, offset = type(value.scale)(1), type(value.offset)(0)
    bare = replace(value, type=kind, digits="", places=0, has_blanks=False, scale=scale, scale_text="", offset=offset)
    return replace(bare, enum="", flags="", sentinels=(), unit="", default=None, ranges=None, write_ranges=None)
