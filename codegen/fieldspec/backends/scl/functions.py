"""Functions that convert between the wire and values, as SCL."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.scl.project import Project
from fieldspec.diagnostics import Diagnostic
from fieldspec.plc.routines.written import written


def functions(held: Project) -> Iterator[list[str]]:
    """All functions, each behind those that it calls."""
    for routine in held.routines:
        yield written(routine, held.declared.dialect.spelling)


def clashes(held: Project) -> Iterator[Diagnostic]:
    """Functions that have the name of another one."""
    taken: set[str] = set()
    for routine in held.routines:
        if routine.name.lower() in taken:
            yield Diagnostic(
                "plc_names_distinct",
                f"two functions of {held.layout.device.id} are {routine.name} in {held.declared.dialect.title}",
                held.layout.device.place["id"],
                help="give one of the two facts that they are about another name",
            )
        taken.add(routine.name.lower())
