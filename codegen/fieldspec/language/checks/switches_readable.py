"""A switch that takes every number says what reading it gives.

Why: where every value but 0 switches on, a device may return what was written, or 1. A program that compares what
it reads with what it wrote, or with 1, works with one device and not with the other.

Example: a register without a range that can be read and written, with an open enum of 0 `off` and 1 `on`.

Cure: Make the enum closed, or give the register a range, if the device refuses other numbers. If the manual does not
print what reading gives, state that under `allow`, and write an erratum with `printed: {allow: ~}`.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.checks.finding import finding
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device

_CODE = "switches_readable"
_SWITCH = [0, 1]


def switches_readable(device: Device) -> Iterator[Diagnostic]:
    for register in device.registers():
        enum = device.enums.get(register.value.enum)
        if register.access != "rw" or register.trigger or enum is None or not enum.open:
            continue
        ranges = register.value.writable_ranges
        if ranges is not None and ranges.high <= max(_SWITCH):
            continue
        if sorted(member.value for member in enum.members) == _SWITCH:
            text = f"{register.name} takes every number as a switch, and what reading it gives is not stated"
            help = "close the enum, give it a range, or allow it with what the manual leaves open, and write an erratum"
            yield finding(_CODE, register.place, "enum", text, help)
