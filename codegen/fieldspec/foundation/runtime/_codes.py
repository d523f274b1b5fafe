"""Members of enums by their printed names and their other numbers."""

from __future__ import annotations

from ._error import CodecError
from ._typing import TYPE_CHECKING, R

if TYPE_CHECKING:
    from collections.abc import Mapping


def by_printed_name(enum: str, members: Mapping[int, R], names: Mapping[int, str], text: str) -> R:
    """The member with a printed name, in capital or small letters. Raises CodecError."""
    folded_text = text.strip().casefold()
    for value, name in names.items():
        if name.casefold() == folded_text:
            return members[value]
    raise CodecError("unknown_value", f"{enum} has no member that is printed as {text!r}")


def by_number(enum: str, members: Mapping[int, R], numbers: Mapping[int, int], number: int) -> R:
    """The member whose number differs from its value. Raises CodecError."""
    for value, other in numbers.items():
        if other == number:
            return members[value]
    raise CodecError("unknown_value", f"{enum} has no member with the number {number}")
