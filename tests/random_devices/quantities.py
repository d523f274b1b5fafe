"""Questions about quantities: the number in the unit of a count, the count of a number in the unit, and both of parts
of a reference; and the states of numbers that are read. The answers are exact fractions of the reference, rounded once.

A count of a quantity is the nearest one, of two equally near ones the even one. It is refused where it may not be
written, and where it stands for a state.
"""

from __future__ import annotations

import math
import random
import struct
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.exponents import ExponentLayout, exponent_of
from fieldspec.codec.reference.quantities import quantity, scale_of, special_name, special_number, state_name
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count, is_real
from fieldspec.language.model.value import Conversion, Value
from random_devices.inputs import is_computed, number_or_text
from random_devices.queries import Answer, Query, has_quantity, quantity_text, shapes

DRAWS = 2
_MOST_REAL = 1e30
"""Reals up to it are tried, as each precision but half has them."""
_DOUBLE_BITS = 50
"""Counts of so many bits are stated apart after some roundings of doubles."""


@dataclass(frozen=True)
class Measured:
    """A value in `size` bytes with a quantity, and what has the exponent of its scale."""

    value: Value
    size: int
    exponent: ExponentLayout | None = None

    @property
    def powers(self) -> tuple[int, ...]:
        """The exponents that are tried; none where the scale is fixed."""
        if self.exponent is None:
            return ()
        ranges = self.exponent.value.ranges
        return (ranges.low, ranges.high) if ranges is not None else ()


def measured_values(layout: DeviceLayout) -> Iterator[tuple[tuple[str, ...], Measured]]:
    """The values with quantities, by their kind and names: registers, parameters, and fields of records."""
    for kind, path, (value, _, _, _, size) in shapes(layout):
        if has_quantity(value) and kind != "subindex" and not (value.scale_by and kind == "parameter"):
            yield (kind, *path), Measured(value, size, exponent_of(value, layout.registers))
    bodies = (body for message in layout.messages.values() for body in message.bodies)
    for record in {record.name: record for record in (*layout.records.values(), *bodies)}.values():
        for field in record.fields:
            value = field.value
            if value is not None and not is_computed(field) and value.parameter is None and has_quantity(value):
                exponent = exponent_of(value, layout.registers, record)
                yield ("record", record.name, field.name), Measured(value, field.size, exponent)


@dataclass(frozen=True)
class StatedValue:
    """A number in `size` bytes that may be in a state where it is read."""

    device: Device
    value: Value
    size: int
    trigger: bool = False

    def state(self, raw: float) -> str | None:
        """The state by the reference. What is read of a trigger was not written: nothing is stated of it."""
        name = state_name(self.device, self.value, raw)
        return None if not name or (self.trigger and not special_name(self.value, raw)) else name


def stated_values(layout: DeviceLayout) -> Iterator[tuple[tuple[str, ...], StatedValue]]:
    """The numbers that may be in a state, by kind and names: registers, parameters, fields, and cases of fields."""
    device = layout.device
    reserved = {row.name for row in layout.registers if row.register.reserved}
    for kind, path, (value, _, _, trigger, size) in shapes(layout):
        if kind == "register" and path[0] in reserved:
            continue
        if kind == "parameter" and any(
            row.subindices for row in device.parameters[path[0]].parameters if row.name == path[1]
        ):
            continue  # its states are those of its elements
        answer = StatedValue(device, value.as_answer(trigger), size, trigger)
        yield from _if_number(("parameter" if kind == "subindex" else kind, *path), answer)
    bodies = (body for message in layout.messages.values() for body in message.bodies)
    for record in {record.name: record for record in (*layout.records.values(), *bodies)}.values():
        for field in record.fields:
            if field.field.reserved or is_computed(field):
                continue
            if field.value is not None:
                yield from _if_number(("record", record.name, field.name), StatedValue(device, field.value, field.size))
            for case in field.cases:
                yield from _if_number(
                    ("record", record.name, field.name, case.name), StatedValue(device, case.value, case.value.size)
                )


def _if_number(path: tuple[str, ...], stated: StatedValue) -> Iterator[tuple[tuple[str, ...], StatedValue]]:
    value = stated.value
    if value.const is None and value.parameter is None and (is_count(value.encoding) or is_real(value.encoding)):
        yield path, stated


def state_queries(layout: DeviceLayout, dice: random.Random) -> list[Query]:
    """Questions about the states of numbers at the ends of what is stated of them, beside these, and anywhere."""
    return [
        Query("state", path, values={"raw": raw}, shape=stated)
        for path, stated in stated_values(layout)
        for raw in _readable(layout, stated.value, dice)
    ]


def _readable(layout: DeviceLayout, value: Value, dice: random.Random) -> list[Any]:
    """Numbers that can be read: of what bounds them, and of their type."""
    if is_real(value.encoding):
        ends = [float(end) for interval in (value.ranges.intervals if value.ranges else ()) for end in interval]
        edges = {near for end in ends for near in (end, end - 1000.0, end + 1000.0)}
        drawn = [struct.unpack("<f", struct.pack("<f", edge))[0] for edge in edges if abs(edge) < _MOST_REAL]
        return [*_counts(layout, value, dice), *sorted(drawn), math.inf]
    ends = [end for interval in (value.ranges.intervals if value.ranges else ()) for end in interval]
    word = layout.device.flags.get(value.flags)
    fields = [] if word is None else [dice.getrandbits(8 * word.type.size) for _ in word.bits]
    near = {end + step for end in ends for step in (-1, 0, 1)}
    numbers = {
        number for number in (*_counts(layout, value, dice), *near, *fields) if value.low <= number <= value.high
    }
    enum = layout.device.enums.get(value.enum)
    if enum is None or enum.open:
        return sorted(numbers)
    members = {member.value for member in enum.members if not member.unavailable}
    return sorted(number for number in numbers if number in members or special_name(value, number))


