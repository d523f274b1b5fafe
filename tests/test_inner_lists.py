"""Messages with fields after a list that another field counts: codecs read them, and refuse them at the same byte."""

from __future__ import annotations

import pytest

from captures.bulk import Sent, decoded, verdicts
from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.reference import CodecError, codec
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


def frame_of(function: str, data: str, direction: str = "request") -> bytes:
    """A frame of the bus with the right checksum."""
    return CODEC.links["bus"].with_checksum(direction, bytes.fromhex(f"01 {function} {data} 00 00"))


BODIES = {
    "02 02 000A 0100 01 0000010A": [10, 256],
    "02 00 01 0000010A": [],
    "02 04 0001 0002 0003 0004 63 00000000": [1, 2, 3, 4],
    "02 05 0001 0002 0003 0004 0005 63 00000000": ("wrong_length", 10),
    "02 01 000A 0100 01 0000010A": ("wrong_measure", 1),
    "02 03 000A 0100 01 0000010A": ("wrong_measure", 1),
    "02 02 000A 01 01 0000010A": ("wrong_length", 5),
    "02 02 000A 0100 05 0000010A": ("unknown_value", 6),
    "02 00 05 0000010A": ("unknown_value", 2),
    "02 02 000A 01": ("incomplete", 5),
    "02 00 01 000001": ("incomplete", 6),
    "02": ("incomplete", 1),
    "": ("incomplete", 0),
}
"""Data of a request with samples: the samples, or why and at which byte it is refused."""


SEVERAL = {
    "0C 2C31323334 2C30303031 01 0100 0001 FFFF 04 03 AABBCC 8000": [[1234, 1], [1, -1], [0xAA, 0xBB, 0xCC], -32768],
    "07 2C31323334 01 0100 0001 FFFF 04 03 AABBCC 8000": [[1234], [1, -1], [0xAA, 0xBB, 0xCC], -32768],
    "02 01 0000 FFFF 02 00 7FFF": [[], [-1], [], 32767],
    "06 01 0000 FFFF 02 00 7FFF": ("wrong_measure", 0),
    "16 01 0000 FFFF 02 00 7FFF": ("wrong_measure", 0),
    "01 01 0000 FFFF 02 00 7FFF": ("wrong_measure", 0),
    "11 01 0000 FFFF 02 00 7FFF": ("incomplete", 10),
    "07 2C31323334 01 FFFF 00 00 7FFF": ("wrong_measure", 7),
    "07 2C31323334 01 0500 FFFF 02 00 7FFF": ("wrong_measure", 7),
    "07 2C31323334 01 0200 FFFF 02 00 7FFF": ("incomplete", 15),
    "07 2C31323334 05 0000 FFFF 02 00 7FFF": ("unknown_value", 6),
    "07 2C31323334 01 0000 FFFF 04 00 7FFF": ("wrong_measure", 11),
    "07 2C31323334 01 0000 FFFF 02 01 7FFF": ("wrong_measure", 12),
    "02 01 0000 FFFF 02 07 01020304050607 7FFF": ("wrong_length", 14),
    "02 01 0000 FFFF 02 00 7F": ("incomplete", 9),
    "02 01": ("incomplete", 2),
}
"""Data of a response with three lists: the lists and the last field, or why and at which byte it is refused."""


