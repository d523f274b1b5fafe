"""Records: from bytes into a struct and back, with choices between field types."""

from __future__ import annotations

from collections.abc import Callable

from fieldspec.layout.record import CaseLayout, FieldLayout, RecordLayout
from fieldspec.model.value import Kind
from fieldspec.plc.routines.expressions import (
    BITS,
    INT,
    UNSIGNED,
    ArrayType,
    Element,
    Elementary,
    EnumType,
    Expression,
    Member,
    Negation,
    Operation,
    Type,
    Variable,
    Whole,
    added,
    compared,
    converted,
    number,
    plus,
)
from fieldspec.plc.routines.holders import Bytes, Holder
from fieldspec.plc.routines.routine import Assignment, Draft, Loop, Selection, Statement
from fieldspec.plc.routines.values import Wire, read, runs, write, write_number
from fieldspec.plc.routines.world import PREFIXES, World

# The expression of a field's variable.
Place = Callable[[FieldLayout], Expression]


def is_user_field(field: FieldLayout) -> bool:
    """Whether users give the field: it is no constant, measures nothing, and has a meaning."""
    constant = field.value is not None and field.value.const is not None
    return not (constant or field.field.measures or field.field.reserved)


def members_of(world: World, record: RecordLayout, struct: Expression) -> Place:
    """Where the fields of a record are in a variable of its struct."""
    return lambda field: Member(struct, world.member(record.name, field.name), field_type(world, field))


def field_type(world: World, field: FieldLayout) -> Type:
    """The type of a field's variable; for a list, that of as many elements as there can be."""
    element_type = (
        world.struct(field.record.name) if field.record is not None else world.type_of(Wire.of_field(field).value)
    )
    if not field.is_list:
        return element_type
    repeat = field.field.repeat
    return ArrayType(0, (repeat.high if repeat is not None else field.count or 1) - 1, element_type)


def read_fields(draft: Draft, world: World, record: RecordLayout, holder: Holder, place: Place) -> list[Statement]:
    """What puts the fields of a record without repeated ones into their variables."""
    statements: list[Statement] = []
    for field in record.fields:
        if field.field.measures is None:
            statements += read_field(draft, world, field, holder, place, None)
    return statements


def read_field(
    draft: Draft, world: World, field: FieldLayout, holder: Holder, place: Place, count: Expression | None
) -> list[Statement]:
    """What puts one field into its variable; `count` is how many elements a repeated one has."""
    if field.field.reserved:
        return []
    target = place(field) if is_user_field(field) else None

    def element_statements(at: Holder, offset: int, variable: Expression | None) -> list[Statement]:
        if field.record is not None:
            assert variable is not None
            return read_fields(draft, world, field.record, at.behind(offset), members_of(world, field.record, variable))
        return read(draft, world, Wire.of_field(field), at, offset, variable)

    return _each(draft, field, holder, target, count, element_statements)


def write_fields(draft: Draft, world: World, record: RecordLayout, holder: Holder, place: Place) -> list[Statement]:
    """What puts the variables of a record without repeated fields into the holder."""
    statements: list[Statement] = []
    for field in record.fields:
        if field.field.measures is None:
            statements += write_field(draft, world, field, holder, place, None)
    return statements


def write_field(
    draft: Draft, world: World, field: FieldLayout, holder: Holder, place: Place, count: Expression | None
) -> list[Statement]:
    """What puts the variable of one field into the holder."""
    if not is_user_field(field):
        return write_number(Wire.of_field(field), holder, field.offset, field.count or 0)

    def element_statements(at: Holder, offset: int, variable: Expression | None) -> list[Statement]:
        assert variable is not None
        if field.record is not None:
            return write_fields(
                draft, world, field.record, at.behind(offset), members_of(world, field.record, variable)
            )
        return write(draft, world, Wire.of_field(field), at, offset, variable)

    return _each(draft, field, holder, place(field), count, element_statements)


_Element = Callable[[Holder, int, Expression | None], list[Statement]]


