"""Messages that share a code, and delimiters of each direction."""

from __future__ import annotations

import pytest

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.explain.recognition import recognised
from fieldspec.codec.layout.device import device_layout
from fieldspec.codec.reference.frames import codec
from fieldspec.codec.reference.records import CodecError
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_apart, module_of
from simulators import Unit
from spec_files import gadget

SCANNER = newest(TEST_SPECS, "scanner")
MODULE = module_of(SCANNER)
HOST = codec(SCANNER).links["host"]
CLEARED = bytes.fromhex("06 02 05 08 00 0A 17")
UNKNOWN = bytes.fromhex("06 02 05 08 00 07 14")
SHORT = bytes.fromhex("06 02 05 08 00 0D")
PLACE = bytes.fromhex("06 02 05 11 01 02 19")
REFUSED = bytes.fromhex("06 02 05 88 03 90")


def test_the_subcode_selects_the_message() -> None:
    decoded = HOST.decode(CLEARED, "response")
    assert decoded.message is not None
    assert decoded.message.name == "clear_counters"
    assert MODULE.host.decode_response(CLEARED).message == MODULE.ClearCountersResponse()
    assert explained(SCANNER, "host", "response", CLEARED).message == "clear_counters"
    assert recognised(SCANNER, CLEARED) == [("host", "response", "clear_counters", False)]


@pytest.mark.parametrize(("frame", "reason", "offset"), [(UNKNOWN, "unknown_code", 2), (SHORT, "incomplete", 3)])
def test_a_subcode_that_no_message_has_is_refused_where_it_is(frame: bytes, reason: str, offset: int) -> None:
    for decode in (lambda: HOST.decode(frame, "response"), lambda: MODULE.host.decode_response(frame)):
        with pytest.raises((CodecError, codec_error())) as refused:
            decode()
        assert (refused.value.reason, refused.value.offset) == (reason, offset)
    assert explained(SCANNER, "host", "response", frame).reasons == (reason,)


def test_a_response_with_another_subcode_than_the_request_is_refused() -> None:
    request = MODULE.EchoDataRequest(7)
    with pytest.raises(codec_error()) as refused:
        MODULE.host.decode_response(CLEARED, request)
    assert refused.value.reason == "unknown_code"
    with pytest.raises(codec_error()):
        MODULE.host.decode_response(CLEARED, MODULE.RestartRequest())
    assert MODULE.host.decode_response(CLEARED, MODULE.ClearCountersRequest).message == MODULE.ClearCountersResponse()


def test_an_exception_response_answers_whichever_message_was_sent() -> None:
    assert HOST.decode(REFUSED, "response").message is None
    reply = MODULE.host.decode_response(REFUSED, MODULE.ClearCountersRequest())
    assert (reply.code, reply.exception.reason) == (0x08, 3)
    assert explained(SCANNER, "host", "response", REFUSED, "read_counter").message == "read_counter"


def test_each_direction_has_its_delimiters() -> None:
    request = MODULE.host.encode_request(5, MODULE.ClearCountersRequest())
    assert request == bytes.fromhex("01 05 08 00 0A 17 0D")
    assert MODULE.host.encode_response(5, MODULE.ClearCountersResponse()) == CLEARED
    for frame, direction in ((CLEARED, "request"), (request, "response")):
        with pytest.raises(CodecError, match="does not start with"):
            HOST.decode(frame, direction)
        assert "wrong_mark" in explained(SCANNER, "host", direction, frame).reasons


def test_framers_find_the_frames_of_their_direction() -> None:
    line = MODULE.terminal.encode_request(MODULE.ReadStateRequest())
    assert line == b":10F0\r\n"
    assert MODULE.terminal.request_framer().feed(b"\x00" + line) == [line]
    framer = MODULE.host.response_framer()
    echoed = MODULE.host.encode_response(5, MODULE.EchoDataResponse(7))
    assert len(echoed) != len(CLEARED), "the subcode determines the length"
    assert framer.feed(echoed + CLEARED) == [echoed, CLEARED]


def test_a_simulated_device_answers_each_message_and_stays_silent_where_none_is_due() -> None:
    unit = Unit("scanner", "host", folder=TEST_SPECS)
    assert unit.answer("clear_counters").frame[:2] == bytes.fromhex("06 02")
    answer = unit.answer("restart")
    assert (answer.frame, answer.text) == (b"", "not answered: restart")


def test_only_the_request_tells_what_a_response_without_a_subcode_is() -> None:
    for message, values in (("read_level", {"level": 258}), ("read_place", {"column": 1, "row": 2})):
        assert HOST.decode(PLACE, "response", message).values == values
        assert explained(SCANNER, "host", "response", PLACE, message).message == message
    reply = MODULE.host.decode_response(PLACE, MODULE.ReadPlaceRequest())
    assert (reply.message.column, reply.message.row) == (1, 2)
    assert MODULE.host.decode_response(PLACE, MODULE.ReadLevelRequest).message.level == 258
    assert [reading[2] for reading in recognised(SCANNER, PLACE)] == ["read_level", "read_place"]


