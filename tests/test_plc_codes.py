"""Codes of messages are constants of a type that holds them."""

from __future__ import annotations

import pytest

from fieldspec.codec.layout.device import device_layout
from fieldspec.targets.controllers.structured.program import program
from fieldspec.targets.st.backend import text
from layouts import layout_at
from spec_files import gadget, project

SPEC = """
links:
  - name: line
    source: 1 L1
    transmission: binary
    byte_order: big
    request: &frame [{name: code, role: code, type: u40}, {name: body, role: body}]
    response: *frame
messages:
  - {name: read, code: %d, source: 1 L2, request: [], response: [{name: value, type: u8}]}
"""


DIGITS = {"UINT": 4, "UDINT": 8, "ULINT": 16}


@pytest.mark.parametrize(
    ("code", "kind"), [(0xFFFF, "UINT"), (0x10000, "UDINT"), (0xFFFFFFFF, "UDINT"), (0x100000000, "ULINT")]
)
def test_a_code_has_a_type_that_holds_it(code: int, kind: str) -> None:
    result = project(SPEC % code)
    assert result.findings == []
    device, findings = result.devices["gadget"].at("1")
    assert findings == []
    assert f"READ_CODE : {kind} := 16#{code:0{DIGITS[kind]}X}" in text(program(device_layout(device)))


REGISTERS = """
registers:
  - group: all
    section: "1"
    rows:
      - {at: 0x10, name: speed, type: u16, count: 3, source: L1}
      - {at: 0x20, name: speed_count, type: u16, source: L2}
"""


def test_a_constant_of_the_spec_keeps_its_name_and_one_that_we_add_gives_way() -> None:
    lines = text(program(layout_at(gadget(REGISTERS), "1"))).splitlines()
    constants = [line.partition(";")[0].split() for line in lines if "SPEED_COUNT" in line and ":=" in line]
    (of_spec,) = [words for words in constants if words[-1] == "16#0020"]
    (added,) = [words for words in constants if words[-1] == "3"]
    assert of_spec[0].endswith("SPEED_COUNT")
    assert added[0].startswith(of_spec[0])
    assert added[0] != of_spec[0]
