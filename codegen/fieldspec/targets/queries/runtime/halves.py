"""Expressions of Polars for floating-point numbers of two bytes, of the modules that need them."""

from __future__ import annotations

import polars as _pl


def _half(bits: _pl.Expr) -> _pl.Expr:
    exponent, fraction = bits // 1024 % 32, (bits % 1024).cast(_pl.Float64)
    step = _pl.lit(2.0).pow(_pl.max_horizontal(exponent, _pl.lit(1)).cast(_pl.Float64) - 25)
    finite = _pl.when(exponent == 0).then(fraction).otherwise(fraction + 1024) * step
    infinite = _pl.when(fraction == 0).then(_pl.lit(float("inf"))).otherwise(_pl.lit(float("nan")))
    size = _pl.when(exponent == 31).then(infinite).otherwise(finite)
    number = _pl.when(bits < 32768).then(size).otherwise(-size)
    return _pl.when(bits.is_null()).then(None).otherwise(number).cast(_pl.Float32)
