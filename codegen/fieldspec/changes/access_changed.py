"""Whether a register, a table, a field or a parameter can be read and written is another matter now.

Why: a program that writes what can only be read is refused by the device, or by the generated code.

Example: `access: rw` that becomes `access: ro`.

Cure: Say in the notes of the version which writes no longer work. Where the old spec was wrong, accept the change
with that reason; else give the new version a number of its own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.parameter import Parameter
from fieldspec.model.record import Field
from fieldspec.model.register import Register
from fieldspec.model.table import Table


def access_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.any_of(Register, Table, Field, Parameter):
        old, new = pair.old.access, pair.new.access
        if old != new:
            text = f"{named(pair.new)}: {turned('the access', old, new)}"
            yield change("access_changed", Effect.BEHAVIOUR, pair, "access", text, old, new)
