"""Fields of bits with a range in C: the tests that refuse a word."""

from __future__ import annotations

from fieldspec.language.model.enums import Bit, Flags
from fieldspec.targets.c.expressions import (
    Expression,
    Group,
    Operation,
    all_of,
    any_of,
    at_least,
    at_most,
    equal,
    hexadecimal,
    negate,
)


def refused_bits_tests(word: Flags | None, size: int, number: Expression) -> list[Expression]:
    """The tests that hold for a number, a word of `size` bytes, with a field of bits that is out of its range."""
    return [_refused_test(bit, size, number) for bit in word.bounded] if word is not None else []


def _refused_test(bit: Bit, size: int, number: Expression) -> Expression:
    """`!((number & 0x70u) <= 0x50u)`"""
    masked = Group(Operation("&", (number, hexadecimal(bit.mask, size))))
    tests: list[Expression] = []
    for low, high in bit.images:
        if low == high:
            tests.append(equal(masked, hexadecimal(low, size)))
            continue
        bounds = [at_least(masked, hexadecimal(low, size))] if low else []
        bounds += [at_most(masked, hexadecimal(high, size))] if high < bit.mask else []
        tests.append(all_of(bounds))
    return negate(tests[0] if len(tests) == 1 else any_of([Group(test) for test in tests]))
