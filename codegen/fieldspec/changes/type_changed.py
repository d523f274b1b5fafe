"""A value has another type or another size, or a record lies where another one, or a value, lay.

Why: the bytes are read as another number, and what follows them in a frame moves.

Example: `type: i16` that becomes `type: i32`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison, Pair, Values
from fieldspec.changes.finding import change, named, turned
from fieldspec.changes.nouns import ALL
from fieldspec.model.flags import Flags
from fieldspec.model.link import Part
from fieldspec.model.record import Field
from fieldspec.model.table import Table
from fieldspec.model.value import Value


def type_changed(both: Comparison) -> Iterator[Change]:
    for held in both.all_values:
        if held.old.size != held.new.size or (held.old.type != held.new.type and not held.reserved):
            yield _change(held, "type", _of(held.old), _of(held.new), named(held.of.new))
    for word in both.of(Flags):
        if word.old.type != word.new.type:
            yield _change(word, "type", word.old.type.name, word.new.type.name, named(word.new))
    for table in both.of(Table):
        record = both.renamed_to("records", table.old.record)
        if record != table.new.record:
            yield _change(table, "record", record, table.new.record, named(table.new))
    for field in both.of(Field):
        record = both.renamed_to("records", field.old.record)
        old, new = _content(field.old, record), _content(field.new, field.new.record)
        if record != field.new.record or old[0] != new[0]:
            yield _change(field, new[0], old[1], new[1], named(field.new))
    for part in both.of(Part):
        if (part.old.value is None) != (part.new.value is None):
            yield _change(part, "type", _of(part.old.value), _of(part.new.value), named(part.new))


def _of(value: Value | None) -> str:
    if value is None:
        return ""
    return value.type.name if value.type.size else f"{value.type.name} of {value.size} bytes"


def _content(field: Field, record: str) -> tuple[str, str]:
    """The key that says what lies in a field, and what that is."""
    if field.choice is not None:
        return "choice", f"a choice by {field.choice.by}"
    return ("record", record) if record else ("type", _of(field.value))


def _change(
    held: Values | Pair[Flags] | Pair[Table] | Pair[Field] | Pair[Part], key: str, old: str, new: str, name: str
) -> Change:
    return change("type_changed", Effect.WIRE, held, key, f"{name}: {turned('the type', old, new)}", old, new, ALL)
