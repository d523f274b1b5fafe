"""The sizes and offsets of fields that follow each other, also in a device that has findings."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.link import Part
from fieldspec.language.model.record import Field
from fieldspec.language.model.sizes import RecordSizes, part_size


@dataclass(frozen=True, slots=True)
class FieldOffsets:
    """The offsets of fields in bytes, in their order, and their size. `is_open` if the last one repeats to the end."""

    offsets: tuple[int, ...]
    size: int
    is_open: bool


def field_offsets(sizes: RecordSizes, fields: Sequence[Field | Part]) -> FieldOffsets:
    """The offsets of the fields of a record or of a message, or of the parts of a frame."""
    offsets = []
    offset = 0
    for field in fields:
        offsets.append(offset)
        offset += part_size(field) if isinstance(field, Part) else _field_size(sizes, field)
    return FieldOffsets(tuple(offsets), offset, any(isinstance(f, Field) and f.repeat is not None for f in fields))


def _field_size(sizes: RecordSizes, field: Field) -> int:
    """The bytes of a field, the fewest where they vary; 0 where nothing decides them.

    It is 0 as well for a choice and for a field that repeats: these are last in their run, and move no field of it.
    """
    if field.choice is not None or field.repeat is not None:
        return 0
    bounds = sizes.field(field)
    return bounds[0] if bounds is not None else 0
