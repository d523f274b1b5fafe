"""What self-tests expect of registers, parameters and conversions: values at their bounds."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from fieldspec.backends.c.assertions import same, same_bytes
from fieldspec.backends.c.expected import legal, raw_bytes
from fieldspec.backends.c.naming import Naming, Noun
from fieldspec.backends.c.signals import bounds
from fieldspec.backends.c.text import array, integer, string
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.record import Orders
from fieldspec.model.device import Device
from fieldspec.model.value import Conversion, Kind, Value


def values_at_bounds(layout: DeviceLayout, naming: Naming) -> Iterator[list[str]]:
    """Each register's and each parameter's value at its bounds."""
    device = layout.device
    for laid in layout.registers:
        value = laid.register.value
        size = value.size + value.size % 2
        yield from _value(device, naming, "register", (laid.name,), value, (laid.order, laid.swapped), size)
    orders = Orders(device.byte_order, device.word_order)
    for held in device.parameters.values():
        for parameter in held.parameters:
            if parameter.reserved:
                continue
            inner = [((held.name, parameter.name, i.name), i.value) for i in parameter.subindices if not i.reserved]
            for names, value in [((held.name, parameter.name), parameter.value), *inner]:
                yield from _value(device, naming, "parameter", names, value, orders.of(value), value.size)


def _value(
    device: Device,
    naming: Naming,
    noun: Noun,
    names: tuple[str, ...],
    value: Value,
    order: tuple[str, bool],
    size: int,
) -> Iterator[list[str]]:
    if value.type.kind is not Kind.INTEGER:
        return
    encode, decode = naming.function(noun, *names, "encode"), naming.function(noun, *names, "decode")
    ok, label = naming.own_macro("ok"), ".".join(names)
    kind = f"{'' if value.type.signed else 'u'}int{8 * value.size}_t"
    lines = [f"uint8_t bytes[{size}];"]
    if value.const is not None:
        data = raw_bytes(value, *order, value.const).ljust(size, b"\0")
        other = 0 if value.const else 1
        raw = raw_bytes(value, *order, other).ljust(size, b"\0")
        yield [
            *lines,
            f"{kind} out = 0;",
            f"static const uint8_t other[] = {{{array(raw)}}};",
            same(label, f"{encode}(bytes)", ok),
            same_bytes(f"{label} bytes", "bytes", data),
            same(label, f"{decode}(bytes, &out)", ok),
            same(label, "out", integer(value.const, value.size, value.type.signed)),
            same(f"{label} {other}", f"{decode}(other, &out)", ok),
            same(f"{label} {other}", "out", integer(other, value.size, value.type.signed)),
        ]
        return
    lines += [f"{kind} out = 0;", f"volatile {kind} in = 0;"]
    for number in sorted(set(legal(device, value))):
        data = raw_bytes(value, *order, number).ljust(size, b"\0")
        literal = integer(number, value.size, value.type.signed)
        what = f"{label} {number}"
        lines += [
            f"in = {literal};",
            same(what, f"{encode}(in, bytes)", ok),
            same_bytes(f"{what} bytes", "bytes", data),
            same(what, f"{decode}(bytes, &out)", ok),
            same(what, "out", literal),
        ]
    yield lines


def conversions(layout: DeviceLayout, naming: Naming) -> Iterator[list[str]]:
    """Each conversion at its bounds, there and back, between two counts, and beyond the bounds."""
    for conversion in layout.device.conversions.values():
        yield [
            f"#ifndef {naming.own_macro('without_double')}",
            *_conversion(layout.device, naming, conversion),
            "#endif",
        ]


def _conversion(device: Device, naming: Naming, conversion: Conversion) -> list[str]:
    size, signed = conversion.type.size, conversion.type.signed
    there = naming.function("conversion", conversion.name, "from_raw")
    back = naming.function("conversion", conversion.name, "to_raw")
    ok, refused = naming.own_macro("ok"), naming.own_macro("err_out_of_range")
    low, high = bounds(device, conversion)
    lines = [f"{'' if signed else 'u'}int{8 * size}_t raw = 0;"]
    for number in sorted(one for one in {low, 0, 1, conversion.full_scale, high} if low <= one <= high):
        literal, what = integer(number, size, signed), f"{conversion.name} {number}"
        wanted = float(conversion.quantity(number, Fraction(3000)))
        near = max(abs(wanted) * 1e-12, 1e-12)
        lines += [
            f"expect({there}({literal}, 3000.0) >= {wanted - near!r}, {string(what)});",
            f"expect({there}({literal}, 3000.0) <= {wanted + near!r}, {string(what)});",
        ]
        if size < 8:
            lines += [
                same(f"{what} back", f"{back}({there}({literal}, 3000.0), 3000.0, &raw)", ok),
                same(f"{what} back", "raw", literal),
            ]
    if conversion.full_scale & (conversion.full_scale - 1) == 0 and low <= 0 and high > 2:
        # A reference as large as the scale is whole makes halves of counts exact.
        reference = Fraction(conversion.full_scale)
        for doubled, even in ((1, 0), (3, 2), (5, 2)):
            half = float(conversion.quantity(doubled, reference / 2) + (reference / 2 if conversion.complement else 0))
            what = f"{conversion.name} {doubled}/2"
            lines += [
                same(what, f"{back}({half!r}, {float(reference)!r}, &raw)", ok),
                same(what, "raw", integer(even, size, signed)),
            ]
    beyond = float(conversion.quantity(2 * high + 2 - low, Fraction(1)))
    return [
        *lines,
        same(f"{conversion.name} beyond", f"{back}({beyond!r}, 1.0, &raw)", refused),
        same(f"{conversion.name} of nothing", f"{back}(1.0, 0.0, &raw)", refused),
        "(void)raw;",
    ]
