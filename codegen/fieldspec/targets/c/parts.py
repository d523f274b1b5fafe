"""The parts of frames other than checksums: where they are, how they are tested and written."""

from __future__ import annotations

from collections.abc import Iterable

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import Digits, Octets, Real, Text, Truth, Whole, number_of
from fieldspec.targets.c.digits import digits_test
from fieldspec.targets.c.expressions import (
    IN,
    LENGTH,
    OUT,
    Cast,
    Expression,
    Group,
    Identifier,
    Type,
    all_of,
    any_of,
)
from fieldspec.targets.c.literals import UINT64, ZERO, decimal, hexadecimal, integer, unsigned
from fieldspec.targets.c.machine import machine, machine_whole
from fieldspec.targets.c.naming import Naming, argument
from fieldspec.targets.c.statements import Body, CompileIf, Statement
from fieldspec.targets.c.values import (
    WireValue,
    check_stored,
    load,
    load_bits,
    refuse,
    store,
    store_constant,
    store_number,
    store_whole,
)

CODE, TOTAL = Identifier("code"), Identifier("total")


def part_value(part: PartLayout) -> WireValue:
    """The value of a part, which must have one, with its order on the wire."""
    assert part.value is not None
    return WireValue(part.value, part.order, False)


def number_type(size: int) -> Type:
    """The type of a code or subcode of `size` bytes where it is a parameter or a member."""
    return Type("uint64_t" if size > 4 else "uint32_t")


