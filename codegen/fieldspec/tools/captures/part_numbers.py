"""The numbers of parts of many frames at once."""

from __future__ import annotations

import numpy as np

from fieldspec.codec.layout.part import PartLayout
from fieldspec.language.model.digits import digits_letters
from fieldspec.language.model.encoding import sign_of
from fieldspec.tools.captures.columns import Bytes, Mask, Numbers, number_at


def part_numbers(part: PartLayout, buffer: Bytes, offsets: Numbers) -> Numbers:
    """The numbers of a part at some places, modulo 2^64; any where the bytes are not its digits."""
    assert part.value is not None
    if not part.form:
        return number_at(buffer, offsets, part.size, part.order, sign_of(part.value.encoding))
    letters = digits_letters(part.value)
    number = np.zeros(len(offsets), np.int64)
    for digits in _digits(part, buffer, offsets):
        number = number * len(letters) + np.maximum(digits, 0)
    return number


def lacks_digits(part: PartLayout, buffer: Bytes, offsets: Numbers) -> Mask:
    """Whether the bytes of a part at some places are not its digits."""
    lacking = np.zeros(len(offsets), np.bool_)
    for digits in _digits(part, buffer, offsets):
        lacking |= digits < 0
    return lacking


def _digits(part: PartLayout, buffer: Bytes, offsets: Numbers) -> list[Numbers]:
    """Each digit of a part at some places, -1 for another character."""
    assert part.value is not None
    table = np.full(256, -1, np.int64)
    for digit, letter in enumerate(digits_letters(part.value)):
        table[letter] = digit
    return [table[buffer.take(offsets + step, mode="clip")] for step in range(part.size)]
