"""Captures in bulk, logs and Wireshark pair a response with the same request, also where answers are lost or late."""

from __future__ import annotations

import io
import re
import struct
from argparse import Namespace
from typing import NamedTuple

import pytest

from captures.bulk import Sent, decoded
from fieldspec.codec.explain.readings import ChosenReading, FrameOptions
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.frames.frame_hints import FrameHints
from fieldspec.command.pipeline import layouts, load
from fieldspec.command.verbs.decode import FramePrinter, Log
from fieldspec.tools.captures.decoding import Choices
from wireshark_output.dissection import Packet, pcap, tshark

PORT = 2300
SPEC = """
device:
  id: twin
  name: Twin
  vendor: Nobody
  manual: {title: The manual of a twin, file: twin.txt, sha256: "%s", lines: 99}
links:
  - name: addressed
    transmission: binary
    byte_order: big
    start: "02"
    source: 1 L1
    request:
      - {name: meter, type: u32}
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
    response:
      - {name: meter, type: u32, same_as: meter}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
  - name: numbered
    transmission: binary
    byte_order: big
    start: "03"
    source: 1 L2
    request:
      - {name: transaction, type: u8}
      - {name: meter, type: u32}
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
    response:
      - {name: transaction, type: u8, same_as: transaction}
      - {name: meter, type: u32, same_as: meter}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
  - name: bus
    transmission: binary
    byte_order: big
    start: "04"
    source: 1 L3
    request:
      - {name: station, role: unit_address, type: u8}
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
    response:
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
  - name: talking
    transmission: binary
    byte_order: big
    start: "05"
    source: 1 L4
    request: &talking
      - {name: station, role: unit_address, type: u8}
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
    response: *talking
messages:
  - {name: event, code: 0x4C, links: [talking], requested: false, source: 2 L3, response: [{name: level, type: u16}]}
  - {name: read_pressure, code: 0x50, source: 2 L1, request: [], response: [{name: pressure, type: u16, unit: bar}]}
  - {name: read_speed, code: 0x53, source: 2 L2, request: [], response: [{name: speed, type: u16, unit: rpm}]}
"""


class Frame(NamedTuple):
    """A frame of a conversation: its direction, the meter, the command of a request, the number of the request.

    `asked` is the place of the request that it answers, from 1; 0 for none.
    """

    direction: str
    meter: int
    command: str
    transaction: int
    asked: int

    def data(self, link: str) -> bytes:
        """The bytes on a link."""
        is_request = self.direction == "request"
        head = {
            "addressed": struct.pack(">I", self.meter),
            "numbered": struct.pack(">BI", self.transaction, self.meter),
            "bus": bytes([self.meter] if is_request else []),
            "talking": bytes([self.meter]) + (b"" if is_request else self.command.encode()),
        }[link]
        parts = head + (self.command.encode() if is_request else b"\x03\xe8")
        start = {"addressed": b"\2", "numbered": b"\3", "bus": b"\4", "talking": b"\5"}[link]
        return start + parts + bytes([sum(parts) & 0xFF])


def frames_of(text: str) -> list[Frame]:
    """Frames as text: a request is `>9P`, or `>9P#1` with a number; `<9:1` answers the first frame, `<9` none.

    A response has a letter too where it has a code.
    """
    result = []
    for word in text.split():
        match = re.fullmatch(r"([<>])(\d)([PSL]?)(?:#(\d))?(?::(\d))?", word)
        assert match is not None
        way, meter, command, transaction, asked = match.groups()
        direction = "request" if way == ">" else "response"
        result.append(Frame(direction, int(meter), command, int(transaction or 0), int(asked or 0)))
    return result


CONVERSATIONS = {
    "no answer is lost": ("addressed", ">9P <9:1 >9S <9:3"),
    "a request is repeated": ("addressed", ">9P >9P <9:2 >9S <9:4 >9P <9:6"),
    "another request follows": ("addressed", ">9P >9S <9:2 <9"),
    "another meter is asked": ("addressed", ">9P >8S <8:2 <9:1"),
    "requests overlap": ("numbered", ">9P#1 >9S#2 >9P#3 <9#2:2 <9#1:1 <9#4 <9#3:3"),
    "a number comes again": ("numbered", ">9P#1 >9S#1 <9#1:2 <9#1"),
    "the response names no station": ("bus", ">9P >8S <8:2 <9"),
    "the device speaks before it answers": ("talking", ">9P <9L <9P:1 <9L >9S <9P <9S"),
}


@pytest.fixture(scope="module")
def twin() -> DeviceLayout:
    return layouts(load({"twin/device.yaml": SPEC.replace("%s", "1" * 64).encode()}).devices["twin"])[0]


class Remarks(FramePrinter):
    """Notes the line of the request that each frame answers."""

    asked: list[int]

    def explain(self, reading: ChosenReading, remarks: object, number: int = 0) -> None:
        """Notes one frame."""
        assert isinstance(remarks, list)
        own = [text for text in remarks if text.startswith("this answers the request in line ")]
        self.asked.append(int(own[0].rpartition(" ")[2]) if own else 0)


@pytest.mark.parametrize("name", CONVERSATIONS)
def test_a_response_answers_the_same_request_in_a_log_and_in_bulk(twin: DeviceLayout, name: str) -> None:
    link, text = CONVERSATIONS[name]
    frames = frames_of(text)
    printer = Remarks(twin, "text")
    printer.asked = []
    lines = "".join(
        f"{'TX' if frame.direction == 'request' else 'RX'}: {frame.data(link).hex(' ')}\n" for frame in frames
    )
    options = FrameOptions()
    hints = FrameHints(twin, options, Namespace())
    Log(twin, options, None, printer, hints, strict=False).explain(io.BytesIO(lines.encode()))
    sent = [Sent(0, frame.direction, frame.data(link)) for frame in frames]
    batches = decoded(twin, sent, Choices(link=link))
    in_bulk = [max(int(number), 0) for _, batch in batches for number in batch.frames.request]
    assert (printer.asked, in_bulk) == ([frame.asked for frame in frames],) * 2


def test_wireshark_shows_no_value_of_another_request(twin: DeviceLayout) -> None:
    packets, options, asked, first = [], [], [], 0
    for place, (link, text) in enumerate(CONVERSATIONS.values()):
        frames = frames_of(text)
        client, port = 40000 + place, PORT + len(link)
        packets += [Packet(client, port, frame.direction, frame.data(link)) for frame in frames]
        asked += [f"{first + frame.asked}" if frame.asked else "" for frame in frames]
        options += ["-o", f"twin.{link}_udp:{port}"]
        first += len(frames)
    run = tshark([twin], pcap(packets), "-T", "fields", "-e", "twin.frame.request_in", *options)
    assert run.stdout.split("\n")[:-1] == asked
