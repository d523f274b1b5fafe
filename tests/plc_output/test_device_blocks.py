"""The blocks for tasks are compiled and run against simulated devices: edges, aborts, alarms, lost frames, restarts."""

from __future__ import annotations

import os
import random
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from devices import Tc100, Telegram111
from loaded import programs
from rigs import NUMBER, RIGS, Axis

STEPS = int(os.environ.get("FIELDSPEC_RANDOM_STEPS", "3000"))


@pytest.fixture
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where compiled programs are kept."""
    return programs(tmp_path_factory)


@pytest.fixture(params=[*RIGS])
def axis(request: pytest.FixtureRequest, folder: Path) -> Axis:
    """Each device, with the servo on."""
    return Axis(request.param, folder)


@pytest.mark.proof(1)
def test_every_task_is_done(axis: Axis) -> None:
    rig = axis.rig
    assert rig.done(axis.block("Home")) == "Done"
    assert [rig.done(axis.absolute), rig.done(axis.relative)] == ["Done", "Done"]
    assert len(axis.starts) == 3
    for starts, direction in enumerate(("JogForward", "JogBackward"), len(rig.device.motion.starts) + 1):
        rig.run(40, axis.jog, **{direction: True})
        assert rig.ended(axis.jog) == "Busy"
        assert len(rig.device.motion.starts) == starts
        assert rig.run(30, axis.jog, **{direction: False}).device.motion.moving == 0
        assert rig.ended(axis.jog) == ""
    if "RunPoint" in rig.bench.blocks:
        assert rig.done("RunPoint") == "Done"
        assert axis.starts[-1].startswith(("point", "move_to_point"))
    assert rig.done(axis.block("Stop")) == "Done"
    assert rig.done(axis.block("ServoOff")) == "Done"


def test_a_block_for_tia_portal_does_the_same(folder: Path) -> None:
    axis = Axis("tc100", folder, "scl")
    assert [axis.rig.done("Home"), axis.rig.done(axis.absolute)] == ["Done", "Done"]
    axis.rig.device.alarm(3)
    assert axis.rig.done(axis.absolute) == f"Error {NUMBER['alarm']}"


def test_a_block_for_tia_portal_says_in_a_word_how_it_is(folder: Path) -> None:
    axis = Axis("tc100", folder, "scl")
    rig, block = axis.rig, axis.absolute

    def statuses(scans: int) -> list[int]:
        result = []
        for _ in range(scans):
            rig.scan()
            result.append(rig.bench.out[block, "Status"])
        return list(dict.fromkeys(result))

    assert rig.done("Home") == "Done"
    assert statuses(1) == [0x7000]
    rig.bench.set(block, Execute=True)
    assert statuses(400) == [0x7001, 0x7002, 0x0000]
    rig.bench.set(block, Execute=False)
    assert statuses(2) == [0x7000]
    rig.device.alarm(3)
    rig.bench.set(block, Execute=True)
    assert statuses(400) == [0x7001, 0x7002, 0x8400 + NUMBER["alarm"]]
    rig.bench.set(block, Execute=False)
    assert statuses(2) == [0x7000]
    rig.bench.set(block, Velocity=101, Execute=True)
    assert statuses(1) == [0x8200 + NUMBER["request"]]


def test_nothing_starts_in_the_first_scan_or_after_a_restart(axis: Axis) -> None:
    rig = axis.rig
    rig.bench.set(axis.absolute, Execute=True)
    rig.restart()
    rig.run(100)
    assert (axis.starts, rig.ended(axis.absolute)) == ([], "")


def test_an_alarm_while_moving_ends_the_block_and_its_reset_moves_nothing(axis: Axis) -> None:
    rig = axis.rig
    assert rig.done(axis.block("Home")) == "Done"
    rig.device.motion.starts.clear()
    rig.seen = 0
    rig.run(1, axis.absolute, Execute=True)
    while not axis.starts:
        rig.scan()
    rig.device.alarm(3)
    rig.run(60)
    assert rig.ended(axis.absolute) == f"Error {NUMBER['alarm']}"
    rig.done(axis.block("ServoOff"))
    assert rig.done(axis.block("ResetAlarm")) == "Done"
    assert rig.done(axis.block("ServoOn")) == "Done"
    rig.run(100)
    assert (len(axis.starts), rig.ended(axis.absolute)) == (1, f"Error {NUMBER['alarm']}")
    assert rig.done(axis.absolute) == "Done"


def test_a_servo_that_goes_off_is_an_error(axis: Axis) -> None:
    rig = axis.rig
    rig.run(1, axis.block("Home"), Execute=True)
    while not axis.starts:
        rig.scan()
    rig.device.power_cycle()
    if isinstance(rig.device, Telegram111):
        rig.device.obey(0)
        rig.bench.ports[rig.axis]["strequest"]["wcontrolword1"] = 0
    rig.run(100)
    assert rig.ended(axis.block("Home")) == f"Error {NUMBER['servo']}"
    assert len(axis.starts) == 1


def test_a_line_that_is_lost_is_an_error_with_its_number(axis: Axis) -> None:
    rig = axis.rig
    if rig.transport is not None:
        rig.transport.lost = True
        wanted = NUMBER["timeout"]
    else:
        rig.lost = True  # type: ignore[attr-defined]
        wanted = NUMBER["transport"]
    assert rig.done(axis.block("Home"), scans=2000) == f"Error {wanted}"
    assert axis.starts == []


def test_a_stop_ends_a_motion_and_locks_the_axis_until_its_input_falls(axis: Axis) -> None:
    rig = axis.rig
    assert rig.done(axis.block("Home")) == "Done"
    rig.run(1, axis.absolute, Execute=True)
    while len(axis.starts) < 2:
        rig.scan()
    rig.run(6)
    rig.run(1, axis.block("Stop"), Execute=True)
    # A motion that was not seen may begin for StartTime, which is 2 s.
    rig.run(300)
    assert rig.ended(axis.absolute) == "CommandAborted"
    assert (rig.ended(axis.block("Stop")), rig.device.motion.moving) == ("Done", 0)
    assert rig.done(axis.relative) == f"Error {NUMBER['locked']}"
    rig.run(30, axis.block("Stop"), Execute=False)
    assert len(axis.starts) == 2
    assert rig.done(axis.relative) == "Done"


def test_an_edge_while_a_block_is_busy_starts_it_again(axis: Axis) -> None:
    rig = axis.rig
    for scans in range(1, 12):
        rig.run(2, axis.block("Home"), Execute=False)
        rig.run(scans, axis.block("Home"), Execute=True)
        assert rig.ended(axis.block("Home")) == "Busy"
    rig.run(400, axis.block("Home"), Execute=False)
    assert rig.done(axis.block("Home")) == "Done"
    assert rig.done(axis.absolute) == "Done"


@pytest.mark.parametrize("name", ["tc100", "hiwin-e"])
def test_a_jog_ends_when_its_block_fails(name: str, folder: Path) -> None:
    axis = Axis(name, folder)
    rig = axis.rig
    rig.run(40, axis.jog, JogForward=True)
    assert rig.device.motion.moving
    if rig.transport is not None:
        rig.transport.lost = True
        rig.run(12)
        rig.transport.lost = False
    else:
        rig.lost = True  # type: ignore[attr-defined]
        rig.run(3)
        rig.lost = False  # type: ignore[attr-defined]
    rig.run(60)
    assert rig.device.motion.moving == 0
    assert rig.ended(axis.jog).startswith("Error")


def test_a_value_out_of_range_is_never_sent(folder: Path) -> None:
    axis = Axis("tc100", folder)
    writes = len(axis.rig.device.written)
    assert axis.rig.done(axis.absolute, Velocity=101) == f"Error {NUMBER['request']}"
    assert len(axis.rig.device.written) == writes


def test_a_command_that_the_device_does_not_carry_out_is_an_error(folder: Path) -> None:
    axis = Axis("tc100", folder)
    axis.rig.device._command = lambda command: axis.rig.device.words.update({Tc100.FAULT: 12})
    assert axis.rig.done(axis.absolute) == f"Error {NUMBER['exception']}"


def test_a_start_bit_that_a_failed_task_has_left_is_cleared_before_the_point_is_chosen(folder: Path) -> None:
    axis = Axis("tc100", folder)
    axis.rig.device.words[0x2040] = 1 << 3
    assert axis.rig.done("RunPoint", PointNumber=2) == "Done"
    chosen, started, *_ = [words[0] for address, words in axis.rig.device.written if address == 0x2040]
    assert (chosen, started) == (1 << 5, 1 << 5 | 1 << 3)
    assert axis.starts == ["point 2"]


def test_an_exception_response_is_an_error(folder: Path) -> None:
    axis = Axis("tc100", folder)
    axis.rig.device.refusing = True
    assert axis.rig.done("Home") == f"Error {NUMBER['exception']}"


def test_a_move_before_homing_is_refused_and_does_not_begin_later(folder: Path) -> None:
    axis = Axis("hiwin-e", folder)
    axis.rig.device.motion.homed = False
    assert axis.rig.done(axis.absolute) == f"Error {NUMBER['unready']}"
    axis.rig.bench.set(axis.absolute, Execute=True)
    axis.rig.run(3)
    assert axis.rig.done("Telegram111Home") == "Done"
    axis.rig.run(60)
    assert axis.starts == ["home"]


def test_a_reset_of_an_alarm_leaves_the_drive_switched_off(folder: Path) -> None:
    axis = Axis("hiwin-e", folder)
    axis.rig.device.alarm(1)
    axis.rig.run(5)
    assert axis.rig.done("Telegram111ResetAlarm") == "Done"
    axis.rig.run(50)
    assert not axis.rig.device.operation


@pytest.mark.parametrize("name", [*RIGS])
def test_a_position_is_valid_while_it_is_read(name: str, folder: Path) -> None:
    axis = Axis(name, folder)
    block = axis.block("ReadPosition")
    rig = axis.rig
    rig.run(20, block, Enable=True)
    assert (rig.bench.out[block, "Valid"], rig.bench.out[block, "Error"]) == (True, False)
    if name == "esc11":
        rig.device.motion.position = 12345
        rig.run(20)
        assert rig.bench.out[block, "Position"] == pytest.approx(123.45)
        assert rig.bench.out[block, "PositionRaw"] == 12345
    rig.run(1, block, Enable=False)
    assert not rig.bench.out[block, "Valid"]
    assert not rig.bench.out[block, "Busy"]


@pytest.mark.proof(1)
@pytest.mark.parametrize("name", [*RIGS])
def test_nothing_starts_without_an_edge_whatever_happens(name: str, folder: Path) -> None:
    axis = Axis(name, folder)
    rig, dice, ended = axis.rig, random.Random(7), 0
    starts = [key for key in rig.bench.inputs if key[0] in rig.bench.blocks and key[1] in rig.STARTS]
    for _ in range(STEPS):
        chance = dice.random()
        if chance < 0.08:
            block, start = dice.choice(starts)
            rig.bench.set(block, **{start: not rig.bench.now[block, start]})
        elif 0.2 < chance < 0.4:
            # A stop that is asked for all the time would let nothing move.
            for stop in (block for block, _ in starts if block.endswith("Stop")):
                rig.bench.set(stop, Execute=False)
        elif chance < 0.088:
            rig.device.alarm(dice.choice([0, 3]))
        elif chance < 0.0885:
            rig.device.power_cycle()
        elif chance < 0.089:
            rig.restart()
        if rig.transport is not None:
            rig.transport.lost = 0.09 < chance < 0.1
            rig.transport.swallowed = 0.1 < chance < 0.11
        else:
            rig.lost = 0.09 < chance < 0.095  # type: ignore[attr-defined]
        rig.scan()
        ended += sum(rig.bench.ended(block) == "Done" for block, _ in starts)
    assert ended
    assert axis.starts
