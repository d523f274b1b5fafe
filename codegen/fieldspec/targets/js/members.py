"""The fields of a record as properties of an object, and what reading and writing them have in common."""

from __future__ import annotations

from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import Name
from fieldspec.targets.js.declaration import Names
from fieldspec.targets.js.naming import property_scope
from fieldspec.targets.js.values import Slot


@dataclass(frozen=True, slots=True)
class Member:
    """A field with its property; empty for a field that users do not see, because it is implied by the others."""

    field: FieldLayout
    key: str

    @property
    def variable(self) -> str:
        """The local variable of its value."""
        return f"{self.key or Name.of(self.field.name).camel()}_"


def members_of(record: RecordLayout) -> list[Member]:
    """The fields of a record with their properties."""
    scope = property_scope()
    return [
        Member(field, "" if _implied(field) else scope.take(Name.of(field.name).camel())) for field in record.fields
    ]


def _implied(field: FieldLayout) -> bool:
    """Whether a field follows from its constant, from another field that it measures, or has no meaning."""
    if field.field.reserved:
        return field.value is not None and not field.field.repeat
    return (field.value is not None and field.value.const is not None) or field.field.measures is not None


def slot_of(field: FieldLayout, names: Names) -> Slot:
    """The slot of a field that has a value."""
    assert field.value is not None
    return Slot(field.name, field.value, field.size, field.order, field.swapped, names.layout.device)


def shapes_of(record: RecordLayout) -> list[tuple[str, RecordLayout]]:
    """The layouts of a record that each have functions of their own, with the suffixes of these."""
    if record.selector is None:
        return [("", record)]
    shapes: list[RecordLayout] = []
    for shape in record.chosen.values():
        if not any(shape is other for other in shapes):
            shapes.append(shape)
    return [(f"Case{number}", shape) for number, shape in enumerate(shapes, 1)]


def most_bytes(record: RecordLayout) -> str:
    """The greatest size of a record as a number of JavaScript."""
    return "Infinity" if record.most is None else str(record.most)
