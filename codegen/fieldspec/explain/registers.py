"""The registers that a frame reads or writes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.classes import dataclass, replace
from fieldspec.explain.row import ExplanationRow, Spot, fact_row
from fieldspec.explain.values import DecodedValue, decode_value, number_of
from fieldspec.layout.bits import unpacked_bits
from fieldspec.layout.device import DeviceLayout, TableLayout
from fieldspec.layout.record import FieldLayout, RegisterLayout
from fieldspec.layout.values import Raw
from fieldspec.model.address_space import BIT, BYTE, WORD
from fieldspec.model.fact import Fact
from fieldspec.model.record import RegisterAccess
from fieldspec.model.registers import Table
from fieldspec.model.value import Value

_PARTIAL = {
    False: "The frame contains only some of its {}s.",
    True: "The frame contains only some of its {}s, which must be accessed in one request.",
}


FORBIDS = {("write", "ro"): "can only be read", ("read", "wo"): "can only be written"}
"""By operation and access: what the access forbids."""


@dataclass(frozen=True, slots=True)
class Piece:
    """Bytes at `at` in the parts of a frame, and the bytes of the value that they carry: for a bit, one with 0 or 1."""

    at: int
    raw: bytes
    content: bytes


@dataclass(frozen=True, slots=True)
class Span:
    """`words` from `address` on in a space. `data` are their bytes in the frame, at `at` in its parts, or empty.

    In a space of bits, `words` counts these, and `bits` has those that the frame carries, in order. A single one is
    None if its number means neither 0 nor 1. In other spaces, `bits` is None. In a space of bytes, `words` counts
    bytes, and an address has a `unit_size` of 1.
    """

    space: str
    address: int
    words: int
    at: int
    data: bytes
    bits: tuple[int | None, ...] | None = None
    unit_size: int = 2

    @property
    def end(self) -> int:
        """The address behind the last word."""
        return self.address + self.words

    @property
    def unit(self) -> str:
        """The unit at one address."""
        return BIT if self.bits is not None else WORD if self.unit_size == 2 else BYTE

    def piece(self, address: int, size: int, skip: int = 0) -> Piece | None:
        """The piece of the frame with a value of `size` bytes, `skip` bytes behind an address; None unless the frame
        has all of it."""
        if self.bits is not None:
            return self._bit(address - self.address, self.bits)
        start = self.unit_size * (address - self.address) + skip
        if start < 0 or start + size > len(self.data):
            return None
        content = self.data[start : start + size]
        return Piece(self.at + start, content, content)

    def _bit(self, index: int, bits: tuple[int | None, ...]) -> Piece | None:
        bit = bits[index] if 0 <= index < len(bits) else None
        if bit is None:
            return None
        at, end = (0, len(self.data)) if len(bits) == 1 else (index // 8, index // 8 + 1)
        return Piece(self.at + at, self.data[at:end], bytes([bit]))

    def unlisted(self, first: int, end: int) -> tuple[int, bytes]:
        """The offset and the bytes of neighbouring words; none for bits, which share bytes with others."""
        piece = self.piece(first, self.unit_size * (end - first)) if self.bits is None else None
        return (piece.at, piece.raw) if piece is not None else (0, b"")


@dataclass(frozen=True, slots=True)
class Occupant:
    """What is at an address: a register, or a field in an element of a table. Its bytes begin after `skip` bytes."""

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


def accessed(
    access: RegisterAccess,
    values: Mapping[str, Raw],
    asked: Mapping[str, Raw],
    at: int,
    data: bytes,
    unit_size: int = 2,
) -> Span | None:
    """The words that a message accesses, by its own values or those of the request that it answers; None if unknown.

    `data` are the bytes of the words, at `at` in the parts; empty if the message does not carry them. In a space of
    bytes, the `unit_size` is 1.
    """
    start = values.get(access.start, asked.get(access.start))
    whole = data[: len(data) // unit_size * unit_size]
    carried = len(whole) // unit_size
    count = values.get(access.count, asked.get(access.count)) if access.count else max(carried, 1)
    if not isinstance(start, int):
        return None
    words = count if isinstance(count, int) else carried
    return Span(access.space, start, words, at, whole, unit_size=unit_size)


def accessed_bits(
    access: RegisterAccess, values: Mapping[str, Raw], asked: Mapping[str, Raw], at: int, data: bytes
) -> Span | None:
    """The same as `accessed` for a space of bits."""
    start = values.get(access.start, asked.get(access.start))
    count = values.get(access.count, asked.get(access.count)) if access.count else 1
    if not isinstance(start, int):
        return None
    if access.set is not None:
        number = values.get(access.values) if data else None
        bit = {access.set: 1, access.clear: 0}.get(number) if isinstance(number, int) else None
        return Span(access.space, start, 1, at, data, (bit,))
    words = count if isinstance(count, int) else 8 * len(data)
    return Span(access.space, start, words, at, data, tuple(unpacked_bits(data))[:words])


def register_rows(layout: DeviceLayout, span: Span, spot: Spot, operation: str) -> Iterator[ExplanationRow]:
    """The rows of all registers that share words with a span, by address, and of words that no register has.

    `operation` is `read` or `write`. Registers that do not allow it have a note.
    """
    present = sorted(occupants(layout, span), key=lambda occupant: occupant.address)
    at = span.address
    for occupant in present:
        if occupant.address > at:
            yield _unlisted(layout, span, at, occupant.address, spot)
        at = max(at, occupant.address + occupant.words)
        row = _row(layout, span, occupant, spot, operation)
        why = FORBIDS.get((operation, occupant.access), "")
        yield replace(row, notes=(*row.notes, f"It {why}.")) if why else row
    if at < span.end:
        yield _unlisted(layout, span, at, span.end, spot)


def forbidden(layout: DeviceLayout, span: Span, operation: str) -> str:
    """Why the words of a span cannot be read or written; empty if all of them can, as far as the spec says."""
    for occupant in sorted(occupants(layout, span), key=lambda occupant: occupant.address):
        why = FORBIDS.get((operation, occupant.access))
        if why:
            return f"{occupant.path} at 0x{occupant.address:04X} {why}"
    return ""


def occupant_at(layout: DeviceLayout, space: str, address: int) -> Occupant | None:
    """The register or the field of a table's element that begins at an address of a space; None if there is none."""
    at_address = occupants(layout, Span(space, address, 1, 0, b""))
    return next((occupant for occupant in at_address if occupant.address == address), None)


