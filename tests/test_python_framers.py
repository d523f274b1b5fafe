"""The generated framers: frames out of bytes that come in pieces, with garbage between them."""

from __future__ import annotations

import random
from typing import Any

import pytest

from fieldspec.codec.layout.checksums import checksum as checksum_of
from layouts import SPECS, TEST_SPECS, newest
from python_package import link_of, module_of

TC100, ESC11, WIDGET = newest(SPECS, "tc100"), newest(SPECS, "esc11"), newest(TEST_SPECS, "widget")
GIZMO = newest(TEST_SPECS, "gizmo")


def frames_of(layout: Any, link: str, direction: str) -> list[bytes]:
    """The valid example frames of a link in a direction, or those of another link in its form."""
    examples = [e for e in layout.device.examples.values() if e.direction == direction and not e.refused]
    own = [example.frame for example in examples if example.link == link]
    return own or [_in_form(layout, example, link) for example in examples]


def _in_form(layout: Any, example: Any, link: str) -> bytes:
    module = module_of(layout)
    decoded = getattr(link_of(module, example.link), f"decode_{example.direction}")(example.frame)
    spoken = link_of(module, link)
    if example.exception_response:
        frame = spoken.encode_exception_response(decoded.unit_address, decoded.code, decoded.exception)
    else:
        frame = getattr(spoken, f"encode_{example.direction}")(decoded.unit_address, decoded.message)
    assert isinstance(frame, bytes)
    return frame


def framer_of(layout: Any, link: str, direction: str) -> Any:
    """A new framer."""
    return getattr(link_of(module_of(layout), link), f"{direction}_framer")()


LINKS = (
    (TC100, "rtu"),
    (TC100, "ascii"),
    (ESC11, "serial"),
    (WIDGET, "rtu"),
    (WIDGET, "ascii"),
    (WIDGET, "packet"),
)
STREAMS = [(layout, link, direction) for layout, link in LINKS for direction in ("request", "response")]
EACH = pytest.mark.parametrize(
    ("layout", "link", "direction"), STREAMS, ids=[f"{a.device.id}-{b}-{c}" for a, b, c in STREAMS]
)


@EACH
def test_frames_behind_each_other_come_out_one_by_one(layout: Any, link: str, direction: str) -> None:
    frames = frames_of(layout, link, direction)
    assert frames
    framer = framer_of(layout, link, direction)
    assert framer.feed(b"".join(frames)) == frames
    assert framer.dropped == 0


@EACH
def test_a_frame_may_be_split_at_any_place(layout: Any, link: str, direction: str) -> None:
    framer = framer_of(layout, link, direction)
    for frame in frames_of(layout, link, direction):
        for cut in range(1, len(frame)):
            assert framer.feed(frame[:cut]) == []
            assert framer.feed(frame[cut:]) == [frame]


@EACH
def test_bytes_may_come_one_at_a_time(layout: Any, link: str, direction: str) -> None:
    framer = framer_of(layout, link, direction)
    frames = frames_of(layout, link, direction)
    stream = b"".join(frames)
    assert [frame for at in range(len(stream)) for frame in framer.feed(stream[at : at + 1])] == frames


@EACH
def test_frames_are_found_behind_garbage(layout: Any, link: str, direction: str) -> None:
    chance = random.Random(f"{layout.device.id} {link} {direction}")
    framer = framer_of(layout, link, direction)
    frames = frames_of(layout, link, direction)
    for _ in range(5):
        for frame in frames:
            received = framer.feed(chance.randbytes(chance.randint(1, 12)))
            received += framer.feed(frame)
            # What looked like the beginning of a longer frame is given up when the line is silent.
            received += framer.idle()
            assert frame in received


@EACH
def test_a_spoiled_frame_is_dropped_and_the_next_one_found(layout: Any, link: str, direction: str) -> None:
    frames = frames_of(layout, link, direction)
    for frame in frames:
        for at in range(len(frame)):
            spoiled = bytearray(frame)
            spoiled[at] ^= 0x55
            framer = framer_of(layout, link, direction)
            received = framer.feed(bytes(spoiled) + frame) + framer.idle()
            assert frame in received
            assert bytes(spoiled) not in received


@EACH
def test_garbage_without_end_takes_no_memory(layout: Any, link: str, direction: str) -> None:
    chance = random.Random(7)
    framer = framer_of(layout, link, direction)
    for _ in range(200):
        framer.feed(chance.randbytes(100))
        assert len(framer._buffer) <= framer.longest
    framer.reset()
    assert len(framer._buffer) == 0


def test_a_reply_that_does_not_say_its_length_ends_with_the_silence() -> None:
    link = module_of(WIDGET).rtu
    frame = link.encode_response(3, module_of(WIDGET).NestResponse([0, 1, 5]))
    framer = link.response_framer()
    assert framer.feed(frame) == []
    assert framer.idle() == [frame]
    assert framer.dropped == 0


def test_an_error_reply_to_any_code_is_a_frame() -> None:
    link, exception = module_of(WIDGET).rtu, module_of(WIDGET).ExceptionRecord(1)
    frames = [link.encode_exception_response(2, code, exception) for code in (0x03, 0x10, 0x2B, 0x7F)]
    assert link.response_framer().feed(b"".join(frames)) == frames


def test_a_frame_for_a_station_that_there_is_not_is_garbage() -> None:
    link, request = module_of(WIDGET).rtu, module_of(WIDGET).StopRequest()
    frame = link.encode_request(16, request)
    other = _with_station(frame, 17)
    framer = link.request_framer()
    assert framer.feed(other + frame) == [frame]
    assert framer.dropped == len(other)


def _with_station(frame: bytes, station: int) -> bytes:
    data = bytes([station]) + frame[1:-2]
    return data + checksum_of("crc16_modbus", data).to_bytes(2, "little")


def test_a_broadcast_is_a_request_and_no_response() -> None:
    link = module_of(WIDGET).rtu
    frame = link.encode_request(0, module_of(WIDGET).WriteRegisterRequest(0x2000, 5))
    assert link.request_framer().feed(frame) == [frame]
    assert link.response_framer().feed(frame) == []


def test_marks_around_a_length_are_part_of_the_frame() -> None:
    module = module_of(GIZMO)
    frames = [module.packet.encode_request(0x0203, module.ReadRequest(number)) for number in (0x0403, 0x0302)]
    framer = module.packet.request_framer()
    assert framer.feed(b"\x02\x03" + frames[0] + b"\x04" + frames[1]) == frames
    assert framer.dropped == 3


def test_a_framer_looks_at_each_byte_no_more_often_than_a_frame_is_long() -> None:
    # Every byte of this stream looks like the beginning of the longest frame that there is.
    framer = module_of(TC100).rtu.response_framer()
    calls = 0

    class Counting(type(framer)):  # type: ignore[misc]
        def _holds(self, frame: bytes) -> bool:
            nonlocal calls
            calls += 1
            assert len(frame) <= self.longest
            return bool(super()._holds(frame))

    framer.__class__ = Counting
    stream = bytes([1, 3, 120]) * 5000
    framer.feed(stream)
    assert calls <= len(stream)
