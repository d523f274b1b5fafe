"""Captures that are cut short, damaged, packed, or of other traffic: what they have comes out, what lacks is said."""

from __future__ import annotations

import gzip
import io
import random
import struct
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import pytest

from captures.conversations import RTAC, USER_0, rtu
from captures.conversations import pcap as lines
from captures.network_captures import (
    FORMS,
    NETWORKS,
    Segment,
    capture,
    connection,
    exchanges,
    packets,
    turns,
)
from captures.test_bulk_takes_any_bytes import damaged
from captures.test_decode_in_bulk import decode, rows, stopped_after_first_part
from captures.test_every_kind_of_capture import own_frames, own_values, true_values, truth
from fieldspec.tools.captures.capture_files import CaptureError
from fieldspec.tools.captures.conversion import Conversion
from fieldspec.tools.captures.decoding import Choices, DeviceDecoder
from layouts import TEST_SPECS, newest

CHANCE = random.Random(7)
TALK = exchanges(CHANCE, 150)
ALONE = connection(turns(TALK, 1, 0, 1, CHANCE))
SPLIT = connection(turns(TALK, 1, 1, 1, CHANCE))
HEADERS = {name: len(next(packets(ALONE, wrap))) for name, (_, wrap) in NETWORKS.items()}
"""The bytes of a packet without data."""


@pytest.mark.parametrize(
    ("network", "form"),
    [("IPv4", "pcap"), ("IPv6", "pcapng in gzip"), ("QinQ", "pcapng"), ("IPv6 with options", "pcap in nanoseconds")],
)
@pytest.mark.parametrize("most", [12, 16, 28])
def test_a_packet_that_is_cut_short_takes_nothing_with_it(tmp_path: Path, network: str, form: str, most: int) -> None:
    content = capture(ALONE, network, form, HEADERS[network] + most)
    code, _, frames, values = decode(tmp_path, content)
    whole = [frame for frame in frames if frame["verdict"] == "ok"]
    true = {
        frame
        for talk in TALK
        for frame in truth([talk])
        if len(talk.request if frame.is_request else talk.answer) <= most
    }
    assert own_frames(whole) == true
    answered = {talk for talk in TALK if len(talk.request) <= most and len(talk.answer) <= most}
    pairs = [frame for frame in whole if frame["request"]]
    assert {frame.transaction for frame in own_frames(pairs)} == {talk.transaction for talk in answered}
    readable = [talk for talk in TALK if len(talk.request if talk.code == 16 else talk.answer) <= most]
    assert own_values(whole, values) == true_values(readable)
    lost = sum(len(talk.request) > most for talk in TALK) + sum(len(talk.answer) > most for talk in TALK)
    assert (code, len(frames) - len(whole)) == (1, lost)


def test_pieces_of_packets_that_are_cut_short_join_nothing(tmp_path: Path) -> None:
    code, _, frames, values = decode(tmp_path, capture(SPLIT, most=HEADERS["IPv4"] + 18))
    whole = [frame for frame in frames if frame["verdict"] == "ok"]
    assert code == 1
    assert own_frames(whole) < truth(TALK)
    assert own_values(whole, values) < true_values(TALK)
    cut = [segment for segment in SPLIT if len(segment.data) > 18]
    assert len(own_frames(whole)) == len(truth(TALK)) - len(cut)


def test_a_frame_of_a_line_that_is_cut_short_takes_nothing_with_it(tmp_path: Path) -> None:
    read, long = rtu(1, 4, 0, 0, 0, 2), rtu(1, 4, 12, *range(12))
    answer = rtu(1, 4, 4, 0x43, 0x66, 0, 0)
    for link_type, head in ((USER_0, b""), (RTAC, bytes(12))):
        content = bytearray(lines([head + data for data in (read, long, read, answer) * 3], link_type))
        size = len(head) + len(long)
        record = struct.pack("<II", size, size)
        at = content.index(record)
        while at >= 0:
            del content[at + 8 + len(head) + 7 : at + 8 + size]
            content[at : at + 4] = struct.pack("<I", len(head) + 7)
            at = content.find(record)
        folder = tmp_path / str(link_type)
        folder.mkdir()
        _, _, frames, _ = decode(folder, bytes(content), "--link", "rtu")
        assert [frame["verdict"] == "ok" for frame in frames] == [True, False, True, True] * 3


