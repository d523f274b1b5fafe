"""A register whose scale is read from the device is a whole number without a scale, offset or names of its own. Its
`scale_by` names another register of the same space: a single whole number that can be read, without a scale of its own,
whose `range` is within -22..22.

Why: programs read the exponent, and compute quantities with it. Beyond 10^22, a power of ten is no exact floating-point
number.

Example: `scale_by: power_sf`, where `power_sf` is a `u16` without a `range`.

Cure: Give the exponent its printed `range`, such as -10..10, and its value for "not available" under `sentinels`. State
bounds of the scaled register in counts.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.finding import finding
from fieldspec.checks.inferred_keys_present import has_key
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.access import readable
from fieldspec.model.device import Device
from fieldspec.model.registers import Register
from fieldspec.model.value import MOST_PLACES, Kind

_CODE = "exponents_apply"
_OWN = ("scale", "offset", "enum", "flags", "const", "parameter")


def exponents_apply(device: Device) -> Iterator[Diagnostic]:
    registers = {register.name: register for register in device.registers()}
    for register in device.registers():
        if not register.value.scale_by:
            continue
        if register.value.type.kind is not Kind.INTEGER:
            text = f"{register.name} is {register.value.type.name}, to which `scale_by` does not apply"
            yield finding(_CODE, register.place, "scale_by", text, "remove it, or use an integer type")
        for key in _OWN:
            if has_key(register, key):
                text = f"{register.name} has `{key}`, and takes its scale from {register.value.scale_by}"
                yield finding(_CODE, register.place, key, text, "remove one of them")
        exponent = registers.get(register.value.scale_by)
        wrong = "" if exponent is None else _no_exponent(device, register, exponent)
        if wrong:
            text = f"{register.value.scale_by} cannot be the exponent of {register.name}: {wrong}"
            yield finding(_CODE, register.place, "scale_by", text, "name the register with the power of ten")


def _no_exponent(device: Device, register: Register, exponent: Register) -> str:
    """Why a register is not the exponent of another one; empty where it may be."""
    value = exponent.value
    if exponent is register:
        return "it is the register itself"
    if device.space_name(exponent.space) != device.space_name(register.space):
        return "it is in another address space"
    if value.type.kind is not Kind.INTEGER or value.scaled or value.scale_by or value.enum or value.flags:
        return "it is not a whole number without a scale and without names"
    if exponent.count > 1:
        return f"it stands for {exponent.count} registers"
    if exponent.reserved or exponent.trigger or not readable(exponent.access):
        return "the spec does not say that it can be read"
    if value.write_ranges is not None:
        return "its `write_range` differs from what it may be"
    if value.ranges is None or value.ranges.low < -MOST_PLACES or value.ranges.high > MOST_PLACES:
        return f"its `range` is not within -{MOST_PLACES}..{MOST_PLACES}"
    if any(sentinel.value in value.ranges for sentinel in value.sentinels):
        return "a special value is within its `range`"
    return ""
