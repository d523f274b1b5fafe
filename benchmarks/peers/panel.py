"""A made-up device that answers with a record of twenty fields: states, words of bits, quantities and numbers."""

from __future__ import annotations

import struct
from collections.abc import Iterator

PORT = 4001


HEAD = """\
device:
  id: panel
  name: Panel
  vendor: Nobody
  title: A made-up panel of a machine
  manual: {{title: The manual of no panel, file: panel.txt, sha256: "{digest}", lines: 99}}
links:
  - name: tcp
    source: 1 L1
    transmission: binary
    byte_order: big
    word_order: big
    request: &frame
      - {{name: length, role: length, type: u16, source: 1 L2}}
      - {{name: code, role: code, type: u8, source: 1 L3}}
      - {{name: body, role: body}}
    response: *frame
    network: {{tcp: {port}, source: 1 L4}}
messages:
  - name: read_all
    code: 1
    source: 2 L1
    request: []
    response:
{fields}
enums:
{enums}
flags:
{flags}
"""


def spec() -> str:
    """The spec of the device."""
    meanings = [
        *(f"enum: state_{place}" for place in range(4)),
        *(f"flags: word_{place}" for place in range(4)),
        *(6 * ["scale: 0.01, unit: mm"]),
        *(6 * ["range: 0..65535"]),
    ]
    fields = [f"      - {{name: f{place}, type: u16, {meaning}}}" for place, meaning in enumerate(meanings)]
    enums = [
        f"  - {{name: state_{place}, title: State, source: 4 L2, members: [{_items('value', f's{place}', 20)}]}}"
        for place in range(4)
    ]
    flags = [
        f"  - {{name: word_{place}, type: u16, source: 4 L3, bits: [{_items('bit', f'w{place}_flag', 16)}]}}"
        for place in range(4)
    ]
    return HEAD.format(
        digest=64 * "6", port=PORT, fields="\n".join(fields), enums="\n".join(enums), flags="\n".join(flags)
    )


def reads(count: int) -> Iterator[tuple[bytes, bytes]]:
    """The request and the answer of reads in `count` frames."""
    for number in range(count // 2):
        words = [(number * 7919 + word) % 65536 for word in range(20)]
        answer = struct.pack(">HB20H", 43, 1, *(word % 20 for word in words[:4]), *words[4:])
        yield struct.pack(">HB", 3, 1), answer


def _items(key: str, name: str, count: int) -> str:
    return ", ".join(f"{{{key}: {number}, name: {name}_{number}}}" for number in range(count))
