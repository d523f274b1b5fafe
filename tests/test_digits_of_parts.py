"""Unit addresses, codes, lengths and other parts of frames that are sent as digits."""

from __future__ import annotations

import importlib
import random
from functools import reduce
from operator import xor
from typing import Any

import pytest
import pyvisa

from fieldspec.cli import main
from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.reference import CodecError, codec
from fieldspec.testing import simulation
from layouts import TEST_SPECS, newest
from python_package import codec_error, link_of, module_of, runtime
from serial_lines import SECONDS

LAYOUT = newest(TEST_SPECS, "ladder")
LADDER = module_of(LAYOUT)
LOOP = link_of(LADDER, "loop")
RING = link_of(LADDER, "ring")
REFERENCE = codec(LAYOUT).links["loop"]


def sealed(text: bytes) -> bytes:
    """The characters between the delimiters as a frame with the right sum."""
    return b"%" + text + b"%03d\r" % (sum(text) & 0xFF)


def checked(text: str) -> str:
    """The characters of a frame of the host link with their exclusive or."""
    return f"{text}{reduce(xor, text.encode()):02X}*"


FRAMES = {
    "as it is sent": (b"0F0410703150", None),
    "a small letter in the unit address": (b"0f0410703150", ("unknown_value", 0)),
    "a letter among decimal digits": (b"0F04A0703150", ("unknown_value", 2)),
    "a space in place of a zero": (b"0F 410703150", ("unknown_value", 2)),
    "a sign": (b"0F+410703150", ("unknown_value", 2)),
    "a capital letter in the length": (b"0F0410A03150", ("unknown_value", 5)),
    "another length": (b"0F0410803150", ("wrong_length", 5)),
    "a code that is not a number": (b"0F0410703:50", ("unknown_value", 7)),
    "a code of no message": (b"0F0410703250", ("unknown_code", 7)),
    "anything in the reserved digit": (b"0F041070315x", None),
}
"""The characters of requests, and why and where they are refused."""


@pytest.mark.parametrize("name", FRAMES)
def test_digits_are_read_as_they_are_sent_and_refused_where_they_are_not(name: str) -> None:
    text, refusal = FRAMES[name]
    frame = sealed(text)
    reasons = explained(LAYOUT, "loop", "request", frame).reasons
    if refusal is None:
        decoded = REFERENCE.decode(frame, "request")
        request = LOOP.decode_request(frame)
        assert (decoded.head["unit"], decoded.head["sequence"], decoded.values) == (15, 41, {"channel": 5})
        assert (request.unit_address, request.sequence, request.message.channel) == (15, 41, 5)
        assert reasons == ()
        return
    with pytest.raises(CodecError) as expected:
        REFERENCE.decode(frame, "request")
    with pytest.raises(codec_error()) as caught:
        LOOP.decode_request(frame)
    assert (expected.value.reason, expected.value.offset) == refusal
    assert (caught.value.reason, caught.value.offset) == refusal
    assert refusal[0] in reasons


def test_a_checksum_is_that_of_the_characters() -> None:
    frame = LOOP.encode_request(15, LADDER.ReadLevelRequest(5), sequence=41)
    assert frame == sealed(b"0F0410703150") == b"%0F0410703150107\r"


@pytest.mark.parametrize(("unit_address", "number"), [(0, 1), (64, 1), (1, 1000), (1, -1)])
def test_numbers_beyond_the_digits_or_the_range_are_refused(unit_address: int, number: int) -> None:
    with pytest.raises(codec_error()):
        LOOP.encode_request(unit_address, LADDER.ReadLevelRequest(1), sequence=number)
    with pytest.raises(CodecError):
        REFERENCE.encode("request", "read_level", {"unit": unit_address, "sequence": number, "channel": 1})


