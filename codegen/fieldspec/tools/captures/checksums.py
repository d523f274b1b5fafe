"""The checksums of many spans of bytes at once."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from fieldspec.codec.layout.checksums import checksum_bytes
from fieldspec.codec.layout.part import PartLayout
from fieldspec.foundation.runtime._checksums import Crc, reflected
from fieldspec.language.model.checksums import Checksum, checksum_named
from fieldspec.tools.captures.columns import Bytes, Mask, Numbers, number_at


def are_right(part: PartLayout, buffer: Bytes, offsets: Numbers, length: Numbers) -> Mask:
    """Whether frames, whose parts have `length` bytes from `offsets` on, carry the checksum that they should."""
    start = offsets + part.start if part.start >= 0 else offsets + length + part.start
    stop = length if part.stop is None else part.stop if part.stop >= 0 else length + part.stop
    sizes = np.maximum(offsets + stop - start, 0)
    place = offsets + part.offset if part.offset >= 0 else offsets + length + part.offset
    kind = checksum_named(part.algorithm)
    if kind.codec or part.digits or kind.suffix or kind.avoided or kind.method == "fletcher" or kind.unit_size != 1:
        return _each(part, buffer, start, sizes, place)
    computed = _crc(kind, buffer, start, sizes) if kind.method == "crc" else _total(kind, buffer, start, sizes)
    return np.asarray(number_at(buffer, place, part.size, part.order).view(np.uint64) == computed)


def _each(part: PartLayout, buffer: Bytes, start: Numbers, sizes: Numbers, place: Numbers) -> Mask:
    """Whether frames carry the right checksum, computed frame by frame, for checksums that are rare."""
    data = buffer.tobytes()
    spans = zip(start.tolist(), sizes.tolist(), place.tolist(), strict=True)
    return np.array(
        [
            checksum_bytes(part.algorithm, part.digits, part.order, part.size, data[first : first + size])
            == data[own : own + part.size]
            for first, size, own in spans
        ],
        np.bool_,
    )


def _total(kind: Checksum, buffer: Bytes, start: Numbers, sizes: Numbers) -> npt.NDArray[np.uint64]:
    """The sum, or the exclusive or, of the bytes of each span."""
    number = np.full(len(start), kind.initial, np.uint64)
    for rows, column in _columns(buffer, start, sizes):
        if kind.method == "sum":
            number[rows] += column
        else:
            number[rows] ^= column.astype(np.uint64)
    if kind.complement:
        number = ~number + np.uint64(kind.complement == "twos")
    return np.asarray(number & np.uint64(kind.mask))


def _crc(kind: Checksum, buffer: Bytes, start: Numbers, sizes: Numbers) -> npt.NDArray[np.uint64]:
    """The CRC of each span; the register of one that is not reflected begins at its highest bit."""
    function = kind.function("big")
    assert isinstance(function, Crc)
    table = np.array(function.table, np.uint64)
    register = np.full(len(start), function.register, np.uint64)
    eight = np.uint64(8)
    for rows, column in _columns(buffer, start, sizes):
        own = register[rows]
        if kind.reflect_in:
            register[rows] = own >> eight ^ table[(own & np.uint64(0xFF)).astype(np.uint8) ^ column]
        else:
            register[rows] = own << eight ^ table[(own >> np.uint64(56)).astype(np.uint8) ^ column]
    if not kind.reflect_in:
        register >>= np.uint64(64 - kind.width)
    if kind.reflect_in != kind.reflect_out:
        ordered, places = np.unique(register, return_inverse=True)
        opposite = np.array([reflected(int(number), kind.width) for number in ordered], np.uint64)
        register = opposite[places]
    return np.asarray(register ^ np.uint64(kind.final_xor))


def _columns(buffer: Bytes, start: Numbers, sizes: Numbers) -> list[tuple[Numbers | slice, Bytes]]:
    """The first byte of all spans, the second one of those that have one, and so on."""
    if not len(start):
        return []
    order = np.argsort(-sizes, kind="stable")
    starts, lengths = start[order], sizes[order]
    columns: list[tuple[Numbers | slice, Bytes]] = []
    live = len(order)
    ordered = -lengths
    for step in range(int(lengths[0])):
        live = int(np.searchsorted(ordered[:live], -step, "left"))
        columns.append((order[:live], buffer[starts[:live] + step]))
    return columns
