"""The blocks that move an axis, driven at random against the models of the manuals, break no rule of the monitors."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from loaded import programs
from model_driver import SCANS, episode
from model_rigs import NAMES

from device_models.monitors import violations

STEPS = int(os.environ.get("FIELDSPEC_RANDOM_STEPS", "6000"))
"""Random scans of each device, in episodes; `make plants` runs a million."""


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", NAMES)
def test_no_rule_is_broken_whatever_happens(name: str, tmp_path_factory: pytest.TempPathFactory) -> None:
    folder = programs(tmp_path_factory)
    for seed in range(-(-STEPS // SCANS)):
        wrong = violations(episode(name, seed, folder))
        assert wrong == [], f'model_driver.py "{name}" seed {seed} {wrong[0].rule}\n' + "\n".join(map(str, wrong))


@pytest.mark.parametrize("name", NAMES)
def test_an_episode_is_the_same_whenever_it_is_run(name: str, tmp_path_factory: pytest.TempPathFactory) -> None:
    folder = programs(tmp_path_factory)
    first, second = (episode(name, 7, folder, 300) for _ in range(2))
    assert first.scans == second.scans


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", NAMES)
def test_the_axis_moves_in_most_episodes(name: str, tmp_path_factory: pytest.TempPathFactory) -> None:
    folder = programs(tmp_path_factory)
    moved = [any(scan.state.velocity for scan in episode(name, seed, folder).scans) for seed in range(6)]
    assert sum(moved) > 2