def test_a_packet_that_a_capture_lacks_takes_no_other_exchange_with_it(tmp_path: Path) -> None:
    missing = {number for number in range(10, len(ALONE), 37) if ALONE[number].data}
    content = capture([segment for number, segment in enumerate(ALONE) if number not in missing])
    _, _, frames, values = decode(tmp_path, content)
    lost = {
        frame
        for number in missing
        for frame in truth(TALK)
        if is_of(ALONE[number], frame.is_request, frame.transaction)
    }
    assert len(lost) == len(missing)
    assert own_frames(frames) >= {frame for frame in truth(TALK) - lost if frame.is_request or frame.code == 16}
    asked = {frame.transaction for frame in truth(TALK) - lost if frame.is_request}
    orphans = {frame.transaction for frame in lost if frame.is_request}
    unpaired = {
        struct.unpack(">H", f["bytes"][:2])[0] for f in frames if f["direction"] == "response" and not f["request"]
    }
    assert unpaired == orphans - {frame.transaction for frame in lost if not frame.is_request}
    assert {number for number, *_ in own_values(frames, values)} <= asked | orphans


def is_of(segment: Segment, is_request: bool, transaction: int) -> bool:
    """Whether a segment is a frame."""
    return segment.is_request == is_request and segment.data[:2] == struct.pack(">H", transaction)


LEFT_OUT: dict[str, tuple[Callable[[], bytes], int]] = {
    "a foreign conversation": (lambda: foreign(b"GET / HTTP/1.1\r\n\r\n"), 1),
    "packets without any of their data": (lambda: capture(ALONE, most=HEADERS["IPv4"]), 1),
    "packets without their headers": (lambda: capture(ALONE, most=30), 1),
    "fragments": (lambda: capture(ALONE).replace(bytes.fromhex("00004006"), bytes.fromhex("20004006")), 1),
    "another protocol": (lambda: lines([bytes(12) + b"\x08\x06" + bytes(28)]), 1),
    "another link type": (lambda: lines([b"\1\2\3"], 105), 1),
    "a log without bytes": (lambda: b"the motor stopped\nthe motor started\n", 1),
    "a handshake": (lambda: capture(ALONE[:3]), 0),
    "no packet": (lambda: lines([]), 0),
    "frames": (lambda: capture(ALONE), 0),
    "pieces of frames": (lambda: capture(SPLIT), 0),
}


def foreign(data: bytes) -> bytes:
    """A capture of a conversation that is none of the device."""
    return capture([segment._replace(data=data if segment.data else b"") for segment in ALONE])


@pytest.mark.parametrize("name", LEFT_OUT)
def test_a_file_of_which_everything_is_left_out_is_a_failure(tmp_path: Path, name: str) -> None:
    make, expected = LEFT_OUT[name]
    code, text, frames, _ = decode(tmp_path, make())
    assert (code, not frames) == (expected, name not in ("frames", "pieces of frames"))
    assert ("nothing in it is a frame of the device" in text) == bool(expected)


