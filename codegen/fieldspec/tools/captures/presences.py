"""The elements of lists in many bodies, by the bits of fields."""

from __future__ import annotations

import numpy as np

from fieldspec.codec.layout.inner_lists import InnerList
from fieldspec.codec.layout.presence import PresenceLayout
from fieldspec.foundation.runtime._digits import size_in
from fieldspec.tools.captures.columns import Bytes, Mask, Numbers, number_at, numbers


def counts_at(buffer: Bytes, offsets: Numbers, inner: InnerList) -> Numbers:
    """The numbers that count the lists of records that begin at some places; 0 for bytes that are not digits."""
    place = offsets + inner.count_at
    if inner.count_order in ("big", "little"):
        return number_at(buffer, place, inner.count_size, inner.count_order)
    pieces = (buffer[first : first + inner.count_size].tobytes() for first in place.tolist())
    return numbers([size_in(piece, inner.count_order) or 0 for piece in pieces])


def has_element(buffer: Bytes, offsets: Numbers, inner: InnerList, number: int) -> Mask:
    """Whether the lists of records that begin at some places have an element with a number."""
    is_there = np.ones(len(offsets), np.bool_)
    if inner.count:
        units = counts_at(buffer, offsets, inner)
        units = units if inner.presence is None else units & inner.presence.mask
        if inner.presence is not None and inner.presence.numbers:
            is_there = is_met(inner.presence, units)
        else:
            units = units if inner.presence is None else presence_bits(inner.presence, units)
            is_there = (units - inner.plus) * inner.unit // inner.element > number
    continuation = inner.continuation
    for index in range(number if continuation is not None else 0):
        assert continuation is not None
        place = offsets + inner.room + index * inner.element + continuation.offset
        codes = number_at(buffer, place, continuation.size, continuation.order)
        is_there &= is_met(continuation.presence, codes & continuation.presence.mask)
    return is_there


def is_met(presence: PresenceLayout, bits: Numbers) -> Mask:
    """Whether the deciding bits of numbers say that something is sent."""
    return bits > 0 if presence.is_any else np.isin(bits, presence.number_list)


def presence_bits(presence: PresenceLayout, numbers: Numbers) -> Numbers:
    """The numbers in the bits that count."""
    return (numbers & presence.mask) >> presence.shift
