"""Foreign clients talk to simulated devices over pseudo-terminals, TCP and UDP."""

from __future__ import annotations

import io
import json
import select
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import minimalmodbus
import pytest
import serial
from pymodbus import FramerType, ModbusException
from pymodbus.client import ModbusSerialClient, ModbusTcpClient

from bounded import HANGING
from external_tools import require_tool
from fieldspec.cli import main
from fieldspec.codec.reference.checksums import checksum
from fieldspec.testing import SimulatedDevice, simulated, simulation
from fieldspec.tools.carriers.carrier import CarrierError, LineSettings
from fieldspec.tools.carriers.sockets import Connection, Listener
from fieldspec.tools.simulator.clock import ManualClock
from simulators import SPECS


def rtu(text: str) -> bytes:
    """A frame in bytes, with its checksum."""
    data = bytes.fromhex(text)
    return data + checksum("crc16_modbus", data, "little").to_bytes(2, "little")


RIGHT = rtu("01 03 02 00 0A")

tc100 = simulated("tc100", ports={"rtu": "pty", "ascii": "pty"}, folder=SPECS)


def test_a_client_in_characters_and_one_in_bytes_share_a_device(tc100: SimulatedDevice) -> None:
    for link, framer in (("rtu", FramerType.RTU), ("ascii", FramerType.ASCII)):
        client = ModbusSerialClient(tc100.places[link], framer=framer, baudrate=19200, timeout=5)
        assert client.connect()
        assert not client.write_register(0x0805, 1234, device_id=1).isError()
        assert client.read_holding_registers(0x0805, count=1, device_id=1).registers == [1234]
        assert client.read_holding_registers(0x1002, count=1, device_id=1).exception_code == 2
        assert client.write_registers(0x2002, [0, 250], device_id=1).count == 2
        client.close()
    assert tc100.value("target_position") == 250


def test_minimalmodbus_reads_and_writes(tc100: SimulatedDevice) -> None:
    instrument = minimalmodbus.Instrument(tc100.places["rtu"], 1)
    instrument.serial.baudrate, instrument.serial.timeout = 19200, 1
    instrument.write_long(0x2002, -12345, signed=True)
    assert instrument.read_long(0x2002, signed=True) == -12345
    instrument.write_register(0x2014, 40, functioncode=6)
    assert instrument.read_register(0x2014) == 40
    with pytest.raises(minimalmodbus.IllegalRequestError):
        instrument.write_register(0x2014, 400, functioncode=6)


def test_mbpoll_reads_and_writes(tc100: SimulatedDevice) -> None:
    tool = require_tool("mbpoll")
    common = [tool, "-m", "rtu", "-b", "19200", "-P", "none", "-a", "1", "-0", "-t", "4", "-o", "5"]
    write = subprocess.run(
        [*common, "-r", "2053", tc100.places["rtu"], "4321"], capture_output=True, text=True, timeout=HANGING
    )
    assert write.returncode == 0, write.stderr
    read = subprocess.run(
        [*common, "-r", "2053", "-1", tc100.places["rtu"]], capture_output=True, text=True, timeout=HANGING
    )
    assert "4321" in read.stdout


def test_serial_frames_are_served_over_tcp() -> None:
    with simulation("ck10", ports={"rtu": "tcp://127.0.0.1:0"}, folder=SPECS) as device:
        port = int(device.place.rpartition(":")[2])
        client = ModbusTcpClient("127.0.0.1", port=port, framer=FramerType.RTU, timeout=5)
        assert client.connect()
        assert client.read_holding_registers(0x0834, count=2, device_id=1).registers == [0, 104]
        client.close()


def test_telegrams_and_parameters_go_over_udp() -> None:
    places = {"cyclic": "udp://127.0.0.1:0", "parameter_channel": "udp://127.0.0.1:0"}
    with simulation("hiwin-e", ports=places, message="telegram_9", folder=SPECS) as device:
        cyclic, channel = (_connected(device.places[link]) for link in places)
        for control, status in ((0x0000, 0x40), (0x0406, 0x01), (0x0407, 0x03), (0x040F, 0x07)):
            cyclic.send(control.to_bytes(2, "big") + bytes(18))
            answer = cyclic.recv(1000)
            assert (len(answer), answer[1] & 0x47) == (10, status)
        channel.send(bytes.fromhex("01 01 00 01 10 00 25 34 00 00"))
        assert channel.recv(1000) == bytes.fromhex("01 01 00 01 06 01 00 64")
        cyclic.close()
        channel.close()


