"""What routines return: that all is well, or the first reason why nothing of it may be used."""

from __future__ import annotations

from fieldspec.plc.routines.expressions import Expression, Listed, Variable, compared
from fieldspec.plc.routines.statements import Assignment, Body, Condition, Return, Statement, when
from fieldspec.plc.routines.types import UINT, EnumType

STATUSES = (
    ("ok", "It is done."),
    ("incomplete", "There are too few words or bytes."),
    ("wrong_length", "The words, bytes or elements are not as many as they must be."),
    ("wrong_mark", "The frame does not start or end with its mark."),
    ("not_hexadecimal", "A character is no hexadecimal digit."),
    ("wrong_check", "The check at the end does not fit the bytes."),
    ("unknown_code", "The answer is to another message."),
    ("unknown_value", "A value is none of those that its enum has, or is neither 0 nor 1."),
    ("wrong_constant", "A constant has another value."),
    ("wrong_measure", "A field that holds a size does not fit what it measures."),
    ("out_of_range", "A value is out of its range."),
    ("no_room", "The array is too small."),
    ("refused", "The device refuses: the outputs say why."),
    ("not_covered", "None of the registers lies wholly in the words, or one of the words belongs to no register."),
    ("no_number", "A floating-point value is infinite or no number."),
)
"""The names of the members, in the order of their numbers, and what they mean."""


class Status:
    """The enum of a device's statuses as expressions. `members` has the member of each name."""

    def __init__(self, kind: EnumType, members: dict[str, str]) -> None:
        self.type = kind
        self._numbers = {name: number for number, (name, _) in enumerate(STATUSES)}
        self._members = members

    def of(self, name: str) -> Listed:
        """The status with a name."""
        return Listed(self._members[name], self._numbers[name], self.type)

    def give(self, result: Variable, name: str) -> Body:
        """Returns a status."""
        return (Assignment(result, self.of(name)), Return())

    def refuse(self, result: Variable, test: Expression, name: str) -> Statement:
        """Returns a status where a test holds."""
        return Condition(((test, self.give(result, name)),))

    def passed_on(self, result: Variable, status: Expression) -> Statement:
        """Returns what another routine has returned, unless all is well."""
        return when(compared(status, "<>", self.of("ok")), (Assignment(result, status), Return()))


BASE = UINT
