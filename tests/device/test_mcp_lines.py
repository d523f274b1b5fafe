"""Each line that a client of `fieldspec mcp` sends has one answer, by JSON-RPC 2.0, and none ends in a traceback."""

from __future__ import annotations

import itertools
import json
import subprocess
import sys
import threading
from collections.abc import Iterator
from typing import Any

import pytest

from bounded import HANGING
from fieldspec.testing import SimulatedDevice, simulation
from simulators import SPECS

INITIALIZE = {
    "jsonrpc": "2.0",
    "id": "first",
    "method": "initialize",
    "params": {
        "protocolVersion": "2025-06-18",
        "capabilities": {},
        "clientInfo": {"name": "test", "version": "1"},
    },
}


class Client:
    """A client that sends lines, whatever they are."""

    def __init__(self, *options: str) -> None:
        command = [sys.executable, "-m", "fieldspec", "mcp", "--specs", SPECS, *options]
        pipe = subprocess.PIPE
        self.process = subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=pipe)
        self.deadline = threading.Timer(300, self.process.kill)
        self.deadline.start()
        assert self.answer(json.dumps(INITIALIZE).encode())["id"] == "first"
        self.send(b'{"jsonrpc":"2.0","method":"notifications/initialized"}')

    def send(self, line: bytes) -> None:
        """Sends a line."""
        assert self.process.stdin is not None
        self.process.stdin.write(line + b"\n")
        self.process.stdin.flush()

    def answer(self, line: bytes) -> dict[str, Any]:
        """The answer to a line."""
        self.send(line)
        assert self.process.stdout is not None
        answer: dict[str, Any] = json.loads(self.process.stdout.readline())
        return answer

    def call(self, tool: str, arguments: dict[str, Any]) -> tuple[bool, str]:
        """Whether the call of a tool is an error, and what it says."""
        call = {"jsonrpc": "2.0", "id": 7, "method": "tools/call", "params": {"name": tool, "arguments": arguments}}
        result = self.answer(json.dumps(call).encode())["result"]
        return bool(result.get("isError")), result["content"][0]["text"]

    def end(self) -> str:
        """Ends the server, and returns what it has printed beside answers."""
        _, errors = self.process.communicate(timeout=HANGING)
        self.deadline.cancel()
        return errors.decode()


@pytest.fixture(scope="module")
def device() -> Iterator[SimulatedDevice]:
    with simulation("tc100", ports={"ascii": "tcp://127.0.0.1:0"}, folder=SPECS) as running:
        yield running


@pytest.fixture(scope="module")
def client(device: SimulatedDevice) -> Iterator[Client]:
    """A client that may read and write a device, and a server that says nothing of what it is sent."""
    client = Client("--port", f"tc100={device.place.replace('tcp://', 'socket://')}", "--allow-writes")
    yield client
    assert client.end() == ""


CALL = '{"jsonrpc":"2.0","id":%s,"method":"tools/call","params":{"name":"show","arguments":{"device":"%s"}}}'


def test_a_line_that_is_no_message_is_answered_with_its_error(client: Client) -> None:
    # JSON-RPC 2.0, 5 and 5.1: the id is null where it cannot be known.
    lines = [
        ((CALL % (5, r"\ud800")).encode(), (5, -32700)),
        ((CALL % ('"a"', r"\udc80")).encode(), ("a", -32700)),
        ((CALL % (6, r"\ud800\ud83d\ude00")).encode(), (6, -32700)),
        ((CALL % (r'"\ud800"', "tc100")).encode(), (None, -32700)),
        (b'{"jsonrpc":"2.0","id":7,"method":"\\ud800"}', (7, -32700)),
        (b"nonsense", (None, -32700)),
        (b"\xff\xfe", (None, -32700)),
        (b'{"jsonrpc":"2.0","id":8', (None, -32700)),
        (b"[" * 100_000, (None, -32700)),
        (b"[1]", (None, -32600)),
        (b"1", (None, -32600)),
        (b'{"jsonrpc":"1.0","id":9,"method":"tools/list"}', (None, -32600)),
    ]
    answers = [client.answer(line) for line, _ in lines]
    assert [(answer["id"], answer["error"]["code"]) for answer in answers] == [expected for _, expected in lines]
    assert client.call("show", {"device": "tc100", "item": "\U0001f600"})[0]


@pytest.mark.parametrize(
    ("tool", "arguments", "expected"),
    [
        ("decode", {"device": "tc100", "frame": "01 " * 70_000}, "send 30000 at most"),
        ("show", {"device": "x" * 200_000}, "send 30000 at most"),
        ("read", {"device": "tc100", "names": ["x"] * 100_000}, "send 30000 at most"),
        ("show", {"device": "tc100", "itme": "motion_command"}, "show has no argument `itme`"),
        ("devices", {"device": "tc100"}, "its arguments are: none"),
        ("decode", {"device": "tc100", "frame": "01", "link": "\0"}, "zero byte"),
        ("read", {"device": "tc100", "names": ["\0"]}, "zero byte"),
        ("nothing", {}, "Unknown tool"),
    ],
)
def test_arguments_that_a_tool_does_not_take_are_refused(
    client: Client, tool: str, arguments: dict[str, Any], expected: str
) -> None:
    error, text = client.call(tool, arguments)
    assert error
    assert expected in text


def test_odd_texts_are_answered(client: Client) -> None:
    texts = ["", " ", "-1", "--help", "a/b", "../x", "0x", "9" * 400, "\x1b[31m", "\u202e", "'", "*", "x=y=z", "\n"]
    calls = (
        lambda text: ("show", {"device": text}),
        lambda text: ("read", {"device": "tc100", "names": [text]}),
        lambda text: ("decode", {"device": "tc100", "frame": "01", "direction": text, "link": text, "message": text}),
    )
    assert all(client.call(*call(text))[1] for text, call in zip(texts, itertools.cycle(calls), strict=False))


@pytest.mark.parametrize("confirmed", ["yes", "true", "on", "1", 1, 1.0, "false", 0, None, [True], {}])
def test_only_true_confirms(client: Client, device: SimulatedDevice, confirmed: Any) -> None:
    homing = {"device": "tc100", "assignments": ["command=homing"], "confirmed": confirmed}
    error, text = client.call("write", homing)
    assert error
    assert "`confirmed` of write is true or false" in text
    assert device.value("axis/moving") is False
