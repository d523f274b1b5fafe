"""The docstring of a record class, and the columns of many records."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import (
    MACHINE_BITS,
    Digits,
    Encoding,
    Octets,
    Real,
    Sign,
    Text,
    Truth,
    Whole,
    has_magnitude,
    is_array,
    is_odd,
    is_text,
    is_truth,
    struct_letter,
)
from fieldspec.language.model.ranges import Ranges, merged
from fieldspec.targets.fact_texts import availability, described, printed, sentence
from fieldspec.targets.python.record_shape import RecordShape
from fieldspec.targets.python.registers import value_facts
from fieldspec.targets.python.scaling import ratio
from fieldspec.targets.python.slots import Slots
from fieldspec.targets.python.text import literal
from fieldspec.targets.python.writing import interval_text, pairs, tuple_of


def column_lines(shaped: RecordShape) -> list[str]:
    """One expression for each field; none for records of variable length, of reserved fields or with characters."""
    if shaped.record.size is None or shaped.selector is not None or _has_characters(shaped.record):
        return []
    return [
        f"Column({', '.join([literal(field.name) if field.stored else literal(''), *_arguments(shaped, field)])})"
        for field in shaped.fields
        if _is_column(field.field)
    ]


def _has_characters(record: RecordLayout) -> bool:
    """Whether a number of a record is sent as digits, or a text has a form of its own; also in a record within it."""
    if any(field.record is not None and _has_characters(field.record) for field in record.fields):
        return True
    values = [field.value for field in record.fields if field.value is not None]
    return any(value.digits or value.text_form is not None for value in values)


def _is_column(field: FieldLayout) -> bool:
    """Whether a field has values or tests: it is not reserved, and of a record not all fields are."""
    if field.record is not None:
        return any(map(_is_column, field.record.fields))
    return not field.field.reserved or field.field.measures is not None


def _arguments(shaped: RecordShape, field: Slots) -> Iterator[str]:
    """The letter of an element and its offset, then the arguments that differ from their defaults."""
    layout = field.field
    if layout.record is not None:
        yield from (literal(""), str(layout.offset), f"record={field.element_type}", f"size={layout.size}")
    else:
        encoding = field.value.encoding
        yield from (literal(column_letter(encoding)), str(layout.offset))
        if is_odd(encoding) or is_array(encoding):
            yield f"size={layout.size}"
        if is_text(encoding):
            yield "text=True"
        if has_magnitude(encoding):
            yield "magnitude=True"
    if field.is_list:
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
            yield f"absent={tuple_of(map(interval_text, field.sentinels))}"


def column_letter(encoding: Encoding) -> str:
    """The letter of the narrowest column that has all values of an encoding."""
    match encoding:
        case Whole():
            bits = next(bits for bits in MACHINE_BITS if bits >= encoding.bits)
            return struct_letter(Whole(bits, Sign.COMPLEMENT if encoding.sign.is_signed else Sign.NONE))
        case Real() | Truth() | Digits() | Text() | Octets():
            return struct_letter(encoding)
        case _:
            assert_never(encoding)


def _tests(shaped: RecordShape, field: Slots) -> str:
    """The intervals outside of which `decode` refuses the field."""
    measure = field.field.measure
    if measure is not None:
        other = next(candidate for candidate in shaped.fields if candidate.title == measure.field)
        size = measure.number(max(other.count, 1), other.field.size)
        return pairs(Ranges(((size, size),)))
    if field.constant is not None:
        return pairs(Ranges(((field.constant, field.constant),)))
    if field.encoding is not None and is_truth(field.encoding):
        return pairs(Ranges(((0, 1),)))
    if field.field.value is not None and field.enum is not None and not field.enum.open:
        known = [*((value, value) for value in field.enum.values), *field.sentinels]
        return tuple_of(f"({low}, {high})" for low, high in merged(known))
    return ""


def record_doc(record: RecordLayout, stored: list[Slots], head: str, *paragraphs: str) -> list[str]:
    """The paragraphs of a class's docstring: its title, its size, and each of its fields."""
    if record.size is not None:
        size = f"{record.size} byte{'' if record.size == 1 else 's'}."
    else:
        size = f"{record.least} to {record.most} bytes."
    first, *rest = described(head, record.record, *paragraphs)
    return [f"{first} {size}".strip(), *rest[:-1], *map(_field_doc, stored), rest[-1]]


def _field_doc(field: Slots) -> str:
    fact = field.field.field
    facts = [_type_doc(field)]
    if field.field.value is not None:
        facts += value_facts(field.value)
    if fact.bit_measure is not None:
        facts.append(f"contains {fact.bit_measure.text}")
    if fact.restart:
        facts.append("takes effect after a restart")
    notes = " ".join(f"Note: {sentence(note)}" for note in fact.notes)
    manual = f" {printed(fact)}" if printed(fact) else ""
    texts = (f"{', '.join(facts)}.", sentence(fact.doc), availability(fact), notes)
    return f" {field.name}{manual}: {' '.join(text for text in texts if text)}"


def _type_doc(field: Slots) -> str:
    has_class = field.field.record is not None or field.decided or field.value.enum or field.value.flags
    type_text = field.element_type if has_class else field.value.type.name
    if field.field.field.choice is not None:
        type_text += f", as `{field.field.field.choice.subject}` says"
    if field.field.field.presence is not None:
        type_text += f", if {field.field.field.presence.condition}"
    if field.field.field.continuation is not None:
        type_text += f", each followed by another one if {field.field.field.continuation.condition}"
    if field.repeated and field.field.field.repeat is not None:
        return f"{field.field.field.repeat.text()} times {type_text}"
    return f"{field.count} times {type_text}" if field.is_list else type_text
