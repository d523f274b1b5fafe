"""Words of flags: their masks, the functions of their bits, and their states."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from fieldspec.codec.layout.needed_bits import needed_bits
from fieldspec.language.model.encoding import Sign, Whole
from fieldspec.language.model.enums import Bit, Enum, Flags
from fieldspec.targets.c.declarations import (
    BLANK,
    Declaration,
    Define,
    Enumeration,
    Enumerator,
    Function,
    Typedef,
    comment,
    describe_fact,
    escape_comment,
)
from fieldspec.targets.c.expressions import VALUE, Expression, Group, Identifier, Operation, Type, Unary
from fieldspec.targets.c.literals import ZERO, decimal, hexadecimal, integer, unsigned
from fieldspec.targets.c.machine import machine, machine_bits
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.scales import define_fractions
from fieldspec.targets.c.statements import If, Return, Variable

_WORD = Identifier("word")


def named_bits(word: Flags) -> list[tuple[str, Bit]]:
    """The bits that have a meaning, by names that differ: bits of one name under several conditions are numbered."""
    bits_by_name: dict[str, Bit] = {}
    for bit in word.bits:
        if bit.reserved or any(other.name == bit.name and other.mask == bit.mask for other in bits_by_name.values()):
            continue
        name, number = bit.name, 1
        while name in bits_by_name:
            number += 1
            name = f"{bit.name}_{number}"
        bits_by_name[name] = bit
    return list(bits_by_name.items())


def declare_flags(naming: Naming, word: Flags, enums: Mapping[str, Enum]) -> list[Declaration]:
    """Masks, shifts, and a function for each bit or bit field; then the states."""
    kind = Type(machine(word.type.encoding).word)
    requirements = [
        escape_comment(f"Set {required.bit.name}: its {required.reason}.") for required in needed_bits(word, enums)
    ]
    declarations: list[Declaration] = [describe_fact(word, f"A word of {8 * word.type.size} bits.", *requirements)]
    declarations.append(Typedef(kind, naming.type("word", word.name)))
    if any(bit.default is not None for bit in word.bits):
        initial = naming.macro("word", word.name, "initial")
        declarations += [
            comment("The word of which nothing is given: its defaults, and 0 elsewhere."),
            Define(initial, hexadecimal(word.initial, word.type.size)),
        ]
    for name, bit in named_bits(word):
        declarations += [BLANK, *_declare_bit(naming, word, name, bit, kind)]
    if word.states:
        declarations += [BLANK, *_declare_states(naming, word, kind)]
    return declarations


def _scaling(bit: Bit) -> str:
    """`1 count = 0.1 mm, plus 5 mm.`"""
    if not bit.as_value.scaled:
        return f"In {escape_comment(bit.unit)}." if bit.unit else ""
    offset = f", plus {bit.offset:f} {bit.unit}".rstrip() if bit.offset else ""
    return escape_comment(f"1 count = {bit.scale_text or '1'} {bit.unit}".rstrip() + f"{offset}.")


def _declare_bit(naming: Naming, word: Flags, name: str, bit: Bit, kind: Type) -> list[Declaration]:
    levels = [f"{n}: {text}." for n, text in ((0, bit.zero), (1, bit.one)) if text]
    facts = [
        " ".join(levels),
        f"It acts on its {bit.edge} edge." if bit.edge else "",
        "It is active low: 0 means what its name says." if bit.active == "low" else "",
        f"See {bit.enum}." if bit.enum else "",
        f"When {bit.when}." if bit.when else "",
        f"A signed number of {bit.width} bits." if bit.signed else "",
        _scaling(bit),
        f"{bit.default} by default." if bit.default is not None else "",
    ]
    mask = Identifier(naming.macro("bit", word.name, name, "mask"))
    shift = Identifier(naming.macro("bit", word.name, name, "shift"))
    get = naming.function("bit", word.name, name)
    masked = _WORD & mask
    parameter = Variable(kind, "word")
    declarations: list[Declaration] = [
        describe_fact(bit, *facts),
        Define(mask.name, hexadecimal(bit.mask, word.type.size)),
        *([] if bit.pieces else [Define(shift.name, unsigned(bit.first))]),
    ]
    declarations += define_fractions(naming, "bit", (word.name, name), bit.scale, bit.offset)
    if bit.ranges is not None:
        whole = number_of_bit(word, bit)
        declarations += [
            Define(naming.macro("bit", word.name, name, limit), integer(bound, whole))
            for limit, bound in (("min", bit.ranges.low), ("max", bit.ranges.high))
        ]
    if bit.width == 1:
        return [*declarations, Function(Type("bool"), get, (parameter,), (Return(masked.differs(ZERO)),))]
    cleared = Group(_WORD & Unary("~", mask).cast(kind.name))
    number: Expression = (masked >> shift).cast(kind.name)
    if bit.pieces:
        number = joined_bits(bit, _WORD, kind.name, word.type.size)
    entered: Expression = VALUE
    number_type = kind
    if bit.signed:
        number_type, number = _signed_number(word, bit, number)
        entered = VALUE.cast(kind.name)
    shifted: Expression = Group((entered << shift).cast(kind.name) & mask)
    if bit.pieces:
        shifted = _placed_bits(bit, entered, kind.name, word.type.size)
    return [
        *declarations,
        Function(number_type, get, (parameter,), (Return(number),)),
        Function(
            kind,
            naming.function("bit", word.name, "with", name),
            (parameter, Variable(number_type, "value")),
            (Return((cleared | shifted).cast(kind.name)),),
        ),
    ]


def joined_bits(bit: Bit, word: Expression, kind: str, size: int) -> Expression:
    """`(uint32_t)((word >> 8u & 0x7Fu) | (word & 0x1u) << 7u)`, the bits beside each other where they lie apart."""
    return _moved_bits(word, kind, size, [(run.first, run.most, run.weight) for run in bit.runs])


def _placed_bits(bit: Bit, number: Expression, kind: str, size: int) -> Expression:
    """The word in which separate bits hold a number."""
    return _moved_bits(number, kind, size, [(run.weight, run.most, run.first) for run in bit.runs])


def _moved_bits(source: Expression, kind: str, size: int, moves: Sequence[tuple[int, int, int]]) -> Expression:
    parts: list[Expression] = []
    for first, ones, weight in moves:
        shifted = Group(source >> unsigned(first)) if first else source
        part: Expression = Group(shifted & hexadecimal(ones, size)).cast(kind)
        parts.append(Group(part << unsigned(weight)) if weight else part)
    return Group(Operation("|", tuple(parts))).cast(kind)


def number_of_bit(word: Flags, bit: Bit) -> Whole:
    """The number of C that a field of bits is: as wide as its word, and where it has a sign 32 bits or more."""
    bits = machine_bits(8 * word.type.size)
    return Whole(max(bits, 32), Sign.COMPLEMENT) if bit.signed else Whole(bits, Sign.NONE)


def _signed_number(word: Flags, bit: Bit, number: Expression) -> tuple[Type, Expression]:
    """The type of a signed field of bits, and `(int32_t)(number ^ 8u) - 8`, which repeats its sign."""
    whole = number_of_bit(word, bit)
    sign, kind = 1 << (bit.width - 1), Type(machine(whole).type)
    moved = Group(number ^ integer(sign, Whole(whole.bits, Sign.NONE))).cast(kind.name)
    return kind, moved - integer(sign, whole)


def _declare_states(naming: Naming, word: Flags, kind: Type) -> list[Declaration]:
    """Masks and values of the states, an enum of them, and the function that gives the first one that holds."""
    size, name = word.type.size, naming.type("word", word.name, "state")
    none = naming.macro("word", word.name, "no_state")
    declarations: list[Declaration] = []
    masks: list[tuple[Identifier, Identifier]] = []
    for state in word.states:
        mask, value = word.masked(state)
        mask_name = Identifier(naming.macro("state", word.name, "state", state.name, "mask"))
        value_name = Identifier(naming.macro("state", word.name, "state", state.name, "value"))
        declarations += [
            describe_fact(state),
            Define(mask_name.name, hexadecimal(mask, size)),
            Define(value_name.name, hexadecimal(value, size)),
        ]
        masks.append((mask_name, value_name))
    states = [naming.macro("state", word.name, "state", state.name) for state in word.states]
    enumerators = [Enumerator(none, ZERO)]
    enumerators += [Enumerator(state, decimal(number)) for number, state in enumerate(states, 1)]
    tests = [
        If((_WORD & mask).equals(value), (Return(Identifier(state)),))
        for (mask, value), state in zip(masks, states, strict=True)
    ]
    return [
        *declarations,
        comment("The states that the word can show."),
        Enumeration(name, tuple(enumerators)),
        comment("The first state, in the order above, whose bits match the word."),
        Function(
            Type(name),
            naming.function("word", word.name, "state_of"),
            (Variable(kind, "word"),),
            (*tests, Return(Identifier(none))),
        ),
    ]
