"""What self-tests expect of constants, and of registers, parameters and conversions at their bounds."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction
from typing import TypeVar

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RegisterLayout
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import bounds_of, is_count
from fieldspec.language.model.enums import Enum, Flags
from fieldspec.language.model.registers import ParameterSet
from fieldspec.language.model.value import Conversion, Value
from fieldspec.targets.c.assertions import expect, expect_bytes, expect_equal, expect_quantity
from fieldspec.targets.c.conversions import count_bounds, count_type
from fieldspec.targets.c.enums import available_members, code_tables, enum_type
from fieldspec.targets.c.expressions import Call, Expression, Identifier, Type, Unary, all_of
from fieldspec.targets.c.flags import named_bits, number_of_bit
from fieldspec.targets.c.literals import (
    FALSE,
    INT64,
    NULL,
    TRUE,
    UINT64,
    ZERO,
    byte_initializer,
    decimal,
    double,
    hexadecimal,
    integer,
    string,
    unsigned,
    whole_double,
)
from fieldspec.targets.c.machine import literal, machine
from fieldspec.targets.c.naming import Naming, Noun
from fieldspec.targets.c.parameters import wire_number_type
from fieldspec.targets.c.printer import INDENT, Printer
from fieldspec.targets.c.quantities import keeps_counts
from fieldspec.targets.c.sample_values import legal_numbers, value_bytes
from fieldspec.targets.c.statements import Block, CompileIf, Printed, Statement, Variable, assign, discard
from fieldspec.targets.c.values import accessed_type, type_name
from fieldspec.targets.pieces import piece, register_runs


def test_constants(layout: DeviceLayout, naming: Naming) -> Iterator[list[Statement]]:
    """The statements, one list a function."""
    device = layout.device
    tests: tuple[list[Statement], ...] = (
        [_printed(naming, "flags", word, _test_flags) for word in device.flags.values()],
        [test for enum in device.enums.values() if (test := _printed(naming, "enum", enum, _test_enum)).lines],
        [_printed(naming, "codes", enum, _test_code_texts) for enum in code_tables(device)],
        list(_test_messages(layout, naming)),
        list(_test_addresses(layout, naming)),
        [test for parameters in device.parameters.values() for test in _test_numbers(naming, parameters)],
    )
    yield from (statements for statements in tests if statements)


Tested = TypeVar("Tested")


def _printed(naming: Naming, kind: str, fact: Tested, test: Callable[[Naming, Tested], Iterable[Statement]]) -> Printed:
    """The tests of a fact of the model, or of a tuple of them, that depend on nothing else."""

    def make() -> Printed:
        return Printed(tuple(Printer().print_statements(test(naming, fact), INDENT)))

    return piece(f"c test of {kind}", fact if isinstance(fact, tuple) else (fact,), (), make, naming)


def _expect_constant(name: str, number: Expression) -> Statement:
    return expect_equal(name, Identifier(name), number)


def _test_flags(naming: Naming, word: Flags) -> Iterator[Statement]:
    """The mask of each bit field, and what its function gives of a word with only its bits, and of all others."""
    size = word.type.size
    for name, bit in named_bits(word):
        all_bits = hexadecimal(sum(1 << number for number in bit.places), size)
        mask, get = naming.macro("bit", word.name, name, "mask"), naming.function("bit", word.name, name)
        other_bits = Unary("~", all_bits).cast(machine(word.type.encoding).word)
        wide = bit.width > 1
        yield _expect_constant(mask, all_bits)
        all_ones = integer(-1 if bit.signed else (1 << bit.width) - 1, number_of_bit(word, bit))
        yield expect_equal(get, Call(get, (all_bits,)), all_ones if wide else TRUE)
        yield expect_equal(get, Call(get, (other_bits,)), ZERO if wide else FALSE)
    if word.states:
        yield from _test_states(naming, word)


def _test_states(naming: Naming, word: Flags) -> Iterator[Statement]:
    """Tests the state of a word with exactly the bits of each state, with no bit, and with all bits."""
    bits = {bit.name: bit.mask for bit in word.bits}
    words = [sum(bits[name] for name in state.set) for state in word.states]
    function = naming.function("word", word.name, "state_of")
    for number in sorted({0, bounds_of(word.type.encoding)[1], *words}):
        matches = [
            state
            for state in word.states
            if all(number & bits[name] == bits[name] for name in state.set)
            and not any(number & bits[name] for name in state.clear)
        ]
        state = (
            naming.macro("state", word.name, "state", matches[0].name)
            if matches
            else naming.macro("word", word.name, "no_state")
        )
        result = Call(function, (hexadecimal(number, word.type.size),))
        yield expect_equal(f"{function} {number:#x}", result, Identifier(state))


def _test_enum(naming: Naming, enum: Enum) -> Iterator[Statement]:
    """Compares the numbers that the function of a closed enum accepts with the numbers of its members."""
    members = available_members(enum)
    largest = max((member.value for member in members), default=0)
    wide = largest >= 2**63
    if not enum.open:
        known = naming.function("enum", enum.name, "known")
        for member in members:
            yield expect_equal(known, Call(known, (integer(member.value, UINT64 if wide else INT64),)), TRUE)
        if largest + 1 < 2**63:
            yield expect_equal(known, Call(known, (integer(largest + 1, INT64),)), FALSE)


def _test_code_texts(naming: Naming, enum: Enum) -> Iterator[Statement]:
    """The names of codes, and that a code which there is not has no texts."""
    function = naming.function("enum", enum.name, "text")
    for member in [member for member in enum.members if member.value < 2**63]:
        result = Call(function, (integer(member.value, INT64),))
        number = integer(-1 if member.number is None else member.number, INT64)
        tests: list[Expression] = [result.differs(NULL), result.arrow("number").equals(number)]
        for text, name in ((member.name, "name"), (member.printed_name, "printed")):
            tests.append(Call("same_text", (result.arrow(name), string(text))))
        yield expect(all_of(tests), function)
    unknown = next(code for code in range(len(enum.members) + 1) if enum.member(code) is None)
    yield expect_equal(function, Call(function, (integer(unknown, INT64),)), NULL)


def _test_messages(layout: DeviceLayout, naming: Naming) -> Iterator[Statement]:
    for message in layout.messages.values():
        own = message.message
        request_code = own.code_of("request")
        response_code = own.code_of("response") if own.has_response_code else None
        for kind, number in (("code", request_code), ("response_code", response_code), ("number", own.number)):
            if number is not None:
                yield _expect_constant(naming.macro("message", message.name, kind), unsigned(number))


def _test_addresses(layout: DeviceLayout, naming: Naming) -> Iterator[Statement]:
    for run, _ in register_runs(layout):
        yield _printed(naming, "addresses", run, _test_run)
    for table in layout.tables.values():
        last = table.table.indexes[-1]
        function = naming.function("table", table.name, "at")
        base = (unsigned(table.table.base),) if table.table.base_by else ()
        yield _test_last(naming, function, "uint16_t", "address", last, table.table.address(last), base)


def _test_run(naming: Naming, registers: Sequence[RegisterLayout]) -> Iterator[Statement]:
    for register in registers:
        yield _expect_constant(naming.macro("register", register.name, "address"), unsigned(register.address))


def _test_numbers(naming: Naming, parameters: ParameterSet) -> Iterator[Statement]:
    for parameter in parameters.parameters:
        name = naming.macro("parameter", parameters.name, parameter.name, "number")
        yield _expect_constant(name, unsigned(parameters.base + parameter.number))
        for inner in parameter.subindices if not parameter.reserved else ():
            if not inner.reserved:
                end = "subindex" if inner.indices.low == inner.indices.high else "last_subindex"
                name = naming.macro("parameter", parameters.name, parameter.name, inner.name, end)
                yield _expect_constant(name, unsigned(inner.indices.high))
    if parameters.numbers is not None:
        function, last = naming.function("parameter", parameters.name, "wire_number"), parameters.numbers.high
        yield _test_last(naming, function, wire_number_type(parameters), "number", last, parameters.base + last)


def _test_last(
    naming: Naming, function: str, kind: str, result: str, last: int, expected: int, before: tuple[Expression, ...] = ()
) -> Block:
    """Tests a function from numbers to addresses: its result for the last number, and that it rejects
    the next number.
    """
    variable = Identifier(result)

    def result_of(number: int) -> Call:
        return Call(function, (*before, unsigned(number), variable.address()))

    return Block(
        (
            Variable(Type(kind), result, value=ZERO),
            expect_equal(f"{function} last", result_of(last), naming.status("ok")),
            expect_equal(f"{function} last {result}", variable, unsigned(expected)),
            expect_equal(f"{function} beyond", result_of(last + 1), naming.status("err_out_of_range")),
            discard(result),
        )
    )


_BYTES, _OTHER, _IN, _OUT, _RAW = (Identifier(name) for name in ("bytes", "other", "in", "out", "raw"))
_OUT_POINTER = _OUT.address()
_REFERENCE = 3000
"""The reference of quantities in tests: a usual speed in revolutions a minute."""


def test_value(
    device: Device,
    naming: Naming,
    noun: Noun,
    names: tuple[str, ...],
    value: Value,
    order: tuple[str, bool],
    size: int,
    trigger: bool,
) -> Iterator[list[Statement]]:
    """The value of a register or a parameter at its bounds; nothing for what is not a number."""
    if not is_count(value.encoding):
        return
    encode, decode = naming.function(noun, *names, "encode"), naming.function(noun, *names, "decode")
    ok, label = naming.status("ok"), ".".join(names)
    body: list[Statement] = [Variable(Type("uint8_t"), "bytes", (decimal(size),))]
    kind = Type(type_name(value))
    if value.const is not None:
        data = _write_bytes(value, order, value.const, size)
        other = 0 if value.const else 1
        other_data = byte_initializer(value_bytes(value, *order, other).ljust(size, b"\0"))
        yield [
            *body,
            Variable(kind, "out", value=ZERO),
            Variable(Type("uint8_t"), "other", (None,), other_data, "static const"),
            expect_equal(label, Call(encode, (_BYTES,)), ok),
            expect_bytes(f"{label} bytes", _BYTES, data),
            *_answer(value, order, value.const),
            expect_equal(label, Call(decode, (_BYTES, _OUT_POINTER)), ok),
            expect_equal(label, _OUT, literal(value.encoding, value.const)),
            expect_equal(f"{label} {other}", Call(decode, (_OTHER, _OUT_POINTER)), ok),
            expect_equal(f"{label} {other}", _OUT, literal(value.encoding, other)),
        ]
        return
    numbers = sorted(set(legal_numbers(device, value)))
    encoded_constants = _constants(naming, device, value, numbers)
    decoded_constants = _constants(naming, device, value.as_answer(trigger), numbers)
    out_type, in_type = (Type(accessed_type(naming, device, content)) for content in (value.as_answer(trigger), value))
    # An enum has no neutral value: `out` starts with another number than the first that is read.
    out_start = ZERO if enum_type(device, value.as_answer(trigger)) is None else decoded_constants[numbers[-1]]
    in_start = ZERO if enum_type(device, value) is None else encoded_constants[numbers[0]]
    body += [Variable(out_type, "out", value=out_start), Variable(in_type, "in", value=in_start, storage="volatile")]
    encoded, decoded = Call(encode, (_IN, _BYTES)), Call(decode, (_BYTES, _OUT_POINTER))
    for number in numbers:
        data = _write_bytes(value, order, number, size)
        description = f"{label} {number}"
        body += [
            assign(_IN, encoded_constants[number]),
            expect_equal(description, encoded, ok),
            expect_bytes(f"{description} bytes", _BYTES, data),
            *_answer(value, order, number),
            expect_equal(description, decoded, ok),
            expect_equal(description, _OUT, decoded_constants[number]),
        ]
    yield body


def _write_bytes(value: Value, order: tuple[str, bool], number: int, size: int) -> bytes:
    """The bytes of a number in a write, whose word order may differ from the word order of a read."""
    byte_order, swapped = order
    return value_bytes(value, byte_order, value.write_swapped(swapped), number).ljust(size, b"\0")


def _answer(value: Value, order: tuple[str, bool], number: int) -> Iterator[Statement]:
    """Writes the bytes of a read over the bytes of a write, where the word orders differ."""
    if value.write_word_order:
        for place, byte in enumerate(value_bytes(value, *order, number)):
            yield assign(_BYTES.element(decimal(place)), hexadecimal(byte, 1))


def _constants(naming: Naming, device: Device, value: Value, numbers: list[int]) -> dict[int, Expression]:
    """Numbers of a value as C constants: the names of its enum where they have its type."""
    enum = enum_type(device, value)
    if enum is None:
        return {number: literal(value.encoding, number) for number in numbers}
    names = {member.value: member.name for member in available_members(enum)}
    return {number: Identifier(naming.macro("enum", enum.name, names[number])) for number in numbers}


def test_conversions(layout: DeviceLayout, naming: Naming) -> Iterator[list[Statement]]:
    """Each conversion at its bounds, there and back, between two counts, and beyond the bounds."""
    for conversion in layout.device.conversions.values():
        body = _test_conversion(layout.device, naming, conversion)
        yield [CompileIf("ifndef", naming.own_macro("without_double"), tuple(body))]


def _test_conversion(device: Device, naming: Naming, conversion: Conversion) -> list[Statement]:
    encoding = conversion.type.encoding
    from_raw = naming.function("conversion", conversion.name, "from_raw")
    to_raw = naming.function("conversion", conversion.name, "to_raw")
    ok, out_of_range = naming.status("ok"), naming.status("err_out_of_range")
    reference, raw = whole_double(_REFERENCE), _RAW.address()
    low, high = count_bounds(device, conversion)
    body: list[Statement] = [Variable(Type(count_type(conversion)), "raw", value=ZERO)]
    counts = {low, 0, 1, conversion.full_scale, high}
    for number in sorted(count for count in counts if low <= count <= high):
        count, description = literal(encoding, number), f"{conversion.name} {number}"
        expected = float(conversion.quantity(number, Fraction(_REFERENCE)))
        quantity = Call(from_raw, (count, reference))
        body += expect_quantity(quantity, expected, description, least_tolerance=1e-12)
        if keeps_counts(encoding):
            body += [
                expect_equal(f"{description} back", Call(to_raw, (quantity, reference, raw)), ok),
                expect_equal(f"{description} back", _RAW, count),
            ]
    if conversion.full_scale & (conversion.full_scale - 1) == 0 and low <= 0 and high > 2:
        # A reference as large as the full scale makes halves of counts exact.
        exact = Fraction(conversion.full_scale)
        for doubled, even in ((1, 0), (3, 2), (5, 2)):
            half = float(conversion.quantity(doubled, exact / 2) + (exact / 2 if conversion.complement else 0))
            description = f"{conversion.name} {doubled}/2"
            arguments: tuple[Expression, ...] = (double(half), double(float(exact)), raw)
            body += [
                expect_equal(description, Call(to_raw, arguments), ok),
                expect_equal(description, _RAW, literal(encoding, even)),
            ]
    excessive = double(float(conversion.quantity(2 * high + 2 - low, Fraction(1))))
    unit = whole_double(1)
    return [
        *body,
        expect_equal(f"{conversion.name} beyond", Call(to_raw, (excessive, unit, raw)), out_of_range),
        expect_equal(f"{conversion.name} of nothing", Call(to_raw, (unit, whole_double(0), raw)), out_of_range),
        discard("raw"),
    ]
