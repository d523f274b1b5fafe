"""The references in the code of a client: the names of a version's module, and values as expressions."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.encoding import is_exact
from fieldspec.language.model.enums import Bit
from fieldspec.language.model.fact import Fact, ScalarValue
from fieldspec.language.model.operand import Operand
from fieldspec.language.model.registers import Parameter, Register, Subindex
from fieldspec.language.model.value import Value
from fieldspec.targets.fact_texts import unit_word
from fieldspec.targets.python.links import Exchange
from fieldspec.targets.python.records import RecordView
from fieldspec.targets.python.slots import Slots, Words, value_type

CODEC = "_codec"
"""The module of the version, as the module of the client imports it."""


class NoTask(Exception):
    """A task that no client carries out. The text says why."""


@dataclass(frozen=True, slots=True)
class Argument:
    """An argument of a task: its name, its type, and whether users pass it in its unit, not in counts."""

    name: str
    type: str
    in_unit: bool


@dataclass(frozen=True, slots=True)
class ClientNames:
    """The names that the module of a version has for its facts. The keys are paths of facts, and names of messages."""

    layout: DeviceLayout
    words: Words
    registers: Mapping[str, str]
    parameters: Mapping[str, str]
    exchanges: Mapping[str, Exchange]
    records: Mapping[str, RecordView]

    def place(self, operand: Operand) -> str:
        """The expression of a register or of a parameter. Raises NoTask for one that is not a single value."""
        fact = operand.holder
        path = fact.place.path
        if isinstance(fact, Register) and fact.count == 1 and path in self.registers:
            return f"{CODEC}.{self.registers[path]}"
        if isinstance(fact, Parameter) and fact.count == 1 and path in self.parameters:
            return f"{CODEC}.{self.parameters[path]}"
        raise NoTask(f"`{operand.path}` is not a single register or parameter")

    def owner(self, element: Subindex) -> str:
        """The expression of the parameter that an element belongs to."""
        rows = (row for owner in self.layout.device.parameters.values() for row in owner.parameters)
        own = next(row for row in rows if any(inner is element for inner in row.subindices))
        return f"{CODEC}.{self.parameters[own.place.path]}"

    def argument(self, name: str, value: Value) -> Argument:
        """The argument for a value: in its unit where it has a scale."""
        if is_scaled(value):
            return Argument(f"{name}_{unit_word(value.unit)}", "_Quantity", True)
        kind = value_type(value, self.words)
        if value.enum or value.flags:
            owner = self.words.enums[value.enum].name if value.enum else self.words.flags[value.flags]
            kind = f"{CODEC}.{owner} | int"
        return Argument(name, kind, False)

    def answer_type(self, value: Value, any_answer: bool = False) -> str:
        """The type of a value that is read, in its unit where it has a scale."""
        if is_scaled(value):
            return "float | None"
        kind = value_type(value, self.words)
        if value.enum and value.const is None:
            name = self.words.enums[value.enum].name
            kind = f"{CODEC}.{name} | int" if any_answer or value.sentinels or " | " in kind else f"{CODEC}.{name}"
        elif value.flags:
            kind = f"{CODEC}.{kind}"
        return kind

    def request(self, message: str) -> Exchange:
        """The classes of a message. Raises NoTask for a message without a response."""
        exchange = self.exchanges.get(message)
        if exchange is None or not exchange.response_name:
            raise NoTask(f"{message} has no response")
        return exchange

    def attribute(self, exchange: Exchange, direction: str, fact: Fact) -> Slots | None:
        """The attribute of a message for a field; None where the message has none in this direction."""
        shaped, _ = exchange.side(direction)
        return next((slot for slot in shaped.stored if slot.field.field is fact), None)

    def scaled_name(self, exchange: Exchange, direction: str, slot: Slots) -> str:
        """The name of the property in the unit; the attribute itself where it has no scale."""
        _, name = exchange.side(direction)
        view = self.records[name]
        return next((scaled.name for scaled in view.scaled if scaled.field == slot.name), slot.name)


def is_scaled(value: Value) -> bool:
    """Whether the count of a value differs from its quantity."""
    return is_exact(value.encoding) and value.scaled and not value.enum and not value.flags


def wanted(layout: DeviceLayout, operand: Operand, value: Value | None, stated: ScalarValue) -> tuple[str, str]:
    """The number and the mask of a value that a step waits for, as expressions; the mask is empty for whole values.

    Raises NoTask for what is not a number.
    """
    bit = operand.bit
    number = raw_number(layout, value, bit, stated)
    if bit is None:
        return str(number), ""
    return f"0x{bit.placed(number):X}", f"0x{bit.mask:X}"


def raw_number(layout: DeviceLayout, value: Value | None, bit: Bit | None, stated: ScalarValue | object) -> int:
    """The number of a value that a step states: a count, a truth, a member, a special value. Raises NoTask."""
    enum = bit.enum if bit is not None else value.enum if value is not None else ""
    if isinstance(stated, bool | int):
        return int(stated)
    if isinstance(stated, str):
        member = layout.device.enums[enum].named(stated) if enum else None
        if member is not None:
            return int(member.value)
        for sentinel in value.sentinels if value is not None else ():
            if sentinel.name == stated and not sentinel.is_nan:
                return int(sentinel.value)
    raise NoTask(f"`{stated}` is not a number")
