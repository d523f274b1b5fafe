"""Routines with their variables, statements and status, and drafts of them."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import TypeAlias

from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import dataclass
from fieldspec.targets.controllers.statements.expressions import (
    INT,
    UINT,
    Call,
    Conversion,
    Element,
    EnumMemberExpression,
    EnumType,
    Expression,
    Fraction,
    Member,
    Negation,
    Operation,
    Shift,
    Truth,
    Type,
    Variable,
    Whole,
)


@dataclass(frozen=True, slots=True)
class Assignment:
    """An assignment: `target := value;`"""

    target: Expression
    value: Expression


@dataclass(frozen=True, slots=True)
class Condition:
    """An IF statement with an ELSIF for each further branch; without `otherwise` it has no ELSE."""

    branches: tuple[tuple[Expression, Body], ...]
    otherwise: Body = ()


@dataclass(frozen=True, slots=True)
class Loop:
    """FOR from `first` to `last`, both included; nothing is done where `last` is less."""

    index: Variable
    first: Expression
    last: Expression
    body: Body


@dataclass(frozen=True, slots=True)
class Selection:
    """CASE; each branch has the intervals of whole numbers, or the members of an enum, for which it is taken."""

    of: Expression
    branches: tuple[tuple[tuple[tuple[int, int] | EnumMemberExpression, ...], Body], ...]
    otherwise: Body = ()


@dataclass(frozen=True, slots=True)
class Return:
    """A RETURN statement, which ends the routine."""


@dataclass(frozen=True, slots=True)
class Remark:
    """A line of comment. In front of a branch of a Selection it is on the line of the label."""

    text: str


@dataclass(frozen=True, slots=True)
class Region:
    """Statements with a heading."""

    heading: str
    body: Body


@dataclass(frozen=True, slots=True)
class Timing:
    """A call of an on-delay timer: it runs while `running` holds, and its Q is true when `time` has passed."""

    timer: Variable
    running: Expression
    time: Variable


@dataclass(frozen=True, slots=True)
class Invocation:
    """A call of a function block by the variable that is its instance: `fbHome(Execute := xHome, stAxis := stAxis);`"""

    block: Variable
    arguments: tuple[tuple[str, Expression], ...]


Statement: TypeAlias = Assignment | Condition | Loop | Selection | Return | Timing | Invocation | Remark | Region
Body: TypeAlias = tuple[Statement, ...]


def when(test: Expression, body: Iterable[Statement], otherwise: Iterable[Statement] = ()) -> Condition:
    """An IF statement with one test."""
    return Condition(((test, tuple(body)),), tuple(otherwise))


SECTIONS = {"input": "VAR_INPUT", "in_out": "VAR_IN_OUT", "output": "VAR_OUTPUT", "local": "VAR"}
"""The roles of variables in the order in which they are declared, and the words for them."""


@dataclass(frozen=True, slots=True)
class Declared:
    """A parameter or a local variable: its role is input, in_out, output or local. `initial` is a literal, or empty."""

    variable: Variable
    role: str
    remark: str = ""
    initial: str = ""


@dataclass(frozen=True, slots=True)
class Routine:
    """A function. It changes only its outputs and in-out variables, and has no state.

    Where `returns` is None it is a function block, which keeps its variables from one call to the next. `group` is what
    it is about, in a word or two; `remarks` are the paragraphs of its comment.
    """

    name: str
    group: str
    returns: Type | None
    declared: tuple[Declared, ...]
    body: Body
    remarks: tuple[str, ...]

    @property
    def result(self) -> Variable:
        """The variable of the routine's own name, to which its result is assigned."""
        assert self.returns is not None
        return Variable(self.name, self.returns)

    def of_role(self, role: str) -> list[Declared]:
        """The declared variables that have a role."""
        return [declared for declared in self.declared if declared.role == role]

    @property
    def constants(self) -> list[Whole]:
        """The named numbers of the statements, grouped by type."""
        return sorted_constants(_names(self.body)[2])

    def called(self, **arguments: Expression) -> Call:
        """A call with an expression for every parameter."""
        assert self.returns is not None
        outputs = {declared.variable.name for declared in self.of_role("output")}
        expected = [declared.variable.name for declared in self.declared if declared.role != "local"]
        assert sorted(arguments) == sorted(expected), (self.name, sorted(arguments), sorted(expected))
        return Call(
            self.name,
            tuple((name, arguments[name]) for name in expected if name not in outputs),
            tuple((name, arguments[name]) for name in expected if name in outputs),
            self.returns,
        )


def sorted_constants(constants: Iterable[Whole]) -> list[Whole]:
    """Constants in the order of their declaration: grouped by type, by their numbers."""
    return sorted(set(constants), key=lambda item: (item.type.name, item.value, item.name))


STATUSES = (
    ("ok", "No error."),
    ("incomplete", "Too few words or bytes."),
    ("wrong_length", "The number of words, bytes or elements is wrong."),
    ("wrong_mark", "The frame does not begin or end with its delimiter."),
    ("not_hexadecimal", "A character is not a hexadecimal digit."),
    ("wrong_checksum", "The checksum does not match."),
    ("unknown_code", "The answer is to another message."),
    ("unknown_value", "A value is not a member of its enum, or a boolean is neither 0 nor 1."),
    ("wrong_constant", "A constant has the wrong value."),
    ("wrong_measure", "A size field does not match what it measures."),
    ("out_of_range", "A value is out of range."),
    ("no_room", "The array is too small."),
    ("refused", "The device refuses the request: the outputs say why."),
    ("not_covered", "No register lies completely in the words, or a word belongs to no register."),
    ("no_number", "A floating-point value is infinite or not a number."),
)
"""The names of the members, in the order of their numbers, and what they mean."""


