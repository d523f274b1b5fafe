"""The registers that a frame reads or writes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.codec.explain import sentences
from fieldspec.codec.explain.row import ExplanationRow, Spot, fact_row
from fieldspec.codec.explain.spans import Span
from fieldspec.codec.explain.values import DecodedValue, decode_answer, decode_value, number_of
from fieldspec.codec.layout.bases import moving_tables
from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.nested_fields import NestedField, nested_fields
from fieldspec.codec.layout.record import RegisterLayout
from fieldspec.codec.layout.values import Raw
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.registers import Register, Table
from fieldspec.language.model.value import Handling, Value

FORBIDS = {("write", "ro"): sentences.READ_ONLY, ("read", "wo"): sentences.WRITE_ONLY}
"""By operation and access: what the access forbids."""


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


class RegisterRows:
    """The rows of some spans, each with its operation; they are made once, on demand."""

    __slots__ = ("_layout", "_rows", "_spans", "_spot")

    def __init__(self, layout: DeviceLayout | None, spot: Spot | None, spans: Sequence[tuple[str, Span]]) -> None:
        self._layout, self._spot, self._spans = layout, spot, spans
        self._rows: tuple[ExplanationRow, ...] | None = None

    @property
    def rows(self) -> tuple[ExplanationRow, ...]:
        """The rows, in the order of the spans."""
        if self._rows is None:
            layout, spot = self._layout, self._spot
            self._rows = (
                ()
                if layout is None or spot is None
                else tuple(
                    row for operation, span in self._spans for row in register_rows(layout, span, spot, operation)
                )
            )
        return self._rows

    def __eq__(self, other: object) -> bool:
        return isinstance(other, RegisterRows) and self.rows == other.rows

    def __hash__(self) -> int:
        return hash(self.rows)


NO_REGISTERS = RegisterRows(None, None, ())


def register_rows(layout: DeviceLayout, span: Span, spot: Spot, operation: str) -> Iterator[ExplanationRow]:
    """The rows of all registers that share words with a span, by address, and of words that no register has.

    `operation` is `read` or `write`. Registers that do not allow it have a note.
    """
    present = sorted(occupants(layout, span), key=lambda occupant: occupant.address)
    address = span.address
    for occupant in present:
        if occupant.address > address:
            yield _unlisted(layout, span, address, occupant.address, spot)
        address = max(address, occupant.address + occupant.words)
        row = _occupant_row(layout, span, occupant, spot, operation)
        reason = FORBIDS.get((operation, occupant.access), "")
        yield replace(row, notes=(*row.notes, sentences.IT.format(statement=reason))) if reason else row
    if address < span.end:
        yield _unlisted(layout, span, address, span.end, spot)


def forbidden(layout: DeviceLayout, span: Span, operation: str) -> str:
    """Why the words of a span cannot be read or written; empty if all of them can, as far as the spec says.

    A part of an atomic value can be neither read nor written.
    """
    for occupant in sorted(occupants(layout, span), key=lambda occupant: occupant.address):
        reason = FORBIDS.get((operation, occupant.access), "")
        if not reason and occupant.atomic and not _is_within(occupant, span):
            reason = f"has {occupant.words} {span.unit}s, all of which must be accessed in one request"
        if reason:
            return f"{occupant.path} at 0x{occupant.address:04X} {reason}"
    return ""


def _is_within(occupant: Occupant, span: Span) -> bool:
    """Whether a span has all words of an occupant."""
    return span.address <= occupant.address and occupant.address + occupant.words <= span.end


def occupant_at(layout: DeviceLayout, space: str, address: int) -> Occupant | None:
    """The register or the field of a table's element that begins at an address of a space; None if there is none."""
    at_address = occupants(layout, Span(space, address, 1, 0, b""))
    return next((occupant for occupant in at_address if occupant.address == address), None)


