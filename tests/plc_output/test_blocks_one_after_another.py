"""Blocks that move an axis while another one does, against the models of the manuals."""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from loaded import programs
from model_scenes import FRAMED, POSITIONING, broken, jogging, ready, set_out, until_moving


@pytest.fixture
def make(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Any]:
    """Makes the rig of a scene."""
    return partial(ready, programs(tmp_path_factory))


@pytest.mark.proof(6)
@pytest.mark.parametrize("name", [item for item in POSITIONING if item != "tc100"])
@pytest.mark.parametrize("kind", ["home", "jog"])
@pytest.mark.parametrize("calls_last", [False, True], ids=["called first", "called last"])
def test_what_shows_no_acceptance_waits_for_no_motion_of_another(
    name: str, kind: str, calls_last: bool, make: Callable[..., Any]
) -> None:
    late = {"moving": "from begin", "executing": "from begin", "target reached": "begin", "stopped": "begin"}
    rig = make(name, delay=1.0, **late)
    move, other = rig.block("relative"), rig.block(kind)
    rig.names.sort(key=lambda block: (block == other) == calls_last)
    rig.start(move)
    for _ in range(1000):
        rig.scan(10, rig.names)
        if rig.model.state.waiting:
            break
    assert rig.model.state.waiting
    rig.run(10)
    rig.start(other)
    rig.run(1000)
    assert (rig.ended(move), rig.ended(other)) == ("Done", "Error 11")
    assert broken(rig, 15, 16, 17, 20, 34, 37) == []


@pytest.mark.parametrize("name", FRAMED)
def test_a_successor_that_is_superseded_by_a_halt_is_aborted(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    block = set_out(rig, name, 1900)
    rig.start(block, False)
    rig.run(2)
    rig.start(block)
    rig.run(1)
    rig.start(rig.block("halt"))
    rig.run(400)
    assert (rig.ended(block), rig.ended(rig.block("halt"))) == ("CommandAborted", "Done")
    assert broken(rig, 15, 16, 20) == []


@pytest.mark.parametrize(("name", "answer"), [("tc100", "Busy"), ("ck10", "Error 11"), ("esc11", "Error 11")])
def test_an_edge_of_a_jog_behind_the_scan_in_which_it_was_aborted_is_taken(
    name: str, answer: str, make: Callable[..., Any]
) -> None:
    rig = make(name)
    jog = jogging(rig)
    rig.start(rig.block("halt"))
    rig.start(jog, False)
    for _ in range(300):
        rig.run(1)
        if rig.ended(jog) != "Busy":
            break
    assert rig.ended(jog) == "CommandAborted"
    rig.start(jog)
    rig.run(1)
    assert (rig.ended(jog), broken(rig, 2)) == (answer, [])


@pytest.mark.parametrize("name", POSITIONING)
def test_an_edge_in_the_scan_in_which_another_has_the_axis_is_taken(name: str, make: Callable[..., Any]) -> None:
    scans, edge = 0, -1
    # The first run tells the scan of the edge in the second one.
    for _ in range(2):
        rig = make(name)
        block = set_out(rig, name, 1900)
        rig.start(block, False)
        rig.run(2)
        rig.start(block)
        rig.run(1)
        rig.start(rig.block("halt"))
        rig.start(block, False)
        for scans in range(300):
            if scans == edge:
                rig.start(block)
                rig.start(rig.block("stop"))
            rig.run(1)
            if scans == edge or rig.ended(block) != "Busy":
                break
        edge = scans
    rig.start(block, False)
    rig.run(100)
    assert broken(rig, 2, 3, 7, 11) == []


@pytest.mark.parametrize("name", ["hiwin-e 9", "hiwin-e 111"])
def test_a_move_waits_for_the_end_of_a_jog_whose_acceptance_is_not_shown(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    jog, move = jogging(rig), rig.block("absolute")
    assert rig.finish(move) == "Error 11"
    assert rig.ended(jog) == "Busy"
    rig.start(jog, False)
    rig.run(300)
    assert (rig.ended(jog), rig.finish(move)) == ("", "Done")


@pytest.mark.parametrize("name", ["hiwin-e 3", "hiwin-e 9", "hiwin-e 102", "hiwin-e 111"])
@pytest.mark.parametrize("kind", ["quick_stop", "power_off"])
def test_a_drive_hears_a_stop_after_a_restart_of_the_controller(name: str, kind: str, make: Callable[..., Any]) -> None:
    rig = make(name, home=False, no_control="stays")
    rig.restart()
    rig.run(10)
    assert rig.model.state.servo
    assert rig.finish(rig.block(kind), limit=5.0) == "Done"
    assert not rig.model.state.servo


@pytest.mark.parametrize("name", ["hiwin-e 3", "hiwin-e 9", "hiwin-e 102", "hiwin-e 111"])
@pytest.mark.parametrize("reading", ["stays", "zeros"])
def test_a_drive_hears_a_reset_after_a_restart_of_the_controller(
    name: str, reading: str, make: Callable[..., Any]
) -> None:
    rig = make(name, home=False, no_control=reading)
    rig.model.set_alarm(3)
    rig.model.set_alarm(0)
    rig.restart()
    rig.run(10)
    assert rig.model.state.alarm
    assert rig.finish(rig.block("reset"), limit=5.0) == "Done"
    assert not rig.model.state.servo
    assert rig.finish(rig.block("power_on"), limit=5.0) == "Done"


@pytest.mark.parametrize("kind", ["home", "absolute", "jog"])
def test_a_point_that_the_end_of_another_command_stops_is_aborted(kind: str, make: Callable[..., Any]) -> None:
    rig = make("tc100")
    point, other = rig.block("point"), rig.block(kind)
    rig.start(point, PointNumber=32)
    until_moving(rig)
    rig.run(20)
    send = rig.line.send

    def lose(request: bytes) -> Any:
        rig.line.fates = ["lost answer"] * rig.model.meaning(request).startswith("start")
        return send(request)

    rig.line.send = lose
    rig.start(other)
    rig.run(600)
    assert (rig.ended(point), rig.ended(other)) == ("CommandAborted", "Error 2")
    assert broken(rig, 15, 16, 17, 20, 37) == []


@pytest.mark.parametrize("alarm", [0, 3])
def test_a_home_that_is_to_begin_again_is_aborted_by_a_halt(alarm: int, make: Callable[..., Any]) -> None:
    rig = make("ck10")
    home, halt = rig.block("home"), rig.block("halt")
    rig.start(home)
    until_moving(rig)
    rig.start(home, False)
    rig.run(1)
    rig.start(home)
    for _ in range(30):
        rig.run(1)
        if "stop" in rig.asked:
            break
    rig.model.set_alarm(alarm)
    rig.start(halt)
    for _ in range(3000):
        rig.run(1)
        if rig.ended(home) != "Busy":
            break
    assert rig.ended(home) == "CommandAborted"
    assert broken(rig, 17, 20, 33) == []
