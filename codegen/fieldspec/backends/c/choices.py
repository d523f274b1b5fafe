"""Fields whose type follows from an earlier field: unions in structs, and switches in functions."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from fieldspec.backends.c.comments import of_value, told
from fieldspec.backends.c.enums import closed_test
from fieldspec.backends.c.naming import Naming, member
from fieldspec.backends.c.text import indented, integer
from fieldspec.backends.c.values import Wire, const_test, declaration, decode_lines, encode_lines, fixed_lines, load
from fieldspec.layout.record import CaseLayout, FieldLayout, RecordLayout
from fieldspec.model.device import Device

CaseLines = Callable[[CaseLayout], list[str]]


def case_wire(case: CaseLayout) -> Wire:
    """The value of a case."""
    return Wire(case.value, case.order, case.swapped)


def case_member(case: CaseLayout) -> str:
    """The member of the union that holds a case's values, empty where they are a constant."""
    return "" if case.value.const is not None else member(case.name)


def union_lines(field: FieldLayout, count: int | None) -> list[str]:
    """The member of a struct, a union with a member for each case."""
    lines = ["union {"]
    for case in field.cases:
        if name := case_member(case):
            when = f"While {field.field.choice.by if field.field.choice else ''} is {' or '.join(case.case.when)}."
            told_of = told(case.case, when, of_value(case.value))
            lines += indented([*told_of, declaration(case_wire(case), name, count) + ";"])
    return [*lines, f"}} {member(field.name)};"] if len(lines) > 1 else []


def selector_given(selector: FieldLayout) -> str:
    """The value of the selector in a struct that is encoded."""
    value = selector.value
    assert value is not None
    if value.const is not None:
        return integer(value.const, value.size, value.type.signed)
    return f"in->{member(selector.name)}"


def selector_read(naming: Naming, selector: FieldLayout) -> str:
    """The value of the selector in bytes that are decoded."""
    assert selector.value is not None
    return load(naming, Wire(selector.value, selector.order, selector.swapped), f"in + {selector.offset}")


def sized_lines(naming: Naming, record: RecordLayout, selector: str) -> list[str]:
    """Statements that return where the selector chooses nothing.

    Where the size of an element differs from case to case, `element` is set to it.
    """
    if record.size is not None:
        return _switch(naming, record, selector, [(list(record.fields[-1].cases), [])])
    sizes: dict[int, list[CaseLayout]] = {}
    for case in record.fields[-1].cases:
        sizes.setdefault(case.value.size, []).append(case)
    groups = [(cases, [f"element = {size}u;"]) for size, cases in sizes.items()]
    return _switch(naming, record, selector, groups)


def chosen_lines(naming: Naming, record: RecordLayout, selector: str, one: CaseLines) -> list[str]:
    """Statements that differ from case to case."""
    return _switch(naming, record, selector, [([case], one(case)) for case in record.fields[-1].cases])


def _switch(
    naming: Naming, record: RecordLayout, selector: str, groups: Iterable[tuple[list[CaseLayout], list[str]]]
) -> list[str]:
    assert record.selector is not None
    assert record.selector.value is not None
    value = record.selector.value
    lines = [f"switch ({selector}) {{"]
    for cases, body in groups:
        numbers = sorted(number for case in cases for number in case.numbers)
        lines += [f"case {integer(number, value.size, value.type.signed)}:" for number in numbers]
        lines += indented([*body, "break;"]) if numbers else []
    return [*lines, "default:", f"    return {naming.own_macro('err_unknown_value')};", "}"]


def case_encoded(naming: Naming, device: Device, case: CaseLayout, name: str, target: str) -> list[str]:
    """Statements that write one value of a case."""
    if case.value.const is not None:
        return fixed_lines(naming, case_wire(case), case.value.const, target)
    return encode_lines(naming, case_wire(case), name, target, closed_test(naming, device, case.value, name))


def case_decoded(naming: Naming, device: Device, case: CaseLayout, name: str, source: str) -> list[str]:
    """Statements that read one value of a case."""
    if case.value.const is not None:
        return const_test(naming, case_wire(case), source)
    return decode_lines(naming, case_wire(case), source, name, closed_test(naming, device, case.value, name))
