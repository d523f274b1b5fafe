"""The blocks that exchange messages are compiled and run against a device that answers, errs, or keeps silent."""

from __future__ import annotations

import random
import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compiled import Block, Compiled
from loaded import programs
from st_syntax import parsed
from standard_text import anonymous, named, needed, without_comments
from test_scl_execution import siemens_text

from fieldspec.codec.reference import codec
from fieldspec.targets.controllers.routines.exchanges import ERRORS
from fieldspec.targets.iec.backend import source, text
from layouts import SPECS, newest

DEVICES = [(device, link) for device in ("tc100", "ck10") for link in ("rtu", "ascii")]
TRY = 10
"""Scans of 100 ms in which a try ends: its time is 500 ms."""
STATION, ADDRESS, COUNT = 3, 0x2002, 2


class Line:
    """A block, and what is on the other side of its line: `answer` makes an answer of a request, or keeps silent."""

    def __init__(self, device: str, link: str, message: str, folder: Path, dialect: str = "iec") -> None:
        layout = newest(SPECS, device)
        self.codec, self.message = codec(layout).links[link], message
        functions = text(source(layout)) if dialect == "iec" else siemens(device)
        words = (link, *message.split("_"))
        prefix = "FB_" if dialect == "iec" else ""
        name = f"{prefix}{device.title()}_{''.join(word.title() for word in words)}"
        functions = needed(functions, [name])
        unpacked_text = anonymous(functions) if dialect == "iec" else functions
        unit = parsed(unpacked_text)
        match = re.search(
            rf"FUNCTION_BLOCK ({prefix}\w+_{link}{message.replace('_', '')})\n(.*?)END_FUNCTION_BLOCK",
            unpacked_text,
            re.S | re.I,
        )
        assert match, (link, message)
        sections = dict(re.findall(r"^(VAR\w*)\n(.*?)^END_VAR", without_comments(match.group(2)), re.M | re.S))
        variable = re.compile(r"^\s*(\w+) : ([^;]+?)(?: :=[^;]*)?;", re.M)
        inputs, outputs, arrays = (
            {f"{name[:1].upper()}{name[1:]}": kind for name, kind in variable.findall(sections[f"VAR_{role}"])}
            for role in ("INPUT", "OUTPUT", "IN_OUT")
        )
        del inputs["Timeout"]
        self.inputs = {name: kind.lower() for name, kind in inputs.items()}
        self.outputs = {name: kind.lower() for name, kind in outputs.items()}
        self.arrays = {}
        for name, kind in arrays.items():
            low, high = re.findall(r"\d+", kind)[:2]
            self.arrays[name] = ("array", int(low), int(high), kind.split()[-1].lower())
        declared = "".join(f"{name} : {kind};\n" for name, kind in (*inputs.items(), *arrays.items()))
        arguments = ", ".join(f"{name} := {name}" for name in (*inputs, *arrays))
        program = f"PROGRAM PRG_Line\nVAR fb : {match.group(1)};\n{declared}END_VAR\nfb({arguments});\nEND_PROGRAM\n"
        encoded = (*self.inputs.items(), *self.arrays.items())
        read = (*((f"fb.{name}", kind) for name, kind in self.outputs.items()), *self.arrays.items())
        whole = named(without_comments(unpacked_text) + program) if dialect != "iec" else standard(functions, program)
        self.program = Compiled(whole, folder, Block("PRG_Line", encoded, read), unit)
        self.program.restart()
        self.now: dict[str, Any] = dict.fromkeys(self.inputs, 0)
        self.now |= {"Execute": False, "Abort": False, "Received": False, "Failed": False, "Retries": 2}
        self.now |= {"Station": STATION, "Address": ADDRESS}
        self.held = {name: [0] * (kind[2] + 1) for name, kind in self.arrays.items()}
        self.out: dict[str, Any] = dict.fromkeys(self.outputs, False)
        self.requests: list[bytes] = []
        self.answer: Callable[[bytes], bytes] = self.right

    def right(self, request: bytes) -> bytes:
        """The answer of a device that obeys."""
        values = dict(self.codec.decode(request, "request", self.message).values)
        answered: dict[str, Any] = {"station": STATION, "address": values.get("address")}
        if self.message == "read_registers":
            answered = {"station": STATION, "values": [0x1234 + at for at in range(values["word_count"])]}
        elif self.message == "write_register":
            answered["value"] = values["value"]
        else:
            answered["word_count"] = len(values["values"])
        return self.codec.encode("response", self.message, answered)

    def scan(self) -> None:
        """One scan; a request is answered in the next one."""
        before = self.out["Send"]
        values = self.program.scan(100, [*self.now.values(), *self.held.values()])
        self.out = dict(zip(self.outputs, values, strict=False))
        self.held = dict(zip(self.arrays, values[len(self.outputs) :], strict=True))
        self.now["Received"] = False
        if self.out["Send"] and not before:
            request = bytes(self.held["Frame"][: self.out["SendLength"]])
            self.requests.append(request)
            coming = self.answer(request)
            if coming:
                self.held["Frame"][: len(coming)] = coming
                self.now |= {"Received": True, "ReceivedLength": len(coming)}

    def run(self, scans: int, **inputs: Any) -> Line:
        """Sets inputs and runs some scans."""
        assert inputs.keys() <= self.inputs.keys(), inputs
        self.now |= inputs
        for _ in range(scans):
            self.scan()
        return self

    @property
    def ended(self) -> str:
        """The output that says how it has ended."""
        result = [name for name in ("Done", "CommandAborted", "Error", "Busy") if self.out[name]]
        assert len(result) <= 1, result
        return "".join(result)


