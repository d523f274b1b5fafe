"""Rules about the fields of records and messages."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.changes.attributes import PYTHON
from fieldspec.language.changes.change import Change, Effect
from fieldspec.language.changes.comparison import Comparison, Pair, fields_beside
from fieldspec.language.changes.descriptions import change, changed, difference_text, kind, named, path, span
from fieldspec.language.changes.evidence import enumeration
from fieldspec.language.model.link import Link
from fieldspec.language.model.record import Case, Field
from fieldspec.language.model.registers import Parameter, Register, Table


def field_moved(comparison: Comparison) -> Iterator[Change]:
    """The offsets of fields of a record or a message, or of parts of a frame, have changed.

    Why: the bytes of one field now belong to a different field.

    Example: a new field before all others, or two fields that change places.

    Fix: Put new fields after the others, or in the place of reserved ones. If the old spec was wrong, accept the change
    with that reason; otherwise, assign a new version number.
    """

    for fields in comparison.field_lists:
        if fields.moved:
            first, now, before, after = fields.moved[0]
            names = enumeration([named(new) for _, new, _, _ in fields.moved])
            container = fields.containers[1]
            text = f"{named(now)} is at offset {after}, and was at {before}"
            if len(fields.moved) > 1:
                text = f"{names} have other offsets; {text}"
            text = f"{named(container)}: {text}"
            yield Change(
                Effect.WIRE,
                kind(now),
                path(now, container),
                text,
                f"offset {before}",
                f"offset {after}",
                span(first, "name", fields.containers[0]),
                span(now, "name", container),
            )


def length_changed(comparison: Comparison) -> Iterator[Change]:
    """The length of a record, of a message's data, or of the rest of a frame has changed.

    Why: a program that waits for the old number of bytes cuts the frame short, or waits indefinitely. Generated code
    rejects frames of a different length.

    Example: a response of 10 bytes that has 12 now.

    Fix: Put new fields in the place of reserved ones. If the old spec was wrong, accept the change with that reason;
    otherwise, assign a new version number.
    """

    for fields in comparison.field_lists:
        before, after = fields.sizes
        if before != after:
            old, new = fields.containers
            subject = " ".join(word for word in ("the length of the", fields.direction or kind(new), _of(new)) if word)
            text = f"{named(new)}: {difference_text(subject, _length_text(before), _length_text(after))}"
            key = fields.direction or "fields"
            fact_path = f"{path(new, None)}/{fields.direction}".rstrip("/")
            places = span(old, key, None), span(new, key, None)
            yield Change(Effect.WIRE, kind(new), fact_path, text, _length_text(before), _length_text(after), *places)


def _of(container: object) -> str:
    return "without its data" if isinstance(container, Link) else ""


def _length_text(size: tuple[int, bool]) -> str:
    """`10 bytes`, or `2 bytes or more`"""
    number, goes_on = size
    return f"{number} byte{'' if number == 1 else 's'}" + (" or more" if goes_on else "")


def case_changed(comparison: Comparison) -> Iterator[Change]:
    """A case of a field applies to different values of the deciding field.

    Why: data of one type are read as another type.

    Example: `when: [unsigned16]` that becomes `when: [unsigned16, word]`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.of(Case):
        enum = _enum(comparison, pair.containers[0])
        old, new = tuple(comparison.renamed_to(f"enums/{enum}", name) for name in pair.old.when), pair.new.when
        if set(old) != set(new):
            effect = Effect.BEHAVIOUR if set(old) <= set(new) else Effect.WIRE
            yield from changed(effect, pair, "when", "what it applies to", old, new)


def _enum(comparison: Comparison, field: Field) -> str:
    """The name of the old enum whose members the cases name."""
    choice = field.choice
    if choice is None:
        return ""
    selector = next((own for own in fields_beside(field, comparison.old) if own.name == choice.by), None)
    return choice.enum_of(selector, comparison.old.flags)


def count_changed(comparison: Comparison) -> Iterator[Change]:
    """A register, a table, a field or a parameter has more or fewer elements, or a different register contains their
    number.

    Why: with fewer elements, programs use addresses without a meaning. A field with more or fewer elements moves all
    following fields.

    Example: `count: 127` of a table that becomes `count: 255`.

    Fix: Nothing to do if registers, tables and parameters grow. If the old spec was wrong, accept the change with that
    reason; otherwise, assign a new version number.
    """

    for pair in comparison.any_of(Register, Table, Parameter):
        yield from _grown(pair, "count", pair.old.count, pair.new.count)
    for table in comparison.of(Table):
        old = comparison.renamed_to("registers", table.old.count_by) if table.old.count_by else ""
        yield from changed(Effect.WIRE, table, "count_by", "the register of its count", old, table.new.count_by)
    for parameter in comparison.of(Parameter):
        yield from _grown(parameter, "elements", parameter.old.elements or 1, parameter.new.elements or 1)
    for field in comparison.of(Field):
        yield from _in_frame(field)


def _grown(pair: Pair[Register] | Pair[Table] | Pair[Parameter], key: str, old: int, new: int) -> Iterator[Change]:
    effect = Effect.BEHAVIOUR if new > old else Effect.WIRE
    yield from changed(effect, pair, key, "the number of elements", old, new)


def _in_frame(pair: Pair[Field]) -> Iterator[Change]:
    if (pair.old.repeat is None) != (pair.new.repeat is None):
        goes_on = pair.new.repeat is not None
        text = "continues to the end of the data" if goes_on else "no longer continues to the end of the data"
        yield change(Effect.WIRE, pair, "repeat", f"{named(pair.new)} {text}", pair.old.repeat, pair.new.repeat)
    elif pair.old.count != pair.new.count:
        same = (pair.old.count or 1) == (pair.new.count or 1)
        effect, outputs = (Effect.SOURCE, (PYTHON,)) if same else (Effect.WIRE, ())
        yield from changed(effect, pair, "count", "the number of elements", pair.old.count, pair.new.count, outputs)
