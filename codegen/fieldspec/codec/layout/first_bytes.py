"""The bytes that the frames of a link may begin with."""

from __future__ import annotations

from collections.abc import Iterable

from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.part import PartLayout

_DIGITS = {
    "decimal": b"+-.0123456789",
    "upper_hex": b"0123456789ABCDEFabcdef",
    "lower_hex": b"0123456789ABCDEFabcdef",
}


def first_bytes(link: LinkLayout, direction: str) -> dict[int, bytes]:
    """The possible values of bytes before the body, by their offset after the start delimiter.

    Bytes that may have any value are not among them.
    """
    frame = link.frame(direction)
    known: dict[int, bytes] = {}
    for part in frame.header:
        for place, values in enumerate(_values(link, frame, part)):
            if len(values) < 256:
                known[part.offset + place] = values
    return known


def _values(link: LinkLayout, frame: FrameLayout, part: PartLayout) -> list[bytes]:
    """The possible values of each byte of a part; empty where it may have any number."""
    if part.form:
        return [_DIGITS[part.form]] * part.size if part.form in _DIGITS and not part.reserved else []
    if part.reserved or part.width:
        return []
    if part.constant is not None:
        return _each_byte([part.data(part.constant)])
    if part.role == "unit_address" and part.size == 1:
        return _addresses(link, frame)
    if part.role == "code":
        return _each_byte(part.data(code) for code in _codes(link, frame, part))
    return []


def _addresses(link: LinkLayout, frame: FrameLayout) -> list[bytes]:
    """The unit addresses that the first byte of a frame may be."""
    known = link.link.unit_addresses
    if known is None or known.ranges is None:
        return []
    numbers = {number for low, high in known.ranges.intervals for number in range(low, high + 1)}
    if frame.direction == "request" and known.broadcast is not None:
        numbers.add(known.broadcast)
    return [bytes(sorted(numbers))]


def _codes(link: LinkLayout, frame: FrameLayout, part: PartLayout) -> list[int]:
    """The codes of frames; all numbers of a part of several bytes in which a flag marks exception responses."""
    error = link.link.exception_response if frame.direction == "response" else None
    codes = link.codes(frame.direction)
    if error is None:
        return codes
    if error.flag:
        return [*codes, *(number for number in range(256) if number & error.flag)] if part.size == 1 else []
    return codes if error.code is None else [*codes, error.code]


def _each_byte(numbers: Iterable[bytes]) -> list[bytes]:
    return [bytes(sorted(set(column))) for column in zip(*numbers, strict=True)]
