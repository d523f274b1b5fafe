"""Memory areas of a device: register runs, tables and message data, with the value at each offset and its bits."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import CaseLayout, FieldLayout, RecordLayout, RegisterLayout
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.model.access import narrowed
from fieldspec.language.model.address_space import WORD
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value


@dataclass(frozen=True, slots=True)
class PlacedValue:
    """A value of `size` bytes that begins `start` bytes after the begin of its area, as on the wire.

    There are `elements` of it, `stride` bytes apart, the first numbered `first`. `order` and `swapped` are as in a
    layout. `value` is None for a check. `case` says when the value lies there, `fixed` is what it always is. `reserved`
    says that it means nothing. It has `width` bits from `shift` on, or all bits where `width` is 0.
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
    shift: int = 0
    width: int = 0

    def names(self) -> Iterator[tuple[str, int]]:
        """The name and the begin of each element."""
        for number in range(self.elements):
            name = self.name if self.elements == 1 else self.name.format(self.first + number)
            yield name, self.start + number * self.stride

    def regular(self, unit: int) -> Iterator[PlacedValue]:
        """The value, or one value for each element where these begin at different bytes of a word of `unit` bytes."""
        if self.stride % unit == 0:
            yield self
            return
        for name, start in self.names():
            yield replace(self, name=name, start=start, elements=1, stride=0)

    @property
    def title(self) -> str:
        """The name with the numbers of its elements: `points[1..127].speed`."""
        return self.name if self.elements == 1 else self.name.format(f"{self.first}..{self.first + self.elements - 1}")


def of_register(register_layout: RegisterLayout, index: int, start: int) -> PlacedValue:
    """The placed value of one element of a register."""
    register = register_layout.register
    value = register.value
    is_list = register_layout.count > 1
    return PlacedValue(
        f"{register_layout.name}[{register.index_from + index}]" if is_list else register_layout.name,
        start,
        value.size,
        value.type.name,
        register_layout.order,
        register_layout.swapped,
        register,
        value,
        access=register.access,
        fixed=value.const,
    )