def _connected(place: str) -> socket.socket:
    host, _, port = place.removeprefix("udp://").rpartition(":")
    client = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    client.settimeout(5)
    client.connect((host, int(port)))
    return client


def test_packets_are_answered_after_the_printed_delay_and_dropped_after_the_printed_pause() -> None:
    with (
        simulation("esc11", unit_address=0, rate=4, folder=SPECS) as device,
        serial.Serial(device.place, timeout=3) as port,
    ):
        began = time.monotonic()
        port.write(bytes.fromhex("04 00 41 45"))
        assert port.read(8)[:3] == bytes.fromhex("08 00 00")
        assert time.monotonic() - began >= 0.2 / 4
        port.write(bytes.fromhex("04 00"))
        time.sleep(1.0)
        port.write(bytes.fromhex("04 00 30 34"))
        assert port.read(4) == bytes.fromhex("04 00 00 04")


@pytest.mark.proof(4)
@pytest.mark.parametrize(
    ("kind", "is_expected"),
    [
        ("no_answer", lambda damaged: damaged == b""),
        ("wrong_checksum", lambda damaged: damaged == RIGHT[:5] + bytes([RIGHT[5] ^ 0x55, RIGHT[6]])),
        ("exception", lambda damaged: damaged == rtu("01 83 04")),
        ("truncated", lambda damaged: RIGHT.startswith(damaged)),
        ("garbage", lambda damaged: damaged.endswith(RIGHT) and len(damaged) <= len(RIGHT) + 8),
        ("wrong_unit", lambda damaged: damaged == rtu(f"{damaged[0]:02X} 03 02 00 0A")),
        ("inserted_word", lambda damaged: damaged == rtu(damaged[:-2].hex()) and len(damaged) == len(RIGHT) + 2),
    ],
)
def test_a_fault_strikes_once(kind: str, is_expected: Callable[[bytes], bool]) -> None:
    with (
        simulation("ck10", ports={"rtu": "pty"}, folder=SPECS) as device,
        serial.Serial(device.place, timeout=0.8) as port,
    ):
        device.set(**{"registers/user_outputs": 10})
        device.fault(kind)
        port.write(rtu("01 03 04 10 00 01"))
        damaged = port.read(40)
        assert damaged != RIGHT
        assert is_expected(damaged), damaged.hex(" ")
        port.write(rtu("01 03 04 10 00 01"))
        assert port.read(7) == RIGHT


def test_a_listener_to_which_nobody_connects_says_so_and_can_be_closed() -> None:
    listener = Listener("tcp://127.0.0.1:0")
    connections: list[Connection | None] = []
    waiting = threading.Thread(target=lambda: connections.append(listener.accept()), daemon=True)
    waiting.start()
    waiting.join(60)
    listener.close()
    assert connections == [None]
    with pytest.raises(CarrierError, match="is closed"):
        listener.accept()


def test_a_read_in_another_thread_ends_where_its_connection_is_closed() -> None:
    listener = Listener("tcp://127.0.0.1:0")
    connection = Connection.opened(listener.name)
    ended: list[str] = []

    def read() -> None:
        try:
            connection.read(HANGING)
        except CarrierError as error:
            ended.append(str(error))

    reader = threading.Thread(target=read, daemon=True)
    reader.start()
    time.sleep(0.2)
    connection.close()
    reader.join(30)
    listener.close()
    assert len(ended) == 1


def test_what_is_sent_waits_for_a_client_that_is_slow_to_read() -> None:
    listener = Listener("tcp://127.0.0.1:0")
    content = bytes(1 << 24)
    with socket.create_connection(("127.0.0.1", int(listener.name.rpartition(":")[2]))) as client:
        connection = listener.accept()
        assert connection is not None
        assert connection.read(0) == b""
        received: list[int] = []

        def read_late() -> None:
            time.sleep(0.2)
            while sum(received) < len(content) and (data := client.recv(1 << 20)):
                received.append(len(data))

        reader = threading.Thread(target=read_late)
        reader.start()
        connection.write(content)
        reader.join(60)
        assert sum(received) == len(content)
        connection.close()
    listener.close()


