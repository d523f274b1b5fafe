"""Literals and types of Structured Text. Text of a spec gets into them through these functions only."""

from __future__ import annotations

from decimal import Decimal

from fieldspec.plc.constants import Constant
from fieldspec.plc.routines.types import ArrayType, Type


def number(constant: Constant) -> str:
    """The value of a constant, as people know it."""
    value = constant.value
    if isinstance(value, Decimal) or constant.type.family == "real":
        return real(Decimal(value))
    if constant.hexadecimal and value >= 0:
        return f"16#{value:0{2 * constant.type.size}X}"
    return str(value)


def real(value: Decimal) -> str:
    """A decimal number with a point."""
    text = f"{value:f}"
    return text if "." in text else f"{text}.0"


def narrow(text: str) -> bool:
    """Whether a text fits STRING, which has no other characters than those of ASCII on every controller."""
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
    return [int.from_bytes(data[at : at + 2], "big") for at in range(0, len(data), 2)]


def length(text: str, wide: bool) -> int:
    """How many elements of a STRING or WSTRING a text takes."""
    return len(text.encode("utf-16-be", "replace")) // 2 if wide else len(text)


def type_name(kind: Type) -> str:
    """A type where something is declared."""
    if isinstance(kind, ArrayType):
        return f"ARRAY[{kind.low}..{kind.high}] OF {type_name(kind.of)}"
    return kind.name


def innermost(kind: Type) -> Type:
    """The type of the elements of an array, or of arrays of arrays."""
    while isinstance(kind, ArrayType):
        kind = kind.of
    return kind
