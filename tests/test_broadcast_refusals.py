"""A request that cannot be broadcast, as the spec says, is refused for the broadcast address by every encoder."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import pytest

from command_line import SPECS, CommandLine
from external_tools import require_tool
from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.reading.project import read
from fieldspec.targets.c.backend import files
from fieldspec.targets.explainer.device import explainer_data
from fieldspec.targets.js.backend import shared
from fieldspec.tools.proofs.running import outcome
from fieldspec_devices import errors, tc100
from fieldspec_devices.tc100 import client as tc100_client
from random_devices.c_driver import REASONS
from random_devices.javascript_judge import JavaScript
from random_devices.python_judge import Python, module_of_device
from random_devices.queries import Query
from random_devices.reference_answers import Reference
from random_devices.structured_text_judge import StructuredText

SPEC = """
device:
  id: faucet
  name: Faucet
  vendor: Maker
  manual: {title: Manual, file: faucet.txt, sha256: "DIGEST", lines: 100}
links:
  - name: bus
    title: A bus
    source: 1 L1
    transmission: binary
    byte_order: big
    word_order: big
    request: &bus
      - {name: station, role: unit_address, type: u8}
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
      - {name: crc, role: checksum, algorithm: crc16_modbus}
    response: *bus
    unit_addresses: {range: 1..16, broadcast: 0, source: 1 L1}
messages:
  - name: ask
    code: 0x10
    source: 2 L1
    broadcast: false
    request: &level [{name: level, type: u16}]
    response: *level
  - name: list
    code: 0x11
    source: 2 L1
    broadcast: false
    request: &levels [{name: levels, type: u16, repeat: 1..3}]
    response: *levels
  - {name: pour, code: 0x12, source: 2 L1, broadcast: true, request: *level, response: *level}
  - {name: stir, code: 0x13, source: 2 L1, request: *level, response: *level}
