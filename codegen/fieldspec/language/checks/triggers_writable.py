"""A register or parameter that starts an action can be written.

Why: only writing starts the action. If a trigger is read-only, its access is misprinted, or it is not a
trigger.

Example: `trigger: true` with `access: ro`.

Fix: Correct the access and write an erratum, or remove `trigger`.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.registers import Parameter, Register


def triggers_writable(device: Device) -> Findings:
    startable: list[Register | Parameter] = [*device.registers()]
    startable += [parameter for parameters in device.parameters.values() for parameter in parameters.parameters]
    for fact in startable:
        if fact.trigger and fact.access == "ro":
            text = f"{fact.name} starts an action when it is written, but its access is ro"
            related_label = label(fact.place, "trigger", "only writing starts an action")
            help = "correct the access, or remove `trigger`"
            yield finding(fact.place, "access", text, help, related_label)
