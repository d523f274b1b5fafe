"""The sizes and offsets of fields, also in a device that does not make sense."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.classes import dataclass
from fieldspec.model.device import Device
from fieldspec.model.link import CHECKSUM_SIZES, Part
from fieldspec.model.record import Field


@dataclass(frozen=True, slots=True)
class FieldOffsets:
    """The offsets of fields in bytes, in their order, and their size. `is_open` if the last one repeats to the end."""

    offsets: tuple[int, ...]
    size: int
    is_open: bool


class Sizes:
    """The sizes of the fields of one device."""

    def __init__(self, device: Device) -> None:
        self._records = device.records
        self._known: dict[str, int] = {}

    def offsets(self, fields: Sequence[Field | Part]) -> FieldOffsets:
        """The offsets of fields that follow each other."""
        offsets = []
        at = 0
        is_open = False
        for field in fields:
            offsets.append(at)
            if isinstance(field, Field) and field.repeat is not None:
                is_open = True
            else:
                at += self.of(field)
        return FieldOffsets(tuple(offsets), at, is_open)

    def of(self, field: Field | Part) -> int:
        """The size of a field with all its elements, or of a part of a frame; 0 for the body, and for a choice."""
        if isinstance(field, Part):
            if field.algorithm:
                return CHECKSUM_SIZES.get(field.algorithm, 0)
            return field.value.size if field.value is not None else 0
        # A choice is the last field, so its size moves no other one.
        size = field.value.size if field.value is not None else self.record(field.record)
        return size * (field.count or 1)

    def record(self, name: str) -> int:
        """The size of a record; 0 for one that does not exist, or as far as it contains itself."""
        if name not in self._known:
            self._known[name] = 0
            record = self._records.get(name)
            self._known[name] = self.offsets(record.fields).size if record is not None else 0
        return self._known[name]
