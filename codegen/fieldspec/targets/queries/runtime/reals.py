"""Expressions of Polars for powers of ten, and for bounds with a fraction, of the modules that need them."""

from __future__ import annotations

import polars as _pl


def _power(number: _pl.Expr, exponent: _pl.Expr, intervals: list[tuple[float, float]]) -> _pl.Expr:
    places = exponent.cast(_pl.Float64)
    above, below = _pl.max_horizontal(places, _pl.lit(0.0)), _pl.max_horizontal(-places, _pl.lit(0.0))
    quantity = number.cast(_pl.Float64) * _pl.lit(10.0).pow(above) / _pl.lit(10.0).pow(below)
    return _pl.when(_is_within(places, intervals)).then(quantity)


def _is_within(number: _pl.Expr, intervals: list[tuple[float, float]]) -> _pl.Expr:
    return _pl.any_horizontal([(number >= _pl.lit(float(a))) & (number <= _pl.lit(float(b))) for a, b in intervals])
