"""The values in an area of memory, one object each."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.classes import dataclass, replace
from fieldspec.layout.frame import PartLayout
from fieldspec.layout.record import CaseLayout, FieldLayout, RecordLayout
from fieldspec.layout.register import RegisterLayout
from fieldspec.model.access import narrowed
from fieldspec.model.fact import Fact
from fieldspec.model.value import Value


@dataclass(frozen=True, slots=True)
class Held:
    """A value of `size` bytes that begins `start` bytes behind the begin of its area, as on the wire.

    There are `elements` of it, `stride` bytes apart, the first numbered `first`. `order` and `swapped` are as in a
    layout. `value` is None for a check. `case` says when the value lies there, `fixed` is what it always is. `reserved`
    says that it means nothing.
    """

    name: str
    start: int
    size: int
    type: str
    order: str
    swapped: bool
    fact: Fact
    value: Value | None
    access: str = ""
    case: str = ""
    fixed: int | None = None
    reserved: bool = False
    elements: int = 1
    stride: int = 0
    first: int = 0

    def names(self) -> Iterator[tuple[str, int]]:
        """The name and the begin of each element."""
        for number in range(self.elements):
            name = self.name if self.elements == 1 else self.name.format(self.first + number)
            yield name, self.start + number * self.stride

    def regular(self, unit: int) -> Iterator[Held]:
        """Itself, or one for each element where these do not all begin at the same byte of a word of `unit` bytes."""
        if self.stride % unit == 0:
            yield self
            return
        for name, start in self.names():
            yield replace(self, name=name, start=start, elements=1, stride=0)

    @property
    def title(self) -> str:
        """The name with the numbers of its elements: `points[1..127].speed`."""
        return self.name if self.elements == 1 else self.name.format(f"{self.first}..{self.first + self.elements - 1}")


def of_register(laid: RegisterLayout, index: int, start: int) -> Held:
    """One element of a register."""
    register = laid.register
    value = register.value
    many = laid.count > 1
    return Held(
        f"{laid.name}[{register.index_from + index}]" if many else laid.name,
        start,
        value.size,
        value.type.name,
        laid.order,
        laid.swapped,
        register,
        value,
        access=register.access,
        fixed=value.const,
    )


def of_table(name: str, record: RecordLayout, access: str, count: int, stride: int, first: int) -> Iterator[Held]:
    """The fields of a table's record; each stands for those of all elements, `stride` bytes apart."""
    for field in record.fields:
        for inner in _of_field(field, f"{name}[{{}}]." if count > 1 else f"{name}.", 0, "", listed=False):
            held = Held(
                inner.name,
                inner.start,
                inner.size,
                inner.type,
                inner.order,
                inner.swapped,
                inner.fact,
                inner.value,
                narrowed(access, inner.access),
                inner.case,
                inner.fixed,
                inner.reserved,
                count,
                stride,
                first,
            )
            yield held


def of_record(record: RecordLayout, start: int) -> Iterator[Held]:
    """The values of a record. Equal values that follow each other are one with several elements."""
    for field in record.fields:
        yield from _of_field(field, "", start, record.selector.name if record.selector else "", listed=True)


def of_part(part: PartLayout, start: int, fixed: int | None) -> Held:
    """A part of a frame."""
    value = part.value
    name = value.type.name if value is not None else f"u{8 * part.size}"
    if fixed is None and not part.reserved:
        fixed = part.constant
    return Held(
        part.name,
        start,
        part.size,
        name,
        part.order,
        False,
        part.part,
        value,
        fixed=fixed,
        reserved=part.reserved,
    )


def _of_field(field: FieldLayout, before: str, at: int, selector: str, listed: bool) -> Iterator[Held]:
    repeat = field.field.repeat
    count = field.count if field.count is not None else repeat.high if repeat is not None else 1
    start = at + field.offset
    if field.cases:
        for case in field.cases:
            yield from _elements(field, case, f"{before}{field.name}", start, count, selector, listed)
        return
    if field.record is None:
        yield from _elements(field, field, f"{before}{field.name}", start, count, "", listed)
        return
    for number in range(count):
        name = f"{before}{field.name}[{number}]." if field.listed else f"{before}{field.name}."
        for inner in field.record.fields:
            for held in _of_field(inner, name, start + number * field.size, "", listed=False):
                yield replace(held, access=narrowed(field.field.access, held.access))


def _elements(
    field: FieldLayout, held: FieldLayout | CaseLayout, name: str, start: int, count: int, selector: str, listed: bool
) -> Iterator[Held]:
    value = held.value
    assert value is not None
    case = f"{selector}: {', '.join(held.case.when)}" if isinstance(held, CaseLayout) else ""
    fact = held.case if isinstance(held, CaseLayout) else held.field
    spec = field.field

    def one(named: str, at: int, elements: int) -> Held:
        return Held(
            named,
            at,
            value.size,
            value.type.name,
            held.order,
            held.swapped,
            fact,
            value,
            spec.access,
            case,
            value.const,
            spec.reserved,
            elements,
            value.size,
        )

    if not field.listed:
        yield one(name, start, 1)
    elif listed and count > 1:
        yield one(f"{name}[{{}}]", start, count)
    else:
        for number in range(count):
            yield one(f"{name}[{number}]", start + number * value.size, 1)
