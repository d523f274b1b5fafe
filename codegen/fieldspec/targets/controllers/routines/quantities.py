"""The values of a device that have a quantity, a state or a range, and the names under which they get functions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.registers import Parameter, Subindex
from fieldspec.language.model.value import Value
from fieldspec.targets.controllers.routines.world import every_record
from fieldspec.targets.controllers.statements.expressions import Elementary
from fieldspec.targets.controllers.statements.numbers import whole_type


@dataclass(frozen=True, slots=True)
class Quantity:
    """A value with another number in its unit, with numbers that stand for states, or with a range.

    `owner` is what it belongs to, `fact` what states it. `answer` is the value as it is read, None where it is only
    sent; what is read of a `trigger` is not what was written.
    """

    owner: str
    name: str
    value: Value
    fact: Fact
    answer: Value | None
    trigger: bool = False

    @property
    def kind(self) -> Elementary:
        """The type of the counts."""
        return whole_type(self.value.encoding)

    @property
    def full_name(self) -> str:
        """Its name after that of its owner: `point_speed`"""
        return self.name if self.owner == self.name else f"{self.owner}_{self.name}"

    @property
    def key(self) -> tuple[object, ...]:
        """The facts in which two quantities of one name must be equal to share a function."""
        value = self.value
        sentinels = tuple((sentinel.interval, sentinel.name) for sentinel in value.sentinels)
        ranges = value.ranges, value.write_ranges
        meanings = value.flags, value.enum, *ranges, sentinels
        return value.type.name, value.scale, value.offset, value.unit, *meanings


def has_scale(value: Value) -> bool:
    """Whether functions convert the counts of a value to a quantity and back."""
    return value.scaled and is_count(value.encoding) and bool(value.quantity_intervals)


def quantities(layout: DeviceLayout) -> dict[str, list[Quantity]]:
    """The values that have a scale, by the names under which they get functions; those that share one are together."""
    return by_name(quantity for quantity in every_value(layout) if has_scale(quantity.value))


def by_name(quantities: Iterable[Quantity]) -> dict[str, list[Quantity]]:
    """Quantities by distinct names; those that have the same name and key are in one list."""
    groups: dict[tuple[object, ...], list[Quantity]] = {}
    for quantity in quantities:
        groups.setdefault((quantity.name, *quantity.key), []).append(quantity)
    by_distinct_name: dict[str, list[Quantity]] = {}
    for same in groups.values():
        first = same[0]
        name = first.name if first.name not in by_distinct_name else f"{first.owner}_{first.name}"
        number = 1
        while name in by_distinct_name:
            number += 1
            name = f"{first.owner}_{first.name}_{number}"
        by_distinct_name[name] = same
    return by_distinct_name


def every_value(layout: DeviceLayout) -> Iterator[Quantity]:
    """The values of signals, registers, fields and parameters."""
    device = layout.device
    for signal in device.signals.values():
        yield Quantity(signal.name, signal.name, signal.value, signal, signal.value)
    for row in layout.registers:
        register = row.register
        answer = None if register.reserved or register.access == "wo" else register.answer
        yield Quantity(row.name, row.name, register.value, register, answer, register.trigger)
    sent_bodies = {message.request.name for message in layout.messages.values()}
    for record in every_record(layout):
        for field in record.fields:
            if field.value is not None:
                answer = None if record.name in sent_bodies or field.field.reserved else field.value
                yield Quantity(record.name, field.name, field.value, field.field, answer)
    for parameter_set in device.parameters.values():
        for parameter in parameter_set.parameters:
            trigger = parameter.trigger
            owned: list[tuple[str, Parameter | Subindex]] = [(parameter_set.name, parameter)] * (not parameter.reserved)
            owned += [(parameter.name, inner) for inner in parameter.subindices if not inner.reserved]
            for owner, fact in owned:
                answer = None if (fact.access or parameter.access) == "wo" else fact.value.as_answer(trigger)
                yield Quantity(owner, fact.name, fact.value, fact, answer, trigger)
