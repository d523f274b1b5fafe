"""Where the fields of a record and the parts of a frame lie, as far as a comparison needs it: sizes and offsets."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.classes import dataclass
from fieldspec.model.device import Device
from fieldspec.model.link import CHECK_SIZES, Part
from fieldspec.model.record import Field


@dataclass(frozen=True, slots=True)
class Laid:
    """The offsets of some fields in bytes, in their order, and their size; `open` where the last ones go on."""

    offsets: tuple[int, ...]
    size: int
    open: bool


class Sizes:
    """The sizes of one device's fields, without asking whether the device makes sense."""

    def __init__(self, device: Device) -> None:
        self._records = device.records
        self._known: dict[str, int] = {}

    def laid(self, fields: Sequence[Field | Part]) -> Laid:
        """Where some fields lie behind each other."""
        offsets = []
        at = 0
        goes_on = False
        for field in fields:
            offsets.append(at)
            if isinstance(field, Field) and field.repeat is not None:
                goes_on = True
            else:
                at += self.of(field)
        return Laid(tuple(offsets), at, goes_on)

    def of(self, field: Field | Part) -> int:
        """The bytes of a field with all its elements, or of a part of a frame; 0 for the body."""
        if isinstance(field, Part):
            if field.algorithm:
                return CHECK_SIZES.get(field.algorithm, 0)
            return field.value.size if field.value is not None else 0
        # What depends on another field lies last, and moves nothing.
        size = field.value.size if field.value is not None else self.record(field.record)
        return size * (field.count or 1)

    def record(self, name: str) -> int:
        """The bytes of a record; 0 for one that is not there, or as far as it holds itself."""
        if name not in self._known:
            self._known[name] = 0
            record = self._records.get(name)
            self._known[name] = self.laid(record.fields).size if record is not None else 0
        return self._known[name]
