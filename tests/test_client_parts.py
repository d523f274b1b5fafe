"""Parts before the body whose values no spec states: clients count those that number requests, users choose others."""

from __future__ import annotations

import asyncio
import importlib
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from fieldspec.cli import main
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference.frames import codec
from fieldspec.command.pipeline import layouts, load
from fieldspec.language.behaviour.reading import behaviour_of
from fieldspec.targets.python.backend import PACKAGE, files, shared
from fieldspec.testing import simulation
from fieldspec.tools.live.client import Client, NoAnswerError, Timing
from fieldspec.tools.live.messages import signals
from fieldspec.tools.simulator.engine import Engine
from fieldspec.tools.simulator.server import Server
from layouts import TEST_SPECS, newest
from python_package import module_of, runtime, write

SPEC = """
device:
  id: meter
  name: Meter
  vendor: Nobody
  manual: {title: The meter of nothing, file: meter.txt, sha256: "%s", lines: 99}
links:
  - name: line
    transmission: binary
    byte_order: little
    source: 1 L1
    request: &line
      - {name: station, role: unit_address, type: u8}
      - {name: meter_address, type: u32}
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
    response: *line
  - name: counted
    transmission: binary
    byte_order: little
    source: 1 L2
    request:
      - {name: sequence, type: u8, range: "3..4, 7"}
      - {name: timeout, type: u8}
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
    response:
      - {name: echo, type: u8, range: "3..4, 7", same_as: sequence}
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
  - name: flagged
    transmission: binary
    byte_order: little
    source: 1 L3
    request: &flagged
      - {name: adr, type: u8, flags: adr}
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
    response: *flagged
  - name: routed
    transmission: binary
    byte_order: little
    source: 1 L5
    request:
      - {name: meter, type: u8}
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
    response:
      - {name: meter, type: u8, same_as: meter}
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
flags:
  - {name: adr, type: u8, source: 1 L4, bits: [{bits: 0..4, name: station}, {bit: 5, name: broadcast}]}
messages:
  - name: read
    code: 1
    links: [line]
    source: 2 L1
    request: [{name: address, type: u16}, {name: words, type: u8, range: 1..20}]
    response: [{name: values, type: u16, repeat: 1..20}]
    accesses: [{operation: read, start: address, count: words, values: values}]
  - {name: ping, code: 2, links: [counted, flagged, routed], source: 2 L2, request: [], response: []}
  - {name: state, code: 3, links: [counted], source: 2 L5, request: [], response: [{name: volume, type: u8}]}
registers:
  - group: readings
    section: "2"
    source: L3
    rows:
      - {at: 0, name: voltage, type: u16, checked: {words: 1}, access: ro, source: L4}
"""
TEXT = SPEC.replace("%s", "1" * 64)


class Line:
    """A line that notes what is sent, and brings the next of some frames."""

    datagrams = True

    def __init__(self, *answers: str) -> None:
        self.answers = [bytes.fromhex(answer) for answer in answers]
        self.sent: list[str] = []
        self.due: list[bytes] = []

    def write(self, data: bytes) -> None:
        """Takes a request."""
        self.sent.append(data.hex(" ").upper())
        self.due = self.answers[:1]
        del self.answers[:1]

    def read(self, limit: float) -> bytes:
        """The answer that is due."""
        return self.due.pop() if self.due else b""

    def close(self) -> None:
        """Nothing is open."""


class AsyncLine(Line):
    """The same for asyncio."""

    async def write(self, data: bytes) -> None:  # type: ignore[override]
        """Takes a request."""
        super().write(data)

    async def read(self, limit: float) -> bytes:  # type: ignore[override]
        """The answer that is due."""
        return super().read(limit)


@pytest.fixture(scope="module")
def meter() -> DeviceLayout:
    return layouts(load({"meter/device.yaml": TEXT.encode()}).devices["meter"])[0]