def quantity_queries(layout: DeviceLayout, dice: random.Random) -> list[Query]:
    """Questions about all values with quantities, and about conversions."""
    drawn: list[Query] = []
    for path, measured in measured_values(layout):
        if measured.exponent is not None and not measured.powers:
            continue
        for count in _counts(layout, measured.value, dice):
            for power in measured.powers or (None,):
                drawn.append(Query("quantity", path, values={"raw": count, "power": power}, shape=measured))
                exact = quantity(measured.value, count, power)
                if exact is None or is_real(measured.value.encoding):
                    continue
                for number in (float(exact), float(exact + scale_of(measured.value, power) / 2)):
                    values = {"quantity": number, "power": power}
                    drawn.append(Query("count", path, values=values, shape=measured))
    for conversion in layout.device.conversions.values():
        for reference in (1.0, 1500.5, -3.25):
            low, high = conversion.type.low, conversion.type.high
            for count in (low, high, 0, dice.randint(low, high)):
                values = {"raw": count, "reference": reference}
                drawn.append(Query("share", ("conversion", conversion.name), values=values, shape=conversion))
    return drawn


def _counts(layout: DeviceLayout, value: Value, dice: random.Random) -> list[Any]:
    """The ends of what a value may be, numbers beside them, states, and drawn numbers."""
    special = [special_number(value, sentinel.name) for sentinel in value.sentinels]
    special += [sentinel.last for sentinel in value.sentinels if sentinel.last is not None]
    drawn = [number_or_text(layout, value, dice) for _ in range(DRAWS)]
    if is_real(value.encoding):
        form = "<f" if value.size == 4 else "<d"
        drawn = [struct.unpack(form, struct.pack(form, number))[0] for number in drawn if math.isfinite(number)]
        return [*special, *drawn, math.nan, -1.5]
    ranges = value.writable_ranges
    ends = [end for interval in ranges.intervals for end in interval] if ranges is not None else []
    edges = {other for number in (*ends, *special) for other in (number - 1, number, number + 1)}
    numbers = {*edges, *drawn, value.low, value.high, 0}
    return sorted(number for number in numbers if value.type.low <= number <= value.type.high)


def expected_answer(query: Query) -> Answer:
    """The answer of the reference."""
    assert query.values is not None
    if query.kind == "state":
        return Answer(quantity=str(query.shape.state(query.values["raw"])))
    if query.kind == "share":
        return Answer(quantity=quantity_text(float(_share(query.shape, query.values)), None))
    value, power = query.shape.value, query.values["power"]
    if query.kind == "quantity":
        raw = query.values["raw"]
        exact = quantity(value, raw, power)
        state = special_name(value, raw) or None
        is_own = is_real(value.encoding) and state is None  # it is in the unit already, as -0.0 and NaN are
        number = raw if is_own else exact
        return Answer(quantity=quantity_text(None if number is None else float(number), state))
    count = round(_exact_count(query))
    ranges = value.writable_ranges
    is_within = value.low <= count <= value.high if ranges is None else count in ranges
    return Answer("out_of_range") if not is_within or special_name(value, count) else Answer(again=str(count))


def _share(conversion: Conversion, values: Mapping[str, Any]) -> Fraction:
    """The quantity of a count that is a part of a reference."""
    reference = Fraction(values["reference"])
    share = Fraction(values["raw"], conversion.full_scale)
    return reference * (1 - share) if conversion.complement else reference * share


def _exact_count(query: Query) -> Fraction:
    assert query.values is not None
    value = query.shape.value
    return (Fraction(query.values["quantity"]) - Fraction(value.offset)) / scale_of(value, query.values["power"])


def is_for_doubles(query: Query) -> bool:
    """Whether arithmetic with doubles has one answer: the count is nearly whole, and has few bits.

    The terms of the quantity have no more digits than a double, and neither has the scale.
    """
    if query.kind != "count":
        return True
    assert query.values is not None
    value, exact = query.shape.value, _exact_count(query)
    scale, number = abs(scale_of(value, query.values["power"])), abs(Fraction(query.values["quantity"]))
    terms = (number + abs(Fraction(value.offset))) / scale
    return terms < 1 << _DOUBLE_BITS and abs(exact - round(exact)) < Fraction(1, 100)


def with_rounding(query: Query, answer: Answer) -> Answer:
    """An answer of arithmetic with doubles: a quantity that is as near as they get is that of the reference."""
    expected = expected_answer(query)
    if answer.quantity is None or expected.quantity is None:
        return answer
    (own, own_state), (exact, state) = answer.quantity.split(" "), expected.quantity.split(" ")
    if own_state != state or "None" in (own, exact) or own.startswith("!"):
        return answer
    assert query.values is not None
    if query.kind == "share":
        terms = 2 * abs(Fraction(query.values["reference"])) * max(1, abs(query.values["raw"]))
    elif is_real(query.shape.value.encoding):
        terms = Fraction(0)
    else:
        scale = abs(scale_of(query.shape.value, query.values["power"]))
        terms = abs(query.values["raw"]) * scale + abs(Fraction(query.shape.value.offset))
    is_near = abs(Fraction(own) - Fraction(exact)) <= terms / 10**14 if math.isfinite(float(own)) else own == exact
    return replace(answer, quantity=expected.quantity) if is_near else answer