def _each(
    draft: Draft,
    field: FieldLayout,
    holder: Holder,
    target: Expression | None,
    count: Expression | None,
    statements_of: _Element,
) -> list[Statement]:
    """The statements for a field: once, or for each of its elements in a loop."""
    if not field.is_list:
        return statements_of(holder, field.offset, target)
    assert target is not None
    assert isinstance(target.type, ArrayType)
    start, step = holder.behind(field.offset).index(), field.size // holder.unit
    if start is None or field.size % holder.unit:
        assert count is None
        elements = [Element(target, number(at), target.type.of) for at in range(field.count or 1)]
        inner = [statements_of(holder, field.offset + at * field.size, element) for at, element in enumerate(elements)]
        return [statement for statements in inner for statement in statements]
    index = _free_index(draft, target)
    element = Element(target, index, target.type.of)
    here = added([start, Operation("*", (index, number(step)), INT) if step > 1 else index], INT)
    if isinstance(start, Whole) and start.value == 0 and step == 1:
        here = index
    if field.record is None and field.size == holder.unit:
        statements = statements_of(holder.moved(here), 0, element)
    else:
        at = draft.local(f"iAt{index.name[1:]}")
        statements = [Assignment(at, here), *statements_of(holder.moved(at), 0, element)]
    last = plus(count, -1) if count is not None else number((field.count or 1) - 1)
    return [Loop(index, number(0), last, tuple(statements))]


def _free_index(draft: Draft, target: Expression) -> Variable:
    """An index that no loop around this one has: the expression of the list says how deep it is."""
    depth, of = 0, target
    while isinstance(of, Member | Element):
        depth += isinstance(of, Element)
        of = of.of
    return draft.local("iElement" if depth == 0 else f"iInner{depth if depth > 1 else ''}")


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
    number = draft.local(f"{PREFIXES[kind.name]}Selected", kind)
    call = world.enum_to_raw(value.enum, source, number)
    draft.refuse(Negation(call), "unknown_value")
    return number


def _shapes(field: FieldLayout) -> list[tuple[CaseLayout, frozenset[int]]]:
    """The cases that differ on the wire, each with all numbers that choose it."""
    shapes: dict[tuple[object, ...], tuple[CaseLayout, frozenset[int]]] = {}
    for case in field.cases:
        truth = case.value.type.kind is Kind.BOOLEAN
        key = (case.value.size, case.order, case.swapped, truth)
        before = shapes.get(key)
        shapes[key] = (case, case.numbers | (before[1] if before else frozenset()))
    return list(shapes.values())


def read_choice(
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
        target_element = Element(target, index, wide)
        body: list[Statement] = [Assignment(target_element, converted(bits, wide))]
        if case.value.type.kind is Kind.BOOLEAN:
            whole = UNSIGNED[wide.size]
            body.append(
                draft.refusal(compared(converted(target_element, whole), ">", Whole(1, whole)), "unknown_value")
            )
        branches.append((tuple(runs(numbers)), tuple(body)))
    here = plus(holder.first, holder.start + field.offset)
    place = Operation("+", (here, Operation("*", (index, element), INT)), INT)
    last = plus(count, -1) if count is not None else number((field.count or 1) - 1)
    loop = Loop(index, number(0), last, (Assignment(at, place), Selection(selector, tuple(branches))))
    return [*statements, loop]


def write_choice(
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
    source_element = Element(source, index, wide)
    branches = []
    for case, numbers in _shapes(field):
        highest = 1 if case.value.type.kind is Kind.BOOLEAN else (1 << (8 * case.value.size)) - 1
        body: list[Statement] = []
        if highest < wide.high:
            whole = UNSIGNED[wide.size]
            body.append(
                draft.refusal(compared(converted(source_element, whole), ">", Whole(highest, whole)), "out_of_range")
            )
        raw = draft.local("dwRaw" if wide.size == 4 else f"{PREFIXES[wide.name]}Raw", wide)
        body.append(Assignment(raw, source_element))
        body += Bytes(holder.array, at).stored(0, case.value.size, case.order, case.swapped, raw)
        branches.append((tuple(runs(numbers)), tuple(body)))
    here = plus(holder.first, holder.start + field.offset)
    place = Operation("+", (here, Operation("*", (index, element), INT)), INT)
    last = plus(count, -1) if count is not None else number((field.count or 1) - 1)
    return [
        Selection(selector, tuple(sizes), draft.status.give(draft.result, "unknown_value")),
        Loop(index, number(0), last, (Assignment(at, place), Selection(selector, tuple(branches)))),
    ]
