"""What self-tests expect of registers, parameters and conversions: values at their bounds."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from fieldspec.backends.c.assertions import expect, expect_bytes, expect_equal
from fieldspec.backends.c.conversions import count_bounds, count_type
from fieldspec.backends.c.expressions import (
    ZERO,
    Call,
    Expression,
    Identifier,
    Type,
    address_of,
    at_least,
    at_most,
    byte_initializer,
    decimal,
    double,
    integer,
    whole_double,
)
from fieldspec.backends.c.naming import Naming, Noun
from fieldspec.backends.c.sample_values import legal_numbers, value_bytes
from fieldspec.backends.c.statements import CompileIf, Statement, Variable, assign, discard
from fieldspec.backends.c.values import type_name
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.record import Orders
from fieldspec.model.device import Device
from fieldspec.model.value import Conversion, Kind, Value

_BYTES, _OTHER, _IN, _OUT, _RAW = (Identifier(name) for name in ("bytes", "other", "in", "out", "raw"))
_OUT_POINTER = address_of(_OUT)
_REFERENCE = 3000
"""The reference of quantities in tests: a usual speed in revolutions a minute."""


def test_values(layout: DeviceLayout, naming: Naming) -> Iterator[list[Statement]]:
    """Each register's and each parameter's value at its bounds."""
    device = layout.device
    for register in layout.registers:
        value, order = register.register.value, (register.order, register.swapped)
        size = value.size + value.size % 2
        yield from _test_value(device, naming, "register", (register.name,), value, order, size)
    orders = Orders(device.byte_order, device.word_order)
    for parameters in device.parameters.values():
        for parameter in parameters.parameters:
            if parameter.reserved:
                continue
            names = (parameters.name, parameter.name)
            inner = [((*names, inner.name), inner.value) for inner in parameter.subindices if not inner.reserved]
            for full_names, value in [(names, parameter.value), *inner]:
                order = orders.of(value)
                yield from _test_value(device, naming, "parameter", full_names, value, order, value.size)


def _test_value(
    device: Device,
    naming: Naming,
    noun: Noun,
    names: tuple[str, ...],
    value: Value,
    order: tuple[str, bool],
    size: int,
) -> Iterator[list[Statement]]:
    if value.type.kind is not Kind.INTEGER:
        return
    encode, decode = naming.function(noun, *names, "encode"), naming.function(noun, *names, "decode")
    ok, label = naming.status("ok"), ".".join(names)
    body: list[Statement] = [Variable(Type("uint8_t"), "bytes", (decimal(size),))]
    kind = Type(type_name(value))
    if value.const is not None:
        data = value_bytes(value, *order, value.const).ljust(size, b"\0")
        other = 0 if value.const else 1
        other_data = byte_initializer(value_bytes(value, *order, other).ljust(size, b"\0"))
        yield [
            *body,
            Variable(kind, "out", value=ZERO),
            Variable(Type("uint8_t"), "other", (None,), other_data, "static const"),
            expect_equal(label, Call(encode, (_BYTES,)), ok),
            expect_bytes(f"{label} bytes", _BYTES, data),
            expect_equal(label, Call(decode, (_BYTES, _OUT_POINTER)), ok),
            expect_equal(label, _OUT, integer(value.const, value.size, value.type.signed)),
            expect_equal(f"{label} {other}", Call(decode, (_OTHER, _OUT_POINTER)), ok),
            expect_equal(f"{label} {other}", _OUT, integer(other, value.size, value.type.signed)),
        ]
        return
    body += [Variable(kind, "out", value=ZERO), Variable(kind, "in", value=ZERO, storage="volatile")]
    encoded, decoded = Call(encode, (_IN, _BYTES)), Call(decode, (_BYTES, _OUT_POINTER))
    for number in sorted(set(legal_numbers(device, value))):
        data = value_bytes(value, *order, number).ljust(size, b"\0")
        literal = integer(number, value.size, value.type.signed)
        what = f"{label} {number}"
        body += [
            assign(_IN, literal),
            expect_equal(what, encoded, ok),
            expect_bytes(f"{what} bytes", _BYTES, data),
            expect_equal(what, decoded, ok),
            expect_equal(what, _OUT, literal),
        ]
    yield body


def test_conversions(layout: DeviceLayout, naming: Naming) -> Iterator[list[Statement]]:
    """Each conversion at its bounds, there and back, between two counts, and beyond the bounds."""
    for conversion in layout.device.conversions.values():
        body = _test_conversion(layout.device, naming, conversion)
        yield [CompileIf("ifndef", naming.own_macro("without_double"), tuple(body))]


def _test_conversion(device: Device, naming: Naming, conversion: Conversion) -> list[Statement]:
    size, signed = conversion.type.size, conversion.type.signed
    from_raw = naming.function("conversion", conversion.name, "from_raw")
    to_raw = naming.function("conversion", conversion.name, "to_raw")
    ok, out_of_range = naming.status("ok"), naming.status("err_out_of_range")
    reference, raw = whole_double(_REFERENCE), address_of(_RAW)
    low, high = count_bounds(device, conversion)
    body: list[Statement] = [Variable(Type(count_type(conversion)), "raw", value=ZERO)]
    counts = {low, 0, 1, conversion.full_scale, high}
    for number in sorted(count for count in counts if low <= count <= high):
        literal, what = integer(number, size, signed), f"{conversion.name} {number}"
        wanted = float(conversion.quantity(number, Fraction(_REFERENCE)))
        near = max(abs(wanted) * 1e-12, 1e-12)
        quantity = Call(from_raw, (literal, reference))
        body += [
            expect(at_least(quantity, double(wanted - near)), what),
            expect(at_most(quantity, double(wanted + near)), what),
        ]
        if size < 8:
            body += [
                expect_equal(f"{what} back", Call(to_raw, (quantity, reference, raw)), ok),
                expect_equal(f"{what} back", _RAW, literal),
            ]
    if conversion.full_scale & (conversion.full_scale - 1) == 0 and low <= 0 and high > 2:
        # A reference as large as the full scale makes halves of counts exact.
        exact = Fraction(conversion.full_scale)
        for doubled, even in ((1, 0), (3, 2), (5, 2)):
            half = float(conversion.quantity(doubled, exact / 2) + (exact / 2 if conversion.complement else 0))
            what = f"{conversion.name} {doubled}/2"
            arguments: tuple[Expression, ...] = (double(half), double(float(exact)), raw)
            body += [
                expect_equal(what, Call(to_raw, arguments), ok),
                expect_equal(what, _RAW, integer(even, size, signed)),
            ]
    beyond = double(float(conversion.quantity(2 * high + 2 - low, Fraction(1))))
    unit = whole_double(1)
    return [
        *body,
        expect_equal(f"{conversion.name} beyond", Call(to_raw, (beyond, unit, raw)), out_of_range),
        expect_equal(f"{conversion.name} of nothing", Call(to_raw, (unit, whole_double(0), raw)), out_of_range),
        discard("raw"),
    ]
