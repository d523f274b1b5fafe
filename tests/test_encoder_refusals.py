"""No encoder writes what a device would take for something else: all of them refuse it, for the same reason."""

from __future__ import annotations

import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from external_tools import require_tool
from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.reading.project import read
from fieldspec.targets.c.backend import files
from fieldspec.tools.proofs.running import outcome
from random_devices.c_driver import REASONS
from random_devices.javascript_judge import JavaScript
from random_devices.python_judge import Python
from random_devices.queries import Query
from random_devices.reference_answers import Reference

SPEC = """
device:
  id: faucet
  name: Faucet
  vendor: Maker
  manual: {title: Manual, file: faucet.txt, sha256: "DIGEST", lines: 100}
links:
  - name: bus
    title: A bus
    source: 1 L1
    transmission: binary
    byte_order: big
    word_order: big
    request: &bus
      - {name: station, role: unit_address, type: u8}
      - {name: command, role: code, type: u8}
      - {name: body, role: body}
      - {name: crc, role: checksum, algorithm: crc16_modbus}
    response: *bus
    unit_addresses: {range: 1..16, broadcast: 0, source: 1 L1}
enums:
  - {name: mode, source: 1 L2, members: [{name: slow, value: 1}, {name: fast, value: 2}]}
messages:
  - name: pour
    code: 0x10
    source: 2 L1
    request:
      - {name: amount, type: u16, range: 1..100}
      - {name: offset, type: i16, range: -50..50}
      - {name: mode, type: u8, enum: mode}
      - {name: speed, type: f32, range: 0..100}
      - {name: gain, type: f32}
      - {name: title, type: text, length: 4}
      - {name: mark, type: u8, const: 0x55}
      - {name: times, type: u16, repeat: 1..3}
    response: []
registers:
  - group: settings
    title: Settings
    section: "3"
    source: L1
    defaults: {type: i16}
    rows:
      - {at: 0, name: level, unit: V, scale: 0.1, access: rw, sentinels: [{value: -32768, name: broken}], source: L2}
      - {at: 1, name: flow, unit: V, scale: 0.1, range: 0..500, access: rw, write_range: 0..10, source: L3}
      - {at: 2, name: start, type: u16, access: wo, trigger: true, enum: mode, source: L4}
""".replace("DIGEST", "0" * 64)

NAN, INFINITY = float("nan"), float("inf")
RIGHT: dict[str, Any] = {
    "station": 1,
    "amount": 5,
    "offset": -3,
    "mode": 2,
    "speed": 2.5,
    "gain": 0.5,
    "title": "ab",
    "times": [1, 2],
}
ATTACKS: list[tuple[str, dict[str, Any], str]] = [
    ("a number below its range", {"amount": 0}, "out_of_range"),
    ("a number above its range", {"amount": 101}, "out_of_range"),
    ("a negative number below its range", {"offset": -51}, "out_of_range"),
    ("a number that no enum lists", {"mode": 3}, "unknown_value"),
    ("a fraction beyond its range", {"speed": 100.5}, "out_of_range"),
    ("no number where there is a range", {"speed": NAN}, "out_of_range"),
    ("infinity where there is a range", {"speed": INFINITY}, "out_of_range"),
    ("a list that is too long", {"times": [1, 2, 3, 4]}, "wrong_length"),
    ("a list that is too short", {"times": []}, "wrong_length"),
    ("a station that the link does not have", {"station": 17}, "out_of_range"),
]
"""What every encoder can be asked: values in place of the right ones, and the reason of the refusal."""

MORE_ATTACKS: list[tuple[str, dict[str, Any], str]] = [
    ("a number that does not fit its bits", {"amount": 65536 + 5}, "out_of_range"),
    ("a negative number without a sign", {"amount": -1}, "out_of_range"),
    ("a fraction that its bits cannot hold", {"gain": 1e39}, "out_of_range"),
    ("an element that does not fit its bits", {"times": [65536]}, "out_of_range"),
    ("a station that does not fit its bits", {"station": 257}, "out_of_range"),
    ("a fraction for a whole number", {"amount": 5.5}, "wrong_type"),
    ("a text for a number", {"amount": "5"}, "wrong_type"),
    ("a text for a fraction", {"gain": "0.5"}, "wrong_type"),
    ("a number for a text", {"title": 4}, "wrong_type"),
    ("a text with a zero, at which a device would stop", {"title": "a\0b"}, "unknown_value"),
    ("a text that is not ASCII", {"title": "\xe9"}, "unknown_value"),
    ("a text that is too long", {"title": "abcde"}, "wrong_length"),
]
"""What the types of C rule out: there the compiler converts, and a text is an array."""


