"""Literals of controllers: numbers in statements, what constants have in their declarations, and texts."""

from __future__ import annotations

from decimal import Decimal

from fieldspec.targets.controllers.statements.expressions import Elementary, Fraction, Whole

_UNTYPED = range(-(1 << 31), 1 << 31)
"""The numbers that every compiler takes without their type."""
_GREATEST_DECIMAL = (1 << 63) - 1


def whole(literal: Whole) -> str:
    """A number; with its type where a compiler may take it for another one.

    Not every compiler knows a sign after the mark of the type, so it stands before it.
    """
    value, kind, hexadecimal = literal.value, literal.type, literal.hexadecimal
    # Translators to C write decimal numbers without a suffix, and none beyond 63 bits has a type there.
    if kind.family == "bits" or hexadecimal or value > _GREATEST_DECIMAL:
        return f"{kind.name}#16#{value:0{2 * kind.size}X}"
    if value in _UNTYPED:
        return str(value)
    if value == kind.low:
        return f"(-{kind.name}#{-value - 1} - 1)"
    return f"{'-' if value < 0 else ''}{kind.name}#{abs(value)}"


def fraction(literal: Fraction) -> str:
    """A decimal number with its type."""
    sign = "-" if literal.digits.startswith("-") else ""
    return f"{sign}{literal.type.name}#{literal.digits.removeprefix('-')}"


def initial(value: int | Decimal, kind: Elementary, hexadecimal: bool) -> str:
    """The literal of a constant in its declaration, which states the type; hexadecimal if the manual writes it so."""
    if isinstance(value, Decimal) or kind.family == "real":
        return real(Decimal(value))
    if hexadecimal and value >= 0:
        return f"16#{value:0{2 * kind.size}X}"
    return str(value)


def real(value: Decimal) -> str:
    """The literal of a decimal number, with a point."""
    text = f"{value:f}"
    return text if "." in text else f"{text}.0"


def narrow(text: str) -> bool:
    """Whether a text fits STRING, which has only ASCII characters on some controllers."""
    return text.isascii()


def string(text: str, wide: bool) -> str:
    """A literal of STRING, or of WSTRING where `wide`; its characters are escaped where they end or control it."""
    mark = '"' if wide else "'"
    return mark + "".join(_escaped(char, mark, wide) for char in text) + mark


def _escaped(char: str, mark: str, wide: bool) -> str:
    if char in ("$", mark):
        return f"${char}"
    if char.isprintable():
        return char
    return "".join(f"${unit:04X}" if wide else f"${unit:02X}" for unit in _units(char, wide))


def _units(char: str, wide: bool) -> list[int]:
    if not wide:
        return [ord(char)]
    data = char.encode("utf-16-be", "replace")
    return [int.from_bytes(data[offset : offset + 2], "big") for offset in range(0, len(data), 2)]


def length(text: str, wide: bool) -> int:
    """The number of elements that a text takes in a STRING or WSTRING."""
    return len(text.encode("utf-16-be", "replace")) // 2 if wide else len(text)