@pytest.fixture(scope="module")
def module(meter: DeviceLayout, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    folder = tmp_path_factory.mktemp("meter")
    outputs = shared() | files([meter])
    write(folder, {path.replace(PACKAGE, "devices_of_meter", 1): text for path, text in outputs.items()})
    sys.path.insert(0, str(folder))
    yield importlib.import_module("devices_of_meter.meter")
    sys.path.remove(str(folder))


@pytest.fixture
def client(module: Any) -> Any:
    return importlib.import_module("devices_of_meter.meter.client")


@pytest.fixture
def errors(module: Any) -> Any:
    return importlib.import_module("devices_of_meter.errors")


def test_all_requests_have_the_part_that_the_user_chooses(module: Any, client: Any, errors: Any) -> None:
    line = Line("01 09 00 00 00 01 E6 00 F1")
    meter = client.Client(line, link="line", unit_address=1, meter_address=0x01020304, retries=1, timeout=0.001)
    assert meter.read(module.VOLTAGE) == 0xE6
    with pytest.raises(errors.NoAnswerError):
        meter.read(module.VOLTAGE)
    assert set(line.sent) == {"01 04 03 02 01 01 00 00 01 0D"}
    assert len(line.sent) == 3


def test_an_asynchronous_client_has_the_same_parts(module: Any, client: Any) -> None:
    line = AsyncLine("01 09 00 00 00 01 E6 00 F1")
    meter = client.AsyncClient(line, link="line", unit_address=1, meter_address=9)
    assert asyncio.run(meter.read(module.VOLTAGE)) == 0xE6
    assert line.sent == ["01 09 00 00 00 01 00 00 01 0C"]


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ({"link": "line"}, "requests on this link have a part meter_address, which needs a value"),
        ({"link": "flagged"}, "requests on this link have a part adr, which needs a value"),
        ({"link": "routed"}, "requests on this link have a part meter, which needs a value"),
        ({"link": "line", "meter_address": 1, "timeout_": 3}, "requests on this link have no part timeout"),
    ],
)
def test_a_client_refuses_parts_that_lack_or_that_its_link_does_not_have(
    client: Any, arguments: Any, text: str
) -> None:
    with pytest.raises(ValueError, match=text):
        client.Client(Line(), **arguments)


def test_a_part_that_the_response_repeats_is_counted_beside_one_that_the_user_chooses(module: Any, client: Any) -> None:
    line = Line("03 02 05", "04 02 06", "03 02 05")
    meter = client.Client(line, link="counted", timeout_=5, timeout=0.001)
    assert [meter.ask(module.PingRequest()).echo for _ in range(3)] == [3, 4, 3]
    assert line.sent == ["03 05 02 0A", "04 05 02 0B", "03 05 02 0A"]


def test_a_repeated_part_is_no_number_of_requests_unless_its_name_says_so(
    module: Any, client: Any, errors: Any
) -> None:
    line = Line("09 02 0B", "08 02 0A")
    meter = client.Client(line, link="routed", meter=9, timeout=0.001)
    assert meter.ask(module.PingRequest()).meter == 9
    with pytest.raises(errors.NoAnswerError):
        meter.ask(module.PingRequest())
    assert line.sent == ["09 02 0B", "09 02 0B"]


def test_a_part_may_be_a_word_of_flags(module: Any, client: Any) -> None:
    line = Line("04 02 06")
    meter = client.Client(line, link="flagged", adr=module.Adr(station=4))
    assert meter.ask(module.PingRequest()).adr.station == 4
    assert line.sent == ["04 02 06"]


def test_a_request_of_another_link_is_refused_with_the_links_that_carry_it(
    module: Any, client: Any, errors: Any
) -> None:
    line = Line()
    meter = client.Client(line, link="line", meter_address=1)
    with pytest.raises(errors.InvalidValueError, match="PingRequest is not sent on this link, but on counted, flag"):
        meter.ask(module.PingRequest())
    assert line.sent == []


