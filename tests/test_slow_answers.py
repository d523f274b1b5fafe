"""Clients wait for the rest of an answer that comes slowly, and find an answer after garbage."""

from __future__ import annotations

import asyncio
import importlib
import sys
from collections.abc import Iterator
from time import monotonic, sleep
from typing import Any

import pytest

from bounded import HANGING
from fieldspec.codec.reference import codec
from fieldspec.targets.python.backend import PACKAGE, files, shared
from fieldspec.tools.live.client import Client, Timing
from fieldspec.tools.simulator.clock import ManualClock
from python_package import write
from streams import linker

GAP = 0.07
"""The seconds between pieces: more than the silence that ends a frame whose length nothing determines."""
ANSWERS = {
    "closed": ("zoom", {"position": [255, 2, 255, 4]}, b""),
    "digital": ("read_words", {"unit": 3, "end_code": 0, "values": [1, 2]}, b"\x00@03"),
    "lines": ("read_level", {"level": -12345}, b"\x00"),
    "little": ("poll", {"value": 7}, b"\xb5b\x01\x02"),
    "routed": ("poll", {"unit": 3, "value": 7}, b"\x03\x00\x01"),
}
"""A message of some links, the values of its response, and garbage that looks like the beginning of a frame."""


class Line:
    """A line on which pieces come after each request, `GAP` seconds apart. A piece may be read in parts."""

    datagrams = False

    def __init__(self, *pieces: bytes) -> None:
        self.pieces = pieces
        self.due: list[tuple[float, bytes]] = []

    def write(self, data: bytes) -> None:
        """Takes a request."""
        self.due = [(monotonic() + number * GAP, piece) for number, piece in enumerate(self.pieces)]

    def read(self, size: int) -> bytes:
        """The bytes that have come."""
        if not self.due or self.due[0][0] > monotonic():
            sleep(0.005)
            return b""
        at, data = self.due.pop(0)
        if len(data) > size:
            self.due.insert(0, (at, data[size:]))
        return data[:size]


class AsyncLine:
    """The same for asyncio: it reads until something comes."""

    datagrams = False

    def __init__(self, *pieces: bytes) -> None:
        self.line = Line(*pieces)

    async def write(self, data: bytes) -> None:
        """Takes a request."""
        self.line.write(data)

    async def read(self, size: int) -> bytes:
        """The bytes that have come."""
        while not (data := self.line.read(size)):
            await asyncio.sleep(0.002)
        return data


class Carrier:
    """The same for live requests, in the time of a clock that nobody waits for."""

    name = "line"
    datagrams = False
    keeps_pauses = True

    def __init__(self, clock: ManualClock, *pieces: bytes) -> None:
        self.clock, self.pieces = clock, pieces
        self.due: list[tuple[float, bytes]] = []

    def write(self, data: bytes) -> None:
        """Takes a request."""
        self.due = [(self.clock.now() + 2 * number * GAP, piece) for number, piece in enumerate(self.pieces)]

    def read(self, seconds: float) -> bytes:
        """The bytes that have come."""
        if not self.due or self.due[0][0] > self.clock.now() + seconds:
            self.clock.sleep(seconds)
            return b""
        at, data = self.due.pop(0)
        self.clock.sleep(at - self.clock.now())
        return data

    def close(self) -> None:
        """Nothing is open."""


@pytest.fixture(scope="module")
def module(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    folder = tmp_path_factory.mktemp("linker")
    outputs = shared() | files([linker()])
    write(folder, {path.replace(PACKAGE, "devices_of_linker", 1): text for path, text in outputs.items()})
    sys.path.insert(0, str(folder))
    yield importlib.import_module("devices_of_linker.linker")
    sys.path.remove(str(folder))


def client_of(module: Any, line: Any, link: str, kind: str = "Client", timeout: float = 0.5) -> Any:
    """A client that sends each request once."""
    clients = importlib.import_module(f"{module.__name__}.client")
    return getattr(clients, kind)(line, link=link, unit_address=3, retries=0, timeout=timeout)


def request_of(module: Any, link: str) -> Any:
    """The request of the message in the table."""
    requests = {
        "zoom": lambda: module.ZoomRequest([0, 0, 0, 0]),
        "read_words": lambda: module.ReadWordsRequest(1),
        "read_level": module.ReadLevelRequest,
        "poll": module.PollRequest,
    }
    return requests[ANSWERS[link][0]]()


def answer_of(link: str) -> bytes:
    """The frame of the response in the table."""
    name, values, _ = ANSWERS[link]
    return codec(linker()).links[link].encode("response", name, values)


def fields_of(message: Any) -> dict[str, Any]:
    return {name: getattr(message, name) for name in message.__match_args__}


def expected(link: str) -> dict[str, Any]:
    """The fields of the response in the table."""
    _, values, _ = ANSWERS[link]
    return {name: value for name, value in values.items() if name not in ("unit", "end_code")}


@pytest.mark.parametrize("link", ANSWERS)
def test_an_answer_in_pieces_with_silence_between_them_is_one(module: Any, link: str) -> None:
    frame = answer_of(link)
    line = Line(frame[:1], frame[1:-1], frame[-1:])
    reply = client_of(module, line, link).ask(request_of(module, link))
    assert fields_of(reply.message if hasattr(reply, "message") else reply) == expected(link)


@pytest.mark.parametrize("link", ANSWERS)
def test_an_answer_behind_garbage_is_taken(module: Any, link: str) -> None:
    line = Line(ANSWERS[link][2] + answer_of(link))
    reply = client_of(module, line, link).ask(request_of(module, link))
    assert fields_of(reply.message if hasattr(reply, "message") else reply) == expected(link)


@pytest.mark.parametrize("garbage", [False, True])
@pytest.mark.parametrize("link", ANSWERS)
def test_live_requests_have_their_answers_too(link: str, garbage: bool) -> None:
    frame, clock = answer_of(link), ManualClock()
    pieces = [ANSWERS[link][2] + frame] if garbage else [frame[:1], frame[1:-1], frame[-1:]]
    name = ANSWERS[link][0]
    client = Client(linker(), link, Carrier(clock, *pieces), 3, Timing(retries=0), clock)
    sent = {"zoom": {"position": [0, 0, 0, 0]}, "read_words": {"address": 1}}.get(name, {})
    assert client.ask(name, sent).values.items() >= expected(link).items()


def test_silence_ends_a_frame_whose_length_nothing_determines_for_asyncio_too(module: Any) -> None:
    frame = codec(linker()).links["summed"].encode("response", "near", {"mode": 5})

    async def ask() -> Any:
        client = client_of(module, AsyncLine(frame), "summed", "AsyncClient", timeout=2 * HANGING)
        return await asyncio.wait_for(client.ask(module.NearRequest(1)), HANGING)

    reply = asyncio.run(ask())
    assert (reply.message if hasattr(reply, "message") else reply).mode == 5
