"""What self-tests expect of constants: masks, states, codes, addresses and numbers, as numbers of their own."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.c.assertions import same
from fieldspec.backends.c.enums import available, coded
from fieldspec.backends.c.naming import Naming
from fieldspec.backends.c.parameters import wire_type
from fieldspec.backends.c.text import hexadecimal, indented, integer, string
from fieldspec.backends.c.words import named_bits
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.enums import Enum, Flags
from fieldspec.model.registers import ParameterSet


def constants(layout: DeviceLayout, naming: Naming) -> Iterator[list[str]]:
    """The statements, one list a function."""
    device = layout.device
    found = [
        [line for word in device.flags.values() for line in _word(naming, word)],
        [line for enum in device.enums.values() for line in _enum(naming, enum)],
        [line for enum in coded(device) for line in _texts(naming, enum)],
        list(_messages(layout, naming)),
        list(_addresses(layout, naming)),
        [line for held in device.parameters.values() for line in _numbers(naming, held)],
    ]
    yield from (lines for lines in found if lines)


def _word(naming: Naming, word: Flags) -> Iterator[str]:
    size = word.type.size
    for name, bit in named_bits(word):
        ones = hexadecimal(sum(1 << number for number in range(bit.first, bit.last + 1)), size)
        mask, get = naming.macro("bit", word.name, name, "mask"), naming.function("bit", word.name, name)
        yield same(mask, mask, ones)
        yield same(get, f"{get}({ones})", integer((1 << bit.width) - 1, size, False) if bit.width > 1 else "true")
        yield same(get, f"{get}((uint{8 * size}_t)~{ones})", "0" if bit.width > 1 else "false")
    if word.states:
        yield from _states(naming, word)


def _states(naming: Naming, word: Flags) -> Iterator[str]:
    """What the word shows with exactly the bits of each state, with none, and with all."""
    bits = {bit.name: bit.mask for bit in word.bits}
    held = [sum(bits[name] for name in state.set) for state in word.states]
    tell = naming.function("word", word.name, "state_of")
    for number in sorted({0, word.type.high, *held}):
        shown = [
            state
            for state in word.states
            if all(number & bits[name] == bits[name] for name in state.set)
            and not any(number & bits[name] for name in state.clear)
        ]
        wanted = (
            naming.macro("state", word.name, "state", shown[0].name)
            if shown
            else naming.macro("word", word.name, "no_state")
        )
        yield same(f"{tell} {number:#x}", f"{tell}({hexadecimal(number, word.type.size)})", wanted)


def _enum(naming: Naming, enum: Enum) -> Iterator[str]:
    """Which values a closed enum knows."""
    members = available(enum)
    largest = max((member.value for member in members), default=0)
    wide = largest >= 2**63
    if not enum.open:
        known = naming.function("enum", enum.name, "known")
        for member in members:
            yield same(known, f"{known}({integer(member.value, 8, not wide)})", "true")
        if largest + 1 < 2**63:
            yield same(known, f"{known}({integer(largest + 1, 8)})", "false")


def _texts(naming: Naming, enum: Enum) -> Iterator[str]:
    """The names of codes, and what is said of a code that there is not."""
    text = naming.function("enum", enum.name, "text")
    for member in [member for member in enum.members if member.value < 2**63]:
        call, number = f"{text}({integer(member.value, 8)})", -1 if member.number is None else member.number
        names = ((member.name, "name"), (member.printed_name, "printed"))
        tests = [f"same_text({call}->{end}, {string(name)})" for name, end in names]
        tests = [f"{call} != NULL", f"{call}->number == {integer(number, 8)}", *tests]
        yield f"expect({' && '.join(tests)}, {string(text)});"
    unknown = next(code for code in range(len(enum.members) + 1) if enum.member(code) is None)
    yield same(text, f"{text}({integer(unknown, 8)})", "NULL")


def _messages(layout: DeviceLayout, naming: Naming) -> Iterator[str]:
    for message in layout.messages.values():
        for kind, number in (("code", message.message.code), ("number", message.message.number)):
            if number is not None:
                name = naming.macro("message", message.name, kind)
                yield same(name, name, f"{number}u")


def _addresses(layout: DeviceLayout, naming: Naming) -> Iterator[str]:
    refused, ok = naming.own_macro("err_out_of_range"), naming.own_macro("ok")
    for register in layout.registers:
        name = naming.macro("register", register.name, "address")
        yield same(name, name, f"{register.address}u")
    for table in layout.tables.values():
        last = table.table.indexes[-1]
        call = naming.function("table", table.name, "at")
        yield from ["{", "    uint16_t address = 0;"]
        yield from indented([same(f"{call} last", f"{call}({last}u, &address)", ok)])
        yield from indented([same(f"{call} last address", "address", f"{table.table.address(last)}u")])
        yield from indented([same(f"{call} beyond", f"{call}({last + 1}u, &address)", refused), "(void)address;"])
        yield "}"


def _numbers(naming: Naming, held: ParameterSet) -> Iterator[str]:
    for parameter in held.parameters:
        name = naming.macro("parameter", held.name, parameter.name, "number")
        yield same(name, name, f"{held.base + parameter.number}u")
        for inner in parameter.subindices if not parameter.reserved else ():
            if not inner.reserved:
                end = "subindex" if inner.indices.low == inner.indices.high else "last_subindex"
                name = naming.macro("parameter", held.name, parameter.name, inner.name, end)
                yield same(name, name, f"{inner.indices.high}u")
    if held.numbers is None:
        return
    call, last = naming.function("parameter", held.name, "wire_number"), held.numbers.high
    yield from ["{", f"    {wire_type(held)} number = 0;"]
    yield from indented([same(f"{call} last", f"{call}({last}u, &number)", naming.own_macro("ok"))])
    yield from indented([same(f"{call} last number", "number", f"{held.base + last}u")])
    refused = naming.own_macro("err_out_of_range")
    yield from indented([same(f"{call} beyond", f"{call}({last + 1}u, &number)", refused), "(void)number;"])
    yield "}"
