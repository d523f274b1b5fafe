"""Words beside the pieces of a value: the bits that nothing else decides have their defaults."""

from __future__ import annotations

import pytest

from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.codec.layout.segments import segments_of
from fieldspec.language.reading.project import read

SPEC = """
device:
  id: node
  name: Node
  vendor: Nobody
  manual: {title: No manual, file: node.txt, sha256: "ZEROS", lines: 99}
links:
  - name: line
    source: 1 L1
    transmission: binary
    byte_order: big
    request: &parts
      - {name: code, role: code, type: u8, source: 1 L1}
      - {name: body, role: body, source: 1 L1}
      - {name: crc, role: checksum, algorithm: crc16_modbus, source: 1 L1}
    response: *parts
flags:
  - name: command
    type: u8
    source: 1 L2
    bits:
      - {bit: 0, name: last, source: 1 L2}
      - {bits: 1..3, name: unused, source: 1 L2}
      - {bit: 4, name: toggle, source: 1 L2}
      - {bit: 6, name: enabled, default: 1, source: 1 L2}
messages:
  - name: download
    code: 0x21
    source: 1 L3
    request:
      - {name: index, type: u16, parameter: {set: objects, part: number}, source: 1 L3}
      - {name: size, type: u32, source: 1 L3, word_order: big}
    response: []
    segments: {message: piece, size: size, data: data, counter: toggle, unused: unused, last: last}
  - name: piece
    code: 0x22
    source: 1 L4
    request: [{name: word, type: u8, flags: command, source: 1 L4}, {name: data, type: bytes, length: 7, source: 1 L4}]
    response: [{name: word, type: u8, flags: command, source: 1 L4}]
parameters:
  - name: objects
    source: 1 L5
    rows: [{number: 5, name: title, type: text, length: 32, access: wo, source: 1 L5}]
"""


@pytest.fixture(scope="module")
def layout() -> DeviceLayout:
    project = read({"node/device.yaml": SPEC.replace("ZEROS", "0" * 64).encode()})
    assert [finding for finding in project.findings if finding.severity.name == "ERROR"] == []
    return device_layout(project.devices["node"].at("1")[0])


def test_each_piece_has_the_defaults_of_the_bits_beside_it(layout: DeviceLayout) -> None:
    pieces = segments_of(layout, layout.messages["download"])
    assert pieces is not None
    words = [pieces.request(count, b"1234567", is_last)["word"] for count, is_last in ((0, False), (1, True))]
    assert words == [0b0100_0000, 0b0101_0001]
