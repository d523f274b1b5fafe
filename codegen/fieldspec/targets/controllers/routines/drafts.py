"""Functions under construction."""

from __future__ import annotations

from collections.abc import Iterable

from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import Expression, Variable
from fieldspec.targets.controllers.statements.routine import Assignment, Routine, Statement, Variables


class Draft(Variables):
    """A routine under construction, which returns a status."""

    def __init__(self, world: World, name: str, group: str, *remarks: str) -> None:
        super().__init__(name)
        self.world, self.name, self.group, self.status = world, name, group, world.status
        self.remarks = [remark for remark in remarks if remark]
        self.result = Variable(name, world.status.type)
        self.body: list[Statement] = []

    def add(self, statements: Iterable[Statement]) -> None:
        """Appends statements."""
        self.body += statements

    def refuse(self, test: Expression, status: str) -> None:
        """Appends the statement that returns a status where a test holds."""
        self.body.append(self.status.refuse(self.result, test, status))

    def refusal(self, test: Expression, status: str) -> Statement:
        """The statement that returns a status where a test holds."""
        return self.status.refuse(self.result, test, status)

    def finished(self, last: Expression | None = None) -> Routine:
        """The finished routine, which returns the status in `last`, or ok."""
        body = (*self.body, Assignment(self.result, self.status.of("ok") if last is None else last))
        return Routine(
            self.name,
            self.group,
            self.status.type,
            self.needed(body),
            body,
            tuple(self.remarks),
        )
