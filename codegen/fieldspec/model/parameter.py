"""Parameters that are addressed by number."""

from __future__ import annotations

from dataclasses import dataclass

from fieldspec.model.fact import Fact
from fieldspec.model.value import Value


@dataclass(frozen=True, slots=True, kw_only=True)
class Parameter(Fact):
    """One numbered parameter; a reserved one has no meaning to the user."""

    number: int
    value: Value
    access: str
    restart: bool | None
    reserved: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class ParameterSet(Fact):
    """The parameters of one set in the order of their numbers."""

    title: str
    parameters: tuple[Parameter, ...]

    def numbered(self, number: int) -> Parameter | None:
        """The parameter with a number."""
        return next((parameter for parameter in self.parameters if parameter.number == number), None)
