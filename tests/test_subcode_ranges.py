"""Messages that share a code and differ in the range of a byte: the segments of CANopen's service data objects."""

from __future__ import annotations

import pytest

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.reference.frames import codec
from fieldspec.codec.reference.records import CodecError
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of

NODE = newest(TEST_SPECS, "node")
MODULE = module_of(NODE)
SDO = codec(NODE).links["sdo"]


def frame(identifier: int, data: str) -> bytes:
    """A frame on the bus."""
    return bytes(MODULE.sdo.frame_of(identifier, bytes.fromhex(data)))


@pytest.mark.parametrize(
    ("data", "message", "fields"),
    [
        ("60 00 00 00 00 00 00 00", "upload_segment", {"command": 0x60}),
        ("70 00 00 00 00 00 00 00", "upload_segment", {"command": 0x70}),
        ("00 41 42 43 44 45 46 47", "download_segment", {"command": 0x00, "data": b"ABCDEFG"}),
        ("1D 41 00 00 00 00 00 00", "download_segment", {"command": 0x1D, "data": b"A\0\0\0\0\0\0"}),
    ],
)
def test_the_range_of_a_byte_selects_the_message(data: str, message: str, fields: dict[str, object]) -> None:
    sent = frame(0x605, data)
    decoded = SDO.decode(sent, "request")
    assert decoded.message is not None
    assert decoded.message.name == message
    assert {name: decoded.values[name] for name in fields} == fields
    assert MODULE.sdo.encode_request(5, MODULE.sdo.decode_request(sent).message) == sent
    assert explained(NODE, "sdo", "request", sent).message == message


def test_bits_of_a_segment_are_fields() -> None:
    segment = MODULE.sdo.decode_request(frame(0x605, "1D 41 00 00 00 00 00 00")).message.command
    assert (segment.toggle, segment.unused, segment.last) == (True, 6, True)
    request = MODULE.UploadSegmentRequest(MODULE.SegmentTurn(specifier=3, toggle=True))
    assert MODULE.sdo.encode_request(5, request) == frame(0x605, "70 00 00 00 00 00 00 00")


def test_a_number_of_no_message_is_refused_where_it_is() -> None:
    sent = frame(0x605, "61 00 00 00 00 00 00 00")
    for decode in (lambda: SDO.decode(sent, "request"), lambda: MODULE.sdo.decode_request(sent)):
        with pytest.raises((CodecError, codec_error())) as refused:
            decode()
        assert refused.value.reason == "unknown_code"
    read = explained(NODE, "sdo", "request", sent)
    assert read.reasons == ("unknown_code",)


def test_a_number_of_another_message_is_not_sent() -> None:
    with pytest.raises(codec_error(), match="command"):
        MODULE.sdo.encode_request(5, MODULE.UploadSegmentRequest(MODULE.SegmentTurn(0x61)))
    with pytest.raises(CodecError):
        SDO.encode("request", "upload_segment", {"node": 5, "command": 0x61})
