"""Numbers on the wire to members of enums and back. A strict enum takes no number without such a function."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.model.enums import Enum
from fieldspec.targets.controllers.routines.world import World, raw_name
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    EnumMemberExpression,
    EnumType,
    Expression,
    Truth,
    Variable,
    Whole,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Declared, Routine, Selection, Statement


def enum_routines(world: World, enum: Enum) -> Iterator[Routine]:
    """The two functions of an enum that is a type."""
    kind = world.names.enums.get(enum.name)
    if kind is None:
        return
    yield _from_raw(world, enum, kind)
    yield _to_raw(world, enum, kind)


def _distinct_members(world: World, enum: Enum, kind: EnumType) -> list[EnumMemberExpression]:
    """The members that there are, one for each number."""
    members: dict[int, EnumMemberExpression] = {}
    for member in enum.members:
        if not member.unavailable and member.value not in members:
            members[member.value] = EnumMemberExpression(
                world.names.enum_members[enum.name][member.name], member.value, kind
            )
    return list(members.values())


def _from_raw(world: World, enum: Enum, kind: EnumType) -> Routine:
    raw = Variable(raw_name(world.raw_type(enum.name)), world.raw_type(enum.name))
    value = Variable("eValue", kind)
    name = world.routine(enum.name, "from_raw")
    result = Variable(name, BOOL)
    members = _distinct_members(world, enum, kind)
    branches: list[tuple[tuple[tuple[int, int] | EnumMemberExpression, ...], tuple[Statement, ...]]] = [
        (((member.value, member.value),), (Assignment(value, member),)) for member in members
    ]
    # What a function leaves unwritten is undefined on some controllers.
    otherwise = (*(Assignment(value, member) for member in members[:1]), Assignment(result, Truth(False)))
    return Routine(
        name,
        "enums",
        BOOL,
        (
            Declared(raw, "input", "number on the wire"),
            Declared(value, "output", "the first member where the number is not listed: not to be used then"),
        ),
        (
            Assignment(result, Truth(True)),
            Selection(raw, tuple(branches), otherwise),
        ),
        (f"The member of {kind.name} with a number; FALSE where there is none. {world.comment(enum, None)}".strip(),),
    )


def _to_raw(world: World, enum: Enum, kind: EnumType) -> Routine:
    raw = Variable(raw_name(world.raw_type(enum.name)), world.raw_type(enum.name))
    value = Variable("eValue", kind)
    name = world.routine(enum.name, "to_raw")
    result = Variable(name, BOOL)
    branches: list[tuple[tuple[tuple[int, int] | EnumMemberExpression, ...], tuple[Statement, ...]]] = [
        ((member,), (_member_or_number(raw, member),)) for member in _distinct_members(world, enum, kind)
    ]
    return Routine(
        name,
        "enums",
        BOOL,
        (Declared(value, "input"), Declared(raw, "output", "number on the wire, 0 where it is not a member")),
        (
            Assignment(result, Truth(True)),
            Selection(value, tuple(branches), (_member_or_number(raw, None), Assignment(result, Truth(False)))),
        ),
        (f"The number of a member of {kind.name}; FALSE where the variable holds none.",),
    )


def _member_or_number(raw: Variable, member: EnumMemberExpression | None) -> Statement:
    kind = raw.type
    number: Expression = Whole(member.value if member is not None else 0, kind)  # type: ignore[arg-type]
    return Assignment(raw, number)
