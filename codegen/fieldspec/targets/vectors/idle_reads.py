"""Reads of the registers of an idle device, block by block of its read plan: requests, responses, and values."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.bits import packed_bits
from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.read_plan import ReadBlock, read_plan
from fieldspec.codec.layout.record import FieldLayout, RecordLayout, RegisterLayout
from fieldspec.codec.layout.values import Raw
from fieldspec.codec.layout.word_digits import has_word_digits
from fieldspec.codec.reference.frames import FrameCodec
from fieldspec.codec.reference.records import CodecError, decoded, decoded_value, encoded
from fieldspec.codec.reference.structs import value_construct
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_array
from fieldspec.language.model.record import RegisterAccess
from fieldspec.language.model.value import Value


@dataclass(frozen=True, slots=True)
class IdleRead:
    """A block of registers, the request that reads it, the response of an idle device, and what they mean.

    `values` has the raw value of each register, element of a register, and element of a table in the block by name; for
    an element that is only partly in the block, the values of its fields.
    """

    block: ReadBlock
    link: str
    request: bytes
    response: bytes
    request_values: dict[str, Raw]
    response_values: dict[str, Raw]
    values: dict[str, Raw]


def idle_reads(layout: DeviceLayout) -> Iterator[IdleRead]:
    """One read of each block on the first link that carries its message; of equal elements of a table, the first one.

    An idle device answers 0 where writing starts something, else the initial value, else the least legal one. A block
    is left out where the message refuses these values, or has fields of which nothing says what they are in a read.
    """
    read_tables: set[tuple[str, ...]] = set()
    for block in read_plan(layout).blocks:
        link = next((link for link in layout.links.values() if block.message in link.messages), None)
        shape = tuple(name.partition("[")[0] + name.rpartition("]")[2] for name in block.names)
        if link is None or ("[" in block.names[0] and shape in read_tables):
            continue
        read_tables.add(shape)
        try:
            read = _idle_read(layout, link, block)
        except CodecError:
            continue
        yield read


def _idle_read(layout: DeviceLayout, link: LinkLayout, block: ReadBlock) -> IdleRead:
    message = layout.messages[block.message]
    access = message.message.single_access
    assert access is not None
    values, words = _words(layout, block)
    codec = FrameCodec(layout, link)
    arguments: dict[str, Raw] = {access.start: block.start}
    if access.count:
        arguments[access.count] = block.words
    is_bits = layout.device.bit_access(message.message) is not None
    answer = _answer_of_bits(access, words) if is_bits else _answer(access, message.response, words)
    request = _frame(codec, "request", block.message, arguments)
    response = _frame(codec, "response", block.message, {**arguments, **answer})
    decoded_request, decoded_response = (
        codec.decode(frame, direction, block.message)
        for frame, direction in ((request, "request"), (response, "response"))
    )
    return IdleRead(
        block,
        link.name,
        request,
        response,
        {**decoded_request.head, **decoded_request.values},
        {**decoded_response.head, **decoded_response.values},
        values,
    )


def _answer(access: RegisterAccess, record: RecordLayout, words: bytes) -> dict[str, Raw]:
    field = record.named(access.values)
    assert field is not None
    assert field.value is not None
    order = ("little" if field.value.is_low_first else "big") if has_word_digits(field) else field.order
    size = field.value.type.size
    numbers: list[Raw] = [int.from_bytes(words[offset : offset + size], order) for offset in range(0, len(words), size)]  # type: ignore[arg-type]
    return {field.name: numbers if field.is_list else numbers[0]}


def _answer_of_bits(access: RegisterAccess, words: bytes) -> dict[str, Raw]:
    bits = [int(any(words[offset : offset + 2])) for offset in range(0, len(words), 2)]
    if access.set is not None:
        return {access.values: access.set if bits[0] else access.clear}
    return {access.values: list(packed_bits(bits))}


def _frame(codec: FrameCodec, direction: str, message: str, values: dict[str, Raw]) -> bytes:
    """A frame of a message; its parts have their least legal values, and the body the matching `values`."""
    body = codec.link.messages[message].data(direction)
    parts = codec.link.frame(direction).parts
    own = {name: value for name, value in values.items() if body.named(name) is not None}
    own = {**_idle_record(codec.layout.device, body), **own}
    heads = {part.name: _least_of_part(codec, part) for part in parts if part.is_argument}
    return codec.encode(direction, message, {**heads, **own})


def _least_of_part(codec: FrameCodec, part: PartLayout) -> int:
    addresses = codec.link.link.unit_addresses if part.role == "unit_address" else None
    ranges = addresses.ranges if addresses is not None else None
    assert part.value is not None
    ranges = ranges or part.value.ranges
    return ranges.low if ranges is not None else max(0, part.value.type.low)


def _words(layout: DeviceLayout, block: ReadBlock) -> tuple[dict[str, Raw], bytes]:
    """The values in a block by their names, and its words as the bytes of the wire."""
    values: dict[str, Raw] = {}
    size = layout.device.space(block.space).unit_size
    data = bytearray(size * block.words)
    for name, address, raw_bytes, value in _contents(layout, block):
        offset = size * (address - block.start)
        data[offset : offset + len(raw_bytes)] = raw_bytes
        values[name] = value
    return values, bytes(data)


def _contents(layout: DeviceLayout, block: ReadBlock) -> Iterator[tuple[str, int, bytes, Raw]]:
    device = layout.device
    for register in layout.registers:
        if _space(device, register.register.space) != block.space:
            continue
        for number in range(register.count):
            address = register.address + number * register.stride
            if block.start <= address and address + register.words <= block.end:
                element = f"[{register.register.index_from + number}]" if register.count > 1 else ""
                yield f"{register.name}{element}", address, *_of_register(device, register)
    for table in layout.tables.values():
        if _space(device, table.table.space) != block.space or table.table.base_by:
            continue
        for index in table.table.indexes:
            yield from _of_element(device, table, index, block)


def _of_element(
    device: Device, table: TableLayout, index: int, block: ReadBlock
) -> Iterator[tuple[str, int, bytes, Raw]]:
    """An element of a table that a block reads whole, or the fields of it that are in the block."""
    first = table.table.address(index)
    if first >= block.end or first + table.words <= block.start:
        return
    data = encoded(table.record, _idle_record(device, table.record), device)
    values = decoded(table.record, data, device)
    name = f"{table.name}[{index}]"
    if block.start <= first and first + table.words <= block.end:
        yield name, first, data, values
        return
    for offset, words, fields in table.word_runs():
        if block.start <= first + offset and first + offset + words <= block.end:
            for field in fields:
                yield (
                    f"{name}.{field.name}",
                    first + offset,
                    data[2 * offset : 2 * (offset + words)],
                    values[field.name],
                )


def _space(device: Device, name: str) -> str:
    return device.space_name(name) if device.several_spaces else ""


def _of_register(device: Device, register: RegisterLayout) -> tuple[bytes, Raw]:
    answer = register.register.answer
    construct = value_construct(answer, register.order, register.swapped)
    data: bytes = construct.build(_idle(device, answer, register.register.trigger))
    return data, decoded_value(register.name, answer, construct.parse(data), device, None)


def _idle_record(device: Device, record: RecordLayout) -> dict[str, Raw]:
    if record.selector is not None:
        number = _idle_field(device, record.selector)
        chosen = record.of_number(number)
        if chosen is None:
            number, chosen = min(record.chosen.items(), key=lambda item: item[0])
        return {**_idle_record(device, chosen), record.selector.name: number}
    values: dict[str, Raw] = {}
    for field in record.fields:
        if field.selector is not None:
            values[field.selector.name] = field.deciding(values)
        if field.field.measures is None:
            decided = record.decided_by(values).fields[record.fields.index(field)]
            values[field.name] = _idle_field(device, decided, field.least_count(values))
    return record.with_list_bits(values)


def _idle_field(device: Device, field: FieldLayout, least_count: int = 1) -> Raw:
    if field.record is not None:
        element: Raw = _idle_record(device, field.record)
    else:
        assert field.value is not None
        element = _idle(device, field.value)
    if field.field.repeat is not None:
        return [element] * least_count
    return [element] * (field.count or 0) if field.is_list else element


def _idle(device: Device, value: Value, trigger: bool = False) -> Raw:
    """The raw value at rest: 0 if writing starts something, else the initial value, else the least legal one."""
    if value.text_form is not None:
        return ""
    if is_array(value.encoding):
        return bytes(value.size)
    if trigger:
        return 0
    if value.const is not None:
        return value.const
    if isinstance(value.default, int):
        return value.default
    return _least_legal(device, value)


def _least_legal(device: Device, value: Value) -> int:
    """0 if it is legal, else the least member of the enum, or the least number of the ranges that is."""
    enum = device.enums.get(value.enum)
    members = sorted(member.value for member in enum.members if not member.unavailable) if enum is not None else []
    ranges = value.ranges

    def legal(number: int) -> bool:
        known = enum is None or enum.open or number in members
        return known and (ranges is None or number in ranges)

    if value.flags and (ranges is None or 0 in ranges):
        return device.flags[value.flags].nearest(0)
    bounds = sorted(low for low, _ in ranges.intervals) if ranges is not None else []
    return next((number for number in (0, *members, *bounds) if legal(number)), 0)
