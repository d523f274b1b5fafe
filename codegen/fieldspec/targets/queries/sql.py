"""Expressions of DuckDB's SQL."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from math import lcm

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import Precision, Sign
from fieldspec.language.model.enums import Bit
from fieldspec.targets.queries.dialect import Body, DecimalScale, Dialect, Slot

_TYPES = {1: "TINYINT", 2: "SMALLINT", 4: "INTEGER", 8: "BIGINT"}
_WINDOW = 8
"""The bytes of a number from which the values in it are cut: one cast for several values."""


def name(text: str) -> str:
    """A name in double quotes, which no word of SQL is."""
    return '"' + text.replace('"', '""') + '"'


def literal(text: str) -> str:
    """A text in single quotes."""
    return "'" + text.replace("'", "''") + "'"


def decimal_text(number: Decimal) -> str:
    """A decimal number without an exponent."""
    return format(number, "f")


def type_of(size: int, signed: bool) -> str:
    """The narrowest integer type with that number of bytes."""
    return ("" if signed else "U") + _TYPES[next(width for width in _TYPES if width >= size)]


def _half(bits: str) -> str:
    """The number of half precision of 16 bits, of which DuckDB has no type.

    Its bits are put where a number of 32 bits has them, which makes it 2^112 times too small, but for infinity and NaN.
    """
    infinite = f"(({bits} & 31744) + 1024 >> 15) * 2139095040"
    single = f"(({bits} & 32768) << 16) | (({bits} & 32767) << 13) | ({infinite})"
    return f"(({single})::UINTEGER::BIT::FLOAT * {2.0**112!r}::FLOAT)"


@dataclass(frozen=True, slots=True)
class Window:
    """Neighbouring bytes, at most eight, as a number without a sign in a column."""

    column: str
    start: int
    end: int


def windows_of(cuts: Sequence[int]) -> tuple[Window, ...]:
    """The windows of a record. `cuts` are the places where values begin, and its size: windows begin and end there."""
    windows: list[Window] = []
    start, size = 0, cuts[-1] if cuts else 0
    while start < size:
        end = max((cut for cut in cuts if start < cut <= start + _WINDOW), default=min(start + _WINDOW, size))
        windows.append(Window(name(f"fieldspec_number_{start}"), start, end))
        start = end
    return tuple(windows)


@dataclass(frozen=True, slots=True)
class Sql(Dialect):
    """The dialect. Numbers of `windowed`, the bytes of a record of fixed size, are cut from the columns of windows."""

    windowed: str = ""
    windows: tuple[Window, ...] = ()

    def levels(self) -> Iterator[dict[str, str]]:
        """The columns with the fixed windows of the payload as numbers, in two levels.

        The first level has numbers of up to sixteen bytes, each with two neighbouring windows. The second level takes
        the two windows of each apart. A level without columns is left out.
        """
        wide: dict[str, str] = {}
        narrow: dict[str, str] = {}
        for first, *following in (self.windows[index : index + 2] for index in range(0, len(self.windows), 2)):
            source = f"{self.windowed}[{first.start + 1}:{(following or [first])[-1].end}]::BIT"
            if not following:
                wide[first.column] = f"{source}::UBIGINT"
                continue
            own, rest = name(f"fieldspec_wide_{first.start}"), 8 * (following[0].end - following[0].start)
            wide[own] = f"{source}::UHUGEINT"
            narrow[first.column] = f"({own} >> {rest})::UBIGINT"
            narrow[following[0].column] = f"({own} & {(1 << rest) - 1})::UBIGINT"
        yield from filter(None, (wide, narrow))

    def whole(self, data: str, slot: Slot) -> str:
        match slot.sign:
            case Sign.NONE | Sign.COMPLEMENT:
                return self._of_complement(data, slot, slot.sign.is_signed)
            case Sign.MAGNITUDE:
                number, highest = self._of_complement(data, slot, False), 8 * slot.size - 1
                size = f"({number} & {(1 << highest) - 1})::BIGINT"
                return f"({size} * (1 - 2 * ({number} >> {highest})::BIGINT))::{type_of(slot.size, True)}"
            case _:
                assert_never(slot.sign)

    def _of_complement(self, data: str, slot: Slot, signed: bool) -> str:
        """A whole number without a sign, or with that of two's complement."""
        kind = type_of(slot.size, signed)
        if data != self.windowed and len(slot.runs) == 1 and slot.size in _TYPES:
            return f"{self.piece(data, slot.offset, slot.size)}::BIT::{kind}"
        number = self._unsigned(data, slot)
        if not signed:
            return f"{number}::{kind}"
        if slot.size == _WINDOW:
            return f"{number}::UBIGINT::BIT::BIGINT"
        half = 1 << (8 * slot.size - 1)
        return f"(xor({number}::BIGINT, {half}) - {half})::{kind}"

    def _unsigned(self, data: str, slot: Slot) -> str:
        terms, left = [], 8 * slot.size
        for start, size in slot.runs:
            left -= 8 * size
            term = self._run(data, start, size)
            terms.append(f"({term}::UBIGINT << {left})" if left else term)
        return terms[0] if len(terms) == 1 else f"({' | '.join(f'{term}::UBIGINT' for term in terms)})"

    def _run(self, data: str, start: int, size: int) -> str:
        """Neighbouring bytes as a number without a sign."""
        containing = (own for own in self.windows if own.start <= start and start + size <= own.end)
        window = next(containing, None) if data == self.windowed else None
        if window is None:
            kind = type_of(size, False) if size in _TYPES else "UBIGINT"
            return f"{self.piece(data, start, size)}::BIT::{kind}"
        shift = 8 * (window.end - start - size)
        shifted = f"({window.column} >> {shift})" if shift else window.column
        return shifted if start == window.start else f"({shifted} & {(1 << 8 * size) - 1})"

    def real(self, data: str, slot: Slot, precision: Precision) -> str:
        match precision:
            case Precision.HALF:
                return _half(f"{self._of_complement(data, slot, False)}::BIGINT")
            case Precision.SINGLE:
                return self._of_bits(data, slot, "FLOAT")
            case Precision.DOUBLE:
                return self._of_bits(data, slot, "DOUBLE")
            case _:
                assert_never(precision)

    def _of_bits(self, data: str, slot: Slot, kind: str) -> str:
        """A floating-point number of a type of DuckDB."""
        if len(slot.runs) == 1:
            return f"{self.piece(data, slot.offset, slot.size)}::BIT::{kind}"
        return f"{self._unsigned(data, slot)}::{type_of(slot.size, False)}::BIT::{kind}"

    def bits(self, word: str, bit: Bit) -> str:
        parts = [(f"(({word} >> {run.first}) & {run.most})", run.weight) for run in bit.runs]
        texts = [f"({part} << {weight})" if weight else part for part, weight in parts]
        number = texts[0] if len(texts) == 1 else f"({' | '.join(texts)})"
        width, size = bit.width, (bit.width + 7) // 8
        if not bit.signed:
            return f"{number}::{type_of(size, False)}"
        if width == 64:
            return f"{number}::UBIGINT::BIT::BIGINT"
        half = 1 << (width - 1)
        return f"(xor({number}::BIGINT, {half}) - {half})::{type_of(size, True)}"

    def mask(self, word: str, mask: int) -> str:
        return f"({word} & {mask}) <> 0"

    def piece(self, data: str, offset: int, size: int) -> str:
        return f"{data}[{offset + 1}:{offset + size}]"

    def text(self, data: str) -> str:
        return f"CASE WHEN regexp_full_match(hex({data}), '([0-7].)*') THEN rtrim(decode({data}), chr(0)) END"

    def not_ascii(self, data: str) -> str:
        return f"NOT regexp_full_match(hex({data}), '([0-7].)*')"

    def truth(self, number: str) -> str:
        return f"CASE {number} WHEN 0 THEN false WHEN 1 THEN true END"

    def member(self, number: str, enum: str) -> str:
        return f"{enum}({number})"

    def cases(
        self,
        number: str,
        names: Mapping[tuple[int, int], str],
        nan: str = "",
        other: tuple[str, str] | None = None,
    ) -> str:
        rows = [
            f"WHEN {number} {f'= {low}' if low == high else f'BETWEEN {low} AND {high}'} THEN {literal(text)}"
            for (low, high), text in names.items()
        ]
        if nan:
            rows.insert(0, f"WHEN isnan({number}) THEN {literal(nan)}")
        if other is not None:
            rows.append(f"WHEN {other[0]} THEN {literal(other[1])}")
        return f"CASE {' '.join(rows)} END"

    def absent(self, value: str, number: str, intervals: Sequence[tuple[int, int]], nan: bool = False) -> str:
        tests = [f"isnan({number})"] if nan else []
        if intervals:
            tests.append(self.is_in(number, intervals).removeprefix("(").removesuffix(")"))
        return f"CASE WHEN NOT ({' OR '.join(tests)}) THEN {value} END"

    def decimal(self, number: str, scale: DecimalScale) -> str:
        # DuckDB multiplies decimals of at most 18 digits in 64 bits, also where the product has more.
        factors = scale.digits + len(scale.scale.as_tuple().digits)
        digits = scale.digits if max(factors, scale.precision) <= 18 else max(scale.digits, 19)
        result = f"{number}::DECIMAL({digits}, 0)"
        if scale.scale != 1:
            result = f"{result} * {decimal_text(scale.scale)}"
        if scale.offset:
            result = f"{result} + ({decimal_text(scale.offset)})"
        return f"({result})::DECIMAL({max(scale.precision, 1)}, {scale.places})"

    def ratio(self, number: str, scale: Fraction, offset: Fraction) -> str:
        below = lcm(scale.denominator, offset.denominator)
        above = f"{number}::DOUBLE * {float(int(scale * below))!r}"
        if offset:
            above = f"({above} + ({float(int(offset * below))!r}))"
        return f"({above} / {float(below)!r})"

    def power(self, number: str, exponent: str, intervals: Sequence[tuple[int, int]]) -> str:
        above, below = f"greatest({exponent}::DOUBLE, 0)", f"greatest(-{exponent}::DOUBLE, 0)"
        quantity = f"{number}::DOUBLE * pow(10, {above}) / pow(10, {below})"
        return f"CASE WHEN {self.is_in(exponent, intervals)} THEN {quantity} END"

    def is_in(self, number: str, intervals: Sequence[tuple[float, float]], floating: bool = False) -> str:
        own = f"{number}::DOUBLE" if floating else number
        tests = [f"{own} BETWEEN {low} AND {high}" for low, high in intervals if low != high]
        single = [str(low) for low, high in intervals if low == high]
        if single:
            tests.append(f"{own} IN ({', '.join(single)})")
        return f"({' OR '.join(tests)})" if tests else "false"

    def is_nan(self, number: str) -> str:
        return f"isnan({number})"

    def size(self, data: str) -> str:
        return f"octet_length({data})"

    def compared(self, left: str, operator: str, right: str) -> str:
        return f"{left} {operator} {right}"

    def both(self, *conditions: str) -> str:
        return f"({' AND '.join(conditions)})"

    def either(self, *conditions: str) -> str:
        return f"({' OR '.join(conditions)})"

    def negated(self, condition: str) -> str:
        return f"NOT {condition}"

    def each(self, data: str, offset: int, size: int, count: int | None, body: Body) -> str:
        number = self.units(data, offset, size) if count is None else str(count)
        element = f"{data}[{offset + 1} + {size} * i : {offset + size} + {size} * i]"
        elements = f"list_transform(range({number}), lambda i: {body(element)})"
        return f"CASE WHEN {data} IS NOT NULL THEN {elements} END"

    def some(self, data: str, offset: int, size: int, count: int | None, body: Body) -> str:
        return f"list_bool_or({self.each(data, offset, size, count, body)})"

    def sized(self, data: str, minimum: int, maximum: int | None, offset: int, unit: int) -> str:
        size = self.size(data)
        tests = [f"{size} = {minimum}" if minimum == maximum else f"{size} >= {minimum}"]
        if maximum is not None and maximum != minimum:
            tests.append(f"{size} <= {maximum}")
        if unit > 1:
            tests.append(f"({size} - {offset}) % {unit} = 0")
        return self.chosen(data, " AND ".join(tests))

    def chosen(self, data: str, condition: str) -> str:
        return f"CASE WHEN {condition} THEN {data} END"

    def first(self, *values: str) -> str:
        return f"coalesce({', '.join(values)})"

    def first_of(self, data: str, offset: int, size: int, count: int | None, body: Body) -> str:
        return f"list_filter({self.each(data, offset, size, count, body)}, lambda own: own IS NOT NULL)[1]"

    def reason(self, refusals: Sequence[tuple[str, str]]) -> str:
        rows = [f"WHEN {condition} THEN {literal(reason)}" for condition, reason in refusals]
        return f"CASE {' '.join(rows)} END"

    def words(self, address: str, size: int, unit: int = 2) -> str:
        offset = f"{unit} * ({address} - start::BIGINT)"
        condition = f"{address} >= start::BIGINT AND {offset} + {size} <= octet_length(payload)"
        return f"CASE WHEN {condition} THEN payload[{offset} + 1 : {offset} + {size}] END"

    def single_bit(self, address: int) -> str:
        offset = f"({address} - start::BIGINT)"
        condition = f"{offset} >= 0 AND {offset} // 8 < octet_length(payload)"
        byte = f"payload[{offset} // 8 + 1 : {offset} // 8 + 1]::BIT::UTINYINT"
        return f"CASE WHEN {condition} THEN ({byte} >> ({offset} % 8)::UTINYINT) & 1 = 1 END"

    def argument(self, name: str) -> str:
        return f"{name}::BIGINT"

    def step(self, name: str) -> str:
        return f'"fieldspec_{name}"'

    def as_text(self, value: str) -> str:
        return f"({value})::VARCHAR"
