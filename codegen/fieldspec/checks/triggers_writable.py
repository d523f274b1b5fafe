"""A register or parameter that starts an action can be written.

Why: only writing starts it. A trigger that is read only is a misprinted access, or no trigger.

Example: `trigger: true` with `access: ro`.

Cure: Put the access right and write an erratum, or take `trigger` out.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.finding import finding, label
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device


def triggers_writable(device: Device) -> Iterator[Diagnostic]:
    for register in device.registers():
        if register.trigger and register.access == "ro":
            text = f"{register.name} starts an action when it is written, but its access is ro"
            there = label(register.place, "trigger", "only writing starts an action")
            help = "put the access right, or take `trigger` out"
            yield finding("triggers_writable", register.place, "access", text, help, there)
