"""The blocks that command a speed or a torque are compiled and run against the simulator, telegram by telegram."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import ClassVar

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from loaded import programs
from rigs import NUMBER
from test_simulated_blocks import SPEEDS, SpeedRig, TelegramRig

TORQUES = [name for name, rig in SPEEDS.items() if "Torque" in rig.move]


@pytest.fixture(params=[*SPEEDS])
def speed(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> SpeedRig:
    """A drive with its servo on, whose reference speed is 3000/min."""
    rig = SPEEDS[request.param](programs(tmp_path_factory))
    rig.run(3)
    assert rig.done(block(rig, "ServoOn")) == "Done"
    torque = {"TorqueReduction": 25.0} if request.param in TORQUES else {}
    rig.bench.set(rig.move, Velocity=10.0, **torque)
    return rig


def block(rig: SpeedRig, task: str) -> str:
    """The block of a task for the telegram of a rig."""
    return next(name for name in rig.blocks if name.endswith(task))


def commanded(rig: TelegramRig, field: str, full_scale: int) -> float:
    """What the drive is sent, in percent."""
    request, data = rig.process_data.of("request"), rig.process_data
    percent: float = request[data.member(data.request, field)] * 100 / full_scale
    return percent


def commanded_speed(rig: SpeedRig) -> float:
    """The speed that the drive is sent, in percent."""
    return commanded(rig, "speed_setpoint_b", 2**30)


def commanded_reduction(rig: SpeedRig) -> float:
    """The reduction of torque that the drive is sent, in percent."""
    return commanded(rig, "torque_reduction", 2**14)


@pytest.mark.proof(2)
def test_a_drive_follows_the_speed_while_it_is_asked_to(speed: SpeedRig) -> None:
    speed.run(3, speed.move, Execute=True)
    assert not speed.bench.out[speed.move, "InVelocity"], "the drive has not begun to turn"
    speed.run(40)
    assert (commanded_speed(speed), speed.bench.out[speed.move, "InVelocity"]) == (pytest.approx(10.0), True)
    assert speed.device.engine.axis.speed(speed.device.unit.now) == pytest.approx(0.1 * 3000 / 60 * 10000)
    speed.run(1, speed.move, Velocity=-20.0)
    assert (commanded_speed(speed), speed.bench.out[speed.move, "InVelocity"]) == (pytest.approx(-20.0), False)
    assert speed.run(40).bench.out[speed.move, "InVelocity"]
    speed.run(3, speed.move, Execute=False)
    assert (commanded_speed(speed), speed.bench.ended(speed.move)) == (0.0, "Busy")
    assert not speed.run(60).device.motion.moving
    assert speed.bench.ended(speed.move) == ""


@pytest.mark.proof(4)
@pytest.mark.parametrize("end", ["alarm", "lost", "servo", "quick stop", "servo off", "refused"])
def test_whatever_ends_a_speed_takes_its_command_away(speed: SpeedRig, end: str) -> None:
    speed.run(40, speed.move, Execute=True)
    result = "CommandAborted"
    if end == "alarm":
        speed.device.alarm(1)
        result = f"Error {NUMBER['alarm']}"
    elif end == "lost":
        speed.lost = True
        result = f"Error {NUMBER['transport']}"
    elif end == "servo":
        speed.device.power_cycle()
        result = f"Error {NUMBER['servo']}"
    elif end == "quick stop":
        speed.bench.set(block(speed, "QuickStop"), Execute=True)
    elif end == "servo off":
        # The motion stays responsible until its axis stands, so it says itself why it has ended.
        speed.bench.set(block(speed, "ServoOff"), Execute=True)
        result = f"Error {NUMBER['servo']}"
    else:
        speed.bench.set(speed.move, Velocity=250.0)
        result = f"Error {NUMBER['request']}"
    speed.run(4)
    assert commanded_speed(speed) == 0.0
    assert not speed.bench.out[speed.move, "InVelocity"]
    speed.lost = False
    speed.run(600)
    assert speed.ended(speed.move) == result
    assert bool(speed.bench.out[speed.move, "Diagnostics"]) == (end == "refused")
    starts = len(speed.device.motion.starts)
    speed.run(60)
    assert (speed.device.motion.moving, len(speed.device.motion.starts)) == (False, starts)


def test_a_speed_that_is_withdrawn_at_once_is_never_commanded(speed: SpeedRig) -> None:
    speed.run(1, speed.move, Execute=True)
    for _ in range(5):
        speed.run(1, speed.move, Execute=False)
        assert commanded_speed(speed) == 0.0
    assert speed.device.motion.starts == []


def test_an_alarm_is_reset_without_a_motion(speed: SpeedRig) -> None:
    speed.device.alarm(1)
    speed.run(5)
    assert speed.done(block(speed, "ResetAlarm")) == "Done"
    speed.run(20)
    assert (speed.device.motion.moving, speed.device.motion.starts) == (False, [])


@pytest.mark.parametrize("speed", TORQUES, indirect=True)
def test_a_torque_is_reduced_without_a_motion(speed: SpeedRig) -> None:
    reduce = block(speed, "ReduceTorque")
    assert speed.done(reduce, TorqueReduction=40.0) == "Done"
    assert (commanded_reduction(speed), speed.device.motion.moving) == (pytest.approx(40.0, abs=0.01), False)
    for wrong in (-1.0, 120.0):
        assert speed.done(reduce, TorqueReduction=wrong) == f"Error {NUMBER['request']}"
        assert commanded_reduction(speed) == pytest.approx(40.0, abs=0.01)


@pytest.mark.parametrize("speed", TORQUES, indirect=True)
def test_a_reduction_of_torque_goes_with_the_speed_and_stays_after_it(speed: SpeedRig) -> None:
    speed.run(3, speed.move, Execute=True)
    assert commanded_reduction(speed) == pytest.approx(25.0)
    speed.run(2, speed.move, TorqueReduction=120.0)
    assert commanded_speed(speed) == 0.0
    assert speed.run(600).ended(speed.move) == f"Error {NUMBER['request']}"
    assert commanded_reduction(speed) == pytest.approx(25.0)


class LimitRig(TelegramRig):
    """The supplementary telegram 750, of which nothing moves."""

    message = "telegram_750"
    starting: ClassVar[dict[str, Sequence[str]]] = {}
    blocks = ("Telegram750LimitTorque",)


def test_torques_are_limited_in_both_directions(tmp_path_factory: pytest.TempPathFactory) -> None:
    rig, limit = LimitRig(programs(tmp_path_factory)), "Telegram750LimitTorque"

    def limits() -> list[float]:
        return [commanded(rig, f"{direction}_torque_limit", 2**14) for direction in ("positive", "negative")]

    rig.run(5, limit, Execute=True, PositiveTorqueLimit=60.0, NegativeTorqueLimit=-30.0)
    assert limits() == [0.0, 0.0], "no edge has been seen"
    assert rig.done(limit) == "Done"
    assert limits() == pytest.approx([60.0, -30.0], abs=0.01)
    for wrong in ({"PositiveTorqueLimit": 250.0}, {"NegativeTorqueLimit": -250.0}):
        assert rig.done(limit, **{"PositiveTorqueLimit": 10.0, "NegativeTorqueLimit": -10.0, **wrong}) == (
            f"Error {NUMBER['request']}"
        )
        assert limits() == pytest.approx([60.0, -30.0], abs=0.01)
    rig.lost = True
    assert rig.done(limit, PositiveTorqueLimit=10.0, NegativeTorqueLimit=-10.0) == f"Error {NUMBER['transport']}"
    assert limits() == pytest.approx([60.0, -30.0], abs=0.01)
