"""All routines of a device, each after those that it calls."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.plc.routines.checksums import checksum
from fieldspec.plc.routines.enums import enum_routines
from fieldspec.plc.routines.expressions import (
    Call,
    Conversion,
    Element,
    EnumMemberExpression,
    Expression,
    Fraction,
    Member,
    Negation,
    Operation,
    Shift,
    Truth,
    Variable,
    Whole,
)
from fieldspec.plc.routines.frames import frame_routines
from fieldspec.plc.routines.messages import message_routines, telegram_routines
from fieldspec.plc.routines.reals import real_routines
from fieldspec.plc.routines.registers import group_routines, table_routines
from fieldspec.plc.routines.routine import Assignment, Condition, Loop, Return, Routine, Selection, Statement
from fieldspec.plc.routines.scaling import scaling_routines
from fieldspec.plc.routines.world import World
from fieldspec.plc.routines.wrapping import framed

# Most of what there is.
_LEAVES = frozenset({Variable, Whole, EnumMemberExpression, Fraction, Truth, Return})


def called(routine: Routine) -> set[str]:
    """The names of the routines that it calls."""
    found: set[str] = set()
    left: list[Statement | Expression] = [*routine.body]
    while left:
        one = left.pop()
        if one.__class__ in _LEAVES:
            continue
        if isinstance(one, Assignment):
            left += (one.target, one.value)
        elif isinstance(one, Operation):
            left += one.operands
        elif isinstance(one, Member | Negation | Shift | Conversion):
            left.append(one.of)
        elif isinstance(one, Element):
            left += (one.of, one.index)
        elif isinstance(one, Condition):
            for test, body in one.branches:
                left.append(test)
                left += body
            left += one.otherwise
        elif isinstance(one, Call):
            found.add(one.routine)
            left += [given for _, given in (*one.inputs, *one.outputs)]
        elif isinstance(one, Loop):
            left += (one.first, one.last, *one.body)
        elif isinstance(one, Selection):
            left.append(one.of)
            for _, body in one.branches:
                left += body
            left += one.otherwise
    return found


def routines(world: World) -> list[Routine]:
    """The routines of a device; of those that make numbers of enums, the ones that others need."""
    made = list(_all(world))
    optional = {world.routine(enum, "to_raw") for enum in world.names.enums}
    if not optional:
        return made
    needed = set().union(*map(called, made))
    return [one for one in made if one.name in needed or one.name not in optional]


def _all(world: World) -> Iterator[Routine]:
    layout = world.layout
    for enum in layout.device.enums.values():
        yield from enum_routines(world, enum)
    yield from real_routines(world)
    yield from scaling_routines(world)
    yield from table_routines(world)
    yield from group_routines(world)
    yield from telegram_routines(world)
    links = [link for link in layout.links.values() if framed(link)]
    checks = (part.algorithm for link in links for shape in (link.request, link.response) for part in shape.parts)
    for algorithm in dict.fromkeys(one for one in checks if one):
        yield checksum(world, algorithm)
    for link in links:
        yield from frame_routines(world, link)
        yield from message_routines(world, link)
