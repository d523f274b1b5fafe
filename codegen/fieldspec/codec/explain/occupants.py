"""The occupants of addresses: registers, and fields in elements of tables."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.explain import sentences
from fieldspec.codec.explain.spans import Span
from fieldspec.codec.explain.values import has_in_ranges, number_of
from fieldspec.codec.layout.bases import moving_tables
from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.nested_fields import NestedField, nested_fields
from fieldspec.codec.layout.record import RegisterLayout
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.registers import Register, Table
from fieldspec.language.model.value import Handling, Value


def forbidden_text(operation: str, access: str) -> str:
    """Why an access forbids an operation; empty if it does not."""
    if operation == "write" and access == "ro":
        return sentences.READ_ONLY
    return sentences.WRITE_ONLY if operation == "read" and access == "wo" else ""


@dataclass(frozen=True, slots=True)
class Occupant:
    """The occupant of an address: a register, or a field in an element of a table. Its bytes begin after `skip` bytes.

    `nested` is the field in the record of its table, or in a record in that one; None for a register.
    """

    address: int
    words: int
    path: str
    fact: Fact
    outer: Fact
    value: Value
    order: str
    swapped: bool
    access: str
    reserved: bool
    atomic: bool = False
    trigger: bool = False
    skip: int = 0
    nested: NestedField | None = None

    @property
    def handlings(self) -> tuple[Handling, ...]:
        """The handlings of its value and of the facts that hold it, the innermost one first."""
        holders = reversed(self.nested.holders) if self.nested is not None else ()
        facts = (self.fact, *(holder.field for holder in holders), *((self.outer,) if self.nested is not None else ()))
        return tuple(handling for fact in facts if (handling := getattr(fact, "handling", None)) is not None)

    def value_for(self, operation: str) -> Value:
        """The value in a `read` or a `write`, which has a range of its own."""
        return self.value.for_writing() if operation == "write" else self.value

    def is_swapped(self, operation: str) -> bool:
        """Whether the words of a value are swapped in a `read` or a `write`."""
        return self.value.write_swapped(self.swapped) if operation == "write" else self.swapped

    @property
    def restart(self) -> bool | None:
        """Whether a change takes effect after a restart; None where nothing states it."""
        if self.nested is not None:
            return self.nested.restart
        return self.outer.restart if isinstance(self.outer, Register) else None

    @property
    def clears_on_read(self) -> bool:
        """Whether reading it changes it."""
        return any(handling.clears_on_read for handling in self.handlings)


def forbidden(layout: DeviceLayout, span: Span, operation: str) -> str:
    """Why the words of a span cannot be read or written; empty if all of them can, as far as the spec says.

    A part of an atomic value can be neither read nor written.
    """
    for occupant in sorted(occupants(layout, span), key=lambda occupant: occupant.address):
        reason = forbidden_text(operation, occupant.access)
        if not reason and occupant.atomic and not is_within_span(occupant, span):
            reason = f"has {occupant.words} {span.unit}s, all of which must be accessed in one request"
        if reason:
            return f"{occupant.path} at 0x{occupant.address:04X} {reason}"
    return ""


def is_within_span(occupant: Occupant, span: Span) -> bool:
    """Whether a span has all words of an occupant."""
    return span.address <= occupant.address and occupant.address + occupant.words <= span.end


def occupant_at(layout: DeviceLayout, space: str, address: int) -> Occupant | None:
    """The register or the field of a table's element that begins at an address of a space; None if there is none."""
    neighbours = occupants(layout, Span(space, address, 1, 0, b""))
    return next((occupant for occupant in neighbours if occupant.address == address), None)