def test_of_several_repeated_parts_without_the_name_of_a_number_none_is_counted() -> None:
    sequencer = module_of(newest(TEST_SPECS, "sequencer"))
    owner = importlib.import_module(f"{sequencer.__package__}.client")
    with pytest.raises(TypeError, match=r"'network', 'pc', 'module_io'.* 'timer'"):
        owner.Client(Line())


def test_a_refusal_by_a_part_says_its_number_and_its_name() -> None:
    scanner = module_of(newest(TEST_SPECS, "scanner"))
    owner = importlib.import_module(f"{scanner.__package__}.client")
    for answer, number, text in (("05 02 10 17", 2, "exception 2, busy"), ("05 09 10 1E", 9, "exception 9$")):
        with pytest.raises(runtime("errors").RefusedError, match=text) as refused:
            owner.Client(Line(answer), link="panel", unit_address=5).ask(scanner.ReadStateRequest())
        assert refused.value.number == number


def test_the_live_client_counts_only_numbers_of_requests(meter: DeviceLayout) -> None:
    for link, message, fixed, sent in (
        ("line", "read", {"meter_address": 9}, ["01 09 00 00 00 01 00 00 01 0C"] * 2),
        ("counted", "ping", {"timeout": 5}, ["03 05 02 0A", "04 05 02 0B"]),
        ("flagged", "ping", {"adr": 4}, ["04 02 06"] * 2),
        ("routed", "ping", {"meter": 9}, ["09 02 0B"] * 2),
    ):
        line = Line()
        owner = Client(meter, link, line, 1, Timing(0.001, 0, 1), fixed=fixed)
        with pytest.raises(NoAnswerError):
            owner.ask(message, {"address": 0, "words": 1} if message == "read" else {})
        assert line.sent == sent


def test_the_simulator_repeats_a_part_under_another_name(meter: DeviceLayout) -> None:
    request = codec(meter).links["counted"].encode("request", "ping", {"sequence": 7, "timeout": 5})
    spec = load({"meter/device.yaml": TEXT.encode()}).devices["meter"]
    assert Server(Engine(meter, behaviour_of(spec.tree))).answer("counted", request).frame.hex() == "070209"


def test_live_takes_a_part_that_no_spec_states(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "meter").mkdir()
    (tmp_path / "meter" / "device.yaml").write_text(TEXT, encoding="utf-8")
    with simulation("meter", ports={"line": "tcp://127.0.0.1:0"}, unit_address=1, folder=str(tmp_path)) as device:
        command = ["live", "meter", "read", "voltage", "--link", "line", "--specs", str(tmp_path), "--unit", "1"]
        command += ["--port", device.places["line"]]
        assert main([*command, "--with", "meter_address=0x01020304"]) == 0
        assert "voltage" in capsys.readouterr().out
        assert main(command) == 2
        assert "meter_address is not given; add it with --with NAME=VALUE" in capsys.readouterr().err


def test_encode_writes_a_register_with_a_part_that_no_spec_states(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write = """messages:
  - name: set
    code: 4
    links: [line]
    source: 2 L6
    request: [{name: address, type: u16}, {name: value, type: u16}]
    response: []
    accesses: [{operation: write, start: address, values: value}]
"""
    text = TEXT.replace("messages:\n", write).replace("access: ro", "access: rw")
    (tmp_path / "meter").mkdir()
    (tmp_path / "meter" / "device.yaml").write_text(text, encoding="utf-8")
    command = ["encode", "meter", "write", "voltage=5", "--link", "line", "--specs", str(tmp_path), "--format", "hex"]
    assert main(command) == 2
    assert "meter_address is not given" in capsys.readouterr().err
    assert main([*command, "meter_address=0x01020304"]) == 0
    assert "04030201" in capsys.readouterr().out.replace(" ", "")
    assert main([*command, "meter_address=far"]) == 2
    assert capsys.readouterr().err.startswith("fieldspec: meter_address=far: ")


def test_a_part_that_repeats_one_of_the_request_says_nothing_about_the_device(meter: DeviceLayout) -> None:
    assert [signal.path for signal in signals(meter, meter.links["counted"])] == ["state.volume"]
