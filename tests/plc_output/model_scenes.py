"""What the scenes of blocks against models have in common: a rig that is ready, a move and a jog that have begun."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from model_rigs import rig

from device_models.draws import calm
from device_models.monitors import violations

FRAMED = ("tc100", "ck10", "esc11")
POSITIONING = (*FRAMED, "hiwin-e 9", "hiwin-e 111")
SPEEDS = ("hiwin-e 3", "hiwin-e 102")
CALM = {
    "servo": "off",
    "excitation": "off",
    "homing": "needed",
    "busy command": "taken",
    "in position": "target",
    "outside": "software",
    "late start": "cancelled",
    "no control": "zeros",
}
"""How the models of the scenes read what the manuals leave open, where a scene says nothing else."""


def ready(
    folder: Path,
    name: str,
    power: bool = True,
    home: bool = True,
    delay: float = 0.0,
    twice: bool = False,
    **readings: str,
) -> Any:
    """A rig whose servo is on and whose axis is at home, unless a scene wants it otherwise.

    Readings of the manual have their names with underscores. Each motion begins `delay` seconds after its command.
    """
    draws = calm(**{key.replace("_", " "): value for key, value in {**CALM, **readings}.items()})
    result = rig(name, folder, draws, twice)
    result.run(3)
    if power:
        assert result.finish(result.block("power_on")) == "Done"
    if power and home and name not in SPEEDS:
        assert result.finish(result.block("home")) == "Done"
    draws.delay = delay
    return result


def place(name: str, counts: float) -> float:
    """A position as the input of a block has it."""
    return counts / 100 if name == "esc11" else counts


def value_input(rig: Any, block: str) -> str:
    """The input that says where a block moves to, or how far."""
    words = ("osition", "istance")
    return next(name for owner, name in rig.bench.inputs if owner == block and any(word in name for word in words))


def speed_input(rig: Any, block: str) -> str:
    """The input that says how fast."""
    return next(name for owner, name in rig.bench.inputs if owner == block and ("peed" in name or "elocity" in name))


def set_out(rig: Any, name: str, counts: float, slow: bool = True) -> str:
    """Starts an absolute move and waits until the axis moves; gives the name of the block."""
    block: str = rig.block("absolute")
    speeds = {"tc100": 10, "ck10": 2000, "esc11": 10}
    speed = speeds.get(name, 2000.0 * 60) if slow else rig.bench.now[block, speed_input(rig, block)]
    rig.start(block, False, **{value_input(rig, block): place(name, counts), speed_input(rig, block): speed})
    rig.run(2)
    rig.start(block)
    until_moving(rig)
    return block


def until_moving(rig: Any) -> None:
    """Lets scans pass until the axis moves."""
    for _ in range(1000):
        rig.scan()
        if rig.model.state.velocity:
            return
    raise AssertionError("it does not begin to move")


def jogging(rig: Any) -> str:
    """Starts a jog and waits until the axis moves; gives the name of the block."""
    block: str = next(block for block, kind in rig.kinds.items() if kind.startswith("jog"))
    rig.start(block)
    until_moving(rig)
    rig.run(20)
    return block


def broken(rig: Any, *rules: int) -> list[str]:
    """The violations of some rules in what was recorded."""
    return [str(item) for item in violations(rig.history) if item.rule in rules]
