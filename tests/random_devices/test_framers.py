"""Framers find the same frames, whatever the pieces in which bytes come."""

from __future__ import annotations

from pathlib import Path

from random_devices.agreement import layouts_of
from random_devices.framer_judge import Framers
from random_devices.framer_streams import Stream

SPEC = """
device:
  id: chance
  name: Chance
  vendor: Maker
  manual: {title: Manual, file: chance.txt, sha256: "DIGEST", lines: 100}
links:
  - name: line
    source: 1 L1
    transmission: binary
    byte_order: big
    word_order: big
    end: "0D"
    request: [{name: body, role: body}]
    response: [{name: body, role: body}]
messages:
  - name: move
    links: [line]
    source: 2 L1
    request: [{name: mark, type: u8, const: 0x0D}, {name: speed, type: u8}]
    response: []
""".replace("DIGEST", "0" * 64)
REFUSED = bytes.fromhex("09 09 0D")
"""A frame whose data the link refuses, and which is known when one byte more than a frame has comes."""
FOLLOWING = bytes.fromhex("02 0D")
"""With the last byte of that frame they are a frame that the link decodes."""


def test_a_frame_that_is_refused_does_not_depend_on_bytes_that_come_later(tmp_path: Path) -> None:
    judge = Framers(layouts_of(SPEC)[0], tmp_path, 0)
    stream = REFUSED + FOLLOWING
    streams = [
        Stream("line", "request", tuple(stream[place : place + size] for place in range(0, len(stream), size)))
        for size in range(1, len(stream) + 1)
    ]
    cuts = [*map(judge.python_cut, streams), *judge.javascript_cuts(streams)]
    assert {cut.all_frames for cut in cuts if cut is not None} == {(REFUSED,)}
    assert None not in cuts


ADDRESSED = """
device:
  id: chance
  name: Chance
  vendor: Maker
  manual: {title: Manual, file: chance.txt, sha256: "DIGEST", lines: 100}
links:
  - name: line
    source: 1 L1
    transmission: binary
    byte_order: big
    word_order: big
    request: &frame
      - {name: length, role: length, type: u8}
      - {name: unit, role: unit_address, type: u8, digits: decimal, length: 2}
      - {name: body, role: body}
    response: *frame
messages:
  - name: move
    links: [line]
    source: 2 L1
    request: [{name: speeds, type: u8, repeat: 1..20}]
    response: []
""".replace("DIGEST", "0" * 64)


def test_a_frame_does_not_wait_for_one_whose_unit_address_is_not_digits(tmp_path: Path) -> None:
    judge = Framers(layouts_of(ADDRESSED)[0], tmp_path, 1)
    frame = b"\x04" + b"15" + b"\x07"
    stream = Stream("line", "request", (b"\x09" + b"1x" + frame,))
    cuts = [judge.python_cut(stream), *judge.javascript_cuts([stream])]
    assert [cut and cut.all_frames for cut in cuts] == [(frame,)] * 2