def occupants(layout: DeviceLayout, span: Span) -> Iterator[Occupant]:
    """The registers, and the fields of tables, that share words with a span, in the order of the spec.

    In a table with a variable base, only a span with the value of the base register has fields.
    """
    device = layout.device
    own = device.space_name(span.space)
    blocks = _INDEXES.get_or_compute(layout, _index).get(own, {})
    numbers = {
        number
        for block in range(span.address // _BLOCK, max(span.address, span.end - 1) // _BLOCK + 1)
        for number in blocks.get(block, ())
    }
    for number in sorted(numbers):
        yield from _elements(layout.registers[number], span)
    for table in layout.tables.values():
        located = _located(layout, table, span)
        if located is not None and device.space_name(table.table.space) == own:
            yield from _fields(located, span)


_BLOCK = 64
_INDEXES: ByIdentity[DeviceLayout, dict[str, dict[int, list[int]]]] = ByIdentity(limit=8)
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


def _located(layout: DeviceLayout, table: TableLayout, span: Span) -> TableLayout | None:
    """A table where it begins; None if only a register says where, and the span does not have it."""
    if not table.table.base_by:
        return table
    register = base_of_table(layout, table.name)
    if layout.device.space_name(register.outer.space) != layout.device.space_name(span.space):  # type: ignore[attr-defined]
        return None
    piece = span.piece(register.address, register.value.size)
    number = number_of(register.value, piece.content, register.order, register.swapped) if piece is not None else None
    if not isinstance(number, int) or register.value.ranges is None or number not in register.value.ranges:
        return None
    return replace(table, table=replace(table.table, base=number))


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


def _occupant_row(layout: DeviceLayout, span: Span, occupant: Occupant, spot: Spot, operation: str) -> ExplanationRow:
    piece = span.piece(occupant.address, occupant.value.size, occupant.skip)
    offset, raw = (piece.at, piece.raw) if piece else (0, b"")
    if piece:
        value = occupant.value.for_writing() if operation == "write" else occupant.value
        value = _by_exponent(layout, span, occupant, value)
        arguments = piece.content, occupant.order, occupant.is_swapped(operation), occupant.reserved
        if operation == "write":
            read = decode_value(layout.device, value, *arguments)
        else:
            read = decode_answer(layout.device, value, *arguments, trigger=occupant.trigger)
    else:
        is_inside = _is_within(occupant, span)
        partial = sentences.PARTIAL_ATOMIC if occupant.atomic else sentences.PARTIAL
        read = DecodedValue(None, notes=() if is_inside else (partial.format(unit=span.unit),))
    row = fact_row(layout.device, "register", occupant.path, occupant.fact, spot, offset, raw, read, occupant.outer)
    if not piece:
        row = replace(row, offset=0, can_place="")
    row = replace(row, notes=(*row.notes, *_absence(layout, span, occupant)))
    return replace(row, address=occupant.address, words=occupant.words, unit=span.unit, access=occupant.access)


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


def _absence(layout: DeviceLayout, span: Span, occupant: Occupant) -> tuple[str, ...]:
    """The note of a field in an element that the device has not got, where the span has the count, too."""
    count = count_of_occupant(layout, occupant)
    piece = span.piece(count.address, count.value.size) if count is not None else None
    if count is None or piece is None:
        return ()
    number = number_of(count.value, piece.content, count.order, count.swapped)
    return (absent_text(count, number),) if isinstance(number, int) and element_number(occupant) >= number else ()


def _by_exponent(layout: DeviceLayout, span: Span, occupant: Occupant, value: Value) -> Value:
    """A value with its scale, where the exponent is elsewhere, and the span has it, too."""
    exponent = exponent_of_occupant(layout, occupant)
    piece = span.piece(exponent.address, exponent.value.size, exponent.skip) if exponent is not None else None
    if exponent is None or piece is None:
        return value
    number = number_of(exponent.value, piece.content, exponent.order, exponent.swapped)
    return exponent_applied(value, exponent.value, number)


def exponent_applied(value: Value, exponent: Value, number: Raw | None) -> Value:
    """A value with the scale that the number of its exponent makes; unchanged for a number that is not an exponent."""
    if not isinstance(number, int) or exponent.ranges is None or number not in exponent.ranges:
        return value
    return value.scaled_by(number) if exponent.sentinel(number) is None else value


def _unlisted(layout: DeviceLayout, span: Span, first: int, end: int, spot: Spot) -> ExplanationRow:
    """The row of words that no register has, with the reasons of the gaps there."""
    reasons = (
        gap.reason
        for group in layout.device.groups
        if layout.device.space_name(group.space) == layout.device.space_name(span.space)
        for gap in group.gaps
        if any(low < end and first <= high for low, high in gap.addresses.intervals)
    )
    start, raw = span.unlisted(first, end)
    offset, length, characters = spot.place(start, len(raw)) if raw else (0, 0, "")
    return ExplanationRow(
        kind="register",
        offset=offset,
        length=length,
        raw=raw,
        characters=characters,
        can_place=spot.can_place(start) if raw else "",
        doc=sentences.UNLISTED_REGISTER,
        notes=(*reasons, *_unknown_bases(layout, span, first, end)),
        address=first,
        words=end - first,
        unit=span.unit,
    )


def _unknown_bases(layout: DeviceLayout, span: Span, first: int, end: int) -> Iterator[str]:
    """What may be at addresses: elements of tables of which the frame does not say where they begin."""
    own = layout.device.space_name(span.space)
    for name, register in moving_tables(layout).items():
        table, ranges = layout.tables[name], register.register.value.ranges
        reach = (table.table.count - 1) * table.table.stride + table.words
        if layout.device.space_name(table.table.space) != own or _located(layout, table, span) is not None:
            continue
        if any(low < end and first < high + reach for low, high in (ranges.intervals if ranges is not None else ())):
            yield sentences.ELEMENTS_OF_TABLE.format(table=name, register=register.name)
