"""The registers of a group among neighbouring words or bits, with the types of their variables."""

from __future__ import annotations

from collections.abc import Callable

from fieldspec.codec.layout.record import RegisterLayout
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.model.access import readable
from fieldspec.language.model.registers import RegisterGroup
from fieldspec.targets.controllers.routines.drafts import Draft
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    INT,
    UINT,
    ArrayType,
    Call,
    Expression,
    Member,
    Type,
    Variable,
    Whole,
    number,
    sequence,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Loop, Statement, when

if TYPE_CHECKING:
    from typing import TypeAlias


def register_type(world: World, register: RegisterLayout) -> Type:
    """The type of a register's variable; an array where there are several equal ones."""
    return _each(register, world.type_of(register.register.value))


def answer_type(world: World, register_layout: RegisterLayout) -> Type | None:
    """The type of a variable of its own for what the device answers, where that of the register does not hold it.

    An enumeration holds what may be written to start something, but not any number that reading may give. So what is
    read never changes what is to be written either.
    """
    register = register_layout.register
    own, answer = world.type_of(register.value), world.type_of(register.answer)
    return _each(register_layout, answer) if readable(register.access) and own != answer else None


def answer_name(register: RegisterLayout) -> str:
    """The name of the variable that holds what the device answers for a register."""
    return f"{register.name}_answer"


def _each(register: RegisterLayout, element_type: Type) -> Type:
    return sequence(register.count, element_type) if register.count > 1 else element_type


Statements: TypeAlias = Callable[[Expression, Expression], list[Statement]]
"""The statements for one register, from the index of its first word or its bit, and its variable."""


class RegisterRange:
    """The parameters that say which words or bits there are, of a function for a group.

    `room` is how many of them the array has, `unit` is `word` or `bit`, and `remark` says what the array is for.
    """

    def __init__(
        self, world: World, group: RegisterGroup, draft: Draft, array: Variable, room: int, unit: str, remark: str
    ) -> None:
        self.world, self.group, self.draft = world, group, draft
        first = f"{array.name}[0]" if unit == "word" else f"the first bit of {array.name}"
        self.address = draft.declare("uiAddress", UINT, "input", f"address of {first}")
        self.count = draft.declare("iCount", INT, "input", f"how many {unit}s there are")
        self.array = draft.declare(array.name, array.type, "in_out", remark)
        self.taken = draft.local("iTaken")
        self.at = draft.local("iAt")
        draft.refuse(self.count.compared(">", room), "no_room")
        draft.add([Assignment(self.taken, number(0))])

    def each(
        self, register: RegisterLayout, struct: Variable, answer: Type | None, statements_of: Statements
    ) -> list[Statement]:
        """The statements for a register, or for each of several equal ones, if it lies in them.

        `answer` is the type of the variable that receives what is read, where that is one of its own.
        """
        kind, name = answer or register_type(self.world, register), answer_name(register) if answer else register.name
        member = Member(struct, self.world.member(self.group.name, name), kind)
        if register.count == 1:
            return [self._if_there(register, Whole(register.address, UINT), member, statements_of)]
        index = self.draft.local("iElement")
        assert isinstance(kind, ArrayType)
        element = member.element(index)
        steps: Expression = index.converted(UINT)
        if register.stride > 1:
            steps = steps.combined("*", register.stride)
        address = self.draft.local("uiRegister", UINT)
        inner = [
            Assignment(address, Whole(register.address, UINT).combined("+", steps)),
            self._if_there(register, address, element, statements_of),
        ]
        return [Loop(index, number(0), number(register.count - 1), tuple(inner))]

    def _if_there(
        self, register: RegisterLayout, address: Expression, variable: Expression, statements_of: Statements
    ) -> Statement:
        call = Call(
            self.world.routine("holds"),
            (
                ("uiAddress", self.address),
                ("iCount", self.count),
                ("uiRegister", address),
                ("uiSize", Whole(register.words, UINT)),
            ),
            (),
            BOOL,
        )
        place = address.combined("-", self.address).converted(INT)
        return when(
            call,
            [
                Assignment(self.at, place),
                *statements_of(self.at, variable),
                Assignment(self.taken, self.taken.plus(register.words)),
            ],
        )
