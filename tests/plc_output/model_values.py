"""Which block is of which kind, and what its inputs may be: read off its declared names, so that both may change."""

from __future__ import annotations

import math
import random
import re
from collections.abc import Iterable, Mapping

KINDS = (
    ("MoveAbsolute", "absolute"),
    ("MoveRelative", "relative"),
    ("MoveVelocity.*", "velocity"),
    ("Home", "home"),
    ("RunPoint", "point"),
    ("JogPositive|JogOpen|JogForward", "jog_forward"),
    ("JogNegative|JogClose|JogBackward", "jog_backward"),
    ("Jog", "jog"),
    ("Stop", "stop"),
    ("Halt", "halt"),
    ("QuickStop|EmergencyStop|ImmediateStop", "quick_stop"),
    ("ServoOn|Power", "power_on"),
    ("ServoOff", "power_off"),
    ("ResetAlarm|Reset", "reset"),
    ("ReadPosition", "read"),
    ("RtuClient", "other"),
)
"""The kind of a block by its name, without the telegram in it. The names of all others are none of a model's."""
SCALES = {"esc11": 100.0}
"""Counts in the unit of an input that is a number with a point."""
INVALID = {"tc100": 101, "esc11": 101, "hiwin-e": -600000.0}
"""A speed that a device does not take."""
TOP_SPEEDS = {"tc100": 20000.0, "esc11": 5000.0, "hiwin-e": 20000.0}
"""Counts in a second at 100 percent."""
POSITION = re.compile(r"position|target(?!speed)", re.IGNORECASE)
DISTANCE = re.compile(r"distance", re.IGNORECASE)
SPEED = re.compile(r"speed|velocity", re.IGNORECASE)
PERCENT = re.compile(r"override|acceleration|deceleration", re.IGNORECASE)


def kinds(names: Iterable[str], telegram: int = 0) -> dict[str, str]:
    """The blocks of one device, or of one of its telegrams, with their kinds; another instance has a number after."""
    result = {}
    for name in names:
        bare = re.sub(r"Telegram(\d+)", "", name).split()[0]
        number = re.search(r"Telegram(\d+)", name)
        if (int(number[1]) if number else 0) != telegram:
            continue
        for pattern, kind in KINDS:
            if re.fullmatch(pattern, bare):
                result[name] = kind
                break
    return result


def fitting(device: str, kind: str, name: str, of: str, dice: random.Random) -> float | bool | None:
    """A value of an input that the device takes; None where it is none of those that change."""
    scale = SCALES.get(device, 1.0) if of == "lreal" else 1.0
    if "Window" in name:
        return 10 / SCALES.get(device, 1.0)
    if PERCENT.search(name):
        return dice.choice([50.0, 100.0]) if of == "lreal" else 100
    if SPEED.search(name):
        return _speed(device, kind, of, dice)
    if POSITION.search(name) and "point" not in name.lower():
        return _number(dice.randrange(-15, 16) * 100 / scale, of)
    if DISTANCE.search(name):
        return _number(dice.choice([-300, -100, 50, 100, 300]) / scale, of)
    if re.search(r"point", name, re.IGNORECASE) and of != "bool":
        return dice.randrange(1, 16)
    if re.search(r"direction", name, re.IGNORECASE):
        return dice.choice([0, 1])
    return None


def invalid(device: str, kind: str, name: str, of: str, dice: random.Random) -> float | None:
    """A value of an input that the device does not take; None where each value of the type is taken."""
    if PERCENT.search(name):
        return None
    no_number = dice.choice([math.nan, math.inf, -math.inf])
    if SPEED.search(name):
        refused = 1e9 if kind == "velocity" else INVALID.get(device)
        return no_number if of == "lreal" and dice.random() < 0.5 else refused
    if of == "lreal" and (POSITION.search(name) or DISTANCE.search(name)):
        return no_number
    return None


def value_of(device: str, block: str, kind: str, inputs: Mapping[tuple[str, str], float]) -> float | None:
    """The position or the distance that a block asks its device for, in counts; None where that is not a number."""
    if kind == "point":
        return _point_of(block, inputs)
    pattern = {"absolute": POSITION, "relative": DISTANCE}.get(kind)
    for (owner, name), value in inputs.items():
        if owner == block and pattern is not None and pattern.search(name):
            if not math.isfinite(value):
                return None
            return round(value * SCALES.get(device, 1.0) * 1e6) / 1e6
    return None


def speed_of(device: str, kind: str, block: str, inputs: Mapping[tuple[str, str], float]) -> float | None:
    """How fast a block asks its device to be, in counts in a second; None where it has no speed of its own.

    TC100 and ESC11 take percents [tc100 8.2 L1623, esc11 10.1 L1165], and begin slowly with 0; the CK10 takes counts,
    and the HIWIN E units in a minute [6.6.1 L1645], less by the override [6.6.1 L1648].
    """
    if kind == "velocity":
        return None
    numbers = {name: value for (owner, name), value in inputs.items() if owner == block and SPEED.search(name)}
    share = numbers.pop("SpeedOverride", 100.0) / 100
    speed = next(iter(numbers.values()), None)
    if speed is None or not math.isfinite(speed):
        return None
    if device == "hiwin-e":
        return min(TOP_SPEEDS[device], speed * share / 60)
    if device in TOP_SPEEDS:
        return TOP_SPEEDS[device] * speed / 100
    return speed


def _point_of(block: str, inputs: Mapping[tuple[str, str], float]) -> float | None:
    """The number of the point that a block asks for: an input of its own, or one a bit."""
    numbers = {name: value for (owner, name), value in inputs.items() if owner == block and "oint" in name}
    bits = {int(name.rsplit("Bit", 1)[1]): value for name, value in numbers.items() if re.search(r"Bit\d+$", name)}
    if bits:
        return float(sum(bool(value) << bit for bit, value in bits.items()))
    return next((float(value) for value in numbers.values()), None)


def position_of(device: str, block: str, outputs: Mapping[tuple[str, str], float]) -> float | None:
    """The position that a block shows, in counts."""
    places = {name: value for (owner, name), value in outputs.items() if owner == block and POSITION.search(name)}
    raw = [value for name, value in places.items() if name.endswith("Raw")]
    if raw:
        return float(raw[0])
    return next((value * SCALES.get(device, 1.0) for value in places.values()), None)


def _speed(device: str, kind: str, of: str, dice: random.Random) -> float:
    if kind == "velocity":
        return dice.choice([-60.0, 10.0, 60.0])
    if device == "hiwin-e":
        # In units a minute.
        return dice.choice([2000.0, 8000.0, 20000.0]) * 60
    return dice.choice([2000, 8000, 20000]) if of == "udint" else dice.choice([10, 40, 100])


def _number(value: float, of: str) -> float:
    return value if of == "lreal" else round(value)
