"""Digits and other characters in a case of a last choice, in outputs that convert none."""

from __future__ import annotations

import pytest

from fieldspec.targets import OUTPUTS
from layouts import layout_at
from spec_files import gadget
from wireshark_output.expectations import Case, results

SPEC = """
enums: [{name: kinds, source: 1 L1, members: [{value: 1, name: shown}, {value: 2, name: raw}]}]
links:
  - name: line
    source: 1 L2
    transmission: binary
    byte_order: big
    frame: [{name: code, role: code, type: u8}, {name: body, role: body}]
messages:
  - name: go
    code: 1
    source: 1 L3
    request:
      - {name: kind, type: u8, enum: kinds}
      - name: value
        choice:
          by: kind
          cases:
            - {name: speed, when: [shown], type: u16, digits: upper_hex, length: 4}
            - {name: place, when: [raw], type: u16}
    response: []
"""
DEVICE = gadget(SPEC)
LAYOUT = layout_at(DEVICE, DEVICE.versions()[-1])


@pytest.mark.parametrize(
    ("output", "deed"),
    [
        ("wireshark", "messages/go/request/value/choice/cases/speed is shown as bytes"),
        ("queries", "message go is left out"),
        ("kv", "message go is left out"),
        ("st", "message go is left out"),
    ],
)
def test_an_output_that_converts_no_digits_names_a_case_with_them(output: str, deed: str) -> None:
    helps = [finding.help for finding in OUTPUTS[output].refusals([LAYOUT])]
    assert any(deed in help for help in helps), helps


@pytest.mark.parametrize(
    ("frame", "path", "value"),
    [
        ("01 01 30 31 41 42", "gadget.go.speed", "30:31:41:42"),
        ("01 01 30 31 7A 42", "gadget.go.speed", "30:31:7a:42"),
        ("01 02 00 07", "gadget.go.place", "7"),
    ],
)
def test_a_dissector_shows_the_digits_of_a_case_as_bytes(frame: str, path: str, value: str) -> None:
    ((_, items),) = results([Case(LAYOUT, "line", "request", "", b"", bytes.fromhex(frame))])
    assert (value, 44) in [(item.value, item.offset) for item in items if item.name == path]
