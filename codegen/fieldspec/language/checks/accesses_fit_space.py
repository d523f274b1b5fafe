"""A message that accesses an address space carries the units of that space: words as `u16`, bytes as `u8`, both also
as two hexadecimal digits for each byte; bits packed into a repeated `u8`, or a single bit as a number; `set` states
which number means 1. The number of words or bytes in a write request is computed from the values.

Why: outputs read the value of a register from the data of the message. They need the position of each word or bit, and
the number that stands for a bit that is 1.

Example: a message that writes one coil with a `u16` and does not state `set: 0xFF00`; a `word_count` of a request that
writes `values`, without `measures: {items: values}`; a `bit_count` of up to 2000 bits for up to 246 bytes.

Fix: Correct the field, or the keys of `accesses`. Packed bits need `count`, because the last byte can contain unused
bits. Codecs compare the bit count of a write request with its bytes, so its range has to fit the repetitions.
"""

from __future__ import annotations

from collections import Counter

from fieldspec.language.checks.finding import Findings, enumeration, finding, label, range_key
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.address_space import BIT, BYTE, WORD, AddressSpace
from fieldspec.language.model.device import Device
from fieldspec.language.model.digits import digits_text, is_hexadecimal_count
from fieldspec.language.model.encoding import is_count, is_signed
from fieldspec.language.model.ranges import Ranges, merged
from fieldspec.language.model.record import Field, Message, RegisterAccess
from fieldspec.language.model.value import Value


def accesses_fit_space(device: Device) -> Findings:
    of_bits = spaces_of_bits(device)
    for name, accessing in of_bits.items():
        space = device.spaces[name]
        unit = _meant_unit(device, name)
        text = f"{enumeration(accessing)} access {unit}s in {name}, whose unit is the {space.unit}"
        help = f"state `unit: {unit}` for {name}, or name another space in the messages"
        yield finding(space.place, "unit", text, help)
    for message in device.messages.values():
        access = message.single_access
        if access is None or access.space not in ("", *device.spaces):
            continue
        if device.space_name(access.space) in of_bits:
            continue
        holder = message.response if access.operation == "read" else message.request
        field, space = holder.named(access.values), device.space(access.space)
        count = message.request.named(access.count) if access.count else None
        if count is not None and count.measures is not None and count.measures.plus:
            text = f"{count.name} is the number of {access.values} plus {count.measures.plus} in {message.name}"
            help = "remove `plus`: what a request asks for is the number of registers"
            yield finding(count.place, "measures", text, help)
        shared = next((name for name, times in Counter(filter(None, _numbers(access))).items() if times > 1), "")
        if shared:
            text = f"{shared} is stated for two purposes in {message.name}"
            yield _of(message, text, "name a field of its own for the address, the count and the values", space)
        if field is None or field.value is None:
            continue
        if space.unit != BIT:
            yield from _words(device, message, access, field, space)
        elif space.unit == BIT and field.repeat is not None:
            yield from _packed(message, access, field, space)
        elif space.unit == BIT:
            yield from _single(message, access, field, space)


def _numbers(access: RegisterAccess) -> tuple[str, ...]:
    """The fields of a request that an access names, one for each purpose."""
    return (access.start, access.count, access.values if access.operation == "write" else "")


def _meant_unit(device: Device, name: str) -> str:
    """The unit of a space whose messages carry a `u8` repeated: bytes, where the space has other values than bits."""
    own = (message.single_access for message in device.messages.values())
    is_set = any(access.set is not None for access in own if access is not None and access.space == name)
    types = {register.value.type.name for register in device.registers() if device.space_name(register.space) == name}
    return BYTE if types and BIT not in types and not is_set else BIT


def spaces_of_bits(device: Device) -> dict[str, list[str]]:
    """The spaces of words whose messages all carry bits, each with the names of the messages.

    They pack the values into bytes, or say which number sets a bit.
    """
    spaces: dict[str, list[tuple[str, bool]]] = {}
    for message in device.messages.values():
        access = message.single_access
        if access is None or device.space_name(access.space) not in device.spaces:
            continue
        holder = message.response if access.operation == "read" else message.request
        field = holder.named(access.values)
        value = field.value if field is not None and field.repeat is not None else None
        is_packed = value is not None and value.type.name == "u8"
        rows = spaces.setdefault(device.space_name(access.space), [])
        rows.append((message.name, access.set is not None or is_packed))
    return {
        name: [message for message, _ in rows]
        for name, rows in spaces.items()
        if device.spaces[name].unit == WORD and len(rows) > 1 and all(has_bits for _, has_bits in rows)
    }


def _words(device: Device, message: Message, access: RegisterAccess, field: Field, space: AddressSpace) -> Findings:
    count = message.request.named(access.count) if access.count and access.operation == "write" else None
    if count is not None and count.measures is None and field.repeat is not None:
        text = f"{count.name} may differ from the number of {field.name} in {message.name}"
        help = f"add `measures: {{items: {field.name}}}`: encoders compute it, and decoders compare it"
        yield finding(count.place, "name", text, help, label(field.place, "name", field.name))
    if access.set is not None:
        text = f"`set` and `clear` have no effect in {message.name}, which accesses {space.unit}s"
        yield _of(message, text, "remove them", space)
    if field.value is None:
        return
    if is_hexadecimal_count(field.value, space.unit_size):
        order = "little" if field.value.is_low_first else "big"
        if space.unit_size > 1 and order != device.byte_order:
            text = f"{field.name} has the {order}-endian digits of a word, but registers are {device.byte_order}-endian"
            help = "state one byte order for the registers and their digits"
            yield finding(field.place, "digits", text, help)
    elif not is_count(field.value.encoding) or field.value.size != space.unit_size:
        form = digits_text(field.value) if field.value.digits else field.value.type.name
        text = f"{field.name} is {form}, but {message.name} accesses {space.unit}s"
        help = f"use `u{8 * space.unit_size}`, and give the registers their types"
        if field.value.digits:
            help = f"{space.unit}s are sent in {2 * space.unit_size} hexadecimal digits without a sign: state others as"
            help = f"{help} `parameters`"
        yield finding(field.place, "type", text, help)
    elif is_signed(field.value.encoding) and space.unit == BYTE:
        text = f"{field.name} is {field.value.type.name}, but the bytes of a register have no sign"
        yield finding(field.place, "type", text, "use `u8`, and give the registers their types")


