"""Texts whose number of bytes another field has: codecs read them, and refuse them at the same byte."""

from __future__ import annotations

from typing import Any

import construct
import pytest
from hypothesis import given
from hypothesis import strategies as st

from captures.bulk import Sent, decoded, verdicts
from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.reference import CodecError, codec
from fieldspec.command import pipeline
from fieldspec.tools.captures.decoding import Choices
from fieldspec.tools.evidence.redaction import Redaction
from fieldspec.tools.evidence.secrets import Secrets
from layouts import TEST_SPECS, newest
from python_package import codec_error, link_of, module_of

LAYOUT = newest(TEST_SPECS, "weigher")
CODEC = codec(LAYOUT)
MODULE = module_of(LAYOUT)
BUS = link_of(MODULE, "bus")
HEADER = 2
"""The bytes before the data: station and function."""
REQUEST = construct.Struct("label" / construct.PascalString(construct.Int8ub, "ascii"), "key" / construct.Int16ub)
"""The request as another library has it."""


def frame_of(data: str, direction: str = "request") -> bytes:
    """A frame of the bus with the right checksum."""
    return CODEC.links["bus"].with_checksum(direction, bytes.fromhex(f"01 4E {data} 00 00"))


REQUESTS = {
    "00 0102": ["", 0x102],
    "02 4142 0102": ["AB", 0x102],
    "0C 4142434445464748494A4B4C 0102": ["ABCDEFGHIJKL", 0x102],
    "0D 4142434445464748494A4B4C4D 0102": ("wrong_measure", 0),
    "FF 4142 0102": ("wrong_measure", 0),
    "05 4142 0102": ("incomplete", 5),
    "03 4142 0102": ("incomplete", 5),
    "01 4142 0102": ("wrong_length", 4),
    "03 410042 0102": ("unknown_value", 1),
    "02 41C4 0102": ("unknown_value", 1),
    "02 4142 01": ("incomplete", 4),
    "": ("incomplete", 0),
}
"""Data of a request: its text and its number, or why and at which byte it is refused."""

RESPONSES = {
    "0200 00 01": ["", ""],
    "0300 03 41 01 E282AC": ["A", "\u20ac"],
    "0E00 01 4142434445464748494A4B4C 01 7A": ["ABCDEFGHIJKL", "z"],
    "0100 00 01": ("wrong_measure", 0),
    "0F00 00 01": ("wrong_measure", 0),
    "0003 03 41 01 E282AC": ("wrong_measure", 0),
    "0300 02 41 01 E282": ("unknown_value", 5),
    "0300 02 41 01 E282AC": ("wrong_length", 7),
    "0300 02 41 05 6162": ("unknown_value", 4),
    "0300 05 41 01 E282AC": ("incomplete", 8),
    "0300 05 00 05 61": ("unknown_value", 3),
}
"""Data of a response: its texts, or why and at which byte it is refused."""


def refusal(direction: str, frame: bytes) -> tuple[str, int | None]:
    """Why both codecs refuse a frame, and where."""
    with pytest.raises(CodecError) as expected:
        CODEC.links["bus"].decode(frame, direction)
    with pytest.raises(codec_error()) as refused:
        (BUS.decode_request if direction == "request" else BUS.decode_response)(frame)
    place = expected.value.reason, expected.value.offset
    assert (refused.value.reason, refused.value.offset) == place
    return place


def check_judgements(direction: str, frame: bytes, reason: str) -> None:
    """An explanation and the decoder of captures judge a frame alike."""
    reasons = explained(LAYOUT, "bus", direction, frame).reasons
    (verdict,) = verdicts(decoded(LAYOUT, [Sent(0, direction, frame)], Choices("bus", "")))
    assert (not reasons, verdict == "ok") == (not reason, not reason)
    assert reason in (*reasons, "")
    assert verdict in (*reasons, "ok")


@pytest.mark.parametrize("data", REQUESTS)
def test_a_text_with_a_field_behind_it_is_read_and_refused_alike(data: str) -> None:
    frame, wanted = frame_of(data), REQUESTS[data]
    if isinstance(wanted, tuple):
        assert refusal("request", frame) == (wanted[0], HEADER + wanted[1])
        check_judgements("request", frame, wanted[0])
        return
    values = CODEC.links["bus"].decode(frame, "request").values
    read = BUS.decode_request(frame).message
    assert [values["label"], values["key"]] == [read.label, read.key] == wanted
    assert values["length"] == len(read.label)
    assert bytes(BUS.encode_request(1, read)) == frame
    check_judgements("request", frame, "")


