"""Unit addresses, codes, lengths and other parts of frames that are some bits of a byte or word."""

from __future__ import annotations

import random
from typing import Any

import meterbus
import pytest

from fieldspec.codec.reference import CodecError, codec
from layouts import TEST_SPECS, newest
from python_package import codec_error, link_of, module_of

LAYOUTS = {name: newest(TEST_SPECS, name) for name in ("spindle", "submeter", "surveyor")}
SPINDLE, SUBMETER, SURVEYOR = (module_of(layout) for layout in LAYOUTS.values())
SERIAL, BUS, STREAM = link_of(SPINDLE, "serial"), link_of(SUBMETER, "bus"), link_of(SURVEYOR, "stream")

HEAD = {"mirror": 0, "broadcast": 0, "node": 3, "number": 700}
WRONG = {"mirror": 2, "broadcast": -1, "node": 31, "number": 2048}
"""The parts of a telegram, and numbers that they cannot have."""


@pytest.mark.parametrize("name", WRONG)
def test_a_number_that_its_bits_do_not_hold_is_refused_and_changes_no_other_part(name: str) -> None:
    head: dict[str, Any] = {**HEAD, name: WRONG[name]}
    with pytest.raises(CodecError) as expected:
        codec(LAYOUTS["spindle"]).links["serial"].encode("request", "read_word", {**head, "index": 0})
    assert expected.value.reason == "out_of_range"
    with pytest.raises(codec_error()) as caught:
        SERIAL.encode_request(head.pop("node"), SPINDLE.ReadWordRequest(0), **head)
    assert caught.value.reason == "out_of_range"


@pytest.mark.parametrize(("position", "bits", "refusal"), [(2, 0x80, "wrong_const"), (3, 0x08, None)])
def test_a_constant_bit_is_compared_and_a_reserved_one_is_not(position: int, bits: int, refusal: str | None) -> None:
    frame = bytearray.fromhex("02 06 03 12 BC 00 00 A9")
    frame[position] |= bits
    frame[-1] ^= bits
    if refusal is None:
        request = SERIAL.decode_request(bytes(frame))
        assert (request.unit_address, request.number, request.message.CODE) == (3, 700, 1)
        return
    with pytest.raises(codec_error()) as caught:
        SERIAL.decode_request(bytes(frame))
    assert caught.value.reason == refusal


@pytest.mark.parametrize("count", [0, 1])
@pytest.mark.parametrize("valid", [0, 1])
def test_meterbus_finds_the_same_bits_in_the_control_field(count: int, valid: int) -> None:
    bits = {"frame_count_bit": count, "frame_count_valid": valid}
    telegram = meterbus.load(BUS.encode_request(45, SUBMETER.RequestDataRequest(), **bits))
    control = meterbus.CONTROL_MASK_DIR_M2S | meterbus.CONTROL_MASK_REQ_UD2
    control = control & ~(meterbus.CONTROL_MASK_FCB | meterbus.CONTROL_MASK_FCV)
    control |= count * meterbus.CONTROL_MASK_FCB | valid * meterbus.CONTROL_MASK_FCV
    assert telegram.header.cField.parts == [control]
    assert telegram.header.aField.parts == [45]


def test_a_framer_finds_frames_by_the_bits_of_their_length() -> None:
    chance = random.Random(5)
    messages = [SURVEYOR.AntennaTextResponse(list(chance.randbytes(size)), 1) for size in (31, 0, 7)]
    frames = [STREAM.encode_response(message, station=chance.randrange(4096)) for message in messages]
    frames[1] = with_unused_bits(frames[1])
    garbage = [b"\xd3", b"\xd3\x00\x05abc", b"", b"\x00\xd3\xff"]
    stream = b"".join(piece for pair in zip(garbage, [*frames, b""], strict=True) for piece in pair)
    for step in (1, 5, len(stream)):
        framer = STREAM.response_framer()
        split = [frame for at in range(0, len(stream), step) for frame in framer.feed(stream[at : at + step])]
        assert split + framer.idle() == frames


def with_unused_bits(frame: bytes) -> bytes:
    """A frame of RTCM whose reserved bits are set, with the right checksum."""
    link = codec(LAYOUTS["surveyor"]).links["stream"]
    return link.joined_parts("response", link.with_checksum("response", bytes((frame[0], frame[1] | 0xFC, *frame[2:]))))


def test_bits_are_written_among_those_of_other_parts() -> None:
    header = {part.name: part for part in LAYOUTS["spindle"].links["serial"].request.header}
    word = header["number"].bytes_with(bytes.fromhex("FF FF"), 0)
    assert (word.hex(), header["task"].read(word), header["number"].read(word)) == ("f800", 15, 0)
