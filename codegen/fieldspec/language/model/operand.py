"""The operands of steps of tasks: facts that can be read, written or sent, with their roles."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Bit
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.record import Field, Message
from fieldspec.language.model.value import Value

REGISTERS, PARAMETERS, COMMANDS, FRAMES = "registers", "parameters", "commands", "frames"
"""The scopes of roles outside of records and messages, whose scopes are their paths."""


@dataclass(frozen=True, slots=True)
class Operand:
    """A fact in the one place where a step can reach it.

    `path` is the path of the fact; for a bit, the path of the value with this bit, a slash, and the bit's name.
    `scope` is where a role occurs once: registers, parameters, commands, frames, the path of a record or of a message.
    `value` is None for a bit and for a message. `fact` is the bit, `holder` the fact with the word of the bit, else
    the fact itself.
    """

    scope: str
    path: str
    fact: Fact
    holder: Fact
    value: Value | None
    roles: tuple[str, ...]
    readable: bool
    writable: bool

    @property
    def bit(self) -> Bit | None:
        """The bit, or the field of bits, where it is one."""
        return self.fact if isinstance(self.fact, Bit) else None


def operands(device: Device) -> Iterator[Operand]:
    """All operands of a device. Copies and reserved facts are left out."""
    for register in device.registers():
        if not register.copy_of and not register.reserved:
            yield from _valued(device, REGISTERS, register, register.value, register.roles, register.access)
    for parameter_set in device.parameters.values():
        for parameter in parameter_set.parameters:
            if parameter.reserved:
                continue
            yield from _valued(device, PARAMETERS, parameter, parameter.value, parameter.roles, parameter.access)
            for inner in parameter.subindices:
                yield from _valued(
                    device, PARAMETERS, inner, inner.value, inner.roles, inner.access or parameter.access
                )
    for link in device.links.values():
        for part in link.response:
            if part.value is not None:
                yield from _valued(device, FRAMES, part, part.value, part.roles, "ro")
    for record in device.records.values():
        for field in record.fields:
            yield from _of_field(device, record.place.path, field, field.access)
    for message in device.messages.values():
        yield Operand(COMMANDS, message.place.path, message, message, None, message.roles, False, True)
        yield from _of_message(device, message)


def _of_message(device: Device, message: Message) -> Iterator[Operand]:
    for direction, access in ((message.request, "wo"), (message.response, "ro")):
        for field in direction.fields:
            yield from _of_field(device, message.place.path, field, access)


def _of_field(device: Device, scope: str, field: Field, access: str) -> Iterator[Operand]:
    """The operands of a field, which has the roles of its signal beside its own."""
    signal = device.signals.get(field.signal)
    roles = field.roles
    if signal is not None:
        roles = (*roles, *(role for role in signal.roles if role not in roles))
    if not field.reserved:
        yield from _valued(device, scope, field, field.value, roles, access)


def _valued(
    device: Device, scope: str, fact: Fact, value: Value | None, roles: tuple[str, ...], access: str
) -> Iterator[Operand]:
    """An operand, and the bits of its word. Where the manual does not print the access, both are possible."""
    readable, writable = access != "wo", access != "ro"
    path = fact.place.path
    yield Operand(scope, path, fact, fact, value, roles, readable, writable)
    word = device.flags.get(value.flags) if value is not None else None
    for bit in word.bits if word is not None else ():
        if not bit.reserved:
            yield Operand(scope, f"{path}/{bit.name}", bit, fact, None, bit.roles, readable, writable)


class Operands:
    """The operands of a device by path and by role."""

    def __init__(self, device: Device) -> None:
        self.all = tuple(operands(device))
        self.by_path: dict[str, Operand] = {}
        self._by_role: dict[str, list[Operand]] = {}
        for operand in self.all:
            self.by_path.setdefault(operand.path, operand)
            for role in operand.roles:
                self._by_role.setdefault(role, []).append(operand)

    def with_role(self, role: str, message: str = "") -> list[Operand]:
        """The operands with a role: in a cyclic message by its name, or else outside of records and messages."""
        candidates = self._by_role.get(role, [])
        if message:
            return [operand for operand in candidates if operand.scope == f"messages/{message}"]
        return [operand for operand in candidates if "/" not in operand.scope]

    def target(self, target: str, message: str = "") -> list[Operand]:
        """The operands that the target of a step means: one where all is well."""
        if "/" in target:
            operand = self.by_path.get(target)
            return [operand] if operand is not None else []
        return self.with_role(target, message)
