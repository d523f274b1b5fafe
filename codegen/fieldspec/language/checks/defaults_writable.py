"""A register or field with a default, or whose changes need a restart, can be written, unless it shows the value of
another register.

Why: a default is the factory value of a setting, and a read-only value cannot be changed. If no program can write the
value, its access or the other key is misprinted.

Example: a register with `access: ro` and `default: 100`, or with `access: ro` and `restart: true`.

Fix: Correct the access, or remove the default or `restart`. If the value is set in a different way, such as by the
controller, state `allow: {defaults_writable: <reason>}`.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, default_key, finding, label
from fieldspec.language.diagnostics import Severity
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import Field
from fieldspec.language.model.registers import Parameter, Register
from fieldspec.language.model.table_records import table_records


def defaults_writable(device: Device) -> Findings:
    settings: list[Register | Parameter | Field] = [register for register in device.registers() if not register.copy_of]
    settings += [parameter for parameters in device.parameters.values() for parameter in parameters.parameters]
    uses = table_records(device)
    writable = {name for name, own in uses.items() if any(use.access != "ro" for use in own)}
    settings += (field for record in device.records.values() if record.name in writable for field in record.fields)
    for fact in settings:
        if fact.access == "ro" and fact.restart:
            text = f"a change of {fact.name} needs a restart, and it can only be read"
            related_label = label(fact.place, "restart", "what changes need")
            help = "correct the access, or remove `restart`"
            yield finding(fact.place, "access", text, help, related_label, severity=Severity.WARNING)
        elif fact.access == "ro" and fact.value is not None and fact.value.default is not None:
            text = f"{fact.name} has a default, and can only be read"
            related_label = label(fact.place, default_key(fact.place), "its value at delivery")
            help = "correct the access, or remove the default"
            yield finding(fact.place, "access", text, help, related_label, severity=Severity.WARNING)
