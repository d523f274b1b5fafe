"""Statements of self-tests: what is expected, and members of structs that are set and compared."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from fieldspec.codec.layout.record import FieldLayout
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import Octets, Real, Text, Truth, Whole, real_bits
from fieldspec.targets.c.expressions import Call, Expression, Identifier, Literal, SizeOf, Unary, all_of
from fieldspec.targets.c.fields import members
from fieldspec.targets.c.literals import (
    FALSE,
    TRUE,
    byte_string,
    decimal,
    double,
    hexadecimal,
    integer,
    string,
    unsigned,
)
from fieldspec.targets.c.machine import of_bits, to_bits
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.sample_values import RecordForm, form_of_values
from fieldspec.targets.c.statements import Assignment, Evaluation, Expectation, Statement, assign, call
from fieldspec.targets.c.values import COUNT, DATA

LENGTH = Identifier("length")


def expect(test: Expression, description: str) -> Evaluation:
    """`expect(test, "what is tested");`"""
    return Evaluation(Call("expect", (test, string(description))))


def expect_equal(description: str, left: Expression, right: Expression) -> Expectation:
    """`expect(left == right, "what is tested");`"""
    return Expectation(left, right, string(description))


def expect_bytes(description: str, memory: Expression, data: bytes) -> Evaluation:
    """`expect(same_bytes(memory, "\\001\\002", 2u), "what is tested");`"""
    return expect(Call("same_bytes", (memory, byte_string(data), unsigned(len(data)))), description)


def expect_quantity(
    quantity: Expression, expected: float, description: str, least_tolerance: float = 0.0
) -> list[Statement]:
    """`expect(quantity >= 0.999, "what is tested");` and the same for `<=`.

    A quantity may differ by `least_tolerance`, or by a millionth of a millionth, where that is more.
    """
    tolerance = max(abs(expected) * 1e-12, least_tolerance)
    return [
        expect(quantity.at_least(double(expected - tolerance)), description),
        expect(quantity.at_most(double(expected + tolerance)), description),
    ]


def same_array(memory: Identifier, expected: Identifier) -> Expression:
    """`length == sizeof wanted && same_bytes(memory, wanted, length)`"""
    return all_of([LENGTH.equals(SizeOf(expected)), Call("same_bytes", (memory, expected, LENGTH))])


def clear_variable(variable: Expression) -> Evaluation:
    """`clear(&variable, sizeof variable);` of a struct, `clear(bytes, sizeof bytes);` of an array"""
    cleared = variable.operand if isinstance(variable, Unary) else variable
    return call("clear", variable, SizeOf(cleared))


def set_members(naming: Naming, form: RecordForm, values: Mapping[str, Any], struct: Expression) -> list[Statement]:
    """`in.speed = 100u;`: gives members their values."""
    statements: list[Statement] = []
    for field in members(form.record):
        statements += set_member(naming, form, field, values[field.name], struct)
    return statements


def set_member(naming: Naming, form: RecordForm, field: FieldLayout, value: Any, struct: Expression) -> list[Statement]:
    """Gives the member of a field its value, and the one for the number of its elements."""
    statements: list[Statement] = []
    if field.field.repeat is not None:
        statements.append(assign(struct.member(form.count_name(field)), unsigned(len(value))))
    for target, item in _elements(form, field, struct, value):
        if field.record is not None:
            statements += set_members(naming, form_of_values(field.record, item), item, target)
        else:
            statements += _set_element(naming, field, target, item)
    return statements


def expect_members(
    naming: Naming, form: RecordForm, values: Mapping[str, Any], struct: Expression, description: str
) -> list[Statement]:
    """`expect(out.speed == 100u, "...");`: compares members with values; members that have none are left out."""
    statements: list[Statement] = []
    for field in members(form.record):
        if field.name not in values:
            continue
        value = values[field.name]
        if field.field.repeat is not None:
            count = struct.member(form.count_name(field))
            statements.append(expect_equal(f"{description}: {field.name} count", count, unsigned(len(value))))
        for target, item in _elements(form, field, struct, value):
            if field.record is not None:
                statements += expect_members(naming, form_of_values(field.record, item), item, target, description)
            else:
                statements += _expect_member(naming, field, target, item, f"{description}: {field.name}")
    return statements


def _elements(form: RecordForm, field: FieldLayout, struct: Expression, value: Any) -> Iterator[tuple[Expression, Any]]:
    """Each element of a field with its value."""
    target = struct
    for name in form.member_names(field):
        target = target.member(name)
    if not field.is_list:
        yield target, value
        return
    for index, item in enumerate(value):
        yield target.element(decimal(index)), item


def _set_element(naming: Naming, field: FieldLayout, target: Expression, item: Any) -> list[Statement]:
    encoding = field.primitive.encoding
    match encoding:
        case Octets() if field.value is not None and field.value.is_marked:
            count = assign(target.member(COUNT), unsigned(len(item)))
            return [count, call("copy", target.member(DATA), byte_string(item), unsigned(len(item)))]
        case Text() | Octets():
            data = _data(item)
            return [call("copy", target, byte_string(data), unsigned(len(data)))] if data else []
        case Real():
            return [assign(target, of_bits(naming, encoding, _real_bits(encoding, item)))]
        case Whole() | Truth():
            return [Assignment(target, _literal(encoding, item))]
        case _:
            assert_never(encoding)


def _expect_member(
    naming: Naming, field: FieldLayout, target: Expression, item: Any, description: str
) -> list[Statement]:
    encoding = field.primitive.encoding
    match encoding:
        case Octets() if field.value is not None and field.value.is_marked:
            count = expect_equal(f"{description} count", target.member(COUNT), unsigned(len(item)))
            return [count, expect_bytes(description, target.member(DATA), item)]
        case Text() | Octets():
            data = _data(item)
            return [expect_bytes(description, target, data)] if data else []
        case Real():
            return [expect_equal(description, to_bits(naming, encoding, target), _real_bits(encoding, item))]
        case Whole() | Truth():
            return [expect_equal(description, target, _literal(encoding, item))]
        case _:
            assert_never(encoding)


def _data(item: Any) -> bytes:
    return item.encode("utf-8") if isinstance(item, str) else bytes(item)


def _real_bits(encoding: Real, item: float) -> Literal:
    return hexadecimal(real_bits(encoding.precision, item), encoding.bits // 8)


def _literal(encoding: Whole | Truth, item: int) -> Literal:
    match encoding:
        case Truth():
            return TRUE if item else FALSE
        case Whole():
            return integer(int(item), encoding)
        case _:
            assert_never(encoding)
