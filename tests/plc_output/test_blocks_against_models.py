"""The blocks that move an axis, against models that are written from the manuals and know nothing of the specs.

Each test is a scene.
"""

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
    SPEEDS,
    broken,
    jogging,
    place,
    ready,
    set_out,
    until_moving,
    value_input,
)


@pytest.fixture
def make(tmp_path_factory: pytest.TempPathFactory) -> Callable[..., Any]:
    """Makes the rig of a scene."""
    return partial(ready, programs(tmp_path_factory))


# Every task works against the model: what fails below is not for a rig that does nothing.


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", POSITIONING)
def test_every_task_is_done_with_a_calm_device(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    for kind in ("absolute", "relative", "point"):
        if kind in rig.kinds.values():
            assert rig.finish(rig.block(kind)) == "Done"
    block = jogging(rig)
    rig.start(block, False)
    rig.run(
        400
    )  # a jog that was not seen to move is Busy until the axis has stood for StartTime, 2 s, and one poll more
    assert (rig.model.state.velocity, rig.ended(block)) == (0, "")
    assert [rig.finish(rig.block(kind)) for kind in ("stop", "power_off")] == ["Done", "Done"]


# An answer of another station is not an answer.


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", FRAMED)
def test_a_position_of_another_station_is_never_valid(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    rig.start(rig.block("read"))
    rig.line.fates = ["foreign"] * 40
    rig.run(1000)
    assert broken(rig, 39) == []


@pytest.mark.parametrize("name", FRAMED)
def test_an_answer_to_the_request_before_is_never_a_position(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    rig.start(rig.block("read"))
    other = rig.block("power_on")
    for _ in range(10):
        rig.line.fates = ["late"]
        rig.start(other, False)
        rig.run(10)
        rig.start(other)
        rig.run(150)
    assert broken(rig, 39) == []


# A jog stops itself.


@pytest.mark.proof(3)
@pytest.mark.parametrize("name", FRAMED)
@pytest.mark.parametrize("abort", [False, True], ids=["", "aborted"])
def test_a_jog_does_not_run_away_when_its_successor_is_refused(
    name: str, abort: bool, make: Callable[..., Any]
) -> None:
    rig = make(name, busy_command="refused")
    jog, move = jogging(rig), rig.block("absolute")
    if (move, "Abort") in rig.bench.inputs:
        rig.set(move, Abort=abort)
    rig.start(move)
    rig.run(20)
    rig.start(move, False)
    rig.run(100)
    rig.start(jog, False)
    rig.run(1000)
    assert rig.model.state.velocity == 0
    assert broken(rig, 15, 16, 20, 30) == []


@pytest.mark.parametrize("name", FRAMED)
def test_a_jog_whose_stop_is_lost_asks_again(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    jog = jogging(rig)
    rig.line.fates = ["lost request"] * 2
    rig.start(jog, False)
    rig.run(1000)
    assert rig.model.state.velocity == 0


# A stop stops, whatever the line does.


@pytest.mark.parametrize("name", [item for item in POSITIONING if item not in FRAMED])
@pytest.mark.parametrize("kind", ["stop", "quick_stop", "power_off"])
@pytest.mark.parametrize("scans", [0, 1, 2])
def test_an_invalid_telegram_swallows_no_stop(name: str, kind: str, scans: int, make: Callable[..., Any]) -> None:
    rig = make(name)
    set_out(rig, name, 9000)
    rig.start(rig.block(kind))
    rig.run(scans)
    rig.lost = True
    rig.run(1)
    rig.lost = False
    rig.run(100)
    assert rig.model.state.velocity == 0
    assert broken(rig, 15, 23) == []


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", SPEEDS)
@pytest.mark.parametrize("kind", ["quick_stop", "power_off"])
def test_an_invalid_telegram_swallows_no_quick_stop_of_a_speed(name: str, kind: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    rig.start(rig.block("velocity"))
    until_moving(rig)
    rig.start(rig.block(kind))
    rig.lost = True
    rig.run(1)
    rig.lost = False
    rig.run(100)
    assert rig.model.state.velocity == 0


@pytest.mark.parametrize("name", FRAMED)
def test_a_stop_whose_answer_is_lost_is_sent_again(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    set_out(rig, name, 1900)
    rig.line.fates = ["good", "lost request", "lost request"]
    rig.start(rig.block("stop"))
    rig.run(400)
    assert rig.model.state.velocity == 0
    assert broken(rig, 15, 23) == []


@pytest.mark.parametrize("name", POSITIONING)
def test_a_stop_is_done_when_the_axis_stands(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    set_out(rig, name, 1900 if name == "esc11" else 9000, slow=False)
    rig.run(20)
    rig.start(rig.block("stop"))
    rig.run(800, milliseconds=5)  # a stop is Busy as long
    assert rig.ended(rig.block("stop")).startswith("Done")
    assert broken(rig, 15, 24) == []


# Done is proven.


@pytest.mark.parametrize("refusal", ["command error", "alarm", "number alone"])
def test_a_gripper_without_a_home_is_not_done(refusal: str, make: Callable[..., Any]) -> None:
    rig = make("esc11", home=False, refusal=refusal)
    assert rig.finish(rig.block("absolute"), Position=10.0).startswith("Error")


@pytest.mark.parametrize("refusal", ["command error", "alarm", "number alone"])
def test_a_gripper_is_not_done_at_a_place_that_it_cannot_reach(refusal: str, make: Callable[..., Any]) -> None:
    rig = make("esc11", refusal=refusal)
    assert rig.finish(rig.block("absolute"), Position=900.0).startswith("Error")


@pytest.mark.proof(11)
@pytest.mark.parametrize("name", POSITIONING)
@pytest.mark.parametrize("delay", [0.38, 1.0])
@pytest.mark.parametrize("kind", ["absolute", "relative", "home"])
def test_what_begins_late_is_not_done_early(name: str, delay: float, kind: str, make: Callable[..., Any]) -> None:
    late = {"moving": "from begin", "executing": "from begin", "target reached": "begin", "stopped": "begin"}
    late |= {"homed bit": "falls"} if name.startswith("hiwin") else {}
    rig = make(name, delay=delay, **late)
    rig.finish(rig.block(kind))
    assert broken(rig, 34, 37) == []


# Power comes at the first try.


@pytest.mark.parametrize("name", [item for item in (*POSITIONING, *SPEEDS) if item not in FRAMED])
def test_the_servo_is_on_at_the_first_try_after_a_quick_stop(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    assert rig.finish(rig.block("quick_stop")) == "Done"
    assert rig.finish(rig.block("power_on"), limit=5.0) == "Done"


@pytest.mark.parametrize("name", [item for item in (*POSITIONING, *SPEEDS) if item not in FRAMED])
def test_the_servo_is_on_at_the_first_try_after_an_alarm(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    rig.model.set_alarm(3)
    rig.run(10)
    rig.model.set_alarm(0)
    assert rig.finish(rig.block("reset"), limit=5.0) == "Done"
    assert rig.finish(rig.block("power_on"), limit=5.0) == "Done"


# Who moves the axis is responsible for it.


@pytest.mark.parametrize("name", FRAMED)
def test_a_successor_that_is_refused_leaves_somebody_responsible(name: str, make: Callable[..., Any]) -> None:
    rig = make(name, busy_command="refused")
    set_out(rig, name, 1900)
    rig.start(rig.block("relative"))
    rig.run(1500)
    assert rig.ended(rig.block("relative")).startswith("Error")
    assert broken(rig, 15, 16, 17, 20) == []


# A stop locks the axis.


@pytest.mark.proof(4)
@pytest.mark.parametrize("name", POSITIONING)
@pytest.mark.parametrize("kind", ["absolute", "relative", "home", "jog"])
def test_nothing_moves_while_a_stop_is_asked_for(name: str, kind: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    block = next(block for block, of in rig.kinds.items() if of.startswith(kind))
    rig.start(rig.block("stop"))
    rig.run(300)
    assert rig.ended(rig.block("stop")).startswith("Done")
    rig.start(block)
    rig.run(300)
    assert (rig.ended(block)[:5], rig.ended(rig.block("stop"))[:4]) == ("Error", "Done")
    rig.start(rig.block("stop"), False)
    rig.run(300)
    assert broken(rig, 13, 25, 27) == []


@pytest.mark.parametrize("name", POSITIONING)
def test_a_move_does_not_abort_a_stop(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    set_out(rig, name, 1900 if name == "esc11" else 9000, slow=False)
    stop, other = rig.block("stop"), rig.block("relative")
    rig.start(stop)
    rig.run(1)
    rig.start(other)
    rig.run(400)
    assert (rig.ended(stop)[:4], rig.ended(other)[:5]) == ("Done", "Error")
    assert broken(rig, 15, 25, 27) == []


@pytest.mark.parametrize("name", POSITIONING)
def test_a_halt_gives_the_axis_to_the_next_move(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    set_out(rig, name, 1900)
    assert "halt" in rig.kinds.values()
    rig.start(rig.block("halt"))
    rig.run(400)
    assert (rig.ended(rig.block("halt")), rig.model.state.velocity) == ("Done", 0)
    assert rig.finish(rig.block("relative")) == "Done"


@pytest.mark.parametrize("name", POSITIONING)
def test_a_jog_has_two_directions_and_is_busy_until_it_stands(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    assert "jog" in rig.kinds.values()
    jog = rig.block("jog")
    assert {(jog, "JogForward"), (jog, "JogBackward")} <= set(rig.bench.inputs)
    for name_of_input in ("JogForward", "JogBackward"):
        rig.set(jog, **{name_of_input: True})
        until_moving(rig)
        rig.set(jog, **{name_of_input: False})
        rig.run(400)
        assert (rig.model.state.velocity, rig.ended(jog)) == (0, "")
    rig.set(jog, JogForward=True, JogBackward=True)
    rig.run(600)
    assert rig.model.state.velocity == 0
    assert broken(rig, 15, 29, 30, 31) == []


# An edge is never lost.


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", POSITIONING)
def test_an_edge_while_it_is_busy_is_taken_or_refused(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    block = set_out(rig, name, 1000)
    rig.start(block, False, **{value_input(rig, block): place(name, 1900)})
    rig.run(2)
    rig.start(block)
    rig.run(3000)
    assert rig.ended(block)[:5] in ("Done", "Error")
    assert broken(rig, 9, 10, 11, 37) == []


@pytest.mark.parametrize("name", POSITIONING)
def test_a_block_that_reads_recovers_while_it_is_enabled(name: str, make: Callable[..., Any]) -> None:
    rig = make(name)
    block = rig.block("read")
    rig.start(block)
    rig.run(100)
    assert rig.bench.out[block, "Valid"]
    if name in FRAMED:
        rig.line.fates = ["lost answer"] * 9
    else:
        rig.lost = True
    for _ in range(2000):
        if not rig.bench.out[block, "Valid"]:
            break
        rig.scan()
    assert not rig.bench.out[block, "Valid"]
    if name not in FRAMED:
        rig.lost = False
    rig.run(1200)
    assert (rig.bench.out[block, "Valid"], rig.bench.out[block, "Error"]) == (True, False)


# Two instances of a block are two blocks.


@pytest.mark.proof(1)
@pytest.mark.parametrize("name", POSITIONING)
def test_another_instance_changes_nothing_until_it_has_the_axis(name: str, make: Callable[..., Any]) -> None:
    rig = make(name, twice=True)
    first = set_out(rig, name, 1900)
    second = f"{first} 2"
    assert rig.ended(second) == ""
    rig.set(second, **{value_input(rig, second): place(name, -500)})
    rig.start(second)
    rig.run(3000)
    # What does not show whether it takes a command is not sent one while it moves.
    ends, position = (("Done", "Error 11"), 1900) if name in ("ck10", "esc11") else (("CommandAborted", "Done"), -500)
    assert (rig.ended(first), rig.ended(second)) == ends
    assert rig.model.state.position == position
    assert broken(rig, 9, 15, 16, 17, 20, 37) == []


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", POSITIONING)
def test_a_second_stop_leaves_the_first_alone(name: str, make: Callable[..., Any]) -> None:
    rig = make(name, twice=True)
    set_out(rig, name, 9000, slow=False)
    first = rig.block("stop")
    rig.start(first)
    rig.run(1)
    rig.start(f"{first} 2")
    rig.run(600)
    assert rig.ended(first)[:4] == "Done"
    assert rig.ended(f"{first} 2")[:4] in ("Done", "Erro")
    rig.start(f"{first} 2", False)
    rig.run(3)
    move = rig.block("relative")
    rig.start(move)
    rig.run(300)
    assert (rig.ended(move)[:5], rig.ended(first)[:4]) == ("Error", "Done")


@pytest.mark.parametrize("name", [name for name in POSITIONING if name not in FRAMED])
@pytest.mark.parametrize("kind", ["absolute", "relative"])
def test_a_telegram_starts_a_motion_once_the_drive_has_seen_all_that_it_is_started_with(
    name: str, kind: str, make: Callable[..., Any]
) -> None:
    rig = make(name)
    block = rig.block(kind)
    rig.start(block, False)
    rig.run(2, 5)
    rig.start(block)
    scans = 0
    while not (rig.word or 0) & 0x0040 and scans < 40:
        rig.run(1, 5)
        scans += 1
    assert 5 <= scans <= 12