def code_type(frame: FrameLayout) -> Type:
    """The type of the code of a frame, which has one."""
    part = frame.role("code")
    assert part is not None
    number = number_of(part_value(part).encoding)
    assert number is not None, "a code is a number, as a check sees to"
    return number_type(number.bits // 8)


def part_pointer(pointer: Expression, part: PartLayout, total: Expression) -> Expression:
    """`in + 2`, or after the body `in + length - 3u`: a pointer to a part of a frame of `total` bytes."""
    return pointer + (decimal(part.offset) if part.offset >= 0 else total.plus(part.offset))


def load_part(naming: Naming, part: PartLayout) -> Expression:
    """`load_u16_be(in + 2)`, or of some bits `(uint8_t)((load_u8(in + 4) >> 5u) & 0x01u)`: a received number"""
    wire, source = part_value(part), part_pointer(IN, part, LENGTH)
    if not part.width:
        return load(naming, wire, source)
    bits = load_bits(naming, wire, source)
    shifted = Group(bits >> unsigned(part.shift)) if part.shift else bits
    mask = hexadecimal((1 << part.width) - 1, part.size)
    return Cast(machine(wire.encoding).word, shifted & mask)


def write_shared_bytes(naming: Naming, frame: FrameLayout) -> Body:
    """`store_u8(out + 2, 0x40u);`: the constants in the bytes that parts share, to which other parts add their bits"""
    body: Body = ()
    for first in frame.header:
        if first.width and not first.part.is_shared:
            parts = (part for part in frame.header if part.offset == first.offset)
            constants = sum((part.constant or 0) << part.shift for part in parts)
            body += store_constant(naming, part_value(first), constants, part_pointer(OUT, first, TOTAL))
    return body


def check_digits(naming: Naming, parts: Iterable[PartLayout]) -> Body:
    """`if (!is_digits(in + 1, 2u, 0u, 0u)) { return ERR_UNKNOWN_VALUE; }`, for each part that is sent as digits"""
    body: Body = ()
    for part in parts:
        test = digits_test(naming, part_value(part).value, part_pointer(IN, part, LENGTH), ZERO)
        body += refuse(naming, test.negated(), "err_unknown_value")
    return body


def length_number(frame: FrameLayout, part: PartLayout, total: Expression) -> tuple[Expression, list[Expression]]:
    """The number of a length part in a frame of `total` bytes, and the tests for lengths that it cannot express.

    Where none of them does, nothing wraps around: `(length - 4u) / 2u`, `(length - 4u) % 2u != 0`
    """
    parts_size = frame.header_size + frame.trailer_size
    unrepresentable: list[Expression] = [total.less(unsigned(part.base))] if part.base > parts_size else []
    number = total.plus(-part.base)
    if part.unit_size > 1:
        unit = unsigned(part.unit_size)
        unrepresentable.append((number % unit).differs(ZERO))
        number = number / unit
    return number, unrepresentable


def write_part(naming: Naming, layout: DeviceLayout, link: LinkLayout, frame: FrameLayout, part: PartLayout) -> Body:
    """Checks a part other than the checksum, and writes it."""
    wire = part_value(part)
    target = part_pointer(OUT, part, TOTAL)
    if part.role == "length":
        highest = wire.value.high
        number, unrepresentable = length_number(frame, part, TOTAL)
        checks = refuse(naming, any_of(unrepresentable), "err_wrong_length") if unrepresentable else ()
        limit = refuse(naming, number.greater(unsigned(highest)), "err_wrong_length")
        if highest >= 0xFFFF:
            limit = (CompileIf("if", f"SIZE_MAX > {highest}u", limit),)
        return (*checks, *limit, _store_part(naming, part, target, number))
    if part.role == "code":
        highest = wire.value.high
        is_any = highest == (1 << (32 if code_type(frame) == number_type(4) else 64)) - 1
        limit = () if is_any else refuse(naming, CODE.greater(unsigned(highest)), "err_unknown_code")
        return (*limit, _store_part(naming, part, target, CODE))
    if part.constant is not None:
        if part.width:
            return ()  # it is among the constants of the bytes
        return store_constant(naming, wire, part.constant, target)
    value = Identifier(argument(part))
    unit_address = _unit_address_test(link, wire, value) if part.role == "unit_address" else None
    if unit_address is None:
        return (*check_stored(naming, layout.device, wire, value), _store_part(naming, part, target, value))
    return (
        *check_stored(naming, layout.device, wire, value, ("unknown_value",)),
        *refuse(naming, unit_address, "err_out_of_range"),
        _store_part(naming, part, target, value),
    )


def _store_part(naming: Naming, part: PartLayout, target: Expression, number: Expression) -> Statement:
    """Writes the number of a part, which its bytes, its bits or its digits hold."""
    wire = part_value(part)
    if part.width:
        word = machine(wire.encoding).word
        own: Expression = Cast(word, number)
        own = Group(own << unsigned(part.shift)) if part.shift else own
        joined = load_bits(naming, wire, target) | own
        return store(naming, wire.access, target, Cast(word, joined))
    match wire.encoding:
        case Digits():
            return store_number(naming, wire, number, target)
        case Whole() | Real() | Truth() | Text() | Octets():
            return store_whole(naming, wire, number, target)
        case _:
            assert_never(wire.encoding)


def address_literal(address: int) -> Expression:
    """`16`, or `UINT64_C(1099511627775)`: older compilers take no wide number without a type."""
    return integer(address, UINT64) if address >> 32 else decimal(address)


def _unit_address_test(link: LinkLayout, wire: WireValue, address: Expression) -> Expression | None:
    """`!((unit_address >= 1 && unit_address <= 16) || (unit_address == 0))`: whether it is not a unit address of the
    link.
    """
    addresses = link.link.unit_addresses
    if addresses is None or addresses.ranges is None:
        return None
    whole = number_of(wire.encoding)
    assert whole is not None, "a check sees to it that an address is a whole number"
    minimum, maximum = machine_whole(whole).bounds
    tests: list[Expression] = []
    for low, high in addresses.ranges.intervals:
        bounds: list[Expression] = [address.at_least(address_literal(low))] if low > minimum else []
        bounds += [address.at_most(address_literal(high))] if high < maximum else []
        tests.append(Group(all_of(bounds) if bounds else decimal(1)))
    if addresses.broadcast is not None and addresses.broadcast not in addresses.ranges:
        tests.append(Group(address.equals(address_literal(addresses.broadcast))))
    return (Group(tests[0]) if len(tests) == 1 else any_of(tests)).negated()
