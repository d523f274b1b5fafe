"""Numbers that are sent as digits, in C: loaded, stored, and tested before they are loaded."""

from __future__ import annotations

from fieldspec.language.model.digits import BCD, NIBBLES, PACKED_DECIMAL, has_sign, is_complement
from fieldspec.language.model.encoding import is_signed
from fieldspec.language.model.value import Value
from fieldspec.targets.c.expressions import Call, Expression
from fieldspec.targets.c.literals import FALSE, TRUE, unsigned
from fieldspec.targets.c.machine import machine, of_bits, to_bits
from fieldspec.targets.c.naming import Naming

LETTERS = {"decimal": 0, "upper_hex": 0x41, "lower_hex": 0x61}


def digits_test(naming: Naming, value: Value, source: Expression, number: Expression) -> Expression:
    """`is_digits(in + 4, 6u, 2u, 0u)`: whether bytes are the digits of a value; `number` is what BCD is loaded as."""
    if value.digits in NIBBLES:
        return Call(naming.own(f"is_{nibbles_name(value)}"), (number, *_sign_place(value)))
    if value.codec:
        return Call(naming.own(f"is_codec_{value.codec}"), (source,))
    size, places = unsigned(value.size), unsigned(value.places)
    if value.has_blanks:
        signed = TRUE if is_signed(value.encoding) else FALSE
        return Call(naming.own("is_blank_digits"), (source, size, places, signed))
    if has_sign(value):
        return Call(naming.own("is_signed_digits"), (source, size, places))
    return Call(naming.own("is_digits"), (source, size, places, unsigned(LETTERS[value.digits])))


def load_digits(naming: Naming, value: Value, source: Expression, number: Expression) -> Expression:
    """`(uint16_t)load_digits(in + 4, 6u, 10u)`: the number of digits, as the type of the value."""
    kind = machine(value.encoding)
    if value.codec:
        return Call(naming.own(f"load_codec_{value.codec}"), (source,)).cast(kind.type)
    if has_sign(value):
        loaded = Call(naming.own("load_signed_digits"), (source, unsigned(value.size)))
        return loaded.cast(kind.type)
    if value.digits in NIBBLES:
        call = Call(naming.own(f"of_{nibbles_name(value)}"), (number, *_sign_place(value)))
        return call.cast(kind.type if is_signed(value.encoding) else kind.word)
    if value.has_blanks:
        loaded = Call(naming.own("load_blank_digits"), (source, unsigned(value.size)))
        return of_bits(naming, value.encoding, loaded.cast(kind.word))
    base = 16 if LETTERS[value.digits] else 10
    if value.is_low_first:
        loaded = Call(naming.own("load_low_first_digits"), (source, unsigned(value.size)))
    else:
        loaded = Call(naming.own("load_digits"), (source, unsigned(value.size), unsigned(base)))
    return of_bits(naming, value.encoding, loaded.cast(kind.word))


def digits_call(
    naming: Naming, value: Value, target: Expression, number: Expression
) -> tuple[str, tuple[Expression, ...]]:
    """The function that writes digits as characters, and its arguments."""
    if value.codec:
        return naming.own(f"{value.codec}_encode"), (number.cast("int64_t"), target)
    size, places = unsigned(value.size), unsigned(value.places)
    if value.has_blanks:
        sign = "signed_" if is_signed(value.encoding) else ""
        return naming.own(f"store_{sign}blank_digits"), (target, size, places, number)
    if has_sign(value):
        return naming.own("store_signed_digits"), (target, size, places, number)
    raw = to_bits(naming, value.encoding, number) if is_complement(value) else number
    if value.is_low_first:
        return naming.own("store_low_first_digits"), (target, size, unsigned(LETTERS[value.digits]), raw)
    return naming.own("store_digits"), (target, size, places, unsigned(LETTERS[value.digits]), raw)


def digits_parts(values: list[Value]) -> list[str]:
    """The parts of the file of the runtime that these values need."""
    characters = [value for value in values if value.has_characters]
    parts = ["digits"] if characters else []
    parts += ["signed_digits"] if any(map(has_sign, characters)) else []
    blank = [value for value in characters if value.has_blanks]
    parts += ["blank_digits"] if blank else []
    parts += ["signed_blank_digits"] if any(is_signed(value.encoding) for value in blank) else []
    parts += ["low_first_digits"] if any(value.is_low_first for value in characters) else []
    nibbles = {nibbles_name(value) for value in values if value.digits in NIBBLES}
    parts += ["bcd"] if nibbles else []
    return [*parts, *(name for name in ("signed_bcd", "unsigned_packed", "signed_packed") if name in nibbles)]


def nibbles_name(value: Value) -> str:
    """What functions call two decimal digits in each byte, with or without a sign: `bcd`, `signed_packed`"""
    signed = is_signed(value.encoding)
    if value.digits == PACKED_DECIMAL:
        return "signed_packed" if signed else "unsigned_packed"
    return "signed_bcd" if signed else BCD


def _sign_place(value: Value) -> tuple[Expression, ...]:
    """The place of the highest nibble, which is a sign below zero."""
    return (unsigned(8 * value.size - 4),) if nibbles_name(value) == "signed_bcd" else ()


def to_nibbles(naming: Naming, value: Value, number: Expression) -> Expression:
    """`to_signed_bcd(in->flow, 28u)`: the digits of a number, with four bits each."""
    return Call(naming.own(f"to_{nibbles_name(value)}"), (number, *_sign_place(value)))
