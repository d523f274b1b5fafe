"""Groups of single bits: the bytes of messages to structs and back. The first bit is the least significant one."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.record import RegisterLayout
from fieldspec.language.model.registers import RegisterGroup
from fieldspec.targets.controllers.routines.drafts import Draft
from fieldspec.targets.controllers.routines.register_range import RegisterRange
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    INT,
    UINT,
    USINT,
    Call,
    Element,
    Expression,
    Variable,
    Whole,
    either,
    every,
    number,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Condition, Declared, Loop, Routine, Statement

_BYTE, _INDEX, _VALUE = Variable("usiByte", USINT), Variable("iIndex", INT), Variable("xValue", BOOL)
_STEP, _WEIGHT, _IS_SET = Variable("iStep", INT), Variable("uiWeight", UINT), Variable("xIsSet", BOOL)
_INPUTS = (
    Declared(_BYTE, "input", "the byte of the bit"),
    Declared(_INDEX, "input", "index of the bit, from 0; of the byte, its remainder by 8"),
)
_LOCALS = tuple(Declared(variable, "local") for variable in (_STEP, _WEIGHT))


def single_bit_routines(world: World) -> Iterator[Routine]:
    """The functions that read a bit of a byte and change it."""
    name = world.routine("bit")
    body = (*_weighed(), Assignment(Variable(name, BOOL), _is_set()))
    yield Routine(name, "registers", BOOL, (*_INPUTS, *_LOCALS), body, ("Whether a bit of a byte is 1.",))
    name = world.routine("with_bit")
    result, byte = Variable(name, USINT), _BYTE.converted(UINT)
    changes = (
        (every([_VALUE, _IS_SET.negated()]), (Assignment(result, _narrowed("+", byte)),)),
        (every([_IS_SET, _VALUE.negated()]), (Assignment(result, _narrowed("-", byte)),)),
    )
    body = (*_weighed(), Assignment(_IS_SET, _is_set()), Assignment(result, _BYTE), Condition(changes))
    declared = (*_INPUTS, Declared(_VALUE, "input", "the bit"), *_LOCALS, Declared(_IS_SET, "local"))
    yield Routine(name, "registers", USINT, declared, body, ("A byte with one bit changed.",))


def _weighed() -> tuple[Statement, ...]:
    """The statements that put 2 to the power of the bit's place into the local variable."""
    twice = Assignment(_WEIGHT, _WEIGHT.combined("*", 2))
    last = _INDEX.combined("MOD", 8)
    return Assignment(_WEIGHT, Whole(1, UINT)), Loop(_STEP, number(1), last, (twice,))


def _is_set() -> Expression:
    share = _BYTE.converted(UINT).combined("/", _WEIGHT)
    return share.combined("MOD", 2).compared("=", 1)


def _narrowed(operator: str, byte: Expression) -> Expression:
    return byte.combined(operator, _WEIGHT).converted(USINT)


def _about(group: RegisterGroup, registers: list[RegisterLayout]) -> str:
    first = min(register.address for register in registers)
    last = max(register.register.end for register in registers) - 1
    section = f" [{group.section}]" if group.section else ""
    return f"{group.title or group.name.replace('_', ' ')}{section}: addresses {first}..{last}."


def bits_to_group(world: World, group: RegisterGroup, registers: list[RegisterLayout]) -> Routine:
    """The function that unpacks the bits of a group."""
    draft = Draft(
        world,
        world.routine("unpack", group.name),
        f"registers {group.name}",
        f"Bits to struct: {_about(group, registers)}",
        "Each register whose bit is there is put into the struct; the others stay as they are.",
    )
    bits_range = _range(group, draft, "is read only")
    struct = draft.declare("stData", world.struct(group.name), "in_out", "receives the values")
    for register in registers:

        def read(index: Expression, variable: Expression) -> list[Statement]:
            byte = _byte(bits_range.array, index)
            return [Assignment(variable, Call(world.routine("bit"), (("usiByte", byte), ("iIndex", index)), (), BOOL))]

        draft.add(bits_range.each(register, struct, None, read))
    draft.refuse(bits_range.taken.compared("=", 0), "not_covered")
    return draft.finished()


def group_to_bits(world: World, group: RegisterGroup, registers: list[RegisterLayout]) -> Routine:
    """The function that packs the bits of a group."""
    draft = Draft(
        world,
        world.routine("pack", group.name),
        f"registers {group.name}",
        f"Struct to bits: {_about(group, registers)}",
        "All requested bits must belong to writable registers. Other bits of the bytes do not change.",
    )
    struct = draft.declare("stData", world.struct(group.name), "in_out", "is read only")
    bits_range = _range(group, draft, "receives the bits")
    for register in registers:

        def write(index: Expression, variable: Expression) -> list[Statement]:
            byte = _byte(bits_range.array, index)
            inputs = (("usiByte", byte), ("iIndex", index), ("xValue", variable))
            return [Assignment(byte, Call(world.routine("with_bit"), inputs, (), USINT))]

        draft.add(bits_range.each(register, struct, None, write))
    wrong = [bits_range.count.compared("<=", 0), bits_range.taken.compared("<>", bits_range.count)]
    draft.refuse(either(wrong), "not_covered")
    return draft.finished()


def _range(group: RegisterGroup, draft: Draft, remark: str) -> RegisterRange:
    array = Variable("aBits", draft.world.bits)
    return RegisterRange(draft.world, group, draft, array, 8 * (draft.world.bits.high + 1), "bit", remark)


def _byte(array: Variable, index: Expression) -> Element:
    return array.element(index.combined("/", 8))
