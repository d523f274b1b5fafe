"""A message whose answer repeats values of every kind, and has names that its block has too."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any, ClassVar

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from benches import Bench
from devices import Transport
from loaded import programs
from rigs import NUMBER, Rig

from fieldspec.codec.reference import codec
from fieldspec.targets import OUTPUTS
from fieldspec.targets.controllers.routines.blocks.ports import FRAMES
from fieldspec.targets.controllers.statements.expressions import INT, Variable
from layouts import SPECS, TEST_SPECS, layouts, newest

SPEC = """
device:
  id: repeater
  name: Repeater
  vendor: Nobody
  title: A made-up device whose answers repeat almost everything
  manual: {title: No manual, file: no.txt, sha256: "%s", lines: 9}
links:
  - name: line
    source: 1 L1
    byte_order: big
    request:
      - {name: receiver, role: unit_address, type: u8}
      - {name: ticket, type: u16}
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
    response:
      - {name: sender, role: unit_address, type: u8}
      - {name: stub, type: u32, same_as: ticket}
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
    exception_response: {code: 0xFF, record: refusal}
enums:
  - name: mode
    source: 1 L2
    members: [{value: 1, name: slow}, {value: 2, name: fast}, {value: 3, name: wild}]
records:
  - {name: point, source: 1 L3, fields: [{name: left, type: i16}, {name: marks, type: u8, count: 3}]}
  - {name: refusal, source: 1 L4, fields: [{name: refused, type: u8, same_as: command}, {name: cause, type: u8}]}
messages:
  - name: copy
    code: 0x21
    source: 1 L5
    request:
      - {name: mode, type: u8, enum: mode}
      - {name: number, type: u8}
      - {name: label, type: text, length: 4}
      - {name: point, record: point}
      - {name: value, type: u16}
      - {name: reason, type: u16}
      - {name: numbers, type: u16, repeat: 1..4}
    response:
      - {name: same_mode, type: u8, enum: mode, same_as: mode}
      - {name: number_again, type: u16, same_as: number}
      - {name: label, type: text, length: 4, same_as: label}
      - {name: place, record: point, same_as: point}
      - {name: value, type: u16}
      - {name: reason, type: u16}
      - {name: step, type: i16}
      - {name: asked, type: bool8}
      - {name: owner, type: u32}
      - {name: numbers, type: u16, repeat: 1..4, same_as: numbers}
""" % ("1" * 64)
ASKED: dict[str, Any] = {
    "receiver": 3,
    "ticket": 700,
    "mode": 2,
    "number": 9,
    "label": "ABCD",
    "point": {"left": -5, "marks": [1, 2, 3]},
}
ASKED |= {"value": 40, "reason": 50, "numbers": [1, 2, 3]}
RIGHT: dict[str, Any] = {
    "sender": 3,
    "stub": 700,
    "same_mode": 2,
    "number_again": 9,
    "label": "ABCD",
    "place": ASKED["point"],
}
RIGHT |= {"value": 41, "reason": 51, "step": -52, "asked": True, "owner": 53, "numbers": [1, 2, 3]}
WRONG: dict[str, list[Any]] = {
    "stub": [1, 700 + (1 << 16)],
    "same_mode": [1, 3],
    "number_again": [8, 9 + 256],
    "label": ["ABCE", "ABC", "XBCD"],
    "place": [{"left": 5, "marks": [1, 2, 3]}, {"left": -5, "marks": [1, 2, 4]}],
    "numbers": [[1, 2, 4], [1, 2], [1, 2, 3, 4], [0, 2, 3]],
}
"""What is repeated wrongly, by the names of parts and fields."""
BLOCK = "SendCopy"
NEW = {"ValueAnswered": 41, "ReasonAnswered": 51, "StepValue": -52, "Asked": True, "Owner": 53}
"""The outputs with what the answer does not repeat: none is a variable of the block itself."""


class Copies(Rig):
    """The block of the message, and a device that answers with some values."""

    starting: ClassVar[dict[str, Any]] = {}

    def __init__(self, root: Path, folder: Path) -> None:
        super().__init__(Bench(root, "repeater", [BLOCK], folder))
        self.codec = codec(newest(root, "repeater")).links["line"]
        self.transport = Transport(self.bench, FRAMES, self.bench.lent[BLOCK, "Frames"], delay=1)
        self.device = self
        self.answer = b""
        self.requests: list[bytes] = []
        self.motion = type("Still", (), {"starts": []})
        point = self.bench.ports[self.bench.lent[BLOCK, "Point"]]
        for name in point:
            point[name] = [1, 2, 3] if "marks" in name else -5
        self.bench.ports[self.bench.lent[BLOCK, "Label"]] = list(b"ABCD")
        self.bench.ports[self.bench.lent[BLOCK, "Numbers"]] = [1, 2, 3, 0]
        self.bench.set(BLOCK, Receiver=3, Ticket=700, Mode=2, Number=9, Value=40, Reason=50)
        self.bench.set(BLOCK, NumbersCount=3)

    def pass_scan(self) -> None:
        """Nothing moves."""

    def exchanged(self, transport: Transport) -> int:
        """Takes the request and gives the answer."""
        self.requests.append(bytes(transport.of("frame")[: transport.of("send")]))
        array = list(transport.of("frame"))
        array[: len(self.answer)] = self.answer
        transport.put("frame", array)
        transport.put("received", len(self.answer))
        return 0

    def outcome(self, **wrong: Any) -> str:
        """How the block ends where an answer is right but for some values."""
        self.answer = self.codec.encode("response", "copy", {**RIGHT, **wrong})
        self.run(2)
        return self.done(BLOCK)

    def outputs(self) -> dict[str, Any]:
        """The outputs of the block with values of the answer."""
        own = ("Done", "Busy", "CommandAborted", "Error", "ErrorID", "Diagnostics")
        return {name: value for (_, name), value in self.bench.out.items() if name not in own}


@pytest.fixture(scope="module")
def root(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the spec."""
    folder = tmp_path_factory.mktemp("specs")
    (folder / "repeater").mkdir()
    (folder / "repeater/device.yaml").write_text(SPEC, "utf-8")
    return folder


