"""A conversion is used for signals of its own type, and its full scale is the raw value that the scale of the
signal makes 100 %.

Why: the manual prints the normalization of a signal in the list of signals and again in the formula. If the
two differ, one of them can make a motor run at twice the speed.

Example: `full_scale: 0x4000` for a signal with `scale: 100/2^30` and the unit %.

Fix: Correct the scale or the full scale, and write an erratum. Add a separate conversion for signals of
another type.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.value import Conversion, Signal

_SHARE = "%"


def conversions_match_signals(device: Device) -> Findings:
    for conversion in device.conversions.values():
        if not conversion.type.low <= conversion.full_scale <= conversion.type.high:
            text = f"the full scale of {conversion.name} is {conversion.full_scale:#x}, which does not fit"
            text += f" {conversion.type.name}"
            yield finding(conversion.place, "full_scale", text, "correct the full scale or the type")
        for name in conversion.signals:
            signal = device.signals.get(name)
            if signal is not None:
                yield from _compare_scales(conversion, signal)


def _compare_scales(conversion: Conversion, signal: Signal) -> Findings:
    if signal.value.type is not conversion.type:
        text = f"{signal.name} is {signal.value.type.name}, but {conversion.name} is for {conversion.type.name}"
        related_label = label(signal.place, "type", signal.name)
        yield finding(conversion.place, "signals", text, "add a separate conversion for the signal", related_label)
    whole = signal.value.in_unit(conversion.full_scale)
    if signal.value.unit == _SHARE and whole != 100:
        text = f"{conversion.full_scale:#x} is {whole.normalize():f} % of {signal.name}, not 100 %"
        related_label = label(signal.place, "scale", "the scale of the signal")
        yield finding(conversion.place, "full_scale", text, "correct the full scale or the scale", related_label)