@pytest.mark.parametrize("data", RESPONSES)
def test_several_texts_are_read_and_refused_alike(data: str) -> None:
    frame, wanted = frame_of(data, "response"), RESPONSES[data]
    if isinstance(wanted, tuple):
        assert refusal("response", frame) == (wanted[0], HEADER + wanted[1])
        check_judgements("response", frame, wanted[0])
        return
    values = CODEC.links["bus"].decode(frame, "response").values
    read = BUS.decode_response(frame).message
    assert [values["label"], values["place"]] == [read.label, read.place] == wanted
    assert (values["length"], values["size"]) == (len(read.label) + 2, len(read.place.encode()))
    assert bytes(BUS.encode_response(1, read)) == frame
    check_judgements("response", frame, "")


@given(label=st.text(st.characters(min_codepoint=1, max_codepoint=0x7F), max_size=12), key=st.integers(0, 0xFFFF))
def test_construct_reads_the_texts_that_are_sent(label: str, key: int) -> None:
    message: Any = MODULE.RenameRequest(label=label, key=key)
    frame = bytes(BUS.encode_request(1, message))
    assert frame == CODEC.links["bus"].encode("request", "rename", {"station": 1, "label": label, "key": key})
    parsed = REQUEST.parse(frame[HEADER:-2])
    assert (parsed.label, parsed.key) == (label, key)
    assert REQUEST.build({"label": label, "key": key}) == frame[HEADER:-2]


@pytest.mark.parametrize("label", ["ABCDEFGHIJKLM", "A\0", "\u20ac"])
def test_a_text_that_would_be_read_as_another_is_not_sent(label: str) -> None:
    with pytest.raises(CodecError) as expected:
        CODEC.links["bus"].encode("request", "rename", {"station": 1, "label": label, "key": 1})
    with pytest.raises(codec_error()) as refused:
        BUS.encode_request(1, MODULE.RenameRequest(label=label, key=1))
    assert refused.value.reason == expected.value.reason


@pytest.mark.parametrize("size", [1, 3, 100])
def test_a_framer_counts_the_bytes_of_a_text(size: int) -> None:
    frames = [frame_of(data) for data, wanted in REQUESTS.items() if isinstance(wanted, list)]
    stream = b"\xee".join(frames)
    framer = BUS.request_framer()
    taken = [frame for at in range(0, len(stream), size) for frame in framer.feed(stream[at : at + size])]
    assert (taken, framer.dropped) == (frames, len(frames) - 1)


LEAK = """
device: {id: leak, name: L, vendor: V, manual: {title: T, file: f, sha256: "%s", lines: 9}}
links:
  - name: line
    source: 1 L1
    byte_order: big
    word_order: big
    request: &parts [{name: command, role: code, type: u8}, {name: body, role: body}]
    response: *parts
messages:
  - name: read
    code: 1
    source: 1 L2
    request: []
    response:
      - {name: size, type: u8, measures: {bytes: label}}
      - {name: label, type: text, length: 12, varies: true}
      - {name: counts, type: u8, count: 10}
      - {name: serial, type: u32, roles: serial_number}
""" % ("0" * 64)


@pytest.mark.parametrize("label", ["", "AB", "ABCDEFGHIJKL"])
def test_redaction_takes_fields_behind_a_text_from_where_they_are_sent(label: str) -> None:
    (layout,) = pipeline.layouts(pipeline.load({"leak/device.yaml": LEAK.encode()}).devices["leak"])
    link = codec(layout).links["line"]
    values = {"label": label, "counts": list(range(10)), "serial": 0x5EC2E7A1}
    frame = link.encode("response", "read", values)
    clean = Redaction(layout, Secrets()).frame("line", "response", frame, link.decode(frame, "response"), {})
    expected = {"size": len(label), "label": "X" * len(label), "counts": list(range(10)), "serial": 0}
    assert link.decode(clean, "response").values == expected
