"""Fields whose type some bits of another one decide: codecs read, write and refuse them alike, with all other bits."""

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

LAYOUT = newest(TEST_SPECS, "heatmeter")
BUS = codec(LAYOUT).links["bus"]
METERS = link_of(module_of(LAYOUT), "bus")
HEAD = {"control": 8, "address": 1}
HEADER = 19
"""The bytes before the records."""
INT_32, REAL_32 = 0x04, 0x05


def frame_of(records: str) -> bytes:
    """A frame of some records."""
    body = bytes.fromhex("08 01 72" + "00" * 12 + records)
    return bytes([0x68, len(body), len(body), 0x68]) + body + bytes([sum(body) & 0xFF, 0x16])


@pytest.mark.parametrize(
    ("record", "number"),
    [
        ("01 13 FE", -2),
        ("42 13 01 02", 0x201),
        ("33 13 FF FF FF", -1),
        ("74 13 00 00 00 80", -(2**31)),
        ("15 13 00 00 C0 3F", 1.5),
        ("06 13 01 00 00 00 00 80", 1 - 2**47),
        ("2C 13 78 56 34 12", 12345678),
    ],
)
def test_the_other_bits_do_not_matter_to_the_type_and_are_written_again(record: str, number: float) -> None:
    frame = frame_of(record)
    values = BUS.decode(frame, "response").values
    message = METERS.decode_response(frame).message
    assert (values["records"][0]["data"], message.records[0].data) == (number, number)
    assert BUS.encode("response", "variable_data", {**values, **HEAD}) == frame
    assert METERS.encode_response(message, **HEAD) == frame


def test_data_of_a_case_without_data_may_be_left_out() -> None:
    frame = frame_of("00 13")
    values = BUS.decode(frame, "response").values
    (record,) = METERS.decode_response(frame).message.records
    sent = {name: value for name, value in values["records"][0].items() if name != "data"}
    assert BUS.encode("response", "variable_data", {**values, "records": [sent], **HEAD}) == frame
    assert type(record)(**{name: getattr(record, name) for name in sent}) == record


@pytest.mark.parametrize(
    ("records", "reason", "place"),
    [
        ("02 13 01 00 0D 13", "unknown_value", 4),
        ("4D 13 02 41 42", "unknown_value", 0),
        ("04 13 01 02 03", "incomplete", 5),
    ],
)
def test_bits_without_a_case_and_missing_bytes_are_refused_alike(records: str, reason: str, place: int) -> None:
    frame = frame_of(records)
    with pytest.raises(CodecError) as expected:
        BUS.decode(frame, "response")
    with pytest.raises(codec_error()) as refused:
        METERS.decode_response(frame)
    for error in (expected.value, refused.value):
        assert (error.reason, error.offset) == (reason, HEADER + place)
    assert reason in explained(LAYOUT, "bus", "response", frame).reasons
    [verdict] = verdicts(decoded(LAYOUT, [Sent(0, "response", frame)], Choices("bus", "")))
    assert verdict == reason


@pytest.mark.parametrize(("dif", "reason"), [(INT_32, "wrong_type"), (0x0D, "unknown_value"), (0x01, "out_of_range")])
def test_a_value_of_another_case_is_not_written(dif: int, reason: str) -> None:
    number = 1.5 if dif == INT_32 else 300
    record = {"dif": dif, "dife": [], "vif": 0x13, "vife": [], "data": number}
    values = BUS.decode(frame_of(""), "response").values | {"records": [record]}
    with pytest.raises(CodecError, match=reason):
        BUS.encode("response", "variable_data", {**values, **HEAD})
    message: Any = METERS.decode_response(frame_of("05 13 00 00 C0 3F")).message
    own = message.records[0]
    own.dif, own.data = type(own.dif)(dif), number
    with pytest.raises(codec_error(), match=reason):
        METERS.encode_response(message, **HEAD)


def test_outputs_without_such_choices_leave_them_out_by_name() -> None:
    texts = OUTPUTS["queries"].files([LAYOUT])
    (sql,) = (text for path, text in texts.items() if path.endswith(".sql") and isinstance(text, str))
    assert "data_record: dife " in sql
