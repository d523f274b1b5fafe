"""Numbered parameters: their numbers, their values, and how many bytes of a message are one."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout, Orders, RecordLayout
from fieldspec.language.model.device import Device
from fieldspec.language.model.registers import Parameter, ParameterSet, Subindex
from fieldspec.language.model.value import Value
from fieldspec.targets.c.declarations import (
    BLANK,
    Declaration,
    Define,
    Function,
    comment,
    describe_fact,
    describe_value,
)
from fieldspec.targets.c.expressions import (
    IN,
    NUMBER,
    OUT,
    SIZE_TYPE,
    Expression,
    Group,
    Identifier,
    Literal,
    Type,
    all_of,
    any_of,
)
from fieldspec.targets.c.literals import hexadecimal_digits, unsigned
from fieldspec.targets.c.machine import literal
from fieldspec.targets.c.naming import Naming, member
from fieldspec.targets.c.registers import ACCESS, access_functions, define_constants
from fieldspec.targets.c.statements import Body, Return, Switch, Variable, assign
from fieldspec.targets.c.values import WireValue, refuse, return_ok, status_type


def declare_parameters(naming: Naming, layout: DeviceLayout, parameters: ParameterSet) -> Iterator[list[Declaration]]:
    """The numbers of a set, then the constants and functions of its parameters, one list each."""
    device, carriers = layout.device, list(_carriers(layout, parameters))
    if parameters.base or parameters.numbers is not None:
        yield _declare_set(naming, parameters)
    for record, field in carriers:
        if field.sizes:
            yield _declare_sizes(naming, parameters, record, field)
    for parameter in parameters.parameters:
        yield _declare_parameter(naming, device, parameters, parameter, bool(carriers))
        if not parameter.reserved:
            for subindex in parameter.subindices:
                if not subindex.reserved:
                    yield _declare_subindex(naming, device, parameters, parameter, subindex, bool(carriers))


def _carriers(layout: DeviceLayout, parameters: ParameterSet) -> Iterator[tuple[RecordLayout, FieldLayout]]:
    """The fields with the bytes of values of a set, each with its record."""
    for message in layout.messages.values():
        for record in message.bodies:
            for field in record.fields:
                part = field.value.parameter if field.value is not None else None
                if part is not None and field.carries_bytes and part.set in (parameters.name, parameters.space):
                    yield record, field


def _declare_sizes(
    naming: Naming, parameters: ParameterSet, record: RecordLayout, field: FieldLayout
) -> list[Declaration]:
    """`codec_status par_objects_upload_response_data_size(const upload_response *in, size_t *out)`"""
    assert field.value is not None
    assert field.value.parameter is not None
    assert field.value.parameter.sizes is not None
    selector_field = record.named(field.value.parameter.sizes.by)
    assert selector_field is not None
    assert selector_field.value is not None
    branches = []
    for size in dict.fromkeys(field.sizes.values()):
        numbers = [number for number, own in field.sizes.items() if own == size]
        labels = tuple(literal(selector_field.value.encoding, number) for number in numbers)
        branches.append((labels, (assign(OUT.dereferenced(), unsigned(size)),)))
    kind = Type(naming.type("record", record.name), const=True, pointer=True)
    selector = IN.arrow(member(selector_field.name))
    body: Body = (
        Switch(selector.cast("int64_t"), tuple(branches), (Return(naming.status("err_unknown_value")),)),
        return_ok(naming),
    )
    function = Function(
        status_type(naming),
        naming.function("parameter", parameters.name, record.name, field.name, "size"),
        (Variable(kind, "in"), Variable(Type(SIZE_TYPE.name, pointer=True), "out")),
        body,
    )
    description = f"How many bytes of {field.name} are the value, as {selector_field.name} says."
    return [comment(f"{description} The value of a parameter has its SIZE."), function]


def wire_number_type(parameters: ParameterSet) -> str:
    """The type of the set's numbers on the wire."""
    assert parameters.numbers is not None
    return "uint16_t" if parameters.base + parameters.numbers.high <= 0xFFFF else "uint32_t"


