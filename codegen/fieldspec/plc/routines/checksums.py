"""The checks that close a frame, as functions over its bytes."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from fieldspec.plc.routines.expressions import (
    BYTE,
    INT,
    UINT,
    WORD,
    Conversion,
    Element,
    Elementary,
    Expression,
    Operation,
    Shift,
    Variable,
    Whole,
    compared,
    converted,
    every,
    number,
    plus,
)
from fieldspec.plc.routines.routine import Assignment, Body, Declared, Loop, Routine, when
from fieldspec.plc.routines.world import World

_FIRST = Variable("iFirst", INT)
_LENGTH, _AT, _BIT = Variable("iLength", INT), Variable("iAt", INT), Variable("iBit", INT)
_CHECK, _SUM = Variable("wCheck", WORD), Variable("uiSum", UINT)

_Make = Callable[[Variable, Variable, Expression], tuple[tuple[Variable, ...], Body]]


def checksum(world: World, algorithm: str) -> Routine:
    """The function of an algorithm; its result is the number that the frame ends with."""
    kind, remark, make = CHECKSUMS[algorithm]
    name = world.routine(algorithm)
    frame = Variable("aFrame", world.frame)
    result = Variable(name, kind)
    later = world.begins_later(algorithm)
    locals_, body = make(frame, result, _FIRST if later else number(0))
    fits: Expression = compared(_LENGTH, "<=", number(world.frame.high + 1))
    fits = every([compared(_FIRST, ">=", number(0)), fits]) if later else fits
    return Routine(
        name,
        "checks",
        kind,
        (
            *([Declared(_FIRST, "input", "index of the first byte that is checked")] if later else []),
            Declared(
                _LENGTH,
                "input",
                "index behind the last byte that is checked; one behind the array gives 0"
                if later
                else "how many bytes from the first one on are checked; more than there are give 0",
            ),
            Declared(frame, "in_out", "is read only"),
            *(Declared(variable, "local") for variable in locals_),
        ),
        (Assignment(result, Whole(0, kind)), when(fits, body)),
        (remark,),
    )


def _bytes(first: Expression, body: Body) -> Loop:
    return Loop(_AT, first, plus(_LENGTH, -1), body)


def _crc16_modbus(frame: Variable, result: Variable, first: Expression) -> tuple[tuple[Variable, ...], Body]:
    half = Shift("SHR", _CHECK, 1, WORD)
    odd = compared(Operation("AND", (_CHECK, Whole(1, WORD)), WORD), "<>", Whole(0, WORD))
    turned = Assignment(_CHECK, Operation("XOR", (half, Whole(0xA001, WORD)), WORD))
    bits = Loop(_BIT, number(0), number(7), (when(odd, [turned], [Assignment(_CHECK, half)]),))
    taken = Operation("XOR", (_CHECK, converted(Element(frame, _AT, BYTE), WORD)), WORD)
    return (_AT, _BIT, _CHECK), (
        Assignment(_CHECK, Whole(0xFFFF, WORD)),
        _bytes(first, (Assignment(_CHECK, taken), bits)),
        Assignment(result, _CHECK),
    )


def _summed(frame: Variable, first: Expression) -> Body:
    term = Conversion(Element(frame, _AT, BYTE), UINT)
    total = Operation("MOD", (Operation("+", (_SUM, term), UINT), Whole(256, UINT)), UINT)
    return Assignment(_SUM, Whole(0, UINT)), _bytes(first, (Assignment(_SUM, total),))


def _sum8(frame: Variable, result: Variable, first: Expression) -> tuple[tuple[Variable, ...], Body]:
    return (_AT, _SUM), (*_summed(frame, first), Assignment(result, Conversion(_SUM, BYTE)))


def _lrc(frame: Variable, result: Variable, first: Expression) -> tuple[tuple[Variable, ...], Body]:
    rest = Operation("-", (Whole(256, UINT), _SUM), UINT)
    negative = Conversion(Operation("MOD", (rest, Whole(256, UINT)), UINT), BYTE)
    return (_AT, _SUM), (*_summed(frame, first), Assignment(result, negative))


CHECKSUMS: Mapping[str, tuple[Elementary, str, _Make]] = {
    "crc16_modbus": (WORD, "The CRC of some bytes, by the polynomial 16#A001 from 16#FFFF on.", _crc16_modbus),
    "lrc": (BYTE, "What makes the sum of some bytes a multiple of 256.", _lrc),
    "sum8": (BYTE, "The lowest byte of the sum of some bytes.", _sum8),
}
"""What a check's algorithm gives, what it is, and its statements."""
