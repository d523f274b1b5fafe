"""What the records by hand of the monitors have in common."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from device_models.history import History

KINDS = {
    "Move": "absolute",
    "Other": "relative",
    "Third": "absolute",
    "Point": "point",
    "Home": "home",
    "Jog": "jog",
    "Stop": "stop",
    "Halt": "halt",
    "Speed": "velocity",
    "Power": "power_on",
    "Off": "power_off",
    "Reset": "reset",
    "Read": "read",
}
EDGE = "+Move.Execute +Move.Busy"
MOVES = "ask:start_absolute accepted:absolute:1:500 began:absolute:1:500 n1 v100"
JOGS = "ask:start_jog_forward accepted:jog_forward:1:1 began:jog_forward:1:1 n1 v100"
JOG_EDGE = "+Jog.JogForward +Jog.Busy"
POINT = "+Point.Execute +Point.Busy"
HOME = "+Home.Execute +Home.Busy"
HOMED = "reached:home:1 n0"
HOMES = "word:0C2F ask:start_home accepted:home:1 began:home:1 n1 v-100"
STOP = "+Stop.Execute +Stop.Busy"
MOVING = "began:absolute:1:500 w0 n1 v100"
STANDS = "reached:absolute:1:500 n0 v0 p500"
DONE = "-Move.Busy +Move.Done"
AWAY = "-Move.Execute -Move.Done"


@dataclass(frozen=True)
class Case:
    """A monitor, a record that keeps its rule, and one that breaks it."""

    monitor: Callable[[History], object]
    rule: int
    keeps: tuple[str, ...]
    breaks: tuple[str, ...]
