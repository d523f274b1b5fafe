"""Records: from bytes into a struct and back, with choices between field types."""

from __future__ import annotations

from collections.abc import Callable

from fieldspec.codec.layout.record import CaseLayout, FieldLayout, RecordLayout
from fieldspec.language.model.encoding import is_truth
from fieldspec.targets.controllers.routines.drafts import Draft
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
    Type,
    Variable,
    Whole,
    number,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Loop, Selection, Statement

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


def read_fields(draft: Draft, record: RecordLayout, holder: Holder, place: Place) -> list[Statement]:
    """The statements that read the fields of a record, which has no repeated ones, into their variables."""
    return _fields(record, lambda field: read_field(draft, field, holder, place))


def read_field(
    draft: Draft, field: FieldLayout, holder: Holder, place: Place, count: Expression | None = None
) -> list[Statement]:
    """The statements that read a field into its variable; a repeated one has `count` elements."""
    if field.field.reserved:
        return []

    def element_statements(start: Holder, variable: Expression | None) -> list[Statement]:
        if field.record is not None and variable is not None:
            return read_fields(draft, field.record, start, members_of(draft.world, field.record, variable))
        return read(draft, Wire.of_field(field), start, variable)

    return _each(draft, field, holder, place(field) if is_user_field(field) else None, count, element_statements)


def write_fields(draft: Draft, record: RecordLayout, holder: Holder, place: Place) -> list[Statement]:
    """The statements that write the variables of a record, which has no repeated fields, into the holder."""
    return _fields(record, lambda field: write_field(draft, field, holder, place))


def write_field(
    draft: Draft, field: FieldLayout, holder: Holder, place: Place, count: Expression | None = None
) -> list[Statement]:
    """The statements that write the variable of a field into the holder."""
    if not is_user_field(field):
        return write_number(Wire.of_field(field), holder.behind(field.offset), field.count or 0)

    def element_statements(start: Holder, variable: Expression | None) -> list[Statement]:
        assert variable is not None
        if field.record is not None:
            return write_fields(draft, field.record, start, members_of(draft.world, field.record, variable))
        return write(draft, Wire.of_field(field), start, variable)

    return _each(draft, field, holder, place(field), count, element_statements)


def _fields(record: RecordLayout, statements_of: Callable[[FieldLayout], list[Statement]]) -> list[Statement]:
    """The statements for the fields of a record that measure no other field."""
    fields = (field for field in record.fields if field.field.measures is None)
    return [statement for field in fields for statement in statements_of(field)]


def _each(
    draft: Draft,
    field: FieldLayout,
    holder: Holder,
    target: Expression | None,
    count: Expression | None,
    statements_of: Callable[[Holder, Expression | None], list[Statement]],
) -> list[Statement]:
    """The statements for a field: once, or for each of its elements in a loop."""
    element = holder.behind(field.offset)
    if not field.is_list:
        return statements_of(element, target)
    assert target is not None
    start, step = element.index(), field.size // holder.unit
    if start is None or field.size % holder.unit:
        assert count is None
        positions = range(field.count or 1)
        elements = [statements_of(element.behind(number * field.size), target.element(number)) for number in positions]
        return [statement for statements in elements for statement in statements]
    index = _free_index(draft, target)
    start_index: Expression = start.combined("+", index.combined("*", step) if step > 1 else index)
    if isinstance(start, Whole) and start.value == 0 and step == 1:
        start_index = index
    if field.record is None and field.size == holder.unit:
        statements = statements_of(holder.moved(start_index), target.element(index))
    else:
        position = draft.local(f"iAt{index.name[1:]}")
        statements = [
            Assignment(position, start_index),
            *statements_of(holder.moved(position), target.element(index)),
        ]
    return [Loop(index, number(0), _last(field, count), tuple(statements))]


def _last(field: FieldLayout, count: Expression | None) -> Expression:
    """The index of the last element of a list with `count` elements, or with a fixed number of them."""
    return count.plus(-1) if count is not None else number((field.count or 1) - 1)


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


