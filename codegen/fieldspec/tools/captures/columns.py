"""Columns of numbers over the bytes of many frames: reading numbers at places, gathering bytes, spreading rows."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import Sign

Bytes: TypeAlias = npt.NDArray[np.uint8]
Numbers: TypeAlias = npt.NDArray[np.int64]
Codes: TypeAlias = npt.NDArray[np.uint64]
Mask: TypeAlias = npt.NDArray[np.bool_]
Verdicts: TypeAlias = npt.NDArray[np.int8]
Texts: TypeAlias = npt.NDArray[np.int32]
"""Places in a list of texts; -1 means that there is no text."""

NO_TIME = int(np.iinfo(np.int64).min)
"""The time of a packet without one."""


def numbers(values: object) -> Numbers:
    """Whole numbers as a column."""
    return np.asarray(values, dtype=np.int64)


def number_at(
    buffer: Bytes, offsets: Numbers, size: int, order: str = "big", sign: Sign = Sign.NONE, swapped: bool = False
) -> Numbers:
    """The whole numbers of `size` bytes, up to 8, at some places, modulo 2^64.

    With `swapped`, the order of their 16-bit words is opposite to that of the bytes in each. Places outside of the
    buffer read other bytes of it; the caller has excluded them.
    """
    match sign:
        case Sign.NONE | Sign.COMPLEMENT:
            return _complement_at(buffer, offsets, size, order, sign.is_signed, swapped)
        case Sign.MAGNITUDE:
            bits, highest = _complement_at(buffer, offsets, size, order, False, swapped), 8 * size - 1
            magnitude = bits & (1 << highest) - 1
            return np.where(bits >> highest & 1, -magnitude, magnitude)
        case _:
            assert_never(sign)


def code_at(buffer: Bytes, offsets: Numbers, size: int, order: str) -> Codes:
    """The unsigned numbers of `size` bytes at some places, as in `number_at`."""
    return number_at(buffer, offsets, size, order).view(np.uint64)


def _complement_at(
    buffer: Bytes, offsets: Numbers, size: int, order: str, signed: bool, swapped: bool = False
) -> Numbers:
    """The same without a sign, or with that of two's complement."""
    if swapped:
        words = range(size - 2, -2, -2) if order == "big" else range(0, size, 2)
        number = np.zeros(len(offsets), np.int64)
        for word in words:
            number = number << 16 | _complement_at(buffer, offsets + word, 2, order, False)
        unused = 64 - 8 * size
        return (number << unused) >> unused if signed and unused else number
    if size == 1:
        single = buffer.take(offsets, mode="clip")
        return (single.view(np.int8) if signed else single).astype(np.int64)
    if size in (4, 8) and len(buffer) >= size:
        kind = f"{'<' if order == 'little' else '>'}{'i' if signed else 'u'}{size}"
        numbers_there: npt.NDArray[Any] = np.ndarray((len(buffer) - size + 1,), kind, buffer, strides=(1,))
        return numbers_there[np.clip(offsets, 0, len(buffer) - size)].astype(np.int64)  # `take` would copy all of them
    number = np.zeros(len(offsets), np.int64)
    for step in reversed(range(size)) if order == "little" else range(size):
        number = number << 8 | buffer.take(offsets + step, mode="clip")
    unused = 64 - 8 * size
    return (number << unused) >> unused if signed and unused else number


def spread(counts: Numbers) -> tuple[Numbers, Numbers]:
    """For `counts` items of each row: the row of each item, and its number within the row."""
    rows = np.repeat(np.arange(len(counts)), counts)
    starts = np.cumsum(counts) - counts
    return rows, np.arange(len(rows)) - starts[rows]


def gathered(buffer: Bytes, starts: Numbers, sizes: Numbers) -> tuple[Bytes, Numbers]:
    """The bytes of some spans one after another, and the offset of each span and of the end."""
    offsets = np.zeros(len(starts) + 1, np.int64)
    np.cumsum(sizes, out=offsets[1:])
    if len(starts) and bool((starts[1:] == starts[:-1] + sizes[:-1]).all()):
        return buffer[int(starts[0]) : int(starts[0] + offsets[-1])], offsets
    shift = np.repeat(starts - offsets[:-1], sizes)
    return buffer[shift + np.arange(len(shift))], offsets


def runs(keys: Numbers) -> list[tuple[int, Numbers]]:
    """The rows of each key, in ascending order of keys; the rows of a key keep their order."""
    if not len(keys):
        return []
    if bool((keys == keys[0]).all()):
        return [(int(keys[0]), np.arange(len(keys)))]
    order = np.argsort(keys, kind="stable")
    ordered = keys[order]
    cuts = np.flatnonzero(ordered[1:] != ordered[:-1]) + 1
    return [(int(keys[part[0]]), part) for part in np.split(order, cuts)]
