"""Lists and texts that some bits of a field count: frames of four standards, as others have published and read them."""

from __future__ import annotations

from typing import Any

import isotp
import pytest

from captures.bulk import Sent, decoded, verdicts
from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.reference import CodecError, codec
from fieldspec.tools.captures.decoding import Choices
from layouts import TEST_SPECS, newest
from python_package import codec_error, link_of, module_of

TRACKER = newest(TEST_SPECS, "tracker")
REFERENCE = codec(TRACKER).links
MODULE = module_of(TRACKER)

PUBLISHED = {
    # anthonykirby, lora-packet, parse_test: no option.
    "40 F1 7D BE 49 00 02 00 01 95 43 78 76 2B 11 FF 0D": ("radio", "response", []),
    # lora-packet, fopts_test, and its issue 18: three options beside the bits that adapt and acknowledge.
    "40 84 41 25 05 A3 01 00 09 11 03 08 B3 37 50 F5 04 D4 B8 6A": ("radio", "response", [0x09, 0x11, 0x03]),
    # brocaar, lorawan, the example of encrypted options.
    "60 04 03 02 01 03 00 00 22 AC 0A 01 F0 B4 68 DD AA 5E D1 3A": ("radio", "request", [0x22, 0xAC, 0x0A]),
    # RFC 7252, figure 16: a request with one option of eleven bytes.
    "40 01 7D 34 BB 74 65 6D 70 65 72 61 74 75 72 65": ("port", "request", [*b"temperature"]),
}

HEADS = {"port": {"message_id": 0x7D34}}
"""The parts of frames that a program states."""


def elements_of(values: Any) -> list[int]:
    """The list that bits count, in the record that has it."""
    return values["frame"]["options"] if "frame" in values else values["options"][0]["value"]


@pytest.mark.parametrize("data", PUBLISHED)
def test_published_frames_have_the_elements_that_their_bits_count(data: str) -> None:
    link, direction, elements = PUBLISHED[data]
    frame = bytes.fromhex(data)
    read = REFERENCE[link].decode(frame, direction)
    assert elements_of(read.values) == elements
    assert REFERENCE[link].encode(direction, read.message.name, {**read.values, **HEADS.get(link, {})}) == frame


@pytest.mark.parametrize("data", PUBLISHED)
def test_python_reads_and_writes_the_same_bytes(data: str) -> None:
    link, direction, _ = PUBLISHED[data]
    own, frame = link_of(MODULE, link), bytes.fromhex(data)
    read = getattr(own, f"decode_{direction}")(frame)
    assert getattr(own, f"encode_{direction}")(read.message, **HEADS.get(link, {})) == frame


@pytest.mark.parametrize(
    ("data", "text"),
    # RFC 8949, appendix A
    [
        ("60", ""),
        ("61 61", "a"),
        ("64 49 45 54 46", "IETF"),
        ("62 22 5C", '"\\'),
        ("62 C3 BC", "\u00fc"),
        ("63 E6 B0 B4", "\u6c34"),
        ("64 F0 90 85 91", "\U00010151"),
    ],
)
def test_published_texts_have_the_bytes_that_their_bits_count(data: str, text: str) -> None:
    frame = bytes.fromhex(data)
    values = {"head": frame[0], "text": text}
    assert REFERENCE["store"].decode(frame, "request", "label").values == values
    assert REFERENCE["store"].encode("request", "label", values) == frame
    message: Any = link_of(MODULE, "store").decode_request(frame, "label").message
    assert message.text == text
    assert link_of(MODULE, "store").encode_request(message) == frame
    assert explained(TRACKER, "store", "request", frame, message="label").reasons == ()
    assert verdicts(decoded(TRACKER, [Sent(0, "request", frame)], Choices("store", "label"))) == ["ok"]


def test_texts_in_a_list_have_the_bytes_that_their_bits_count() -> None:
    frame = bytes.fromhex("7F 65 73 74 72 65 61 64 6D 69 6E 67 FF")
    values = {"items": [{"head": 0x65, "text": "strea"}, {"head": 0x64, "text": "ming"}]}
    read = REFERENCE["store"].decode(frame, "request", "streamed_labels")
    assert read.values["items"] == values["items"]
    assert REFERENCE["store"].encode("request", "streamed_labels", values) == frame
    message = link_of(MODULE, "store").decode_request(frame, "streamed_labels").message
    assert link_of(MODULE, "store").encode_request(message) == frame


