"""The meaning of names in a behaviour: signals, elements of records, properties of the axis, states of machines."""

from __future__ import annotations

from fieldspec.language.behaviour.part import AXIS_PROPERTIES, NONZERO, Behaviour
from fieldspec.language.model.device import Device
from fieldspec.language.model.operand import Operand, Operands
from fieldspec.language.model.record import Message, Record

IN_USE = "message/"
"""Begins the name of a signal in the cyclic message in use."""


class Names:
    """The signals that the parts of a behaviour can name, at one version of a device."""

    def __init__(self, device: Device, behaviour: Behaviour) -> None:
        self.device = device
        self.operands = Operands(device)
        self.machines = {part.name: part.subject for part in behaviour.of_kind("machine")}
        self.collections = {part.name: part for part in behaviour.of_kind("collection")}

    def of_signal(self, name: str) -> list[Operand]:
        """The operands that a role or a path names; of a role those outside of messages, if there are any."""
        if name.startswith(IN_USE):
            rest = name.removeprefix(IN_USE)
            paths = [f"messages/{message}/{rest}" for message in self.device.messages]
            return [self.operands.by_path[path] for path in paths if path in self.operands.by_path]
        if "/" in name:
            operand = self.operands.by_path.get(name)
            return [operand] if operand is not None else []
        operands = self.operands.with_role(name)
        if operands:
            return [operand for operand in operands if not isinstance(operand.fact, Message)]
        return [
            operand for operand in self.operands.all if name in operand.roles and operand.scope.startswith("messages/")
        ]

    def of_message(self, name: str) -> list[Message]:
        """The messages with a role, or with a path."""
        return [
            message for message in self.device.messages.values() if name in message.roles or name == message.place.path
        ]

    def is_known(self, name: str) -> bool:
        """Whether a name is a signal, a property of the axis, a state, or a field of a loaded record."""
        scope, _, rest = name.partition("/")
        if scope == "axis":
            return rest in AXIS_PROPERTIES
        if scope == "state":
            return rest in self.machines
        if scope == "element":
            return any(record.named(rest) is not None for record in self._records())
        return bool(self.of_signal(name.partition("[")[0]))

    def like(self, name: str) -> list[str]:
        """The names of the same kind, for a hint."""
        scope = name.partition("/")[0]
        if scope == "axis":
            return [f"axis/{known}" for known in AXIS_PROPERTIES]
        if scope == "state":
            return [f"state/{machine}" for machine in self.machines]
        close = [path for path in self.operands.by_path if path.partition("/")[0] == scope]
        return close if "/" in name else sorted({role for operand in self.operands.all for role in operand.roles})

    def unknown(self, name: str) -> str:
        """The text of a finding about a name that is not a signal, with the names that it may be a misprint of."""
        from difflib import get_close_matches

        last = name.rpartition("/")[2]
        suggestions = [path for path in self.operands.by_path if path.rpartition("/")[2] == last]
        suggestions = suggestions or get_close_matches(name, [*self.like(name), *self.operands.by_path], 3, 0.75)
        hint = f"did you mean {' or '.join(suggestions[:3])}?" if suggestions else "`fieldspec facts` lists the paths"
        return f"the device has no signal `{name}`; a signal is a role, or a path as registers/NAME; {hint}"

    def has_member(self, signal: str, member: str) -> bool:
        """Whether a text is a value of a signal: a state of a machine, a member of an enum, or a special value."""
        scope, _, rest = signal.partition("/")
        if member == NONZERO:
            return scope not in ("state", "axis")
        if scope == "state":
            return member in self.machines.get(rest, ())
        if scope == "element":
            values = [field.value for record in self._records() for field in record.fields if field.name == rest]
        else:
            operands = self.of_signal(signal.partition("[")[0])
            values = [operand.value for operand in operands]
            values_of_bits = [operand.bit.enum for operand in operands if operand.bit is not None and operand.bit.enum]
            if any(self._has_name(enum, member) for enum in values_of_bits):
                return True
        return any(
            self._has_name(value.enum, member) or any(sentinel.name == member for sentinel in value.sentinels)
            for value in values
            if value is not None
        )

    def _has_name(self, enum: str, member: str) -> bool:
        """Whether an enum has a member; one that is not there is a finding at the fact that names it."""
        own = self.device.enums.get(enum)
        return bool(enum) and (own is None or own.named(member) is not None)

    def _records(self) -> list[Record]:
        """The records of tables and collections."""
        names = [table.record for table in self.device.tables.values()]
        names += [part.subject for part in self.collections.values()]
        return [self.device.records[name] for name in dict.fromkeys(names) if name in self.device.records]
