"""Links whose messages carry less than a register has, or whose responses lack what requests have."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import serial

from fieldspec.cli import main
from fieldspec.command.pipeline import layouts, load
from fieldspec.targets.python.backend import PACKAGE, files, shared
from fieldspec.testing import SimulatedDevice, simulation
from python_package import write

DEVICE = """
device:
  id: gauge
  name: Gauge
  vendor: Nobody
  manual: {title: The manual, file: gauge.txt, sha256: "%s", lines: 99}
links:
  - name: line
    source: 1 L1
    transmission: binary
    byte_order: big
    word_order: big
    unit_addresses: {range: 1..9, source: 1 L1}
    request:
      - {name: to, role: unit_address, type: u8}
      - {name: from, type: u8, range: 1..9}
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
    response: [%s{name: command, role: code, type: u8}, {name: body, role: body}]
messages:
  - name: read
    code: 1
    source: 1 L2
    request: [{name: address, type: u8}]
    response: [{name: value, type: u16, repeat: 1}]
    accesses: [{operation: read, start: address, values: value}]
registers:
  - group: levels
    source: 2 L1
    rows:
      - {at: 3, name: level, type: u32, checked: {words: 2}, access: ro, source: 2 L2}
      - {at: 5, name: speed, type: f32, checked: {words: 2}, access: ro, source: 2 L3}
behaviour:
  - {name: full, initial: registers/level, value: 305419896, source: 1 L5}
"""
ADDRESSED = "{name: to, same_as: from, type: u8}, {name: from, role: unit_address, type: u8}, "


def project(folder: Path, answer: str) -> str:
    """A folder of specs whose responses begin with some parts."""
    (folder / "gauge").mkdir()
    (folder / "gauge/device.yaml").write_text(DEVICE % ("0" * 64, answer), "utf-8")
    return str(folder)


@pytest.fixture(params=["", ADDRESSED], ids=["responses without an address", "responses with exchanged addresses"])
def device(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[SimulatedDevice]:
    """A gauge at a pseudo-terminal."""
    with simulation("gauge", ports={"line": "pty"}, folder=project(tmp_path, request.param)) as running:
        yield running


def test_a_register_that_no_request_reads_whole_is_read_by_several(
    device: SimulatedDevice, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    options = ("--with", "from=7", "--port", device.place, "--specs", str(tmp_path))
    assert main(["live", "gauge", "read", "level", "speed", *options]) == 0
    output = capsys.readouterr().out
    assert "305419896" in output
    assert main(["live", "gauge", "dump", "-", *options]) == 0
    assert "0x0003,4660\n0x0004,22136\n" in capsys.readouterr().out


@pytest.fixture
def client(device: SimulatedDevice, tmp_path: Path) -> Iterator[Any]:
    """The generated client; its requests name 7 as their sender."""
    name = f"{tmp_path.name}_devices"
    text = (tmp_path / "gauge/device.yaml").read_bytes()
    versions = layouts(load({"gauge/device.yaml": text}).devices["gauge"])
    outputs = shared() | files(versions)
    write(tmp_path / "out", {path.replace(PACKAGE, name, 1): text for path, text in outputs.items()})
    sys.path.insert(0, str(tmp_path / "out"))
    module = importlib.import_module(f"{name}.gauge.client")
    sys.path.remove(str(tmp_path / "out"))
    with serial.Serial(device.place, 19200, timeout=0.02) as port:
        yield module.Client(port, unit_address=1, from_=7)


def test_the_generated_client_reads_what_the_simulated_device_has(client: Any) -> None:
    assert client.read(importlib.import_module(type(client).__module__.rpartition(".")[0]).LEVEL) == 305419896
