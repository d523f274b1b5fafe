"""What bits say about the elements of lists, compared with these: what is wrong, and at which byte of the record."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.codec.layout.bits import packed_size
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Any

    Wrong = tuple[str, int]


_COUNTING: ByIdentity[RecordLayout, list[FieldLayout]] = ByIdentity(1024)


def counting_fields(record: RecordLayout) -> list[FieldLayout]:
    """The fields that say how much there is of another field, or of themselves."""
    return _COUNTING.get_or_compute(
        record,
        lambda record: [
            field for field in record.fields if field.measure or field.bits_of or field.presence or field.continuation
        ],
    )


def wrong_list_bits(record: RecordLayout, values: Mapping[str, Any]) -> Wrong | None:
    """The first of the numbers of a record that is wrong about how many elements there are."""
    for field in counting_fields(record):
        wrong = wrong_bit_number(field, values) or _wrong_presence(record, field, values) or _wrong_end(field, values)
        if wrong is not None:
            return wrong
    return None


def wrong_bit_number(field: FieldLayout, values: Mapping[str, Any]) -> Wrong | None:
    """A number of bits that fill another number of bytes."""
    if not field.bits_of or packed_size(values[field.name]) == len(values[field.bits_of]):
        return None
    text = f"{field.name} is {values[field.name]}, but {field.bits_of} has {len(values[field.bits_of])} bytes"
    return text, field.offset


def _wrong_presence(record: RecordLayout, field: FieldLayout, values: Mapping[str, Any]) -> Wrong | None:
    presence = field.presence
    decider = record.named(presence.by) if presence is not None else None
    if presence is None or decider is None or presence.fits(values[presence.by], len(values[field.name])):
        return None
    text = f"{presence.text(field.name, values[presence.by])}, but there are {len(values[field.name])}"
    return text, decider.offset


def _wrong_end(field: FieldLayout, values: Mapping[str, Any]) -> Wrong | None:
    """An element that is wrong about whether another one follows."""
    continuation = field.continuation
    wrong = continuation.wrong_element(values[field.name]) if continuation is not None else None
    if continuation is None or wrong is None:
        return None
    text = continuation.text(field.name, values[field.name], wrong)
    return text, field.offset + wrong * field.size + continuation.offset
