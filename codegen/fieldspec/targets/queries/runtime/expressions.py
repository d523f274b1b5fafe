"""Expressions of Polars that the modules of all devices use; each module has them in itself."""

from __future__ import annotations

from decimal import Decimal as _Number
from typing import Literal as _Literal
from typing import TypeAlias as _TypeAlias

import polars as _pl

_Order: _TypeAlias = "_Literal['big', 'little']"
_BIG = True
_WHOLE = {
    1: (_pl.UInt8, _pl.Int8),
    2: (_pl.UInt16, _pl.Int16),
    4: (_pl.UInt32, _pl.Int32),
    8: (_pl.UInt64, _pl.Int64),
}
_REALS = {4: _pl.Float32, 8: _pl.Float64}


def _whole(data: _pl.Expr, offset: int, size: int, order: _Order, swapped: bool, signed: bool) -> _pl.Expr:
    if not swapped and size in _WHOLE:
        kind = _WHOLE[size][signed]
        return _piece(data, offset, size).bin.reinterpret(dtype=kind, endianness=order)
    places = list(range(offset, offset + size))
    if order != "big":
        places.reverse()
    if swapped:
        places = [place for first in range(size - 2, -1, -2) for place in places[first : first + 2]]
    number = _pl.lit(0, dtype=_pl.UInt64)
    for place in places:
        number = number * 256 + _piece(data, place, 1).bin.reinterpret(dtype=_pl.UInt8).cast(_pl.UInt64)
    return _narrowed(number, 8 * size, signed)


def _narrowed(number: _pl.Expr, width: int, signed: bool) -> _pl.Expr:
    kind = _WHOLE[next(size for size in _WHOLE if 8 * size >= width)][signed]
    if not signed:
        return number.cast(kind)
    if width == 64:
        return number.reinterpret(signed=True)
    whole = number.cast(_pl.Int64)
    return _pl.when(whole >= 1 << (width - 1)).then(whole - (1 << width)).otherwise(whole).cast(kind)


def _real(data: _pl.Expr, offset: int, size: int, order: _Order, swapped: bool) -> _pl.Expr:
    kind = _REALS[size]
    if not swapped:
        return _piece(data, offset, size).bin.reinterpret(dtype=kind, endianness=order)
    # The words are turned around: put in order, they are a number with one order of bytes.
    pieces = [_piece(data, offset + first, 2).bin.encode("hex") for first in range(size - 2, -1, -2)]
    return _pl.concat_str(pieces).str.decode("hex").bin.reinterpret(dtype=kind, endianness=order)


def _bits(word: _pl.Expr, first: int, width: int, signed: bool) -> _pl.Expr:
    number = word.cast(_pl.UInt64) // (1 << first)
    return _narrowed(number % (1 << width) if width < 64 else number, width, signed)


def _any_bit(word: _pl.Expr, mask: int) -> _pl.Expr:
    return (word & mask) != 0 if mask < 1 << 31 else (word.cast(_pl.UInt64) & _pl.lit(mask, dtype=_pl.UInt64)) != 0


def _piece(data: _pl.Expr, offset: int, size: int) -> _pl.Expr:
    return data.bin.slice(offset, size)


def _size(data: _pl.Expr) -> _pl.Expr:
    return data.bin.size().cast(_pl.Int64)


def _is_ascii(data: _pl.Expr) -> _pl.Expr:
    return data.bin.encode("hex").str.contains("^([0-7].)*$")


def _text(data: _pl.Expr) -> _pl.Expr:
    # A cast looks at the bytes after a null too.
    text = _pl.when(_is_ascii(data)).then(data).otherwise(_pl.lit(b"")).cast(_pl.String).str.strip_chars_end("\0")
    return _pl.when(_is_ascii(data)).then(text).otherwise(None)


def _truth(number: _pl.Expr) -> _pl.Expr:
    return _pl.when(number <= 1).then(number == 1).otherwise(None)


def _names(number: _pl.Expr, names: dict[int, str]) -> _pl.Expr:
    known = _pl.Series(list(names), dtype=_pl.Int128)
    return number.cast(_pl.Int128).replace_strict(known, list(names.values()), default=None, return_dtype=_pl.String)


def _states(
    number: _pl.Expr, names: dict[tuple[int, int], str], nan: str, condition: _pl.Expr | None = None, other: str = ""
) -> _pl.Expr:
    state = _pl.lit(None, dtype=_pl.String)
    if condition is not None:
        state = _pl.when(condition).then(_pl.lit(other)).otherwise(state)
    for interval, name in names.items():
        state = _pl.when(_is_in(number, [interval])).then(_pl.lit(name)).otherwise(state)
    return _pl.when(number.is_nan()).then(_pl.lit(nan)).otherwise(state) if nan else state


