"""Columns of halves, and of whole numbers with sign and magnitude, have the numbers that `struct` and counting give."""

from __future__ import annotations

import numpy as np
import pytest

from fieldspec.language.model.encoding import Precision, Sign
from fieldspec.tools.captures.columns import number_at
from fieldspec.tools.captures.decoders import reals_of
from number_bits import HALVES, magnitude

PATTERNS = ("0000000000000000", "8000000000000000", "8182838485868788", "0102030405060708", "FFFFFFFFFFFFFFFF")


def test_all_halves_have_the_numbers_of_struct() -> None:
    numbers = reals_of(Precision.HALF, np.arange(1 << 16, dtype=np.int64))
    assert list(map(repr, numbers.tolist())) == list(map(repr, HALVES))


@pytest.mark.parametrize("size", range(1, 9))
def test_the_highest_bit_is_the_sign_in_every_width_and_order(size: int) -> None:
    data = [bytes.fromhex(pattern)[:size] for pattern in PATTERNS]
    for order, step in (("big", 1), ("little", -1)):
        buffer = np.frombuffer(b"".join(own[::step] for own in data), np.uint8)
        numbers = number_at(buffer, np.arange(len(data)) * size, size, order, Sign.MAGNITUDE)
        assert numbers.tolist() == [magnitude(own) for own in data]