@pytest.mark.parametrize(
    ("data", "reason", "place"),
    [
        ("78", "wrong_measure", 0),
        ("62 61", "incomplete", 2),
        ("61 61 61", "wrong_length", 2),
        ("63 61 00 61", "unknown_value", 1),
        ("61 C3", "unknown_value", 1),
    ],
)
def test_wrong_bits_and_texts_are_refused_alike(data: str, reason: str, place: int) -> None:
    frame = bytes.fromhex(data)
    with pytest.raises(CodecError) as expected:
        REFERENCE["store"].decode(frame, "request", "label")
    with pytest.raises(codec_error()) as refused:
        link_of(MODULE, "store").decode_request(frame, "label")
    for error in (expected.value, refused.value):
        assert (error.reason, error.offset) == (reason, place)
    assert reason in explained(TRACKER, "store", "request", frame, message="label").reasons
    assert verdicts(decoded(TRACKER, [Sent(0, "request", frame)], Choices("store", "label"))) == [reason]


def test_texts_of_other_lengths_than_the_bits_say_are_not_written() -> None:
    message: Any = link_of(MODULE, "store").decode_request(b"\x61a", "label").message
    message.text = "ab"
    with pytest.raises(codec_error(), match="wrong_measure"):
        link_of(MODULE, "store").encode_request(message)
    with pytest.raises(CodecError, match="wrong_measure"):
        REFERENCE["store"].encode("request", "label", {"head": 0x61, "text": "ab"})


@pytest.mark.parametrize("length", range(1, 8))
def test_single_frames_are_those_of_an_independent_library(length: int) -> None:
    address = isotp.Address(isotp.AddressingMode.Normal_11bits, txid=0x7E0, rxid=0x7E8)
    frames: list[isotp.CanMessage] = []
    layer = isotp.TransportLayerLogic(lambda timeout: None, frames.append, address)
    data = list(range(16, 16 + length))
    layer.send(bytes(data))
    layer.process()
    [frame] = frames
    values = {"control": length, "data": data}
    assert REFERENCE["bus"].encode("request", "single_frame", values)[8:] == bytes(frame.data)


@pytest.mark.parametrize("length", range(1, 8))
@pytest.mark.parametrize("filler", [0xAA, 0xCC])
def test_padded_frames_are_those_of_an_independent_library(length: int, filler: int) -> None:
    address = isotp.Address(isotp.AddressingMode.Normal_11bits, txid=0x7E2, rxid=0x7EA)
    frames: list[isotp.CanMessage] = []
    options = {"tx_padding": filler, "tx_data_min_length": 8}
    layer = isotp.TransportLayerLogic(lambda timeout: None, frames.append, address, params=options)
    data = list(range(16, 16 + length))
    layer.send(bytes(data))
    layer.process()
    values = {"control": length, "data": data, "padding": [filler] * (7 - length)}
    frame = REFERENCE["bus"].encode("request", "padded_frame", values)
    assert frame[8:] == bytes(frames[0].data)
    assert REFERENCE["bus"].decode(frame, "request").values == values


@pytest.mark.parametrize("control", [0, 1, 3, 0x13])
def test_bits_that_do_not_count_the_elements_are_refused(control: int) -> None:
    with pytest.raises(CodecError, match="wrong_measure"):
        REFERENCE["bus"].encode("request", "single_frame", {"control": control, "data": [0x10, 3]})


def test_the_other_bits_of_a_field_that_counts_are_those_of_the_program() -> None:
    frame = REFERENCE["bus"].encode("request", "single_frame", {"control": 0xF2, "data": [0x10, 3]})
    assert frame[8:] == bytes([0xF2, 0x10, 3])


@pytest.mark.parametrize(
    ("link", "data", "reason"),
    [
        ("bus", "00 00 07 E0 03 00 00 00 03 10 03", "wrong_measure at byte 2"),
        ("bus", "00 00 07 E1 05 00 00 00 60 00 00 05 00", "wrong_measure at byte 2"),  # 6 is 3 bytes and 3 more
        ("bus", "00 00 07 E1 07 00 00 00 50 00 00 05 00 01 02", "wrong_length at byte 8"),
        ("port", "40 01 7D 34 B2 74", "incomplete at byte 6"),
        ("port", "40 01 7D 34 BD 74", "wrong_measure at byte 4"),  # 13 means that the length follows
    ],
)
def test_bytes_that_the_bits_do_not_count_are_refused(link: str, data: str, reason: str) -> None:
    with pytest.raises(CodecError, match=reason):
        REFERENCE[link].decode(bytes.fromhex(data), "request")