@pytest.mark.parametrize("asked", [(), ("clear_counters",)])
def test_a_response_without_a_subcode_is_refused_without_its_request(asked: tuple[str, ...]) -> None:
    request = [MODULE.ClearCountersRequest() for _ in asked]
    codecs = (
        lambda: HOST.decode(PLACE, "response", *asked),
        lambda: MODULE.host.decode_response(PLACE, *request),
    )
    for decode in codecs:
        with pytest.raises((CodecError, codec_error())) as refused:
            decode()
        assert (refused.value.reason, refused.value.offset) == ("unknown_code", 1)
    assert explained(SCANNER, "host", "response", PLACE, *asked).reasons == ("unknown_code",)


def test_a_simulated_device_answers_without_the_subcode() -> None:
    assert Unit("scanner", "host", folder=TEST_SPECS).answer("read_place").frame[2:4] == bytes.fromhex("01 11")


SWAPPED = """
links:
  - name: line
    byte_order: {byte}
    word_order: {word}
    request: &frame [{{name: command, role: code, type: u8}}, {{name: data, role: body}}]
    response: *frame
messages:
  - name: start
    code: 8
    request: [{{name: which, type: u32, const: 0x12345678}}, {{name: speed, type: u16}}]
    response: [{{name: which, type: u32, const: 0x12345678}}]
  - name: halt
    code: 8
    request: [{{name: which, type: u32, const: 0x12345679}}]
    response: [{{name: which, type: u32, const: 0x12345679}}]
"""


@pytest.mark.parametrize(
    ("byte", "word", "start", "halt"),
    [
        ("big", "little", "08 56 78 12 34", "08 56 79 12 34"),
        ("little", "big", "08 34 12 78 56", "08 34 12 79 56"),
        ("big", "big", "08 12 34 56 78", "08 12 34 56 79"),
    ],
)
def test_subcodes_of_two_words_tell_messages_apart_in_any_order_of_words(
    byte: str, word: str, start: str, halt: str
) -> None:
    layout = device_layout(gadget(SWAPPED.format(byte=byte, word=word)).at("")[0])
    module, host = module_apart(layout, f"subcodes_{byte}_{word}"), codec(layout).links["line"]
    for name, frame in (("start", bytes.fromhex(start)), ("halt", bytes.fromhex(halt))):
        decoded = host.decode(frame, "response")
        assert decoded.message is not None
        assert decoded.message.name == name
        reply = getattr(module, f"{name.title()}Response")()
        assert module.line.decode_response(frame).message == reply
        assert explained(layout, "line", "response", frame).message == name


AS_DIGITS = """
links:
  - name: line
    byte_order: big
    frame: [{name: command, role: code, type: u8}, {name: data, role: body}]
messages:
  - name: start
    code: 8
    request: [{name: which, type: u8, digits: upper_hex, length: 2, const: 0x8A}]
    response: [{name: which, type: u8, digits: upper_hex, length: 2, const: 0x8A}]
  - name: halt
    code: 8
    request: [{name: which, type: u8, digits: upper_hex, length: 2, const: 0x80}]
    response:
      - {name: which, type: u8, digits: upper_hex, length: 2, const: 0x80}
      - {name: count, type: u8, digits: decimal, length: 2, measures: {items: values}}
      - {name: values, type: u8, repeat: 0..20}
"""


def test_digits_tell_messages_apart_and_count_lists() -> None:
    layout = device_layout(gadget(AS_DIGITS).at("")[0])
    module, line = module_apart(layout, "subcodes_digits"), codec(layout).links["line"]
    start, halt = b"\x088A", b"\x088012" + bytes(12)
    assert module.line.encode_response(module.StartResponse()) == start
    assert module.line.encode_response(module.HaltResponse([0] * 12)) == halt
    assert module.line.decode_response(start).message == module.StartResponse()
    for frame, name, reason in ((start, "start", ()), (halt, "halt", ()), (halt[:-1], "halt", ("wrong_measure",))):
        explanation = explained(layout, "line", "response", frame)
        assert (explanation.message, explanation.reasons) == (name, reason)
    for frame, reason in ((halt[:-1], "wrong_measure"), (halt.replace(b"12", b"1x"), "unknown_value")):
        for decode in (
            lambda frame=frame: line.decode(frame, "response"),
            lambda frame=frame: module.line.decode_response(frame),
        ):
            with pytest.raises((CodecError, codec_error())) as refused:
                decode()
            assert refused.value.reason == reason


def test_a_size_in_digits_leaves_the_end_of_a_frame_to_silence() -> None:
    module = module_apart(device_layout(gadget(AS_DIGITS).at("")[0]), "framed_digits")
    framer, halt = module.line.response_framer(), b"\x088012" + bytes(12)
    assert framer.feed(halt) == []
    assert framer.idle() == [halt]
