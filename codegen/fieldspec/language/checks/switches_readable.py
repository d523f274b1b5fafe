"""A switch that accepts every number states which number a read returns.

Why: if every value except 0 switches on, a device may return the written value, or 1. A program that compares the read
value with the written value, or with 1, works with some devices only.

Example: a register without a range that can be read and written, with an open enum of 0 `off` and 1 `on`.

Fix: Make the enum closed, or give the register a range, if the device rejects other numbers. If the manual does not
print the returned number, state that under `allow`, and write an erratum with `printed: {allow: ~}`.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding
from fieldspec.language.model.device import Device

_SWITCH = [0, 1]


def switches_readable(device: Device) -> Findings:
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
            yield finding(register.place, "enum", text, help)
