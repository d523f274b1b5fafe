"""The registers that a frame reads or writes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.classes import dataclass, replace
from fieldspec.explain.row import ExplanationRow, Spot, fact_row
from fieldspec.explain.values import DecodedValue, decode_value
from fieldspec.layout.device import DeviceLayout, TableLayout
from fieldspec.layout.record import FieldLayout, RegisterLayout
from fieldspec.layout.values import Raw
from fieldspec.model.fact import Fact
from fieldspec.model.record import RegisterAccess
from fieldspec.model.value import Value

_PART = {
    False: "The frame holds a part of its words.",
    True: "The frame holds a part of its words, which must be accessed in one request.",
}


FORBIDS = {("write", "ro"): "can only be read", ("read", "wo"): "can only be written"}
"""What an access forbids."""


@dataclass(frozen=True, slots=True)
class Span:
    """`words` from `address` on in a space, and their bytes: `data` at `at` in the parts of the frame, or none."""

    space: str
    address: int
    words: int
    at: int
    data: bytes

    @property
    def end(self) -> int:
        """The address behind the last word."""
        return self.address + self.words

    def bytes_of(self, address: int, size: int) -> tuple[int, bytes] | None:
        """Where the bytes of a value lie in the frame, and these bytes, where the frame has all of them."""
        start = 2 * (address - self.address)
        if start < 0 or start + size > len(self.data):
            return None
        return self.at + start, self.data[start : start + size]


@dataclass(frozen=True, slots=True)
class Holder:
    """A register, or a field in an element of a table, at an address."""

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


def accessed(
    access: RegisterAccess, values: Mapping[str, Raw], asked: Mapping[str, Raw], at: int, data: bytes
) -> Span | None:
    """The words that a message accesses: its own values say which, or those of the request that it answers.

    `data` are the bytes of the words, which lie at `at`; none where the message does not carry them.
    """
    start = values.get(access.start, asked.get(access.start))
    count = values.get(access.count, asked.get(access.count)) if access.count else 1
    if not isinstance(start, int):
        return None
    words = count if isinstance(count, int) else len(data) // 2
    return Span(access.space, start, words, at, data)


def register_rows(layout: DeviceLayout, span: Span, spot: Spot, operation: str) -> Iterator[ExplanationRow]:
    """A row for every register that shares words with a span, by address; and for words that none has.

    `operation` is `read` or `write`: a note says which registers do not allow it.
    """
    held = sorted(_holders(layout, span), key=lambda holder: holder.address)
    at = span.address
    for holder in held:
        if holder.address > at:
            yield _unlisted(layout, span, at, holder.address, spot)
        at = max(at, holder.address + holder.words)
        row = _row(layout, span, holder, spot, operation)
        why = FORBIDS.get((operation, holder.access), "")
        yield replace(row, notes=(*row.notes, f"It {why}.")) if why else row
    if at < span.end:
        yield _unlisted(layout, span, at, span.end, spot)


def forbidden(layout: DeviceLayout, span: Span, operation: str) -> str:
    """Why the words of a span cannot be read, or written, at once; empty where nothing says that they cannot."""
    for holder in sorted(_holders(layout, span), key=lambda holder: holder.address):
        why = FORBIDS.get((operation, holder.access))
        if why:
            return f"{holder.path} at 0x{holder.address:04X} {why}"
    return ""


def holder_at(layout: DeviceLayout, space: str, address: int) -> Holder | None:
    """The register, or the field of a table's element, that begins at an address of a space; None for none."""
    held = _holders(layout, Span(space, address, 1, 0, b""))
    return next((holder for holder in held if holder.address == address), None)


def _holders(layout: DeviceLayout, span: Span) -> Iterator[Holder]:
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


def _elements(laid: RegisterLayout, span: Span) -> Iterator[Holder]:
    register = laid.register
    for number in _near(laid.address, laid.stride, laid.words, laid.count, span):
        address = laid.address + number * laid.stride
        path = laid.name if laid.count == 1 else f"{laid.name}[{register.index_from + number}]"
        fact: Fact = register
        if number < len(register.element_sources):
            fact = replace(register, sources=(register.element_sources[number],))
        yield Holder(
            address=address,
            words=laid.words,
            path=path,
            fact=fact,
            outer=register,
            value=register.value,
            order=laid.order,
            swapped=laid.swapped,
            access=register.access,
            reserved=False,
            atomic=register.atomic,
            trigger=register.trigger,
        )


def _fields(laid: TableLayout, span: Span) -> Iterator[Holder]:
    table = laid.table
    for number in _near(table.base, table.stride, laid.words, table.count, span):
        index = table.index_from + number
        for field in laid.record.fields:
            if field.value is None:
                continue
            for item in range(field.count or 0):
                path = f"{laid.name}[{index}].{field.name}" + (f"[{item}]" if field.is_list else "")
                holder = _field(laid, field, table.address(index), item, path)
                if holder.address < span.end and span.address < holder.address + holder.words:
                    yield holder


def _field(laid: TableLayout, field: FieldLayout, base: int, item: int, path: str) -> Holder:
    assert field.value is not None
    first = field.offset + item * field.size
    return Holder(
        base + first // 2,
        (first + field.size + 1) // 2 - first // 2,
        path,
        field.field,
        laid.table,
        field.value,
        field.order,
        field.swapped,
        laid.access(field.field),
        field.field.reserved,
    )


def _near(base: int, stride: int, words: int, count: int, span: Span) -> range:
    """The numbers of the elements that share words with a span."""
    first = max(0, (span.address - base - words) // stride + 1)
    last = min(count, -(-(span.end - base) // stride))
    return range(first, max(first, last))


def _row(layout: DeviceLayout, span: Span, holder: Holder, spot: Spot, operation: str) -> ExplanationRow:
    found = span.bytes_of(holder.address, holder.value.size)
    at, raw = found if found else (0, b"")
    if found:
        value = holder.value.for_writing() if operation == "write" else holder.value
        read = decode_value(layout.device, value, raw, holder.order, holder.swapped, holder.reserved)
        if holder.trigger and operation == "read":
            read = replace(read, verdict="", reason="")  # what starts something does not answer what was written
    else:
        inside = span.address <= holder.address and holder.address + holder.words <= span.end
        read = DecodedValue(None, notes=() if inside else (_PART[holder.atomic],))
    row = fact_row(layout.device, "register", holder.path, holder.fact, spot, at, raw, read, holder.outer)
    if not found:
        row = replace(row, offset=0)
    return replace(row, address=holder.address, words=holder.words, access=holder.access)


def _unlisted(layout: DeviceLayout, span: Span, first: int, end: int, spot: Spot) -> ExplanationRow:
    """The row of words that no register has."""
    reasons = (
        gap.reason
        for group in layout.device.groups
        if layout.device.space_name(group.space) == layout.device.space_name(span.space)
        for gap in group.gaps
        if any(low < end and first <= high for low, high in gap.addresses.intervals)
    )
    found = span.bytes_of(first, 2 * (end - first))
    offset, length, characters = spot.place(found[0], len(found[1])) if found else (0, 0, "")
    return ExplanationRow(
        kind="register",
        offset=offset,
        length=length,
        raw=found[1] if found else b"",
        characters=characters,
        doc="No register is listed here.",
        notes=tuple(reasons),
        address=first,
        words=end - first,
    )
