"""The number of bits that a request writes, compared with the bytes into which they are packed."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.targets.python.slots import Slots
from fieldspec.targets.python.text import literal


def fills(number: str, packed: str, operator: str) -> str:
    """The comparison of the bytes of a bit count with the bytes of a list."""
    return f"({number} + 7) // 8 {operator} len({packed})"


def bit_count_test(field: Slots, number: str, packed: str, offset: int) -> list[str]:
    """The lines that refuse a number of bits in a record that has been read, with the `offset` of that number."""
    return [
        f"if {fills(number, packed, '!=')}:",
        f"    raise _wrong_bits({_arguments(field, number, packed)}, {offset})",
    ]


def bit_count_refusal(field: Slots, expressions: Mapping[str, str]) -> str:
    """The expression of the refusal of a number of bits that is to be written: a CodecError, or None."""
    return f"_refused_bits({_arguments(field, expressions[field.title], expressions[field.field.bits_of])})"


def _arguments(field: Slots, number: str, packed: str) -> str:
    return f"{literal(field.title)}, {number}, {literal(field.field.bits_of)}, len({packed})"
