"""What self-tests expect of constants: masks, states, codes, addresses and numbers, as numbers of their own."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.c.assertions import expect, expect_equal
from fieldspec.backends.c.enums import available_members, code_tables
from fieldspec.backends.c.expressions import (
    FALSE,
    NULL,
    TRUE,
    ZERO,
    Call,
    Cast,
    Expression,
    Identifier,
    PointerMember,
    Type,
    Unary,
    address_of,
    all_of,
    different,
    equal,
    hexadecimal,
    integer,
    string,
    unsigned,
)
from fieldspec.backends.c.flags import named_bits
from fieldspec.backends.c.naming import Naming
from fieldspec.backends.c.parameters import wire_number_type
from fieldspec.backends.c.statements import Block, Statement, Variable, discard
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.enums import Enum, Flags
from fieldspec.model.registers import ParameterSet


def test_constants(layout: DeviceLayout, naming: Naming) -> Iterator[list[Statement]]:
    """The statements, one list a function."""
    device = layout.device
    tests: tuple[list[Statement], ...] = (
        [test for word in device.flags.values() for test in _test_flags(naming, word)],
        [test for enum in device.enums.values() for test in _test_enum(naming, enum)],
        [test for enum in code_tables(device) for test in _test_code_texts(naming, enum)],
        list(_test_messages(layout, naming)),
        list(_test_addresses(layout, naming)),
        [test for parameters in device.parameters.values() for test in _test_numbers(naming, parameters)],
    )
    yield from (statements for statements in tests if statements)


def _expect_constant(name: str, number: Expression) -> Statement:
    return expect_equal(name, Identifier(name), number)


def _test_flags(naming: Naming, word: Flags) -> Iterator[Statement]:
    """The mask of each bit field, and what its function gives of a word with only its bits, and of all others."""
    size = word.type.size
    for name, bit in named_bits(word):
        ones = hexadecimal(sum(1 << number for number in range(bit.first, bit.last + 1)), size)
        mask, get = naming.macro("bit", word.name, name, "mask"), naming.function("bit", word.name, name)
        others = Cast(f"uint{8 * size}_t", Unary("~", ones))
        wide = bit.width > 1
        yield _expect_constant(mask, ones)
        yield expect_equal(get, Call(get, (ones,)), integer((1 << bit.width) - 1, size, False) if wide else TRUE)
        yield expect_equal(get, Call(get, (others,)), ZERO if wide else FALSE)
    if word.states:
        yield from _test_states(naming, word)


def _test_states(naming: Naming, word: Flags) -> Iterator[Statement]:
    """What the word shows with exactly the bits of each state, with none, and with all."""
    bits = {bit.name: bit.mask for bit in word.bits}
    words = [sum(bits[name] for name in state.set) for state in word.states]
    function = naming.function("word", word.name, "state_of")
    for number in sorted({0, word.type.high, *words}):
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
    """Which values a closed enum knows."""
    members = available_members(enum)
    largest = max((member.value for member in members), default=0)
    wide = largest >= 2**63
    if not enum.open:
        known = naming.function("enum", enum.name, "known")
        for member in members:
            yield expect_equal(known, Call(known, (integer(member.value, 8, not wide),)), TRUE)
        if largest + 1 < 2**63:
            yield expect_equal(known, Call(known, (integer(largest + 1, 8),)), FALSE)


def _test_code_texts(naming: Naming, enum: Enum) -> Iterator[Statement]:
    """The names of codes, and that a code which there is not has no texts."""
    function = naming.function("enum", enum.name, "text")
    for member in [member for member in enum.members if member.value < 2**63]:
        result = Call(function, (integer(member.value, 8),))
        number = integer(-1 if member.number is None else member.number, 8)
        tests: list[Expression] = [different(result, NULL), equal(PointerMember(result, "number"), number)]
        for text, name in ((member.name, "name"), (member.printed_name, "printed")):
            tests.append(Call("same_text", (PointerMember(result, name), string(text))))
        yield expect(all_of(tests), function)
    unknown = next(code for code in range(len(enum.members) + 1) if enum.member(code) is None)
    yield expect_equal(function, Call(function, (integer(unknown, 8),)), NULL)


def _test_messages(layout: DeviceLayout, naming: Naming) -> Iterator[Statement]:
    for message in layout.messages.values():
        for kind, number in (("code", message.message.code), ("number", message.message.number)):
            if number is not None:
                yield _expect_constant(naming.macro("message", message.name, kind), unsigned(number))


def _test_addresses(layout: DeviceLayout, naming: Naming) -> Iterator[Statement]:
    for register in layout.registers:
        yield _expect_constant(naming.macro("register", register.name, "address"), unsigned(register.address))
    for table in layout.tables.values():
        last = table.table.indexes[-1]
        function = naming.function("table", table.name, "at")
        yield _test_last(naming, function, "uint16_t", "address", last, table.table.address(last))


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


def _test_last(naming: Naming, function: str, kind: str, result: str, last: int, wanted: int) -> Block:
    """What a function from numbers to addresses gives for the last number, and that it refuses the one behind it."""
    variable = Identifier(result)

    def result_of(number: int) -> Call:
        return Call(function, (unsigned(number), address_of(variable)))

    return Block(
        (
            Variable(Type(kind), result, value=ZERO),
            expect_equal(f"{function} last", result_of(last), naming.status("ok")),
            expect_equal(f"{function} last {result}", variable, unsigned(wanted)),
            expect_equal(f"{function} beyond", result_of(last + 1), naming.status("err_out_of_range")),
            discard(result),
        )
    )
