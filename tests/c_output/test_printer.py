"""Trees of C are printed with the parentheses that C needs, and declare only the variables that they use."""

from __future__ import annotations

import pytest

from fieldspec.targets.c.declarations import Function
from fieldspec.targets.c.expressions import (
    IN,
    INDEX,
    OUT,
    Call,
    Conditional,
    Expression,
    Identifier,
    SizeOf,
    Type,
    Unary,
    all_of,
    any_of,
)
from fieldspec.targets.c.fields import INNER_LENGTH
from fieldspec.targets.c.literals import INT64, decimal, integer, string, unsigned
from fieldspec.targets.c.printer import Printer
from fieldspec.targets.c.statements import CountUp, If, Return, Switch, assign, contains

A, B, C = (Identifier(name) for name in "abc")

EXPRESSIONS: list[tuple[Expression, str]] = [
    (A.at_most(unsigned(12)).negated(), "!(a <= 12u)"),
    (A.negated(), "!a"),
    (A + (B - C), "a + b - c"),
    (A - (B - C), "a - (b - c)"),
    ((A - B) - C, "a - b - c"),
    ((A + B) * C, "(a + b) * c"),
    (A / (B * C), "a / (b * c)"),
    ((A & B).equals(C), "(a & b) == c"),
    (all_of([any_of([A, B]), C]), "(a || b) && c"),
    (any_of([A]), "a"),
    ((A >> decimal(4)).cast("uint8_t"), "(uint8_t)(a >> 4)"),
    (Unary("~", A).cast("uint8_t"), "(uint8_t)~a"),
    (Conditional(A, B, C).cast("uint8_t"), "(uint8_t)(a ? b : c)"),
    (A.equals(Conditional(A, B, C)), "a == (a ? b : c)"),
    (Conditional(any_of([A, B]), B, C), "a || b ? b : c"),
    (SizeOf(A), "sizeof a"),
    (IN.arrow("list").element(INDEX + unsigned(1)), "in->list[at + 1u]"),
    (Call("f", (A, Call("g", ()))), "f(a, g())"),
    (integer(-1), "(-1)"),
    (integer(-(1 << 31)), "(-2147483647 - 1)"),
    (integer(-(1 << 63), INT64), "(-INT64_C(9223372036854775807) - 1)"),
    (string('"*/\\\n?é1'), '"\\"*/\\\\\\n\\?\\303\\2511"'),
]


@pytest.mark.parametrize(("expression", "text"), EXPRESSIONS, ids=[text for _, text in EXPRESSIONS])
def test_an_expression_has_the_parentheses_that_it_needs(expression: Expression, text: str) -> None:
    assert Printer().print_statements([Return(expression)], "") == [f"return {text};"]


def test_a_function_declares_the_variables_that_it_uses_in_their_order() -> None:
    loop = CountUp(INDEX, unsigned(4), (assign(OUT.element(INDEX), decimal(0)),))
    function = Function(Type("void"), "clear", (), (loop,), (INNER_LENGTH, INDEX))
    assert Printer().print_declarations([function]) == [
        "static inline void clear(void)",
        "{",
        "    size_t at;",
        "    for (at = 0; at < 4u; at++) {",
        "        out[at] = 0;",
        "    }",
        "}",
    ]


def test_a_long_condition_continues_on_the_next_line() -> None:
    names = [Identifier(f"{letter * 30}") for letter in "abcde"]
    lines = Printer().print_statements([If(any_of(names), ())], "    ")
    assert lines == [
        f"    if ({'a' * 30} || {'b' * 30} || {'c' * 30} ||",
        f"            {'d' * 30} || {'e' * 30}) {{",
        "    }",
    ]


def test_an_else_with_a_condition_is_an_else_if_on_one_line() -> None:
    printed = Printer().print_statements([If(A, (Return(A),), (If(B, (Return(B),), (Return(C),)),))], "")
    assert [line for line in printed if line.startswith("}")] == ["} else if (b) {", "} else {", "}"]


def test_a_branch_without_labels_is_left_out() -> None:
    switch = Switch(A, (((decimal(1), decimal(2)), (assign(B, C),)), ((), (assign(B, A),))), (Return(),))
    assert Printer().print_statements([switch], "") == [
        "switch (a) {",
        "case 1:",
        "case 2:",
        "    b = c;",
        "    break;",
        "default:",
        "    return;",
        "}",
    ]


def test_a_tree_is_searched_for_a_node() -> None:
    body = (If(A.equals(decimal(1)), (assign(B, IN.element(decimal(0))),)),)
    assert contains(body, IN)
    assert not contains(body, OUT)
