"""Values that have an address: registers and tables of records; and signals."""

from __future__ import annotations

from fieldspec.codec.layout.device import TableLayout
from fieldspec.codec.layout.record import RegisterLayout
from fieldspec.foundation.classes import replace
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_exact
from fieldspec.language.model.value import Signal, Value
from fieldspec.targets.c.declarations import (
    BLANK,
    Declaration,
    Define,
    Function,
    comment,
    describe_fact,
    describe_value,
)
from fieldspec.targets.c.enums import enum_type, integer_reason
from fieldspec.targets.c.expressions import (
    IN,
    INPUT_BYTES,
    NUMBER,
    OUT,
    OUTPUT_BYTES,
    VALUE,
    Expression,
    Identifier,
    Type,
)
from fieldspec.targets.c.literals import ZERO, decimal, hexadecimal, unsigned
from fieldspec.targets.c.machine import literal, macro_literal
from fieldspec.targets.c.naming import Naming, Noun
from fieldspec.targets.c.runtime_files import is_bit
from fieldspec.targets.c.scales import define_fractions
from fieldspec.targets.c.statements import Body, Variable, assign
from fieldspec.targets.c.values import (
    WireValue,
    accessed_type,
    declare_value,
    decode_enum,
    decode_value,
    encode_enum,
    encode_value,
    refuse,
    return_ok,
    status_type,
    store_constant,
)

ACCESS = {
    "ro": "Read only.",
    "rw": "Read and write.",
    "wo": "Write only.",
    "": "The manual does not say how it is accessed.",
}


# Constants and functions of a value


def define_constants(naming: Naming, noun: Noun, names: tuple[str, ...], value: Value) -> list[Declaration]:
    """`#define GADGET_REG_SPEED_MAX 3000`: constant, range, default and scale, in counts or as a fraction."""
    encoding = value.encoding
    constants: list[tuple[str, Expression]] = []
    if value.const is not None:
        constants.append(("value", literal(encoding, value.const)))
    if value.ranges is not None:
        constants += [
            ("min", macro_literal(encoding, value.ranges.low)),
            ("max", macro_literal(encoding, value.ranges.high)),
        ]
    if value.write_ranges is not None:
        low, high = value.write_ranges.low, value.write_ranges.high
        constants += [("write_min", macro_literal(encoding, low)), ("write_max", macro_literal(encoding, high))]
    if isinstance(value.default, int) and is_exact(encoding):
        constants.append(("default", literal(encoding, value.default)))
    defined: list[Declaration] = [Define(naming.macro(noun, *names, name), number) for name, number in constants]
    return defined + define_fractions(naming, noun, names, value.scale, value.offset)


def access_functions(
    naming: Naming,
    device: Device,
    noun: Noun,
    names: tuple[str, ...],
    wire: WireValue,
    size: int,
    trigger: bool,
) -> list[Declaration]:
    """The functions that read and write a value, as its bytes lie in a frame, filled up to `size` bytes.

    The response of the device is always read. Only what is written must be the constant or, of a `trigger`, a member of
    its closed enum. A value of a closed enum has the type of the enum where that holds all that it may be.

    `codec_status reg_speed_decode(const uint8_t *in, uint16_t *out)`, `reg_speed_encode(uint16_t value, uint8_t *out)`
    """
    value = wire.value
    answer, wire = (
        replace(wire, value=value.as_answer(trigger)),
        replace(wire, swapped=value.write_swapped(wire.swapped)),
    )
    result_type = Type(accessed_type(naming, device, answer.value), pointer=True)
    result = declare_value(wire, "out") if wire.is_array else Variable(result_type, "out")
    inputs, outputs = (Variable(INPUT_BYTES, "in"), result), [Variable(OUTPUT_BYTES, "out")]
    if enum_type(device, answer.value) is not None:
        decode = decode_enum(naming, device, answer)
    else:
        decode = decode_value(naming, device, answer, IN, OUT if wire.is_array else OUT.dereferenced())
    if value.const is not None:
        encode = store_constant(naming, wire, value.const, OUT)
    elif enum_type(device, value) is not None:
        encode = encode_enum(naming, device, wire)
        outputs.insert(0, Variable(Type(accessed_type(naming, device, value)), "value"))
    else:
        encode = encode_value(naming, device, wire, VALUE, OUT)
        outputs.insert(0, declare_value(wire, "value", const=wire.is_array))
    padding = [assign(OUT.element(decimal(index)), ZERO) for index in range(wire.size, size)]
    source, target = "", ""
    if noun == "register":
        bytes_text = f"its {size} byte{'s' * (size > 1)}"
        source, target = f" from {bytes_text}", f" into {bytes_text}"
    reason = integer_reason(device, value)
    answer_reason = integer_reason(device, answer.value)
    if value.enum and value.const is None and answer.value.enum != value.enum and not device.enums[value.enum].open:
        answer_reason = f"An integer, as the device may answer what {value.enum} does not have."
    decode_name, encode_name = naming.function(noun, *names, "decode"), naming.function(noun, *names, "encode")
    return [
        comment(f"Decodes the value{source}.", answer_reason),
        Function(status_type(naming), decode_name, inputs, (*decode, return_ok(naming))),
        BLANK,
        comment(f"Encodes the value{target}.", reason),
        Function(status_type(naming), encode_name, tuple(outputs), (*encode, *padding, return_ok(naming))),
    ]


