"""Records: from bytes into a struct and back, with choices between field types."""

from __future__ import annotations

from collections.abc import Callable

from fieldspec.codec.layout.record import CaseLayout, FieldLayout, RecordLayout
from fieldspec.language.model.encoding import is_truth
from fieldspec.targets.controllers.routines.holders import Bytes, Holder
from fieldspec.targets.controllers.routines.values import Wire, read, runs, write, write_number
from fieldspec.targets.controllers.routines.world import PREFIXES, World
from fieldspec.targets.controllers.statements.expressions import (
    BITS,
    UNSIGNED,
    ArrayType,
    Element,
    Elementary,
    EnumType,
    Expression,
    Member,
    Negation,
    Type,
    Variable,
    Whole,
    number,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Draft, Loop, Selection, Statement

# The expression of a field's variable.
Place = Callable[[FieldLayout], Expression]


def is_user_field(field: FieldLayout) -> bool:
    """Whether users state the value of a field: it is not a constant, measures nothing, and has a meaning."""
    constant = field.value is not None and field.value.const is not None
    return not (constant or field.field.measures or field.field.reserved)


def members_of(world: World, record: RecordLayout, struct: Expression) -> Place:
    """The function that gives the struct member in which a field of a record is."""
    return lambda field: Member(struct, world.member(record.name, field.name), field_type(world, field))


def field_type(world: World, field: FieldLayout) -> Type:
    """The type of the variable of a field; for a list, an array of its greatest number of elements."""
    element_type = (
        world.struct(field.record.name) if field.record is not None else world.type_of(Wire.of_field(field).value)
    )
    if not field.is_list:
        return element_type
    repeat = field.field.repeat
    return ArrayType(0, (repeat.high if repeat is not None else field.count or 1) - 1, element_type)


def read_fields(draft: Draft, world: World, record: RecordLayout, holder: Holder, place: Place) -> list[Statement]:
    """The statements that read the fields of a record, which has no repeated ones, into their variables."""
    statements: list[Statement] = []
    for field in record.fields:
        if field.field.measures is None:
            statements += read_field(draft, world, field, holder, place, None)
    return statements


def read_field(
    draft: Draft, world: World, field: FieldLayout, holder: Holder, place: Place, count: Expression | None
) -> list[Statement]:
    """The statements that read a field into its variable; a repeated one has `count` elements."""
    if field.field.reserved:
        return []
    target = place(field) if is_user_field(field) else None

    def element_statements(element_holder: Holder, offset: int, variable: Expression | None) -> list[Statement]:
        if field.record is not None:
            assert variable is not None
            return read_fields(
                draft, world, field.record, element_holder.behind(offset), members_of(world, field.record, variable)
            )
        return read(draft, world, Wire.of_field(field), element_holder, offset, variable)

    return _each(draft, field, holder, target, count, element_statements)


def write_fields(draft: Draft, world: World, record: RecordLayout, holder: Holder, place: Place) -> list[Statement]:
    """The statements that write the variables of a record, which has no repeated fields, into the holder."""
    statements: list[Statement] = []
    for field in record.fields:
        if field.field.measures is None:
            statements += write_field(draft, world, field, holder, place, None)
    return statements


def write_field(
    draft: Draft, world: World, field: FieldLayout, holder: Holder, place: Place, count: Expression | None
) -> list[Statement]:
    """The statements that write the variable of a field into the holder."""
    if not is_user_field(field):
        return write_number(Wire.of_field(field), holder, field.offset, field.count or 0)

    def element_statements(element_holder: Holder, offset: int, variable: Expression | None) -> list[Statement]:
        assert variable is not None
        if field.record is not None:
            return write_fields(
                draft, world, field.record, element_holder.behind(offset), members_of(world, field.record, variable)
            )
        return write(draft, world, Wire.of_field(field), element_holder, offset, variable)

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
        elements = [target.element(position) for position in range(field.count or 1)]
        inner = [
            statements_of(holder, field.offset + position * field.size, element)
            for position, element in enumerate(elements)
        ]
        return [statement for statements in inner for statement in statements]
    index = _free_index(draft, target)
    element = target.element(index)
    start_index: Expression = start.combined("+", index.combined("*", step) if step > 1 else index)
    if isinstance(start, Whole) and start.value == 0 and step == 1:
        start_index = index
    if field.record is None and field.size == holder.unit:
        statements = statements_of(holder.moved(start_index), 0, element)
    else:
        position = draft.local(f"iAt{index.name[1:]}")
        statements = [Assignment(position, start_index), *statements_of(holder.moved(position), 0, element)]
    last = count.plus(-1) if count is not None else number((field.count or 1) - 1)
    return [Loop(index, number(0), last, tuple(statements))]


def _free_index(draft: Draft, target: Expression) -> Variable:
    """An index variable that no enclosing loop uses: the target expression says how deep the loop is."""
    depth, expression = 0, target
    while isinstance(expression, Member | Element):
        depth += isinstance(expression, Element)
        expression = expression.of
    return draft.local("iElement" if depth == 0 else f"iInner{depth if depth > 1 else ''}")


def choice_type(field: FieldLayout) -> ArrayType:
    """The type of the variable of a list whose elements have the type that a selector chooses."""
    repeat = field.field.repeat
    limit = repeat.high if repeat is not None else field.count or 1
    return ArrayType(0, limit - 1, _widest(field))


def _widest(field: FieldLayout) -> Elementary:
    return BITS[max(case.value.size for case in field.cases)]


def selecting(draft: Draft, world: World, selector: FieldLayout, source: Expression) -> Expression:
    """The number that chooses a case, in a variable; numbers that its enum does not list are refused."""
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
        truth = is_truth(case.value.encoding)
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
    """The statements that read the elements, each into the low bits of its variable, and count them."""
    assert isinstance(element, Variable)
    sizes = [
        (tuple(runs(numbers)), (Assignment(element, number(case.value.size)),)) for case, numbers in _shapes(field)
    ]
    statements: list[Statement] = [Selection(selector, tuple(sizes), draft.status.give(draft.result, "unknown_value"))]
    rest = size.plus(-field.offset)
    if count is not None:
        repeat = field.field.repeat
        assert repeat is not None
        statements += [
            draft.refusal(rest.combined("MOD", element).compared("<>", 0), "wrong_length"),
            Assignment(count, rest.combined("/", element)),
            draft.refusal(count.compared("<", repeat.low), "incomplete"),
            draft.refusal(count.compared(">", repeat.high), "wrong_length"),
        ]
    index, position, wide = draft.local("iElement"), draft.local("iAtElement"), _widest(field)
    branches = []
    for case, numbers in _shapes(field):
        bits = Bytes(holder.array, position).number(0, case.value.size, case.order, case.swapped)
        target_element = target.element(index)
        body: list[Statement] = [Assignment(target_element, bits.converted(wide))]
        if is_truth(case.value.encoding):
            whole = UNSIGNED[wide.size]
            body.append(draft.refusal(target_element.converted(whole).compared(">", 1), "unknown_value"))
        branches.append((tuple(runs(numbers)), tuple(body)))
    start = holder.first.plus(holder.start + field.offset)
    place = start.combined("+", index.combined("*", element))
    last = count.plus(-1) if count is not None else number((field.count or 1) - 1)
    loop = Loop(index, number(0), last, (Assignment(position, place), Selection(selector, tuple(branches))))
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
    """The statements that write the low bits of the elements; a value with too many bits is refused."""
    assert isinstance(element, Variable)
    sizes = [
        (tuple(runs(numbers)), (Assignment(element, number(case.value.size)),)) for case, numbers in _shapes(field)
    ]
    index, position = draft.local("iElement"), draft.local("iAtElement")
    wide = _widest(field)
    source_element = source.element(index)
    branches = []
    for case, numbers in _shapes(field):
        highest = 1 if is_truth(case.value.encoding) else (1 << (8 * case.value.size)) - 1
        body: list[Statement] = []
        if highest < wide.high:
            whole = UNSIGNED[wide.size]
            body.append(draft.refusal(source_element.converted(whole).compared(">", highest), "out_of_range"))
        raw = draft.local(f"{PREFIXES[wide.name]}Raw", wide)
        body.append(Assignment(raw, source_element))
        body += Bytes(holder.array, position).stored(0, case.value.size, case.order, case.swapped, raw)
        branches.append((tuple(runs(numbers)), tuple(body)))
    start = holder.first.plus(holder.start + field.offset)
    place = start.combined("+", index.combined("*", element))
    last = count.plus(-1) if count is not None else number((field.count or 1) - 1)
    return [
        Selection(selector, tuple(sizes), draft.status.give(draft.result, "unknown_value")),
        Loop(index, number(0), last, (Assignment(position, place), Selection(selector, tuple(branches)))),
    ]
