"""A case of a field holds for other values of the field that decides.

Why: data of one type are read as data of another.

Example: `when: [unsigned16]` that becomes `when: [unsigned16, word]`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison, beside
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.record import Case, Field


def case_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Case):
        enum = _enum(both, pair.holder[0])
        old, new = tuple(both.renamed_to(f"enums/{enum}", name) for name in pair.old.when), pair.new.when
        if old != new:
            effect = Effect.BEHAVIOUR if set(old) <= set(new) else Effect.WIRE
            text = f"{named(pair.new)}: {turned('what it holds for', old, new)}"
            yield change("case_changed", effect, pair, "when", text, old, new)


def _enum(both: Comparison, field: Field) -> str:
    """The name of the old enum whose members are named."""
    by = field.choice.by if field.choice else ""
    values = (one.value for one in beside(field, both.old) if one.name == by)
    return next((value.enum for value in values if value is not None), "")
