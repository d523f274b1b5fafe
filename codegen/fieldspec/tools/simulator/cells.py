"""Cells: where the value of a signal is in the memory of a simulated device."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod

from fieldspec.codec.explain.occupants import Occupant
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.behaviour.names import IN_USE, Names
from fieldspec.language.behaviour.part import Behaviour
from fieldspec.language.model.operand import Operand
from fieldspec.language.model.registers import Parameter, Register, Subindex
from fieldspec.tools.simulator.memory import Element, Memory, default_raw, element_value

if TYPE_CHECKING:
    from fieldspec.codec.layout.values import Raw
    from fieldspec.language.model.enums import Bit
    from fieldspec.language.model.value import Value

_INDEX = re.compile(r"(.*)\[([0-9]+)\]")


class Cell(ABC):
    """One value. `path` is that of its operand, without an index."""

    def __init__(self, path: str, value: Value | None) -> None:
        self.path, self.value = path, value

    @abstractmethod
    def read(self) -> Raw:
        """The raw value."""

    @abstractmethod
    def write(self, raw: Raw) -> None:
        """Sets the raw value."""


class WordCell(Cell):
    """A register, or an element of one."""

    def __init__(self, path: str, memory: Memory, space: str, occupant: Occupant) -> None:
        super().__init__(path, occupant.value)
        self.memory, self.space, self.occupant = memory, space, occupant
        self._addresses = [(space, address) for address in range(occupant.address, occupant.address + occupant.words)]
        memory.words.watch(self._addresses)
        self._read: tuple[list[int], Raw] = [], 0
        self._written: tuple[list[int], str] = [], ""
        """The words after the last reading and the last writing, with the raw value, and with its exact text."""

    def _words(self) -> list[int]:
        return [*map(self.memory.words.__getitem__, self._addresses)]

    def read(self) -> Raw:
        words = self._words()
        if words != self._read[0]:
            self._read = words, self.memory.read(self.space, self.occupant)
        return self._read[1]

    def write(self, raw: Raw) -> None:
        text = repr(raw)
        if (self._words(), text) != self._written:
            self.memory.write(self.space, self.occupant, raw)
            self._written = self._words(), text


class ElementCell(Cell):
    """An element of a parameter."""

    def __init__(self, path: str, memory: Memory, element: Element, value: Value) -> None:
        super().__init__(path, value)
        self.memory, self.element = memory, element
        memory.elements.watch([element])

    def read(self) -> Raw:
        return self.memory.elements[self.element]

    def write(self, raw: Raw) -> None:
        self.memory.elements[self.element] = raw


class FieldCell(Cell):
    """A field of a message, or a part of a frame."""

    def __init__(self, path: str, memory: Memory, value: Value | None) -> None:
        super().__init__(path, value)
        self.memory = memory
        self.default: Raw = default_raw(memory.layout.device, value) if value is not None else 0
        memory.fields.watch([path])

    def read(self) -> Raw:
        return self.memory.fields.get(self.path, self.default)

    def write(self, raw: Raw) -> None:
        self.memory.fields[self.path] = raw


class BitCell(Cell):
    """A bit, or a field of bits, of another cell."""

    def __init__(self, path: str, cell: Cell, bit: Bit) -> None:
        super().__init__(path, None)
        self.cell, self.bit, self.enum = cell, bit, bit.enum

    def read(self) -> Raw:
        """The number in the bits."""
        word = self.cell.read()
        return self.bit.joined(word) if isinstance(word, int) else 0

    def write(self, raw: Raw) -> None:
        """Sets the bits and leaves the others as they are."""
        word = self.cell.read()
        number = int(raw) if isinstance(raw, int | float) else 0
        old = word if isinstance(word, int) else 0
        self.cell.write(old & ~self.bit.mask | self.bit.placed(number))


class Cells:
    """The cells of signals by name. A role in cyclic messages means that of the message in use."""

    def __init__(self, memory: Memory, behaviour: Behaviour, message: str = "") -> None:
        self.memory, self.message = memory, message
        self.names = Names(memory.layout.device, behaviour)
        self._known: dict[tuple[str, str], list[Cell]] = {}

    def of(self, name: str, direction: str = "") -> list[Cell]:
        """The cells of a signal; of a role in messages only the cells of one direction, where it is stated."""
        key = (name, direction)
        if key not in self._known:
            self._known[key] = list(self._cells(name, direction))
        return self._known[key]

    def elements(self, name: str) -> list[str]:
        """The names of all elements of a register of many; the name itself for any other signal."""
        operand = next(iter(self.names.of_signal(name)), None)
        register = operand.holder if operand is not None else None
        if not isinstance(register, Register) or register.count == 1:
            return [name]
        return [f"{name}[{number}]" for number in range(register.index_from, register.index_from + register.count)]

    def _cells(self, name: str, direction: str) -> list[Cell]:
        match = _INDEX.fullmatch(name)
        index = int(match[2]) if match else None
        operands = self.names.of_signal(match[1] if match else name)
        if "/" not in name and direction:
            operands = [
                operand
                for operand in operands
                if not operand.scope.startswith("messages/") or f"/{direction}/" in operand.path
            ]
        in_use = [operand for operand in operands if operand.scope == f"messages/{self.message}"]
        if name.startswith(IN_USE) or ("/" not in name and in_use):
            operands = in_use
        return [self._of_operand(operand, index) for operand in operands]

    def _of_operand(self, operand: Operand, index: int | None) -> Cell:
        bit = operand.bit
        if bit is None:
            return self._of_fact(operand, operand.path, index)
        whole = operand.path.rpartition("/")[0]
        return BitCell(operand.path, self._of_fact(operand, whole, index), bit)

    def _of_fact(self, operand: Operand, path: str, index: int | None) -> Cell:
        fact, memory = operand.holder, self.memory
        device = memory.layout.device
        if isinstance(fact, Register):
            number = 0 if index is None else index - fact.index_from
            address, space = fact.address + number * fact.stride, device.space_name(fact.space)
            present = next(o for o in memory.at(space, address) if o.outer is fact or o.fact is fact)
            return WordCell(path, memory, space, present)
        if isinstance(fact, Parameter | Subindex):
            for parameter_set in device.parameters.values():
                for parameter in parameter_set.parameters:
                    if fact is parameter:
                        element = (parameter_set.name, parameter.number, index or 0)
                        return ElementCell(path, memory, element, element_value(parameter, index or 0))
                    if isinstance(fact, Subindex) and fact in parameter.subindices:
                        element = (parameter_set.name, parameter.number, fact.indices.low)
                        return ElementCell(path, memory, element, fact.value)
        value = operand.value
        if value is None:
            holder = next((o for o in self.names.operands.all if o.path == path), None)
            value = holder.value if holder is not None else None
        return FieldCell(path, memory, value)
