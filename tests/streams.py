"""A made-up device on whose links neither a length nor the code alone determines where frames end, and its streams."""

from __future__ import annotations

import random
from functools import cache
from types import ModuleType

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference import CodecError, codec
from fieldspec.command.pipeline import layouts, load
from random_devices.inputs import header_values, record_values
from random_devices.python_judge import module_of_device

SPEC = """
device:
  id: linker
  name: Linker
  vendor: Nobody
  manual: {title: The linker of nothing, file: linker.txt, sha256: "%s", lines: 99}
links:
  - name: closed
    source: 1 L1
    byte_order: big
    end: "FF"
    request: &headed
      - {name: head, type: u8, const: 0x81}
      - {name: command, role: code, type: u8}
      - {name: data, role: body}
    response: &answered
      - {name: head, type: u8, const: 0x90}
      - {name: command, role: code, type: u8}
      - {name: data, role: body}
  - name: summed
    source: 1 L2
    byte_order: big
    request: &summed
      - {name: command, role: code, type: u8}
      - {name: data, role: body}
      - {name: sum, role: checksum, algorithm: crc16_modbus}
    response: *summed
  - {name: bare, source: 1 L3, byte_order: big, request: *headed, response: *answered}
  - name: digital
    source: 1 L4
    byte_order: big
    start: "40"
    end: "2A 0D"
    unit_addresses: {range: 0..31, source: 1 L4}
    request: &digital
      - {name: unit, role: unit_address, type: u8, digits: decimal, length: 2}
      - {name: header, role: code, type: u16}
      - {name: text, role: body}
      - {name: fcs, role: checksum, algorithm: xor8, digits: upper_hex}
    response:
      - {name: unit, role: unit_address, type: u8, digits: decimal, length: 2}
      - {name: header, role: code, type: u16}
      - {name: end_code, type: u8, digits: upper_hex, length: 2, enum: end_code}
      - {name: text, role: body}
      - {name: fcs, role: checksum, algorithm: xor8, digits: upper_hex}
    exception_response: {part: end_code, normal: 0, record: nothing, source: 1 L4}
  - name: lines
    source: 1 L5
    byte_order: big
    end: "0A"
    request: [{name: line, role: body}]
    response: [{name: line, role: body}]
  - name: little
    source: 1 L6
    byte_order: big
    start: "B5 62"
    request: &little
      - {name: class_id, role: code, type: u16}
      - {name: length, role: length, type: u16, byte_order: little, measures: {from: payload, to: payload}}
      - {name: payload, role: body}
      - {name: sum, role: checksum, algorithm: sum8, covers: {from: class_id, to: payload}}
    response: *little
  - name: routed
    source: 1 L7
    byte_order: big
    unit_addresses: {range: "1..500, 600..60000", source: 1 L7}
    request: &routed
      - {name: unit, role: unit_address, type: u16, byte_order: little}
      - {name: command, role: code, type: u16}
      - {name: data, role: body}
      - {name: sum, role: checksum, algorithm: crc16_modbus}
    response: *routed
messages:
  - name: power
    code: 0x01
    links: [closed, summed, bare]
    source: 2 L1
    request: [{name: sub, type: u8, const: 0}, {name: state, type: u8}]
    response: [{name: sub, type: u8, const: 0}, {name: state, type: u8}]
  - name: zoom
    code: 0x01
    links: [closed, summed, bare]
    source: 2 L2
    request: [{name: sub, type: u8, const: 1}, {name: position, type: u8, count: 4}]
    response: [{name: sub, type: u8, const: 1}, {name: position, type: u8, count: 4}]
  - name: near
    code: 0x02
    response_code: 0x50
    links: [closed, summed]
    source: 2 L3
    request: [{name: mode, type: u8}]
    response: [{name: mode, type: u8}]
  - name: far
    code: 0x03
    response_code: 0x50
    links: [closed, summed]
    source: 2 L4
    request: [{name: steps, type: u8, range: 0..15, count: 4}]
    response: [{name: steps, type: u8, range: 0..15, count: 4}]
  - name: read_words
    code: 0x5252
    links: [digital]
    source: 2 L5
    request: [{name: address, type: u16, digits: decimal, length: 4, range: 0..6655}]
    response: [{name: values, type: u16, digits: upper_hex, length: 4, repeat: 1..29}]
  - name: read_status
    code: 0x4D53
    links: [digital]
    source: 2 L6
    request: []
    response: [{name: mode, type: u8, digits: upper_hex, length: 2}, {name: note, type: text, length: 16, varies: true}]
  - name: read_level
    links: [lines]
    source: 2 L7
    request: [{name: words, type: u32, const: 0x4C564C3F}]
    response: [{name: level, type: i32, digits: decimal, length: 9, scale: 0.001, varies: true}]
  - name: read_all
    links: [lines]
    source: 2 L8
    request: [{name: words, type: u32, const: 0x414C4C3F}, {name: channel, type: u8, digits: decimal, length: 1}]
    response:
      - {name: level, type: i32, digits: decimal, length: 9, scale: 0.001, varies: true}
      - {name: comma, type: u8, const: 0x2C}
      - {name: count, type: u16, digits: decimal, length: 5, varies: true}
  - {name: poll, code: 0x0102, links: [little, routed], source: 2 L9, request: [], response: [{name: value, type: u16}]}
records:
  - {name: nothing, source: 1 L4, fields: []}
enums:
  - name: end_code
    kind: exception
    source: 3 L1
    open: true
    members: [{value: 0, name: normal}, {value: 1, name: refused}]
"""
FRAMES = 30


@cache
def linker(bare: str = "bare") -> DeviceLayout:
    """The made-up device of this file, with the name of its link without an end delimiter or a length."""
    text = SPEC.replace("%s", "1" * 64).replace("bare", bare)
    project = load({"linker/device.yaml": text.encode()})
    assert [finding.message for finding in project.findings] == []
    return layouts(project.devices["linker"])[0]


@cache
def linker_module() -> ModuleType:
    return module_of_device(linker(), 0)


def frames_of(layout: DeviceLayout, link: str, direction: str, chance: random.Random) -> list[bytes]:
    """Random frames of all messages of a link that its encoder makes."""
    line = layout.links[link]
    carried = line.carried(direction)
    addresses, part = line.link.unit_addresses, line.frame(direction).role("unit_address")
    name_of_address = part.name if part is not None else ""
    frames: list[bytes] = []
    for _ in range(20 * FRAMES):
        name = chance.choice(list(carried))
        head = header_values(layout, link, line.frame(direction), chance)
        if direction == "response" and addresses and head.get(name_of_address, -1) == addresses.broadcast:
            continue  # nobody answers a broadcast
        values = record_values(layout, carried[name].data(direction), chance)
        try:
            frames.append(codec(layout).links[link].encode(direction, name, {**head, **values}))
        except CodecError:
            continue  # one of the values is just out of range
        if len(frames) == FRAMES:
            break
    return frames


GARBAGE = b"\x00\xc1\xfe"


def pieces_of(frames: list[bytes], most: int, chance: random.Random) -> list[bytes]:
    """Frames with up to `most` bytes of garbage between them, in pieces of any size."""
    stream = b"".join(bytes(chance.choices(GARBAGE, k=chance.randint(0, most))) + frame for frame in frames)
    cuts = sorted(chance.sample(range(len(stream)), min(len(stream), 2 * len(frames))))
    return [stream[first:last] for first, last in zip([0, *cuts], [*cuts, len(stream)], strict=True)]
