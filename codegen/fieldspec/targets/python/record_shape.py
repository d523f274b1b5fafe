"""A record as generated code sees it: its fields with their slots, and the format that packs them."""

from __future__ import annotations

from fieldspec.codec.layout.record import RecordLayout
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.targets.python.naming import TYPES, Scope
from fieldspec.targets.python.slots import Slots, Words, native_order, slots


@dataclass(frozen=True, slots=True)
class RecordShape:
    """The fields of a record in a Struct of one byte order. It does not depend on the names of the module."""

    record: RecordLayout
    order: str
    fields: tuple[Slots, ...]

    @property
    def sign(self) -> str:
        """The letter of the byte order with which the format of its Struct begins."""
        return ">" if self.order == "big" else "<"

    @property
    def tail(self) -> Slots | None:
        """The field that is repeated to the end, unless another one decides its type."""
        last = self.fields[-1] if self.fields else None
        return last if last is not None and last.repeated and not last.splits else None

    @property
    def lists(self) -> list[Slots]:
        """The lists of free length, and the records that differ in size."""
        return [field for field in self.fields if field.in_room]

    @property
    def selector(self) -> Slots | None:
        """The field that decides the type of the last one."""
        selector = self.record.selector
        return next(field for field in self.fields if field.title == selector.name) if selector is not None else None

    def selector_of(self, field: Slots) -> Slots | None:
        """The field that decides the type of another one."""
        selector = field.field.selector or (self.record.selector if field.splits else None)
        return next(own for own in self.fields if own.title == selector.name) if selector is not None else None

    @property
    def letters(self) -> str:
        """The letters of all fields except `lists` and a decided field."""
        return "".join(field.letters * field.count for field in self.fields if not field.in_room)

    @property
    def stored(self) -> list[Slots]:
        """The fields that are attributes of the class, in the order of its arguments."""
        return [field for field in self.fields if field.stored]

    @property
    def in_sent_order(self) -> list[Slots]:
        """The fields that are attributes of the class, in the order of the wire."""
        by_name = {field.title: field for field in self.stored}
        return [by_name[field.name] for field in self.record.sent_fields if field.name in by_name]


def shape(record: RecordLayout, words: Words, reserved: frozenset[str]) -> RecordShape:
    """The shape of a record; none of its attributes has a reserved name."""
    scope = Scope(reserved, TYPES)
    order = native_order(record.fields)
    fields = [slots(field, scope.take(field.name), words, order) for field in record.fields]
    selectors = {own.name for own in (record.selector, *(field.selector for field in record.fields)) if own is not None}
    deferred = [replace(field, deferred=field.deferrable and field.title not in selectors) for field in fields]
    return RecordShape(record, order, tuple(deferred))