def _absent(value: _pl.Expr, number: _pl.Expr, intervals: list[tuple[int, int]], nan: bool) -> _pl.Expr:
    absent = _is_in(number, intervals)
    if nan:
        absent = absent | number.is_nan()
    return _pl.when(absent).then(None).otherwise(value)


def _decimal(number: _pl.Expr, scale: str, offset: str, places: int) -> _pl.Expr:
    kind = _pl.Decimal(38, places)
    quantity = number.cast(_pl.Decimal(38, 0)) * _pl.lit(_Number(scale), dtype=kind)
    return quantity + _pl.lit(_Number(offset), dtype=kind) if _Number(offset) else quantity


def _ratio(number: _pl.Expr, factor: float, shift: float, divisor: float) -> _pl.Expr:
    return (number.cast(_pl.Float64) * factor + shift) / divisor


def _is_in(number: _pl.Expr, intervals: list[tuple[int, int]]) -> _pl.Expr:
    tests = [_pl.lit(False)]
    for low, high in intervals:
        minimum, maximum = _pl.lit(low, dtype=_pl.Int128), _pl.lit(high, dtype=_pl.Int128)
        tests.append(number == maximum if low == high else (number >= minimum) & (number <= maximum))
    return _pl.any_horizontal(tests[1:] or tests)


def _each(data: _pl.Expr, offset: int, size: int, count: int | None, body: _pl.Expr) -> _pl.Expr:
    length = (_size(data) - offset) // size * size if count is None else _pl.lit(count * size)
    pieces = data.bin.slice(offset, length).cast(_pl.List(_pl.UInt8))
    elements = pieces.list.eval(_pl.element().reshape((-1, size)).arr.to_list().cast(_pl.Binary))
    return elements.list.eval(body)


def _sized(data: _pl.Expr, minimum: int, maximum: int | None, offset: int, unit: int) -> _pl.Expr:
    fits = _size(data) >= minimum
    if maximum is not None:
        fits = fits & (_size(data) <= maximum)
    if unit > 1:
        fits = fits & ((_size(data) - offset) % unit == 0)
    return _pl.when(fits).then(data).otherwise(None)


def _words(payload: _pl.Expr, start: _pl.Expr, address: _pl.Expr | int, size: int, unit: int = 2) -> _pl.Expr:
    offset = (0 - start.cast(_pl.Int64) + address) * unit
    is_inside = (offset >= 0) & (offset + size <= _size(payload))
    return payload.bin.slice(_pl.when(is_inside).then(offset).otherwise(None), size)


def _single_bit(payload: _pl.Expr, start: _pl.Expr, address: int) -> _pl.Expr:
    offset = address - start.cast(_pl.Int64)
    is_inside = (offset >= 0) & (offset // 8 < _size(payload))
    byte = payload.bin.slice(_pl.when(is_inside).then(offset // 8).otherwise(None), 1).bin.reinterpret(dtype=_pl.UInt8)
    masks = (offset % 8).replace_strict(list(range(8)), [1 << bit for bit in range(8)], return_dtype=_pl.UInt8)
    return (byte & masks) != 0


def _reason(rows: list[tuple[_pl.Expr, str]]) -> _pl.Expr:
    reason = _pl.lit(None, dtype=_pl.String)
    for condition, text in reversed(rows):
        reason = _pl.when(condition).then(_pl.lit(text)).otherwise(reason)
    return reason


def _findings(rows: list[tuple[_pl.Expr, str, str, _pl.Expr | None]]) -> _pl.Expr:
    kind = _pl.Struct({"field": _pl.String, "reason": _pl.String, "raw": _pl.String})
    none = _pl.lit(None, dtype=_pl.List(kind))
    results = []
    for condition, field, reason, raw in rows:
        number = _pl.lit(None, dtype=_pl.String) if raw is None else raw
        finding = _pl.struct(field=_pl.lit(field), reason=_pl.lit(reason), raw=number).cast(kind)
        results.append(_pl.when(condition).then(finding).otherwise(None))
    return _pl.concat_list(results).list.drop_nulls() if results else none


def _named(columns: dict[str, _pl.Expr]) -> list[_pl.Expr]:
    return [column.alias(name) for name, column in columns.items()]


def _column(column: _pl.Expr | str) -> _pl.Expr:
    return _pl.col(column) if isinstance(column, str) else column


def payload_of(words: _pl.Expr | str) -> _pl.Expr:
    """The bytes of a column with lists of 16-bit words."""
    word = _pl.element()
    halves = [(word // 256).cast(_pl.UInt8), (word % 256).cast(_pl.UInt8)]
    numbers = _column(words).cast(_pl.List(_pl.UInt16))
    return numbers.list.eval(_pl.concat_list(halves if _BIG else halves[::-1]).explode()).cast(_pl.Binary)
