"""The motion of an axis: trapezoids of speed as functions of time, so that no time has to pass step by step."""

from __future__ import annotations

from math import copysign, inf, sqrt

from fieldspec.foundation.classes import dataclass

_SAME = 1e-9
LEAST_SECONDS = 0.001
"""The shortest motion: without a least time, points without a distance would follow each other without end."""
LEAST_SEARCH = 0.5
"""The shortest homing, in seconds: the axis looks for its origin, however near it is."""


@dataclass(frozen=True, slots=True)
class Ramp:
    """A stretch of motion with constant acceleration: its seconds, and the speeds at its beginning and its end."""

    seconds: float
    first: float
    last: float

    def distance(self, seconds: float) -> float:
        """The distance after some seconds of the ramp."""
        if self.seconds in (0.0, inf):
            return self.first * seconds if self.seconds else 0.0
        return self.first * seconds + (self.last - self.first) * seconds * seconds / (2 * self.seconds)

    def speed(self, seconds: float) -> float:
        """The speed after some seconds of the ramp."""
        if self.seconds in (0.0, inf):
            return self.last
        return self.first + (self.last - self.first) * seconds / self.seconds


@dataclass(frozen=True, slots=True)
class Limits:
    """The bounds of the positions that a move reaches."""

    lowest: float = -inf
    highest: float = inf

    def nearest(self, position: float) -> float:
        """The position itself, or the bound that it is beyond."""
        return min(max(position, self.lowest), self.highest)


class Axis:
    """One axis. Positions are in counts, speeds in counts a second.

    `rise` and `fall` are the seconds for a change of speed by 1.
    """

    def __init__(self, start: float) -> None:
        self.ramps: tuple[Ramp, ...] = ()
        self.began = 0.0
        self.origin = start
        """The position when the motion began."""
        self.goal = start
        """The position at its end."""
        self.machine_zero = 0.0
        """The position that the mechanical origin has."""
        self.kind = ""
        """`move`, `home`, `stop`, or empty at rest."""
        self.home_position = 0.0
        self.homed = False
        self.limited = False

    @property
    def end(self) -> float:
        """The time at which the motion ends; infinite without one."""
        return self.began + sum(ramp.seconds for ramp in self.ramps) if self.ramps else inf

    @property
    def moving(self) -> bool:
        """Whether the axis moves."""
        return bool(self.ramps)

    @property
    def parts(self) -> tuple[object, ...]:
        """All that the axis is made of: only what differs in it differs at some time."""
        motion = self.ramps, self.began, self.origin, self.goal, self.kind
        return *motion, self.machine_zero, self.home_position, self.homed, self.limited

    def position(self, now: float) -> float:
        """The position at a time."""
        position, rest = self.origin, now - self.began
        for ramp in self.ramps:
            position += ramp.distance(min(rest, ramp.seconds))
            rest -= ramp.seconds
            if rest <= 0:
                return position
        return self.goal if self.ramps else position

    def ramp(self, now: float) -> tuple[Ramp, float] | None:
        """The ramp at a time, and the seconds since it began; None at rest."""
        rest = now - self.began
        for ramp in self.ramps:
            if rest < ramp.seconds:
                return ramp, rest
            rest -= ramp.seconds
        return None

    def speed(self, now: float) -> float:
        """The speed at a time, negative where the position decreases."""
        current = self.ramp(now)
        return current[0].speed(current[1]) if current else 0.0

    def move(self, now: float, goal: float, speed: float, rise: float, fall: float, limits: Limits, kind: str) -> None:
        """Begins to move to a position. A speed of 0 leaves the axis at rest."""
        bounded = goal if kind == "home" else limits.nearest(goal)
        origin, present = self.position(now), self.speed(now)
        if speed <= 0:
            self.halt(now)
            return
        self._begin(now, origin, bounded, _ramps(bounded - origin, present, speed, rise, fall), kind)
        self.limited = abs(bounded - goal) > _SAME

    def run(self, now: float, speed: float, rise: float, fall: float, limits: Limits) -> None:
        """Begins a motion without an end; at a limit it stops."""
        bound = limits.highest if speed > 0 else limits.lowest
        if abs(bound) != inf or speed == 0:
            self.move(now, bound, abs(speed), rise, fall, limits, "move")
            self.limited = speed != 0
            return
        origin, present = self.position(now), self.speed(now)
        change = Ramp(abs(speed - present) * rise, present, speed)
        self._begin(now, origin, copysign(inf, speed), (change, Ramp(inf, speed, speed)), "move")
        self.limited = False

    def stop(self, now: float, fall: float) -> None:
        """Begins to stop."""
        origin, present = self.position(now), self.speed(now)
        ramp = Ramp(abs(present) * fall, present, 0.0)
        self._begin(now, origin, origin + ramp.distance(ramp.seconds), (ramp,), "stop")
        self.limited = False

    def halt(self, now: float) -> None:
        """Ends a motion at once, without a ramp."""
        self.origin = self.goal = self.position(now)
        self.ramps, self.kind, self.limited = (), "", False

    def settle(self) -> str:
        """Ends the motion whose time is over: the event of it."""
        event = {"stop": "stopped"}.get(self.kind, "limit_reached" if self.limited else "arrived")
        if self.kind == "home":
            self.machine_zero = self.home_position
            self.goal = self.home_position
            self.homed = True
        self.origin, self.ramps, self.kind, self.limited = self.goal, (), "", False
        return event

    def place(self, now: float, number: float) -> None:
        """Gives the present position a number. A motion continues to the same place."""
        shift = number - self.position(now)
        self.origin += shift
        self.goal += shift
        self.machine_zero += shift

    def _begin(self, now: float, origin: float, goal: float, ramps: tuple[Ramp, ...], kind: str) -> None:
        missing = (LEAST_SEARCH if kind == "home" else LEAST_SECONDS) - sum(ramp.seconds for ramp in ramps)
        if missing > 0:
            ramps = (*ramps, Ramp(missing, 0.0, 0.0))
        self.began, self.origin, self.goal, self.ramps, self.kind = now, origin, goal, ramps, kind


def _ramps(distance: float, present: float, speed: float, rise: float, fall: float) -> tuple[Ramp, ...]:
    """The ramps of a move by a distance, from the present speed to rest."""
    ramps: list[Ramp] = []
    braking = present * abs(present) * fall / 2
    if present and (present * distance < 0 or abs(braking) > abs(distance) + _SAME):
        ramps.append(Ramp(abs(present) * fall, present, 0.0))
        distance, present = distance - braking, 0.0
    sign = copysign(1.0, distance)
    length, begin = abs(distance), abs(present)
    rise_and_fall = rise + fall
    peak = (
        min(speed, sqrt(max(0.0, (length + begin * begin * rise / 2) * 2 / rise_and_fall))) if rise_and_fall else speed
    )
    slope = rise if peak >= begin else fall
    first = Ramp(abs(peak - begin) * slope, sign * begin, sign * peak)
    last = Ramp(peak * fall, sign * peak, 0.0)
    between = length - (begin + peak) * first.seconds / 2 - peak * last.seconds / 2
    ramps.append(first)
    if between > _SAME and peak > 0:
        ramps.append(Ramp(between / peak, sign * peak, sign * peak))
    ramps.append(last)
    return tuple(ramps)