def occupants(layout: DeviceLayout, span: Span) -> Iterator[Occupant]:
    """The registers, and the fields of tables, that share words with a span, in the order of the spec."""
    device = layout.device
    own = device.space_name(span.space)
    for register in layout.registers:
        if device.space_name(register.register.space) != own:
            continue
        end = register.address + (register.count - 1) * register.stride + register.words
        if register.address < span.end and span.address < end:
            yield from _elements(register, span)
    for table in layout.tables.values():
        if device.space_name(table.table.space) == own:
            yield from _fields(table, span)


def _elements(register_layout: RegisterLayout, span: Span) -> Iterator[Occupant]:
    register = register_layout.register
    for number in _near(
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
    for number in _near(table.base, table.stride, table_layout.words, table.count, span):
        index = table.index_from + number
        for field in table_layout.record.fields:
            if field.value is None:
                continue
            for item in range(field.count or 0):
                path = f"{table_layout.name}[{index}].{field.name}" + (f"[{item}]" if field.is_list else "")
                occupant = _field(table_layout, field, table.address(index), item, path)
                if occupant.address < span.end and span.address < occupant.address + occupant.words:
                    yield occupant


def _field(table_layout: TableLayout, field: FieldLayout, base: int, item: int, path: str) -> Occupant:
    assert field.value is not None
    first = field.offset + item * field.size
    return Occupant(
        base + first // 2,
        (first + field.size + 1) // 2 - first // 2,
        path,
        field.field,
        table_layout.table,
        field.value,
        field.order,
        field.swapped,
        table_layout.access(field.field),
        field.field.reserved,
        atomic=field.field.atomic,
        skip=first % 2,
    )


def _near(base: int, stride: int, words: int, count: int, span: Span) -> range:
    """The numbers of the elements that may share words with a span."""
    first = max(0, (span.address - base - words) // stride + 1)
    last = min(count, -(-(span.end - base) // stride))
    return range(first, max(first, last))


def _row(layout: DeviceLayout, span: Span, occupant: Occupant, spot: Spot, operation: str) -> ExplanationRow:
    piece = span.piece(occupant.address, occupant.value.size, occupant.skip)
    at, raw = (piece.at, piece.raw) if piece else (0, b"")
    if piece:
        value = occupant.value.for_writing() if operation == "write" else occupant.value
        value = _by_exponent(layout, span, occupant, value)
        read = decode_value(layout.device, value, piece.content, occupant.order, occupant.swapped, occupant.reserved)
        if occupant.trigger and operation == "read":
            read = replace(read, verdict="", reason="")  # what starts something does not answer what was written
    else:
        inside = span.address <= occupant.address and occupant.address + occupant.words <= span.end
        read = DecodedValue(None, notes=() if inside else (_PARTIAL[occupant.atomic].format(span.unit),))
    row = fact_row(layout.device, "register", occupant.path, occupant.fact, spot, at, raw, read, occupant.outer)
    if not piece:
        row = replace(row, offset=0)
    row = replace(row, notes=(*row.notes, *_absence(layout, span, occupant)))
    return replace(row, address=occupant.address, words=occupant.words, unit=span.unit, access=occupant.access)


def exponent_of_occupant(layout: DeviceLayout, occupant: Occupant) -> Occupant | None:
    """What has the exponent of the scale of a value: a field of the same element, or a register; None without one."""
    name = occupant.value.scale_by
    if not name:
        return None
    table = occupant.outer
    if isinstance(table, Table):
        table_layout = layout.tables[table.name]
        field = table_layout.record.named(name)
        if field is not None:
            number = element_number(occupant)
            path = f"{table.name}[{table.index_from + number}].{name}"
            return _field(table_layout, field, table.base + number * table.stride, 0, path)
    register = next(row for row in layout.registers if row.name == name)
    return next(_elements(register, Span(register.register.space, register.address, 1, 0, b"")))


def element_number(occupant: Occupant) -> int:
    """How many elements of its table are before that of a field; 0 for a register."""
    table = occupant.outer
    return (occupant.address - table.base) // table.stride if isinstance(table, Table) else 0


def count_of_occupant(layout: DeviceLayout, occupant: Occupant) -> Occupant | None:
    """The register with the number of elements that the table of a field has; None where all are there."""
    table = occupant.outer
    if not isinstance(table, Table) or not table.count_by:
        return None
    register = next(row for row in layout.registers if row.name == table.count_by)
    return next(_elements(register, Span(register.register.space, register.address, 1, 0, b"")))


def absent_text(count: Occupant, number: int) -> str:
    """Why a device has not got an element: what its register of the count says."""
    return f"The device has no such element: {count.path} is {number}."


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
    """A value with the scale that the number of its exponent makes; unchanged for a number that is no exponent."""
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
    at, raw = span.unlisted(first, end)
    offset, length, characters = spot.place(at, len(raw)) if raw else (0, 0, "")
    return ExplanationRow(
        kind="register",
        offset=offset,
        length=length,
        raw=raw,
        characters=characters,
        doc="No register is listed here.",
        notes=tuple(reasons),
        address=first,
        words=end - first,
        unit=span.unit,
    )
