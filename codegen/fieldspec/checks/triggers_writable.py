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
from fieldspec.model.registers import Parameter, Register


def triggers_writable(device: Device) -> Iterator[Diagnostic]:
    startable: list[Register | Parameter] = [*device.registers()]
    startable += [parameter for parameters in device.parameters.values() for parameter in parameters.parameters]
    for fact in startable:
        if fact.trigger and fact.access == "ro":
            text = f"{fact.name} starts an action when it is written, but its access is ro"
            there = label(fact.place, "trigger", "only writing starts an action")
            help = "put the access right, or take `trigger` out"
            yield finding("triggers_writable", fact.place, "access", text, help, there)
