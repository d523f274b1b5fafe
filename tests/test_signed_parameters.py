"""Signed parameters in unsigned fields of messages, and the other way round: their bits go over the wire."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from external_tools import require_tool
from fieldspec.cli import main
from fieldspec.language.model.encoding import is_signed
from fieldspec.targets.js.backend import files, shared
from fieldspec.testing import SimulatedDevice, simulation
from fieldspec.tools.simulator.codecs import device_module
from layouts import layouts

SPEC = """
device:
  id: parbox
  name: Parameter box
  vendor: Example Works
  manual: {{title: "Parameter box, manual", file: box.txt, sha256: "{hash}", lines: 200}}
links:
  - name: bus
    source: 2 L10
    transmission: binary
    start: "AA"
    byte_order: little
    request: &frame
      - {{name: length, role: length, type: u8, measures: {{from: command, to: body}}}}
      - {{name: command, role: code, type: u8}}
      - {{name: body, role: body}}
      - {{name: crc, role: checksum, algorithm: crc16_ibm_3740, byte_order: big}}
    response: *frame
flags:
  - {{name: inputs, type: u{bits}, source: 3 L45, bits: [{{bit: 0, name: door}}, {{bit: 12, name: lamp}}]}}
enums:
  - name: mode
    source: 3 L46
    sparse: true
    members: [{{value: -2, name: reverse}}, {{value: 0, name: stop}}, {{value: 1, name: forward}}]
messages:
  - name: read_parameter
    code: 0x20
    source: 2 L25
    request: [{{name: number, type: u8, parameter: {{set: settings, part: number}}}}]
    response:
      - {{name: number, type: u8, same_as: number, parameter: {{set: settings, part: number}}}}
      - {{name: value, type: {sign}{bits}, parameter: {{set: settings, part: value, number: number}}}}
  - name: write_parameter
    code: 0x21
    source: 2 L26
    request:
      - {{name: number, type: u8, parameter: {{set: settings, part: number}}}}
      - {{name: value, type: {sign}{bits}, parameter: {{set: settings, part: value, number: number}}}}
    response: [{{name: number, type: u8, same_as: number, parameter: {{set: settings, part: number}}}}]
parameters:
  - name: settings
    title: Settings
    source: 4 L60
    type: u{bits}
    rows:
      - {{number: 1, name: ramp, unit: ms, access: rw, source: 4 L61}}
      - number: 2
        name: zero_offset
        type: i{bits}
        scale: 0.001
        unit: mm
        range: -30000..30000
        access: rw
        source: 4 L62
      - {{number: 3, name: mask, flags: inputs, access: rw, source: 4 L63}}
      - {{number: 4, name: mode, type: i{bits}, enum: mode, access: rw, source: 4 L64}}
