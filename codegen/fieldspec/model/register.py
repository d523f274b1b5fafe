"""Registers: words at addresses."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.fact import Citation, Fact
from fieldspec.model.handling import Handling
from fieldspec.model.place import Place
from fieldspec.model.ranges import Ranges
from fieldspec.model.value import Value


@dataclass(frozen=True, slots=True, kw_only=True)
class Register(Fact):
    """One register, or `count` equal ones that are `stride` words apart, numbered from `index_from`.

    `space` is empty where the spec names none, which means the first one of the device.
    `words`, `decimal` and `number` are what the manual prints; `copy_of` names the register of which this one is a
    copy, else empty; `access` is empty, and `restart` None, where it does not
    say. A reserved one has no meaning to the user. `element_lines` has the place of each element, where they have rows
    of their own.
    """

    space: str
    address: int
    decimal: int | None
    number: int | None
    copy_of: str
    words: int | None
    value: Value
    access: str
    restart: bool | None
    atomic: bool
    trigger: bool
    reserved: bool
    handling: Handling
    same_as: str
    count: int
    stride: int
    index_from: int
    element_name: str
    element_sources: tuple[Citation, ...]

    @property
    def answer(self) -> Value:
        """The value as the device answers it when it is read."""
        return self.value.as_answer(self.trigger)

    @property
    def width(self) -> int:
        """The words of one element."""
        return (self.value.size + 1) // 2

    @property
    def end(self) -> int:
        """The address behind the last word."""
        return self.address + (self.count - 1) * self.stride + self.width


@dataclass(frozen=True, slots=True)
class Gap:
    """Addresses that the manual leaves out, why, and between which lines."""

    place: Place
    addresses: Ranges
    reason: str
    sources: tuple[Citation, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class RegisterGroup(Fact):
    """Registers that the manual lists together, all in one address space."""

    title: str
    space: str
    section: str
    ascending: bool
    gaps: tuple[Gap, ...]
    registers: tuple[Register, ...]
