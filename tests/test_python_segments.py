"""Values in pieces, as generated clients read and write them: with canopen, and with devices that err."""

from __future__ import annotations

import asyncio
import importlib
from collections.abc import Iterator
from typing import Any

import can
import canopen
import pytest
from canopen import objectdictionary as dictionary

from fieldspec.tools.live.client import Client, Timing
from fieldspec.tools.live.messages import named_signals, read_signals, signals
from layouts import TEST_SPECS, newest
from python_package import module_of, package, runtime

AXIS = newest(TEST_SPECS, "axis")
MODULE = module_of(AXIS)
OBJECTS = MODULE.objects
NODE = 5
KINDS = {
    0x1008: dictionary.VISIBLE_STRING,
    0x2000: dictionary.VISIBLE_STRING,
    0x2001: dictionary.UNSIGNED64,
}


def client_module() -> Any:
    """The module with the clients of the drive."""
    return importlib.import_module(f"{package().__name__}.axis.client")


def objects() -> dictionary.ObjectDictionary:
    """The long objects of the drive."""
    result = dictionary.ObjectDictionary()
    for number, kind in KINDS.items():
        variable = dictionary.ODVariable(f"object_{number:x}", number, 0)
        variable.data_type, variable.access_type = kind, "rw"
        result.add_object(variable)
    return result


@pytest.fixture(scope="module")
def node() -> Iterator[canopen.LocalNode]:
    network = canopen.Network()
    network.connect(interface="virtual", channel="client_segments")
    yield network.create_node(NODE, objects())
    network.disconnect()


@pytest.fixture(scope="module")
def transport() -> Iterator[Any]:
    with can.Bus(interface="virtual", channel="client_segments") as bus:
        yield runtime("transports").CanTransport(bus, can.Message)


@pytest.mark.parametrize("name", ["Node", "Node of nobody", "The 32 characters that there are"])
def test_a_client_reads_a_text_of_a_node_of_canopen(node: canopen.LocalNode, transport: Any, name: str) -> None:
    node.sdo[0x1008].raw = name
    assert client_module().Client(transport, unit_address=NODE).read_parameter(OBJECTS.DEVICE_NAME) == name


@pytest.mark.parametrize("label", ["", "L", "Label 7", "exactly twenty chars"])
def test_a_client_writes_a_text_to_a_node_of_canopen(node: canopen.LocalNode, transport: Any, label: str) -> None:
    drive = client_module().Client(transport, unit_address=NODE)
    drive.write_parameter(OBJECTS.LABEL, label)
    assert (node.sdo[0x2000].raw, drive.read_parameter(OBJECTS.LABEL)) == (label, label)


class Asynchronous:
    """A transport for asyncio that waits in the same way."""

    datagrams = True

    def __init__(self, transport: Any) -> None:
        self.transport = transport

    async def read(self, size: int) -> bytes:
        data: bytes = self.transport.read(size)
        return data

    async def write(self, data: bytes) -> None:
        self.transport.write(data)


def test_a_client_for_asyncio_writes_and_reads_a_number_of_eight_bytes(node: canopen.LocalNode, transport: Any) -> None:
    async def talk() -> int:
        drive = client_module().AsyncClient(Asynchronous(transport), unit_address=NODE)
        await drive.write_parameter(OBJECTS.TRAVEL, 9_876_543_210)
        number: int = await drive.read_parameter(OBJECTS.TRAVEL)
        return number

    assert asyncio.run(talk()) == 9_876_543_210
    assert node.sdo[0x2001].raw == 9_876_543_210


class Device:
    """A transport whose device answers with frames that a test states, in order."""

    datagrams = True

    def __init__(self, *answers: str) -> None:
        self.answers = [MODULE.sdo.frame_of(0x580 + NODE, bytes.fromhex(data)) if data else b"" for data in answers]
        self.requests: list[str] = []
        self.due: list[bytes] = []

    def close(self) -> None:
        """Nothing is open."""

    def write(self, frame: bytes) -> None:
        """Takes a request."""
        self.requests.append(MODULE.sdo.can_frame(frame).data.hex(" ").upper())
        self.due = [self.answers.pop(0)] if self.answers else []

    def read(self, size: int) -> bytes:
        """The answer that is due."""
        return self.due.pop() if self.due else b""


SIZED = "41 08 10 00 09 00 00 00"
UNSIZED = "40 08 10 00 00 00 00 00"
SEVEN = "00 41 42 43 44 45 46 47"
ODD = "10 41 42 43 44 45 46 47"
BEGUN = "60 01 20 00 00 00 00 00"
TWO = "1B 48 49 00 00 00 00 00"


