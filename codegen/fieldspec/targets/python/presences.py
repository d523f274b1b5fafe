"""Whether an optional field is given, and which element of a list is the last, compared with what numbers say."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.targets.python.naming import RECORD
from fieldspec.targets.python.record_shape import RecordShape, shape
from fieldspec.targets.python.slots import Slots
from fieldspec.targets.python.text import literal
from fieldspec.targets.python.writing import tuple_of


def presences(shaped: RecordShape) -> Iterator[tuple[Slots, Slots]]:
    """The fields of a record that bits of another one say are sent, or count; each with that other one."""
    by_title = {field.title: field for field in shaped.fields}
    for field in shaped.fields:
        if field.field.presence is not None:
            yield field, by_title[field.field.presence.by]


def fitting(field: Slots, number: str, elements: str, operator: str = "==") -> str:
    """The comparison of what a number says of a field with how many elements it has, or whether it has any."""
    presence = field.field.presence
    assert presence is not None
    numbers = presence.numbers
    if not numbers:
        unit = f" * {presence.unit}" if presence.unit > 1 else ""
        plus = f" {'+' if presence.plus > 0 else '-'} {abs(presence.plus)}" if presence.plus else ""
        bits = f"({number} & {presence.mask}){f' >> {presence.shift}' if presence.shift else ''}"
        return f"{bits} {operator} len({elements}){unit}{plus}"
    if presence.is_any:
        return f"(({number} & {presence.mask}) > 0) {operator} bool({elements})"
    test = f"== {numbers[0]}" if len(numbers) == 1 else f"in {tuple_of(numbers)}"
    return f"({number} & {presence.mask} {test}) {operator} bool({elements})"


def presence_tests(shaped: RecordShape, owner: str, offset: int) -> list[str]:
    """The lines that refuse an optional field in a record that has been read; only the data decide on the last one."""
    lines = []
    for field, decider in presences(shaped):
        room = shaped.record.image.room_of(field.field)
        if room is not None and room.count:
            continue
        number, elements = f"_index({owner}.{decider.slot})", f"{owner}.{field.name}"
        wrong = _wrong(field, decider, number, elements, f", {offset + decider.field.offset}")
        lines += [f"if {fitting(field, number, elements, '!=')}:", f"    raise {wrong}"]
    return lines


def presence_refusals(shaped: RecordShape) -> list[str]:
    """The expressions of the refusals of elements that are to be written: a CodecError, or None."""
    refusals = []
    deciders = {field.title: decider for field, decider in presences(shaped)}
    for field in shaped.fields:
        elements = f"self.{field.name}"
        if (decider := deciders.get(field.title)) is not None:
            number = f"_index(self.{decider.slot})"
            wrong = _wrong(field, decider, number, elements)
            refusals.append(f"({wrong} if {fitting(field, number, elements, '!=')} else None)")
        refusals += filter(None, [wrong_end(field, elements)])
    return refusals


def wrong_end(field: Slots, elements: str) -> str:
    """`_wrong_end("dife", [_index(item) for item in self.dife], 128, (128,))`: the refusal of elements that are wrong
    about whether another one follows, a CodecError or None; empty for lists that end in another way.
    """
    continuation, record = field.field.continuation, field.field.record
    if continuation is None:
        return ""
    item = "item"
    if record is not None:
        [decider] = [own for own in shape(record, field.words, RECORD).fields if own.title == continuation.presence.by]
        item = f"item.{decider.name}"
    numbers = f"[_index({item}) for item in {elements}]"
    presence = continuation.presence
    return f"_wrong_end({literal(field.title)}, {numbers}, {presence.mask}, {tuple_of(presence.numbers)})"


def _wrong(field: Slots, decider: Slots, number: str, elements: str, place: str = "") -> str:
    return f"_wrong_presence({literal(decider.title)}, {number}, {literal(field.title)}, len({elements}){place})"
