"""Functions that convert between the wire and values, as SCL."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.scl.project import Project
from fieldspec.plc.routines.device import routines
from fieldspec.plc.routines.written import written


def functions(held: Project) -> Iterator[list[str]]:
    """All functions, each behind those that it calls."""
    for routine in routines(held.declared.world):
        yield written(routine, held.declared.dialect.spelling)
