"""Where the fields of a record lie, for decoding many records at once: one column a field."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.python.records import RecordShape
from fieldspec.backends.python.slots import Slots
from fieldspec.backends.python.text import literal
from fieldspec.backends.python.units import ratio
from fieldspec.backends.python.writing import joined, pairs, tuple_of
from fieldspec.model.primitive import Kind
from fieldspec.model.ranges import Ranges


def column_lines(shaped: RecordShape) -> list[str]:
    """An expression a field; none for records whose length varies or whose fields are all reserved."""
    if shaped.record.size is None or shaped.selector is not None:
        return []
    return [
        f"Column({', '.join([literal(field.name) if field.stored else literal(''), *_arguments(shaped, field)])})"
        for field in shaped.fields
        if field.stored or field.constant is not None or field.field.field.measures
    ]


def _arguments(shaped: RecordShape, field: Slots) -> Iterator[str]:
    """The letter of an element and its offset, then what is not usual."""
    layout = field.field
    if layout.record is not None:
        yield from (literal(""), str(layout.offset), f"record={field.element_type}", f"size={layout.size}")
    else:
        yield from (literal(field.value.type.letter), str(layout.offset))
        if field.value.type.letter == "s":
            yield f"size={layout.size}"
        if field.kind is Kind.TEXT:
            yield "text=True"
    if field.listed:
        yield f"count={field.count}"
    if layout.order == "little" and layout.size > 1 and layout.record is None:
        yield 'order="little"'
    if layout.swapped:
        yield "swapped=True"
    tests = _tests(shaped, field)
    if tests:
        yield f"tests={tests}"
    if field.stored and field.whole and field.value.scaled and not field.value.enum and not field.value.flags:
        yield f"ratio={ratio(field.value)}"
        if field.sentinels:
            yield f"absent={tuple_of(field.sentinels)}"


def _tests(shaped: RecordShape, field: Slots) -> str:
    """The intervals outside of which one record alone would be refused when it is decoded."""
    measure = field.field.field.measures
    if measure is not None:
        other = next(one for one in shaped.fields if one.title == measure.field)
        size = max(other.count, 1) * (other.field.size if measure.of == "bytes" else 1)
        return pairs(Ranges(((size, size),)))
    if field.constant is not None:
        return pairs(Ranges(((field.constant, field.constant),)))
    if field.kind is Kind.BOOLEAN:
        return pairs(Ranges(((0, 1),)))
    if field.field.value is not None and field.enum is not None and not field.enum.open:
        known = [(value, value) for value in (*field.enum.values, *field.sentinels)]
        return tuple_of(f"({low}, {high})" for low, high in joined(known))
    return ""
