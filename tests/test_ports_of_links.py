"""What states the ports of a device: where it is served and found, and which side of a captured connection it is."""

from __future__ import annotations

import io
import shutil
import socket
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import pytest

from captures.conversations import ethernet, pcap, tcp_poll
from fieldspec.cli import main
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.testing import simulation
from fieldspec.tools.captures.conversion import Conversion
from fieldspec.tools.captures.decoding import Choices, DeviceDecoder
from fieldspec.tools.simulator.simulation import completed_place, stated_place, usual_place
from layouts import SPECS, TEST_SPECS, newest
from python_package import module_of

STATION = newest(TEST_SPECS, "station").links["tcp"]
RTU = newest(TEST_SPECS, "station").links["rtu"]
FOLDER = str(TEST_SPECS)


@pytest.mark.parametrize(
    ("place", "expected"),
    [
        ("tcp://10.0.0.2", "tcp://10.0.0.2:502"),
        ("tcp://10.0.0.2/", "tcp://10.0.0.2:502"),
        ("tcp://[::1]", "tcp://[::1]:502"),
        ("tcp://[::1]:5020", "tcp://[::1]:5020"),
        ("tcp://10.0.0.2:5020", "tcp://10.0.0.2:5020"),
        ("udp://10.0.0.2", "udp://10.0.0.2"),
        ("tcp://", "tcp://"),
        ("/dev/ttyUSB0", "/dev/ttyUSB0"),
    ],
)
def test_an_address_without_a_port_has_the_one_of_the_spec(place: str, expected: str) -> None:
    assert completed_place(STATION, place) == expected
    assert completed_place(RTU, place) == place


def test_a_link_is_served_at_its_port_and_a_serial_one_at_a_terminal() -> None:
    assert stated_place(STATION) == "tcp://127.0.0.1:502"
    assert stated_place(RTU) == usual_place(RTU)
    rtu = newest(SPECS, "tc100").links["rtu"]
    assert stated_place(rtu) == usual_place(rtu)


@pytest.fixture
def busy_port() -> Iterator[int]:
    """A TCP port on which somebody listens already."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        yield server.getsockname()[1]


def specs_at(folder: Path, port: int, udp: int = 502) -> str:
    """Specs with a wattmeter that listens on other ports."""
    shutil.copytree(TEST_SPECS / "wattmeter", folder / "wattmeter")
    shutil.copytree(TEST_SPECS / "protocols", folder / "protocols")
    path = folder / "wattmeter" / "device.yaml"
    text = path.read_text("utf-8")
    path.write_text(text.replace("{tcp: 502, udp: 502,", f"{{tcp: {port}, udp: {udp},"), "utf-8")
    return str(folder)


def test_simulate_says_how_to_serve_elsewhere_where_the_port_is_taken(
    tmp_path: Path, busy_port: int, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["simulate", "wattmeter", "--specs", specs_at(tmp_path, busy_port)]) == 2
    text = f"cannot listen on tcp://127.0.0.1:{busy_port}"
    error = capsys.readouterr().err
    assert text in error
    assert "name another place, such as --port tcp=tcp://127.0.0.1:0 for a free port" in error


def test_live_connects_to_the_port_of_the_spec(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with simulation("wattmeter", ports={"tcp": "tcp://127.0.0.1:0"}, folder=FOLDER) as device:
        folder = specs_at(tmp_path, int(device.place.rpartition(":")[2]))
        assert main(["live", "wattmeter", "read", "--link", "tcp", "--port", "tcp://127.0.0.1", "--specs", folder]) == 0
    assert len(capsys.readouterr().out.splitlines()) > 2


def conversation(layout: DeviceLayout, port: int) -> str:
    """The name of a connection to a port, as tables have it."""
    segments = tcp_poll(3)
    file = io.BytesIO(pcap(ethernet(segment, port) for segment in segments))
    conversion = Conversion(file, DeviceDecoder(layout, Choices()), ())
    for _ in conversion.batches():
        pass
    (name,) = conversion.decoder.names.texts
    return str(name)


def test_the_side_with_the_port_of_the_spec_is_the_device_in_captures(tmp_path: Path) -> None:
    high = newest(Path(specs_at(tmp_path, 50000)), "wattmeter")
    client = "10.0.0.1:49152"
    assert conversation(high, 50000) == f"tcp {client} 10.0.0.2:50000"
    assert conversation(newest(TEST_SPECS, "wattmeter"), 502) == f"tcp {client} 10.0.0.2:502"
    assert conversation(newest(TEST_SPECS, "wattmeter"), 50000) == f"tcp 10.0.0.2:50000 {client}"


def test_a_simulated_device_is_served_at_the_port_of_the_spec_where_its_place_has_none(tmp_path: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
    with simulation("wattmeter", ports={"tcp": "udp://127.0.0.1"}, folder=specs_at(tmp_path, port, port)) as device:
        assert device.place == f"udp://127.0.0.1:{port}"


def test_live_asks_for_a_host_where_the_port_is_known(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["live", "wattmeter", "read", "--link", "tcp", "--specs", FOLDER]) == 2
    assert "say where the device is: --port tcp://HOST, udp://HOST" in capsys.readouterr().err


def test_the_documentation_of_a_client_says_the_ports_of_the_device() -> None:
    module = import_module(f"{module_of(newest(TEST_SPECS, 'wattmeter')).__name__}_client")
    about = " ".join((module.Client.__doc__ or "").split())
    assert 'On the link "tcp", the device listens on TCP port 502.' in about
    assert 'On the link "tcp", the device listens on UDP port 502.' in about
