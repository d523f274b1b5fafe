"""An axis with its motion: it begins some time after a command, ramps up and down, and records what happens to it.

Positions are counts of the device, velocities counts in a second.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from device_models.draws import Draws

STEP = 0.01
"""The longest step of the integration, in seconds."""
NOTHING = 1e-9
"""What is left of a number where binary fractions do not meet."""
ACCELERATION = 40000.0
"""Counts in a second, gained or lost in a second."""


@dataclass(frozen=True)
class Motion:
    """A motion. `kind` is absolute, relative, point, home, jog_forward, jog_backward or velocity.

    `value` is what was asked for: a position, a distance, or the number of a point. `target` is where the motion ends,
    or None where a stop ends it. `outside` is a motion that no command has asked for.
    """

    number: int
    kind: str
    value: float
    target: float | None
    speed: float
    outside: bool = False


@dataclass(frozen=True)
class Event:
    """What happens at a device.

    `kind` is asked (a frame or a bit that is to start or stop something is on the wire), accepted, refused, began,
    reached, interrupted, stop, stop ended (it is not shown any more), alarm or cause gone; `about` says of what,
    `number` of which motion, and `speed` how fast it is to be.
    """

    kind: str
    about: str
    number: int = 0
    value: float = 0.0
    speed: float = 0.0


@dataclass(frozen=True)
class State:
    """An axis at one moment.

    `number` is that of the motion that it carries out by a command, as long as nobody else stops it, and `waiting` that
    of the one that it has accepted and not begun; both are 0 without one.
    """

    position: float = 0.0
    velocity: float = 0.0
    number: int = 0
    waiting: int = 0
    servo: bool = True
    homed: bool = True
    alarm: bool = False


class Axis:
    """Where an axis is, how fast it is, and what it is about to do."""

    def __init__(self, draws: Draws) -> None:
        self.draws = draws
        self.position = self.velocity = 0.0
        self.motion: Motion | None = None
        self.waiting: Motion | None = None
        self.wait = 0.0
        self.stopping = self.foreign_stop = False
        self.deceleration = ACCELERATION
        self.homed = False
        self.number = 0
        self.events: list[Event] = []
        self._homing = 0.0

    @property
    def moving(self) -> bool:
        """Whether it carries out a motion, or has not come to a halt after one."""
        return self.motion is not None

    def state(self, servo: bool, alarm: bool) -> State:
        """What is true now."""
        motion, waiting = self.motion, self.waiting
        return State(
            self.position,
            self.velocity,
            motion.number if motion is not None and not motion.outside and not self.foreign_stop else 0,
            waiting.number if waiting is not None else 0,
            servo,
            self.homed,
            alarm,
        )

    @property
    def expected(self) -> bool:
        """Whether it moves, or is about to."""
        return self.motion is not None or self.waiting is not None

    def record(self, kind: str, about: str, value: float = 0.0, number: int = 0) -> None:
        """Notes an event."""
        self.events.append(Event(kind, about, number, value))

    def accept(self, kind: str, value: float, target: float | None, speed: float, outside: bool = False) -> None:
        """Takes a command; its motion begins later, and then takes the place of the one before."""
        self.number += 1
        self.waiting = Motion(self.number, kind, value, target, speed, outside)
        self.wait = 0.0 if outside else self.draws.start_delay()
        if kind == "home":
            self.homed = False
        self.events.append(Event("accepted", kind, self.number, value, abs(speed)))
        if self.wait <= 0:
            self._begin()

    def stop(self, deceleration: float = ACCELERATION, outside: bool = False, visible: bool = False) -> None:
        """Decelerates to a halt. `late_start` says whether a motion that has not begun yet begins nevertheless.

        The value of the event is 1 where a stop from `outside` is `visible` to the controller for as long as it stands.
        """
        about = "outside" if outside else "command"
        self.record("stop", about, float(visible), self.motion.number if self.motion else 0)
        waiting = self.waiting
        if waiting is not None and (
            outside or self.draws.reading("late start", *["cancelled"] * 7, "goes on") == "cancelled"
        ):
            self._end("interrupted", waiting)
            self.waiting = None
        if self.motion is not None:
            self.stopping, self.deceleration, self.foreign_stop = True, deceleration, outside

    def cut(self) -> None:
        """Stands at once, whatever it does, as with an alarm or without power."""
        for motion in filter(None, (self.motion, self.waiting)):
            self._end("interrupted", motion)
        self.motion = self.waiting = None
        self.velocity, self.stopping, self.foreign_stop = 0.0, False, False

    def pass_time(self, seconds: float) -> None:
        """Some time goes by."""
        while seconds > NOTHING and (self.motion is not None or self.waiting is not None):
            step = min(seconds, STEP)
            seconds -= step
            if self.waiting is not None:
                self.wait -= step
                if self.wait <= 0:
                    self._begin()
            if self.motion is not None:
                self._move(self.motion, step)

    def _begin(self) -> None:
        motion = self.waiting
        assert motion is not None
        if self.motion is not None:
            self._end("interrupted", self.motion)
        self.waiting = None
        if motion.kind == "relative" and motion.target is None:
            motion = Motion(motion.number, motion.kind, motion.value, self.position + motion.value, motion.speed)
        self.motion, self.stopping, self.foreign_stop = motion, False, False
        self.record("began", motion.kind, motion.value, motion.number)
        if motion.kind == "home":
            self._homing = self.draws.dice.uniform(0.3, 1.5)

    def _move(self, motion: Motion, step: float) -> None:
        if self.stopping:
            self._ramp(0.0, step, self.deceleration)
            if abs(self.velocity) < NOTHING:
                self._end("interrupted", motion)
                self.motion, self.velocity = None, 0.0
                self.stopping = self.foreign_stop = False
        elif motion.kind == "home":
            self._ramp(-motion.speed, step, ACCELERATION)
            self._homing -= step
            if self._homing <= 0:
                self.position = self.velocity = 0.0
                self.homed = True
                self._reach(motion)
        elif motion.target is None:
            self._ramp(motion.speed, step, ACCELERATION)
        else:
            self._approach(motion, motion.target, step)

    def _approach(self, motion: Motion, target: float, step: float) -> None:
        left = target - self.position
        braking = math.sqrt(2 * ACCELERATION * abs(left))
        # A quarter is left for the steps, which are not as fine as the formula takes them to be.
        wanted = math.copysign(min(abs(motion.speed), 0.75 * braking), left)
        before = self.position
        self._ramp(wanted, step, 4 * ACCELERATION)
        if (target - before) * (target - self.position) <= 0 or abs(target - self.position) < 2:
            self.position, self.velocity = target, 0.0
            self._reach(motion)

    def _ramp(self, wanted: float, step: float, rate: float) -> None:
        change = max(-rate * step, min(rate * step, wanted - self.velocity))
        self.velocity += change
        self.position += self.velocity * step

    def _reach(self, motion: Motion) -> None:
        self._end("reached", motion)
        self.motion = None

    def _end(self, kind: str, motion: Motion) -> None:
        self.record(kind, motion.kind, motion.value, motion.number)