def _packed(message: Message, access: RegisterAccess, field: Field, space: AddressSpace) -> Findings:
    if field.value is not None and field.value.type.name != "u8":
        text = f"{field.name} is {field.value.type.name}, but bits are packed into bytes"
        related_label = label(space.place, "unit", "the unit of the space")
        yield finding(field.place, "type", text, "use `u8`", related_label)
    if not access.count:
        text = f"{message.name} does not state how many bits {field.name} has"
        yield _of(message, text, "name the field with the number under `count`", space)
    if access.set is not None:
        text = f"`set` and `clear` have no effect in {message.name}, whose bits are packed"
        yield _of(message, text, "remove them", space)
    if field.value is not None and (field.value.flags or field.value.enum):
        key = "flags" if field.value.flags else "enum"
        text = f"`{key}` has no effect on {field.name} in {message.name}, whose bits are packed"
        yield finding(field.place, key, text, f"remove `{key}`, and describe the bits as registers of {space.name}")
    count = message.request.named(access.count) if access.count else None
    if count is not None and access.operation == "write":
        yield from _bit_count(message, count, field)
    elif count is not None and count.value is not None and not count.value.digits:
        yield from _bytes_of_bits(count, count.value, field)


def _bit_count(message: Message, count: Field, packed: Field) -> Findings:
    """The findings of the field with the number of bits that a request writes, which codecs compare with the bytes."""
    value = count.value
    related_label = label(packed.place, "repeat", f"the bytes of {packed.name}")
    is_number = value is not None and is_count(value.encoding) and not is_signed(value.encoding) and not value.digits
    if value is None or not is_number or value.size > 2 or value.flags or value.enum or count.is_list or count.reserved:
        text = f"{count.name} is the number of bits in {message.name}, and no single `u8` or `u16`"
        yield finding(count.place, "name", text, "state it as `u8` or `u16`, without an enum or digits", related_label)
    elif count.measures is not None:
        text = f"{count.name} is the number of bits in {message.name}, but `measures` {count.measures.of}"
        help = "remove `measures`: `accesses` says that it is the number of the bits, which codecs compare"
        yield finding(count.place, "measures", text, help, related_label)
    else:
        yield from _bytes_of_bits(count, value, packed)


def _bytes_of_bits(count: Field, value: Value, packed: Field) -> Findings:
    """Whether the repetitions of packed bytes have room for the number of bits, and no more."""
    if packed.repeat is None or (value.const is None and value.ranges is None):
        return
    numbers = value.ranges or Ranges(((value.low, value.high),))
    numbers = numbers if value.const is None else Ranges(((value.const, value.const),))
    sizes = Ranges(tuple(merged(((low + 7) // 8, (high + 7) // 8) for low, high in numbers.intervals)))
    if merged(sizes.intervals) != merged(packed.repeat.intervals):
        text = f"{count.name} is {numbers.text()} bits, which take {sizes.text()} bytes"
        text = f"{text}, but {packed.name} has {packed.repeat.text()}"
        key = "const" if value.const is not None else range_key(count.place)
        help = "a byte has eight bits: correct the number or the repetitions, or leave out `accesses` if the device"
        help += " packs them in another way"
        yield finding(count.place, key, text, help, label(packed.place, "repeat", f"the bytes of {packed.name}"))


def _single(message: Message, access: RegisterAccess, field: Field, space: AddressSpace) -> Findings:
    value = field.value
    if value is None or not is_count(value.encoding) or field.count is not None:
        text = f"{field.name} is neither bits packed into a repeated `u8` nor a number for a single bit"
        yield finding(field.place, "type", text, "correct the field, or `values` of the message")
        return
    if access.count:
        text = f"{message.name} has a `count`, but {field.name} is a single bit"
        yield _of(message, text, "remove `count`, or let `values` name a repeated `u8`", space)
    if access.set is None:
        text = f"{message.name} does not state which number of {field.name} is a bit that is 1"
        yield _of(message, text, "add `set`, such as `set: 0xFF00`, and `clear` where 0 does not stand for 0", space)
        return
    for key, number in (("set", access.set), ("clear", access.clear)):
        if number > value.type.high or (value.ranges is not None and number not in value.ranges):
            yield _of(message, f"{field.name} cannot be {number}, which is `{key}`", "correct the number", space)
    if access.set == access.clear:
        yield _of(message, f"{access.set} stands for both bits in {message.name}", "correct `set` or `clear`", space)


def _of(message: Message, text: str, help: str, space: AddressSpace) -> Diagnostic:
    related_labels = () if not space.name else (label(space.place, "name", "the space"),)
    return finding(message.place, "accesses", text, help, *related_labels)
