"""What a block says whose motion something else than its own command stops, against the models of the manuals."""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from loaded import programs
from model_scenes import (
    FRAMED,
    POSITIONING,
    broken,
    jogging,
    place,
    ready,
    speed_input,
    until_moving,
    value_input,
)

from device_models.ck10 import POINT_WORDS, POINTS


@pytest.fixture
def make(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Any]:
    """Makes the rig of a scene."""
    return partial(ready, programs(tmp_path_factory))


def to_a_point(rig: Any) -> str:
    """Starts a run to a point that is far away, and waits until the axis moves; gives the name of the block."""
    block: str = rig.block("point")
    rig.model.words.update({POINTS + 6 * POINT_WORDS + 1: 20000, POINTS + 6 * POINT_WORDS + 5: 2000})
    rig.start(block, PointNumber=6)
    until_moving(rig)
    rig.run(10)
    return block


@pytest.mark.proof(2)
@pytest.mark.parametrize("kind", ["point", "home"])
@pytest.mark.parametrize("reset", [False, True], ids=["that stands", "that is reset"])
def test_an_emergency_stop_that_is_shown_is_an_error(kind: str, reset: bool, make: Callable[..., Any]) -> None:
    rig = make("ck10", outside="emergency stop")
    block = rig.block(kind)
    if kind == "point":
        to_a_point(rig)
    else:
        rig.start(block)
        until_moving(rig)
    rig.model.stop_outside()
    if reset:
        rig.run(30)
        rig.start(rig.block("reset"))
    rig.run(1500)
    assert rig.ended(block) == "Error 8"
    assert broken(rig, 34, 37) == []


def test_a_point_is_done_where_a_reset_ends_an_emergency_stop_before_it_is_seen(make: Callable[..., Any]) -> None:
    rig = make("ck10", outside="emergency stop")
    block = to_a_point(rig)
    rig.model.stop_outside()
    rig.start(rig.block("reset"))
    rig.run(1500)
    assert rig.ended(block) == "Done"
    assert broken(rig, 37) == []


def test_the_servo_is_on_in_an_emergency_stop(make: Callable[..., Any]) -> None:
    rig = make("ck10", outside="emergency stop")
    rig.model.stop_outside()
    assert rig.finish(rig.block("power_on")) == "Done"


def test_nothing_moves_from_an_emergency_stop_to_its_reset(make: Callable[..., Any]) -> None:
    rig = make("ck10", outside="emergency stop")
    rig.model.stop_outside()
    assert rig.finish(rig.block("relative")) == "Error 8"
    assert rig.finish(rig.block("reset")) == "Done"
    assert rig.finish(rig.block("relative")) == "Done"


@pytest.mark.parametrize("name", [item for item in POSITIONING if item not in FRAMED])
@pytest.mark.parametrize("kind", ["stop", "quick_stop", "halt"])
@pytest.mark.parametrize("scans", [1, 2, 40])
def test_a_stop_that_no_telegram_carries_answers_for_the_axis(
    name: str, kind: str, scans: int, make: Callable[..., Any]
) -> None:
    rig = make(name)
    jogging(rig)
    stop = rig.block(kind)
    rig.start(stop)
    rig.lost = rig.unheard = True
    for _ in range(scans):
        rig.scan(10, [stop, *(block for block in rig.names if block != stop)])
        assert rig.ended(stop) == "Busy"
    assert rig.model.state.velocity != 0
    rig.lost = rig.unheard = False
    rig.run(100)
    assert rig.model.state.velocity == 0
    assert broken(rig, 15, 16, 20, 23, 30) == []


@pytest.mark.parametrize(
    ("refusal", "end"), [("command error", "Error 13"), ("alarm", "Error 8"), ("number alone", "Error 13")]
)
def test_a_jog_that_the_device_refuses_ends_though_its_input_is_held(
    refusal: str, end: str, make: Callable[..., Any]
) -> None:
    rig = make("esc11", home=False, refusal=refusal)
    block = next(block for block, kind in rig.kinds.items() if kind == "jog")
    rig.start(block)
    rig.run(600)
    assert rig.ended(block) == end
    assert broken(rig, 17, 30) == []


def test_a_jog_that_has_reached_the_end_of_the_stroke_is_busy_until_its_input_falls(make: Callable[..., Any]) -> None:
    rig = make("esc11")
    block = jogging(rig)
    rig.run(3000)
    assert (rig.model.state.velocity, rig.ended(block)) == (0, "Busy")
    rig.start(block, False)
    rig.run(400)
    assert rig.ended(block) == ""
    assert broken(rig, 30) == []


@pytest.mark.proof(3)
@pytest.mark.parametrize("name", POSITIONING)
@pytest.mark.parametrize("kind", ["absolute", "home", "relative"])
def test_what_is_stopped_from_outside_is_not_done(name: str, kind: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    block = rig.block(kind)
    if kind != "home":
        slow = {"tc100": 10, "ck10": 2000, "esc11": 10}.get(name, 120000.0)
        rig.set(block, **{value_input(rig, block): place(name, 1900), speed_input(rig, block): slow})
    rig.start(block)
    until_moving(rig)
    rig.model.stop_outside()
    rig.run(7000)
    assert rig.ended(block).startswith("Error")
    assert broken(rig, 34, 37) == []
