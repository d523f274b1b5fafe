"""The values of a record, and of the records in it, each with its place."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.access import narrowed


@dataclass(frozen=True, slots=True)
class NestedField:
    """A field with a value in a record, or in a record in it; one element where it is a list.

    `path` leads to it from the record: `lead`, `part.value`, `parts[1].value`. It begins at `offset` bytes from the
    start of the whole record. `holders` are the fields with the records in which it is, the outermost one first.
    `record` is the innermost of these records, which begins at `start` bytes; `before` is its path with a dot, and
    empty for the whole record.
    """

    path: str
    field: FieldLayout
    offset: int
    holders: tuple[FieldLayout, ...]
    record: RecordLayout
    start: int
    before: str

    def access(self, container: str) -> str:
        """The access to it: what all of the container of the whole record, the holders and the field allow."""
        for holder in self.holders:
            container = narrowed(container, holder.field.access)
        return narrowed(container, self.field.field.access)

    @property
    def restart(self) -> bool | None:
        """Whether a change takes effect after a restart, as the field or the nearest holder states it."""
        fields = (self.field.field, *(holder.field for holder in reversed(self.holders)))
        return next((own.restart for own in fields if own.restart is not None), None)

    @property
    def name(self) -> str:
        """The path without the numbers of elements, which all elements of a list share: `parts.value`."""
        return ".".join((*(holder.name for holder in self.holders), self.field.name))

    @property
    def words(self) -> int:
        """The words of 16 bits that have parts of it."""
        return (self.offset + self.field.size + 1) // 2 - self.offset // 2

    def beside(self, name: str) -> NestedField | None:
        """The first element of a field of the same record; None where it has no such field with a value."""
        field = self.record.named(name)
        if field is None or field.value is None:
            return None
        offset = self.start + field.offset
        return NestedField(f"{self.before}{name}", field, offset, self.holders, self.record, self.start, self.before)


def nested_fields(record: RecordLayout) -> Iterator[NestedField]:
    """The values of a record of a table in the order of the spec, each element of a list by itself."""
    yield from _of_record(record, (), 0, "")


def _of_record(
    record: RecordLayout, holders: tuple[FieldLayout, ...], start: int, before: str
) -> Iterator[NestedField]:
    for field in record.fields:
        for number in range(field.count or 0):
            path = f"{before}{field.name}" + (f"[{number}]" if field.is_list else "")
            offset = start + field.offset + number * field.size
            if field.record is not None:
                yield from _of_record(field.record, (*holders, field), offset, f"{path}.")
            elif field.value is not None:
                yield NestedField(path, field, offset, holders, record, start, before)
