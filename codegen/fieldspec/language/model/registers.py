"""Registers, record tables and numbered parameters."""

from __future__ import annotations

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.fact import Citation, Fact, Place
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.value import Handling, Value


@dataclass(frozen=True, slots=True, kw_only=True)
class Register(Fact):
    """One register, or `count` equal ones that are `stride` addresses apart, numbered from `index_from`.

    An address has `unit_size` bytes: 2 in a space of words, and 1 in a space of bytes.

    `space` is empty where the spec names none, which means the first one of the device. `words`, `decimal` and `number`
    are what the manual prints; `copy_of` names the register of which this one is a copy, else empty; `access` is empty,
    and `restart` None, where it does not say. A reserved register has no meaning for users. `element_sources` has the
    place of each element, where they have rows of their own.
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
    unit_size: int = 2

    @property
    def answer(self) -> Value:
        """The value in the response when the register is read."""
        return self.value.as_answer(self.trigger)

    @property
    def width(self) -> int:
        """The addresses of one element: its words, or its bytes in a space of bytes."""
        return -(-self.value.size // self.unit_size)

    @property
    def end(self) -> int:
        """The address after the last one."""
        return self.address + (self.count - 1) * self.stride + self.width


@dataclass(frozen=True, slots=True)
class Gap:
    """Addresses that the manual leaves out, the reason, and the lines around them."""

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


@dataclass(frozen=True, slots=True)
class PrintedElement:
    """The printed details of one element: its addresses and its words."""

    place: Place
    index: int
    first: int | None
    last: int | None
    words: int | None
    sources: tuple[Citation, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Table(Fact):
    """`count` records, the first at `base`, `stride` words apart, numbered from `index_from`.

    `space` is empty where the spec names none, which means the first one of the device. `count_by` names the register
    with the number of elements that the device has; `count` is then the greatest one. It is empty where all are there.
    `base_by` names the register whose value is the address of the first element; `base` is then the usual one. It is
    empty where the table does not move.
    """

    title: str
    space: str
    base: int
    decimal: int | None
    stride: int
    count: int
    index_from: int
    record: str
    words: int | None
    access: str
    handling: Handling
    elements: tuple[PrintedElement, ...]
    count_by: str = ""
    base_by: str = ""

    def address(self, index: int) -> int:
        """The address of an element by its number."""
        return self.base + (index - self.index_from) * self.stride

    @property
    def indexes(self) -> range:
        """The numbers of the elements."""
        return range(self.index_from, self.index_from + self.count)


@dataclass(frozen=True, slots=True, kw_only=True)
class Subindex(Fact):
    """An element of a parameter, or a run of them, with a meaning of its own.

    `access` is empty where that of the parameter applies.
    """

    indices: Ranges
    value: Value
    reserved: bool
    access: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Parameter(Fact):
    """One numbered parameter, or `count` equal ones in a row; a reserved parameter has no meaning for users.

    `number` is counted as the manual counts in its set; `wire_number` is the one on the wire as printed. `elements`
    is the length of an array. `applies_to` names kinds of motor or model, `messages` those with which it has an
    effect; both are empty where the manual makes no difference.
    """

    number: int
    wire_number: int | None
    count: int
    value: Value
    elements: int | None
    subindices: tuple[Subindex, ...]
    access: str
    restart: bool | None
    trigger: bool
    handling: Handling
    applies_to: tuple[str, ...]
    messages: tuple[str, ...]
    reserved: bool

    def element(self, index: int) -> Subindex | None:
        """The element with an index, where it has a meaning of its own."""
        return next((inner for inner in self.subindices if index in inner.indices), None)

    def element_access(self, index: int) -> str:
        """The access of the element with an index."""
        element = self.element(index)
        return self.access if element is None else element.access or self.access


@dataclass(frozen=True, slots=True, kw_only=True)
class ParameterSet(Fact):
    """The parameters of one set in the order of their numbers.

    On the wire their numbers have `base` added. Sets with the same `space` share these; it is the set's name where
    nothing is given. `numbers` are all that there are, where they are more than the rows. `printed_as` is how the
    manual writes a number, empty where it writes digits only.
    """

    title: str
    space: str
    base: int
    numbers: Ranges | None
    printed_as: str
    parameters: tuple[Parameter, ...]

    def at_place(self, place: int) -> tuple[Parameter, int] | None:
        """The parameter and its number at a place among the values of all numbers, in order; None after the last."""
        for parameter in self.parameters:
            if place < parameter.count:
                return parameter, parameter.number + place
            place -= parameter.count
        return None

    def numbered(self, number: int) -> Parameter | None:
        """The parameter with a number of the set."""
        return next(
            (
                parameter
                for parameter in self.parameters
                if parameter.number <= number < parameter.number + parameter.count
            ),
            None,
        )

    def holds(self, number: int) -> bool:
        """Whether the set has a number, with or without a row."""
        return self.numbered(number) is not None or (self.numbers is not None and number in self.numbers)

    def number_text(self, number: int) -> str:
        """A number as the manual writes it."""
        return self.printed_as.format(number=number) if self.printed_as else str(number)
