"""The examples of docs/plc.md are parsed, and run against what is generated and against devices that are simulated."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from blark.parse import parse_source_code

sys.path.insert(0, str(Path(__file__).parent))

from loaded import program_of
from page import PAGE, blocks, example
from scans import Scans, of_siemens

from fieldspec.codec.reference import codec
from fieldspec.targets.st.backend import text
from layouts import SPECS, newest

CHANNEL = "xExecute : BOOL; iChannelIndex : INT; xDone : BOOL; xError : BOOL;"
SERIAL = {
    "ClearComBuffer": "Unused : BOOL;",
    "SendByte": "SendByte : BYTE; Busy : BOOL;",
    "ReceiveByte": "ByteReceived : BOOL; ReceivedByte : BYTE;",
    "TON": "IN : BOOL; Q : BOOL;",
}


@cache
def generated(device: str) -> str:
    """The newest version of a device as Structured Text."""
    return text(program_of(SPECS, device))


@pytest.mark.parametrize("block", [*blocks("iecst"), *map(of_siemens, blocks("scl"))])
def test_an_example_parses(block: str) -> None:
    result = parse_source_code(block)
    assert result.exception is None, (result.exception, block)


@pytest.mark.parametrize("block", blocks("python"))
def test_a_recipe_is_python(block: str) -> None:
    ast.parse(block)


@pytest.mark.parametrize("block", blocks("sh"))
def test_a_command_of_the_page_runs(block: str, built: Path) -> None:
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    result = subprocess.run(
        ["sh", "-e", "-c", block], cwd=built, env={**os.environ, "PATH": path}, capture_output=True, encoding="utf-8"
    )
    assert result.returncode == 0, result.stderr


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder where the first command of the page has run."""
    folder = tmp_path_factory.mktemp("plc_page")
    (folder / "specs").symlink_to(SPECS)
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    subprocess.run(["sh", "-e", "-c", blocks("sh")[0]], cwd=folder, env={**os.environ, "PATH": path}, check=True)
    return folder


def test_every_file_and_every_generated_name_of_the_page_is_built(built: Path) -> None:
    everything = "".join(
        path.read_text("utf-8").lstrip("\ufeff")
        for path in built.rglob("*")
        if path.suffix in (".st", ".scl", ".udt", ".db", ".xml")
    )
    names = set(re.findall(r"\b(?:F|E|ST|GVL)_(?:Tc100|Esc11|HiwinE)_\w+", PAGE))
    assert len(names) > 15
    assert {name for name in names if not re.search(rf"\b{name}\b", everything)} == set()
    for path in re.findall(r"`(?:generated/)?((?:plcopen|st|twincat|iec|scl|kv|hmi)/[\w./]+)`", PAGE):
        if "DEVICE" not in path:
            assert (built / "generated" / path).exists(), path
    for name in re.findall(r'"(hiwin_e_\w+\.(?:udt|db|scl))"', PAGE):
        assert (built / "generated" / "scl" / name).exists(), name


# The TC100, by Modbus


class Controller:
    """The registers of a TC100 and how they change; `polls` readings pass before a move has ended."""

    def __init__(self, polls: int) -> None:
        self.words: dict[int, int] = dict.fromkeys(range(0x1000, 0x100F), 0)
        self.polls, self.left = polls, 0
        self.written: list[tuple[int, list[int]]] = []

    def write(self, address: int, words: list[int]) -> None:
        self.written.append((address, words))
        self.words.update(zip(range(address, address + len(words)), words, strict=True))
        if address == 0x2011:
            self.words[0x100C] = 1 - words[0]
        if address == 0x201E and words == [1]:
            self.left = self.polls
            self.words[0x1000], self.words[0x1001] = 1, 0

    def read(self, address: int, count: int) -> list[int]:
        if address == 0x1000 and self.words[0x1000] == 1:
            self.left -= 1
            if self.left == 0:
                self.words[0x1000], self.words[0x1001] = 0, 1
                self.words[0x1008], self.words[0x1009] = self.words[0x2002], self.words[0x2003]
        return [self.words[address + at] for at in range(count)]


def channels() -> list[tuple[int, int, int, str]]:
    """The table of channels: function code, offset, length and variable."""
    rows = re.findall(r"^\| (\d) \| .*function code (\d+)\) \| 0x(\w+) \| (\d+) \| `(\w+)` \|$", PAGE, re.MULTILINE)
    assert [int(row[0]) for row in rows] == list(range(6))
    return [(int(code), int(offset, 16), int(length), name.lower()) for _, code, offset, length, name in rows]


def moved(controller: Controller, **arguments: Any) -> Scans:
    """The example of the TC100, run until it is done or has failed."""
    scans = Scans(generated("tc100"), example("iecst", "PRG_Tc100Move"), {"IoDrvModbus.ModbusChannel": CHANNEL})
    variables = scans.variables
    variables.update(arguments)
    scans.scan()
    variables["xstart"] = True
    before = False
    for _ in range(300):
        scans.scan()
        block = variables["fbchannel"]
        rising, before = block["xexecute"] and not before, block["xexecute"]
        block["xdone"] = block["xdone"] and block["xexecute"]
        if rising:
            code, offset, length, name = channels()[block["ichannelindex"]]
            if code == 3:
                variables[name][:] = controller.read(offset, length)
            else:
                value = variables[name]
                controller.write(offset, list(value) if isinstance(value, list) else [value])
                assert len(controller.written[-1][1]) == length
            block["xdone"] = True
        if variables["xdone"] or variables["xerror"]:
            return scans
    raise AssertionError("it goes on")


