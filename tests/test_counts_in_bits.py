"""Lists that some bits of a field count: frames of three standards, as others have published and read them."""

from __future__ import annotations

from typing import Any

import isotp
import pytest

from fieldspec.codec.reference import CodecError, codec
from layouts import TEST_SPECS, newest
from python_package import link_of, module_of

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
    decoded = REFERENCE[link].decode(frame, direction)
    assert elements_of(decoded.values) == elements
    assert REFERENCE[link].encode(direction, decoded.message.name, {**decoded.values, **HEADS.get(link, {})}) == frame


@pytest.mark.parametrize("data", PUBLISHED)
def test_python_reads_and_writes_the_same_bytes(data: str) -> None:
    link, direction, _ = PUBLISHED[data]
    own, frame = link_of(MODULE, link), bytes.fromhex(data)
    decoded = getattr(own, f"decode_{direction}")(frame)
    assert getattr(own, f"encode_{direction}")(decoded.message, **HEADS.get(link, {})) == frame


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