def test_a_lost_connection_can_be_made_again() -> None:
    with simulation("ck10", ports={"rtu": "tcp://127.0.0.1:0"}, folder=SPECS) as device:
        port = int(device.place.rpartition(":")[2])
        device.fault("connection_lost")
        client = ModbusTcpClient("127.0.0.1", port=port, framer=FramerType.RTU, timeout=2, retries=0)
        assert client.connect()
        with pytest.raises(ModbusException):
            client.read_holding_registers(0x0834, count=1, device_id=1)
        assert client.connect()
        assert client.read_holding_registers(0x0835, count=1, device_id=1).registers == [104]
        client.close()


def test_a_late_answer_waits_by_the_clock_of_the_simulation() -> None:
    clock = ManualClock()
    with (
        simulation("ck10", ports={"rtu": "pty"}, clock=clock, folder=SPECS) as device,
        serial.Serial(device.place, timeout=5) as port,
    ):
        device.fault("late_answer", seconds=3600)
        port.write(rtu("01 03 08 35 00 01"))
        assert port.read(7)[:5] == bytes.fromhex("01 03 02 00 68")
        assert clock.now() >= 3600


@pytest.fixture
def running(tmp_path: Path) -> Iterator[Any]:
    """Starts `fieldspec simulate` with some arguments: the process, and the places that it prints."""
    processes = []

    def start(*arguments: str) -> tuple[subprocess.Popen[str], dict[str, str]]:
        command = [sys.executable, "-m", "fieldspec", "simulate", *arguments, "--specs", SPECS]
        process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=tmp_path
        )
        processes.append(process)
        assert process.stderr is not None
        places = {}
        while not places or select.select([process.stderr], [], [], 0.3)[0]:
            line = process.stderr.readline()
            assert line, "it has ended"
            if ", " in line and ": " in line:
                link, _, place = line.strip().partition(", ")[2].partition(": ")
                places[link] = place
        return process, places

    yield start
    for process in processes:
        process.kill()
        process.communicate()


def test_commands_come_from_standard_input(running: Any) -> None:
    process, _ = running("tc100", "--control")
    commands = [
        ({"set": {"alarm_code": "overcurrent"}}, True),
        ({"get": ["alarm_code", "axis/position", "state/alarm"]}, True),
        ({"fault": "no_answer", "count": 3}, True),
        ({"fault": "nothing"}, False),
        ({"get": ["nothing"]}, False),
        ({"set": {"alarm_code": "nothing"}}, False),
        ({"power": "cycle"}, True),
        ({"state": True}, True),
        ({"hello": 1}, False),
    ]
    output, _ = process.communicate(
        "\n".join(json.dumps(command) for command, _ in commands) + "\nnot json\n", timeout=HANGING
    )
    results = [json.loads(line) for line in output.splitlines()]
    assert [result["ok"] for result in results] == [*(ok for _, ok in commands), False]
    assert results[1]["values"] == {"alarm_code": 9, "axis/position": 5000.0, "state/alarm": "present"}


def test_a_recording_is_a_log_that_decode_reads(running: Any, tmp_path: Path) -> None:
    process, places = running("tc100", "--port", "rtu=pty", "--record", "traffic.log", "--control")
    with serial.Serial(places["rtu"], timeout=5) as port:
        port.write(rtu("01 03 10 00 00 01"))
        assert len(port.read(7)) == 7
        port.write(rtu("01 03 10 02 00 01"))
        assert port.read(5)[1] == 0x83
    process.communicate(timeout=HANGING)
    log = (tmp_path / "traffic.log").read_text("utf-8")
    assert [line.split()[1] for line in log.splitlines()] == ["request", "response"] * 2
    decode = [sys.executable, "-m", "fieldspec", "decode", "tc100", "-", "--specs", SPECS]
    decoded = subprocess.run(decode, input=log, capture_output=True, text=True, timeout=HANGING)
    assert "action_status" in decoded.stdout
    assert "illegal_data_address" in decoded.stdout


def test_a_device_begins_with_a_dump(running: Any, tmp_path: Path) -> None:
    (tmp_path / "dump.csv").write_text("address,value\n0x0805,444\n0x2002,0\n0x2003,77\n0x7777,1\n", "utf-8")
    process, _ = running("tc100", "--dump", "dump.csv", "--control")
    output, _ = process.communicate('{"get": ["registers/deceleration_time", "target_position"]}\n', timeout=HANGING)
    assert json.loads(output)["values"] == {"registers/deceleration_time": 444, "target_position": 77}


