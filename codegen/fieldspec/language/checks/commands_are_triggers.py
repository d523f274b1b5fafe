"""A register or parameter that is write-only, or accepts only one constant, is a trigger. A register or parameter with
the role of an action, such as the start of a move, is a trigger too.

Why: a value that cannot be read stores no setting, and a value with one member offers no choice. Writing it starts an
action, and outputs warn only at triggers. If no action starts, the access is misprinted.

Example: a register without `trigger` but with `access: wo`, with `access: rw` and `const: 1`, or with `roles:
move_start`.

Fix: Set `trigger: true`, or correct the access. If the device stores a setting that it does not return, or acts as
long as the value is set, state `allow: {commands_are_triggers: <reason>}`.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding
from fieldspec.language.diagnostics import Severity
from fieldspec.language.model.device import Device
from fieldspec.language.model.registers import Parameter, Register
from fieldspec.language.model.table_records import table_records

_ACTIONS = frozenset(
    ("alarm_reset", "command", "homing_start", "jog_start", "move_start", "point_start", "restart", "save")
) | frozenset(("save_points", "stop"))
"""The roles of what starts an action when it is written."""


def commands_are_triggers(device: Device) -> Findings:
    writable: list[Register | Parameter] = [*device.registers()]
    writable += [parameter for parameters in device.parameters.values() for parameter in parameters.parameters]
    for fact in writable:
        if fact.trigger or fact.reserved:
            continue
        if fact.access == "wo":
            text, key = f"{fact.name} can only be written, but is not a trigger", "access"
        elif fact.access == "rw" and fact.value.const is not None:
            text, key = f"{fact.name} can only be written with {fact.value.const}, but is not a trigger", "const"
        elif fact.access != "ro" and not fact.value.flags and (roles := _ACTIONS.intersection(fact.roles)):
            text, key = f"{fact.name} has the role {min(roles)}, but is not a trigger", "name"
        else:
            continue
        help = "set `trigger: true`, or correct the access"
        yield finding(fact.place, key, text, help, severity=Severity.WARNING)
    uses = table_records(device)
    for record in device.records.values():
        is_setting = any(use.access != "wo" for use in uses.get(record.name, ()))
        for field in record.fields if is_setting else ():
            if field.access == "wo":
                text = f"the field {field.name} of a table can only be written"
                help = "correct the access, or allow it with a reason"
                yield finding(field.place, "access", text, help, severity=Severity.WARNING)