# Registers and tables of records


def declare_register(naming: Naming, device: Device, layout: RegisterLayout) -> list[Declaration]:
    """The constants of a register, and the functions for its value."""
    register, value = layout.register, layout.register.value
    unit = "words" if register.unit_size > 1 else "bytes"
    facts = (
        f"In the address space {device.space_name(register.space)}." if device.several_spaces else "",
        ACCESS[register.access],
        "A change takes effect after a restart." if register.restart else "",
        "Writing starts an action." if register.trigger else "",
        f"A bit: {naming.own('load_bit')} takes it out of the bytes of a message." if is_bit(layout) else "",
        f"{layout.words} {unit} must be accessed in one request." if register.atomic and layout.words > 1 else "",
        f"The same as {register.same_as}." if register.same_as else "",
        f"A copy of {register.copy_of}." if register.copy_of else "",
    )
    constants: list[tuple[str, Expression]] = [("address", hexadecimal(layout.address, 2))]
    if not is_bit(layout):
        constants.append((unit, unsigned(layout.words)))
    if register.number is not None:
        constants.append(("number", unsigned(register.number)))
    if layout.count > 1:
        constants += [
            ("count", unsigned(layout.count)),
            ("stride", unsigned(layout.stride)),
            ("first", unsigned(register.index_from)),
        ]
    names = (layout.name,)
    wire = WireValue(value, layout.order, layout.swapped)
    declarations: list[Declaration] = [
        describe_fact(register, " ".join(fact for fact in facts if fact), describe_value(value)),
        *(Define(naming.macro("register", layout.name, name), number) for name, number in constants),
        *define_constants(naming, "register", names, value),
    ]
    if not is_bit(layout):
        declarations += [
            BLANK,
            *access_functions(naming, device, "register", names, wire, layout.size, register.trigger),
        ]
    if layout.count > 1:
        declarations += [BLANK, *_address_function(naming, "register", layout.name, f"{layout.name} by its number")]
    return declarations


def declare_table(naming: Naming, device: Device, layout: TableLayout) -> list[Declaration]:
    """The constants of a table, and the function that gives an element's address."""
    table = layout.table
    access = ACCESS[table.access] if table.access else ""
    if device.several_spaces:
        access = f"In the address space {device.space_name(table.space)}. {access}".strip()
    read_only = f"Read only: {', '.join(layout.read_only)}." if layout.read_only else ""
    count_text = f"The register {table.count_by} has the actual number." if table.count_by else ""
    base_text = f"The register {table.base_by} has the address of the first one." if table.base_by else ""
    constants = [
        ("usual_address" if table.base_by else "address", hexadecimal(table.base, 2)),
        ("words", unsigned(layout.words)),
        ("stride", unsigned(table.stride)),
        ("count", unsigned(table.count)),
        ("first", unsigned(table.index_from)),
    ]
    return [
        describe_fact(
            table,
            f"Its elements are {naming.type('record', layout.record.name)}.",
            count_text,
            base_text,
            access,
            read_only,
        ),
        *(Define(naming.macro("table", layout.name, name), number) for name, number in constants),
        BLANK,
        *_address_function(
            naming, "table", layout.name, f"an element of {table.name} by its number", layout if table.base_by else None
        ),
    ]


def _address_function(
    naming: Naming, noun: Noun, name: str, subject: str, moving: TableLayout | None = None
) -> list[Declaration]:
    """`codec_status table_points_at(uint32_t number, uint16_t *address)`

    The function of a `moving` table has `uint16_t base` before the number.
    """
    first, count, stride = (Identifier(naming.macro(noun, name, end)) for end in ("first", "count", "stride"))
    base = Identifier("base") if moving is not None else Identifier(naming.macro(noun, name, "address"))
    index = NUMBER - first
    address = (base + (index * stride)).cast("uint16_t")
    extent = moving.table.stride * (moving.table.count - 1) + moving.words if moving is not None else 1
    fits = refuse(naming, base.greater(hexadecimal(0x10000 - extent, 2)), "err_out_of_range") if extent > 1 else ()
    body: Body = (
        *refuse(naming, index.at_least(count), "err_out_of_range"),
        *fits,
        assign(Identifier("address").dereferenced(), address),
        return_ok(naming),
    )
    parameters = (
        *((Variable(Type("uint16_t"), "base"),) if moving is not None else ()),
        Variable(Type("uint32_t"), "number"),
        Variable(Type("uint16_t", pointer=True), "address"),
    )
    start = " The first one is at `base`; all must fit after it." if moving is not None else ""
    return [
        comment(f"The address of {subject}; other numbers are refused.{start}"),
        Function(status_type(naming), naming.function(noun, name, "at"), parameters, body),
    ]


# Signals


def declare_signal(naming: Naming, signal: Signal) -> list[Declaration]:
    """The constants of a signal of messages; nothing where it has none."""
    constants = define_constants(naming, "signal", (signal.name,), signal.value)
    return [describe_fact(signal, describe_value(signal.value)), *constants] if constants else []
