"""Tables that begin where a register says: pymodbus judges them over TCP, as client and as server."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from pymodbus.client import ModbusTcpClient
from pymodbus.server import ModbusTcpServer
from pymodbus.simulator import DataType, SimData, SimDevice

from c_output.compilers import compiled
from command_line import CommandLine
from external_tools import require_tool
from fieldspec.cli import main
from fieldspec.codec.explain.occupants import occupants
from fieldspec.codec.explain.spans import Span
from fieldspec.codec.layout.bases import at_usual_bases
from fieldspec.codec.layout.read_plan import read_plan
from fieldspec.testing import SimulatedDevice, simulation
from fieldspec.tools.audit.register_dump import compared
from fieldspec.tools.lists.dump import dump
from fieldspec.tools.lists.text_sheet import text_sheet
from fieldspec.tools.simulator.seeding import seed
from js_output.explanations import explained_by_node, explained_by_python
from pymodbus_server import free_port, running
from recorder import FOLDER, LAYOUT, module, output_folder

SECONDS = 60
RECORDER = module("recorder.v1")
EVENTS = [(1000, -1, 3, 815), (2000, 0, 1, -7), (70000, 2, 255, 12)]
"""Time, exponent, channel and level of each event."""
PLACES = {own.path: own for own in occupants(at_usual_bases(LAYOUT), Span("holding_registers", 0, 0x10000, 0, b""))}
PLACES |= {own.path: own for own in occupants(LAYOUT, Span("input_registers", 0, 0x10000, 0, b""))}


def words(events: list[tuple[int, int, int, int]]) -> list[int]:
    """The words of events, as the spec has them."""
    return [
        word
        for time, exponent, channel, level in events
        for word in (time >> 16, time & 0xFFFF, (exponent & 0xFF) << 8 | channel, level & 0xFFFF)
    ]


def put(device: SimulatedDevice, path: str, raw: int) -> None:
    """Sets the raw value of a register or of a field."""
    space = "input_registers" if path == "setting_address" else "holding_registers"
    device.simulation.engine.memory.write(space, PLACES[path], raw)


@pytest.fixture(scope="module")
def device() -> Iterator[SimulatedDevice]:
    with simulation("recorder", ports={"tcp": "tcp://127.0.0.1:0"}, folder=str(FOLDER)) as running_device:
        for number, event in enumerate(EVENTS, 1):
            for field, raw in zip(("time", "level_sf", "channel", "level"), event, strict=True):
                put(running_device, f"events[{number}].{field}", raw)
        yield running_device


def port_of(device: SimulatedDevice) -> int:
    return int(device.place.rpartition(":")[2])


@pytest.fixture(scope="module")
def peer(device: SimulatedDevice) -> Iterator[Any]:
    """A client of pymodbus."""
    client = ModbusTcpClient("127.0.0.1", port=port_of(device), timeout=SECONDS)
    assert client.connect()
    yield client
    client.close()


def live(port: int, *arguments: str, unit: str = "1") -> int:
    """Runs a verb of `fieldspec live`."""
    place = ("--port", f"tcp://127.0.0.1:{port}", "--link", "tcp", "--unit", unit, "--timeout", "2")
    return main(["live", "recorder", *arguments, *place, "--specs", str(FOLDER)])


def events_read(port: int) -> Any:
    """The events that the generated client reads."""
    with module("transports").tcp("127.0.0.1", port) as transport:
        client = module("recorder.client").Client(transport, timeout=SECONDS)
        return [
            (event.time, event.level_sf, event.channel, event.level) for event in client.read_table(RECORDER.events)
        ]


@pytest.mark.parametrize(("base", "count"), [(0x0100, 3), (0x0101, 3), (0x0106, 1), (0x8000, 2)])
def test_a_table_of_a_simulated_device_is_where_its_register_says(
    device: SimulatedDevice, peer: Any, base: int, count: int, capsys: pytest.CaptureFixture[str]
) -> None:
    put(device, "event_address", base)
    put(device, "event_count", count)
    assert peer.read_holding_registers(0x10, count=2, device_id=1).registers == [base, count]
    assert peer.read_holding_registers(base, count=4 * count, device_id=1).registers == words(EVENTS[:count])
    for address in (base - 1, base + 4 * count):
        assert peer.read_holding_registers(address, count=1, device_id=1).isError()
    assert events_read(port_of(device)) == EVENTS[:count]
    assert live(port_of(device), "read", "events[1].level", "--format", "json") == 0
    (row,) = json.loads(capsys.readouterr().out)
    assert (row["address"], row["meaning"]) == (base + 3, "81.5 V")
    assert live(port_of(device), "dump", "-") == 0
    addresses = {
        int(line.split(",")[1], 16): line for line in capsys.readouterr().out.splitlines()[1:] if "holding" in line
    }
    assert set(range(base, base + 4 * count)) <= set(addresses)
    assert not set(addresses) & set(range(base + 4 * count, base + 12))


def test_a_register_in_another_space_says_where_values_are_written(device: SimulatedDevice, peer: Any) -> None:
    for base in (0x0200, 0x0203, 0x9000):
        put(device, "setting_address", base)
        number = base & 0xFF | 1
        assert live(port_of(device), "write", f"settings[1].threshold=-{number} mV", "--yes") == 0
        with module("transports").tcp("127.0.0.1", port_of(device)) as transport:
            client = module("recorder.client").Client(transport, timeout=SECONDS)
            client.write(RECORDER.settings.at_base(base)[0], RECORDER.Setting(threshold=5, delay=number))
        assert peer.read_holding_registers(base, count=4, device_id=1).registers[:3] == [5, number, 0x10000 - number]
        assert peer.write_registers(base + 3, [77], device_id=1).registers is not None
        assert device.simulation.engine.memory.read("holding_registers", PLACES["settings[1].delay"]) == 77


def test_a_dry_run_says_that_the_device_decides_on_the_address(capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["live", "recorder", "write", "settings[1].threshold=-5 mV", "--link", "tcp", "--unit", "1"]
    assert main([*arguments, "--dry-run", "--specs", str(FOLDER)]) == 0
    assert "its table begins where setting_address says" in capsys.readouterr().err


def test_a_scan_finds_a_table_where_it_is(device: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    put(device, "event_address", 0x0700)
    put(device, "event_count", 3)
    place = ("--port", device.place, "--link", "tcp", "--unit", "1", "--timeout", "2", "--specs", str(FOLDER))
    assert main(["scan", "recorder", "0x0100..0x010F", "0x0700..0x070F", *place, "--format", "json"]) == 0
    (space,) = json.loads(capsys.readouterr().out)["spaces"]
    assert (len(space["words"]), space["unknown"], space["silent"]) == (12, [], [])


def test_clients_follow_a_server_of_pymodbus(capsys: pytest.CaptureFixture[str]) -> None:
    holding = [
        SimData(0x10, values=[0x0321, 2], datatype=DataType.REGISTERS),
        SimData(0x0321, values=words(EVENTS[:2]), datatype=DataType.REGISTERS),
    ]
    pointer = [SimData(0, values=[0, 0x0210], datatype=DataType.REGISTERS)]
    bits = [SimData(0, values=[False] * 16, datatype=DataType.BITS)]
    server, port = SimDevice(1, simdata=(bits, bits, holding, pointer)), free_port()
    with running(lambda: ModbusTcpServer(server, address=("127.0.0.1", port))):
        assert events_read(port) == EVENTS[:2]
        assert live(port, "read", "events", "--format", "json") == 1
        rows = {row["name"]: row["meaning"] for row in json.loads(capsys.readouterr().out)}
    assert rows["events[2].time"] == "2000 s"
    assert rows["events[1].level"] == "81.5 V"
    assert rows["events[3].level"] == "refused: The device has no such element: event_count is 2."


def test_an_address_outside_its_range_is_said_and_not_used(
    device: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    put(device, "event_address", 0xFFF0)
    try:
        assert live(port_of(device), "read", "events[1].time", "--format", "json") == 1
        (row,) = json.loads(capsys.readouterr().out)
        assert (
            "event_address does not say where events begins: it is 65520, which is not within 32..32768"
            in row["meaning"]
        )
    finally:
        put(device, "event_address", 0x0100)


def test_a_generated_table_has_no_records_before_its_base_is_known() -> None:
    error = module("_error").CodecError
    table = RECORDER.events
    assert (table.base_by, table.base, table.at(0x0100)) == (RECORDER.EVENT_ADDRESS, 0x0100, None)
    for use in (lambda: table[1], lambda: list(table), lambda: table.present(1), lambda: table.read_requests(1)):
        with pytest.raises(error) as refused:
            use()
        assert refused.value.reason == "no_base"
    placed = table.at_base(0x0200)
    assert type(placed) is type(table)
    assert (placed[2].address, placed.at(0x0208).name, placed.base_by) == (0x0204, "events[3]", None)
    assert [register.address for register in placed.present(2)] == [0x0200, 0x0204]
    assert placed.count_by is RECORDER.EVENT_COUNT
    assert table.at_base(0xFFF4)[3].address == 0xFFFC
    for base, reason in ((0xFFF5, "out_of_range"), (-1, "out_of_range"), (True, "wrong_type"), (1.0, "wrong_type")):
        with pytest.raises(error) as refused:
            table.at_base(base)
        assert refused.value.reason == reason


PROGRAM = """
import {{ EVENTS, SETTINGS, EVENT_ADDRESS, SETTING_ADDRESS }} from "{module}";
const refused = (use) => {{ try {{ use(); return ""; }} catch (error) {{ return error.message; }} }};
console.log(JSON.stringify([
  EVENTS.baseBy === EVENT_ADDRESS, SETTINGS.baseBy === SETTING_ADDRESS, EVENTS.address,
  refused(() => EVENTS.at(1)), refused(() => EVENTS.present(1)),
  refused(() => EVENTS.atBase(0xfff5)), refused(() => EVENTS.atBase(-1)),
  EVENTS.atBase(0x0321).at(3).address, EVENTS.atBase(0x0321n).present(2).map(({{ address }}) => address),
  EVENTS.atBase(1).baseBy,
  SETTINGS.atBase(0xfffc).at(1).space,
]));
"""


def test_a_table_in_javascript_takes_its_base(tmp_path: Path) -> None:
    program = tmp_path / "program.mjs"
    program.write_text(PROGRAM.format(module=(output_folder("js") / "recorder/v1.js").as_uri()), "utf-8")
    run = subprocess.run([require_tool("node"), str(program)], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    message = "events begins where event_address says: use atBase"
    assert json.loads(run.stdout) == [
        *(True, True, 0x0100, message, message),
        *("events does not fit after the address 65525", "events does not fit after the address -1"),
        *(0x0329, [0x0321, 0x0325], None, "holding_registers"),
    ]


def test_the_function_in_c_takes_the_base(tmp_path: Path) -> None:
    source = tmp_path / "bases.c"
    source.write_text(
        '#include "recorder_v1.h"\n#include <stdio.h>\nint main(void) { uint16_t at = 0; int status;\n'
        + "".join(
            f"status = recorder_table_events_at({base}, {number}, &at);\n"
            'printf("%d %u\\n", status == RECORDER_OK, at);\n'
            for base, number in ((0x0321, 3), (0xFFF4, 3), (0xFFF5, 1), (0, 0), (0, 4))
        )
        + "return 0; }\n",
        "utf-8",
    )
    program = compiled("gcc", source, tmp_path / "bases", f"-I{output_folder('c')}")
    lines = subprocess.run([str(program)], capture_output=True, text=True, check=True).stdout.splitlines()
    assert [line.split()[0] for line in lines] == ["1", "1", "0", "0", "0"]
    assert [int(line.split()[1]) for line in lines[:2]] == [0x0329, 0xFFFC]
    tested = compiled("gcc", output_folder("c") / "recorder_v1_selftest.c", tmp_path / "selftest")
    assert " 0 failed" in subprocess.run([str(tested)], capture_output=True, text=True, check=True).stdout


def test_nobody_reads_usual_addresses_by_a_plan() -> None:
    spans = {(block.space, block.start, block.end) for block in read_plan(LAYOUT).blocks}
    assert spans == {("holding_registers", 0x10, 0x12), ("input_registers", 0, 2)}


def frames(first: int, content: list[int]) -> tuple[str, str]:
    """A request of Modbus TCP that reads holding registers, and its response."""
    data = b"".join(word.to_bytes(2, "big") for word in content)
    response = f"00010000{len(data) + 3:04X}0103{len(data):02X}{data.hex()}"
    return f"0001000000060103{first:04X}{len(content):04X}", response


NOTE = "Elements of events may be here: event_address has the address of the first one."


@pytest.mark.parametrize(
    ("first", "base", "elements", "known"),
    [
        (0x10, 0x20, 3, True),
        (0x10, 0x41, 3, True),
        (0x0F, 0x7F, 3, True),
        (0x10, 0x8000, 0, True),
        (0x10, 0x1F, 0, False),
        (0x20, 0x20, 0, False),
    ],
)
def test_a_frame_with_the_address_has_the_elements_that_follow_from_it(
    first: int,
    base: int,
    elements: int,
    known: bool,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    memory = dict.fromkeys(range(first, first + 125), 0) | {0x10: base, 0x11: 3} | dict(enumerate(words(EVENTS), base))
    request, response = frames(first, [memory[address] for address in range(first, first + 125)])
    module_path = str(output_folder("js") / "recorder/v1_explain.js")
    goes = {"link": "tcp", "direction": "response"}
    job = {"module": module_path, "frame": response, "request": request, "options": goes}
    run = CommandLine(capsys, monkeypatch, FOLDER)
    options = ("--request", request, "--link", "tcp", "--direction", "response", "--format", "json")
    registers = json.loads(run("decode", "recorder", response, *options)[1])["registers"]
    rows = {row["path"]: row for row in registers if (row["path"] or "").startswith("events[") and row["raw"]}
    assert {path.partition(".")[0] for path in rows} == {f"events[{number}]" for number in range(1, elements + 1)}
    if elements:
        assert rows["events[1].level"]["address"] == base + 3
    assert any(NOTE in row["notes"] for row in registers) != known
    (have,) = explained_by_node([job])[0]
    assert have == explained_by_python(LAYOUT, job)


def test_a_dump_with_the_address_has_the_elements_that_follow_from_it(
    tmp_path: Path, device: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "dump.csv"
    rows = {0x10: 0x0400, 0x11: 3} | dict(enumerate(words(EVENTS), 0x0400))
    path.write_text("address,value\n" + "".join(f"0x{address:04X},{word}\n" for address, word in rows.items()), "utf-8")
    report = compared(LAYOUT, dump(text_sheet(path.read_bytes()), {}))
    values = {value.name: value.number for value in report.read}
    assert (values["events[3].time"], values["events[2].level"], report.unknown) == (70000, -7, ())
    with simulation("recorder", ports={"tcp": "tcp://127.0.0.1:0"}, folder=str(FOLDER)) as seeded:
        assert seed(seeded.simulation.engine, dump(text_sheet(path.read_bytes()), {})) == (14, 0)
        assert events_read(port_of(seeded)) == EVENTS


def test_a_list_of_constant_addresses_leaves_moving_tables_out_and_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["export", "recorder", "--specs", str(FOLDER)]) == 0
    printed = capsys.readouterr()
    assert printed.err.count("warning[output_addresses_constant]") == 2
    assert {line.split(",")[3] for line in printed.out.splitlines()[1:]} == {
        "setting_address",
        "event_address",
        "event_count",
    }
