"""Values that have an address or a number: their constants, and functions that read and write one."""

from __future__ import annotations

from fractions import Fraction

from fieldspec.backends.c.enums import closed_test
from fieldspec.backends.c.naming import Naming, Noun
from fieldspec.backends.c.text import comment, indented, integer
from fieldspec.backends.c.values import Wire, declaration, decode_lines, encode_lines, fixed_lines
from fieldspec.classes import replace
from fieldspec.model.device import Device
from fieldspec.model.value import Kind, Value

ACCESS = {
    "ro": "Read only.",
    "rw": "Read and write.",
    "wo": "Write only.",
    "": "The manual does not say how it is accessed.",
}

_LARGEST = 2**63 - 1


def _real(number: int) -> str:
    """A whole number as a literal of a float."""
    return f"(-{-number}.0f)" if number < 0 else f"{number}.0f"


def constant_lines(naming: Naming, noun: Noun, names: tuple[str, ...], value: Value) -> list[str]:
    """The constant, the range, the default and the scale, each in counts or as a fraction."""
    found: list[tuple[str, str]] = []
    size, signed = value.size, value.type.signed
    if value.const is not None:
        found.append(("value", integer(value.const, size, signed)))
    if value.ranges is not None and value.type.kind is Kind.FLOAT:
        found += [("min", _real(value.ranges.low)), ("max", _real(value.ranges.high))]
    elif value.ranges is not None:
        found.append(("min", integer(value.ranges.low, size, signed)))
        found.append(("max", integer(value.ranges.high, size, signed)))
    if value.write_ranges is not None:
        found.append(("write_min", integer(value.write_ranges.low, size, signed)))
        found.append(("write_max", integer(value.write_ranges.high, size, signed)))
    if isinstance(value.default, int) and value.type.kind is not Kind.FLOAT:
        found.append(("default", integer(value.default, size, signed)))
    for name, exact, implied in (("scale", value.scale, 1), ("offset", value.offset, 0)):
        share = Fraction(exact)
        if share != implied and max(abs(share.numerator), share.denominator) <= _LARGEST:
            found.append((f"{name}_numerator", integer(share.numerator, 8)))
            found.append((f"{name}_denominator", integer(share.denominator, 8)))
    return [f"#define {naming.macro(noun, *names, name)} {text}" for name, text in found]


def access_lines(
    naming: Naming, device: Device, noun: Noun, names: tuple[str, ...], wire: Wire, size: int, trigger: bool
) -> list[str]:
    """The functions that read and write the value, as its bytes lie in a frame, filled up to a size in bytes.

    What the device answers is read whatever it is; only what is written must be the constant, or, of a trigger, what
    its enum lists.
    """
    value, status = wire.value, naming.own("codec_status")
    answer = replace(wire, value=value.as_answer(trigger))
    ok = f"return {naming.own_macro('ok')};"
    pad = [f"out[{at}] = 0;" for at in range(wire.size, size)]
    text = wire.kind in (Kind.TEXT, Kind.BYTES)
    target = "out" if text else "*out"
    decode = decode_lines(naming, answer, "in", target, closed_test(naming, device, answer.value, target))
    pointer = declaration(wire, target, None)
    if value.const is not None:
        encode, given = fixed_lines(naming, wire, value.const, "out"), ""
    else:
        encode = encode_lines(naming, wire, "value", "out", closed_test(naming, device, value, "value"))
        given = f"{'const ' if text else ''}{declaration(wire, 'value', None)}, "
    words = f"the {size} bytes of its words" if noun == "register" else ""
    return [
        *comment(f"Reads its value from {words}." if words else "Reads its value."),
        f"static inline {status} {naming.function(noun, *names, 'decode')}(const uint8_t *in, {pointer})",
        "{",
        *indented([*decode, ok]),
        "}",
        "",
        *comment(f"Writes its value to {words}." if words else "Writes its value."),
        f"static inline {status} {naming.function(noun, *names, 'encode')}({given}uint8_t *out)",
        "{",
        *indented([*encode, *pad, ok]),
        "}",
    ]
