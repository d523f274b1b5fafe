"""Records: out of a holder into a struct, and back."""

from __future__ import annotations

from collections.abc import Callable

from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.plc.routines.draft import Draft
from fieldspec.plc.routines.expressions import (
    Element,
    Expression,
    Member,
    Operation,
    Variable,
    Whole,
    added,
    number,
    plus,
)
from fieldspec.plc.routines.holders import Holder
from fieldspec.plc.routines.statements import Assignment, Loop, Statement
from fieldspec.plc.routines.types import INT, ArrayType, Type
from fieldspec.plc.routines.values import Wire, read, write, write_number
from fieldspec.plc.routines.world import World

# The expression of a field's variable.
Place = Callable[[FieldLayout], Expression]


def given(field: FieldLayout) -> bool:
    """Whether users give the field: it is no constant, measures nothing, and has a meaning."""
    constant = field.value is not None and field.value.const is not None
    return not (constant or field.field.measures or field.field.reserved)


def members_of(world: World, record: RecordLayout, struct: Expression) -> Place:
    """Where the fields of a record are in a variable of its struct."""
    return lambda field: Member(struct, world.member(record.name, field.name), field_type(world, field))


def field_type(world: World, field: FieldLayout) -> Type:
    """The type of a field's variable; for a list, that of as many elements as there can be."""
    one = world.struct(field.record.name) if field.record is not None else world.type_of(Wire.of_field(field).value)
    if not field.listed:
        return one
    repeat = field.field.repeat
    return ArrayType(0, (repeat.high if repeat is not None else field.count or 1) - 1, one)


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
    target = place(field) if given(field) else None

    def one(at: Holder, offset: int, held: Expression | None) -> list[Statement]:
        if field.record is not None:
            assert held is not None
            return read_fields(draft, world, field.record, at.behind(offset), members_of(world, field.record, held))
        return read(draft, world, Wire.of_field(field), at, offset, held)

    return _each(draft, field, holder, target, count, one)


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
    if not given(field):
        return write_number(Wire.of_field(field), holder, field.offset, field.count or 0)

    def one(at: Holder, offset: int, held: Expression | None) -> list[Statement]:
        assert held is not None
        if field.record is not None:
            return write_fields(draft, world, field.record, at.behind(offset), members_of(world, field.record, held))
        return write(draft, world, Wire.of_field(field), at, offset, held)

    return _each(draft, field, holder, place(field), count, one)


_One = Callable[[Holder, int, Expression | None], list[Statement]]


def _each(
    draft: Draft, field: FieldLayout, holder: Holder, target: Expression | None, count: Expression | None, one: _One
) -> list[Statement]:
    """The statements for a field: once, or for each of its elements in a loop."""
    if not field.listed:
        return one(holder, field.offset, target)
    assert target is not None
    assert isinstance(target.type, ArrayType)
    start, step = holder.behind(field.offset).index(), field.size // holder.unit
    if start is None or field.size % holder.unit:
        assert count is None
        elements = [Element(target, number(at), target.type.of) for at in range(field.count or 1)]
        inner = [one(holder, field.offset + at * field.size, held) for at, held in enumerate(elements)]
        return [statement for statements in inner for statement in statements]
    index = _free_index(draft, target)
    held = Element(target, index, target.type.of)
    here = added([start, Operation("*", (index, number(step)), INT) if step > 1 else index], INT)
    if isinstance(start, Whole) and start.value == 0 and step == 1:
        here = index
    if field.record is None and field.size == holder.unit:
        statements = one(holder.moved(here), 0, held)
    else:
        at = draft.local(f"iAt{index.name[1:]}")
        statements = [Assignment(at, here), *one(holder.moved(at), 0, held)]
    last = plus(count, -1) if count is not None else number((field.count or 1) - 1)
    return [Loop(index, number(0), last, tuple(statements))]


def _free_index(draft: Draft, target: Expression) -> Variable:
    """An index that no loop around this one has: the expression of the list says how deep it is."""
    depth, of = 0, target
    while isinstance(of, Member | Element):
        depth += isinstance(of, Element)
        of = of.of
    return draft.local("iElement" if depth == 0 else f"iInner{depth if depth > 1 else ''}")