@pytest.fixture(scope="module")
def layout() -> DeviceLayout:
    project = read({"faucet/device.yaml": SPEC.encode()})
    assert not has_errors(project.findings), project.findings[0].message
    spec = project.devices["faucet"]
    assert outcome(spec).findings == []
    return device_layout(spec.at(spec.versions()[0])[0])


def encoding(layout: DeviceLayout, changed: Mapping[str, Any]) -> Query:
    """The question for a frame with some values in place of the right ones."""
    shape = layout.messages["pour"].request
    return Query("frame", ("bus", "request", "pour"), values={**RIGHT, **changed}, code=0x10, shape=shape)


@pytest.mark.parametrize("judge", [Reference, Python, JavaScript])
def test_what_a_device_would_misread_is_refused(judge: Any, layout: DeviceLayout, tmp_path: Path) -> None:
    attacks = [("the right values", {}, ""), *ATTACKS, *MORE_ATTACKS]
    queries = [encoding(layout, changed) for _, changed, _ in attacks]
    if judge is Reference:
        reasons = [Reference(layout).answer(query).reason for query in queries]
    else:
        reasons = [answer.reason for answer in judge(layout, tmp_path, 1).answers(queries)]
    assert dict(zip([title for title, *_ in attacks], reasons, strict=True)) == {
        title: reason for title, _, reason in attacks
    }


def c_statements(values: Mapping[str, Any]) -> str:
    """The statements that fill the request, and print the status of its encoder."""
    times = values["times"]
    elements = "".join(f" in.times[{at}] = {number};" for at, number in enumerate(times[:3]))
    numbers = {float("inf"): "INFINITY"}
    speed = "NAN" if values["speed"] != values["speed"] else numbers.get(values["speed"], values["speed"])
    assignments = "".join(f" in.{name} = {values[name]};" for name in ("amount", "offset", "gain"))
    return (
        f"{{ faucet_pour_request in = {{0}};{assignments} in.mode = (faucet_mode){values['mode']}; in.speed = {speed};"
        f' strcpy(in.title, "{values["title"]}"); in.times_count = {len(times)};{elements}'
        f' printf("%d\\n", (int)faucet_bus_encode_pour_request({values["station"]}, &in, out, sizeof out, &length)); }}'
    )


def test_c_refuses_the_same(layout: DeviceLayout, tmp_path: Path) -> None:
    for path, text in files([layout]).items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    header = next(path for path in files([layout]) if path.endswith(".h"))
    statements = [c_statements({**RIGHT, **changed}) for changed in ({}, *(changed for _, changed, _ in ATTACKS))]
    source = tmp_path / "main.c"
    source.write_text(
        f'#include <math.h>\n#include <stdio.h>\n#include <string.h>\n#include "{header}"\n'
        "int main(void) { uint8_t out[64]; size_t length;\n" + "\n".join(statements) + "\nreturn 0; }\n",
        "utf-8",
    )
    command = [require_tool("gcc"), "-std=c99", "-w", "-o", str(tmp_path / "main"), str(source)]
    compiled = subprocess.run(command, capture_output=True, text=True, check=False)
    assert compiled.returncode == 0, compiled.stderr
    printed = subprocess.run([str(tmp_path / "main")], capture_output=True, text=True, check=True).stdout
    reasons = ["" if number == "0" else REASONS[int(number)] for number in printed.split()]
    assert reasons == ["", *(reason for *_, reason in ATTACKS)]


@pytest.mark.parametrize(
    ("register", "quantity"),
    [("LEVEL", -3276.8), ("LEVEL", 1e9), ("LEVEL", NAN), ("LEVEL", INFINITY), ("FLOW", 1.1), ("FLOW", -0.1)],
)
def test_a_quantity_never_becomes_an_absent_value_or_a_count_out_of_range(
    register: str, quantity: float, layout: DeviceLayout, tmp_path: Path
) -> None:
    judge = Python(layout, tmp_path, 1)
    constant = getattr(judge.module, register)
    with pytest.raises(judge.error) as refused:
        constant.encode(constant.from_unit(quantity))
    assert refused.value.reason == "out_of_range"


def test_a_trigger_is_written_with_what_its_enum_lists_alone(layout: DeviceLayout, tmp_path: Path) -> None:
    judge = Python(layout, tmp_path, 1)
    assert judge.module.START.encode(2) == b"\0\2"
    with pytest.raises(judge.error) as refused:
        judge.module.START.encode(3)
    assert refused.value.reason == "unknown_value"
