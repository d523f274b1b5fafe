"""Counts of the bytes of a field whose type another one decides, with texts among the types: frames that others have
published of the serial protocol of Tuya.
"""

from __future__ import annotations

from typing import Any

import pytest

from captures.bulk import Sent, decoded, verdicts
from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.reference import CodecError, codec
from fieldspec.targets import OUTPUTS
from fieldspec.tools.captures.decoding import Choices
from layouts import TEST_SPECS, newest
from python_package import codec_error, link_of, module_of

LAYOUT = newest(TEST_SPECS, "thermostat")
LINE = codec(LAYOUT).links["module"]
MODULE = link_of(module_of(LAYOUT), "module")
HEADER = 6
"""The bytes before the data points."""
RAW, BOOLEAN, NUMBER, STRING, ENUMERATION, BITMAP = range(6)


def frame_of(points: str) -> bytes:
    """A report of some data points."""
    data = bytes.fromhex(points)
    frame = bytes.fromhex("55 AA 03 07") + len(data).to_bytes(2, "big") + data
    return frame + bytes([sum(frame) & 0xFF])


def point(id: int, type: int, length: int, value: Any) -> dict[str, Any]:
    """The values of a data point."""
    return {"id": id, "type": type, "length": length, "value": value}


PUBLISHED = {
    "55 AA 03 07 00 05 12 01 00 01 01 23": [point(18, BOOLEAN, 1, True)],
    "55 AA 03 07 00 08 02 02 00 04 00 00 00 64 7D": [point(2, NUMBER, 4, 100)],
    "55 AA 03 07 00 05 03 04 00 01 00 16": [point(3, ENUMERATION, 1, 0)],
    "55 AA 00 07 00 1C 01 01 00 01 00 05 02 00 04 00 00 00 29 65 01 00 01 00 66 04 00 01 00 67 04 00 01 00 97": [
        point(1, BOOLEAN, 1, False),
        point(5, NUMBER, 4, 41),
        point(101, BOOLEAN, 1, False),
        point(102, ENUMERATION, 1, 0),
        point(103, ENUMERATION, 1, 0),
    ],
    "55 AA 01 07 00 0D 77 00 00 09 05 06 0E 08 00 0F 0B 1E 0F FC": [
        point(119, RAW, 9, bytes.fromhex("05 06 0E 08 00 0F 0B 1E 0F")),
    ],
    "55 AA 03 07 00 15 66 00 00 11 B4 00 00 01 01 03 01 00 14 00 01 0A 00 4B 00 0A 03 C6": [
        point(102, RAW, 17, bytes.fromhex("B4 00 00 01 01 03 01 00 14 00 01 0A 00 4B 00 0A 03")),
    ],
}
"""Reports of devices, as users have written them down, with their data points."""


@pytest.mark.parametrize("printed", PUBLISHED)
def test_published_frames_have_the_data_points_that_were_sent(printed: str) -> None:
    frame = bytes.fromhex(printed)
    values = LINE.decode(frame, "response").values
    message = MODULE.decode_response(frame).message
    assert values["points"] == PUBLISHED[printed]
    assert [own.value for own in message.points] == [own["value"] for own in PUBLISHED[printed]]
    assert LINE.encode("response", "report_status", {**values, "version": frame[2]}) == frame
    assert MODULE.encode_response(message, version=frame[2]) == frame
    assert explained(LAYOUT, "module", "response", frame).reasons == ()
    assert verdicts(decoded(LAYOUT, [Sent(0, "response", frame)], Choices("module", ""))) == ["ok"]


@pytest.mark.parametrize("text", ["", "a", "Küche", "x" * 255])
def test_a_text_has_as_many_bytes_as_the_count_says_and_is_written_with_its_count(text: str) -> None:
    data = text.encode()
    frame = frame_of(f"07 03 {len(data):04X} {data.hex()} 05 05 00 01 80")
    values = LINE.decode(frame, "response").values
    message = MODULE.decode_response(frame).message
    assert values["points"] == [point(7, STRING, len(data), text), point(5, BITMAP, 1, 128)]
    assert [own.value for own in message.points] == [text, 128]
    assert LINE.encode("response", "report_status", {**values, "version": 3}) == frame
    assert MODULE.encode_response(message, version=3) == frame
    assert verdicts(decoded(LAYOUT, [Sent(0, "response", frame)], Choices("module", ""))) == ["ok"]


@pytest.mark.parametrize(
    "data", [b"", b"\0", b"\1", b"\1\0\0", b"\0" * 255], ids=["none", "zero", "one", "zeros_after_one", "most"]
)
def test_bytes_have_any_content_and_as_many_as_the_count_says(data: bytes) -> None:
    frame = frame_of(f"07 00 {len(data):04X} {data.hex()} 05 05 00 01 80")
    values = LINE.decode(frame, "response").values
    message = MODULE.decode_response(frame).message
    assert values["points"] == [point(7, RAW, len(data), data), point(5, BITMAP, 1, 128)]
    assert [own.value for own in message.points] == [data, 128]
    assert LINE.encode("response", "report_status", {**values, "version": 3}) == frame
    assert MODULE.encode_response(message, version=3) == frame
    assert verdicts(decoded(LAYOUT, [Sent(0, "response", frame)], Choices("module", ""))) == ["ok"]


@pytest.mark.parametrize(
    ("points", "reason", "place"),
    [
        ("12 01 00 02 01 01", "wrong_measure", 2),
        ("12 02 00 01 01", "wrong_measure", 2),
        ("12 03 01 00" + "61" * 256, "wrong_measure", 2),
        ("12 06 00 01 01", "unknown_value", 1),
        ("12 00 01 00" + "61" * 256, "wrong_measure", 2),
        ("12 00 00 03 61 62", "incomplete", 6),
        ("12 03 00 03 61 62", "incomplete", 6),
        ("12 03 00 03 61 00 62", "unknown_value", 4),
        ("12 01 00 01 02", "unknown_value", 4),
    ],
)
def test_wrong_counts_types_and_texts_are_refused_alike(points: str, reason: str, place: int) -> None:
    frame = frame_of(points)
    with pytest.raises(CodecError) as expected:
        LINE.decode(frame, "response")
    with pytest.raises(codec_error()) as refused:
        MODULE.decode_response(frame)
    for error in (expected.value, refused.value):
        assert (error.reason, error.offset) == (reason, HEADER + place)
    assert reason in explained(LAYOUT, "module", "response", frame).reasons
    assert verdicts(decoded(LAYOUT, [Sent(0, "response", frame)], Choices("module", ""))) == [reason]


@pytest.mark.parametrize(("kind", "value"), [(STRING, "x" * 256), (RAW, b"x" * 256)])
def test_longer_texts_and_bytes_are_not_written(kind: int, value: str | bytes) -> None:
    message: Any = MODULE.decode_response(frame_of(f"07 {kind:02X} 00 01 61")).message
    message.points[0].value = value
    with pytest.raises(codec_error(), match="wrong_length"):
        MODULE.encode_response(message, version=3)


def test_outputs_without_such_choices_leave_them_out_by_name() -> None:
    texts = OUTPUTS["queries"].files([LAYOUT])
    (sql,) = (text for path, text in texts.items() if path.endswith(".sql") and isinstance(text, str))
    assert "data_point: value " in sql
