"""Preambles: bytes before a frame, of which a sender sends some and a receiver takes more or fewer."""

from __future__ import annotations

from pathlib import Path

import pytest

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference import CodecError, codec
from fieldspec.targets import OUTPUTS
from layouts import TEST_SPECS, newest
from python_package import codec_error, link_of, module_of
from random_devices.c_judge import C
from random_devices.javascript_judge import JavaScript
from random_devices.python_judge import Python
from random_devices.queries import Query

PRESSURE, TARIFF = newest(TEST_SPECS, "pressure"), newest(TEST_SPECS, "tariff")
LOOP = link_of(module_of(PRESSURE), "loop")

# What a program for pressure transmitters logs, and a bus of electricity meters: frames that others have published.
VALUE = bytes.fromhex("86 A6 06 BC 61 4E 01 07 00 00 06 40 B0 00 00 45")
METER = bytes.fromhex("68 18 20 12 22 20 65 68 91 0A 33 32 34 35 33 33 33 33 C7 56 13 16")


@pytest.mark.parametrize("count", [5, 6, 19, 20])
def test_a_receiver_takes_as_many_bytes_as_are_stated(count: int) -> None:
    frame = b"\xff" * count + VALUE
    assert codec(PRESSURE).links["loop"].decode(frame, "response").values["primary_variable"] == 5.5
    assert LOOP.decode_response(frame).message.primary_variable == 5.5


@pytest.mark.parametrize("count", [0, 4, 21])
def test_a_receiver_refuses_fewer_and_more(count: int) -> None:
    frame = b"\xff" * count + VALUE
    with pytest.raises(CodecError):
        codec(PRESSURE).links["loop"].decode(frame, "response")
    with pytest.raises(codec_error()):
        LOOP.decode_response(frame)


def test_codecs_of_all_languages_refuse_a_preamble_with_another_byte_in_it(tmp_path: Path) -> None:
    frame = b"\xff" * 20 + VALUE
    damaged = [frame[:place] + b"\xfe" + frame[place + 1 :] for place in range(20)]
    asked = [Query("frame", ("loop", "response", ""), each) for each in (frame, *damaged)]
    compiled = C(PRESSURE, tmp_path, ["tcc", "-std=c99", "-w"])
    for judge in (Python(PRESSURE, tmp_path, 0), JavaScript(PRESSURE, tmp_path, 0), compiled):
        assert [bool(answer.reason) for answer in judge.answers(asked)] == [False, *[True] * 20]


@pytest.mark.parametrize(
    ("layout", "link", "received", "sent"),
    [(PRESSURE, "loop", b"\xff" * 7 + VALUE, b"\xff" * 5 + VALUE), (TARIFF, "line", METER, b"\xfe" * 4 + METER)],
    ids=["pressure", "tariff"],
)
def test_a_frame_is_written_again_with_the_number_that_is_sent(
    layout: DeviceLayout, link: str, received: bytes, sent: bytes
) -> None:
    reference = codec(layout).links[link]
    decoded = reference.decode(received, "response")
    assert decoded.message is not None
    assert reference.encode("response", decoded.message.name, {**decoded.head, **decoded.values}) == sent


@pytest.mark.parametrize("count", [0, 1, 4])
def test_a_preamble_may_be_left_out_where_that_is_stated(count: int) -> None:
    frame = b"\xfe" * count + METER
    message = link_of(module_of(TARIFF), "line").decode_response(frame).message
    assert tuple(message.voltages) == (0, 0, 2394)


@pytest.mark.parametrize("pieces", [1, 3, 99])
def test_a_framer_returns_frames_with_their_preambles_and_drops_what_comes_before(pieces: int) -> None:
    frames = [b"\xff" * 5 + VALUE, b"\xff" * 20 + VALUE]
    stream = b"\x01\xff\xff" + b"\x02" + frames[0] + b"\xff" * 3 + frames[1]
    framer = LOOP.response_framer()
    size = -(-len(stream) // pieces)
    result = [frame for at in range(0, len(stream), size) for frame in framer.feed(stream[at : at + size])]
    assert result == frames
    assert framer.dropped == 4 + 3


def test_a_framer_has_no_frame_waiting_for_the_length_of_another_one() -> None:
    framer = LOOP.response_framer()
    assert framer.feed(b"\xff" * 30 + VALUE) == [b"\xff" * 20 + VALUE]
    assert framer.idle() == []
    assert framer.dropped == 10


def test_an_explanation_names_the_preamble_and_what_is_missing_of_it() -> None:
    rows = explained(PRESSURE, "loop", "response", b"\xff" * 7 + VALUE).rows
    assert [(row.path, row.offset, row.length, row.verdict) for row in rows[:2]] == [
        ("preamble", 0, 7, "right"),
        ("delimiter", 7, 1, "right"),
    ]
    short = explained(PRESSURE, "loop", "response", b"\xff" * 3 + VALUE).rows[0]
    assert short.verdict == "wrong: should be FF FF FF FF FF"


@pytest.mark.parametrize("output", ["st", "scl", "iec", "twincat", "plcopen"])
def test_controllers_have_no_functions_for_them_and_say_so(output: str) -> None:
    findings = [(finding.code, finding.message) for finding in OUTPUTS[output].refusals([PRESSURE])]
    assert any(
        code == "plc_frames_supported" and "loop has a preamble of varying length" in text for code, text in findings
    )


def test_a_word_map_has_no_frames_behind_them_and_says_so() -> None:
    findings = [finding.message for finding in OUTPUTS["kv"].refusals([PRESSURE])]
    assert any("loop has a preamble of varying length" in text for text in findings)
