"""An address space with tables consists of words. A message reads each address space with readable values, and a
message writes each address space with writable values. If the device itself, not a protocol, states a message that
writes an address space, that space contains a writable value.

Why: a register that no message reaches has no request in any output, and a message for another address space would read
another register. If the address space contains no writable value, the message accesses the wrong one, or the access of
the registers is wrong.

Example: a group of input registers in a device whose only reading message accesses holding registers.

Fix: Add the message that reads or writes the address space, with `space` under its `accesses`, or move the group to the
address space that the message accesses. Correct the access of the registers; if the manual does not list the values
that the message writes, set `allow: {spaces_reachable: <reason>}` on the message.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.checks.finding import Findings, finding, is_imported, label
from fieldspec.language.diagnostics import Severity
from fieldspec.language.model.address_space import WORD
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.registers import Table
from fieldspec.language.model.table_records import table_records


def spaces_reachable(device: Device) -> Findings:
    yield from _read_only(device)
    if not device.spaces:
        return
    reached = {
        (device.space_name(message.single_access.space), message.single_access.operation)
        for message in device.messages.values()
        if message.single_access is not None
    }
    for fact, name, accesses in _holders(device):
        space = device.space(name)
        if space.unit != WORD and isinstance(fact, Table):
            text = f"{fact.name} has records of words, but an address of {space.name} is a {space.unit}"
            help = "list the fields of its records as registers, or move the table to a space of words"
            yield finding(fact.place, "space", text, help, label(space.place, "unit", "the unit of the space"))
            continue
        for operation, needs in (("read", {"ro", "rw"}), ("write", {"rw", "wo"})):
            if accesses & needs and (space.name, operation) not in reached:
                text = f"no message {operation}s {space.name}, which contains {fact.name}"
                help = f"name the space under `accesses` of the message that {operation}s it"
                yield finding(fact.place, "space", text, help, label(space.place, "name", "the space"))


def _read_only(device: Device) -> Findings:
    """Warnings of the messages that write spaces in which everything is read only."""
    present: dict[str, set[str]] = {}
    for _, name, accesses in _holders(device):
        present.setdefault(device.space(name).name, set()).update(accesses)
    for message in device.messages.values():
        access = message.single_access
        if access is None or access.operation != "write" or is_imported(message.place, device):
            continue
        space = device.space(access.space)
        if present.get(space.name) == {"ro"}:
            text = f"{message.name} writes {space.name or 'registers'}, and all that is there is read only"
            help = "correct the space, or the `access` of what can be written there"
            yield finding(message.place, "accesses", text, help, severity=Severity.WARNING)


def _holders(device: Device) -> Iterator[tuple[Fact, str, set[str]]]:
    """The groups and tables, their spaces, and how what is in them can be accessed."""
    uses = table_records(device)
    for group in device.groups:
        yield group, group.space, {register.access for register in group.registers}
    for table in device.tables.values():
        own = (use for name in uses for use in uses[name] if use.table is table)
        accesses = {
            field.access or use.access
            for use in own
            for field in (device.records[use.record].fields if use.record in device.records else ())
            if not field.record
        }
        yield table, table.space, accesses
