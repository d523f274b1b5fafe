"""No output of a made-up device changes unnoticed: together they use every feature of the language."""

from __future__ import annotations

import pytest

from fieldspec.targets import OUTPUTS
from recorded_outputs import RECORDED, digests, digests_path, main


@pytest.mark.parametrize("name", OUTPUTS)
def test_outputs_of_made_up_devices_are_as_recorded(name: str, accept: bool) -> None:
    now = digests(name)
    if accept:
        digests_path(name).write_text(now, "utf-8", newline="\n")
    recorded = dict(line.split() for line in digests_path(name).read_text("utf-8").splitlines())
    present = dict(line.split() for line in now.splitlines())
    different = sorted(device for device in recorded | present if recorded.get(device) != present.get(device))
    assert different == [], "compare these outputs with those of main; if only what should differ does, use --accept"


def test_every_recorded_output_exists() -> None:
    assert {path.stem for path in RECORDED.iterdir()} == set(OUTPUTS)


def test_the_right_compiler_makes_what_is_recorded() -> None:
    assert main(["c"]) == 0