""".replace("DIGEST", "0" * 64)

REFUSED, ACCEPTED = "out_of_range", ""
ANSWERS: dict[tuple[str, str, int], str] = {
    ("request", "ask", 0): REFUSED,
    ("request", "ask", 1): ACCEPTED,
    ("request", "ask", 16): ACCEPTED,
    ("request", "list", 0): REFUSED,
    ("request", "list", 1): ACCEPTED,
    ("request", "pour", 0): ACCEPTED,
    ("request", "stir", 0): ACCEPTED,
    ("response", "ask", 0): ACCEPTED,
}
"""The reasons of encoders by direction, message and unit address. Where a spec says nothing, nothing is refused."""
REQUESTS = {key: reason for key, reason in ANSWERS.items() if key[0] == "request"}


def read_device() -> DeviceLayout:
    project = read({"faucet/device.yaml": SPEC.encode()})
    assert not has_errors(project.findings), project.findings[0].message
    spec = project.devices["faucet"]
    assert outcome(spec).findings == []
    return device_layout(spec.at(spec.versions()[0])[0])


@pytest.fixture(scope="module")
def layout() -> DeviceLayout:
    return read_device()


def values_of(message: str, station: int) -> dict[str, Any]:
    return {"station": station, **({"levels": [5]} if message == "list" else {"level": 5})}


def encoding(layout: DeviceLayout, direction: str, message: str, station: int) -> Query:
    """The question for a frame to a unit address."""
    shaped = layout.messages[message]
    path = ("bus", direction, message)
    return Query(
        "frame", path, values=values_of(message, station), code=shaped.message.code, shape=shaped.data(direction)
    )


@pytest.mark.parametrize("judge", [Reference, Python, JavaScript])
def test_the_broadcast_address_is_refused(judge: Any, layout: DeviceLayout, tmp_path: Path) -> None:
    queries = [encoding(layout, *key) for key in ANSWERS]
    if judge is Reference:
        reasons = [Reference(layout).answer(query).reason for query in queries]
    else:
        reasons = [answer.reason for answer in judge(layout, tmp_path, 1).answers(queries)]
    assert dict(zip(ANSWERS, reasons, strict=True)) == ANSWERS


def test_c_refuses_it(layout: DeviceLayout, tmp_path: Path) -> None:
    for path, text in files([layout]).items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    header = next(path for path in files([layout]) if path.endswith(".h"))
    statements = []
    for direction, message, station in ANSWERS:
        filling = "in.levels_count = 1; in.levels[0] = 5;" if message == "list" else "in.level = 5;"
        call = f"faucet_bus_encode_{message}_{direction}({station}, &in, out, sizeof out, &length)"
        statements.append(f'{{ faucet_{message}_{direction} in = {{0}}; {filling} printf("%d\\n", (int){call}); }}')
    source = tmp_path / "main.c"
    source.write_text(
        f'#include <stdio.h>\n#include "{header}"\n'
        "int main(void) { uint8_t out[64]; size_t length;\n" + "\n".join(statements) + "\nreturn 0; }\n",
        "utf-8",
    )
    command = [
        require_tool("gcc"),
        "-std=c99",
        "-Wall",
        "-Wextra",
        "-Werror",
        "-o",
        str(tmp_path / "main"),
        str(source),
    ]
    compiled = subprocess.run(command, capture_output=True, text=True, check=False)
    assert compiled.returncode == 0, compiled.stderr
    printed = subprocess.run([str(tmp_path / "main")], capture_output=True, text=True, check=True).stdout
    reasons = ["" if number == "0" else REASONS[int(number)] for number in printed.split()]
    assert dict(zip(ANSWERS, reasons, strict=True)) == ANSWERS


def test_structured_text_refuses_it(layout: DeviceLayout, tmp_path: Path) -> None:
    prover = StructuredText(layout, tmp_path).prover
    assert prover is not None
    link = layout.links["bus"]
    answers = {
        (direction, message, station): prover.build(link, layout.messages[message], values_of(message, station))[0]
        for direction, message, station in REQUESTS
    }
    assert answers == {key: reason or "ok" for key, reason in REQUESTS.items()}


ENCODE = """
import { ExplainedDevice } from "./runtime/explain/device.js";
import { encodeFrame } from "./runtime/explain/encoding.js";
import { dataOf } from "./data.js";
import { readFileSync } from "node:fs";
const { asked } = JSON.parse(readFileSync(process.argv[2], "utf8"));
const device = new ExplainedDevice(dataOf);
for (const [direction, message, values] of asked) {
  try {
    encodeFrame(device, { link: "bus", direction, message }, new Map(Object.entries(values)));
    console.log("ok");
  } catch (error) {
    console.log(error.reason);
  }
}
"""


def test_the_lab_refuses_it(layout: DeviceLayout, tmp_path: Path) -> None:
    for path, text in {**shared(), "package.json": '{"type": "module"}'}.items():
        place = tmp_path / path
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text, "utf-8")
    (tmp_path / "encode.js").write_text(ENCODE, "utf-8")
    asked = [(direction, message, values_of(message, station)) for direction, message, station in ANSWERS]
    (tmp_path / "data.js").write_text(f"export const dataOf = {explainer_data(layout)};", "utf-8")
    (tmp_path / "asked.json").write_text(json.dumps({"asked": asked}), "utf-8")
    command = [require_tool("node"), str(tmp_path / "encode.js"), str(tmp_path / "asked.json")]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert dict(zip(ANSWERS, run.stdout.split(), strict=True)) == {
        key: reason or "ok" for key, reason in ANSWERS.items()
    }


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (("read_registers", "station=0", "address=0x1000", "word_count=1"), 2),
        (("read_registers", "station=1", "address=0x1000", "word_count=1"), 0),
        (("write_register", "station=0", "address=0x201E", "value=3"), 0),
    ],
)
def test_the_command_line_refuses_it_for_a_read(
    arguments: tuple[str, ...], code: int, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    result = CommandLine(capsys, monkeypatch, SPECS)("encode", "tc100", *arguments, "--link", "rtu")
    assert result.code == code
    assert ("station is 0: read_registers cannot be broadcast" in result.err) == bool(code)


class Silence:
    """A transport that records what is sent."""

    def __init__(self) -> None:
        self.sent: list[bytes] = []

    def write(self, data: bytes) -> None:
        self.sent.append(data)

    def read(self, timeout: float) -> bytes:
        return b""

    def discard(self) -> None:
        """Nothing is ever there."""


def test_a_client_sends_nothing_to_all_stations_that_cannot_be_broadcast() -> None:
    transport = Silence()
    client = tc100_client.Client(transport, link="rtu", pause=0.0)
    with pytest.raises(errors.InvalidValueError, match="station is 0: read_registers cannot be broadcast"):
        client.send(tc100.ReadRegistersRequest(0x1000, 1), unit_address=0)
    assert transport.sent == []
    client.send(tc100.WriteRegisterRequest(0x201E, 3), unit_address=0)
    assert [frame[:2].hex() for frame in transport.sent] == ["0006"]


def test_decoders_take_what_somebody_else_has_sent(layout: DeviceLayout) -> None:
    frame = bytes.fromhex("00 10 00 05")
    codec = Reference(layout).codec.links["bus"]
    whole = frame + codec.link.request.checksums[0].checksum(frame + b"\0\0")
    assert codec.decode(whole, "request").values == {"level": 5}
    assert module_of_device(layout, 77).bus.decode_request(whole).message.level == 5
