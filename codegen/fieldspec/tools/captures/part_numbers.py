"""The numbers of parts and of fields of many frames at once, and the words that are sent as hexadecimal digits."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from fieldspec.codec.explain.values import number_of as number_of_bytes
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import FieldLayout
from fieldspec.codec.layout.word_digits import has_word_digits
from fieldspec.language.model.digits import digits_letters
from fieldspec.language.model.encoding import sign_of
from fieldspec.language.model.value import Value
from fieldspec.tools.captures.columns import Bytes, Codes, Mask, Numbers, code_at, gathered, number_at


def part_numbers(part: PartLayout, buffer: Bytes, offsets: Numbers) -> Numbers:
    """The numbers of a part at some places, modulo 2^64; any where the bytes are not its digits."""
    assert part.value is not None
    if part.width:
        whole = code_at(buffer, offsets, part.size, part.order)
        own: Codes = whole >> np.uint64(part.shift) & np.uint64((1 << part.width) - 1)
        return own.view(np.int64)
    if not part.form:
        return number_at(buffer, offsets, part.size, part.order, sign_of(part.value.encoding))
    return _number(part.value, part.size, buffer, offsets)


def own_bytes(part: PartLayout, buffer: Bytes, offsets: Numbers) -> tuple[Bytes, Numbers]:
    """A buffer with the bytes of a part alone, also if it shares them with other parts, and where they are in it."""
    if not part.width:
        return buffer, offsets
    is_little = part.order == "little"
    wide = part_numbers(part, buffer, offsets).astype("<u8" if is_little else ">u8").view(np.uint8).reshape(-1, 8)
    table = wide[:, : part.size] if is_little else wide[:, 8 - part.size :]
    return np.append(table, np.uint8(0)), np.arange(len(offsets)) * part.size


def field_numbers(field: FieldLayout, buffer: Bytes, offsets: Numbers) -> Numbers:
    """The numbers of a field without a sign in records that begin at some places, modulo 2^64.

    They are any numbers where the bytes are not its digits.
    """
    value, offsets = field.value, offsets + field.offset
    if value is None or not value.digits:
        return number_at(buffer, offsets, field.size, field.order, swapped=field.swapped)
    if value.has_characters and not value.has_blanks:
        return _number(value, field.size, buffer, offsets)
    table = buffer.take(offsets[:, None] + np.arange(field.size), mode="clip")
    distinct, index = np.unique(table, axis=0, return_inverse=True)
    numbers = (number_of_bytes(value, row.tobytes(), field.order, field.swapped) for row in distinct)
    raw = np.array([number if isinstance(number, int) else 0 for number in numbers], np.uint64)
    return raw.view(np.int64)[index.reshape(-1)]


def with_word_bytes(
    fields: Mapping[int, FieldLayout], messages: Numbers, buffer: Bytes, starts: Numbers, sizes: Numbers
) -> Bytes:
    """A buffer that also has the bytes of words that some frames carry as hexadecimal digits.

    `fields` have the words, by message. `starts` and `sizes` of the data of these frames then concern the bytes.
    """
    for message, field in fields.items():
        rows = np.flatnonzero(messages == message)
        if has_word_digits(field) and len(rows):
            words, own_starts, own_sizes = _word_buffer(field, buffer, starts[rows], sizes[rows])
            starts[rows], sizes[rows] = len(buffer) + own_starts, own_sizes
            buffer = np.concatenate([buffer, words])
    return buffer


def _word_buffer(field: FieldLayout, buffer: Bytes, starts: Numbers, sizes: Numbers) -> tuple[Bytes, Numbers, Numbers]:
    """The bytes of words that are sent as hexadecimal digits; where the bytes of each frame begin, and their number.

    Words count up to the first one with other characters.
    """
    assert field.value is not None
    characters, offsets = gathered(buffer, starts, sizes // field.size * field.size)
    digits = _table(field.value)[characters]
    wrong = np.flatnonzero(digits < 0)
    ends = offsets[1:].copy()
    rows = np.searchsorted(offsets, wrong, "right") - 1
    np.minimum.at(ends, rows, offsets[rows] + (wrong - offsets[rows]) // field.size * field.size)
    pairs = np.maximum(digits, 0)
    return (pairs[::2] << 4 | pairs[1::2]).astype(np.uint8), offsets[:-1] // 2, (ends - offsets[:-1]) // 2


def lacks_digits(part: PartLayout, buffer: Bytes, offsets: Numbers) -> Mask:
    """Whether the bytes of a part at some places are not its digits."""
    assert part.value is not None
    lacking = np.zeros(len(offsets), np.bool_)
    for digits in _digits(part.value, part.size, buffer, offsets):
        lacking |= digits < 0
    return lacking


def _number(value: Value, size: int, buffer: Bytes, offsets: Numbers) -> Numbers:
    base = len(digits_letters(value))
    number = np.zeros(len(offsets), np.int64)
    for digits in _digits(value, size, buffer, offsets):
        number = number * base + np.maximum(digits, 0)
    return number


def _digits(value: Value, size: int, buffer: Bytes, offsets: Numbers) -> list[Numbers]:
    """Each digit of a value at some places, the most significant first, -1 for another character."""
    table = _table(value)
    steps = list(range(size))
    if value.is_low_first:
        steps = [step for pair in range(size - 2, -1, -2) for step in (pair, pair + 1)]
    return [table[buffer.take(offsets + step, mode="clip")] for step in steps]


def _table(value: Value) -> Numbers:
    """The digit of each character, -1 for others."""
    table = np.full(256, -1, np.int64)
    for digit, letter in enumerate(digits_letters(value)):
        table[letter] = digit
    return table
