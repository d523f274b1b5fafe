"""Texts of six bits a character, packed into bytes, as others have published them and as tshark reads them."""

from __future__ import annotations

from typing import Any

import pytest

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.reference import CodecError, codec
from fieldspec.language.model.text_form import decoded_text, text_bytes
from layouts import TEST_SPECS, newest
from python_package import codec_error, link_of, module_of
from wireshark_output.dissection import Packet, pcap, tshark

HERALD = newest(TEST_SPECS, "herald")
REFERENCE = codec(HERALD).links
MODULE = module_of(HERALD)


def value_of(message: str, name: str) -> Any:
    return next(own.value for own in HERALD.device.messages[message].response.fields if own.name == name)


PUBLISHED = {
    # J. Sun, The 1090 Megahertz Riddle: the callsign of 8D4840D6202CC371C32CE0576098.
    "2C C3 71 C3 2C E0": ("identify", "call_sign", "KLM1023"),
    # The tests of pyModeS: 8D406B902015A678D4D220AA4BDA.
    "15 A6 78 D4 D2 20": ("identify", "call_sign", "EZY85MH"),
    # `pack_ascii` of the package hart-protocol 2023.6.0.
    "51 4B 71 C3 1B C1": ("read_tag", "tag", "TT-101/A"),
    # `pack_ascii` of the package hartip-py 0.5.0.
    "48 50 43 50 F4 A0 6F 27 60 50 53 50": ("read_tag", "descriptor", "REACTOR [2] TEMP"),
}


@pytest.mark.parametrize("data", PUBLISHED)
def test_published_bytes_are_read_and_written(data: str) -> None:
    message, name, text = PUBLISHED[data]
    value, raw = value_of(message, name), bytes.fromhex(data)
    assert decoded_text(value, "big", raw) == text
    assert text_bytes(value, "big", text) == raw


# `pack_ascii` of hartip-py has made the texts; the bytes around them are those of the HART commands 12, 13, 17 and 18.
MESSAGE = "0C 13 09 09 20 54 14 48 02 66 02 AE 80 43 C5 B2 0C B0 CB 78 20 82 08 20"
TAG = "51 4B 71 C3 1B C1 48 50 43 50 F4 A0 6F 27 60 50 53 50 1D 0B 7E"
TEXT = "CALIBRATED BY J. DOE, 2027"
NAMES = {"tag": "TT-101/A", "descriptor": "REACTOR [2] TEMP"}
ANSWERS = {
    "read_message": (12, MESSAGE, {"text": TEXT}),
    "read_tag": (13, TAG, {**NAMES, "date": 0x1D0B7E}),
    "write_message": (17, MESSAGE, {"text": TEXT}),
    "write_tag": (18, TAG, {**NAMES, "date": 0x1D0B7E}),
}


def answer(message: str) -> bytes:
    command, content, _ = ANSWERS[message]
    body = bytes(2) + bytes.fromhex(content)
    frame = bytes.fromhex("86 A6 06 BC 61 4E") + bytes([command, len(body)]) + body
    check = 0
    for byte in frame:
        check ^= byte
    return frame + bytes([check])


@pytest.mark.parametrize("message", ANSWERS)
def test_all_codecs_read_an_answer_and_write_it_again(message: str) -> None:
    data, wanted = answer(message), ANSWERS[message][2]
    decoded = REFERENCE["long"].decode(data, "response").values
    assert {name: decoded[name] for name in wanted} == wanted
    own = link_of(MODULE, "long").decode_response(data)
    assert {name: getattr(own.message, name) for name in wanted} == wanted
    assert link_of(MODULE, "long").encode_response(0xA606BC614E, own.message) == data
    rows = {row.path: row for row in explained(HERALD, "long", "response", data).rows}
    assert {name: rows[name].number for name in wanted} == wanted


def test_tshark_reads_the_same_texts_in_the_answers_of_hart_ip() -> None:
    frames = [answer(message) for message in ANSWERS]
    heads = [
        bytes([1, 1, 3, 0, 0, number]) + (8 + len(frame)).to_bytes(2, "big") for number, frame in enumerate(frames)
    ]
    packets = [Packet(40000, 5094, "response", head + frame) for head, frame in zip(heads, frames, strict=True)]
    names = ("message", "tag", "descriptor")
    fields = [option for name in names for option in ("-e", f"hart_ip.pt.rsp.{name}")]
    lines = tshark([], pcap(packets), "-T", "fields", *fields).stdout.split("\n")[:-1]
    wanted = [[ANSWERS[message][2].get(name, "") for name in ("text", "tag", "descriptor")] for message in ANSWERS]
    assert [[text.rstrip() for text in line.split("\t")] for line in lines] == wanted


UNSENDABLE = {
    "lower case": ("tt-101", "unknown_value"),
    "a letter that ASCII lacks": ("T\xc4", "unknown_value"),
    "a line feed": ("T\n1", "unknown_value"),
    "a zero": ("T\0", "unknown_value"),
    "a space at the end, which fills it up": ("TT-101 ", "unknown_value"),
    "one character too many": ("TT-101/AB", "wrong_length"),
}


@pytest.mark.parametrize("case", UNSENDABLE)
def test_a_text_that_six_bits_do_not_have_is_not_sent(case: str) -> None:
    text, reason = UNSENDABLE[case]
    values = {"tag": text, "descriptor": "REACTOR", "date": 0}
    with pytest.raises(CodecError) as expected:
        REFERENCE["long"].encode("request", "write_tag", {"address": 0xA606BC614E, **values})
    with pytest.raises(codec_error()) as refused:
        link_of(MODULE, "long").encode_request(0xA606BC614E, MODULE.WriteTagRequest(**values))
    assert (expected.value.reason, refused.value.reason) == (reason, reason)


IDENTITY = {
    "call_sign": "KLM1023",
    "vessel": "EVER GIVEN",
    "right": "PT100",
    "names": ["A", "", "_?^Z"],
}


def test_ends_padding_before_a_text_byte_order_and_lists_are_those_of_other_texts() -> None:
    link, message = link_of(MODULE, "wide"), MODULE.IdentifyResponse(**IDENTITY)
    frame = link.encode_response(1, message)
    body = frame[9:]
    # `pack_ascii` of hartip-py makes `EVER GIVEN@` with spaces, and `   PT100`, whose words are exchanged here.
    assert body[6:21] == bytes.fromhex("15 61 52 80 72 56 14 E0 20 82 08 20 82 08 20")
    assert body[21:27] == bytes.fromhex("08 82 53 10 30 1C")
    assert body[27:] == bytes.fromhex("06 08 20 82 08 20 7F F7 9A")
    assert link.decode_response(frame, MODULE.IdentifyRequest()).message == message
    values = REFERENCE["wide"].decode(frame, "response").values
    assert {name: values[name] for name in IDENTITY} == IDENTITY
