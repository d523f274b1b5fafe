"""Exception responses that a code of their own marks, or a part before the body."""

from __future__ import annotations

import pytest

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.explain.readings import FrameOptions, OpenRequest, read_frame, remarks_on
from fieldspec.codec.reference.frames import codec
from fieldspec.codec.reference.records import CodecError
from fieldspec.tools.live.client import Client, RefusedError, Timing
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of

SCANNER = newest(TEST_SPECS, "scanner")
MODULE = module_of(SCANNER)
LINKS = codec(SCANNER).links
REFUSED_LINE = b">FF02FF\r"
BUSY = bytes.fromhex("05 02 10 17")


class Line:
    """A line on which one frame comes."""

    datagrams = True

    def __init__(self, frame: bytes) -> None:
        self.frame = frame
        self.sent = False

    def write(self, data: bytes) -> None:
        self.sent = True

    def read(self, timeout: float) -> bytes:
        return self.frame if self.sent else b""

    def close(self) -> None:
        """Nothing is open."""


def test_a_code_of_its_own_marks_an_exception_response() -> None:
    decoded = LINKS["terminal"].decode(REFUSED_LINE, "response")
    assert (decoded.error, decoded.message, decoded.values) == (True, None, {"reason": 2})
    reply = MODULE.terminal.decode_response(REFUSED_LINE, MODULE.ReadStateRequest())
    assert (reply.code, reply.exception) == (0xFF, MODULE.Refusal(2))
    assert MODULE.terminal.encode_exception_response(0xFF, MODULE.Refusal(2)) == REFUSED_LINE
    with pytest.raises(codec_error()) as refused:
        MODULE.terminal.encode_exception_response(0x10, MODULE.Refusal(2))
    assert refused.value.reason == "unknown_code"
    assert explained(SCANNER, "terminal", "response", REFUSED_LINE).error


def test_a_code_of_its_own_is_no_code_of_a_request() -> None:
    asked = explained(SCANNER, "terminal", "request", LINKS["terminal"].encode("request", "read_state", {}))
    chosen = read_frame(SCANNER, REFUSED_LINE, FrameOptions(), open_request=OpenRequest(asked, True))
    assert (chosen.wrong, chosen.explanation.message, chosen.chosen) == (False, "read_state", "request")
    unasked = explained(SCANNER, "terminal", "response", REFUSED_LINE)
    (meaning,) = next(row for row in unasked.rows if row.path == "command").meanings
    assert meaning.text == "a request is refused"


@pytest.mark.parametrize(
    ("device", "link", "message", "frame"),
    [
        ("scanner", "terminal", "read_state", REFUSED_LINE),
        ("servo2", "bus", "read", bytes.fromhex("FF FF FD 00 01 04 00 55 04 BA 8C")),
    ],
)
def test_an_exception_response_answers_the_message_that_the_user_names(
    device: str, link: str, message: str, frame: bytes
) -> None:
    layout = newest(TEST_SPECS, device)
    options = FrameOptions(((link, "response"),), message)
    chosen = read_frame(layout, frame, options)
    assert (chosen.readings, chosen.wrong) == (((link, "response", message, True),), False)
    assert not list(remarks_on(layout, chosen, 0, options))


def test_a_part_before_the_body_marks_an_exception_response() -> None:
    decoded = LINKS["panel"].decode(BUSY, "response")
    assert decoded.error
    assert decoded.message is not None
    assert decoded.message.name == "read_state"
    reply = MODULE.panel.decode_response(BUSY, MODULE.ReadStateRequest())
    assert (reply.unit_address, reply.code, reply.status) == (5, 0x10, 2)
    assert MODULE.panel.encode_exception_response(5, 0x10, MODULE.Nothing(), status=2) == BUSY


def test_a_response_is_not_encoded_with_the_mark_of_the_other_kind() -> None:
    with pytest.raises(codec_error()) as refused:
        MODULE.panel.encode_response(5, MODULE.ReadStateResponse(7), status=2)
    assert refused.value.reason == "out_of_range"
    with pytest.raises(codec_error()):
        MODULE.panel.encode_exception_response(5, 0x10, MODULE.Nothing(), status=100)
    for error, values in ((False, {"status": 2, "state": 7}), (True, {"status": 0})):
        with pytest.raises(CodecError, match="status is"):
            LINKS["panel"].encode("response", "read_state", {"station": 5, **values}, error=error)


@pytest.mark.parametrize(
    ("link", "frame", "number", "name"), [("panel", BUSY, 2, "busy"), ("terminal", REFUSED_LINE, 2, "")]
)
def test_a_client_raises_what_an_exception_response_says(link: str, frame: bytes, number: int, name: str) -> None:
    client = Client(SCANNER, link, Line(frame), 5, Timing(timeout=5))
    with pytest.raises(RefusedError) as refused:
        client.ask("read_state", {})
    assert (refused.value.number, refused.value.name) == (number, name)


def test_a_part_marks_an_exception_response_where_responses_carry_no_code() -> None:
    servo = newest(TEST_SPECS, "servo2")
    module, line = module_of(servo), codec(servo).links["bus"]
    refusal = module.bus.encode_exception_response(1, module.NoData(), error=module.Error(4))
    assert line.encode("response", "", {"id": 1, "error": 4}, error=True) == refusal
    reply = module.bus.decode_response(refusal, module.ReadRequest(address=132, size=4))
    assert (reply.code, reply.error.number, reply.exception) == (
        2,
        module.ErrorNumber.DATA_RANGE_ERROR,
        module.NoData(),
    )
    decoded = line.decode(refusal, "response", "read")
    assert (decoded.error, decoded.values) == (True, {})
    assert explained(servo, "bus", "response", refusal, "read").error
    with pytest.raises(codec_error()):
        module.bus.encode_response(1, module.WriteResponse(), error=module.Error(4))
    alert = module.bus.encode_response(1, module.WriteResponse(), error=module.Error(0x80))
    assert not line.decode(alert, "response", "write").error
    with pytest.raises(RefusedError):
        Client(servo, "bus", Line(refusal), 1, Timing(timeout=0.2, retries=0)).ask("read", {"address": 132, "size": 4})