def test_faults_by_chance_are_the_same_for_the_same_seed() -> None:
    def silences(seed: int) -> list[int]:
        options: dict[str, Any] = {"faults": [{"fault": "no_answer", "probability": 0.3}], "seed": seed}
        with simulation("ck10", ports={"rtu": "tcp://127.0.0.1:0"}, folder=SPECS, **options) as device:
            line = device.simulation.line("rtu")
            request = rtu("01 03 08 35 00 01")
            return [number for number in range(40) if not list(line.feed(number, request))]

    assert silences(5) == silences(5) != silences(6)
    assert 4 < len(silences(5)) < 24


def test_a_script_says_when_faults_strike() -> None:
    faults: list[dict[str, Any]] = [
        {"fault": "no_answer", "request": 3, "count": 2},
        {"fault": "busy", "at": 100.0},
        {"fault": "power_cycle", "request": 7},
    ]
    with simulation("tc100", faults=faults, folder=SPECS) as device:
        line = device.simulation.line("rtu")
        request = rtu("01 03 10 00 00 01")
        answers = [[sending.data[1] for sending in line.feed(now, request)] for now in (1, 2, 3, 4, 5, 200, 201, 202)]
        assert answers == [[3], [3], [], [], [3], [], [], [3]]


def test_a_stuck_bit_and_a_value_out_of_range_stay() -> None:
    with simulation("tc100", folder=SPECS) as device:
        device.fault("stuck_bit", signal="in_position", value=0)
        device.fault("out_of_range", signal="registers/motion_speed", value=999)
        line = device.simulation.line("rtu")
        for request, expected in (("01 03 10 01 00 01", 0), ("01 03 20 14 00 01", 999)):
            (sending,) = line.feed(1.0, rtu(request))
            assert int.from_bytes(sending.data[3:5], "big") == expected


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (["nothing"], "there is no device nothing"),
        (["tc100@7"], "there is no version of tc100 7"),
        (["tc100", "--port", "usb=pty"], "there is no link usb"),
        (["tc100", "--port", "/dev/nothing-here"], "cannot open /dev/nothing-here"),
        (["tc100", "--port", "tcp://nowhere"], "is not an address"),
        (["tc100", "--port", "udp://127.0.0.1:0"], "is a serial line"),
        (["tc100", "--unit", "17"], "17 is not in 1..16"),
        (["hiwin-e", "--unit", "3"], "frames of hiwin-e have no unit address; leave out --unit"),
        (["tc100", "--fault", "rust=0.1"], "there is no fault `rust`"),
        (["tc100", "--fault", "no_answer"], "KIND=PROBABILITY"),
        (["tc100", "--faults", "nothing.jsonl"], "cannot read nothing.jsonl"),
        (["tc100", "--dump", "nothing.csv"], "cannot read nothing.csv"),
        (["hiwin-e", "--message", "750"], "only supplements others"),
        (["hiwin-e", "--message", "7"], "there is no cyclic message 7"),
    ],
)
def test_wrong_use_is_one_line(arguments: list[str], expected: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["simulate", *arguments, "--specs", SPECS]) == 2
    output = capsys.readouterr()
    assert output.out == ""
    assert expected in output.err.splitlines()[-1]


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (["tc100"], "unit address 1; --unit NUMBER chooses another\n"),
        (["esc11"], "unit address 0; --unit NUMBER chooses another\n"),
        (["tc100", "--unit", "2"], ""),
        (["hiwin-e"], "message telegram_3; --message NAME chooses another\n"),
    ],
)
def test_a_unit_address_and_a_message_that_nobody_has_chosen_are_printed(
    arguments: list[str], expected: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO())  # its end ends the device
    assert main(["simulate", *arguments, "--control", "--specs", SPECS]) == 0
    lines = capsys.readouterr().err.splitlines(keepends=True)
    assert "".join(line for line in lines if ": " not in line) == expected


def test_assumptions_are_listed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["simulate", "ck10", "--assumptions", "--specs", SPECS]) == 0
    assert "20000 pulses from its origin" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("line", "characters", "milliseconds"),
    [
        (LineSettings(19200, 8, "even", 1), 3.5, 2.005),
        (LineSettings(9600, 8, "none", 2), 1.5, 1.719),
        (LineSettings(9600, 8, "none", 1), 96, 100),
        (LineSettings(1200, 7, "odd", 1), 12, 100),
    ],
)
def test_characters_take_the_time_of_their_bits(line: LineSettings, characters: float, milliseconds: float) -> None:
    assert line.seconds(characters) == pytest.approx(milliseconds / 1000, abs=1e-6)
