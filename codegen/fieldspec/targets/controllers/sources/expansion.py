"""Structured Text with slots as statements: its variables are declared, its actions written in their places."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from typing import Any

from fieldspec.foundation.classes import replace
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.targets.controllers.sources.lookups import Lookup, Members, near_text, type_name
from fieldspec.targets.controllers.sources.nodes import (
    Applied,
    Assigned,
    Block,
    Chosen,
    Commented,
    Entry,
    Headed,
    Indexed,
    Insertion,
    Iteration,
    Named,
    Section,
    Selected,
    Source,
    Step,
    Term,
    Timed,
    Token,
)
from fieldspec.targets.controllers.sources.syntax import parsed
from fieldspec.targets.controllers.statements.expressions import (
    ELEMENTARY,
    TIME,
    TIMER,
    ArrayType,
    Element,
    Elementary,
    EnumType,
    Expression,
    Member,
    StructType,
    Truth,
    Type,
    Variable,
)
from fieldspec.targets.controllers.statements.routine import (
    Assignment,
    Body,
    Condition,
    Declared,
    Loop,
    Region,
    Remark,
    Routine,
    Selection,
    Statement,
    Timing,
    Variables,
)
from fieldspec.targets.templates import text

_TYPES: Mapping[str, Type] = {**ELEMENTARY, "TIME": TIME, "TON": TIMER}
_WIDE = [kind.name for kind in ELEMENTARY.values() if kind.size > 4]


@cache
def source(*names: str) -> Source:
    """Sources of this folder as one, each after the one that it extends. Raises SourceError for an invalid source.

    If several actions or properties have one name, the last source counts. The late variables of the last source stand
    in front.
    """
    parts = [*{key: part for name in names for key, part in _chain(name).items()}.values()]
    return Source(
        remarks=tuple(remark for part in parts for remark in part.remarks),
        sections=[section for part in parts for section in part.sections],
        late=[section for part in reversed(parts) for section in part.late],
        actions={name: action for part in parts for name, action in part.actions.items()},
        properties={name: term for part in parts for name, term in part.properties.items()},
        body=next((part.body for part in reversed(parts) if part.body), ()),
        names={name for part in parts for name in part.names},
    )


def _chain(name: str) -> dict[str, Source]:
    """A source after those that it extends, by their names."""
    own = parsed(f"{name}.st", text(f"targets/controllers/sources/{name}.st"))
    return {**(_chain(own.extends) if own.extends else {}), name: own}


class Expansion(Lookup):
    """A source while its variables are declared and its statements are written.

    `slots` are what its braces may name: types, expressions, truths, functions, declarations, statements, and mappings
    of those. A function is called where its slot is first named, and may declare variables.
    """

    def __init__(self, source: Source, variables: Variables, slots: Mapping[str, Any], members: Members) -> None:
        super().__init__(source, slots, members)
        self.variables = variables
        self._declare(source.sections)

    def remarks(self) -> tuple[str, ...]:
        """The paragraphs of the comment."""
        texts = {key: value for key, value in self.scope.items() if isinstance(value, str)}
        remarks = (remark.format_map(texts).strip() for remark in self.source.remarks)
        return tuple(filter(None, remarks))

    def body(self) -> Body:
        """The statements, after the declarations of late variables. Raises SourceError where one cannot be."""
        self._declare(self.source.late)
        statements = self._block(self.source.body)
        for section in (*self.source.sections, *self.source.late):
            for entry in section.entries:
                if entry.kind is not None and entry.token.text not in self.source.names:
                    raise self.fail(entry.token, f"nothing uses {entry.token.text}")
        return statements

    def routine(self, name: str, group: str) -> Routine:
        """The block that the source makes."""
        body = self.body()
        return Routine(name, group, None, self.variables.needed(body), body, self.remarks())

    def action(self, name: str, **arguments: Any) -> list[Statement]:
        """The statements of an action, with its argument by the name of its parameter."""
        return self._expand(self.source.actions[name].body, arguments)

    def _expand(self, body: Block, arguments: Mapping[str, Any], *trace: str) -> list[Statement]:
        before = self.arguments, self.trace
        self.arguments, self.trace = {**self.arguments, **arguments}, (*trace, *self.trace)
        statements = self._block(body)
        self.arguments, self.trace = before
        return [*statements]

    # Declarations

    def _declare(self, sections: Iterable[Section]) -> None:
        for section in sections:
            if section.condition is None or self.truth(section.condition) == Truth(True):
                for entry in section.entries:
                    self._enter(section.role, entry)

    def _enter(self, role: str, entry: Entry) -> None:
        name = entry.token.text
        if entry.kind is None:
            declared = self.value(entry.name)
            if not isinstance(declared, Sequence) or not all(isinstance(item, Declared) for item in declared):
                raise self.fail(entry.token, "this slot is not a list of declarations")
            self.variables.declared += declared
            return
        kind = self._type(entry.kind)
        if role == "constant":
            assert entry.initial is not None
            self.scope[name] = replace(self._number(entry.initial, kind), name=name)
            return
        # What is lent is shared with the steps of the block.
        declare = self.variables.declared_once if role == "in_out" else self.variables.declare
        initial = entry.initial.text if entry.initial is not None else ""
        self.scope[name] = declare(name, kind, role, entry.remark, initial)

    def _type(self, term: Term) -> Type:
        name = term.token.text
        if isinstance(term, Named) and term.structure is None and name not in (*_TYPES, *self.scope):
            raise self.fail(term.token, f"{name} is not a type{near_text(name, _TYPES)}")
        if name in _WIDE:
            raise self.fail(term.token, f"not every controller has {name}: take the type from a slot")
        kind = _TYPES[name] if name in _TYPES else self.value(term)
        if isinstance(kind, Elementary | EnumType | StructType | ArrayType):
            return kind
        raise self.fail(term.token, f"{name} is not a type")

    # Statements

    def _block(self, steps: Block) -> Body:
        return tuple(statement for step in steps for statement in self._step(step))

    def _step(self, step: Step) -> Sequence[Statement]:
        match step:
            case Assigned():
                target = self._place(step.target)
                return (Assignment(target, self._fitting(step.target.token, target.type, step.value)),)
            case Insertion():
                return self._write(step)
            case Chosen():
                return self._choice(step)
            case Selected():
                branches = self.value(step.branches)
                return (Selection(self.expression(step.selector), branches),) if branches else ()
            case Iteration():
                index = self._place(step.index)
                first, last = (self._fitting(term.token, index.type, term) for term in (step.first, step.last))
                if not isinstance(index, Variable):
                    raise self.fail(step.index.token, "only a variable counts")
                return (Loop(index, first, last, self._block(step.body)),)
            case Timed():
                return (self._timing(step.call),)
            case Commented():
                return self._commented(step.comment, self._step(step.step))
            case Headed():
                body = self._block(step.body)
                return (Region(step.heading, body),) if body else ()
            case _:
                assert_never(step)

    def _commented(self, comment: str, statements: Sequence[Statement]) -> Sequence[Statement]:
        """Statements with their comment, unless nothing is left of them."""
        return (Remark(comment), *statements) if comment and statements else statements

    def _place(self, term: Term) -> Variable | Member | Element:
        place = self.expression(term)
        if not isinstance(place, Variable | Member | Element):
            raise self.fail(term.token, f"{term.token.text} cannot be assigned")
        return place

    def _fitting(self, token: Token, kind: Type, term: Term) -> Expression:
        value = self.expression(term, kind)
        if value.type != kind:
            raise self.fail(token, f"{type_name(kind)} := {type_name(value.type)}: convert it")
        return value

    def _timing(self, call: Applied) -> Timing:
        timer = self.expression(call.routine)
        arguments = {argument.token.text: argument.value for argument in call.arguments}
        if not isinstance(timer, Variable) or timer.type != TIMER or sorted(arguments) != ["IN", "PT"]:
            raise self.fail(call.token, "only a timer is called as a statement, with IN and PT")
        time = self.expression(arguments["PT"])
        if not isinstance(time, Variable) or time.type != TIME:
            raise self.fail(arguments["PT"].token, "PT is a variable of type TIME")
        return Timing(timer, self.truth(arguments["IN"]), time)

    def _write(self, step: Insertion) -> Sequence[Statement]:
        name, argument = step.token.text, step.argument
        is_path = isinstance(step.name, Indexed) or step.name.structure is not None
        if argument is None and (is_path or name in self.scope or name in self.arguments):
            statements = self.value(step.name)
            if not isinstance(statements, Sequence):
                raise self.fail(step.token, f"{name} has no statements")
            return statements
        action = self.source.actions.get(name)
        if action is None:
            actions = self.source.actions if argument is not None else (*self.source.actions, *self.scope)
            raise self.fail(step.token, f"no action is called {name}{near_text(name, actions)}")
        if bool(action.parameter) != (argument is not None):
            raise self.fail(step.token, f"{name} has {'one argument' if action.parameter else 'no argument'}")
        argument_text = argument.token.text if argument is not None else ""
        arguments = {action.parameter: self.value(argument)} if argument is not None else {}
        statements = self._expand(action.body, arguments, f"{name}({argument_text}), line {step.token.line}")
        return self._commented(action.comment, statements)

    def _choice(self, step: Chosen) -> Sequence[Statement]:
        """An IF without the branches that cannot be taken; the one that always is becomes its ELSE."""
        branches: list[tuple[Expression, Body]] = []
        otherwise: Body = ()
        for term, block in step.branches:
            if isinstance(term, Insertion):
                branches += self._branches(term)
                continue
            test = self.truth(term) if term is not None else Truth(True)
            if isinstance(test, Truth) and test.value:
                otherwise = self._block(block)
                break
            if not isinstance(test, Truth):
                branches.append((test, self._block(block)))
        return (Condition(tuple(branches), otherwise),) if branches else otherwise

    def _branches(self, step: Insertion) -> Sequence[tuple[Expression, Body]]:
        """The branches of the IF that an insertion is; none where nothing of it is left."""
        statements = self._write(step)
        first = statements[0] if statements else Condition(())
        if len(statements) > 1 or not isinstance(first, Condition) or first.otherwise:
            raise self.fail(step.token, f"{step.token.text} is not a single IF without ELSE")
        return first.branches