def of_table(
    name: str, record: RecordLayout, access: str, count: int, stride: int, first: int
) -> Iterator[PlacedValue]:
    """The fields of a table's record; each represents the fields of all elements, `stride` bytes apart."""
    for field in record.fields:
        for inner in _of_field(field, f"{name}[{{}}]." if count > 1 else f"{name}.", 0, "", as_elements=False):
            placed_value = PlacedValue(
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
            yield placed_value


def of_record(record: RecordLayout, start: int) -> Iterator[PlacedValue]:
    """The values of a record. Equal values that follow each other are one with several elements."""
    for field in record.fields:
        yield from _of_field(field, "", start, record.selector.name if record.selector else "", as_elements=True)


def of_part(part: PartLayout, start: int, fixed: int | None) -> PlacedValue:
    """The placed value of a part of a frame."""
    value = part.value
    name = value.type.name if value is not None else f"u{8 * part.size}"
    if part.width:
        name = "bit" if part.width == 1 else "bits"
    if fixed is None and not part.reserved:
        fixed = part.constant
    return PlacedValue(
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
        shift=part.shift,
        width=part.width,
    )


def _of_field(field: FieldLayout, before: str, base: int, selector: str, as_elements: bool) -> Iterator[PlacedValue]:
    repeat = field.field.repeat
    count = field.count if field.count is not None else repeat.high if repeat is not None else 1
    start = base + field.offset
    if field.cases:
        for case in field.cases:
            yield from _elements(field, case, f"{before}{field.name}", start, count, selector, as_elements)
        return
    if field.record is None:
        yield from _elements(field, field, f"{before}{field.name}", start, count, "", as_elements)
        return
    for number in range(count):
        name = f"{before}{field.name}[{number}]." if field.is_list else f"{before}{field.name}."
        for inner in field.record.fields:
            for placed_value in _of_field(inner, name, start + number * field.size, "", as_elements=False):
                yield replace(placed_value, access=narrowed(field.field.access, placed_value.access))


def _elements(
    field: FieldLayout,
    typed: FieldLayout | CaseLayout,
    name: str,
    start: int,
    count: int,
    selector: str,
    as_elements: bool,
) -> Iterator[PlacedValue]:
    value = typed.value
    assert value is not None
    case = f"{selector}: {', '.join(typed.case.when)}" if isinstance(typed, CaseLayout) else ""
    fact = typed.case if isinstance(typed, CaseLayout) else typed.field
    spec = field.field

    def value_at(label: str, offset: int, elements: int) -> PlacedValue:
        return PlacedValue(
            label,
            offset,
            value.size,
            value.type.name,
            typed.order,
            typed.swapped,
            fact,
            value,
            spec.access,
            case,
            value.const,
            spec.reserved,
            elements,
            value.size,
        )

    if not field.is_list:
        yield value_at(name, start, 1)
    elif as_elements and count > 1:
        yield value_at(f"{name}[{{}}]", start, count)
    else:
        for number in range(count):
            yield value_at(f"{name}[{number}]", start + number * value.size, 1)


@dataclass(frozen=True, slots=True)
class Area:
    """Words that follow each other. Each holds `unit` bytes of the wire; of two, the first one is the upper half.

    `size` is in bytes. `tag` stands before the names of its values in comments. `address` is the first register's, None
    if it holds no registers.
    """

    name: str
    tag: str
    unit: int
    size: int
    values: tuple[PlacedValue, ...]
    address: int | None = None

    @property
    def words(self) -> int:
        """The number of words that the area takes."""
        return -(-self.size // self.unit)


def areas(layout: DeviceLayout) -> Iterator[Area]:
    """The areas of a device in the order of its spec: registers by address, tables, messages."""
    yield from _runs(layout)
    for table in layout.tables.values():
        yield _table(table)
    for link in layout.links.values():
        if frames_in_words(link):
            for message in link.messages.values():
                yield from _message(layout, link, message)


def frames_in_words(link: LinkLayout) -> bool:
    """Whether the bytes that a link sends equal the parts of its frames, between the delimiters."""
    return link.link.transmission == "binary" and link.link.escape is None and link.link.preamble is None


def has_frame_areas(layout: DeviceLayout, link: LinkLayout, message: MessageLayout) -> bool:
    """Whether the frames of a message on a link are areas, as far as the link allows it."""
    return next(_message(layout, link, message), None) is not None


def _runs(layout: DeviceLayout) -> Iterator[Area]:
    """Registers whose addresses follow each other, so that one request can read or write them."""
    names = list(layout.device.spaces) if layout.device.several_spaces else [""]
    for name in (name for name in names if layout.device.space(name).unit == WORD):
        yield from _runs_of(layout, name)


def _runs_of(layout: DeviceLayout, space: str) -> Iterator[Area]:
    """The runs of a space; of all registers where it has no name."""
    placed = [
        (register.address + number * register.stride, register, number)
        for register in layout.registers
        if not space or layout.device.space_name(register.register.space) == space
        for number in range(register.count)
    ]
    placed.sort(key=lambda place: place[0])
    run: list[PlacedValue] = []
    first = end = 0
    for address, register, number in placed:
        if run and address > end:
            yield _run(space, first, end, run)
            run = []
        if not run:
            first = end = address
        run.append(of_register(register, number, 2 * (address - first)))
        end = max(end, address + register.words)
    if run:
        yield _run(space, first, end, run)


def _run(space: str, first: int, end: int, run: list[PlacedValue]) -> Area:
    return Area(f"{space or 'registers'} 0x{first:04X}..0x{end - 1:04X}", "", 2, 2 * (end - first), tuple(run), first)


def _table(table_layout: TableLayout) -> Area:
    table = table_layout.table
    stride = 2 * table.stride
    values = tuple(of_table(table.name, table_layout.record, table.access, table.count, stride, table.index_from))
    return Area(f"table {table.name}", "", 2, stride * (table.count - 1) + 2 * table_layout.words, values, table.base)


def _message(layout: DeviceLayout, link: LinkLayout, message: MessageLayout) -> Iterator[Area]:
    """The frames of a message. A message that reads or writes registers has only the areas of registers."""
    if layout.device.word_access(message.message) is not None:
        return
    on_several_links = sum(message.name in other.messages for other in layout.links.values()) > 1
    for direction, sign in (("request", ">"), ("response", "<")):
        if message.name not in link.carried(direction):
            continue
        shape, data = link.frame(direction), message.data(direction)
        whole = None if data.size is None else shape.header_size + data.size + shape.trailer_size
        fixed: dict[str, int | None] = {part.name: part.number(whole) for part in shape.lengths if whole is not None}
        coded = shape.role("code")
        if coded is not None:
            fixed[coded.name] = message.message.code_of(direction)
        first = len(shape.start)
        values = [_delimiter(link, "start delimiter", shape.start, 0)] if shape.start else []
        values += [of_part(part, first + part.offset, fixed.get(part.name)) for part in shape.header]
        values += of_record(data, first + shape.header_size)
        if whole is not None:
            values += [of_part(part, first + whole + part.offset, None) for part in shape.trailer]
            values += [_delimiter(link, "end delimiter", shape.end, first + whole)] if shape.end else []
        longest = data.size if data.size is not None else data.most or data.least
        size = first + shape.header_size + longest + shape.trailer_size + len(shape.end)
        if values:
            name = f"{message.name} on {link.name}" if on_several_links else message.name
            # A frame with a check goes through a serial port, byte by byte; anything else is exchanged as words.
            unit = 1 if shape.checksum else 2
            regular_values = tuple(value for placed in values for value in placed.regular(unit))
            yield Area(f"{name} {direction}", f"{message.name}{sign}", unit, size, regular_values)


def _delimiter(link: LinkLayout, name: str, mark: bytes, start: int) -> PlacedValue:
    """The bytes that open or close a frame."""
    size = len(mark)
    kind = f"u{8 * size}" if size <= 8 else "bytes"
    return PlacedValue(name, start, size, kind, "big", False, link.link, None, fixed=int.from_bytes(mark, "big"))


Bit = tuple[int, int]
"""A word, and a bit in it; bit 0 is the least significant."""


def bits(start: int, size: int, order: str, swapped: bool, unit: int) -> tuple[Bit, ...]:
    """The bits of a number in memory, the least significant first.

    It begins at a byte of its area, whose words hold `unit` bytes each, the first one of two in the upper half.
    """
    return tuple(
        (byte // unit, 8 * (unit - 1 - byte % unit) + bit)
        for significance in range(size)
        for byte in (start + wire_byte(significance, size, order, swapped),)
        for bit in range(8)
    )


def wire_byte(significance: int, size: int, order: str, swapped: bool) -> int:
    """Which byte on the wire, from 0, is the one with a significance, from 0."""
    byte = size - 1 - significance if order == "big" else significance
    return (size // 2 - 1 - byte // 2) * 2 + byte % 2 if swapped else byte


def bits_text(bits: Sequence[Bit], first: int) -> str:
    """Bits as text, the most significant first: `15..0`, `3`, `1:15..0 0:15..0`.

    The number before a colon is that of the word, counted from `first`; it is left out where all are in that word.
    """
    runs: list[tuple[int, int, int]] = []
    for word, bit in reversed(bits):
        if runs and runs[-1][0] == word and runs[-1][2] == bit + 1:
            runs[-1] = (word, runs[-1][1], bit)
        else:
            runs.append((word, bit, bit))
    alone = all(word == first for word, _, _ in runs)
    return " ".join(("" if alone else f"{word - first}:") + _span(high, low) for word, high, low in runs)


def words(bits: Iterable[Bit]) -> int:
    """How many words some bits reach over."""
    numbers = [word for word, _ in bits]
    return max(numbers) - min(numbers) + 1


def _span(high: int, low: int) -> str:
    return str(high) if high == low else f"{high}..{low}"
