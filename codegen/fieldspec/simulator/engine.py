"""Carries out a behaviour: events, rules, states, the motion of the axis, and what signals show."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterable, Iterator
from decimal import Decimal
from math import inf

from fieldspec.behaviour.part import NONZERO, Behaviour, Part, Product
from fieldspec.classes import TYPE_CHECKING
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.values import Raw, number_of_sentinel
from fieldspec.simulator.actions import ACTIONS
from fieldspec.simulator.axis import LEAST_SECONDS, Axis, Limits
from fieldspec.simulator.cells import BitCell, Cell, Cells
from fieldspec.simulator.memory import Memory
from fieldspec.simulator.refusal import Refusal
from fieldspec.simulator.reported_version import reported_version

if TYPE_CHECKING:
    from typing import Any, TypeAlias

Number: TypeAlias = "int | float | Decimal"

_DEEPEST = 16
"""How many events may raise each other at one moment."""
_MOST_ROUNDS = 64
"""How often rules without an event may follow each other before the rest waits for the next event."""


class Engine:
    """A device in operation. `message` is the cyclic message in use, or empty.

    Nothing here knows the time: the caller says what it is, and `advance` brings everything up to it.
    """

    def __init__(self, layout: DeviceLayout, behaviour: Behaviour, message: str = "") -> None:
        self.layout, self.behaviour = layout, behaviour
        self.memory = Memory(layout)
        self.cells = Cells(self.memory, behaviour, message)
        axis = next(iter(behaviour.of_kind("axis")), None)
        self.axis_keys: dict[str, Any] = dict(axis.subject) if axis is not None else {}
        self.axis = Axis(float(self.axis_keys.get("start", 0)))
        self.states: dict[str, str] = {}
        self.element: dict[str, Raw] = {}
        self.now = 0.0
        self.listeners: list[Callable[[str, str], None]] = []
        """Called with a kind and a text for each event: `state`, `event` or `move`."""
        self._queue: list[tuple[float, int, str]] = []
        self._count = 0
        self._depth = 0
        self._held: dict[str, bool] = {}
        self._old: dict[str, int] = {}
        self._rules = behaviour.of_kind("rule")
        self._levels = [rule for rule in self._rules if rule.get("when") is None]
        self._edges = [rule for rule in self._rules if {"rises", "falls"} & (rule.get("when") or {}).keys()]
        self._shows = behaviour.of_kind("show")
        self.saved: dict[tuple[str, int], int] = {}
        self.saved_elements: dict[tuple[str, int, int], Raw] = {}
        self.overridden: dict[str, Raw] = {}
        """Values that a person or a fault holds fast, by the path of their cells."""
        self.reported_version = reported_version(layout, behaviour)
        """What the device tells of its version; None where the spec or a behaviour leaves it to other values."""
        self._deliver()
        self.power_on()
        self.refresh()

    def _deliver(self) -> None:
        if self.reported_version is not None:
            for cell in self.cells.of(self.reported_version.fact):
                cell.write(self.reported_version.raw)
        for part in self.behaviour.of_kind("initial"):
            for cell in self.cells.of(part.subject):
                cell.write(self.raw(cell, part["value"]))
        self.saved = dict(self.memory.words)
        self.saved_elements = dict(self.memory.elements)
        self.delivered_fields = dict(self.memory.fields)

    def power_on(self) -> None:
        """Begins with the values that outlast the power."""
        self.memory.words = dict(self.saved)
        self.memory.elements = dict(self.saved_elements)
        self.memory.fields = dict(self.delivered_fields)
        self.memory.transfers.clear()
        self.axis.halt(self.now)
        self.axis.homed = False
        self.states = {part.name: part.subject[0] for part in self.behaviour.of_kind("machine")}
        self._queue.clear()
        self._held.clear()
        self.element.clear()
        self._old = {rule.name: self._bit(rule) for rule in self._edges}
        self.raise_event("power_on")

    def advance(self, now: float) -> None:
        """Lets everything happen that is due until a time."""
        while (due := min(self.axis.end, self._queue[0][0] if self._queue else inf)) <= now:
            self.now = max(self.now, due)
            if self.axis.end <= due:
                self.raise_event(self.axis.settle())
            else:
                self.raise_event(heapq.heappop(self._queue)[2])
        self.now = max(self.now, now)
        self.refresh()

    def due(self) -> float:
        """The time of the next event that is known; infinite if none is."""
        return min(self.axis.end, self._queue[0][0] if self._queue else inf)

    # Events

    def raise_event(self, name: str, seconds: float = 0.0) -> None:
        """Raises an event, now or later. Of events that raise each other without end, the rest comes later.

        A rule of an event that cannot go on, as with a record that does not exist, ends there: nobody is refused.
        """
        if seconds > 0 or self._depth >= _DEEPEST:
            self._count += 1
            heapq.heappush(self._queue, (self.now + max(seconds, LEAST_SECONDS), self._count, name))
            return
        self.tell("event", name)
        self._depth += 1
        try:
            self.run(rule for rule in self._rules if (rule.get("when") or {}).get("event") == name)
        except Refusal as refusal:
            self.tell("event", f"{name} ends: {refusal}")
        finally:
            self._depth -= 1

    def follow_message(self, message: str, path: str, roles: Iterable[str]) -> None:
        """A request with a message has come; its fields are in memory."""
        names = {path, *roles, f"messages/{message}"}
        self.run(rule for rule in self._rules if (rule.get("when") or {}).get("receive") in names)
        self.follow()

    def follow_write(self, paths: Iterable[str]) -> None:
        """A request has written the values of some operands. Raises Refusal, before any other rule has acted."""
        rules = [rule for path in paths for rule in self._rules if self._writes(rule, path)]
        guards = [rule for rule in rules if rule.subject[0].kind == "refuse"]
        self.run(guards)
        self.run(rule for rule in rules if rule not in guards)
        self.follow()

    def _writes(self, rule: Part, path: str) -> bool:
        name = (rule.get("when") or {}).get("write")
        return name is not None and any(cell.path == path for cell in self.cells.of(name))

    def follow(self) -> None:
        """Carries out the rules of bits that have changed, then those without an event whose condition is new."""
        for rule in self._edges:
            new, old = self._bit(rule), self._old.get(rule.name, 0)
            self._old[rule.name] = new
            if new != old and bool(new) == ("rises" in rule["when"]):
                self.run([rule])
        self._settle()

    def _settle(self) -> None:
        for _ in range(_MOST_ROUNDS):
            acted = False
            for rule in self._levels:
                holds = self.holds(rule.get("if") or {})
                if holds and not self._held.get(rule.name):
                    self._held[rule.name] = True
                    acted = True
                    for action in rule.subject:
                        ACTIONS[action.kind](self, action)
                elif not holds:
                    self._held[rule.name] = False
            if not acted:
                return

    def _bit(self, rule: Part) -> int:
        name = next(iter(rule["when"].values()))
        return max((int(bool(cell.read())) for cell in self.cells.of(name, "request")), default=0)

    def run(self, rules: Iterable[Part]) -> None:
        """Carries out the rules whose conditions hold, in the order of the spec. Raises Refusal."""
        for rule in list(rules):
            if self.holds(rule.get("if") or {}):
                for action in rule.subject:
                    if action.kind == "refuse":
                        raise Refusal(action.subject)
                    ACTIONS[action.kind](self, action)
        self._settle()

    # Signals

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
        """The cells that a condition means: those of requests, or else those of responses."""
        return self.cells.of(name, "request") or self.cells.of(name)

    def _member(self, field: str, value: object) -> object:
        if not isinstance(value, str):
            return value
        device = self.layout.device
        for record in device.records.values():
            known = record.named(field)
            if known is not None and known.value is not None and known.value.enum:
                member = device.enums[known.value.enum].named(value)
                if member is not None:
                    return member.value
        return value

    def raw(self, cell: Cell, value: object) -> Raw:
        """The raw value of a value in a behaviour for a cell: that of a member, of a special value, or a number."""
        if isinstance(value, bool):
            return int(value)
        if isinstance(value, str):
            enum = cell.enum if isinstance(cell, BitCell) else cell.value.enum if cell.value is not None else ""
            member = self.layout.device.enums[enum].named(value) if enum else None
            if member is not None:
                return member.value
            for sentinel in cell.value.sentinels if cell.value is not None else ():
                if sentinel.name == value and cell.value is not None:
                    return number_of_sentinel(cell.value, sentinel)
        number = self.number(value)
        return number if isinstance(number, int | float) else float(number)

    def names_nothing(self, cell: Cell, text: str) -> bool:
        """Whether a text is no value of a cell, and no signal either."""
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
        if name in ("position", "commanded"):
            return axis.position(now)
        speed = axis.speed(now)
        if name == "speed":
            return speed
        ramp = axis.ramp(now)
        change = (abs(ramp[0].last) > abs(ramp[0].first)) - (abs(ramp[0].last) < abs(ramp[0].first)) if ramp else 0
        limits = self.limits()
        zone = float(self.number(self.axis_keys.get("zone", 0)))
        is_near = not axis.moving or abs(axis.goal - axis.position(now)) < zone
        return {
            "moving": axis.moving,
            "homing": axis.moving and axis.kind == "home",
            "homed": axis.homed,
            "in_position": is_near,
            "accelerating": change > 0,
            "decelerating": change < 0,
            "constant_speed": ramp is not None and change == 0 and speed != 0,
            "forward": speed > 0,
            "at_lowest": axis.position(now) <= limits.lowest,
            "at_highest": axis.position(now) >= limits.highest,
        }[name]

    def limits(self) -> Limits:
        """The bounds of the axis at present."""
        lowest, highest = (self._bound(key) for key in ("lowest", "highest"))
        return Limits(-inf if lowest is None else lowest, inf if highest is None else highest)

    def _bound(self, key: str) -> float | None:
        value = self.axis_keys.get(key)
        number = self.signal(value) if isinstance(value, str) else None if value is None else self.number(value)
        return None if number is None else float(number)

    def refresh(self) -> None:
        """Writes the values of signals that are shown, or overridden, to the memory."""
        for part in self._shows:
            for cell in self.cells.of(part.subject, "response"):
                cell.write(self.raw(cell, self._displayed(part)))
        for path, raw in self.overridden.items():
            for cell in self.cells.of(path):
                cell.write(raw)

    def _displayed(self, part: Part) -> object:
        condition = part.get("if")
        if condition is None:
            return part.get("value", 0)
        if self.holds(condition):
            return part.get("value", 1)
        return part.get("otherwise", 0)

    def tell(self, kind: str, text: str) -> None:
        """Passes an event to the listeners."""
        for listener in self.listeners:
            listener(kind, text)

    def loaded(self) -> Iterator[str]:
        """The names of the fields of the record that was loaded last."""
        yield from self.element
