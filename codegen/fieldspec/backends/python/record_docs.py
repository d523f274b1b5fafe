"""What the docstring of a record's class says."""

from __future__ import annotations

from fieldspec.backends.python.slots import Slots
from fieldspec.backends.python.text import availability, described, printed, sentence
from fieldspec.backends.python.units import quantity
from fieldspec.layout.record import RecordLayout
from fieldspec.names import Name


def record_doc(record: RecordLayout, stored: list[Slots], head: str, *more: str) -> list[str]:
    """The paragraphs of a class's docstring: what it is, how long, and each of its fields."""
    if record.size is not None:
        size = f"{record.size} byte{'' if record.size == 1 else 's'}."
    else:
        size = f"{record.least} to {record.most} bytes."
    first, *rest = described(head, record.record, *more)
    return [f"{first} {size}".strip(), *rest[:-1], *map(_field_doc, stored), rest[-1]]


def _field_doc(field: Slots) -> str:
    fact = field.field.field
    facts = [_type_doc(field)]
    if field.field.value is not None:
        if quantity(field.value):
            facts.append(quantity(field.value))
        if field.value.ranges is not None:
            facts.append(f"{field.value.ranges.text()}")
        if field.value.write_ranges is not None:
            facts.append(f"{field.value.write_ranges.text()} when it is written")
        facts += [f"{sentinel.text} = {Name.of(sentinel.name).title().lower()}" for sentinel in field.value.sentinels]
        if field.value.default is not None:
            facts.append(f"initially {field.value.default}")
    if fact.restart:
        facts.append("takes effect after a restart")
    notes = " ".join(f"Note: {sentence(note)}" for note in fact.notes)
    manual = f" {printed(fact)}" if printed(fact) else ""
    texts = (f"{', '.join(facts)}.", sentence(fact.doc), availability(fact), notes)
    return f" {field.name}{manual}: {' '.join(text for text in texts if text)}"


def _type_doc(field: Slots) -> str:
    named = field.field.record is not None or field.decided or field.value.enum or field.value.flags
    one = field.element_type if named else field.value.type.name
    if field.field.field.choice is not None:
        one += f", as `{field.field.field.choice.by}` says"
    if field.repeated and field.field.field.repeat is not None:
        return f"{field.field.field.repeat.text()} times {one}"
    return f"{field.count} times {one}" if field.listed else one
