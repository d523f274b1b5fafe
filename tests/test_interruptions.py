"""Builds that are killed, and builds at the same time, on all processors, as people run them."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from interruptions import Place, soak
from proofs import IS_WHOLE

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="builds in processes on Linux alone")


LARGEST = ("ck10", "hiwin-e")
"""Building them takes longer than building the others, and their outputs are placed as those are."""


@pytest.mark.proof
def test_a_build_that_is_killed_at_a_random_moment_is_repaired_by_the_next() -> None:
    builds = 3 if IS_WHOLE else 1
    assert sum(soak(builds, 1, LARGEST).values()) == builds


def test_builds_at_the_same_time_leave_the_outputs_of_one_of_them(tmp_path: Path) -> None:
    place = Place(tmp_path, LARGEST)
    builds = [place.build(number) for number in (0, 1, 0)]
    assert [build.wait() for build in builds] == [0, 0, 0]
    assert place.files() in place.states
    assert place.left_over() == []
