"""Answers that belong to something else: every block that asks is compiled and answered by another, late or wrongly."""

from __future__ import annotations

import random
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from benches import Bench, block_names
from loaded import programs
from rigs import NUMBER
from test_every_block import drawn_frame

from fieldspec.codec.reference import codec
from fieldspec.targets.controllers.routines.blocks.ports import ABANDONED, ANSWERED, ASKED, AXIS, FRAMES, FREE
from layouts import SPECS, TEST_SPECS, layouts, newest

CLIENTS = {
    "ck10": ["rtu", "ascii"],
    "tc100": ["rtu", "ascii"],
    "caller": ["bus"],
    "ladder": ["bus"],
    "inverter": ["rtu", "tcp"],
    "meter": ["rtu"],
    "station": ["rtu", "ascii", "tcp"],
    "totalizer": ["line"],
    "warmer": ["rtu", "tcp"],
    "wattmeter": ["rtu", "tcp"],
    "widget": ["rtu", "ascii", "packet"],
}
"""The links of every device by which a client carries accesses to registers."""
CASES = [(device, link) for device, links in CLIENTS.items() for link in links]
STATION, OTHER_STATION, ADDRESS = 3, 2, 1
WORDS, ANSWER = [0x5555, 0x5556], [0x1234, 0x1235]


def root_of(device: str) -> Path:
    """The folder with the spec of a device."""
    return SPECS if device in layouts(SPECS) else TEST_SPECS


