"""Expressions of Polars for fields of bits that lie apart, of the modules that need them."""

from __future__ import annotations

from collections.abc import Sequence

import polars as _pl


def _bits_apart(word: _pl.Expr, runs: Sequence[tuple[int, int, int]]) -> _pl.Expr:
    number = _pl.lit(0, dtype=_pl.UInt64)
    for first, width, weight in runs:
        number = number + word.cast(_pl.UInt64) // (1 << first) % (1 << width) * (1 << weight)
    return number
