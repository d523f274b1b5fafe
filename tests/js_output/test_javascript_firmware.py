"""The JavaScript of a device selects the module of a version by the firmware that the device reports."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import pytest

from external_tools import require_tool
from fieldspec.command import pipeline
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import read
from fieldspec.targets.js.backend import files, shared
from layouts import SPECS, layout_at
from test_python_firmware import DETECTIONS, MILL, detecting_spec

PROGRAM = """
const device = await import(process.argv[1]);
const runtime = await import(process.argv[2]);
const results = [];
for (const [value, nearest] of JSON.parse(process.argv[3])) {
  try {
    results.push((await device.forFirmware(value, { nearest })).VERSION);
  } catch (error) {
    if (!(error instanceof runtime.UnknownFirmwareError)) throw error;
    results.push([error.message, error.known]);
  }
}
console.log(JSON.stringify(results));
"""


def chosen(folder: Path, spec: DeviceSpec, values: list[Any], nearest: bool = False, whole: bool = False) -> list[Any]:
    """The versions whose modules are chosen, or the texts and the known versions of refusals."""
    versions = pipeline.layouts(spec) if whole else [layout_at(spec, version) for version in spec.versions()]
    for path, text in {**shared(), **files(versions)}.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text, "utf-8")
    places = [str(folder / spec.id / "index.js"), str(folder / "runtime/index.js")]
    asked = json.dumps([[value, nearest] for value in values])
    command = [require_tool("node"), "--input-type=module", "-e", PROGRAM, *places, asked]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    results: list[Any] = json.loads(run.stdout)
    return results


@pytest.fixture
def mill() -> DeviceSpec:
    """A device with two lines of firmware."""
    return read({"mill/device.yaml": MILL.encode()}).devices["mill"]


def test_a_firmware_has_the_module_of_its_version(tmp_path: Path, mill: DeviceSpec) -> None:
    expected = {
        "2.8.16": "2.8.16",
        " V2.08.16\0": "2.8.16",
        "before-2.8.16": "before-2.8.16",
        "2.8.15": "before-2.8.16",
        "2.0": "before-2.8.16",
        "3.12.5.0": "3.12.5",
        "3.0.1": "before-3.12.5",
        "3.20.0-rc1": "3.20.0-rc1",
    }
    assert chosen(tmp_path, mill, list(expected)) == list(expected.values())


def test_what_the_spec_does_not_know_is_refused_with_what_it_knows(tmp_path: Path, mill: DeviceSpec) -> None:
    unknown = ["2.12.6", "2.10", "4.0", "1.9", "", "two", "2..8", "-2.8", "\uff12.8", "3.20.0", "9" * 5000]
    known = ["before-2.8.16", "2.8.16", "2.12.5", "before-3.12.5", "3.12.5", "3.20.0-rc1"]
    for result in chosen(tmp_path, mill, unknown):
        assert result[1] == known
        assert f"known are {', '.join(known)}" in result[0]


def test_the_nearest_one_below_is_taken_if_that_is_asked_for(tmp_path: Path, mill: DeviceSpec) -> None:
    results = chosen(tmp_path, mill, ["2.12.6", "2.10", "3.99", "4.0", "two"], nearest=True)
    assert results[:3] == ["2.12.5", "2.8.16", "3.12.5"]
    assert all(isinstance(result, list) for result in results[3:])


@pytest.mark.parametrize("keys", DETECTIONS)
def test_a_number_that_the_device_sends_chooses_the_version(tmp_path: Path, keys: str) -> None:
    spec = detecting_spec(keys)
    values = [value for value, _ in DETECTIONS[keys]]
    results = chosen(tmp_path, spec, [*values, -1, 999, 1 << 20, 0.5])
    assert results[: len(values)] == [version for _, version in DETECTIONS[keys]]
    assert all("known are" in result[0] for result in results[len(values) :])


def test_versions_of_lines_that_are_alike_share_their_modules(tmp_path: Path) -> None:
    texts = {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in SPECS.rglob("*.yaml")}
    spec = read(texts, frozenset(["hiwin-e"])).devices["hiwin-e"]
    results = chosen(tmp_path, spec, ["2.12.5", "3.12.5", "3.1.0", "4.14.4", "4.2", "2.1"], whole=True)
    assert results == ["2.12.5", "2.12.5", "2.8.16", "2.14.4", "2.12.5", "before-2.8.16"]
