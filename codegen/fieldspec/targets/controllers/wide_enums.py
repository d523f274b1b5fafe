"""Enums whose numbers, or whose codes with texts, no single type holds."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic
from fieldspec.targets.controllers.dialects import Dialect
from fieldspec.targets.controllers.enums import coded
from fieldspec.targets.controllers.routines.world import has_common_type, raw_bounds

_MOST = (1 << 63) - 1


def wide_enums(layout: DeviceLayout, dialect: Dialect) -> Iterator[Diagnostic]:
    """A finding for each enum that no type holds, and for each whose codes are too great for the list of texts."""
    for name, (low, high) in raw_bounds(layout).items():
        if not has_common_type(low, high):
            text = f"values with {name} may be negative, or 2^63 and more; {dialect.title} has no type for both"
            yield Diagnostic("plc_enums_fit", text, layout.device.enums[name].place["name"], help=LEAVE_OUT)
    if not dialect.texts:
        return
    for enum, texts in coded(layout.device):
        if max(text.code for text in texts) > _MOST:
            text = f"{enum.name} has codes from 2^63 on with texts; lists of texts have a signed column of codes"
            yield Diagnostic("plc_enums_fit", text, enum.place["name"], help=LEAVE_OUT)