def _parameter_number(parameters: ParameterSet, number: int) -> Literal:
    """A number of the set as a constant: in hexadecimal where the manual writes it so."""
    if parameters.base or "x}" in parameters.printed_as.lower():
        return hexadecimal_digits(number, 4, "u")
    return unsigned(number)


def _number_text(parameters: ParameterSet, number: int) -> str:
    """A number of the set in comments, without the suffix of its C type."""
    return _parameter_number(parameters, number).text.removesuffix("u")


def _declare_set(naming: Naming, parameters: ParameterSet) -> list[Declaration]:
    """The base of the set's numbers on the wire, and the function that gives one where they are a formula."""
    base_text = _number_text(parameters, parameters.base)
    base = Identifier(naming.macro("parameter", parameters.name, "base"))
    declarations: list[Declaration] = [
        describe_fact(parameters, f"On the wire, {base_text} is added to the numbers of the set."),
        Define(base.name, _parameter_number(parameters, parameters.base)),
    ]
    numbers = parameters.numbers
    if numbers is None:
        return declarations
    declarations += [
        Define(naming.macro("parameter", parameters.name, "first"), _parameter_number(parameters, numbers.low)),
        Define(naming.macro("parameter", parameters.name, "last"), _parameter_number(parameters, numbers.high)),
    ]
    example = f"{_number_text(parameters, parameters.base + numbers.low)} for {parameters.number_text(numbers.low)}"
    interval_tests: list[Expression] = []
    for low, high in numbers.intervals:
        lower_test, upper_test = (
            NUMBER.at_least(_parameter_number(parameters, low)),
            NUMBER.at_most(_parameter_number(parameters, high)),
        )
        interval_tests.append(upper_test if low == 0 else Group(all_of([lower_test, upper_test])))
    kind = wire_number_type(parameters)
    body: Body = (
        *refuse(naming, any_of(interval_tests).negated(), "err_out_of_range"),
        assign(OUT.dereferenced(), (base + NUMBER).cast(kind)),
        return_ok(naming),
    )
    function = Function(
        status_type(naming),
        naming.function("parameter", parameters.name, "wire_number"),
        (Variable(Type("uint32_t"), "number"), Variable(Type(kind, pointer=True), "out")),
        body,
    )
    description = f"A number of the set as it is on the wire: {example}. Other numbers are refused."
    return [*declarations, comment(description), function]


def _declare_parameter(
    naming: Naming, device: Device, parameters: ParameterSet, parameter: Parameter, has_size: bool
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
    constants = [("number", _parameter_number(parameters, parameters.base + parameter.number))]
    if parameter.count > 1:
        constants.append(("count", unsigned(parameter.count)))
    if parameter.elements is not None:
        constants.append(("elements", unsigned(parameter.elements)))
    if has_size:
        constants.append(("size", unsigned(parameter.value.size)))
    declarations: list[Declaration] = [
        describe_fact(parameter, " ".join(fact for fact in facts if fact), describe_value(parameter.value)),
        *(Define(naming.macro("parameter", *names, name), number) for name, number in constants),
    ]
    if parameter.reserved:
        return declarations
    return [*declarations, *_declare_parameter_value(naming, device, names, parameter.value, parameter.trigger)]


def _declare_subindex(
    naming: Naming,
    device: Device,
    parameters: ParameterSet,
    parameter: Parameter,
    subindex: Subindex,
    has_size: bool,
) -> list[Declaration]:
    names = (parameters.name, parameter.name, subindex.name)
    low, high = subindex.indices.low, subindex.indices.high
    ends = [("subindex", low)] if low == high else [("first_subindex", low), ("last_subindex", high)]
    ends += [("size", subindex.value.size)] if has_size else []
    access = f" {ACCESS[subindex.access]}" if subindex.access else ""
    return [
        describe_fact(subindex, f"Of {parameter.name}.{access}", describe_value(subindex.value)),
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
