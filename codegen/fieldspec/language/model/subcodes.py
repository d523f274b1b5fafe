"""Where messages that share a code differ: in the numbers of a field that all of them have at the same place."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.model.digits import digit_bounds, digits_bytes
from fieldspec.language.model.encoding import is_count, is_signed
from fieldspec.language.model.raw_numbers import orders_of

if TYPE_CHECKING:
    from fieldspec.language.model.record import Field

Place = tuple[int, int, str]
"""The offset of a constant in the data, its bytes, and its byte order."""

WIDEST = 8
"""The bytes of the widest code, and of the widest constant that tells messages apart or marks exception responses."""

Numbers = tuple[int, ...]
"""The numbers that a field may have, in the order of the spec."""


def constant_at(field: Field, offset: int, order: str, word_order: str) -> tuple[Place, int] | None:
    """The place and the unsigned number of a constant of at most `WIDEST` bytes, None for any other field.

    `order` and `word_order` apply to values without their own. The number is that of the bytes as they are sent, in the
    order of the bytes of a word: that of 0x12345678 with its low word first is 0x56781234, and that of digits
    the number of their bytes. Digits with a sign have no place, as a zero can have either sign.
    """
    value = field.value
    if value is None or value.const is None or field.reserved or field.count is not None or field.repeat is not None:
        return None
    if not is_count(value.encoding) or value.width or value.size > WIDEST:
        return None
    sent_order = (value.byte_order or order) if value.size > 1 and not value.has_characters else "big"
    number = value.const & (1 << 8 * value.size) - 1
    if value.digits:
        if value.codec or is_signed(value.encoding) or not 0 <= value.const <= digit_bounds(value)[1]:
            return None
        number = int.from_bytes(digits_bytes(value, value.const), "big")
    if orders_of(value, order, word_order)[1]:
        words = [number >> 16 * word & 0xFFFF for word in range(value.size // 2)]
        number = sum(word << 16 * place for place, word in enumerate(reversed(words)))
    return (offset, value.size, sent_order), number


def numbers_at(field: Field, offset: int, order: str, word_order: str) -> tuple[Place, Numbers] | None:
    """The place and the numbers of a field that may tell messages apart, None for any other field.

    The numbers are its constant, or the range of an unsigned byte. The orders are as in `constant_at`.
    """
    constant = constant_at(field, offset, order, word_order)
    if constant is not None:
        return constant[0], (constant[1],)
    value = field.value
    if value is None or value.ranges is None or value.write_ranges is not None or value.sentinels or field.reserved:
        return None
    if field.count is not None or field.repeat is not None or value.parameter is not None or value.width:
        return None
    if not is_count(value.encoding) or is_signed(value.encoding) or value.size != 1 or value.digits:
        return None
    numbers = (number for low, high in value.ranges.intervals for number in range(max(low, 0), min(high, 0xFF) + 1))
    return (offset, 1, "big"), tuple(dict.fromkeys(numbers))


def distinct_place(places: Sequence[Mapping[Place, Numbers]]) -> Place | None:
    """The first place at which all of some messages have numbers that no other of them has; None if there is none.

    A place where each has a constant is preferred.
    """
    common = [place for place in places[0] if all(numbers.get(place) for numbers in places)]
    for place in sorted(common, key=lambda place: any(len(numbers[place]) > 1 for numbers in places)):
        all_numbers = [number for numbers in places for number in numbers[place]]
        if len(set(all_numbers)) == len(all_numbers):
            return place
    return None
