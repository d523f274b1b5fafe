"""Codes of messages are constants of a type that holds them."""

from __future__ import annotations

import pytest

from fieldspec.codec.layout.device import device_layout
from fieldspec.targets.controllers.structured.program import program
from fieldspec.targets.st.backend import text
from spec_files import project

SPEC = """
links:
  - name: line
    source: 1 L1
    encoding: binary
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
