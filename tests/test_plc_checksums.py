"""Functions for controllers check each frame from its own first byte on, where links share an algorithm."""

from __future__ import annotations

import re

from fieldspec.language.reading.project import read
from fieldspec.targets.st.backend import files
from layouts import layout_at

SPEC = """
device:
  id: gadget
  name: Gadget
  vendor: Maker
  manual: {title: Manual, file: gadget.txt, sha256: DIGEST, lines: 100}
links:
  - name: whole
    title: The sum covers all bytes.
    source: 1 L1
    transmission: binary
    byte_order: big
    request: &whole
      - {name: station, role: unit_address, type: u8}
      - {name: code, role: code, type: u8}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8}
    response: *whole
  - name: marked
    title: The sum covers the bytes after the mark.
    source: 1 L2
    transmission: binary
    byte_order: big
    request: &marked
      - {name: mark, type: u8, const: 0x55}
      - {name: code, role: code, type: u8}
      - {name: body, role: body}
      - {name: sum, role: checksum, algorithm: sum8, covers: {from: code}}
    response: *marked
messages:
  - {name: ping, code: 1, source: 2 L1, request: [{name: number, type: u8}], response: [{name: number, type: u8}]}
""".replace("DIGEST", '"' + "0" * 64 + '"')


def test_each_link_checks_from_its_own_first_byte_on() -> None:
    spec = read({"gadget/device.yaml": SPEC.encode()}).devices["gadget"]
    text = "\n".join(str(content) for content in files([layout_at(spec, spec.versions()[0])]).values())
    assert set(re.findall(r"iFirst := (\w+)", text)) == {"0", "1"}
