"""Whole numbers of a sign and a magnitude, and their bits: the highest bit alone says that a number is below zero."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.model.encoding import Sign
from fieldspec.language.model.encoding import Whole as WholeNumber
from fieldspec.targets.controllers.routines.world import PREFIXES, World, bits_name, encodings_of, magnitude_name
from fieldspec.targets.controllers.statements.expressions import (
    BITS,
    Elementary,
    Expression,
    Operation,
    Variable,
    Whole,
)
from fieldspec.targets.controllers.statements.numbers import whole_type
from fieldspec.targets.controllers.statements.routine import Assignment, Declared, Routine, when


def magnitude_routines(world: World) -> Iterator[Routine]:
    """The functions that convert such numbers of each width that the device has."""
    encodings = encodings_of(world.layout)
    for bits in range(8, 65, 8):
        whole = WholeNumber(bits, Sign.MAGNITUDE)
        if whole in encodings:
            yield _from_bits(world, whole)
            yield _to_bits(world, whole)


def _from_bits(world: World, whole: WholeNumber) -> Routine:
    kind, word = whole_type(whole), BITS[whole.bits // 8]
    name = world.routine("number_from", magnitude_name(whole))
    bits, result = Variable(bits_name(whole), word), Variable(name, kind)
    number = Variable(f"{PREFIXES[kind.name]}Number", kind)
    sign = 1 << (whole.bits - 1)
    return Routine(
        name,
        "numbers",
        kind,
        (Declared(bits, "input"), Declared(number, "local")),
        (
            Assignment(number, _and(bits, sign - 1, word).converted(kind)),
            when(
                _and(bits, sign, word).compared("<>", 0),
                [Assignment(number, Whole(0, kind).combined("-", number))],
            ),
            Assignment(result, number),
        ),
        (f"The number of {whole.bits} bits, of which the highest one is its sign, and the others are its magnitude.",),
    )


def _to_bits(world: World, whole: WholeNumber) -> Routine:
    kind, word = whole_type(whole), BITS[whole.bits // 8]
    name = world.routine(magnitude_name(whole), "from_number")
    number, result = Variable(f"{PREFIXES[kind.name]}Value", kind), Variable(name, word)
    bits = Variable(bits_name(whole), word)
    magnitude = Whole(0, kind).combined("-", number)
    sign = Whole(1 << (whole.bits - 1), word)
    low, high = whole.bounds
    return Routine(
        name,
        "numbers",
        word,
        (Declared(number, "input"), Declared(bits, "local")),
        (
            when(
                number.compared("<", 0),
                [Assignment(bits, magnitude.converted(word).combined("OR", sign))],
                [Assignment(bits, number.converted(word))],
            ),
            Assignment(result, bits),
        ),
        (f"The {whole.bits} bits of a number from {low} to {high}: first its sign, then its magnitude.",),
    )


def _and(bits: Expression, mask: int, word: Elementary) -> Operation:
    return bits.combined("AND", mask)
