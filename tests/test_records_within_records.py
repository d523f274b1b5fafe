"""Records of no fixed size within others, and lists with fields after them: all codecs read and refuse them alike."""

from __future__ import annotations

from typing import Any

import pytest

from captures.bulk import Sent, decoded, verdicts
from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.reference import CodecError, codec
from fieldspec.tools.captures.decoding import Choices
from fieldspec.tools.evidence.redaction import Redaction
from fieldspec.tools.evidence.secrets import Secrets
from layouts import TEST_SPECS, newest
from python_package import codec_error, link_of, module_of

LAYOUT = newest(TEST_SPECS, "sorter")
CODEC = codec(LAYOUT)
LINE = link_of(module_of(LAYOUT), "line")
HEADER = 2
"""The bytes before the data: kind and number of bytes."""
PARCEL = {"weights": [10, 256], "lane": 2}
LABEL = {"letters": "AB", "digits": "7"}
PALLET = {"number": 0x0102, "parcels": [PARCEL, {"weights": [], "lane": 1}], "state": 3, "codes": [7], "label": LABEL}
TRUCK = {"front": {"weights": [1], "lane": 1}, "pallets": [PALLET], "gate": 9}
PALLET_BYTES = "0201 02 0300 02 000A 0100 02 00 01 03 0007 02 01 4142 2D 37"
TRUCK_BYTES = f"02 01 0001 01 {PALLET_BYTES} 09"
MQTT = "82 0E 00 0A 00 03 61 2F 62 01 00 03 63 2F 64 02"
"""The example of SUBSCRIBE in MQTT 3.1.1, figures 3.21 and 3.23: two topics, each with a quality after it."""

REQUESTS = {
    f"05 {TRUCK_BYTES} 00 00 2D 0D0A": {"dock": 5, "truck": TRUCK, "driver": {"letters": "", "digits": ""}},
    "05 01 00 02 09 01 00 5A 2D 0D0A": {
        "dock": 5,
        "truck": {"front": {"weights": [], "lane": 2}, "pallets": [], "gate": 9},
        "driver": {"letters": "Z", "digits": ""},
    },
    "05 04 00 02 09 01 00 5A 2D 0D0A": ("wrong_measure", 1),
    "05 01 04 02 09 01 00 5A 2D 0D0A": ("wrong_measure", 2),
    "05 01 00 03 09 01 00 5A 2D 0D0A": ("unknown_value", 3),
    "05 01 00 02 09 05 00 5A 2D 0D0A": ("wrong_measure", 5),
    "05 01 00 02 09 01 00 00 2D 0D0A": ("unknown_value", 7),
    "05 01 00 02 09 01 00 5A 2E 0D0A": ("wrong_const", 8),
    f"05 {TRUCK_BYTES.replace('02 000A', '04 000A')} 00 00 2D 0D0A": ("wrong_measure", 11),
    f"05 {TRUCK_BYTES.replace('0300', '0200')} 00 00 2D 0D0A": ("wrong_measure", 9),
    f"05 {TRUCK_BYTES.replace('01 03 0007', '03 03 0007')} 00 00 2D 0D0A": ("unknown_value", 18),
    "05 01 00 02 09 01 00 5A 2D 0D0A 00": ("wrong_length", 9),
    "05 01 00 02 09 01 02 5A 2D 0D0A": ("incomplete", 9),
    "05 01": ("incomplete", 2),
}
"""Data of the request to load: its values, or why and at which byte it is refused."""


def frame_of(code: int, data: str) -> bytes:
    """A frame of the line."""
    body = bytes.fromhex(data)
    return bytes([code, len(body)]) + body


def test_the_printed_subscription_of_mqtt_is_read_and_written() -> None:
    frame = bytes.fromhex(MQTT)
    values = CODEC.links["line"].decode(frame, "request").values
    assert values["filters"] == [
        {"length": 3, "topic": "a/b", "quality": 1},
        {"length": 3, "topic": "c/d", "quality": 2},
    ]
    message = LINE.decode_request(frame).message
    assert [(own.topic, own.quality) for own in message.filters] == [("a/b", 1), ("c/d", 2)]
    assert bytes(LINE.encode_request(message)) == frame


@pytest.mark.parametrize("data", REQUESTS)
def test_records_of_no_fixed_size_are_read_and_refused_alike(data: str) -> None:
    frame, wanted = frame_of(0x22, data), REQUESTS[data]
    reasons = explained(LAYOUT, "line", "request", frame).reasons
    (verdict,) = verdicts(decoded(LAYOUT, [Sent(0, "request", frame)], Choices("line", "")))
    assert verdict == (reasons[0] if reasons else "ok")
    if isinstance(wanted, dict):
        assert known(CODEC.links["line"].decode(frame, "request").values) == wanted
        message = LINE.decode_request(frame).message
        assert bytes(LINE.encode_request(message)) == frame
        assert CODEC.links["line"].encode("request", "load", wanted) == frame
        return
    reason, at = wanted
    with pytest.raises(CodecError) as expected:
        CODEC.links["line"].decode(frame, "request")
    with pytest.raises(codec_error()) as refused:
        LINE.decode_request(frame)
    place = reason, HEADER + at
    assert (expected.value.reason, expected.value.offset) == place
    assert (refused.value.reason, refused.value.offset) == place
    assert reason in reasons


def known(values: Any) -> Any:
    """Values without those that encoders compute."""
    if isinstance(values, list):
        return [known(value) for value in values]
    if not isinstance(values, dict):
        return values
    computed = {"weight_count", "parcel_count", "code_bytes", "pallet_count", "length", "size", "mark", "end"}
    return {name: known(value) for name, value in values.items() if name not in computed}


def test_python_has_records_in_records_as_objects() -> None:
    truck = LINE.decode_request(frame_of(0x22, next(iter(REQUESTS)))).message.truck
    assert (truck.front.weights, truck.gate, truck.pallets[0].parcels[0].weights) == ([1], 9, [10, 256])
    assert (truck.pallets[0].label.letters, truck.pallets[0].codes) == ("AB", [7])


def test_an_explanation_has_each_value_where_it_is_sent() -> None:
    rows = explained(LAYOUT, "line", "request", frame_of(0x22, next(iter(REQUESTS)))).rows
    places = {row.path: row.offset - HEADER for row in rows if row.kind == "field"}
    assert places["truck.pallets[0].parcels[1].lane"] == 18
    assert places["truck.pallets[0].label.digits"] == 27
    assert places["truck.gate"] == 28
    assert places["driver.mark"] == 31


def test_a_list_whose_count_is_in_the_request_has_fields_behind_it() -> None:
    frame = frame_of(0x21, "000A 0100 02 00010A")
    assert LINE.decode_response(frame).message.weights == [10, 256]
    with pytest.raises(codec_error()) as refused:
        LINE.decode_response(frame_of(0x21, "000A 01 02 00010A"))
    assert (refused.value.reason, refused.value.offset) == ("wrong_length", HEADER + 3)


def test_redaction_finds_the_texts_of_records_within_records() -> None:
    frame = frame_of(0x22, next(iter(REQUESTS)))
    read = CODEC.links["line"].decode(frame, "request")
    clean = Redaction(LAYOUT, Secrets()).frame("line", "request", frame, read, {})
    assert clean == frame.replace(b"AB-7", b"XX-X")