def selecting(draft: Draft, selector: FieldLayout, source: Expression) -> Expression:
    """The number that chooses a case, in a variable; numbers that its enum does not list are refused."""
    value = Wire.of_field(selector).value
    if not isinstance(source.type, EnumType):
        return source.converted(UNSIGNED[selector.size])
    kind = draft.world.raw_type(value.enum)
    number = draft.local(f"{PREFIXES[kind.name]}Selected", kind)
    call = draft.world.enum_to_raw(value.enum, source, number)
    draft.refuse(call.negated(), "unknown_value")
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
    field: FieldLayout,
    selector: Expression,
    holder: Bytes,
    target: Expression,
    count: Variable | None,
    size: Expression,
) -> list[Statement]:
    """The statements that read the elements, each into the low bits of its variable, and count them."""
    statements: list[Statement] = []
    rest, element = size.plus(-field.offset), draft.local("iSize")
    if count is not None:
        repeat = field.field.repeat
        assert repeat is not None
        statements += [
            draft.refusal(rest.combined("MOD", element).compared("<>", 0), "wrong_length"),
            Assignment(count, rest.combined("/", element)),
            draft.refusal(count.compared("<", repeat.low), "incomplete"),
            draft.refusal(count.compared(">", repeat.high), "wrong_length"),
        ]
    index, wide = draft.local("iElement"), _widest(field)
    received, whole = target.element(index), UNSIGNED[wide.size]

    def body(case: CaseLayout, place: Bytes) -> list[Statement]:
        bits = place.number(0, case.value.size, case.order, case.swapped)
        assignment = Assignment(received, bits.converted(wide))
        if not is_truth(case.value.encoding):
            return [assignment]
        return [assignment, draft.refusal(received.converted(whole).compared(">", 1), "unknown_value")]

    return _chosen(draft, field, selector, holder, count, statements, body)


def write_choice(
    draft: Draft, field: FieldLayout, selector: Expression, holder: Bytes, source: Expression, count: Variable | None
) -> list[Statement]:
    """The statements that write the low bits of the elements; a value with too many bits is refused."""
    index, wide = draft.local("iElement"), _widest(field)
    source_bits, whole = source.element(index), UNSIGNED[wide.size]

    def body(case: CaseLayout, place: Bytes) -> list[Statement]:
        highest = 1 if is_truth(case.value.encoding) else (1 << (8 * case.value.size)) - 1
        too_great = source_bits.converted(whole).compared(">", highest)
        raw = draft.local(f"{PREFIXES[wide.name]}Raw", wide)
        stored = place.stored(0, case.value.size, case.order, case.swapped, raw)
        refusals = [draft.refusal(too_great, "out_of_range")] if highest < wide.high else []
        return [*refusals, Assignment(raw, source_bits), *stored]

    return _chosen(draft, field, selector, holder, count, [], body)


def _chosen(
    draft: Draft,
    field: FieldLayout,
    selector: Expression,
    holder: Bytes,
    count: Variable | None,
    before: list[Statement],
    body_of: Callable[[CaseLayout, Bytes], list[Statement]],
) -> list[Statement]:
    """The statements for the elements of a choice, by the case that the selector chooses.

    The statements `before` the elements know the size of one.
    """
    index, position, element = draft.local("iElement"), draft.local("iAtElement"), draft.local("iSize")
    sizes, branches = [], []
    for case, numbers in _shapes(field):
        intervals = tuple(runs(numbers))
        sizes.append((intervals, (Assignment(element, number(case.value.size)),)))
        branches.append((intervals, tuple(body_of(case, Bytes(holder.array, position)))))
    start = holder.first.plus(holder.start + field.offset)
    place = Assignment(position, start.combined("+", index.combined("*", element)))
    return [
        Selection(selector, tuple(sizes), draft.status.give(draft.result, "unknown_value")),
        *before,
        Loop(index, number(0), _last(field, count), (place, Selection(selector, tuple(branches)))),
    ]
