"""Expressions of Polars, as Python."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import lcm

from fieldspec.foundation.classes import dataclass, field
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import MACHINE_BITS, Precision, Sign
from fieldspec.language.model.enums import Bit
from fieldspec.targets.queries.dialect import Body, DecimalScale, Dialect, Slot

ELEMENT = "_pl.element()"

_OPERATORS = {"=": "==", "<>": "!=", "<": "<", ">": ">"}


@dataclass(frozen=True, slots=True)
class Polars(Dialect):
    """The dialect. `variables` has the expressions that a function computes once, by the names of local variables."""

    variables: dict[str, str] = field(default_factory=dict)
    _names: dict[str, str] = field(default_factory=dict)
    """The names of local variables by their expressions."""

    def bind(self, expression: str, prefix: str = "number") -> str:
        """The local variable of an expression."""
        if expression not in self._names:
            name = f"{prefix}_{len(self.variables)}"
            self._names[expression] = name
            self.variables[name] = expression
        return self._names[expression]

    def whole(self, data: str, slot: Slot) -> str:
        place = f"{{}}, {slot.offset}, {slot.size}, {_order(slot)}"
        match slot.sign:
            case Sign.NONE:
                return self._bound_number(data, f"_whole({place}, False)")
            case Sign.COMPLEMENT:
                return self._bound_number(data, f"_whole({place}, True)")
            case Sign.MAGNITUDE:
                width = 8 * slot.size
                kind = f"_pl.Int{next(bits for bits in MACHINE_BITS if bits >= width)}"
                return self._bound_number(data, f"_magnitude(_whole({place}, False), {width}, {kind})")
            case _:
                assert_never(slot.sign)

    def real(self, data: str, slot: Slot, precision: Precision) -> str:
        place = f"{{}}, {slot.offset}, {slot.size}, {_order(slot)}"
        match precision:
            case Precision.HALF:
                return self._bound_number(data, f"_half(_whole({place}, False))")
            case Precision.SINGLE | Precision.DOUBLE:
                return self._bound_number(data, f"_real({place})")
            case _:
                assert_never(precision)

    def _bound_number(self, data: str, call: str) -> str:
        expression = call.format(data)
        return expression if data.startswith("_") else self.bind(expression)

    def bits(self, word: str, bit: Bit) -> str:
        if not bit.pieces:
            return f"_bits({word}, {bit.first}, {bit.width}, {bit.signed})"
        runs = ", ".join(f"({run.first}, {run.width}, {run.weight})" for run in bit.runs)
        return f"_bits(_bits_apart({word}, [{runs}]), 0, {bit.width}, {bit.signed})"

    def mask(self, word: str, mask: int) -> str:
        return f"_any_bit({word}, {mask:#x})"

    def piece(self, data: str, offset: int, size: int) -> str:
        return f"_piece({data}, {offset}, {size})"

    def text(self, data: str) -> str:
        return f"_text({data})"

    def not_ascii(self, data: str) -> str:
        return f"~_is_ascii({data})"

    def truth(self, number: str) -> str:
        return f"_truth({number})"

    def member(self, number: str, enum: str) -> str:
        return f"_names({number}, {enum})"

    def cases(
        self,
        number: str,
        names: Mapping[tuple[int, int], str],
        nan: str = "",
        other: tuple[str, str] | None = None,
    ) -> str:
        if other is None:
            return f"_states({number}, {dict(names)!r}, {nan!r})"
        return f"_states({number}, {dict(names)!r}, {nan!r}, {other[0]}, {other[1]!r})"

    def absent(self, value: str, number: str, intervals: Sequence[tuple[int, int]], nan: bool = False) -> str:
        return f"_absent({value}, {number}, {list(intervals)!r}, {nan})"

    def decimal(self, number: str, scale: DecimalScale) -> str:
        return f'_decimal({number}, "{scale.scale:f}", "{scale.offset:f}", {scale.places})'

    def ratio(self, number: str, scale: Fraction, offset: Fraction) -> str:
        below = lcm(scale.denominator, offset.denominator)
        numbers = [float(int(scale * below)), float(int(offset * below)), float(below)]
        return f"_ratio({number}, {', '.join(map(repr, numbers))})"

    def power(self, number: str, exponent: str, intervals: Sequence[tuple[int, int]]) -> str:
        return f"_power({number}, {exponent}, {list(intervals)!r})"

    def is_in(self, number: str, intervals: Sequence[tuple[float, float]], floating: bool = False) -> str:
        reals = any(isinstance(bound, float) for interval in intervals for bound in interval)
        return f"{'_is_within' if reals else '_is_in'}({number}, {list(intervals)!r})"

    def is_nan(self, number: str) -> str:
        return f"{number}.is_nan()"

    def size(self, data: str) -> str:
        return f"_size({data})"

    def compared(self, left: str, operator: str, right: str) -> str:
        return f"({left} {_OPERATORS[operator]} {right})"

    def both(self, *conditions: str) -> str:
        return f"({' & '.join(conditions)})"

    def either(self, *conditions: str) -> str:
        return f"({' | '.join(conditions)})"

    def negated(self, condition: str) -> str:
        return f"~{condition}"

    def each(self, data: str, offset: int, size: int, count: int | None, body: Body) -> str:
        return f"_each({data}, {offset}, {size}, {count}, {body(ELEMENT)})"

    def some(self, data: str, offset: int, size: int, count: int | None, body: Body) -> str:
        return f"{self.each(data, offset, size, count, body)}.list.any()"

    def sized(self, data: str, minimum: int, maximum: int | None, offset: int, unit: int) -> str:
        return f"_sized({data}, {minimum}, {maximum}, {offset}, {unit})"

    def chosen(self, data: str, condition: str) -> str:
        return f"_pl.when({condition}).then({data}).otherwise(None)"

    def first(self, *values: str) -> str:
        return f"_pl.coalesce({', '.join(values)})"

    def first_of(self, data: str, offset: int, size: int, count: int | None, body: Body) -> str:
        return f"{self.each(data, offset, size, count, body)}.list.drop_nulls().list.first()"

    def reason(self, refusals: Sequence[tuple[str, str]]) -> str:
        rows = ", ".join(f'({condition}, "{reason}")' for condition, reason in refusals)
        return f"_reason([{rows}])"

    def words(self, address: str, size: int, unit: int = 2) -> str:
        return f"_words(payload, start, {address}, {size}{f', {unit}' if unit != 2 else ''})"

    def single_bit(self, address: int) -> str:
        return f"_single_bit(payload, start, {address})"

    def argument(self, name: str) -> str:
        return f"{name}.cast(_pl.Int64)"

    def step(self, name: str) -> str:
        return name

    def as_text(self, value: str) -> str:
        return f"{value}.cast(_pl.String)"


def _order(slot: Slot) -> str:
    return f'"{slot.order}", {slot.swapped}'
