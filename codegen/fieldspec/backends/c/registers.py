"""Registers, tables of records, and numbered parameters: constants, and functions for their values."""

from __future__ import annotations

from fractions import Fraction

from fieldspec.backends.c.naming import Naming
from fieldspec.backends.c.text import comment, hexadecimal, indented, integer
from fieldspec.backends.c.values import Wire, const_test, declaration, decode_lines, encode_lines, fixed_lines
from fieldspec.backends.c.words import closed_test, told
from fieldspec.layout.device import DeviceLayout, RegisterLayout, TableLayout
from fieldspec.layout.record import Orders
from fieldspec.model.device import Device
from fieldspec.model.parameter import Parameter, ParameterSet
from fieldspec.model.primitive import Kind
from fieldspec.model.value import Value

_ACCESS = {
    "ro": "Read only.",
    "rw": "Read and write.",
    "wo": "Write only.",
    "": "The manual does not say how it is accessed.",
}


def register_lines(naming: Naming, device: Device, laid: RegisterLayout) -> list[str]:
    """The constants of a register, and the functions for its value."""
    register = laid.register
    restart = {True: "A change takes effect after a restart.", False: "", None: ""}[register.restart]
    trigger = "Writing starts an action." if register.trigger else ""
    words = f"{laid.words} words must be accessed in one request." if register.atomic and laid.words > 1 else ""
    lines = told(register, " ".join(part for part in (_ACCESS[register.access], restart, trigger, words) if part))
    names = ("reg", laid.name)
    lines += [
        f"#define {naming.macro(*names, 'address')} {hexadecimal(laid.address, 2)}",
        f"#define {naming.macro(*names, 'words')} {laid.words}u",
    ]
    if laid.count > 1:
        lines += [
            f"#define {naming.macro(*names, 'count')} {laid.count}u",
            f"#define {naming.macro(*names, 'stride')} {laid.stride}u",
            f"#define {naming.macro(*names, 'first')} {register.index_from}u",
        ]
    lines += _constants(naming, names, register.value)
    wire = Wire(register.value, laid.order, laid.swapped)
    lines += ["", *_functions(naming, device, names, wire)]
    if laid.count > 1:
        lines += ["", *_address(naming, names, f"{laid.name} by its number")]
    return lines


def _constants(naming: Naming, names: tuple[str, ...], value: Value) -> list[str]:
    """The range, the default and the scale, each in counts or as a fraction."""
    lines = []
    size, signed = value.size, value.type.signed
    if value.ranges is not None:
        lines += [
            f"#define {naming.macro(*names, 'min')} {integer(value.ranges.low, size, signed)}",
            f"#define {naming.macro(*names, 'max')} {integer(value.ranges.high, size, signed)}",
        ]
    if isinstance(value.default, int) and value.type.kind is not Kind.FLOAT:
        lines.append(f"#define {naming.macro(*names, 'default')} {integer(value.default, size, signed)}")
    if value.scaled:
        scale = Fraction(value.scale)
        lines += [
            f"#define {naming.macro(*names, 'scale_numerator')} {integer(scale.numerator, 8)}",
            f"#define {naming.macro(*names, 'scale_denominator')} {integer(scale.denominator, 8)}",
        ]
    return lines


def _functions(naming: Naming, device: Device, names: tuple[str, ...], wire: Wire) -> list[str]:
    """The functions that read and write the value, as its bytes lie in a frame."""
    value, status = wire.value, naming.type("codec_status")
    ok = f"return {naming.macro('ok')};"
    size = wire.size + wire.size % 2 if names[0] == "reg" else wire.size
    pad = [f"out[{wire.size}] = 0;"] if size != wire.size else []
    if value.const is not None:
        encode, decode = fixed_lines(naming, wire, value.const, "out"), const_test(naming, wire, "in")
        taken, given = "", ""
    else:
        closed = closed_test(naming, device, value, "value")
        text = wire.kind in (Kind.TEXT, Kind.BYTES)
        target = "out" if text else "*out"
        encode = encode_lines(naming, wire, "value", "out", closed)
        decode = decode_lines(naming, wire, "in", target, closed_test(naming, device, value, target))
        pointer = declaration(wire, "out" if text else "*out", None)
        argument = declaration(wire, "value", None)
        taken, given = f", {pointer}", f"{'const ' if text else ''}{argument}, "
    return [
        *comment(f"Reads its value from the {size} bytes of its words." if names[0] == "reg" else "Reads its value."),
        f"static inline {status} {naming.function(*names, 'decode')}(const uint8_t *in{taken})",
        "{",
        *indented([*decode, ok]),
        "}",
        "",
        *comment(f"Writes its value to the {size} bytes of its words." if names[0] == "reg" else "Writes its value."),
        f"static inline {status} {naming.function(*names, 'encode')}({given}uint8_t *out)",
        "{",
        *indented([*encode, *pad, ok]),
        "}",
    ]


def _address(naming: Naming, names: tuple[str, ...], what: str) -> list[str]:
    first, count = naming.macro(*names, "first"), naming.macro(*names, "count")
    base = naming.macro(*names, "address")
    return [
        *comment(f"The address of {what}; a number that there is not is refused."),
        f"static inline {naming.type('codec_status')} {naming.function(*names, 'at')}"
        "(uint32_t number, uint16_t *address)",
        "{",
        *indented(
            [
                f"if (number - {first} >= {count}) {{",
                f"    return {naming.macro('err_out_of_range')};",
                "}",
                f"*address = (uint16_t)({base} + (number - {first}) * {naming.macro(*names, 'stride')});",
                f"return {naming.macro('ok')};",
            ]
        ),
        "}",
    ]


def table_lines(naming: Naming, laid: TableLayout) -> list[str]:
    """The constants of a table, and the function that gives an element's address."""
    table = laid.table
    names = ("table", laid.name)
    lines = told(table, f"Its elements are {naming.type(laid.record.name)}.")
    lines += [
        f"#define {naming.macro(*names, 'address')} {hexadecimal(table.base, 2)}",
        f"#define {naming.macro(*names, 'words')} {laid.words}u",
        f"#define {naming.macro(*names, 'stride')} {table.stride}u",
        f"#define {naming.macro(*names, 'count')} {table.count}u",
        f"#define {naming.macro(*names, 'first')} {table.index_from}u",
    ]
    return [*lines, "", *_address(naming, names, f"an element of {table.name} by its number")]


def parameter_lines(naming: Naming, layout: DeviceLayout, held: ParameterSet) -> list[list[str]]:
    """The constants and functions of a set's parameters, one block each."""
    return [_parameter(naming, layout, held, one) for one in held.parameters if not one.reserved]


def _parameter(naming: Naming, layout: DeviceLayout, held: ParameterSet, parameter: Parameter) -> list[str]:
    names = ("par", held.name, parameter.name)
    device = layout.device
    order, swapped = Orders(device.byte_order, device.word_order).of(parameter.value)
    lines = told(parameter, _ACCESS[parameter.access] if parameter.access else "")
    lines.append(f"#define {naming.macro(*names, 'number')} {parameter.number}u")
    lines += _constants(naming, names, parameter.value)
    return [*lines, "", *_functions(naming, device, names, Wire(parameter.value, order, swapped))]
