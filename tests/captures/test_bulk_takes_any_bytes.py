"""Files of random and damaged bytes are decoded without an error, and no byte of a payload is lost."""

from __future__ import annotations

import io
import random
from contextlib import suppress

import pytest

from captures.bulk import Sent, decoded, verdicts
from captures.conversations import RTAC, USER_0, ethernet, pcap, pcapng, rtu, tcp_poll
from fieldspec.codec.layout.device import device_layout
from fieldspec.language.reading.project import read
from fieldspec.tools.captures.capture_files import CaptureError
from fieldspec.tools.captures.conversion import Conversion
from fieldspec.tools.captures.decoding import Choices, DeviceDecoder
from fieldspec.tools.captures.network import Network
from fieldspec.tools.captures.payloads import Names
from fieldspec.tools.captures.sources import PacketSource
from layouts import TEST_SPECS, newest

METER = newest(TEST_SPECS, "wattmeter")
SEEDS = (
    pcap(map(ethernet, tcp_poll(20))),
    pcapng(map(ethernet, tcp_poll(20))),
    pcap(5 * [rtu(1, 4, 0, 0, 0, 2), rtu(1, 4, 4, 1, 2, 3, 4)], USER_0),
    pcap(5 * [bytes(12) + rtu(1, 4, 0, 0, 0, 2)], RTAC),
    b"12:00:00 TX: 01 04 00 00 00 02 71 CB\n" * 20,
    b"time,address,value\n1.5 ,0,1\n1.5 ,1,2\n" * 20,
)


def damaged(data: bytes, chance: random.Random) -> bytes:
    """The same bytes with some changed, cut out or added."""
    result = bytearray(data)
    for _ in range(chance.randrange(1, 12)):
        place = chance.randrange(len(result))
        kind = chance.randrange(3)
        if kind == 0:
            result[place] = chance.randrange(256)
        elif kind == 1:
            del result[place : place + chance.randrange(1, 30)]
        else:
            result[place:place] = chance.randbytes(chance.randrange(1, 30))
        result = result or bytearray(b"\0")
    return bytes(result)


@pytest.mark.parametrize("number", range(len(SEEDS)))
def test_damaged_files_never_raise_another_error(number: int) -> None:
    chance = random.Random(number)
    device = DeviceDecoder(METER, Choices())
    for _ in range(60):
        data = damaged(SEEDS[number], chance)
        with suppress(CaptureError):
            for batches in Conversion(io.BytesIO(data), device, ()).batches():
                assert all(len(batch.frames.number) for batch in batches)


@pytest.mark.parametrize("link", ["rtu", "tcp"])
def test_every_byte_of_a_garbled_line_is_in_the_table(link: str) -> None:
    chance = random.Random(3)
    device = DeviceDecoder(METER, Choices(link))
    for _ in range(30):
        good = [rtu(1, 4, 0, 0, 0, 2), rtu(1, 4, 4, 1, 2, 3, 4)] * 4
        line = damaged(b"".join(good), chance)
        cuts = sorted(chance.randrange(len(line) + 1) for _ in range(6))
        packets = [line[a:b] for a, b in zip([0, *cuts], [*cuts, len(line)], strict=True) if a < b]
        batches = [
            batch for each in Conversion(io.BytesIO(pcap(packets, USER_0)), device, ()).batches() for batch in each
        ]
        assert b"".join(batch.frames.bytes[0].tobytes() for batch in batches) == line


def test_a_packet_source_of_nothing_has_no_payload() -> None:
    file = io.BytesIO(pcap([]))
    assert list(PacketSource(file.read, Names(), ()).payloads()) == []
    assert Network((), Names()).skipped == {}


CHECK_IN_FRONT = """
device:
  {id: chance, name: Chance, vendor: Nobody, manual: {title: T, file: t.txt, sha256: "%s", lines: 9}}
links:
  - name: line
    source: 1 L1
    byte_order: big
    request: &parts
      - {name: check, role: checksum, algorithm: sum8, covers: {from: code, to: last}}
      - {name: code, role: code, type: u8}
      - {name: last, type: u8}
      - {name: body, role: body}
    response: *parts
messages:
  - {name: read, source: 1 L1, code: 3, request: [], response: []}
""" % ("0" * 64)


def test_frames_that_end_before_what_their_check_covers_are_incomplete() -> None:
    device = read({"chance/device.yaml": CHECK_IN_FRONT.encode()}).devices["chance"]
    layout = device_layout(device.at(device.versions()[-1])[0])
    whole = bytes([3 + 9, 3, 9])
    sent = [Sent(0, "request", whole[:size]) for size in (3, 2, 1)]
    assert verdicts(decoded(layout, sent, Choices("line"))) == ["ok", "incomplete", "incomplete"]