def test_a_connection_is_told_from_pieces_in_several_batches(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = decode(tmp_path, capture(SPLIT))
    monkeypatch.setattr("fieldspec.tools.captures.capture_files.BATCH", 150)
    again = tmp_path / "again"
    again.mkdir()
    assert decode(again, capture(SPLIT)) == whole


@pytest.mark.proof(3)
@pytest.mark.parametrize("form", FORMS)
def test_a_killed_run_over_any_file_goes_on_where_it_was(
    tmp_path: Path, form: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    content = capture(SPLIT, "IPv6", form)
    decode(tmp_path, content, "--part-frames", "1000000")
    whole = {table: rows(tmp_path / "out", table) for table in ("frames", "values")}
    again = tmp_path / "again"
    again.mkdir()
    monkeypatch.setattr("captures.test_decode_in_bulk.STOP_BATCH", 5000)
    assert stopped_after_first_part(again, content, "50") == "stopped"
    assert decode(again, content, "--part-frames", "50")[0] == 0
    assert {table: rows(again / "out", table) for table in ("frames", "values")} == whole


def test_packed_logs_and_rows_are_read(tmp_path: Path) -> None:
    for name, text in (
        ("log", f"{rtu(1, 4, 0, 0, 0, 2).hex(' ')}\n{rtu(1, 4, 4, 0x43, 0x66, 0, 0).hex(' ')}\n"),
        ("rows", "address,value,space\n0,0x4366,input_registers\n1,0,input_registers\n"),
    ):
        folder = tmp_path / name
        folder.mkdir()
        code, _, _, values = decode(folder, gzip.compress(text.encode()))
        assert (code, [value["value"] for value in values]) == (0, [230.0])


@pytest.mark.parametrize("end", [12, 300, 2000, -9, -1])
def test_packed_bytes_that_end_too_early_are_decoded_as_far_as_they_go(tmp_path: Path, end: int) -> None:
    content = gzip.compress(capture(ALONE), mtime=0)
    code, text, frames, _ = decode(tmp_path, content[:end])
    assert code == 1
    assert "the compressed data ends too early" in text
    true = truth(TALK)
    assert own_frames(frames) <= true
    assert len(frames) >= (len(true) if end < 0 else 0)


def test_packed_bytes_that_are_broken_are_said(tmp_path: Path) -> None:
    content = bytearray(gzip.compress(capture(ALONE), mtime=0))
    content[-6] ^= 1  # in the checksum
    code, text, frames, _ = decode(tmp_path, bytes(content))
    assert (code, own_frames(frames)) == (1, truth(TALK))
    assert "the compressed data is broken" in text


@pytest.mark.parametrize(
    ("magic", "program"), [("28b52ffd", "zstd"), ("04224d18", "lz4"), ("fd377a585a", "xz"), ("425a6839", "bzip2")]
)
def test_what_another_program_has_packed_is_refused_by_its_name(tmp_path: Path, magic: str, program: str) -> None:
    code, text, _, _ = decode(tmp_path, bytes.fromhex(magic) + bytes(100))
    assert code == 1
    assert f"{program} has packed the file; unpack it, or pack it with gzip" in text


@pytest.mark.proof(3)
@pytest.mark.parametrize("form", FORMS)
def test_a_capture_damaged_anywhere_never_ends_in_another_error(form: str) -> None:
    device = DeviceDecoder(newest(TEST_SPECS, "wattmeter"), Choices())
    chance = random.Random(form)
    for network in NETWORKS:
        content = capture(SPLIT[:60], network, form)
        for number in range(6):
            data = damaged(content, chance) if number % 2 else content[: chance.randrange(len(content))]
            with suppress(CaptureError):
                for batches in Conversion(io.BytesIO(data), device, ()).batches():
                    assert all(len(batch.frames.number) for batch in batches)


@pytest.mark.proof(6)
@pytest.mark.parametrize("network", NETWORKS)
def test_packets_damaged_anywhere_lose_only_what_is_damaged(network: str) -> None:
    """The bits of one packet are changed; all frames but those in it and in what it seems to repeat stay."""
    device = DeviceDecoder(newest(TEST_SPECS, "wattmeter"), Choices())
    chance = random.Random(network)
    for _ in range(8):
        number = chance.randrange(20, len(ALONE))
        _, wrap = NETWORKS[network]
        data = bytearray(capture(ALONE, network))
        sizes = [16 + len(packet) for packet in packets(ALONE, wrap)]
        start = 24 + sum(sizes[:number])
        place = start + 16 + chance.randrange(sizes[number] - 16)
        data[place] ^= 1 << chance.randrange(8)
        frames = sum(
            int((batch.frames.verdict == 0).sum())
            for batches in Conversion(io.BytesIO(bytes(data)), device, ()).batches()
            for batch in batches
        )
        assert frames >= 2 * len(TALK) - 3