@pytest.fixture
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where compiled programs are kept."""
    return programs(tmp_path_factory)


class Client:
    """A client between the port of an axis, in which a test asks, and the frames, which the test answers."""

    def __init__(self, device: str, link: str, folder: Path) -> None:
        root = root_of(device)
        self.layout = newest(root, device)
        self.link = self.layout.links[link]
        self.codec = codec(self.layout).links[link]
        clients = [name for name in block_names(root, device) if name.endswith("Client")]
        self.name = next(name for name in clients if name.lower() == f"{link}client" or len(clients) == 1)
        self.bench = Bench(root, device, [self.name], folder, program=clients)
        self.bench.set(self.name, Retries=0)
        for block, name in self.bench.inputs:
            if block == self.name and name != "Retries":
                self.bench.set(block, **{name: STATION})

    def of(self, port: str, name: str) -> Any:
        """A member of a port."""
        return self._port(port)[self.bench.port(port, name)]

    def put(self, port: str, **members: Any) -> None:
        """Changes members of a port."""
        for name, value in members.items():
            self._port(port)[self.bench.port(port, name)] = value

    def _port(self, port: str) -> Any:
        return self.bench.ports[self.bench.lent[self.name, "Axis" if port == AXIS else "Frames"]]

    def ask(self, write: bool, words: list[int]) -> bytes:
        """Asks through the port of the axis; the request that the client sends."""
        array = [*words, *self.of(AXIS, "words")[len(words) :]]
        self.put(AXIS, write=write, address=ADDRESS, count=len(words), words=array)
        self.put(AXIS, state=ASKED, request=self.of(AXIS, "request") + 1, error=0)
        for _ in range(3):
            if self.of(FRAMES, "state") == FREE:
                self.bench.scan()
        assert self.of(FRAMES, "state") == ASKED, self.of(AXIS, "error")
        return bytes(self.of(FRAMES, "frame")[: self.of(FRAMES, "send")])

    def answer(self, frame: bytes, late: int = 0) -> None:
        """Answers the request of the frames, or one that was `late` requests before it."""
        array = self.of(FRAMES, "frame")
        array[: len(frame)] = frame
        number = self.of(FRAMES, "request") - late
        self.put(FRAMES, frame=array, received=len(frame), error=0, state=ANSWERED, answered=number)
        self.bench.scan()
        self.bench.scan()

    def asked(self, request: bytes) -> tuple[Any, dict[str, Any]]:
        """The message of a request, and all that an answer to it may repeat."""
        sent = self.codec.decode(request, "request")
        assert sent.message is not None
        access = sent.message.message.single_access
        assert access is not None
        known = {**sent.head, **sent.values}
        if access.operation == "read":
            known[access.values] = ANSWER[: known[access.count]]
        elif access.count:
            known[access.count] = len(known[access.values])
        return sent.message, known

    def answered(self, request: bytes, **wrong: Any) -> bytes:
        """The answer of a device that obeys, but for some parts and fields; `station` is that which answers."""
        message, known = self.asked(request)
        return repeated_frame(self.layout, self.link, message, known, {"station": STATION, **wrong})

    def restart(self) -> None:
        """Switches the controller off and on."""
        self.bench.restart()

    @property
    def outcome(self) -> tuple[int, int, list[int]]:
        """The state and the error of the axis, and its first words."""
        return self.of(AXIS, "state"), self.of(AXIS, "error"), list(self.of(AXIS, "words")[:2])


def repeated_frame(layout: Any, link: Any, message: Any, known: Mapping[str, Any], wrong: Mapping[str, Any]) -> bytes:
    """A response with what its request has, but for what is wrong."""
    addressed = link.response.role("unit_address")
    names = [(part.name, part.part.same_as) for part in link.response.header]
    names += [(field.name, field.field.same_as) for field in message.response.fields]
    values = {name: known[same or name] for name, same in names if (same or name) in known}
    values |= {
        addressed.name if name == "station" and addressed is not None else name: of for name, of in wrong.items()
    }
    reference = codec(layout).links[link.name]
    return drawn_frame(layout, reference, link, message, "response", values, random.Random(7))[1]


def test_every_client_of_every_device_is_asked_here() -> None:
    names = {device: block_names(root, device) for root in (SPECS, TEST_SPECS) for device in layouts(root)}
    counts = {device: sum(name.endswith("Client") for name in blocks) for device, blocks in names.items()}
    assert {device: count for device, count in counts.items() if count} == {
        device: len(links) for device, links in CLIENTS.items()
    }


def requests(client: Client) -> dict[str, tuple[bool, list[int]]]:
    """What a client can be asked for."""
    accesses = [message.message.single_access for message in client.link.exchanged.values()]
    counts = [access.count for access in accesses if access is not None and access.operation == "write"]
    return {
        "read": (False, WORDS),
        **({"write one": (True, WORDS[:1])} if "" in counts else {}),
        **({"write two": (True, WORDS)} if any(counts) else {}),
    }


@pytest.fixture(params=CASES, ids=["-".join(case) for case in CASES])
def client(request: pytest.FixtureRequest, folder: Path) -> Client:
    """Each client of each device."""
    return Client(*request.param, folder)


@pytest.mark.proof(3)
def test_a_client_gives_the_answer_of_its_device(client: Client) -> None:
    for write, words in requests(client).values():
        client.answer(client.answered(client.ask(write, words)))
        assert client.outcome == (ANSWERED, 0, [*words, 0][:2] if write else ANSWER)
        client.restart()


@pytest.mark.proof(7)
def test_an_answer_of_another_station_is_error_4_and_no_data(client: Client) -> None:
    for write, words in requests(client).values():
        client.answer(client.answered(client.ask(write, words), station=OTHER_STATION))
        assert client.outcome[:2] == (ANSWERED, NUMBER["station"])
        assert client.outcome[2][: len(words)] == words
        client.put(AXIS, state=FREE)


def test_what_an_answer_repeats_wrongly_is_error_5_and_no_data(client: Client) -> None:
    for write, words in requests(client).values():
        message, known = client.asked(client.ask(write, words))
        parts = [part for part in client.link.response.header if part.role == "plain" and part.is_argument]
        names = [part.name for part in parts if part.name in known]
        names += [field.name for field in message.response.fields if write and field.name in known]
        if write:
            assert names
        for name in names:
            client.restart()
            request = client.ask(write, words)
            number = client.asked(request)[1][name]
            client.answer(client.answered(request, **{name: number - 1 if number else 1}))
            assert client.outcome == (ANSWERED, NUMBER["other"], [*words, 0][:2]), name
        client.restart()


@pytest.mark.parametrize("count", [1, 3])
def test_an_answer_of_another_number_of_words_is_error_5_and_no_data(client: Client, count: int) -> None:
    values = client.asked(client.ask(False, WORDS))[0].message.single_access.values
    request = bytes(client.of(FRAMES, "frame")[: client.of(FRAMES, "send")])
    client.answer(client.answered(request, **{values: [9] * count}))
    assert client.outcome == (ANSWERED, NUMBER["other"], WORDS)


def test_an_answer_to_an_earlier_request_of_the_line_is_error_5_and_no_data(client: Client) -> None:
    client.answer(client.answered(client.ask(False, WORDS)), late=1)
    assert client.outcome == (ANSWERED, NUMBER["other"], WORDS)


def test_the_answer_to_a_request_that_was_given_up_is_nobodys(client: Client) -> None:
    request = client.ask(False, WORDS)
    client.put(AXIS, state=ABANDONED)
    client.answer(client.answered(request))
    assert client.outcome == (FREE, 0, WORDS)
    client.answer(client.answered(client.ask(False, WORDS)))
    assert client.outcome == (ANSWERED, 0, ANSWER)


def test_the_answer_to_a_request_that_was_given_up_is_not_that_of_the_next_one(client: Client) -> None:
    request = client.ask(False, WORDS)
    client.put(AXIS, request=client.of(AXIS, "request") + 1)
    client.answer(client.answered(request))
    assert client.outcome == (ASKED, 0, WORDS)
    client.bench.scan()
    client.answer(client.answered(request))
    assert client.outcome == (ANSWERED, 0, ANSWER)
    assert client.of(AXIS, "answered") == client.of(AXIS, "request")


@pytest.mark.parametrize("count", [-1, 0, 30000])
def test_a_number_of_words_that_no_port_holds_is_error_1_and_nothing_is_sent(client: Client, count: int) -> None:
    client.put(AXIS, state=ASKED, write=False, address=ADDRESS, count=count)
    for _ in range(3):
        client.bench.scan()
    assert client.outcome[:2] == (ANSWERED, NUMBER["request"])
    assert client.of(FRAMES, "state") == FREE
