"""Fields whose type another one decides, with fields behind them and in records: codecs read and refuse them alike."""

from __future__ import annotations

from typing import Any

import pytest

from captures.bulk import Sent, decoded, verdicts
from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.layout.values import MeaningError, raw_of
from fieldspec.codec.reference import CodecError, codec
from fieldspec.targets import OUTPUTS
from fieldspec.tools.captures.decoding import Choices
from fieldspec.tools.evidence.redaction import Redaction
from fieldspec.tools.evidence.secrets import Secrets
from layouts import TEST_SPECS, newest
from python_package import codec_error, link_of, module_of

LAYOUT = newest(TEST_SPECS, "weigher")
CODEC = codec(LAYOUT)
BUS = link_of(module_of(LAYOUT), "bus")
HEADER = 2
"""The bytes before the data: station and function."""
PAIR = "04414243 01 BEEF"
"""A pair whose first sample has letters."""
RESPONSES: dict[str, Any] = {
    f"{PAIR} 00 01 07": ("ABC", [], 7),
    f"{PAIR} 02 02FEFFFFFF00 01C801 03 0102": ("ABC", [-65537, 200], 258),
    f"{PAIR} 01 09FEFFFFFF00 01 07": ("unknown_value", 8),
    f"{PAIR} 01 02FEFF": ("incomplete", 10),
    f"{PAIR} 00 03 01": ("incomplete", 10),
    f"{PAIR} 00 01 0701": ("wrong_length", 10),
    f"{PAIR} 00 02 07": ("unknown_value", 8),
    "04FF4243 01 BEEF 00 01 07": ("unknown_value", 1),
    "0505 01 BEEF 00 01 07": ("unknown_value", 0),
}
"""Data of a response: the values of its samples and of the last field, or why and at which byte it is refused."""
REQUESTS: dict[str, Any] = {
    "0100 07 05": 7,
    "0200 3F800000 05": 1.0,
    "0400 3F800000 05": 1.0,
    "0100 08 05": ("wrong_const", 2),
    "0300 3F800000 05": ("unknown_value", 0),
    "0200 3F8000 05": ("incomplete", 6),
}
"""Data of a request: its limit, or why and at which byte it is refused."""


def frame_of(direction: str, data: str) -> bytes:
    """A frame of the bus with the right checksum."""
    return CODEC.links["bus"].with_checksum(direction, bytes.fromhex(f"01 46 {data} 00 00"))


def assert_refused(direction: str, frame: bytes, reason: str, at: int) -> None:
    """All codecs refuse a frame alike."""
    with pytest.raises(CodecError) as expected:
        CODEC.links["bus"].decode(frame, direction)
    with pytest.raises(codec_error()) as refused:
        getattr(BUS, f"decode_{direction}")(frame)
    assert (expected.value.reason, expected.value.offset) == (reason, HEADER + at)
    assert (refused.value.reason, refused.value.offset) == (reason, HEADER + at)
    assert reason in explained(LAYOUT, "bus", direction, frame).reasons


@pytest.mark.parametrize("data", RESPONSES)
def test_choices_in_elements_and_in_records_are_read_and_refused_alike(data: str) -> None:
    frame, expected = frame_of("response", data), RESPONSES[data]
    reasons = explained(LAYOUT, "bus", "response", frame).reasons
    (verdict,) = verdicts(decoded(LAYOUT, [Sent(0, "response", frame)], Choices("bus", "")))
    assert verdict == (reasons[0] if reasons else "ok")
    if (isinstance(expected[0], str) and "_" in expected[0]) or expected[0] == "incomplete":
        assert_refused("response", frame, *expected)
        return
    values = CODEC.links["bus"].decode(frame, "response").values
    message = BUS.decode_response(frame).message
    first, samples, last = expected
    assert (values["pair"]["first"]["value"], values["last"]) == (first, last)
    assert (message.pair.first.value, message.last) == (first, last)
    assert [own["value"] for own in values["samples"]] == [own.value for own in message.samples] == samples
    assert bytes(BUS.encode_response(1, message)) == frame
    assert CODEC.links["bus"].encode("response", "read_samples", {"station": 1, **values}) == frame


@pytest.mark.parametrize("data", REQUESTS)
def test_a_choice_with_fields_behind_it_is_read_and_refused_alike(data: str) -> None:
    frame, expected = frame_of("request", data), REQUESTS[data]
    if isinstance(expected, tuple):
        assert_refused("request", frame, *expected)
        return
    values = CODEC.links["bus"].decode(frame, "request").values
    message = BUS.decode_request(frame).message
    assert values["limit"] == message.limit == expected
    assert bytes(BUS.encode_request(1, message)) == frame
    assert CODEC.links["bus"].encode("request", "read_samples", {"station": 1, **values}) == frame


def test_an_explanation_has_each_field_where_it_is_sent() -> None:
    rows = explained(LAYOUT, "bus", "response", frame_of("response", list(RESPONSES)[1])).rows
    places = {row.path: row.offset - HEADER for row in rows if row.kind == "field"}
    assert [places[path] for path in ("pair.first.state", "samples[0].value", "samples[1].coding", "last")] == [
        4,
        9,
        14,
        18,
    ]


def test_redaction_replaces_texts_of_choices_and_leaves_all_else() -> None:
    data = list(RESPONSES)[1]
    frame, replaced = (frame_of("response", own) for own in (data, data.replace("414243", "585858")))
    read = CODEC.links["bus"].decode(frame, "response")
    assert Redaction(LAYOUT, Secrets()).frame("bus", "response", frame, read, {}) == replaced


def test_entered_values_have_the_type_that_is_decided() -> None:
    body = LAYOUT.messages["read_samples"].response
    entered = {"pair": {"first": {"coding": "weight", "value": "-2 g"}}, "coding": "grams", "last": "0x102"}
    raw = raw_of(LAYOUT.device, (), body, entered)
    assert (raw["pair"], raw["last"]) == ({"first": {"coding": 2, "value": -2}}, 0x102)
    with pytest.raises(MeaningError, match="leaves open what value holds"):
        raw_of(LAYOUT.device, (), body, {"pair": {"first": {"coding": "nothing", "value": "1"}}})


def test_outputs_without_choices_within_data_leave_them_out_by_name() -> None:
    texts = OUTPUTS["queries"].files([LAYOUT])
    (sql,) = (text for path, text in texts.items() if path.endswith(".sql") and isinstance(text, str))
    assert "record sample: value has several types and fields after it" in sql
    assert "message read_samples: " in sql
