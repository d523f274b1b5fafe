"""Numbered parameters: their numbers on the wire, their elements, and functions for their values."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.c.accessors import ACCESS, access_lines, constant_lines
from fieldspec.backends.c.comments import of_value, told
from fieldspec.backends.c.naming import Naming
from fieldspec.backends.c.text import comment, indented
from fieldspec.backends.c.values import Wire
from fieldspec.layout.record import Orders
from fieldspec.model.device import Device
from fieldspec.model.registers import Parameter, ParameterSet, Subindex
from fieldspec.model.value import Value


def parameter_lines(naming: Naming, device: Device, held: ParameterSet) -> Iterator[list[str]]:
    """The numbers of a set, then the constants and functions of its parameters, one block each."""
    if held.base or held.numbers is not None:
        yield _family(naming, held)
    for one in held.parameters:
        yield _parameter(naming, device, held, one)
        if not one.reserved:
            for inner in one.subindices:
                if not inner.reserved:
                    yield _subindex(naming, device, held, one, inner)


def number_text(held: ParameterSet, number: int) -> str:
    """A number of the set as a constant: in hexadecimal where the manual writes it so."""
    return f"0x{number:04X}u" if held.base or "x}" in held.printed_as.lower() else f"{number}u"


def wire_type(held: ParameterSet) -> str:
    """The type that holds every number of the set on the wire."""
    assert held.numbers is not None
    return "uint16_t" if held.base + held.numbers.high <= 0xFFFF else "uint32_t"


def _family(naming: Naming, held: ParameterSet) -> list[str]:
    """The base of the set's numbers on the wire, and the function that gives one where they are a formula."""
    names = (held.name,)
    lines = told(held, f"Their numbers on the wire are those of the set and {number_text(held, held.base)[:-1]}.")
    lines.append(f"#define {naming.macro('parameter', *names, 'base')} {number_text(held, held.base)}")
    if held.numbers is None:
        return lines
    lines += [
        f"#define {naming.macro('parameter', *names, 'first')} {number_text(held, held.numbers.low)}",
        f"#define {naming.macro('parameter', *names, 'last')} {number_text(held, held.numbers.high)}",
    ]
    number, wire = held.numbers.low, held.base + held.numbers.low
    example = f"{number_text(held, wire)[:-1]} for {held.number_text(number)}"
    tests = []
    for low, high in held.numbers.intervals:
        first, last = (number_text(held, bound) for bound in (low, high))
        tests.append(f"number <= {last}" if low == 0 else f"(number >= {first} && number <= {last})")
    kind = wire_type(held)
    return [
        *lines,
        *comment(f"A number of the set as it is on the wire: {example}. A number that there is not is refused."),
        f"static inline {naming.own('codec_status')} {naming.function('parameter', *names, 'wire_number')}"
        f"(uint32_t number, {kind} *out)",
        "{",
        *indented(
            [
                f"if (!({' || '.join(tests)})) {{",
                f"    return {naming.own_macro('err_out_of_range')};",
                "}",
                f"*out = ({kind})({naming.macro('parameter', *names, 'base')} + number);",
                f"return {naming.own_macro('ok')};",
            ]
        ),
        "}",
    ]


def _parameter(naming: Naming, device: Device, held: ParameterSet, parameter: Parameter) -> list[str]:
    names = (held.name, parameter.name)
    written = held.number_text(parameter.number) if held.printed_as else ""
    facts = (
        "Reserved." if parameter.reserved else "",
        f"{written} of {held.name}." if written else "",
        ACCESS[parameter.access] if parameter.access else "",
        "A change takes effect after a restart." if parameter.restart else "",
        f"For {', '.join(parameter.applies_to)} only." if parameter.applies_to else "",
        f"With {', '.join(parameter.messages)}." if parameter.messages else "",
    )
    lines = told(parameter, " ".join(fact for fact in facts if fact), of_value(parameter.value))
    number = number_text(held, held.base + parameter.number)
    lines.append(f"#define {naming.macro('parameter', *names, 'number')} {number}")
    if parameter.count > 1:
        lines.append(f"#define {naming.macro('parameter', *names, 'count')} {parameter.count}u")
    if parameter.elements is not None:
        lines.append(f"#define {naming.macro('parameter', *names, 'elements')} {parameter.elements}u")
    if parameter.reserved:
        return lines
    return [*lines, *_held(naming, device, names, parameter.value, parameter.trigger)]


def _subindex(naming: Naming, device: Device, held: ParameterSet, parameter: Parameter, inner: Subindex) -> list[str]:
    names = (held.name, parameter.name, inner.name)
    low, high = inner.indices.low, inner.indices.high
    ends = [("subindex", low)] if low == high else [("first_subindex", low), ("last_subindex", high)]
    lines = told(inner, f"Of {parameter.name}.", of_value(inner.value))
    lines += [f"#define {naming.macro('parameter', *names, end)} {number}u" for end, number in ends]
    return [*lines, *_held(naming, device, names, inner.value, parameter.trigger)]


def _held(naming: Naming, device: Device, names: tuple[str, ...], value: Value, trigger: bool) -> list[str]:
    order, swapped = Orders(device.byte_order, device.word_order).of(value)
    return [
        *constant_lines(naming, "parameter", names, value),
        "",
        *access_lines(naming, device, "parameter", names, Wire(value, order, swapped), value.size, trigger),
    ]
