"""No example of docs/plc.md starts a device without a fresh edge: each is compiled and runs against a simulated one."""

from __future__ import annotations

import os
import random
import sys
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from loaded import programs
from plants import Esc11, Plant, Tc100, Telegram111, disturbed

PLANTS = {"telegram_111": Telegram111, "tc100": Tc100, "esc11": Esc11}
STEPS = int(os.environ.get("FIELDSPEC_RANDOM_STEPS", "20000"))
"""Random scans of each example; `make plants` runs a million."""
LONG = 120
"""Scans in which every move ends, and every time runs out."""


@pytest.fixture
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where compiled programs are kept."""
    return programs(tmp_path_factory)


@pytest.fixture(params=PLANTS)
def plant(request: pytest.FixtureRequest, folder: Path) -> Plant:
    """Each example with its device, which has come up."""
    plant: Plant = PLANTS[request.param](folder)
    run(plant, LONG)
    return plant


def run(plant: Plant, scans: int, **inputs: Any) -> Plant:
    """Sets inputs, and runs some scans."""
    for name, value in inputs.items():
        assert hasattr(plant, name), name
        setattr(plant, name, value)
    for _ in range(scans):
        plant.scan()
    return plant


def begun(plant: Plant) -> Plant:
    """A plant whose device has begun to move."""
    plant.start = True
    for _ in range(LONG):
        plant.scan()
        if plant.starts:
            return run(plant, 2)
    raise AssertionError("it does not start")


def ends_and_starts_again_by_an_edge_alone(plant: Plant, outcome: str) -> None:
    """A move that has begun ends as said, and nothing happens until there is another edge."""
    before = plant.starts
    run(plant, LONG, alarm=False, lost=False)
    assert (plant.starts, plant.done, plant.error) == (before, outcome == "done", outcome == "error")
    run(plant, LONG, start=False)
    assert (plant.starts, plant.done, plant.error) == (before, False, False)
    run(plant, LONG, start=True)
    assert (plant.starts, plant.done, plant.error) == (before + 1, True, False)


def test_an_edge_moves_once_and_the_next_edge_once_more(plant: Plant) -> None:
    begun(plant)
    assert plant.starts == 1
    ends_and_starts_again_by_an_edge_alone(plant, "done")


def test_an_input_that_is_true_when_the_controller_is_switched_on_moves_nothing(plant: Plant) -> None:
    run(plant, 1, start=True)
    plant.restart()
    run(plant, LONG)
    assert (plant.starts, plant.done) == (0, False)
    run(plant, 2, start=False)
    run(plant, LONG, start=True)
    assert (plant.starts, plant.done) == (1, True)


def test_a_restart_of_the_controller_while_it_moves_is_followed_by_no_start(plant: Plant) -> None:
    begun(plant).restart()
    run(plant, LONG)
    assert (plant.starts, plant.done, plant.error) == (1, False, False)


def test_an_alarm_while_it_moves_is_an_error_and_its_reset_moves_nothing(plant: Plant) -> None:
    run(begun(plant), LONG, alarm=True)
    assert plant.error
    ends_and_starts_again_by_an_edge_alone(plant, "error")


def test_frames_that_are_lost_while_it_moves_are_an_error_and_their_return_moves_nothing(plant: Plant) -> None:
    run(begun(plant), LONG, lost=True)
    assert plant.error
    ends_and_starts_again_by_an_edge_alone(plant, "error")


def test_a_device_that_is_switched_off_and_on_while_it_moves_is_an_error_and_does_not_move_again(plant: Plant) -> None:
    begun(plant).power_cycle()
    ends_and_starts_again_by_an_edge_alone(plant, "error")


def test_an_edge_during_an_alarm_is_not_made_up_for(plant: Plant) -> None:
    run(plant, 5, alarm=True)
    run(plant, LONG, start=True)
    assert plant.error
    # The gripper and the controller are asked first, and answer with the alarm.
    before = plant.starts
    run(plant, LONG, alarm=False)
    assert plant.starts == before


def test_an_input_that_is_withdrawn_at_once_moves_nothing(plant: Plant) -> None:
    run(plant, 1, start=True)
    run(plant, LONG, start=False)
    assert (plant.starts, plant.done, plant.error) == (0, False, False)


@pytest.mark.parametrize(("name", "value"), [("enable", False), ("unsent", True), ("homed", False)])
def test_the_telegram_starts_nothing_where_the_drive_cannot_move(folder: Path, name: str, value: bool) -> None:
    plant = run(Telegram111(folder), LONG)
    run(plant, 10, **{name: value})
    run(plant, LONG, start=True)
    assert (plant.starts, plant.error) == (0, True)
    run(plant, LONG, **{name: not value})
    assert plant.starts == 0


@pytest.mark.parametrize("change", [{"start": False}, {"enable": False}, {"alarm": True}, {"lost": True}])
@pytest.mark.parametrize("scans", range(1, 5))
def test_the_start_bit_is_reset_with_whatever_ends_the_move_before_it(
    folder: Path, change: dict[str, bool], scans: int
) -> None:
    plant = run(Telegram111(folder), LONG)
    run(plant, scans, start=True)
    run(plant, 3, **change)
    run(plant, 1, lost=False)
    assert not plant.command["startTraversingTask"]
    before = plant.starts
    run(plant, LONG, start=True, enable=True, alarm=False)
    # What was taken back before it was acknowledged may be asked for again, by the next edge.
    assert plant.starts - before in ((0, 1) if change == {"start": False} else (0,))


@pytest.mark.parametrize("losses", [1, 2, 3, 4])
def test_the_gripper_is_asked_three_times_at_most(folder: Path, losses: int) -> None:
    plant = Esc11(folder)
    run(plant, 2)
    plant.start = plant.lost = True
    for _ in range(LONG):
        plant.scan()
        plant.lost = plant.starts < losses and not plant.error
    assert (plant.starts, plant.done, plant.error) == (min(losses, 3), losses < 4, losses >= 4)


def test_a_damaged_answer_of_the_gripper_is_an_error_and_grips_no_more(folder: Path) -> None:
    plant = Esc11(folder)
    run(plant, 2, damaged=True)
    run(plant, LONG, start=True)
    assert (plant.starts, plant.error) == (1, True)
    run(plant, LONG, damaged=False)
    assert plant.starts == 1


@pytest.mark.parametrize("name", PLANTS)
def test_nothing_starts_without_an_edge_whatever_happens(name: str, folder: Path) -> None:
    plant: Plant = PLANTS[name](folder)
    disturbed(plant, random.Random(name), STEPS)
    assert min(plant.starts, plant.finished, plant.failed) > STEPS / 2000
