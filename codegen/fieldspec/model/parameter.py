"""Parameters that are addressed by number."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.fact import Fact
from fieldspec.model.handling import Handling
from fieldspec.model.ranges import Ranges
from fieldspec.model.value import Value


@dataclass(frozen=True, slots=True, kw_only=True)
class Subindex(Fact):
    """An element of a parameter, or a run of them, with a meaning of its own."""

    indices: Ranges
    value: Value
    reserved: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class Parameter(Fact):
    """One numbered parameter, or `count` equal ones that follow each other; a reserved one has no meaning to the user.

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

    def numbered(self, number: int) -> Parameter | None:
        """The parameter with a number of the set."""
        return next((one for one in self.parameters if one.number <= number < one.number + one.count), None)

    def holds(self, number: int) -> bool:
        """Whether the set has a number, with or without a row."""
        return self.numbered(number) is not None or (self.numbers is not None and number in self.numbers)

    def written(self, number: int) -> str:
        """A number as the manual writes it."""
        return self.printed_as.format(number=number) if self.printed_as else str(number)
