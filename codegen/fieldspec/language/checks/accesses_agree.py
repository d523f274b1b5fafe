"""The access of a table and the access of its fields fit together: every access that a field permits is permitted by
one of its tables, and every access that a table permits is permitted by one of its fields. A field of a request is not
read-only, and a field of a response is not write-only; neither is `atomic`, because frames are sent whole.

Why: every output uses the narrower of the two. A table of settings can contain a status field with `ro`, and a table
with `ro` can use a record whose fields have `rw`. An access that is narrowed everywhere has no effect, so one of the
two is misprinted.

Example: a table with `access: ro`, the only one that uses its record, and a field of that record with
`access: rw`. A field of a request with `access: ro`.

Fix: Correct one of them, and write an erratum if the manual prints it wrong. Remove the access of a field of a
message.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, enumeration, finding, label
from fieldspec.language.model.access import narrowed, readable, writable
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import Field, Record
from fieldspec.language.model.registers import Table
from fieldspec.language.model.table_records import TableRecord, table_records

_HELP = "correct one of them: outputs use the narrower access"
_VERBS = (("read", readable), ("written", writable))


def accesses_agree(device: Device) -> Findings:
    uses = table_records(device)
    for record in device.records.values():
        own = uses.get(record.name, [])
        for field in record.fields if own else ():
            yield from _of_field(field, own)
        for table in (use.table for use in own if use.table.record == record.name):
            yield from _of_table(table, record)
    for message in device.messages.values():
        yield from _of_message(message.request, "request", "sends", "ro")
        yield from _of_message(message.response, "response", "receives", "wo")


def _of_message(data: Record, direction: str, verb: str, refused: str) -> Findings:
    """The fields whose access contradicts the direction in which they are sent."""
    for field in data.fields:
        if field.access == refused and "access" in field.place:
            text = f"{field.name} is a field of a {direction}, which a controller {verb}, but its access is {refused}"
            yield finding(field.place, "access", text, "remove it: the message says who sends the field")
        if "atomic" in field.place:
            text = f"{field.name} is a field of a {direction}, which is sent whole, so that `atomic` does not apply"
            yield finding(field.place, "atomic", text, "remove it, or state it at the register")


def _of_field(field: Field, uses: list[TableRecord]) -> Findings:
    """The access that the field permits, but no table with its record."""
    if not field.access or not all(use.access for use in uses):
        return
    for verb, allows in _VERBS:
        if allows(field.access) and not any(allows(narrowed(use.access, field.access)) for use in uses):
            names = enumeration(list(dict.fromkeys(use.name for use in uses)))
            text = f"{field.name} can be {verb} by its access, {field.access}, but not as a part of {names}"
            related_label = label(uses[0].place, "access", f"the access of {uses[0].name}")
            yield finding(field.place, "access", text, _HELP, related_label)


def _of_table(table: Table, record: Record) -> Findings:
    """The access that the table permits, but no field of its record."""
    fields = [field for field in record.fields if not field.reserved]
    if not table.access or not fields or not all(field.access for field in fields):
        return
    for verb, allows in _VERBS:
        if allows(table.access) and not any(allows(field.access) for field in fields):
            text = f"{table.name} can be {verb} by its access, {table.access}, but no field of {record.name} can"
            related_label = label(fields[0].place, "access", f"the access of {fields[0].name}")
            yield finding(table.place, "access", text, _HELP, related_label)
