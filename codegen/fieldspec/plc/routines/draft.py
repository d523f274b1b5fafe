"""A routine while it is being made: its variables get names that differ, and its statements follow each other."""

from __future__ import annotations

from collections.abc import Iterable

from fieldspec.plc.routines.expressions import Expression, Variable
from fieldspec.plc.routines.routine import Declared, Routine
from fieldspec.plc.routines.statements import Assignment, Statement
from fieldspec.plc.routines.status import Status
from fieldspec.plc.routines.types import INT, Type


class Draft:
    """A routine that returns a status. Names are compared without their case, as all dialects do."""

    def __init__(self, name: str, group: str, status: Status, *remarks: str) -> None:
        self.name, self.group, self.status = name, group, status
        self.remarks = [remark for remark in remarks if remark]
        self.example: list[str] = []
        self.result = Variable(name, status.type)
        self.body: list[Statement] = []
        self._declared: list[Declared] = []
        self._names: set[str] = {name.lower()}

    def declare(self, name: str, kind: Type, role: str, remark: str = "") -> Variable:
        """A new variable; where its name is taken, a number stands behind it."""
        number, tried = 1, name
        while tried.lower() in self._names:
            number += 1
            tried = f"{name}{number}"
        self._names.add(tried.lower())
        variable = Variable(tried, kind)
        self._declared.append(Declared(variable, role, remark))
        return variable

    def local(self, name: str, kind: Type = INT) -> Variable:
        """A local variable; one that is asked for twice is the same one."""
        for one in self._declared:
            if one.role == "local" and one.variable == Variable(name, kind):
                return one.variable
        return self.declare(name, kind, "local")

    def add(self, statements: Iterable[Statement]) -> None:
        """Adds statements to the end."""
        self.body += statements

    def refuse(self, test: Expression, status: str) -> None:
        """Returns a status where a test holds."""
        self.body.append(self.status.refuse(self.result, test, status))

    def refusal(self, test: Expression, status: str) -> Statement:
        """The statement that returns a status where a test holds."""
        return self.status.refuse(self.result, test, status)

    def finished(self, last: Expression | None = None) -> Routine:
        """The routine; at its end it returns a status, where none is given that all is well."""
        body = (*self.body, Assignment(self.result, self.status.of("ok") if last is None else last))
        return Routine(
            self.name,
            self.group,
            self.status.type,
            tuple(self._declared),
            body,
            tuple(self.remarks),
            tuple(self.example),
        )