@pytest.mark.parametrize("data", SEVERAL)
def test_several_lists_are_read_and_refused_alike(data: str) -> None:
    frame, wanted = frame_of("42", data, "response"), SEVERAL[data]
    reasons = explained(LAYOUT, "bus", "response", frame).reasons
    (verdict,) = verdicts(decoded(LAYOUT, [Sent(0, "response", frame)], Choices("bus", "")))
    assert verdict == (reasons[0] if reasons else "ok")
    if isinstance(wanted, list):
        values = CODEC.links["bus"].decode(frame, "response").values
        read = BUS.decode_response(frame)
        assert [
            [limit["weight"] for limit in values["limits"]],
            *map(values.get, ("samples", "marks", "drift")),
        ] == wanted
        message = read.message
        assert [[limit.weight for limit in message.limits], message.samples, message.marks, message.drift] == wanted
        assert bytes(BUS.encode_response(1, message)) == frame
        assert CODEC.links["bus"].encode("response", "read_lists", {"station": 1, **values}) == frame
        return
    reason, at = wanted
    with pytest.raises(CodecError) as expected:
        CODEC.links["bus"].decode(frame, "response")
    with pytest.raises(codec_error()) as refused:
        BUS.decode_response(frame)
    place = reason, HEADER + at
    assert (expected.value.reason, expected.value.offset) == place
    assert (refused.value.reason, refused.value.offset) == place
    assert reason in reasons


@pytest.mark.parametrize("data", BODIES)
def test_fields_behind_a_list_are_read_and_refused_alike(data: str) -> None:
    frame, wanted = frame_of("41", data), BODIES[data]
    reasons = explained(LAYOUT, "bus", "request", frame).reasons
    (verdict,) = verdicts(decoded(LAYOUT, [Sent(0, "request", frame)], Choices("bus", "")))
    if isinstance(wanted, list):
        values = CODEC.links["bus"].decode(frame, "request").values
        read = BUS.decode_request(frame)
        assert values["samples"] == read.message.samples == wanted
        assert (values["total"], read.message.stability) == (read.message.total, values["stability"])
        assert bytes(BUS.encode_request(1, read.message)) == frame
        assert (list(reasons), verdict) == ([], "ok")
        return
    reason, at = wanted
    with pytest.raises(CodecError) as expected:
        CODEC.links["bus"].decode(frame, "request")
    with pytest.raises(codec_error()) as refused:
        BUS.decode_request(frame)
    place = reason, HEADER + at
    assert (expected.value.reason, expected.value.offset) == place
    assert (refused.value.reason, refused.value.offset) == place
    assert (reason in reasons, verdict) == (True, reasons[0])


@pytest.mark.parametrize("data", [data for data, wanted in BODIES.items() if isinstance(wanted, list)])
def test_a_struct_that_reads_the_count_finds_the_same_values(data: str) -> None:
    values = CODEC.links["bus"].decode(frame_of("41", data), "request").values
    struct = CODEC.records["weigh_samples_request"]
    parsed = {field.name: struct.parse(bytes.fromhex(data))[field.name] for field in struct.subcons}
    assert parsed == {name: values[name] for name in parsed}
    assert struct.build(parsed) == bytes.fromhex(data)


def test_an_explanation_has_the_fields_in_the_order_of_the_wire() -> None:
    rows = explained(LAYOUT, "bus", "request", frame_of("41", "02 02 000A 0100 01 0000010A")).rows
    places = [(row.path, row.offset) for row in rows if row.kind == "field"]
    assert places == [
        ("channel", 2),
        ("sample_count", 3),
        ("samples[0]", 4),
        ("samples[1]", 6),
        ("stability", 8),
        ("total", 9),
    ]


@pytest.mark.parametrize("size", [1, 2, 3, 100])
def test_a_framer_counts_the_bytes_behind_a_list(size: int) -> None:
    frames = [frame_of("41", data) for data, wanted in BODIES.items() if isinstance(wanted, list)]
    stream = b"\xee".join(frames)
    framer = BUS.request_framer()
    taken = [frame for at in range(0, len(stream), size) for frame in framer.feed(stream[at : at + size])]
    assert (taken, framer.dropped) == (frames, len(frames) - 1)


def test_redaction_takes_the_bytes_of_each_field_from_where_it_is_sent() -> None:
    frame = frame_of("41", "02 02 000A 0100 01 0000010A")
    read = CODEC.links["bus"].decode(frame, "request")
    assert Redaction(LAYOUT, Secrets()).frame("bus", "request", frame, read, {}) == frame