def test_a_framer_finds_frames_by_the_digits_of_their_length() -> None:
    chance = random.Random(7)
    frames = [
        LOOP.encode_request(chance.randint(1, 63), LADDER.StoreRequest(list(chance.randbytes(size))), sequence=size)
        for size in (1, 9, 40, 2)
    ]
    garbage = [b"", b"%", b"%0F041x7", b"\r%%zz", b"%40001070315"]
    stream = b"".join(piece for pair in zip(garbage, [*frames, b""], strict=True) for piece in pair)
    for step in (1, 3, len(stream)):
        framer = LOOP.request_framer()
        split = [frame for at in range(0, len(stream), step) for frame in framer.feed(stream[at : at + step])]
        assert split + framer.idle() == frames


def test_a_framer_finds_frames_by_the_digits_of_their_code() -> None:
    requests = [RING.encode_request(unit, LADDER.ReadLevelRequest(unit)) for unit in (1, 8)]
    assert requests[1] == b"!1F88" + b"%02x\r" % reduce(xor, b"1F88")
    framer = RING.request_framer()
    stream = b"!1f88" + requests[0] + b"!1F9810\r!" + requests[1]
    assert [frame for byte in stream for frame in framer.feed(bytes((byte,)))] == requests
    assert framer.dropped == len(stream) - len(b"".join(requests))
    responses = [
        RING.encode_response(2, LADDER.ReadLevelResponse(-5)),
        RING.encode_exception_response(2, 31, LADDER.Trouble(31, 0xAB)),
    ]
    assert responses[1][:8] == b"!9F2031A"
    framer = RING.response_framer()
    assert framer.feed(b"!9G" + b"".join(responses)) == responses
    error = RING.decode_response(responses[1])
    assert (error.code, error.exception.reason) == (31, 0xAB)


def test_a_simulated_device_speaks_in_digits_over_a_line() -> None:
    with simulation("ladder", ports={"host": "pty"}, unit_address=10, folder=str(TEST_SPECS)) as device:
        manager = pyvisa.ResourceManager("@py")
        opened: Any = manager.open_resource(f"ASRL{device.places['host']}::INSTR")
        opened.read_termination = opened.write_termination = "\r"
        opened.timeout = 1000 * SECONDS
        assert opened.query(checked("@10WD001012AB")) == checked("@10WD00")
        assert opened.query(checked("@10RD00100001")) == checked("@10RD0012AB")
        assert device.value("parameters/words/limit") == 0x12AB
        assert opened.query(checked("@10TSabcd1234")) == checked("@10TS00abcd1234")
        manager.close()


def test_a_client_reads_and_writes_words_by_name(capsys: pytest.CaptureFixture[str]) -> None:
    folder = str(TEST_SPECS)
    with simulation("ladder", ports={"host": "pty"}, unit_address=3, folder=folder) as device:
        more = ["--link", "host", "--port", device.places["host"], "--unit", "3", "--specs", folder]
        assert main(["live", "ladder", "write", "target=2500rpm", *more]) == 0
        assert device.value("parameters/words/target") == 2500
        assert main(["live", "ladder", "read", "target", *more]) == 0
        assert "2500" in capsys.readouterr().out


def test_a_generated_client_counts_its_requests_in_digits() -> None:
    client_module = importlib.import_module(f"{LADDER.__package__}.client")
    with simulation("ladder", ports={"loop": "tcp://127.0.0.1:0"}, unit_address=63, folder=str(TEST_SPECS)) as device:
        host, port = device.place.removeprefix("tcp://").split(":")
        with runtime("transports").tcp(host, int(port)) as transport:
            client = client_module.Client(transport, link="loop", unit_address=63)
            replies = [client.ask(LADDER.ReadLevelRequest(channel)) for channel in (1, 8)]
            assert client.ask(LADDER.StoreRequest([0x0D])).message == LADDER.StoreResponse()
    assert [reply.message.level for reply in replies] == [0, 0]
    assert replies[1].sequence == replies[0].sequence + 1
