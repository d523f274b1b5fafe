"""Values in pieces on a serial line: blocks with a number from 1 to 3, and no mark of the last one but the size."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.pipeline import layouts, load
from fieldspec.language.behaviour.reading import behaviour_of
from fieldspec.targets.python.backend import PACKAGE, files, shared
from fieldspec.tools.live.client import Client, Timing
from fieldspec.tools.live.messages import named_signals, parameter_assignment, read_signals, signals, write_parameter
from fieldspec.tools.simulator.engine import Engine
from fieldspec.tools.simulator.server import Server
from python_package import write

SPEC = Path(__file__).parent / "cases" / "segments_complete" / "passing_numbered" / "device.yaml"
VALUES = {"level": 7, "title": "seventeen letters", "whole": 2**63 + 5, "blob": bytes(range(13))}


@pytest.fixture(scope="module")
def layout() -> DeviceLayout:
    return layouts(load({"gadget/device.yaml": SPEC.read_bytes()}).devices["gadget"])[0]


class Line:
    """A line with a simulated device at its other end."""

    datagrams = True

    def __init__(self, layout: DeviceLayout) -> None:
        spec = load({"gadget/device.yaml": SPEC.read_bytes()}).devices["gadget"]
        self.server = Server(Engine(layout, behaviour_of(spec.tree)))
        self.requests: list[str] = []
        self.due: list[bytes] = []

    def write(self, data: bytes) -> None:
        """Takes a request."""
        self.requests.append(data[:-1].hex(" ").upper())
        self.due = [self.server.answer("line", data).frame]

    def read(self, limit: float) -> bytes:
        """The answer that is due."""
        return self.due.pop() if self.due else b""

    def close(self) -> None:
        """Nothing is open."""


@pytest.fixture(scope="module")
def module(layout: DeviceLayout, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    folder = tmp_path_factory.mktemp("pieces")
    write(
        folder,
        {path.replace(PACKAGE, "devices_of_pieces", 1): text for path, text in (shared() | files([layout])).items()},
    )
    sys.path.insert(0, str(folder))
    yield importlib.import_module("devices_of_pieces.gadget.client")
    sys.path.remove(str(folder))


def test_a_client_writes_and_reads_values_in_numbered_blocks(layout: DeviceLayout, module: Any) -> None:
    line = Line(layout)
    client, settings = module.Client(line), importlib.import_module("devices_of_pieces.gadget").settings
    for name, value in VALUES.items():
        parameter = getattr(settings, name.upper())
        client.write_parameter(parameter, value)
        assert client.read_parameter(parameter) == value
    blob = [request for request in line.requests if "08 09 0A 0B" in request or request.startswith("03 07 04")]
    assert blob == ["03 07 04 00 0D", "04 03 08 09 0A 0B"]
    assert line.requests[-5:] == ["01 04", "02 01", "02 02", "02 03", "02 01"]


def test_live_writes_and_reads_values_in_numbered_blocks(layout: DeviceLayout) -> None:
    client = Client(layout, "line", Line(layout), 1, Timing(timeout=0.05))
    known = list(signals(layout, layout.links["line"]))
    for name, text in (("level", "7"), ("title", "seventeen letters"), ("whole", str(2**63 + 5))):
        (signal,) = named_signals(layout, known, name)
        chosen = parameter_assignment(layout, layout.links["line"], signal, text)
        write_parameter(client, chosen)
        (reading,) = read_signals(client, [signal])
        assert reading.words == chosen.words
