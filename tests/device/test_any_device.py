"""Any device can be simulated, also one without behaviour: nothing that comes over the line is an error of ours."""

from __future__ import annotations

import random

import pytest

from fieldspec.cli import main
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.behaviour.part import Behaviour
from fieldspec.testing import simulation
from fieldspec.tools.simulator.engine import Engine
from fieldspec.tools.simulator.server import Server
from layouts import SPECS, TEST_SPECS, layouts

NEWEST = [
    pytest.param(versions[-1], id=name) for root in (SPECS, TEST_SPECS) for name, versions in layouts(root).items()
]


@pytest.mark.parametrize("layout", NEWEST)
def test_every_frame_is_answered_or_ignored(layout: DeviceLayout) -> None:
    server = Server(Engine(layout, Behaviour(())))
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


READABLE = {"caller": "bus", "station": "tcp", "mover": "serial", "wattmeter": "tcp"}


@pytest.mark.parametrize(("name", "link"), READABLE.items())
def test_a_simulated_device_answers_a_client_without_options(
    name: str, link: str, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = str(TEST_SPECS)
    more = ["--with", "axis=0"] if name == "mover" else []
    with simulation(name, ports={link: "tcp://127.0.0.1:0"}, folder=folder) as device:
        assert main(["live", name, "read", "--link", link, "--port", device.place, *more, "--specs", folder]) == 0
    assert len(capsys.readouterr().out.splitlines()) > 2


def test_a_link_that_reads_nothing_is_refused_with_the_one_that_reads_registers(
    capsys: pytest.CaptureFixture[str],
) -> None:
    arguments = [
        "live",
        "ladder",
        "read",
        "--link",
        "loop",
        "--port",
        "tcp://127.0.0.1:9",
        "--specs",
        str(TEST_SPECS),
    ]
    assert main(arguments) == 2
    assert "no message of loop reads registers; say --link area" in capsys.readouterr().err