def standard(functions: str, program: str) -> str:
    """A program after the functions whose types of arrays it uses by their names."""
    for name, kind in re.findall(r"\nTYPE\n    (T_\w+) : (ARRAY [^;:]+?);\nEND_TYPE", functions):
        program = program.replace(f": {kind};", f": {name};")
    return functions + program


def siemens(device: str) -> str:
    """The functions and blocks for TIA Portal, without texts of codes."""
    actual = without_comments(siemens_text(device)).replace("TON_TIME", "TON")
    return re.sub(r"^TYPE \w+CodeText :.*?^END_TYPE$", "", actual, flags=re.MULTILINE | re.DOTALL)


def asked(line: Line) -> dict[str, Any]:
    """The inputs for two words, or for the one that there is."""
    if "Values" in line.held:
        line.held["Values"][:COUNT] = [7, 8]
    counts = {name: COUNT for name in ("WordCount", "ValuesCount") if name in line.inputs}
    return counts | ({"Value": 7} if "Value" in line.inputs else {})


@pytest.fixture
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where compiled programs are kept."""
    return programs(tmp_path_factory)


@pytest.fixture
def line(folder: Path) -> Line:
    """A block that reads two registers of a TC100, ready to start."""
    line = Line("tc100", "rtu", "read_registers", folder)
    return line.run(2, **asked(line))


@pytest.mark.proof(3)
@pytest.mark.parametrize("message", ["read_registers", "write_register", "write_registers"])
@pytest.mark.parametrize(("device", "link"), DEVICES)
def test_every_block_exchanges_its_message(device: str, link: str, message: str, folder: Path) -> None:
    line = Line(device, link, message, folder)
    line.run(2, **asked(line)).run(TRY, Execute=True)
    assert (line.ended, line.out["ErrorID"], len(line.requests)) == ("Done", 0, 1)
    if message == "read_registers":
        assert line.held["Values"][:COUNT] == [0x1234, 0x1235]
    values = line.codec.decode(line.requests[0], "request", message).values
    assert values["address"] == ADDRESS
    assert line.run(1, Execute=False).ended == ""


@pytest.mark.proof(1)
@pytest.mark.parametrize("message", ["read_registers", "write_register", "write_registers"])
def test_a_block_for_tia_portal_does_the_same(message: str, folder: Path) -> None:
    line = Line("tc100", "rtu", message, folder, "scl")
    line.run(2, **asked(line)).run(TRY, Execute=True)
    assert (line.ended, len(line.requests)) == ("Done", 1)
    line.answer = lambda request: b""
    line.run(1, Execute=False).run(4 * TRY, Execute=True)
    assert (line.ended, line.out["Status"], len(line.requests)) == ("Error", 0x8600 + ERRORS["timeout"][0], 4)


def test_a_block_that_is_told_to_execute_in_its_first_scan_does_nothing(folder: Path) -> None:
    line = Line("tc100", "rtu", "read_registers", folder)
    line.run(4 * TRY, **asked(line), Execute=True)
    assert (line.ended, line.requests) == ("", [])


def exception(line: Line, request: bytes) -> bytes:
    """The answer of a TC100 that refuses, with its check."""
    body = bytes([STATION, request[1] | 0x80, 2])
    check = 0xFFFF
    for byte in body:
        check ^= byte
        for _ in range(8):
            check = check >> 1 ^ (0xA001 if check & 1 else 0)
    return body + check.to_bytes(2, "little")


def of_station(line: Line, request: bytes) -> bytes:
    """The answer of another station."""
    return line.codec.encode("response", "read_registers", {"station": STATION + 1, "values": [1, 2]})


FAULTS: dict[str, Callable[[Line, bytes], bytes]] = {
    "timeout": lambda line, request: b"",
    "damaged": lambda line, request: line.right(request)[:-1] + b"\x00",
    "station": of_station,
    "other": lambda line, request: line.codec.encode("response", "read_registers", {"station": STATION, "values": [1]}),
    "exception": exception,
}


@pytest.mark.parametrize("fault", FAULTS)
def test_each_fault_is_an_error_with_its_number_after_all_tries(line: Line, fault: str) -> None:
    line.answer = lambda request: FAULTS[fault](line, request)
    line.run(4 * TRY, Execute=True)
    tries = 1 if fault == "exception" else 3
    assert (line.ended, line.out["ErrorID"], len(line.requests)) == ("Error", ERRORS[fault][0], tries)
    line.answer = line.right
    assert line.run(4 * TRY).ended == "Error"
    assert line.run(1, Execute=False).ended == ""
    assert line.run(TRY, Execute=True).ended == "Done"


@pytest.mark.proof(6)
@pytest.mark.parametrize(
    ("message", "wrong"),
    [
        ("write_register", {"address": ADDRESS + 1}),
        ("write_register", {"value": 8}),
        ("write_registers", {"address": ADDRESS + 1}),
        ("write_registers", {"word_count": COUNT - 1}),
    ],
)
@pytest.mark.parametrize(("device", "link"), DEVICES)
def test_what_an_answer_to_a_write_repeats_wrongly_is_error_5(
    device: str, link: str, message: str, wrong: dict[str, int], folder: Path
) -> None:
    line = Line(device, link, message, folder)
    values = {"address": ADDRESS, **({"value": 7} if message == "write_register" else {"word_count": COUNT}), **wrong}
    line.answer = lambda request: line.codec.encode("response", message, {"station": STATION, **values})
    line.run(2, **asked(line)).run(4 * TRY, Execute=True)
    assert (line.ended, line.out["ErrorID"]) == ("Error", ERRORS["other"][0])


@pytest.mark.parametrize("fault", ["station", "other"])
def test_words_of_a_wrong_answer_are_not_given(line: Line, fault: str) -> None:
    line.answer = lambda request: FAULTS[fault](line, request)
    line.run(4 * TRY, Execute=True)
    assert (line.held["Values"][:COUNT], line.out["ValuesCount"]) == ([7, 8], 0)


@pytest.mark.parametrize("fault", ["timeout", "damaged", "station", "other"])
def test_a_fault_that_passes_is_repeated_and_done(line: Line, fault: str) -> None:
    answers = [lambda request: FAULTS[fault](line, request), line.right]
    line.answer = lambda request: answers.pop(0)(request)
    line.run(4 * TRY, Execute=True)
    assert (line.ended, len(line.requests)) == ("Done", 2)


def test_a_request_that_cannot_be_built_is_never_sent(line: Line) -> None:
    line.run(TRY, WordCount=61, Execute=True)
    assert (line.ended, line.out["ErrorID"], line.requests) == ("Error", ERRORS["request"][0], [])


def test_a_line_that_cannot_send_is_an_error(line: Line) -> None:
    line.answer = lambda request: b""
    line.run(TRY, Execute=True, Failed=True)
    assert (line.ended, line.out["ErrorID"]) == ("Error", ERRORS["transport"][0])


@pytest.mark.parametrize("scans", range(1, 4))
def test_an_exchange_that_is_aborted_ends_and_sends_nothing_more(line: Line, scans: int) -> None:
    line.answer = lambda request: b""
    line.run(scans, Execute=True).run(1, Abort=True)
    assert line.ended == "CommandAborted"
    sent = len(line.requests)
    line.run(4 * TRY, Abort=False)
    assert len(line.requests) == sent


def test_no_request_is_sent_without_an_edge_whatever_happens(line: Line) -> None:
    dice, allowed, before, done = random.Random(5), False, False, 0
    faults = [*FAULTS.values(), *[lambda line, request: line.right(request)] * 5]
    line.answer = lambda request: dice.choice(faults)(line, request)
    for _ in range(20_000):
        chance = dice.random()
        if chance < 0.1:
            line.now["Execute"] = not line.now["Execute"]
        line.now["Abort"], line.now["Failed"] = chance > 0.995, 0.99 < chance < 0.992
        if 0.985 < chance < 0.9852:
            line.program.restart()
            line.out["Send"], allowed, before = False, False, True
        allowed = allowed or (line.now["Execute"] and not before)
        before, sent = line.now["Execute"], len(line.requests)
        line.scan()
        if not allowed:
            assert len(line.requests) == sent
        if line.ended in ("Done", "Error", "CommandAborted"):
            allowed, done = False, done + (line.ended == "Done")
    assert done > 100
