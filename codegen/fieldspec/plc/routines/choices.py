"""Fields whose type another field decides: their elements are kept as bit strings, as wide as the widest type."""

from __future__ import annotations

from fieldspec.layout.record import CaseLayout, FieldLayout
from fieldspec.model.primitive import Kind
from fieldspec.plc.routines.draft import Draft
from fieldspec.plc.routines.expressions import (
    Element,
    Expression,
    Negation,
    Operation,
    Variable,
    Whole,
    compared,
    converted,
    number,
    plus,
)
from fieldspec.plc.routines.holders import Bytes
from fieldspec.plc.routines.statements import Assignment, Loop, Selection, Statement
from fieldspec.plc.routines.types import BITS, INT, UNSIGNED, ArrayType, Elementary, EnumType
from fieldspec.plc.routines.values import Wire, runs
from fieldspec.plc.routines.world import PREFIXES, World


def choice_type(field: FieldLayout) -> ArrayType:
    """The type of the elements' variable."""
    repeat = field.field.repeat
    most = repeat.high if repeat is not None else field.count or 1
    return ArrayType(0, most - 1, _widest(field))


def _widest(field: FieldLayout) -> Elementary:
    return BITS[max(case.value.size for case in field.cases)]


def selecting(draft: Draft, world: World, selector: FieldLayout, source: Expression) -> Expression:
    """The number that decides, in a variable; other numbers than those of its enum are refused."""
    value = Wire.of_field(selector).value
    if not isinstance(source.type, EnumType):
        return source
    kind = world.raw_type(value.enum)
    held = draft.local(f"{PREFIXES[kind.name]}Selected", kind)
    call = world.enum_to_raw(value.enum, source, held)
    draft.refuse(Negation(call), "unknown_value")
    return held


def _shapes(field: FieldLayout) -> list[tuple[CaseLayout, frozenset[int]]]:
    """The cases that differ on the wire, each with all numbers that choose it."""
    found: dict[tuple[object, ...], tuple[CaseLayout, frozenset[int]]] = {}
    for case in field.cases:
        truth = case.value.type.kind is Kind.BOOLEAN
        key = (case.value.size, case.order, case.swapped, truth)
        before = found.get(key)
        found[key] = (case, case.numbers | (before[1] if before else frozenset()))
    return list(found.values())


def chosen_read(
    draft: Draft,
    world: World,
    field: FieldLayout,
    selector: Expression,
    holder: Bytes,
    target: Expression,
    count: Variable | None,
    size: Expression,
    element: Expression,
) -> list[Statement]:
    """What puts the elements into their variable, each at the low end of a bit string, and how many they are."""
    assert isinstance(element, Variable)
    sizes = [
        (tuple(runs(numbers)), (Assignment(element, number(case.value.size)),)) for case, numbers in _shapes(field)
    ]
    statements: list[Statement] = [
        Selection(selector, tuple(sizes), draft.status.give(draft.result, "unknown_value")),
    ]
    rest = plus(size, -field.offset)
    if count is not None:
        repeat = field.field.repeat
        assert repeat is not None
        statements += [
            draft.refusal(compared(Operation("MOD", (rest, element), INT), "<>", number(0)), "wrong_length"),
            Assignment(count, Operation("/", (rest, element), INT)),
            draft.refusal(compared(count, "<", number(repeat.low)), "incomplete"),
            draft.refusal(compared(count, ">", number(repeat.high)), "wrong_length"),
        ]
    index, at, wide = draft.local("iElement"), draft.local("iAtElement"), _widest(field)
    branches = []
    for case, numbers in _shapes(field):
        bits = Bytes(holder.array, at).number(0, case.value.size, case.order, case.swapped)
        held = Element(target, index, wide)
        body: list[Statement] = [Assignment(held, converted(bits, wide))]
        if case.value.type.kind is Kind.BOOLEAN:
            whole = UNSIGNED[wide.size]
            body.append(draft.refusal(compared(converted(held, whole), ">", Whole(1, whole)), "unknown_value"))
        branches.append((tuple(runs(numbers)), tuple(body)))
    here = plus(holder.first, holder.start + field.offset)
    place = Operation("+", (here, Operation("*", (index, element), INT)), INT)
    last = plus(count, -1) if count is not None else number((field.count or 1) - 1)
    loop = Loop(index, number(0), last, (Assignment(at, place), Selection(selector, tuple(branches))))
    return [*statements, loop]


def chosen_written(
    draft: Draft,
    world: World,
    field: FieldLayout,
    selector: Expression,
    holder: Bytes,
    source: Expression,
    count: Variable | None,
    element: Expression,
) -> list[Statement]:
    """What puts the low ends of the elements' bit strings into the bytes; what does not fit is refused."""
    assert isinstance(element, Variable)
    sizes = [
        (tuple(runs(numbers)), (Assignment(element, number(case.value.size)),)) for case, numbers in _shapes(field)
    ]
    index, at = draft.local("iElement"), draft.local("iAtElement")
    wide = _widest(field)
    held = Element(source, index, wide)
    branches = []
    for case, numbers in _shapes(field):
        highest = 1 if case.value.type.kind is Kind.BOOLEAN else (1 << (8 * case.value.size)) - 1
        body: list[Statement] = []
        if highest < wide.high:
            whole = UNSIGNED[wide.size]
            body.append(draft.refusal(compared(converted(held, whole), ">", Whole(highest, whole)), "out_of_range"))
        raw = draft.local("dwRaw" if wide.size == 4 else f"{PREFIXES[wide.name]}Raw", wide)
        body.append(Assignment(raw, held))
        body += Bytes(holder.array, at).stored(0, case.value.size, case.order, case.swapped, raw)
        branches.append((tuple(runs(numbers)), tuple(body)))
    here = plus(holder.first, holder.start + field.offset)
    place = Operation("+", (here, Operation("*", (index, element), INT)), INT)
    last = plus(count, -1) if count is not None else number((field.count or 1) - 1)
    return [
        Selection(selector, tuple(sizes), draft.status.give(draft.result, "unknown_value")),
        Loop(index, number(0), last, (Assignment(at, place), Selection(selector, tuple(branches)))),
    ]
