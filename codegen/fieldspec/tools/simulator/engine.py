"""Carries out a behaviour: events, rules, states, the motion of the axis, and what signals show."""

from __future__ import annotations

import heapq
from collections.abc import Iterable, Set
from contextlib import suppress
from math import inf

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.behaviour.part import Behaviour, Part
from fieldspec.tools.simulator.actions import ACTIONS
from fieldspec.tools.simulator.axis import LEAST_SECONDS
from fieldspec.tools.simulator.operation import Operation
from fieldspec.tools.simulator.refusal import Refusal
from fieldspec.tools.simulator.reported_version import reported_version

if TYPE_CHECKING:
    from fieldspec.codec.layout.values import Raw

_DEEPEST = 16
"""How many events may raise each other at one moment."""
_MOST_ROUNDS = 64
"""How often rules without an event may follow each other before the rest waits for the next event."""


class Engine(Operation):
    """A device in operation. `message` is the cyclic message in use, or empty.

    Nothing here knows the time: the caller says what it is, and `advance` brings everything up to it.
    """

    def __init__(self, layout: DeviceLayout, behaviour: Behaviour, message: str = "") -> None:
        super().__init__(layout, behaviour, message)
        self._queue: list[tuple[float, int, str]] = []
        self._count = 0
        self._depth = 0
        self._held: dict[str, bool] = {}
        self._old: dict[str, int] = {}
        self._rules = behaviour.of_kind("rule")
        self._levels = [rule for rule in self._rules if rule.get("when") is None and "refused" not in rule.keys]
        self._edges = [rule for rule in self._rules if {"rises", "falls"} & (rule.get("when") or {}).keys()]
        self._written: dict[str, list[Part]] = {}
        """The rules of requests that write operands, by the paths that have been written."""
        self._shows = behaviour.of_kind("show")
        self._shown: tuple[object, ...] | None = None
        """What decided on what signals show, if writing that has changed nothing."""
        self._settled: tuple[object, ...] | None = None
        """What decided on the conditions of rules without an event, if all of them had been carried out."""
        self._followed: tuple[int, ...] = ()
        """How often values had changed when rules of bits were last carried out."""
        self.overridden: dict[str, Raw] = {}
        """Values that a person or a fault holds fast, by the path of their cells."""
        self.reported_version = reported_version(layout, behaviour)
        """The version that the device reports; None where the spec or a behaviour leaves it to other values."""
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
        """Begins with the nonvolatile values."""
        self.memory.words.replace(self.saved)
        self.memory.elements.replace(self.saved_elements)
        self.memory.fields.replace(self.delivered_fields)
        self.memory.transfers.clear()
        self.axis.halt(self.now)
        self.axis.homed = False
        self.states = {part.name: part.subject[0] for part in self.behaviour.of_kind("machine")}
        self._queue.clear()
        self._held.clear()
        self._settled = None
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

    # Events

    def raise_event(self, name: str, seconds: float = 0.0) -> None:
        """Raises an event, now or later. If events raise each other without end, the rest of them is raised later.

        A rule of an event that cannot continue, as for a record that does not exist, ends there without a refusal.
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
        self.run(rule for rule in self._rules if "refused" not in rule.keys and names.intersection(rule.received))
        self.follow()

    def follow_refusal(self, names: Set[str], reason: str) -> None:
        """A request with a message of some `names` has been refused for a reason. A rule that refuses ends there."""
        rules = [
            rule
            for rule in self._rules
            if rule.get("refused") == reason and (not rule.received or names & set(rule.received))
        ]
        with suppress(Refusal):
            self.run(rules)
        self.follow()

    def follow_write(self, paths: Iterable[str]) -> None:
        """A request has written the values of some operands. Raises Refusal, before any other rule has acted."""
        rules = [rule for path in paths for rule in self._rules_of_write(path)]
        guards = [rule for rule in rules if rule.subject[0].kind == "refuse"]
        self.run(guards)
        if len(rules) > len(guards):
            self.run(rule for rule in rules if rule not in guards)
        self.follow()

    def _rules_of_write(self, path: str) -> list[Part]:
        """The rules of requests that write an operand."""
        if path not in self._written:
            self._written[path] = [
                rule
                for rule in self._rules
                if (name := (rule.get("when") or {}).get("write")) is not None
                and any(cell.path == path for cell in self.cells.of(name))
            ]
        return self._written[path]

    def follow(self) -> None:
        """Carries out the rules of bits that have changed, then those without an event whose condition is new."""
        before, self._followed = self._followed, self.memory.changes
        for rule in self._edges if before != self._followed else ():
            new, old = self._bit(rule), self._old.get(rule.name, 0)
            self._old[rule.name] = new
            if new != old and bool(new) == ("rises" in rule["when"]):
                self.run([rule])
        self._settle()

    def _settle(self) -> None:
        """Carries out the rules without an event whose condition is new, until none is."""
        for _ in range(_MOST_ROUNDS):
            decisive = self._decisive()
            if decisive == self._settled:
                return
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
            self._settled = None if acted else decisive

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

    def refresh(self) -> None:
        """Writes what signals show, unless nothing has changed since nothing of it changed the last time."""
        before = self._decisive()
        if before == self._shown:
            return
        for part in self._shows:
            for cell in self.cells.of(part.subject, "response"):
                cell.write(self.raw(cell, self._displayed(part)))
        for path, raw in self.overridden.items():
            for cell in self.cells.of(path):
                cell.write(raw)
        self._shown = before if self._decisive() == before else None

    def _decisive(self) -> tuple[object, ...]:
        """What decides on that which signals show. The time does so in a motion only."""
        settings = *self.states.values(), *self.element.items(), *self.overridden.items()
        return *self.memory.changes, *settings, *self.axis.parts, self.now if self.axis.ramps else None

    def _displayed(self, part: Part) -> object:
        condition = part.get("if")
        if condition is None:
            return part.get("value", 0)
        if self.holds(condition):
            return part.get("value", 1)
        return part.get("otherwise", 0)
