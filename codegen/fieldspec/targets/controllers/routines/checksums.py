"""The checks that close a frame, as functions over its bytes."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from fieldspec.foundation.runtime._checksums import reflected
from fieldspec.language.model.checksums import Checksum, checksum_named
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import (
    BYTE,
    INT,
    UINT,
    WORD,
    Elementary,
    Expression,
    Shift,
    Variable,
    Whole,
    every,
    number,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Body, Declared, Loop, Routine, when

_FIRST = Variable("iFirst", INT)
_LENGTH, _AT, _BIT = Variable("iLength", INT), Variable("iAt", INT), Variable("iBit", INT)
_CHECK, _SUM = Variable("wCheck", WORD), Variable("uiSum", UINT)

_Make = Callable[[Variable, Variable, Expression], tuple[tuple[Variable, ...], Body]]


def is_supported(algorithm: str) -> bool:
    """Whether there is a function: for CRCs of 8 and 16 bits, and sums and xors of bytes with 8 bits."""
    check = checksum_named(algorithm)
    if check.suffix or check.avoided or check.unit_size != 1:
        return False
    if check.method == "crc":
        return check.width in (8, 16) and check.reflect_in == check.reflect_out
    return check.method in ("sum", "xor") and check.width == 8


def checksum(world: World, algorithm: str) -> Routine:
    """The function of an algorithm; its result is the number that the frame ends with."""
    kind, remark, make = CHECKSUMS.get(algorithm) or _derived(checksum_named(algorithm))
    name = world.routine(algorithm)
    frame = Variable("aFrame", world.frame)
    result = Variable(name, kind)
    later = world.begins_later(algorithm)
    locals_, body = make(frame, result, _FIRST if later else number(0))
    fits: Expression = _LENGTH.compared("<=", world.frame.high + 1)
    fits = every([_FIRST.compared(">=", 0), fits]) if later else fits
    return Routine(
        name,
        "checks",
        kind,
        (
            *([Declared(_FIRST, "input", "index of the first byte that is checked")] if later else []),
            Declared(
                _LENGTH,
                "input",
                "index after the last byte that is checked; one after the array gives 0"
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
    return Loop(_AT, first, _LENGTH.plus(-1), body)


def _crc(check: Checksum) -> _Make:
    """The statements of a CRC, whose register is reflected where the lowest bit of each byte comes first."""
    is_reflected, width = check.reflect_in, check.width
    initial = reflected(check.initial, width) if is_reflected else check.initial
    term = reflected(check.polynomial, width) if is_reflected else check.polynomial
    first_bit = 1 if is_reflected else 1 << width - 1
    moved: Expression = Shift("SHR" if is_reflected else "SHL", _CHECK, 1, WORD)
    if not is_reflected and width < 16:
        moved = moved.combined("AND", check.mask)

    def make(frame: Variable, result: Variable, first: Expression) -> tuple[tuple[Variable, ...], Body]:
        carries = _CHECK.combined("AND", first_bit).compared("<>", 0)
        turned = Assignment(_CHECK, moved.combined("XOR", term))
        bits = Loop(_BIT, number(0), number(7), (when(carries, [turned], [Assignment(_CHECK, moved)]),))
        byte = frame.element(_AT).converted(WORD)
        if not is_reflected and width > 8:
            byte = Shift("SHL", byte, width - 8, WORD)
        final = _CHECK.combined("XOR", check.final_xor) if check.final_xor else _CHECK
        return (_AT, _BIT, _CHECK), (
            Assignment(_CHECK, Whole(initial, WORD)),
            _bytes(first, (Assignment(_CHECK, _CHECK.combined("XOR", byte)), bits)),
            Assignment(result, final if width > 8 else final.converted(BYTE)),
        )

    return make


def _xor(check: Checksum) -> _Make:
    def make(frame: Variable, result: Variable, first: Expression) -> tuple[tuple[Variable, ...], Body]:
        checked = _CHECK.combined("XOR", frame.element(_AT).converted(WORD))
        body = (Assignment(_CHECK, Whole(check.initial, WORD)), _bytes(first, (Assignment(_CHECK, checked),)))
        if check.complement == "twos":
            rest = Whole(256, UINT).combined("-", _CHECK.converted(UINT))
            whole: Expression = rest.combined("MOD", 256)
        else:
            whole = _CHECK.combined("XOR", 0xFF) if check.complement else _CHECK
        return (_AT, _CHECK), (*body, Assignment(result, whole.converted(BYTE)))

    return make


def _sum(check: Checksum) -> _Make:
    def make(frame: Variable, result: Variable, first: Expression) -> tuple[tuple[Variable, ...], Body]:
        whole: Expression = _SUM
        if check.complement == "ones":
            whole = Whole(255, UINT).combined("-", _SUM)
        if check.complement == "twos":
            rest = Whole(256, UINT).combined("-", _SUM)
            whole = rest.combined("MOD", 256)
        return (_AT, _SUM), (*_summed(frame, first, check.initial), Assignment(result, whole.converted(BYTE)))

    return make


def _derived(check: Checksum) -> tuple[Elementary, str, _Make]:
    """The type, the remark and the statements of an algorithm that `is_supported`."""
    if check.method == "crc":
        bits = f"{check.width} bits by the polynomial 16#{check.polynomial:0{check.width // 4}X}"
        return WORD if check.width > 8 else BYTE, f"The CRC of some bytes, of {bits}.", _crc(check)
    complement = {"": "", "ones": "The ones' complement of ", "twos": "The two's complement of "}[check.complement]
    start = f" from {check.initial} on" if check.initial else ""
    if check.method == "xor":
        text = f"{complement}the exclusive or of some bytes{start}."
        return BYTE, text[0].upper() + text[1:], _xor(check)
    text = f"{complement}the lowest byte of the sum of some bytes{start}."
    return BYTE, text[0].upper() + text[1:], _sum(check)


def _summed(frame: Variable, first: Expression, initial: int) -> Body:
    term = frame.element(_AT).converted(UINT)
    total = _SUM.combined("+", term).combined("MOD", 256)
    return Assignment(_SUM, Whole(initial, UINT)), _bytes(first, (Assignment(_SUM, total),))


CHECKSUMS: Mapping[str, tuple[Elementary, str, _Make]] = {
    "crc16_modbus": (
        WORD,
        "The CRC of some bytes, by the polynomial 16#A001 from 16#FFFF on.",
        _crc(checksum_named("crc16_modbus")),
    ),
    "lrc": (BYTE, "What makes the sum of some bytes a multiple of 256.", _sum(checksum_named("lrc"))),
}
"""The algorithms with words of their own: what they give, what they are, and their statements."""
