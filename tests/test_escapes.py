"""Escaped frames, judged by cobs and sliplib, and searched in streams."""

from __future__ import annotations

import random
from collections.abc import Callable

import pytest
import sliplib
from cobs import cobs

from fieldspec.codec.layout.escapes import EscapeError, original_places
from fieldspec.codec.reference import CodecError, codec
from fieldspec.codec.reference.escapes import escaped, unescaped
from fieldspec.language.behaviour.part import Behaviour
from fieldspec.language.model.escape import Escape
from fieldspec.tools.simulator.engine import Engine
from fieldspec.tools.simulator.server import Answer, Server
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of, runtime

BEACON = newest(TEST_SPECS, "beacon")
SERVO = newest(TEST_SPECS, "servo2")
ESCAPES: dict[str, Escape] = {name: link.link.escape for name, link in BEACON.links.items() if link.link.escape}
ESCAPES["insert"] = SERVO.links["bus"].link.escape or ESCAPES["cobs"]
BYTES = (0, 1, 2, 0x10, 0x1B, 0x7D, 0x7E, 0xC0, 0xDB, 0xDC, 0xDD, 0xFD, 0xFD, 0xFF, 0xFF, 0xFF)
CHANCE = random.Random(3)
DATA = [bytes(CHANCE.choices(BYTES, k=CHANCE.randrange(12))) for _ in range(300)]
DATA += [
    bytes(CHANCE.choices(range(1, 256), k=size)) + end for size in (253, 254, 255, 508, 509) for end in (b"", b"\0")
]


def python_escape(name: str) -> object:
    """The escape of the generated code."""
    modules = {"insert": module_of(SERVO)}
    module = modules.get(name, module_of(BEACON))
    return getattr(module, "_BUS_REQUESTS" if name == "insert" else f"_{name.upper()}_REQUESTS").escape


@pytest.mark.parametrize("name", ESCAPES)
def test_what_is_sent_becomes_the_original_bytes_again(name: str) -> None:
    escape, generated = ESCAPES[name], python_escape(name)
    for data in DATA:
        sent = escaped(escape, data)
        assert generated.escaped(data) == sent  # type: ignore[attr-defined]
        assert generated.original(sent, 0) == unescaped(escape, sent, 0) == data  # type: ignore[attr-defined]
        assert bytes(byte for byte, _ in original_places(escape, sent)) == data
        assert len(sent) <= escape.most(len(data))


def outcome(read: Callable[[], bytes], offset: int = 5) -> bytes | int:
    """The original bytes, or where they are refused, counted from the first one."""
    try:
        return read()
    except (CodecError, EscapeError, codec_error()) as error:
        return int(error.offset) - offset  # type: ignore[attr-defined]


@pytest.mark.parametrize("name", ESCAPES)
def test_wrong_escapes_are_refused_at_the_same_place(name: str) -> None:
    escape, generated = ESCAPES[name], python_escape(name)
    refusals = 0
    for data in DATA:
        results = [
            outcome(lambda data=data: generated.original(data, 5)),  # type: ignore[attr-defined,misc]
            outcome(lambda data=data: unescaped(escape, data, 5)),  # type: ignore[misc]
            outcome(lambda data=data: bytes(byte for byte, _ in original_places(escape, data)), 0),  # type: ignore[misc]
        ]
        assert results == [results[0]] * 3
        refusals += isinstance(results[0], int)
    assert refusals > 1


def test_cobs_is_that_of_the_library() -> None:
    for data in DATA:
        assert escaped(ESCAPES["cobs"], data) == cobs.encode(data)


def test_slip_is_that_of_the_library() -> None:
    for data in DATA:
        assert escaped(ESCAPES["slip"], data) == sliplib.encode(data).strip(b"\xc0")
        assert sliplib.decode(escaped(ESCAPES["slip"], data)) == data


@pytest.mark.parametrize("name", [*BEACON.links, "bus"])
def test_a_framer_finds_the_frames_between_garbage(name: str) -> None:
    layout = SERVO if name == "bus" else BEACON
    link, module = codec(layout).links[name], module_of(layout)
    framer = getattr(module, name).response_framer()
    chance, frames, stream = random.Random(name), [], b""
    for _ in range(60):
        station = {"slip": {"station": 7}, "bus": {"id": 7, "error": 0}}.get(name, {})
        values = chance.choices(BYTES, k=chance.randrange(1, 40))
        address = {} if name == "bus" else {"address": chance.choice(BYTES)}
        body = {"data": values} if name == "bus" else {"values": values}
        frames.append(link.encode("response", "read", {**station, **address, **body}))
        # What is not a frame ends where frames without a start mark end.
        garbage = bytes(chance.choices(BYTES, k=chance.randrange(6)))
        stream += garbage + {"slip": b"\xc0", "cobs": b"\0"}.get(name, b"") + frames[-1]
    matches = []
    at = 0
    while at < len(stream):
        size = chance.randrange(1, 30)
        matches += framer.feed(stream[at : at + size])
        at += size
    missing = [frame for frame in frames if frame not in matches]
    assert len(matches) - len(frames) <= 0
    assert len(missing) <= (3 if name in ("bus", "partly", "doubled", "flagged") else 0)


def test_the_checks_of_what_is_sent_come_before_those_of_the_original_bytes() -> None:
    link = codec(BEACON).links["partly"]
    frame = bytearray(link.encode("request", "read", {"address": 0x0202}))
    # The sum of the body, 02 02, is 04. The outer one is that of what is sent, where each 02 stands twice.
    assert frame.hex(" ") == "02 10 00 0a 02 02 02 02 04 00 26"
    frame[-1] ^= 1
    with pytest.raises(CodecError, match="outer"):
        link.decode(bytes(frame), "request")
    assert runtime("_escapes").Cobs().escaped(b"") == b"\x01"


@pytest.mark.parametrize("frame", [b"\x02", b"\x02\x10", b"\x02\x10\x00"])
def test_a_frame_without_all_parts_is_refused_before_its_escapes_are_undone(frame: bytes) -> None:
    with pytest.raises(CodecError) as refused:
        codec(BEACON).links["partly"].original_parts(frame, "request")
    assert (refused.value.reason, refused.value.offset) == ("incomplete", len(frame) - 1)
    answer = Server(Engine(BEACON, Behaviour(()))).answer("partly", frame)
    assert answer == Answer(b"", f"damaged: a frame has at least 6 bytes, not {len(frame) - 1}")
