"""The elements of lists in many bodies, by the bits of fields."""

from __future__ import annotations

import numpy as np

from fieldspec.codec.layout.inner_lists import InnerList
from fieldspec.codec.layout.presence import PresenceLayout
from fieldspec.tools.captures.columns import Bytes, Mask, Numbers, number_at


def has_element(buffer: Bytes, offsets: Numbers, inner: InnerList, number: int) -> Mask:
    """Whether the lists of records that begin at some places have an element with a number."""
    is_there = np.ones(len(offsets), np.bool_)
    if inner.count:
        units = number_at(buffer, offsets + inner.count_at, inner.count_size, inner.count_order)
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
        numbers = number_at(buffer, place, continuation.size, continuation.order)
        is_there &= is_met(continuation.presence, numbers & continuation.presence.mask)
    return is_there


def is_met(presence: PresenceLayout, bits: Numbers) -> Mask:
    """Whether the deciding bits of numbers say that something is sent."""
    return bits > 0 if presence.is_any else np.isin(bits, presence.number_list)


def presence_bits(presence: PresenceLayout, numbers: Numbers) -> Numbers:
    """The numbers in the bits that count."""
    return (numbers & presence.mask) >> presence.shift