@pytest.mark.parametrize("begin", [SIZED, UNSIZED])
def test_pieces_are_asked_for_with_a_toggle_bit(begin: str) -> None:
    device = Device(begin, SEVEN, TWO)
    assert client_module().Client(device, unit_address=NODE).read_parameter(OBJECTS.DEVICE_NAME) == "ABCDEFGHI"
    assert device.requests == ["40 08 10 00 00 00 00 00", "60 00 00 00 00 00 00 00", "70 00 00 00 00 00 00 00"]


def test_pieces_are_sent_with_a_toggle_bit_and_the_unused_bytes() -> None:
    device = Device(BEGUN, "20 00 00 00 00 00 00 00", "30 00 00 00 00 00 00 00")
    client_module().Client(device, unit_address=NODE).write_parameter(OBJECTS.TRAVEL, 9_876_543_210)
    assert device.requests == ["21 01 20 00 08 00 00 00", "00 EA 16 B0 4C 02 00 00", "1D 00 00 00 00 00 00 00"]


@pytest.mark.parametrize(
    ("answers", "error", "text"),
    [
        ((SIZED, ODD), "InvalidAnswerError", "counts the piece as 1, not as 0"),
        ((SIZED, SEVEN, "0B 48 49 00 00 00 00 00"), "InvalidAnswerError", "counts the piece as 0, not as 1"),
        ((SIZED, SEVEN, "1D 48 00 00 00 00 00 00"), "InvalidAnswerError", "9 bytes, and 8 came"),
        ((SIZED, SEVEN, "17 48 49 4A 4B 00 00 00"), "InvalidAnswerError", "more than 9 bytes came"),
        (("41 08 10 00 21 00 00 00",), "InvalidAnswerError", "33 bytes, more than 32"),
        ((UNSIZED, SEVEN, ODD, SEVEN, ODD, SEVEN), "InvalidAnswerError", "more than 32"),
        ((UNSIZED, "0E 00 00 00 00 00 00 00"), "InvalidAnswerError", "a piece is empty"),
        ((SIZED, "60 08 10 00 00 00 00 00"), "InvalidAnswerError", "command is 96"),
        ((SIZED, SEVEN, "80 08 10 00 00 00 03 05"), "RefusedError", "toggle_bit_unchanged"),
        ((SIZED, SEVEN, ""), "NoAnswerError", "no answer"),
    ],
)  # fmt: skip
def test_pieces_that_do_not_follow_are_no_value(answers: tuple[str, ...], error: str, text: str) -> None:
    device = Device(*answers)
    drive = client_module().Client(device, unit_address=NODE, timeout=0.05, retries=0)
    with pytest.raises(getattr(runtime("errors"), error), match=text):
        drive.read_parameter(OBJECTS.DEVICE_NAME)
    reason = "00 00 03 05" if text.startswith(("command", "counts")) else "10 00 07 06"
    assert (device.requests[-1] == f"80 08 10 00 {reason}") is (error == "InvalidAnswerError")


@pytest.mark.parametrize(
    ("answers", "error", "text"),
    [
        ((BEGUN, "30 00 00 00 00 00 00 00"), "InvalidAnswerError", "counts the piece as 1, not as 0"),
        ((BEGUN, "80 01 20 00 10 00 07 06"), "RefusedError", "wrong_length"),
        (("80 01 20 00 22 00 00 08",), "RefusedError", "device_state"),
        ((BEGUN, "20 00 00 00 00 00 00 00", ""), "NoAnswerError", "no answer"),
    ],
)  # fmt: skip
def test_a_value_whose_pieces_are_not_taken_is_not_written(answers: tuple[str, ...], error: str, text: str) -> None:
    device = Device(*answers)
    drive = client_module().Client(device, unit_address=NODE, timeout=0.05)
    with pytest.raises(getattr(runtime("errors"), error), match=text):
        drive.write_parameter(OBJECTS.TRAVEL, 1)
    assert (device.requests[-1] == "80 01 20 00 00 00 03 05") is (error == "InvalidAnswerError")


def test_a_value_out_of_range_begins_nothing() -> None:
    device = Device()
    drive = client_module().Client(device, unit_address=NODE)
    for parameter, value in (
        (OBJECTS.TRAVEL, 10**14),
        (OBJECTS.LABEL, "more than twenty characters"),
        (OBJECTS.DEVICE_NAME, "x"),
    ):
        with pytest.raises(runtime("errors").InvalidValueError):
            drive.write_parameter(parameter, value)
    assert device.requests == []


def test_live_ends_what_does_not_follow() -> None:
    device = Device(SIZED, SEVEN, SEVEN)
    client = Client(AXIS, "sdo", device, NODE, Timing(timeout=0.05, retries=0))
    (signal,) = named_signals(AXIS, list(signals(AXIS, AXIS.links["sdo"])), "device_name")
    (reading,) = read_signals(client, [signal])
    assert reading.refusal == "the device counts the pieces in another way: one is missing, or came twice"
    assert device.requests[-1] == "80 08 10 00 00 00 03 05"
