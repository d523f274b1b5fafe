"""What a block asks for does not depend on how long Execute is TRUE (rule 5), against the models of the manuals."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from loaded import programs
from model_rigs import FrameRig, rig
from model_scenes import POSITIONING

from device_models.draws import Draws

KINDS = ("power_on", "power_off", "home", "absolute", "relative", "point", "stop", "halt", "quick_stop", "reset")
LACKING = {("esc11", "quick_stop"), ("hiwin-e 9", "point"), ("hiwin-e 111", "point")}
"""Blocks that a device does not have."""
BLOCKS = [(name, kind) for name in POSITIONING for kind in KINDS if (name, kind) not in LACKING]
FALLS = (1, 2, 7, 40)
"""Scans after which Execute falls."""


def carried_out(folder: Path, name: str, kind: str, falls: int | None) -> list[Any]:
    """What is on the wire in each scan until a block has ended, and how it has.

    A move to elsewhere goes on before, and exchanges are lost and damaged; what is drawn depends on the requests alone.
    """
    device = rig(name, folder, Draws(f"{name} {kind}", delay=0.1))
    device.run(3)
    for before in ("power_on", "home"):
        device.finish(device.block(before), limit=10.0)
    if kind not in ("power_on", "home", "reset"):
        device.start(device.block("relative"))
        device.run(30)
        device.start(device.block("relative"), False)
    if isinstance(device, FrameRig):
        device.line.chance = 0.1
    block = device.block(kind)
    device.start(block, False)
    device.run(2)
    device.start(block)
    first = len(device.record)
    while len(device.record) < first + 3000:
        if falls is not None and len(device.record) == first + falls:
            device.start(block, False)
        device.run(1)
        if not device.ended(block).startswith("Busy") or device.ended(block) == "":
            break
    return [*((scan.asked, scan.word) for scan in device.record[first:]), device.ended(block)]


@pytest.mark.proof(8)
@pytest.mark.parametrize(("name", "kind"), BLOCKS)
def test_the_wire_is_the_same_however_long_execute_is_true(
    name: str, kind: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    folder = programs(tmp_path_factory)
    long = carried_out(folder, name, kind, None)
    assert [carried_out(folder, name, kind, falls) for falls in FALLS] == [long] * len(FALLS)
