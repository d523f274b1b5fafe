"""A field, or a part of the frame, has another job: it measures, chooses, repeats, or carries something else.

Why: the same bytes are read as a length, a code, an address or a plain value.

Example: `role: plain` that becomes `role: station`, or `measures: {bytes: values}` that becomes `measures: {items:
values}`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison, Pair
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.link import Part
from fieldspec.model.message import Message
from fieldspec.model.record import Field, Measure
from fieldspec.model.value import ParameterPart


def role_changed(both: Comparison) -> Iterator[Change]:
    for part in both.of(Part):
        if part.old.role != part.new.role:
            yield _said(part, "role", "the role", part.old.role, part.new.role)
    for field in both.of(Field):
        yield from _of_field(both, field)
    for held in both.values:
        old, new = _parameter(held.old.parameter, both), _parameter(held.new.parameter, None)
        if old != new:
            text = f"{named(held.of.new)}: {turned('the part of a parameter that it is', old, new)}"
            yield change("role_changed", Effect.WIRE, held, "parameter", text, old, new)
    for message in both.of(Message):
        before, after = _access(both, message.old), _access(None, message.new)
        if before != after:
            yield _said(message, "accesses", "how it accesses registers", before, after)


def _said(pair: Pair[Part] | Pair[Field] | Pair[Message], key: str, what: str, old: str, new: str) -> Change:
    return change("role_changed", Effect.WIRE, pair, key, f"{named(pair.new)}: {turned(what, old, new)}", old, new)


def _of_field(both: Comparison, pair: Pair[Field]) -> Iterator[Change]:
    beside = pair.old.place.path.rpartition("/")[0]
    old, new = _measure(pair.old.measures), _measure(pair.new.measures)
    if pair.old.measures is not None:
        old = _measure(Measure(pair.old.measures.of, both.renamed_to(beside, pair.old.measures.field)))
    if old != new:
        yield _said(pair, "measures", "what it measures", old, new)
    by = both.renamed_to(beside, pair.old.choice.by) if pair.old.choice else ""
    if pair.old.choice and pair.new.choice and by != pair.new.choice.by:
        yield _said(pair, "choice", "what decides its type", by, pair.new.choice.by)
    same = both.renamed_to(beside.rpartition("/")[0] + "/request", pair.old.same_as) if pair.old.same_as else ""
    if same != pair.new.same_as:
        text = f"{named(pair.new)}: {turned('the field that it repeats', same, pair.new.same_as)}"
        yield change("role_changed", Effect.BEHAVIOUR, pair, "same_as", text, same, pair.new.same_as)


def _measure(measure: Measure | None) -> str:
    return f"the {measure.of} of {measure.field}" if measure else ""


def _parameter(part: ParameterPart | None, both: Comparison | None) -> str:
    if part is None:
        return ""
    held = both.renamed_to("parameters", part.set) if both else part.set
    return f"the {part.part} of {held}" + (f" by {part.number}" if part.number else "")


def _access(both: Comparison | None, message: Message) -> str:
    access = message.accesses
    if access is None:
        return ""
    words = [access.start, access.count, access.values]
    if both is not None:
        words = [_renamed(both, message, word) for word in words]
    said = ", ".join(
        f"{word} as {part}" for word, part in zip(words, ("start", "count", "values"), strict=True) if word
    )
    return f"{access.operation} with {said}"


def _renamed(both: Comparison, message: Message, name: str) -> str:
    """The new name of a field of the request or of the response."""
    asked = both.renamed_to(f"messages/{message.name}/request", name)
    return asked if asked != name else both.renamed_to(f"messages/{message.name}/response", name)
