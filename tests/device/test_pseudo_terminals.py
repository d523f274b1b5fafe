"""Ports on pseudo-terminals, which have no parity, ports that refuse their settings, and carriers that are closed."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

from fieldspec.cli import main
from fieldspec.testing import SimulatedDevice, simulation
from fieldspec.tools.carriers.carrier import CarrierError, LineSettings
from fieldspec.tools.carriers.pages import PageServer
from fieldspec.tools.carriers.sockets import Connection, Datagrams, Listener
from fieldspec.tools.carriers.terminals import SerialPort
from serial_lines import Line, serial_line
from simulators import SPECS


@pytest.fixture
def tc100() -> Iterator[SimulatedDevice]:
    with simulation("tc100", ports={"ascii": "pty"}, folder=SPECS) as device:
        yield device


def live(device: SimulatedDevice, verb: str, *more: str) -> int:
    """The exit code of a verb at the place of a device."""
    names = ["live", "tc100", verb] if verb != "scan" else ["scan", "tc100"]
    return main([*names, *more, "--port", device.place, "--timeout", "0.5", "--specs", SPECS])


@pytest.mark.parametrize("parity", ["none", "even", "odd"])
def test_a_device_is_read_whatever_the_parity(
    tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str], parity: str
) -> None:
    assert live(tc100, "read", "motion_speed", "--parity", parity) == 0
    assert "100 %" in capsys.readouterr().out
    assert live(tc100, "scan", "0x2014", "--parity", parity) == 0


@pytest.mark.parametrize("settings", [LineSettings(9600, 7, "even", 2), LineSettings(19200, 8, "odd", 1)])
def test_bytes_go_both_ways_whatever_the_settings(settings: LineSettings) -> None:
    with serial_line() as (handle, path):
        line, port = Line(handle), SerialPort(path, settings)
        port.write(b"\x00\xff")
        assert line.receive() == b"\x00\xff"
        line.send(b"\xfe\x01")
        assert port.read(1.0) + port.read(0.05) == b"\xfe\x01"
        port.close()


def test_settings_that_a_port_refuses_are_one_line(
    tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    import termios

    def refuse(*arguments: object) -> None:
        raise termios.error(22, "Invalid argument")

    monkeypatch.setattr(termios, "tcsetattr", refuse)
    with pytest.raises(CarrierError, match="cannot open"):
        SerialPort(tc100.place, LineSettings())
    assert live(tc100, "read", "motion_speed", "--parity", "even") == 2
    error = capsys.readouterr().err
    assert error.startswith("fieldspec: cannot open ")
    assert error.count("\n") == 1


def simulated_lines() -> ExitStack:
    """A simulated device on two pseudo-terminals."""
    stack = ExitStack()
    stack.enter_context(simulation("tc100", ports={"rtu": "pty", "ascii": "pty"}, folder=SPECS))
    return stack


CARRIERS: dict[str, Callable[[str], Any]] = {
    "listener": lambda place: Listener("tcp://127.0.0.1:0"),
    "connection": Connection.opened,
    "serial port": lambda place: SerialPort(place.replace("tcp:", "socket:"), LineSettings()),
    "server of datagrams": lambda place: Datagrams("udp://127.0.0.1:0", server=True),
    "client of datagrams": lambda place: Datagrams(place, server=False),
    "pages": lambda place: PageServer(Path(__file__).parent, 0),
    "pseudo-terminals": lambda place: simulated_lines(),
}


@pytest.mark.parametrize("carrier", CARRIERS.values(), ids=CARRIERS)
def test_what_is_closed_leaves_no_descriptor_open(carrier: Callable[[str], Any]) -> None:
    listener = Listener("tcp://127.0.0.1:0")
    carrier(listener.name).close()  # what a module opens once is open from then on
    before = os.listdir("/dev/fd")
    closed = carrier(listener.name)
    assert os.listdir("/dev/fd") != before
    closed.close()
    assert os.listdir("/dev/fd") == before
    listener.close()