@pytest.fixture
def copies(root: Path, tmp_path_factory: pytest.TempPathFactory) -> Copies:
    """A block that asks, and whoever answers."""
    return Copies(root, programs(tmp_path_factory))


def test_the_right_answer_is_done_and_gives_what_is_new_in_it(copies: Copies) -> None:
    assert copies.outcome() == "Done"
    assert copies.requests == [copies.codec.encode("request", "copy", ASKED)]
    assert copies.outputs() == {**NEW, "Refused": 0, "Cause": 0}


def test_an_answer_leaves_what_was_asked_as_it_is(copies: Copies) -> None:
    before = {name: value for name, value in copies.bench.ports.items() if not name.endswith("Frames")}
    for wrong in ({}, {"label": "XXXX"}, {"numbers": [9, 9, 9, 9]}, {"place": {"left": 7, "marks": [7, 7, 7]}}):
        copies.outcome(**wrong)
        assert {name: copies.bench.ports[name] for name in before} == before


@pytest.mark.parametrize("name", WRONG)
def test_what_is_repeated_wrongly_is_error_5_and_gives_nothing(copies: Copies, name: str) -> None:
    for value in WRONG[name]:
        assert copies.outcome(**{name: value}) == f"Error {NUMBER['other']}", value
        assert not any(copies.outputs().values())
    assert copies.outcome() == "Done"


def test_the_answer_of_another_station_is_error_4_and_gives_nothing(copies: Copies) -> None:
    assert copies.outcome(sender=4) == f"Error {NUMBER['station']}"
    assert not any(copies.outputs().values())


REFUSALS: dict[str, tuple[dict[str, int], str, int]] = {
    "refused": ({}, f"Error {NUMBER['exception']}", 77),
    "another message": ({"refused": 0x22}, f"Error {NUMBER['other']}", 0),
    "another request": ({"stub": 1}, f"Error {NUMBER['other']}", 0),
    "another station": ({"sender": 4}, f"Error {NUMBER['station']}", 0),
}


@pytest.mark.parametrize("refusal", REFUSALS)
def test_a_refusal_counts_where_it_is_that_of_the_request(copies: Copies, refusal: str) -> None:
    wrong, ended, cause = REFUSALS[refusal]
    values = {"sender": 3, "stub": 700, "refused": 0x21, "cause": 77, **wrong}
    head = values["sender"].to_bytes(1, "big") + values["stub"].to_bytes(4, "big")
    copies.answer = head + bytes([0xFF, values["refused"], values["cause"]])
    copies.run(2)
    assert copies.done(BLOCK) == ended
    assert copies.outputs()["Cause"] == cause


def test_a_comparison_of_a_thing_with_itself_is_refused() -> None:
    with pytest.raises(ValueError, match="is compared with itself"):
        Variable("iAt", INT).compared("<>", Variable("iAt", INT))


@pytest.mark.proof(1)
@pytest.mark.parametrize("dialect", ["iec", "st", "twincat", "scl", "plcopen"])
def test_no_output_compares_a_thing_with_itself(dialect: str) -> None:
    operand = r'(?<![\w.\]#"])([\w.#"]+(?:\[[^\]]*\])?(?:\.\w+)*)'
    itself = re.compile(operand + r"\s*(?:=|<>|&lt;&gt;|<=|>=|<|>)\s*\1(?![\w.\[(])")
    comparisons, seen = [], 0
    for root in (SPECS, TEST_SPECS):
        for versions in layouts(root).values():
            output = OUTPUTS[dialect]
            if output.refusals(versions):
                continue
            for path, content in output.files(versions).items():
                if isinstance(content, str):
                    seen += content.count("<>") + content.count("&lt;&gt;")
                    comparisons += [f"{path}: {match.group(0)}" for match in itself.finditer(content)]
    assert comparisons == []
    assert seen > 1000
