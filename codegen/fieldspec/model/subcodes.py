"""Where messages that share a code differ: a constant that all of them have at the same place of their data."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from fieldspec.classes import TYPE_CHECKING
from fieldspec.model.value import Kind

if TYPE_CHECKING:
    from fieldspec.model.record import Field

Place = tuple[int, int, str]
"""The offset of a constant in the data, its bytes, and its byte order."""

WIDEST = 2
"""The bytes of the widest constant that tells messages apart."""


def constant_at(field: Field, offset: int, order: str) -> tuple[Place, int] | None:
    """The place and the number of a field that may tell messages apart, None for any other field.

    `order` is the byte order of values without their own. The number is unsigned.
    """
    value = field.value
    if value is None or value.const is None or field.reserved or field.count is not None or field.repeat is not None:
        return None
    if value.type.kind is not Kind.INTEGER or value.size > WIDEST:
        return None
    own = (value.byte_order or order) if value.size > 1 else "big"
    return (offset, value.size, own), value.const & (1 << 8 * value.size) - 1


def distinct_place(constants: Sequence[Mapping[Place, int]]) -> Place | None:
    """The first place at which all of some messages have a constant, each another one; None if there is none."""
    for place in constants[0]:
        numbers = {numbers.get(place) for numbers in constants}
        if None not in numbers and len(numbers) == len(constants):
            return place
    return None
