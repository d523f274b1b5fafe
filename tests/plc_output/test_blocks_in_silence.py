"""Blocks whose device is silent, or does later what it was asked for before: scenes against models of the manuals."""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from loaded import programs
from model_scenes import FRAMED, POSITIONING, broken, jogging, ready, set_out

LIMIT = 900
"""Scans of 10 ms: a time-out of each try to send, of the reads and of three stops, and again as much."""


@pytest.fixture
def make(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Any]:
    """Makes the rig of a scene."""
    return partial(ready, programs(tmp_path_factory))


@pytest.mark.proof(3)
@pytest.mark.parametrize("name", FRAMED)
@pytest.mark.parametrize("kind", ["absolute", "relative", "home", "power_off", "reset", "read"])
def test_who_gets_no_answer_says_so_in_a_bounded_time(name: str, kind: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    rig.line.silent = True
    rig.start(rig.block(kind))
    rig.run(LIMIT)
    assert rig.ended(rig.block(kind)) == "Error 2"


@pytest.mark.parametrize("name", FRAMED)
def test_a_moving_axis_is_asked_to_stop_three_times_where_nothing_answers(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    block = set_out(rig, name, 9000 if name == "esc11" else 90000)
    rig.line.silent, before = True, len(rig.record)
    rig.run(LIMIT)
    assert rig.ended(block) == "Error 2"
    assert [text for scan in rig.record[before:] for text in scan.asked].count("stop") >= 3


@pytest.mark.parametrize("name", [item for item in POSITIONING if item not in FRAMED])
def test_who_gets_no_telegrams_says_so_in_a_bounded_time(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    block = set_out(rig, name, 90000)
    rig.lost = True
    rig.run(LIMIT)
    assert rig.ended(block) == "Error 7"


@pytest.mark.parametrize("name", FRAMED)
def test_a_jog_is_asked_to_stop_three_times_where_nothing_answers(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    jog = jogging(rig)
    rig.line.silent, before = True, len(rig.record)
    rig.start(jog, False)
    rig.run(LIMIT)
    assert [text for scan in rig.record[before:] for text in scan.asked].count("stop") >= 3
    assert broken(rig, 15, 29, 30) == []


@pytest.mark.proof(4)
@pytest.mark.parametrize("name", POSITIONING)
@pytest.mark.parametrize("kind", ["stop", "halt"])
def test_a_motion_that_begins_after_its_stop_has_somebody_responsible(
    name: str, kind: str, make: Callable[..., Any]
) -> None:
    rig = make(name, delay=0.8, late_start="goes on")
    move = rig.block("relative")
    rig.start(move)
    rig.run(30)
    rig.start(rig.block(kind))
    rig.run(1)
    rig.start(rig.block(kind), False)
    rig.run(400)
    assert broken(rig, 15, 24) == []


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", POSITIONING)
@pytest.mark.parametrize("stopped", [False, True], ids=["", "stopped"])
def test_a_jog_that_begins_after_its_end_was_asked_for_comes_to_a_halt(
    name: str, stopped: bool, make: Callable[..., Any]
) -> None:
    rig = make(name, delay=0.8, late_start="goes on")
    jog, stop = rig.block("jog"), rig.block("stop")
    rig.start(jog)
    while not rig.model.state.waiting and len(rig.record) < 2000:
        rig.scan()
    rig.run(5)
    rig.start(stop, stopped)
    rig.run(1)
    rig.start(stop, False)
    rig.start(jog, False)
    rig.run(1500)
    assert rig.model.state.velocity == 0
    assert broken(rig, 15, 24, 29, 30) == []


@pytest.mark.proof(3)
@pytest.mark.parametrize("name", POSITIONING)
@pytest.mark.parametrize("release", ["both", "none", "other"])
def test_a_jog_that_begins_late_is_stopped_again_where_its_input_falls_again(
    name: str, release: str, make: Callable[..., Any]
) -> None:
    begin = {"moving": "from begin", "executing": "from begin", "stopped": "begin"}
    rig = make(name, delay=1.5, late_start="goes on", **begin)
    jog = rig.block("jog")
    rig.start(jog)
    while not rig.model.state.waiting and len(rig.record) < 2000:
        rig.scan()
    rig.run(5)
    rig.start(jog, False)
    rig.run(1)
    rig.start(jog)
    while not rig.model.state.velocity and len(rig.record) < 4000 and rig.model.state.waiting:
        rig.scan()
    rig.run(20)
    rig.set(jog, JogForward=release == "both", JogBackward=release != "none")
    rig.run(200)
    rig.set(jog, JogForward=False, JogBackward=False)
    rig.run(1500)
    assert rig.model.state.velocity == 0
    assert broken(rig, 15, 29, 30, 31) == []
