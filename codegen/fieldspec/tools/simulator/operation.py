"""A device in operation: its memory, its states, its axis, and the signals that come of them."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from decimal import Decimal
from math import inf

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.values import Raw, number_of_sentinel
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.behaviour.part import NONZERO, Behaviour, Product
from fieldspec.tools.simulator.axis import Axis, Limits
from fieldspec.tools.simulator.cells import BitCell, Cell, Cells
from fieldspec.tools.simulator.memory import Memory

if TYPE_CHECKING:
    from typing import Any, TypeAlias

Number: TypeAlias = "int | float | Decimal"


class Operation(ABC):
    """What actions act on. `message` is the cyclic message in use, or empty.

    What happens by itself, or follows from what has happened, is up to the `Engine`.
    """

    def __init__(self, layout: DeviceLayout, behaviour: Behaviour, message: str) -> None:
        self.layout, self.behaviour = layout, behaviour
        self.memory = Memory(layout)
        self.cells = Cells(self.memory, behaviour, message)
        self._named_numbers: dict[tuple[Cell, str], Raw | None] = {}
        axis = next(iter(behaviour.of_kind("axis")), None)
        self.axis_keys: dict[str, Any] = dict(axis.subject) if axis is not None else {}
        self.axis = Axis(float(self.axis_keys.get("start", 0)))
        self.states: dict[str, str] = {}
        self.element: dict[str, Raw] = {}
        self.now = 0.0
        self.listeners: list[Callable[[str, str], None]] = []
        """Called with a kind and a text for each event: `state`, `event` or `move`."""
        self.saved: dict[tuple[str, int], int] = {}
        self.saved_elements: dict[tuple[str, int, int], Raw] = {}

    @abstractmethod
    def raise_event(self, name: str, seconds: float = 0.0) -> None:
        """Raises an event, now or later."""

    @abstractmethod
    def power_on(self) -> None:
        """Begins with the nonvolatile values."""

    def holds(self, condition: dict[str, Any]) -> bool:
        """Whether all signals of a condition have a value that it names."""
        return all(self._has(name, expected) for name, expected in condition.items())

    def _has(self, name: str, expected: Any) -> bool:
        expected_values = expected if isinstance(expected, tuple) else (expected,)
        scope, _, rest = name.partition("/")
        if scope == "state":
            return self.states[rest] in expected_values
        if scope == "axis":
            return any(bool(self.of_axis(rest)) == bool(value) for value in expected_values)
        if scope == "element":
            raw = self.element.get(rest)
            return any(raw == self._member(rest, value) for value in expected_values)
        return any(self._equals(cell, value) for cell in self._in_use(name) for value in expected_values)

    def _equals(self, cell: Cell, value: object) -> bool:
        raw = cell.read()
        return bool(raw) if value == NONZERO else raw == self.raw(cell, value)

    def _in_use(self, name: str) -> list[Cell]:
        """The cells of a condition: of requests, or else of responses."""
        return self.cells.of(name, "request") or self.cells.of(name)

    def _member(self, field: str, value: object) -> object:
        if not isinstance(value, str):
            return value
        device = self.layout.device
        for record in device.records.values():
            known = record.named(field)
            if known is None or known.value is None:
                continue
            member = device.enums[known.value.enum].named(value) if known.value.enum else None
            if member is not None:
                return member.value
            for sentinel in known.value.sentinels:
                if sentinel.name == value:
                    return number_of_sentinel(known.value, sentinel)
        return value

    def raw(self, cell: Cell, value: object) -> Raw:
        """The raw value of a value in a behaviour for a cell: that of a member, of a special value, or a number."""
        if isinstance(value, bool):
            return int(value)
        if isinstance(value, str):
            key = cell, value
            if key not in self._named_numbers:
                self._named_numbers[key] = self._named_number(cell, value)
            named_number = self._named_numbers[key]
            if named_number is not None:
                return named_number
        number = self.number(value)
        return number if isinstance(number, int | float) else float(number)

    def _named_number(self, cell: Cell, name: str) -> Raw | None:
        """The raw value of a member or a special value of a cell; None for other names."""
        enum = cell.enum if isinstance(cell, BitCell) else cell.value.enum if cell.value is not None else ""
        member = self.layout.device.enums[enum].named(name) if enum else None
        if member is not None:
            return member.value
        for sentinel in cell.value.sentinels if cell.value is not None else ():
            if sentinel.name == name and cell.value is not None:
                return number_of_sentinel(cell.value, sentinel)
        return None

    def names_nothing(self, cell: Cell, text: str) -> bool:
        """Whether a text is not a value of a cell, and no signal either."""
        return not self.cells.names.has_member(cell.path, text) and not self.cells.names.is_known(text)

    def number(self, value: object) -> Number:
        """A number, that of a signal, or a computed one; a special value counts as 0."""
        if isinstance(value, Product):
            return self._product(value)
        if isinstance(value, str):
            known = self.signal(value)
            return 0 if known is None else known
        return value if isinstance(value, int | float | Decimal) else 0

    def _product(self, product: Product) -> Number:
        result = 1.0
        if product.bits:
            result = float(sum(bool(self.number(name)) << number for number, name in enumerate(product.bits)))
        for number, factor in enumerate((*product.factors, *product.over)):
            term = factor if not isinstance(factor, str) else self.signal(factor)
            amount = float(term) if term is not None else 0.0
            if number < len(product.factors):
                result *= amount
            else:
                result = result / amount if amount else 0.0
        return self.number(product.alternative) if not result and product.alternative is not None else result

    def signal(self, name: str) -> Number | None:
        """The number that a signal has; None for a special value."""
        scope, _, rest = name.partition("/")
        if scope == "axis":
            return self.of_axis(rest)
        if scope == "element":
            raw: Raw = self.element.get(rest, 0)
            return raw if isinstance(raw, int | float) else 0
        cells = self._in_use(name)
        if not cells:
            return 0
        raw, value = cells[0].read(), cells[0].value
        if not isinstance(raw, int | float):
            return 0
        return None if value is not None and value.sentinel(raw) is not None else raw

    def of_axis(self, name: str) -> Number:
        """A property of the axis; truth values are 0 or 1."""
        axis, now = self.axis, self.now
        match name:
            case "position" | "commanded":
                return axis.position(now)
            case "speed":
                return axis.speed(now)
            case "moving":
                return axis.moving
            case "homing":
                return axis.moving and axis.kind == "home"
            case "homed":
                return axis.homed
            case "in_position":
                zone = float(self.number(self.axis_keys.get("zone", 0)))
                return not axis.moving or abs(axis.goal - axis.position(now)) < zone
            case "forward":
                return axis.speed(now) > 0
            case "at_lowest":
                return axis.position(now) <= self.limits().lowest
            case "at_highest":
                return axis.position(now) >= self.limits().highest
        ramp = axis.ramp(now)
        change = (abs(ramp[0].last) > abs(ramp[0].first)) - (abs(ramp[0].last) < abs(ramp[0].first)) if ramp else 0
        return {
            "accelerating": change > 0,
            "decelerating": change < 0,
            "constant_speed": ramp is not None and change == 0 and axis.speed(now) != 0,
        }[name]

    def limits(self) -> Limits:
        """The bounds of the axis at present."""
        lowest, highest = (self._bound(key) for key in ("lowest", "highest"))
        return Limits(-inf if lowest is None else lowest, inf if highest is None else highest)

    def _bound(self, key: str) -> float | None:
        value = self.axis_keys.get(key)
        number = self.signal(value) if isinstance(value, str) else None if value is None else self.number(value)
        return None if number is None else float(number)

    def tell(self, kind: str, text: str) -> None:
        """Tells the listeners of something."""
        for listener in self.listeners:
            listener(kind, text)
