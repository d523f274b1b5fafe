"""The fields that say how many bytes or elements other fields of their record have."""

from __future__ import annotations

from fieldspec.language.model.encoding import is_count, is_signed, is_text
from fieldspec.language.model.record import Field, Measure, Record
from fieldspec.language.model.value import Value

COUNTING = "a binary `u8` or `u16`, or plain `digits`"
"""What such numbers are."""

_GREATEST_SIZE = 999_999_999
"""The greatest size in digits, which programs in C compute with."""


def list_count(record: Record, field: Field) -> Field | None:
    """The field before a list that decides how many elements it has if another list follows, None if there is none.

    It is a number that `can_count`, or has the number in some of its bits.
    """
    if (bits := bit_count(record, field.name)) is not None:
        return bits[0]
    for other in record.fields[: record.fields.index(field)]:
        is_measure = other.measures is not None and other.measures.field == field.name and not other.is_list
        if is_measure and other.value is not None and can_count(other.value):
            return other
    return None


def can_count(value: Value) -> bool:
    """Whether a number may say where something ends that other data follow.

    It is a binary number of one or two bytes without a sign, or decimal digits or hexadecimal ones of a fixed number.
    """
    if not is_count(value.encoding) or is_signed(value.type.encoding):
        return False
    if not value.digits:
        return value.size <= 2
    has_only_digits = not (value.width or value.places or value.has_blanks or value.is_low_first)
    return value.has_characters and has_only_digits and value.high <= _GREATEST_SIZE


def bit_count(record: Record, name: str) -> tuple[Field, Measure] | None:
    """The field that has the size of another one in some of its bits, and what they contain; None if there is none."""
    return next(((other, own) for other in record.fields if (own := other.bit_measure) and own.field == name), None)


def choice_count(record: Record, field: Field) -> Field | None:
    """The field before a single one with several types that has its number of bytes, None if there is none."""
    count = list_count(record, field) if field.choice is not None and not field.is_list else None
    is_right = count is not None and count.measures is not None and count.measures.of == "bytes"
    return count if is_right and count is not None and count.value is not None and count.value.ranges is None else None


def text_count(record: Record, field: Field) -> Field | None:
    """The field before a text that varies in width that has its number of bytes, None if there is none.

    It is a number that `can_count` and has no other meaning, or has the number in its bits.
    """
    if field.value is None or not field.value.width or not is_text(field.value.encoding):
        return None
    if (bits := bit_count(record, field.name)) is not None:
        return bits[0]
    for other in record.fields[: record.fields.index(field)]:
        value, measure = other.value, other.measures
        if measure is None or measure.field != field.name or measure.of != "bytes" or value is None or other.is_list:
            continue
        has_meaning = value.const is not None or value.enum or value.flags or value.sentinels or value.scaled
        if can_count(value) and not has_meaning and not other.reserved and measure.plus >= 0:
            return other
    return None