@pytest.mark.parametrize("target", [123456, -70000, 0x7FFFFFFF])
def test_the_tc100_moves_to_its_target_and_is_awaited(target: int) -> None:
    controller = Controller(polls=3)
    scans = moved(controller, ditarget=target, uispeed=30)
    assert (scans.variables["xdone"], scans.variables["xerror"]) == (True, False)
    high, low = divmod(target & 0xFFFFFFFF, 1 << 16)
    assert controller.written == [(0x2011, [0]), (0x2002, [high, low]), (0x2014, [30]), (0x201E, [1])]
    assert controller.left == 0
    assert scans.variables["ststatus"]["dicommandposition"] == target
    scans.variables["xstart"] = False
    scans.scan()
    assert scans.variables["istep"] == 0


def test_what_is_written_to_the_tc100_is_what_its_registers_take() -> None:
    controller = Controller(polls=1)
    moved(controller, ditarget=-5, uispeed=100)
    layout = newest(SPECS, "tc100")
    for address, words in controller.written:
        register = next(register for register in layout.registers if register.address == address)
        assert register.register.words == len(words)
    names = {register.address: register.name for register in layout.registers}
    assert [names[address] for address, _ in controller.written] == [
        "servo",
        "absolute_position",
        "motion_speed",
        "motion_command",
    ]


@pytest.mark.parametrize(("address", "value"), [(0x1005, 3), (0x100D, 12)])
def test_an_alarm_and_a_fault_end_the_move_with_an_error(address: int, value: int) -> None:
    controller = Controller(polls=2)
    controller.words[address] = value
    assert moved(controller, ditarget=1).variables["xerror"]


def test_a_speed_above_the_range_is_never_sent() -> None:
    controller = Controller(polls=1)
    scans = moved(controller, ditarget=1, uispeed=101)
    assert scans.variables["xerror"]
    assert controller.written == []


# The ESC11, by packets


def gripped(answer: Callable[[bytes], bytes]) -> tuple[Scans, list[bytes]]:
    """The example of the ESC11, run until it is done or has failed, and the packets that it has sent."""
    scans = Scans(generated("esc11"), example("iecst", "PRG_Esc11Grip"), SERIAL)
    value = scans.variables
    scans.scan()
    value["xstart"] = True
    sent, line, coming = [], bytearray(), bytearray()
    for _ in range(400):
        step = value["istep"]
        scans.scan()
        if step == 20:
            line.append(value["fbsend"]["sendbyte"])
        if step == 20 and value["istep"] == 30:
            sent.append(bytes(line))
            coming[:] = answer(bytes(line))
            line.clear()
        block = value["fbreceive"]
        block["bytereceived"] = value["istep"] == 30 and bool(coming)
        if block["bytereceived"]:
            block["receivedbyte"] = coming.pop(0)
        value["fbtimeout"]["q"] = value["fbtimeout"]["in"] and not block["bytereceived"] and step == 30
        value["fbpause"]["q"] = value["fbpause"]["in"]
        if value["xdone"] or value["xerror"]:
            return scans, sent
    raise AssertionError("it goes on")


def understood(request: bytes) -> tuple[str, dict[str, Any]]:
    """The message of a packet and the parts of its head, by the reference."""
    meaning = codec(newest(SPECS, "esc11")).links["serial"].decode(request, "request")
    assert meaning.message is not None
    return meaning.message.name, meaning.head


def answers(*statuses: int) -> Callable[[bytes], bytes]:
    """A gripper that answers with these states, one after the other."""
    left = list(statuses)

    def answer(request: bytes) -> bytes:
        assert understood(request)[1]["address"] == 0
        body = bytes([4, 0, left.pop(0)])
        return body + bytes([sum(body) & 255])

    return answer


def test_the_esc11_grips_with_the_bytes_of_the_manual_and_is_asked_until_it_has_ended() -> None:
    examples = newest(SPECS, "esc11").device.examples
    scans, sent = gripped(answers(0x03, 0x03, 0x01, 0x00))
    assert (scans.variables["xdone"], scans.variables["xerror"]) == (True, False)
    assert sent[0] == examples["grip-close-request"].frame
    assert [understood(frame)[0] for frame in sent] == ["grip_close", *["no_operation"] * 3]


@pytest.mark.parametrize("status", [0x20, 0x40])
def test_a_wrong_command_and_an_alarm_end_the_grip_with_an_error(status: int) -> None:
    scans, sent = gripped(answers(status))
    assert scans.variables["xerror"]
    assert len(sent) == 1


def test_a_gripper_that_keeps_silent_is_asked_three_times() -> None:
    scans, sent = gripped(lambda request: b"")
    assert scans.variables["xerror"]
    assert len(sent) == 3


def test_a_damaged_answer_ends_the_grip_with_an_error() -> None:
    assert gripped(lambda request: bytes.fromhex("04 00 03 08"))[0].variables["xerror"]
