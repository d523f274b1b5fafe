"""Texts for people have raw values as a spec writes them, not as Python does."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from command_line import CommandLine
from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.layout.value_texts import spec_text
from fieldspec.command.rendering.explanation_text import frame_table
from fieldspec.language.reading.project import read
from fieldspec.targets.js.backend import shared
from fieldspec.targets.js.explainer import explainer_files
from fieldspec.tools.proofs.running import outcome
from js_output.explanations import explained_by_node, explained_by_python
from layouts import SPECS, layout_at
from oven import FOLDER


@pytest.mark.parametrize(
    ("raw", "text"),
    [
        (12, "12"),
        (-0.5, "-0.5"),
        (math.inf, "inf"),
        (True, "true"),
        (b"\xff\x0a", "FF 0A"),
        ('say "ja"\n', r'"say \"ja\"\n"'),
        ([{"id": 1, "on": False}, {"id": 2, "on": True}], "[{id: 1, on: false}, {id: 2, on: true}]"),
        ((), "[]"),
        (None, "nothing"),
    ],
)
def test_a_value_is_written_as_in_a_spec(raw: object, text: str) -> None:
    assert spec_text(raw) == text


DIGEST = "0" * 64
SPEC = f"""
device:
  id: gadget
  name: Gadget
  vendor: Maker
  manual: {{title: Manual, file: gadget.txt, sha256: "{DIGEST}", lines: 100}}
links:
  - name: line
    source: 1 L1
    transmission: binary
    byte_order: big
    request: &frame [{{name: code, role: code, type: u8}}, {{name: body, role: body}}]
    response: *frame
messages:
  - name: go
    code: 1
    source: 1 L2
    request: [{{name: first, type: bytes, length: 2}}, {{name: targets, record: target, repeat: 1..3}}]
    response:
      - {{name: state, type: u16, flags: lamps}}
      - {{name: tag, type: bytes, length: 2}}
      - {{name: other, type: bytes, length: 2, same_as: first}}
records:
  - {{name: target, source: 1 L3, fields: [{{name: id, type: u8}}, {{name: tag, type: bytes, length: 2}}]}}
flags:
  - {{name: lamps, type: u16, bit_0: most, source: 1 L4, bits: [{{bit: 0, name: first}}, {{bits: 4..7, name: level}}]}}
examples:
  - id: one
    origin: computed
    link: line
    direction: request
    message: go
    frame: 01 07 08 01 AA BB 02 CC DD
    values: {{first: 07 08, targets: [{{id: 1, tag: AA BB}}, {{id: 2, tag: CC DE}}]}}
"""


def test_a_finding_names_the_value_in_a_list_that_differs() -> None:
    device = read({"gadget/device.yaml": SPEC.encode()}).devices["gadget"]
    texts = [finding.message for finding in outcome(device).findings]
    assert "targets[1].tag is CC DD in the bytes, but CC DE in the values" in texts


def test_bytes_that_are_no_digits_are_refused_as_bytes(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    text = (FOLDER / "oven/device.yaml").read_text("utf-8")
    for path in ("oven/device.yaml", "protocols/modbus.yaml"):
        (tmp_path / path).parent.mkdir()
    (tmp_path / "protocols/modbus.yaml").write_text((SPECS / "protocols/modbus.yaml").read_text("utf-8"), "utf-8")
    digits = text.replace("{name: hour, type: u8, range: 0..23,", "{name: hour, type: u8, digits: bcd, length: 1,")
    (tmp_path / "oven/device.yaml").write_text(digits, "utf-8")
    run = CommandLine(capsys, monkeypatch, tmp_path)
    result = run("encode", "oven", "write_registers", "station=1", "transaction=1", "address=257", "values=0xFA00")
    assert result.code == 2
    assert "programs[0].steps[0].begin.hour is FA: wrong: should be 2 BCD digits" in result.err


def test_bytes_have_a_raw_value_and_bits_say_how_the_manual_counts(tmp_path: Path) -> None:
    spec = read({"gadget/device.yaml": SPEC.replace("CC DE", "CC DD").encode()}).devices["gadget"]
    layout = layout_at(spec, "1")
    for path, text in {**shared(), **explainer_files(layout, "device/explain")}.items():
        place = tmp_path / path
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text, "utf-8")
    options = {"link": "line", "direction": "response"}
    frames = {"frame": "018a00aabbccdd", "request": "01070801aabb"}
    job = {"module": str(tmp_path / "device/explain.js"), "options": options, **frames}
    (have,) = explained_by_node([job])[0]
    assert have == explained_by_python(layout, job)
    state, other = (next(row for row in have["rows"] if row["path"] == path) for path in ("state", "other"))
    assert [meaning["bits"] for meaning in state["meanings"]][:2] == ["8..11", "15"]
    assert state["notes"] == [
        "Bit 0 is the least significant one here. The manual counts from the most significant: bit 15 is its bit 0."
    ]
    assert other["verdict"] == "wrong: should be 07 08"
    explanation = explained(
        layout, "line", "response", bytes.fromhex(frames["frame"]), "", bytes.fromhex("01070801aabb")
    )
    rows = {cells[2]: cells for cells in frame_table(layout, explanation).rows}
    assert "AA BB" in rows["tag"][3]
