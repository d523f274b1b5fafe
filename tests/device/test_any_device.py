"""Any device can be simulated, also one without behaviour: nothing that comes over the line is an error of ours."""

from __future__ import annotations

import random

import pytest

from fieldspec.behaviour.part import NONE
from fieldspec.layout.device import DeviceLayout
from fieldspec.simulator.engine import Engine
from fieldspec.simulator.server import Server
from layouts import SPECS, TEST_SPECS, layouts

NEWEST = [
    pytest.param(versions[-1], id=name) for root in (SPECS, TEST_SPECS) for name, versions in layouts(root).items()
]


@pytest.mark.parametrize("layout", NEWEST)
def test_every_frame_is_answered_or_ignored(layout: DeviceLayout) -> None:
    server = Server(Engine(layout, NONE))
    chance = random.Random(layout.device.id)
    for example in layout.device.examples.values():
        for changed in range(4):
            frame = bytearray(example.frame)
            for _ in range(changed):
                frame[chance.randrange(len(frame))] ^= 1 << chance.randrange(8)
            answer = server.answer(example.link, bytes(frame), example.message)
            assert isinstance(answer.frame, bytes)
            frames = server.codecs[example.link]
            try:
                whole = frames.joined_parts(
                    "request", frames.with_checksum("request", frames.original_parts(bytes(frame), "request"))
                )
            except ValueError:
                continue
            assert isinstance(server.answer(example.link, whole, example.message).frame, bytes)
