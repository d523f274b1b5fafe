"""Functions: what they take, what they give, and what they do."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.plc.routines.expressions import Call, Expression, Variable
from fieldspec.plc.routines.statements import Body
from fieldspec.plc.routines.types import Type

SECTIONS = {"input": "VAR_INPUT", "in_out": "VAR_IN_OUT", "output": "VAR_OUTPUT", "local": "VAR"}
"""The roles of variables in the order in which they are declared, and the words for them."""


@dataclass(frozen=True, slots=True)
class Declared:
    """A parameter or a local variable: its role is input, in_out, output or local."""

    variable: Variable
    role: str
    remark: str = ""


@dataclass(frozen=True, slots=True)
class Routine:
    """A function. It changes nothing but its outputs and the variables that it is lent, and keeps nothing.

    `group` is what it is about, in a word or two; `remarks` are the paragraphs of its comment, `example` are lines of
    a program that calls it.
    """

    name: str
    group: str
    returns: Type
    declared: tuple[Declared, ...]
    body: Body
    remarks: tuple[str, ...]
    example: tuple[str, ...] = ()

    @property
    def result(self) -> Variable:
        """What is assigned to return a value."""
        return Variable(self.name, self.returns)

    def of_role(self, role: str) -> list[Declared]:
        """The variables with a role."""
        return [one for one in self.declared if one.role == role]

    def called(self, **given: Expression) -> Call:
        """A call with an expression for every parameter."""
        outputs = {one.variable.name for one in self.of_role("output")}
        wanted = [one.variable.name for one in self.declared if one.role != "local"]
        assert sorted(given) == sorted(wanted), (self.name, sorted(given), sorted(wanted))
        return Call(
            self.name,
            tuple((name, given[name]) for name in wanted if name not in outputs),
            tuple((name, given[name]) for name in wanted if name in outputs),
            self.returns,
        )