def occupants(layout: DeviceLayout, span: Span) -> Iterator[Occupant]:
    """The registers, and the fields of tables, that share words with a span, in the order of the spec.

    In a table with a variable base, only a span with the value of the base register has fields.
    """
    device = layout.device
    own = device.space_name(span.space)
    blocks = _INDEXES.get_or_compute(layout, _index).get(own, {})
    near_blocks = range(span.address // _BLOCK, max(span.address, span.end - 1) // _BLOCK + 1)
    numbers = dict.fromkeys(number for block in near_blocks for number in blocks.get(block, ()))
    for number in sorted(numbers):
        yield from _elements(layout.registers[number], span)
    for table in layout.tables.values():
        located = located_table(layout, table, span)
        if located is not None and device.space_name(table.table.space) == own:
            yield from _fields(located, span)


_BLOCK = 64
_INDEXES: ByIdentity[DeviceLayout, dict[str, dict[int, list[int]]]] = ByIdentity(8)
"""By space and block of addresses: the numbers of the registers with words there."""


def _index(layout: DeviceLayout) -> dict[str, dict[int, list[int]]]:
    result: dict[str, dict[int, list[int]]] = {}
    for number, register in enumerate(layout.registers):
        blocks = result.setdefault(layout.device.space_name(register.register.space), {})
        last = register.address + (register.count - 1) * register.stride + register.words - 1
        for block in range(register.address // _BLOCK, last // _BLOCK + 1):
            blocks.setdefault(block, []).append(number)
    return result


def base_of_table(layout: DeviceLayout, name: str) -> Occupant:
    """The register with the address of the first element of a table that moves."""
    return _first(moving_tables(layout)[name])


def _first(register: RegisterLayout) -> Occupant:
    """The first register of a layout, as what is at its address."""
    return next(_elements(register, Span(register.register.space, register.address, 1, 0, b"")))


def located_table(layout: DeviceLayout, table: TableLayout, span: Span) -> TableLayout | None:
    """A table where it begins; None if only a register says where, and the span does not have it."""
    if not table.table.base_by:
        return table
    register = base_of_table(layout, table.name)
    space = moving_tables(layout)[table.name].register.space
    if layout.device.space_name(space) != layout.device.space_name(span.space):
        return None
    piece = span.piece(register.address, register.value.size)
    number = number_of(register.value, piece.content, register.order, register.swapped) if piece is not None else None
    if not isinstance(number, int) or not has_in_ranges(register.value, number):
        return None
    return replace(table, table=replace(table.table, base=int(number)))


def _elements(register_layout: RegisterLayout, span: Span) -> Iterator[Occupant]:
    register = register_layout.register
    for number in _element_numbers(
        register_layout.address, register_layout.stride, register_layout.words, register_layout.count, span
    ):
        address = register_layout.address + number * register_layout.stride
        path = (
            register_layout.name
            if register_layout.count == 1
            else f"{register_layout.name}[{register.index_from + number}]"
        )
        fact: Fact = register
        if number < len(register.element_sources):
            fact = replace(register, sources=(register.element_sources[number],))
        yield Occupant(
            address=address,
            words=register_layout.words,
            path=path,
            fact=fact,
            outer=register,
            value=register.value,
            order=register_layout.order,
            swapped=register_layout.swapped,
            access=register.access,
            reserved=False,
            atomic=register.atomic,
            trigger=register.trigger,
        )


def _fields(table_layout: TableLayout, span: Span) -> Iterator[Occupant]:
    table = table_layout.table
    numbers = _element_numbers(table.base, table.stride, table_layout.words, table.count, span)
    nested = tuple(nested_fields(table_layout.record)) if numbers else ()
    for number in numbers:
        base = table.base + number * table.stride
        for field in nested:
            first = base + field.offset // 2
            if first < span.end and span.address < first + field.words:
                yield _field(table, field, number)


def _field(table: Table, nested: NestedField, number: int) -> Occupant:
    """A field in the element with a number, counted from 0."""
    field = nested.field
    assert field.value is not None
    return Occupant(
        table.base + number * table.stride + nested.offset // 2,
        nested.words,
        f"{table.name}[{table.index_from + number}].{nested.path}",
        field.field,
        table,
        field.value,
        field.order,
        field.swapped,
        nested.access(table.access),
        field.field.reserved,
        atomic=field.field.atomic,
        skip=nested.offset % 2,
        nested=nested,
    )


def _element_numbers(base: int, stride: int, words: int, count: int, span: Span) -> range:
    """The numbers of the elements that may share words with a span."""
    first = max(0, (span.address - base - words) // stride + 1)
    last = min(count, -(-(span.end - base) // stride))
    return range(first, max(first, last))


def exponent_of_occupant(layout: DeviceLayout, occupant: Occupant) -> Occupant | None:
    """The fact with the exponent of a value's scale: a field of the same record, or a register; None without one."""
    name = occupant.value.scale_by
    if not name:
        return None
    table = occupant.outer
    nested_exponent = occupant.nested.beside(name) if occupant.nested is not None else None
    if nested_exponent is not None and isinstance(table, Table):
        return _field(table, nested_exponent, element_number(occupant))
    return _first(next(row for row in layout.registers if row.name == name))


def element_number(occupant: Occupant) -> int:
    """How many elements of its table are before that of a field; 0 for a register."""
    table = occupant.outer
    return (occupant.address - table.base) // table.stride if isinstance(table, Table) else 0


def count_of_occupant(layout: DeviceLayout, occupant: Occupant) -> Occupant | None:
    """The register with the number of elements that the table of a field has; None where all are there."""
    table = occupant.outer
    if not isinstance(table, Table) or not table.count_by:
        return None
    return _first(next(row for row in layout.registers if row.name == table.count_by))


def absent_text(count: Occupant, number: int) -> str:
    """Why a device has not got an element: what its register of the count says."""
    return sentences.ABSENT_ELEMENT.format(count=count.path, number=number)
