"""Expressions of Polars for whole numbers whose highest bit is the sign, of the modules that need them."""

from __future__ import annotations

import polars as _pl


def _magnitude(bits: _pl.Expr, width: int, kind: type[_pl.DataType]) -> _pl.Expr:
    highest = _pl.lit(1 << (width - 1), dtype=_pl.UInt64)
    whole = bits.cast(_pl.UInt64)
    size = (whole % highest).cast(_pl.Int64)
    return _pl.when(whole < highest).then(size).otherwise(-size).cast(kind)