"""
SIZES = [("u", 16), ("u", 24), ("u", 32), ("i", 16), ("i", 24), ("i", 32)]


@pytest.fixture(params=SIZES, ids=lambda size: f"{size[0]}{size[1]}")
def box(request: pytest.FixtureRequest, tmp_path: Path) -> tuple[int, Path]:
    """The bytes of a value, and the folder of the specs of a device with it."""
    sign, bits = request.param
    (tmp_path / "parbox").mkdir()
    text = SPEC.format(sign=sign, bits=bits, hash="4" * 64)
    (tmp_path / "parbox" / "device.yaml").write_text(text, "utf-8")
    return bits // 8, tmp_path


@pytest.fixture
def device(box: tuple[int, Path]) -> Iterator[SimulatedDevice]:
    with simulation("parbox", ports={"bus": "tcp://127.0.0.1:0"}, folder=str(box[1])) as device:
        yield device


def encoded(folder: Path, capsys: pytest.CaptureFixture[str], number: str, value: str) -> tuple[int, bytes, str]:
    """The exit code, the bytes of the value in the frame, and what is wrong."""
    capsys.readouterr()
    code = main(["encode", "parbox", "write_parameter", f"number={number}", f"value={value}", "--specs", str(folder)])
    printed = capsys.readouterr()
    return code, bytes.fromhex(printed.out)[4:-2], printed.err


@pytest.mark.parametrize(
    ("number", "entered", "expected"),
    [
        ("2", "-1234", -1234),
        ("zero_offset", "-1.234mm", -1234),
        ("2", "1.5mm", 1500),
        ("3", "door", 1),
        ("mask", "door,lamp", 0x1001),
        ("3", "0x1001", 0x1001),
        ("mode", "reverse", -2),
        ("1", "5ms", 5),
    ],
)
def test_the_value_of_the_parameter_is_encoded(
    box: tuple[int, Path], capsys: pytest.CaptureFixture[str], number: str, entered: str, expected: int
) -> None:
    size, folder = box
    bits = (expected & ((1 << 8 * size) - 1)).to_bytes(size, "little")
    assert encoded(folder, capsys, number, entered) == (0, bits, "")


@pytest.mark.parametrize(
    ("number", "entered", "reason"),
    [
        ("2", "-31.234mm", "zero_offset is -31234"),
        ("3", "window", "not a bit of inputs: door, lamp"),
        ("4", "backward", "not a member of mode"),
        ("1", "-1", "out_of_range"),
        ("2", "5kg", "not a number"),
    ],
)
def test_a_value_that_the_parameter_does_not_take_is_refused(
    box: tuple[int, Path], capsys: pytest.CaptureFixture[str], number: str, entered: str, reason: str
) -> None:
    code, sent, error = encoded(box[1], capsys, number, entered)
    assert (code, sent) == (2, b"")
    assert reason in error


@pytest.mark.proof(6)
@pytest.mark.parametrize(
    ("name", "entered", "meaning"),
    [("zero_offset", "-1.234mm", "-1.234 mm"), ("mode", "reverse", "reverse"), ("mask", "lamp", "lamp")],
)
def test_a_parameter_is_written_saved_and_restored(
    box: tuple[int, Path],
    device: SimulatedDevice,
    capsys: pytest.CaptureFixture[str],
    name: str,
    entered: str,
    meaning: str,
) -> None:
    def live(*arguments: str) -> int:
        return main(["live", "parbox", *arguments, "--port", device.place, "--specs", str(box[1])])

    saved = str(box[1] / "saved.csv")
    assert live("write", f"{name}={entered}", "--yes") == 0
    assert live("backup", saved) == 0
    assert live("write", f"{name}=0", "--yes") == 0
    assert live("restore", saved, "--yes") == 0
    capsys.readouterr()
    assert live("read", name) == 0
    assert meaning in capsys.readouterr().out


def test_javascript_has_the_number_of_the_field(box: tuple[int, Path]) -> None:
    size, folder = box
    (layout,) = layouts(folder)["parbox"]
    package = folder / "package"
    for path, text in {**shared(), **files([layout])}.items():
        (package / path).parent.mkdir(parents=True, exist_ok=True)
        (package / path).write_text(text, "utf-8")
    module = package / "parbox" / "v1.js"
    program = f"""
        const {{ Settings }} = await import({json.dumps(str(module))});
        const {{ zeroOffset, ramp }} = Settings.parameters;
        const raw = zeroOffset.toRaw(-1234);
        const back = [zeroOffset.fromRaw(raw), zeroOffset.fromRaw(-1234), ramp.fromRaw(ramp.toRaw(40000))];
        console.log(JSON.stringify([raw, zeroOffset.toRaw(-1234, {{ unsigned: true }}), ramp.toRaw(40000), ...back]));
    """
    run = subprocess.run(
        [require_tool("node"), "--input-type=module", "-e", program], capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr
    field = next(iter(layout.messages["write_parameter"].request.fields[1:]))
    span, has_sign = 1 << 8 * size, is_signed(field.primitive.encoding)
    long = 40000 - span if has_sign and size == 2 else 40000
    assert json.loads(run.stdout) == [-1234 if has_sign else span - 1234, span - 1234, long, -1234, -1234, 40000]
    python = device_module(layout).settings
    assert [python.ZERO_OFFSET.to_raw(-1234), python.RAMP.to_raw(40000)] == [
        -1234 if has_sign else span - 1234,
        long,
    ]
