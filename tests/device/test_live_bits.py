"""Registers of single bits are read, written, dumped and restored like words, in spaces with messages of their own."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from pymodbus.client import ModbusTcpClient

from fieldspec.cli import main
from fieldspec.testing import SimulatedDevice, simulation
from layouts import TEST_SPECS


@pytest.fixture
def station() -> Iterator[SimulatedDevice]:
    with simulation("station", ports={"tcp": "tcp://127.0.0.1:0"}, folder=str(TEST_SPECS)) as device:
        yield device


def live(device: SimulatedDevice, *arguments: str) -> int:
    """The exit code of a verb."""
    options = ("--port", device.place, "--link", "tcp", "--unit", "1", "--timeout", "0.5", "--specs", str(TEST_SPECS))
    return main(["live", "station", *arguments, *options])


def coils(device: SimulatedDevice, address: int, count: int) -> list[bool]:
    """Coils as another client reads them."""
    host, _, port = device.place.removeprefix("tcp://").rpartition(":")
    client = ModbusTcpClient(host, port=int(port))
    assert client.connect()
    bits = client.read_coils(address, count=count, device_id=1).bits[:count]
    client.close()
    return bits


def test_bits_are_written_and_read(station: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    assert live(station, "write", "relays[2]=1", "enable=enabled", "test_lamp=true", "relays[8]=1") == 0
    assert coils(station, 0, 10) == [False, True, False, False, False, False, False, True, True, True]
    capsys.readouterr()
    assert live(station, "read", "relays", "enable", "fault", "mode", "--format", "json") == 0
    rows = {row["name"]: row for row in json.loads(capsys.readouterr().out)}
    assert [rows[f"relays[{number}]"]["value"] for number in range(1, 9)] == [*(n in (2, 8) for n in range(1, 9))]
    assert rows["enable"]["meaning"] == "enabled"
    assert rows["fault"]["meaning"] == "none"
    assert rows["mode"]["meaning"] == "direct"


def test_bits_are_restored_and_compared(station: SimulatedDevice, tmp_path: Path) -> None:
    path = str(tmp_path / "settings.csv")
    assert live(station, "write", "relays[3]=1", "mode=toggle") == 0
    assert live(station, "backup", path) == 0
    assert live(station, "write", "relays[3]=0", "valves[1]=1", "mode=pulse") == 0
    assert live(station, "compare", path) == 1
    assert live(station, "restore", path, "--yes") == 0
    assert coils(station, 2, 1) == [True]
    assert live(station, "compare", path) == 0


def test_a_dump_names_the_spaces(station: SimulatedDevice, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    path = tmp_path / "dump.csv"
    assert live(station, "write", "relays[1]=1", "filter_time=7") == 0
    assert live(station, "dump", str(path)) == 0
    lines = path.read_text("utf-8").splitlines()
    assert f"{len(lines) - 1} words\n" in capsys.readouterr().err
    assert lines[0] == "space,address,value"
    assert "coils,0x0000,1" in lines
    assert "discrete_inputs,0x0000,0" in lines
    assert any(line.endswith(",0x0000,7") for line in lines)
    from fieldspec.tools.lists.dump import dump
    from fieldspec.tools.lists.text_sheet import text_sheet
    from fieldspec.tools.simulator.seeding import seed

    with simulation("station", ports={"tcp": "tcp://127.0.0.1:0"}, folder=str(TEST_SPECS)) as other:
        seed(other.simulation.engine, dump(text_sheet(path.read_bytes(), ""), {}))
        assert coils(other, 0, 2) == [True, False]


def test_a_scan_asks_for_bits(station: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    assert live(station, "scan", "0..0x1F", "--format", "json") == 0
    assert json.loads(capsys.readouterr().out)["spaces"][0]["silent"] == []


def test_the_numbers_that_a_manual_prints_are_names(
    station: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    assert live(station, "write", "40001=7", "--yes") == 0
    capsys.readouterr()
    assert live(station, "read", "40001", "10017", "--format", "json") == 0
    rows = json.loads(capsys.readouterr().out)
    assert [(row["name"], row["words"]) for row in rows] == [("filter_time", [7]), ("fault", [0])]
