"""Numbered parameters: their numbers on the wire, their elements, and functions for their values."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.c.comments import comment, describe_fact, describe_value
from fieldspec.backends.c.declarations import BLANK, Declaration, Define, Function
from fieldspec.backends.c.expressions import (
    NUMBER,
    OUT,
    Cast,
    Expression,
    Group,
    Identifier,
    Literal,
    Type,
    add,
    all_of,
    any_of,
    at_least,
    at_most,
    dereference,
    hexadecimal_digits,
    negate,
    unsigned,
)
from fieldspec.backends.c.naming import Naming
from fieldspec.backends.c.registers import ACCESS, access_functions, define_constants
from fieldspec.backends.c.statements import Body, Variable, assign
from fieldspec.backends.c.values import (
    WireValue,
    refuse,
    return_ok,
    status_type,
)
from fieldspec.layout.record import Orders
from fieldspec.model.device import Device
from fieldspec.model.registers import Parameter, ParameterSet, Subindex
from fieldspec.model.value import Value


def declare_parameters(naming: Naming, device: Device, parameters: ParameterSet) -> Iterator[list[Declaration]]:
    """The numbers of a set, then the constants and functions of its parameters, one list each."""
    if parameters.base or parameters.numbers is not None:
        yield _declare_set(naming, parameters)
    for parameter in parameters.parameters:
        yield _declare_parameter(naming, device, parameters, parameter)
        if not parameter.reserved:
            for subindex in parameter.subindices:
                if not subindex.reserved:
                    yield _declare_subindex(naming, device, parameters, parameter, subindex)


def wire_number_type(parameters: ParameterSet) -> str:
    """The type of the set's numbers on the wire."""
    assert parameters.numbers is not None
    return "uint16_t" if parameters.base + parameters.numbers.high <= 0xFFFF else "uint32_t"


def _number(parameters: ParameterSet, number: int) -> Literal:
    """A number of the set as a constant: in hexadecimal where the manual writes it so."""
    if parameters.base or "x}" in parameters.printed_as.lower():
        return hexadecimal_digits(number, 4, "u")
    return unsigned(number)


def _number_text(parameters: ParameterSet, number: int) -> str:
    """The same for people, without the mark of its type."""
    return _number(parameters, number).text.removesuffix("u")


def _declare_set(naming: Naming, parameters: ParameterSet) -> list[Declaration]:
    """The base of the set's numbers on the wire, and the function that gives one where they are a formula."""
    base_text = _number_text(parameters, parameters.base)
    base = Identifier(naming.macro("parameter", parameters.name, "base"))
    declarations: list[Declaration] = [
        describe_fact(parameters, f"Their numbers on the wire are those of the set and {base_text}."),
        Define(base.name, _number(parameters, parameters.base)),
    ]
    numbers = parameters.numbers
    if numbers is None:
        return declarations
    declarations += [
        Define(naming.macro("parameter", parameters.name, "first"), _number(parameters, numbers.low)),
        Define(naming.macro("parameter", parameters.name, "last"), _number(parameters, numbers.high)),
    ]
    example = f"{_number_text(parameters, parameters.base + numbers.low)} for {parameters.number_text(numbers.low)}"
    inside: list[Expression] = []
    for low, high in numbers.intervals:
        least, most = at_least(NUMBER, _number(parameters, low)), at_most(NUMBER, _number(parameters, high))
        inside.append(most if low == 0 else Group(all_of([least, most])))
    kind = wire_number_type(parameters)
    body: Body = (
        *refuse(naming, negate(any_of(inside)), "err_out_of_range"),
        assign(dereference(OUT), Cast(kind, add(base, NUMBER))),
        return_ok(naming),
    )
    function = Function(
        status_type(naming),
        naming.function("parameter", parameters.name, "wire_number"),
        (Variable(Type("uint32_t"), "number"), Variable(Type(kind, pointer=True), "out")),
        body,
    )
    about = f"A number of the set as it is on the wire: {example}. A number that there is not is refused."
    return [*declarations, comment(about), function]


def _declare_parameter(
    naming: Naming, device: Device, parameters: ParameterSet, parameter: Parameter
) -> list[Declaration]:
    names = (parameters.name, parameter.name)
    printed_number = parameters.number_text(parameter.number) if parameters.printed_as else ""
    facts = (
        "Reserved." if parameter.reserved else "",
        f"{printed_number} of {parameters.name}." if printed_number else "",
        ACCESS[parameter.access] if parameter.access else "",
        "A change takes effect after a restart." if parameter.restart else "",
        f"For {', '.join(parameter.applies_to)} only." if parameter.applies_to else "",
        f"With {', '.join(parameter.messages)}." if parameter.messages else "",
    )
    constants = [("number", _number(parameters, parameters.base + parameter.number))]
    if parameter.count > 1:
        constants.append(("count", unsigned(parameter.count)))
    if parameter.elements is not None:
        constants.append(("elements", unsigned(parameter.elements)))
    declarations: list[Declaration] = [
        describe_fact(parameter, " ".join(fact for fact in facts if fact), describe_value(parameter.value)),
        *(Define(naming.macro("parameter", *names, name), number) for name, number in constants),
    ]
    if parameter.reserved:
        return declarations
    return [*declarations, *_declare_parameter_value(naming, device, names, parameter.value, parameter.trigger)]


def _declare_subindex(
    naming: Naming, device: Device, parameters: ParameterSet, parameter: Parameter, subindex: Subindex
) -> list[Declaration]:
    names = (parameters.name, parameter.name, subindex.name)
    low, high = subindex.indices.low, subindex.indices.high
    ends = [("subindex", low)] if low == high else [("first_subindex", low), ("last_subindex", high)]
    return [
        describe_fact(subindex, f"Of {parameter.name}.", describe_value(subindex.value)),
        *(Define(naming.macro("parameter", *names, end), unsigned(number)) for end, number in ends),
        *_declare_parameter_value(naming, device, names, subindex.value, parameter.trigger),
    ]


def _declare_parameter_value(
    naming: Naming, device: Device, names: tuple[str, ...], value: Value, trigger: bool
) -> list[Declaration]:
    order, swapped = Orders(device.byte_order, device.word_order).of(value)
    wire = WireValue(value, order, swapped)
    return [
        *define_constants(naming, "parameter", names, value),
        BLANK,
        *access_functions(naming, device, "parameter", names, wire, value.size, trigger),
    ]