class Status:
    """The enum of a device's statuses as expressions. `members` has the member of each name."""

    def __init__(self, kind: EnumType, members: dict[str, str]) -> None:
        self.type = kind
        self._numbers = {name: number for number, (name, _) in enumerate(STATUSES)}
        self._members = members

    def of(self, name: str) -> EnumMemberExpression:
        """The member of the enum for a status."""
        return EnumMemberExpression(self._members[name], self._numbers[name], self.type)

    def give(self, result: Variable, name: str) -> Body:
        """The statements that return a status."""
        return (Assignment(result, self.of(name)), Return())

    def refuse(self, result: Variable, test: Expression, name: str) -> Statement:
        """The statement that returns a status where a test holds."""
        return Condition(((test, self.give(result, name)),))

    def passed_on(self, result: Variable, status: Expression) -> Statement:
        """The statement that returns the status of another routine unless it is ok."""
        return when(status.compared("<>", self.of("ok")), (Assignment(result, status), Return()))


BASE = UINT


# Most of what there is, beside variables.
_LEAVES = frozenset({EnumMemberExpression, Fraction, Truth, Return, Remark})


def called(routine: Routine) -> set[str]:
    """The names of the routines that a routine calls."""
    return _names(routine.body)[0]


def used(body: Body) -> set[str]:
    """The names of the variables in some statements."""
    return _names(body)[1]


_Names: TypeAlias = tuple[set[str], set[str], list[Whole]]

_NAMES: ByIdentity[Body, _Names] = ByIdentity(limit=1000)
"""The names in statements, which those who declare, print and choose a routine all ask for."""


def _names(body: Body) -> _Names:
    """The names of the routines that some statements call, of their variables, and of named numbers."""
    return _NAMES.get_or_compute(body, _searched)


def _searched(body: Body) -> _Names:
    routines: set[str] = set()
    numbers: list[Whole] = []
    variables: set[str] = set()
    left: list[Statement | Expression] = [*body]
    while left:
        node = left.pop()
        if node.__class__ in _LEAVES:
            continue
        if isinstance(node, Variable):
            variables.add(node.name)
        elif isinstance(node, Whole):
            numbers += [node] if node.name else []
        elif isinstance(node, Assignment):
            left += (node.target, node.value)
        elif isinstance(node, Operation):
            left += node.operands
        elif isinstance(node, Member | Negation | Shift | Conversion):
            left.append(node.of)
        elif isinstance(node, Element):
            left += (node.of, node.index)
        elif isinstance(node, Condition):
            for test, body in node.branches:
                left.append(test)
                left += body
            left += node.otherwise
        elif isinstance(node, Call):
            routines.add(node.routine)
            left += [argument for _, argument in (*node.inputs, *node.outputs)]
        elif isinstance(node, Region):
            left += node.body
        elif isinstance(node, Timing):
            left += (node.timer, node.running, node.time)
        elif isinstance(node, Invocation):
            left += (node.block, *(argument for _, argument in node.arguments))
        elif isinstance(node, Loop):
            left += (node.index, node.first, node.last, *node.body)
        elif isinstance(node, Selection):
            left.append(node.of)
            for _, body in node.branches:
                left += body
            left += node.otherwise
    return routines, variables, numbers


_PREFIX = re.compile("^(?:x|by|w|dw|lw|usi|ui|udi|uli|si|i|di|li|r|lr|a|e|st|t|fb)(?=[A-Z0-9])")


def bare(name: str) -> str:
    """A name without the letters of its type: `Speed` for `uiSpeed`"""
    return _PREFIX.sub("", name)


class Variables:
    """The variables of a routine while it is being made. Names are compared without their case, as all dialects do.

    Those of parameters differ without the letters of their types as well, as some dialects have them.
    """

    def __init__(self, *reserved: str) -> None:
        self.declared: list[Declared] = []
        self._names = {name.lower() for name in reserved}
        self._parameters: set[str] = set()
        self._kept: set[str] = set()
        self._shared: dict[tuple[str, Type, str], Variable] = {}

    def keep(self, *names: str) -> None:
        """Keeps the names of parameters that are declared later, so that no earlier parameter takes them."""
        self._kept.update(names)
        self._names.update(name.lower() for name in names)
        self._parameters.update(bare(name).lower() for name in names)

    def declare(self, name: str, kind: Type, role: str, remark: str = "", initial: str = "") -> Variable:
        """A new variable; where its name is taken, a number follows it."""
        if name in self._kept:
            self._kept.remove(name)
            self._names.remove(name.lower())
            self._parameters.remove(bare(name).lower())
        number, tried = 1, name
        while tried.lower() in self._names or (role != "local" and bare(tried).lower() in self._parameters):
            number += 1
            tried = f"{name}{number}"
        self._names.add(tried.lower())
        if role != "local":
            self._parameters.add(bare(tried).lower())
        variable = Variable(tried, kind)
        self.declared.append(Declared(variable, role, remark, initial))
        return variable

    def declared_once(self, name: str, kind: Type, role: str, remark: str = "", initial: str = "") -> Variable:
        """A variable that is shared by all requests for its name, type and role; `declare` shares none."""
        key = (name, kind, role)
        if key not in self._shared:
            self._shared[key] = self.declare(name, kind, role, remark, initial)
        return self._shared[key]

    def local(self, name: str, kind: Type = INT) -> Variable:
        """A local variable that is shared by all requests for its name and type."""
        return self.declared_once(name, kind, "local")

    def needed(self, body: Body) -> tuple[Declared, ...]:
        """The declared variables without the local ones that no statement uses: compilers warn of them."""
        names = used(body)
        return tuple(item for item in self.declared if item.role != "local" or item.variable.name in names)
