"""Messages whose fields are wider than the parameters that they write."""

from __future__ import annotations

from pathlib import Path

import pytest

from simulators import Unit

DEVICE = """
device:
  id: gauge
  name: Gauge
  vendor: Nobody
  manual: {{title: The manual, file: gauge.txt, sha256: "{0}", lines: 99}}
links:
  - name: line
    source: 1 L1
    byte_order: big
    word_order: big
    frame: [{{name: command, role: code, type: u8}}, {{name: body, role: body}}]
    exception_response: {{flag: 0x80, record: refusal}}
records:
  - {{name: refusal, source: 1 L1, fields: [{{name: error_number, type: u8, enum: reason}}]}}
enums:
  - {{name: reason, source: 1 L1, members: [{{value: 3, name: bad_value}}]}}
behaviour:
  - {{name: refuses_values, refuse: value_invalid, with: bad_value, source: 1 L2}}
messages:
  - name: read
    code: 1
    source: 1 L2
    request: [{{name: number, type: u16, parameter: {{set: drive, part: number}}}}]
    response: [{{name: value, type: {1}, parameter: {{set: drive, part: value, number: number}}}}]
  - name: write
    code: 2
    source: 1 L2
    request:
      - {{name: number, type: u16, parameter: {{set: drive, part: number}}}}
      - {{name: value, type: {1}, parameter: {{set: drive, part: value, number: number}}}}
    response: []
parameters:
  - name: drive
    source: 2 L1
    rows:
      - {{number: 1, name: level, type: i16, access: rw, default: 3, source: 2 L2}}
      - {{number: 2, name: limit, type: u16, access: rw, default: 4, source: 2 L3}}
"""


@pytest.mark.parametrize(
    ("kind", "number", "sent", "stored"),
    [
        ("i32", 1, -9, -9),
        ("i32", 2, 40000, 40000),
        ("u32", 1, 0xFFFF_FFF7, -9),
        ("u32", 1, 0x0000_FFF7, -9),
        ("i32", 1, 40000, None),
        ("i32", 1, 65539, None),
        ("i32", 2, -1, None),
        ("u32", 1, 65539, None),
        ("u32", 2, 65539, None),
    ],
)
def test_a_parameter_is_written_with_the_numbers_of_its_type_alone(
    tmp_path: Path, kind: str, number: int, sent: int, stored: int | None
) -> None:
    (tmp_path / "gauge").mkdir()
    (tmp_path / "gauge" / "device.yaml").write_text(DEVICE.format("0" * 64, kind), "utf-8")
    unit = Unit("gauge", "line", folder=str(tmp_path))
    if stored is None:
        assert unit.exception("write", number=number, value=sent) == 3
        return
    unit.ask("write", number=number, value=sent)
    assert unit.engine.memory.elements["drive", number, 0] == stored
