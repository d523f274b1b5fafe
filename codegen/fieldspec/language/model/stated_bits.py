"""The bits of a number that say whether a field, or another element of a list, is sent."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.language.model.enums import Enum
from fieldspec.language.model.record import Presence
from fieldspec.language.model.value import Value


def stated_bits(presence: Presence, value: Value, enums: Mapping[str, Enum]) -> tuple[int, tuple[int, ...] | range]:
    """The mask of the bits in a number with a value, and the numbers in them that say that something is sent.

    Where any of several bits says it, the numbers are a range, which has others besides that these bits cannot have.
    """
    if presence.bits:
        mask = sum((2 << high) - (1 << low) for low, high in presence.bits)
        lowest = mask & -mask
        return mask, (0,) if not presence.value else (mask,) if mask == lowest else range(lowest, mask + 1, lowest)
    enum = enums.get(value.enum)
    members = [enum.named(name) for name in presence.when] if enum is not None else []
    return (1 << 8 * value.size) - 1, tuple(sorted({member.value for member in members if member is not None}))


def legal_numbers(presence: Presence, value: Value, enums: Mapping[str, Enum]) -> tuple[int | None, int | None]:
    """Numbers that programs may write which say that something is sent, and that nothing is; None where none does."""
    mask, numbers_if_sent = stated_bits(presence, value, enums)
    ranges, enum = value.writable_ranges, enums.get(value.enum)
    members = [member.value for member in enum.members if not member.unavailable] if enum is not None else []
    bounds = [bound for pair in ranges.intervals for bound in pair] if ranges is not None else [0]
    candidates = [*bounds, *members]
    if presence.bits:
        candidates += [own for number in candidates for own in (number & ~mask, number | mask & -mask)]
    else:
        candidates += [*numbers_if_sent, *range(len(numbers_if_sent) + 1)]
    if enum is not None and not enum.open:
        candidates = [number for number in candidates if number in members]
    numbers = [number for number in candidates if value.low <= number <= value.high]
    numbers = [number for number in numbers if ranges is None or number in ranges]
    following = (own for own in numbers if own & mask in numbers_if_sent)
    ending = (own for own in numbers if own & mask not in numbers_if_sent)
    return next(following, None), next(ending, None)
