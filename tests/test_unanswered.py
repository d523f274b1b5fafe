"""Requests that a device does not answer: on some links, or never."""

from __future__ import annotations

import importlib

import pytest

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.explain.occupants import occupant_at
from fieldspec.codec.explain.recognition import recognised
from fieldspec.codec.reference.frames import codec
from fieldspec.codec.reference.records import CodecError
from fieldspec.tools.live.client import Client, Timing
from fieldspec.tools.live.writing import Assignment, write
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of, runtime
from simulators import Unit

CALLER = newest(TEST_SPECS, "caller")
MODULE = module_of(CALLER)
LINKS = codec(CALLER).links
RESET = bytes.fromhex("01 08 05 E7 C3")
WRITE_FRAME = bytes.fromhex("01 06 00 01 20 19")
STATUS = bytes.fromhex("FF FF 01 02 00 03")


class Line:
    """A line that keeps what is written, and on which nothing comes."""

    datagrams = False

    def __init__(self) -> None:
        self.frames: list[bytes] = []

    def write(self, data: bytes) -> None:
        self.frames.append(data)

    def read(self, timeout: float) -> bytes:
        assert timeout < 0.01, "nobody waits for an answer that does not come"
        return b""

    def close(self) -> None:
        """Nothing is open."""


def test_a_response_with_the_code_of_what_is_never_answered_is_refused_at_the_code() -> None:
    for decode in (
        lambda: LINKS["bus"].decode(RESET, "response"),
        lambda: MODULE.bus.decode_response(RESET),
        lambda: MODULE.bus.decode_response(RESET, MODULE.ResetRequest),
    ):
        with pytest.raises((CodecError, codec_error())) as refused:
            decode()
        assert (refused.value.reason, refused.value.offset) == ("unknown_code", 1)
    assert explained(CALLER, "bus", "response", RESET).reasons == ("unknown_code",)
    assert ("bus", "response", "reset", False) not in recognised(CALLER, RESET)


def test_a_response_without_a_code_answers_nothing_that_is_not_answered() -> None:
    for message in ("write", "reset", "latch"):
        with pytest.raises(CodecError, match="not answered on status"):
            LINKS["status"].decode(STATUS, "response", message)
    for request in (MODULE.WriteRequest, MODULE.ResetRequest, MODULE.LatchRequest):
        with pytest.raises(codec_error()) as refused:
            MODULE.status.decode_response(STATUS, request)
        assert refused.value.reason == "unknown_code"


def test_a_response_to_what_is_not_answered_is_not_encoded() -> None:
    for link, message in (("bus", "reset"), ("status", "write"), ("shout", "latch")):
        with pytest.raises(CodecError, match=f"not answered on {link}"):
            LINKS[link].encode("response", message, {"station": 1, "id": 1, "error": 0, "address": 0})


def test_what_is_answered_on_one_link_is_decoded_there() -> None:
    assert LINKS["bus"].decode(WRITE_FRAME, "response").values == {"address": 1}
    assert MODULE.bus.decode_response(WRITE_FRAME, MODULE.WriteRequest).message == MODULE.WriteResponse(1)


def test_python_has_no_responses_where_there_are_none() -> None:
    assert not hasattr(MODULE, "ResetResponse")
    assert not hasattr(MODULE.ResetRequest, "response_type")
    assert not hasattr(MODULE.shout, "decode_response")
    assert not hasattr(MODULE.shout, "response_framer")
    assert (
        MODULE.shout.decode_request(MODULE.shout.encode_request(MODULE.LatchRequest())).message == MODULE.LatchRequest()
    )


def test_a_client_does_not_wait_for_an_answer_that_does_not_come() -> None:
    line = Line()
    client = Client(CALLER, "bus", line, 1, Timing(timeout=5))
    client.send("reset", {"delay": 5})
    assert line.frames == [RESET]
    client = Client(CALLER, "status", line, 1, Timing(timeout=5))
    speed = occupant_at(CALLER, "", 0)
    assert speed is not None
    write(client, Assignment("", speed, (7,), ()))
    assert line.frames[1] == LINKS["status"].encode("request", "write", {"id": 1, "address": 0, "value": 7})


def test_a_generated_client_sends_what_nobody_answers_and_refuses_to_ask_it() -> None:
    client = importlib.import_module(f"{MODULE.__package__}.client")
    line = Line()
    caller = client.Client(line, link="bus", timeout=5)
    with pytest.raises(
        runtime("errors").InvalidValueError, match=r"ResetRequest has no response on this link: use `send`"
    ):
        caller.ask(MODULE.ResetRequest(5))
    assert line.frames == []
    caller.send(MODULE.ResetRequest(5))
    assert line.frames == [RESET]
    caller = client.Client(line, link="status", timeout=5)
    caller.write(MODULE.SPEED, 7)
    assert line.frames[1] == LINKS["status"].encode("request", "write", {"id": 1, "address": 0, "value": 7})


def test_a_simulated_device_carries_out_what_it_does_not_answer() -> None:
    unit = Unit("caller", "status", folder=TEST_SPECS)
    assert unit.answer("write", address=1, value=9).frame == b""
    assert unit.ask("read", address=1, count=1)["values"] == [9]
    answer = unit.answer("latch")
    assert (answer.frame, answer.text) == (b"", "not answered: latch")
    assert Unit("caller", "bus", folder=TEST_SPECS).answer("write", address=1, value=9).frame != b""
