"""The names of a source: what they stand for, and what cannot be is refused."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from difflib import get_close_matches
from typing import Any

from fieldspec.foundation.exhaustive import assert_never
from fieldspec.targets.controllers.sources.nodes import (
    Applied,
    Indexed,
    Inverted,
    Joined,
    Literal,
    Named,
    Source,
    SourceError,
    Term,
    Token,
    wrong,
)
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    ELEMENTARY,
    INT,
    TIMER,
    ArrayType,
    Elementary,
    Expression,
    Member,
    Operation,
    StructType,
    Truth,
    Type,
    Whole,
)
from fieldspec.targets.controllers.statements.routine import Routine

_CONVERSION = re.compile("([A-Z]+)_TO_([A-Z]+)")
_COMPARISONS = ("=", "<>", "<", ">", "<=", ">=")
Members = Mapping[str, Mapping[str, tuple[str, Type]]]
"""The members of structs, by the name of the struct and their key: how the device calls them, and their types."""


class Lookup:
    """The meanings of the names of a source while its statements are written."""

    def __init__(self, source: Source, slots: Mapping[str, Any], members: Members) -> None:
        self.source = source
        self.members: Members = {**members, TIMER.name: {"Q": ("Q", BOOL)}}
        self.scope: dict[str, Any] = {"TRUE": True, "FALSE": False, **slots}
        self.arguments: dict[str, Any] = {}
        self.trace: tuple[str, ...] = ()

    def fail(self, token: Token, text: str) -> SourceError:
        """The error for a fault in what is being written."""
        return wrong(token, text, self.trace)

    def property(self, name: str) -> Expression:
        """The expression that a property stands for."""
        return self.expression(self.source.properties[name])

    def value(self, term: Term) -> Any:
        """The object that a term names, which need not be an expression. Raises SourceError where
        nothing has the name.
        """
        if not isinstance(term, Named):
            return self.expression(term)
        token = term.token
        if term.structure is None:
            name = token.text
            if name in self.arguments:
                return self.arguments[name]
            if name in self.source.properties:
                return self.property(name)
            if name not in self.scope:
                names = (*self.arguments, *self.scope, *self.source.properties)
                raise self.fail(token, f"nothing is called {name}{near_text(name, names)}")
            if callable(self.scope[name]):
                self.scope[name] = self.scope[name]()
            return self.scope[name]
        outer = self.value(term.structure)
        if isinstance(outer, dict):
            if token.text in outer:
                return outer[token.text]
            raise self.fail(token, f"{term.structure.token.text} has no {token.text}{near_text(token.text, outer)}")
        kind = outer.type if isinstance(outer, Expression) else None
        if not isinstance(kind, StructType):
            raise self.fail(token, f"{term.structure.token.text} has no members")
        members = self.members.get(kind.name, {})
        if token.text not in members:
            raise self.fail(token, f"{kind.name} has no member {token.text}{near_text(token.text, members)}")
        return Member(outer, *members[token.text])

    def expression(self, term: Term, expected: Type | None = None) -> Expression:
        """A term as an expression; a number takes the expected type. Raises SourceError for other terms."""
        match term:
            case Named():
                value = self.value(term)
                if isinstance(value, bool):
                    return Truth(value)
                if not isinstance(value, Expression):
                    raise self.fail(term.token, f"{term.token.text} is not a value")
                return value
            case Literal():
                return self._number(term.token, expected)
            case Inverted():
                inverted = self.truth(term.operand)
                return Truth(not inverted.value) if isinstance(inverted, Truth) else inverted.negated()
            case Joined():
                return self._joined(term) if term.token.text in ("AND", "OR") else self._operation(term)
            case Applied():
                return self._call(term)
            case Indexed():
                array, index = self.expression(term.array), self.expression(term.index, INT)
                if not isinstance(array.type, ArrayType):
                    raise self.fail(term.token, f"{term.array.token.text} is not an array")
                return array.element(index)
            case _:
                assert_never(term)

    def truth(self, term: Term) -> Expression:
        """A term as a BOOL. Raises SourceError for other terms."""
        value = self.expression(term, BOOL)
        if value.type != BOOL:
            raise self.fail(term.token, f"this is {type_name(value.type)}, where a BOOL is wanted")
        return value

    def _number(self, token: Token, expected: Type | None) -> Whole:
        prefix, _, digits = token.text.rpartition("#")
        if token.kind != "number":
            raise self.fail(token, f"{token.text} is not a number; a time is only what a variable has at first")
        kind = ELEMENTARY.get(prefix.partition("#")[0], expected)
        if not isinstance(kind, Elementary):
            raise self.fail(token, f"the type of {token.text} is not clear here: write UINT#{token.text}")
        value = int(digits, 16 if prefix.endswith("16") else 10)
        if not kind.low <= value <= kind.high:
            raise self.fail(token, f"{value} is not a valid {kind.name}, which has {kind.low}..{kind.high}")
        return Whole(value, kind, prefix.endswith("16"))

    def _operation(self, term: Joined) -> Operation:
        operator = term.token.text
        typed = next((part for part in term.parts if not isinstance(part, Literal)), None)
        if typed is None:
            raise self.fail(term.token, f"both sides of {operator} are numbers")
        kind = self.expression(typed).type
        operands = tuple(self.expression(part, kind) for part in term.parts)
        for part, operand in zip(term.parts, operands, strict=True):
            if operand.type != kind:
                raise self.fail(
                    part.token, f"{type_name(kind)} {operator} {type_name(operand.type)}: convert one of them"
                )
        if operator in _COMPARISONS and operands[0] == operands[1]:
            raise self.fail(term.token, f"both sides of {operator} are the same")
        return Operation(operator, operands, BOOL if operator in _COMPARISONS else kind)

    def _joined(self, term: Joined) -> Expression:
        """AND or OR; what is known is left out, or decides: then the terms after need not exist."""
        decides = term.token.text == "OR"
        left: list[Expression] = []
        for part in term.parts:
            test = self.truth(part)
            if not isinstance(test, Truth):
                left.append(test)
            elif test.value is decides:
                return test
        if len(left) < 2:
            return left[0] if left else Truth(not decides)
        return Operation(term.token.text, tuple(left), BOOL)

    def _call(self, term: Applied) -> Expression:
        token = term.token
        conversion = _CONVERSION.fullmatch(token.text)
        if conversion is not None:
            value = self.expression(term.arguments[0].value)
            if value.type != ELEMENTARY.get(conversion[1]) or conversion[2] not in ELEMENTARY:
                raise self.fail(token, f"the value is {type_name(value.type)}")
            return value.converted(ELEMENTARY[conversion[2]])
        routine = self.value(term.routine)
        if not isinstance(routine, Routine):
            raise self.fail(token, f"{token.text} is not a function")
        roles = {item.variable.name: item.role for item in routine.declared if item.role != "local"}
        kinds = {item.variable.name: item.variable.type for item in routine.declared}
        values: dict[str, Expression] = {}
        for argument in term.arguments:
            name = argument.token.text
            if not argument.direction:
                arguments = self.value(argument.value)
            else:
                if name not in roles:
                    raise self.fail(argument.token, f"{routine.name} has no parameter {name}{near_text(name, roles)}")
                if (argument.direction == "=>") != (roles[name] == "output"):
                    raise self.fail(argument.token, f"{name} is an {roles[name]} of {routine.name}")
                arguments = {name: self.expression(argument.value, kinds[name])}
            for key, expression in arguments.items():
                if key not in roles:
                    raise self.fail(argument.token, f"{routine.name} has no parameter {key}{near_text(key, roles)}")
                if expression.type != kinds[key]:
                    types = f"{type_name(kinds[key])}, not {type_name(expression.type)}"
                    raise self.fail(argument.token, f"{key} of {routine.name} is {types}")
            values |= arguments
        if missing := [name for name in roles if name not in values]:
            raise self.fail(token, f"{routine.name} wants {', '.join(missing)} as well")
        return routine.called(**values)


def near_text(name: str, names: Iterable[str]) -> str:
    """What may be meant by a name that is not known, as the end of an error."""
    matches = get_close_matches(name, [*names], 1)
    return f": is it {matches[0]}?" if matches else f"; there is {', '.join(sorted(names))}"


def type_name(kind: Type) -> str:
    """A type in an error."""
    return "an array" if isinstance(kind, ArrayType) else kind.name
