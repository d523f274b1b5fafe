"""The package of a device selects the module of a version by the firmware that the device reports."""

from __future__ import annotations

import importlib
import pickle
import subprocess
import sys
import tempfile
from functools import cache
from pathlib import Path
from types import ModuleType

import pytest

from fieldspec.command import pipeline
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import read
from fieldspec.targets.python.backend import files, shared
from layouts import SPECS, layout_at, layouts
from python_package import NAME, package, write

MILL = """
device: {id: mill, name: Mill, vendor: Making, manual: {title: T, language: en, file: f, sha256: "%s", lines: 9}}
versions:
  - line: line_2
    builds: true
    members: [{id: before-2.8.16, source: L1}, {id: 2.8.16, source: L1}, {id: 2.12.5, source: L1}]
  - line: line_3
    builds: true
    members: [{id: before-3.12.5, source: L1}, {id: 3.12.5, source: L1}, {id: 3.20.0-rc1, source: L1}]
registers:
  - group: all
    source: L1
    defaults: {access: rw}
    rows: [{name: latest, at: 1, type: u16}, {name: for_firmware, at: 2, type: u16}]
""" % ("0" * 64)


@pytest.fixture(scope="module")
def mill(tmp_path_factory: pytest.TempPathFactory) -> ModuleType:
    """A device with two lines of firmware, in a package of its own."""
    spec = read({"mill/device.yaml": MILL.encode()}).devices["mill"]
    texts = {**shared(), **files([layout_at(spec, version) for version in spec.versions()])}
    folder = tmp_path_factory.mktemp("mill")
    write(folder, {path.replace("fieldspec_devices", "mill_devices", 1): text for path, text in texts.items()})
    sys.path.insert(0, str(folder))
    try:
        return importlib.import_module("mill_devices.mill")
    finally:
        sys.path.remove(str(folder))


@cache
def alike() -> str:
    """A package with the device that has three lines of firmware, two of them like the first one."""
    files_of_specs = {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in SPECS.rglob("*.yaml")}
    spec = read(files_of_specs, frozenset(["hiwin-e"])).devices["hiwin-e"]
    folder = Path(tempfile.mkdtemp(prefix="fieldspec-alike-"))
    texts = {**shared(), **files(pipeline.layouts(spec))}
    write(folder, {path.replace("fieldspec_devices", "alike_devices", 1): text for path, text in texts.items()})
    sys.path.insert(0, str(folder))
    return "alike_devices"


@pytest.mark.parametrize(
    ("firmware", "version"),
    [
        ("2.8.16", "2.8.16"),
        (" V2.08.16\0", "2.8.16"),
        ("before-2.8.16", "before-2.8.16"),
        ("2.8.15", "before-2.8.16"),
        ("2.0", "before-2.8.16"),
        ("3.12.5.0", "3.12.5"),
        ("3.0.1", "before-3.12.5"),
        ("3.20.0-rc1", "3.20.0-rc1"),
    ],
)
def test_a_firmware_has_the_module_of_its_version(mill: ModuleType, firmware: str, version: str) -> None:
    assert version == mill.for_firmware(firmware).VERSION


@pytest.mark.parametrize(
    "firmware", ["2.12.6", "2.10", "4.0", "1.9", "", "two", "2..8", "-2.8", "\uff12.8", "3.20.0", "9" * 5000]
)
def test_what_the_spec_does_not_know_is_refused_with_what_it_knows(mill: ModuleType, firmware: str) -> None:
    with pytest.raises(LookupError) as caught:
        mill.for_firmware(firmware)
    assert type(caught.value).__name__ == "UnknownFirmwareError"
    assert caught.value.firmware == firmware  # type: ignore[attr-defined]
    assert "known are before-2.8.16, 2.8.16, 2.12.5, before-3.12.5, 3.12.5, 3.20.0-rc1" in str(caught.value)


@pytest.mark.parametrize(("firmware", "version"), [("2.12.6", "2.12.5"), ("2.10", "2.8.16"), ("3.99", "3.12.5")])
def test_the_nearest_one_below_is_taken_if_that_is_asked_for(mill: ModuleType, firmware: str, version: str) -> None:
    assert version == mill.for_firmware(firmware, nearest=True).VERSION


@pytest.mark.parametrize("firmware", ["4.0", "1.9", "two", ""])
def test_what_is_on_no_line_has_no_nearest_one(mill: ModuleType, firmware: str) -> None:
    with pytest.raises(LookupError):
        mill.for_firmware(firmware, nearest=True)


DETECTIONS = {
    "form: decimal, places: 2": [(280, "2.80"), (201, "2.1"), (7, "0.07"), (1212, "12.12"), (0xFFFF, "3.5")],
    "form: hexadecimal, places: 2": [(0x280, "2.80"), (0x1212, "12.12"), (0xFFFF, "3.5")],
    "form: bytes": [(0x0201, "2.1"), (0x0C0C, "12.12"), (0xFFFF, "3.5")],
    "form: decimal": [(12, "12"), (0xFFFF, "3.5")],
    "doc: Its form is not printed.": [(0xFFFF, "3.5"), ("v2.1", "2.1")],
}


def detecting_spec(keys: str) -> DeviceSpec:
    """A device whose version is in a register."""
    members = ", ".join(f'{{id: "{version}", source: L1}}' for version in ("0.07", "2.1", "2.80", "12", "12.12"))
    head = MILL.partition("versions:")[0]
    spec = f"""{head}versions:
  - line: firmware
    builds: true
    detected_by: {{fact: registers/firmware, {keys}}}
    members: [{members}, {{id: "3.5", detected_as: [0xFFFF], source: L1}}]
registers:
  - {{group: all, source: L1, rows: [{{name: firmware, at: 1, type: u16, access: ro}}]}}
"""
    return read({"mill/device.yaml": spec.encode()}).devices["mill"]


def detecting(keys: str, number: int) -> ModuleType:
    """The package of a device whose version is in a register."""
    device = detecting_spec(keys)
    texts = {**shared(), **files([layout_at(device, version) for version in device.versions()])}
    folder = Path(tempfile.mkdtemp(prefix="fieldspec-detecting-"))
    name = f"detecting_{number}"
    write(folder, {path.replace("fieldspec_devices", name, 1): text for path, text in texts.items()})
    sys.path.insert(0, str(folder))
    return importlib.import_module(f"{name}.mill")


@pytest.mark.parametrize("keys", DETECTIONS)
def test_a_number_that_the_device_sends_chooses_the_version(keys: str) -> None:
    package = detecting(keys, list(DETECTIONS).index(keys))
    assert package.DETECTED_BY == "registers/firmware"
    for value, version in DETECTIONS[keys]:
        assert version == package.for_firmware(value).VERSION
    for unknown in (-1, 999, 1 << 20):
        with pytest.raises(LookupError, match="known are"):
            package.for_firmware(unknown)


def test_what_tells_the_version_is_a_name_of_the_package() -> None:
    package()
    assert importlib.import_module(f"{NAME}.esc11").DETECTED_BY == "messages/read_version/response/version"


def test_the_exception_can_be_passed_between_processes() -> None:
    error = package().UnknownFirmwareError("9", ("1", "2"))
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.known) == (str(error), ("1", "2"))


def test_the_text_that_a_device_sends_is_taken_as_it_comes() -> None:
    package()
    device = importlib.import_module(f"{NAME}.esc11")
    (layout,) = (layout for layout in layouts(SPECS)["esc11"] if layout.device.version == "1.17")
    assert layout.identity == device.for_firmware(" 1.17 ").IDENTITY
    assert device.for_firmware(" 0.01 ").VERSION == "before-1.17"


@pytest.mark.parametrize(
    ("firmware", "version"),
    [
        ("2.12.5", "2.12.5"),
        ("3.12.5", "2.12.5"),
        ("3.1.0", "2.8.16"),
        ("4.14.4", "2.14.4"),
        ("4.2", "2.12.5"),
        ("2.1", "before-2.8.16"),
    ],
)
def test_versions_of_lines_that_are_alike_share_their_modules(firmware: str, version: str) -> None:
    assert version == importlib.import_module(f"{alike()}.hiwin_e").for_firmware(firmware).VERSION


def test_latest_is_the_newest_version_and_the_others_are_imported_when_they_are_asked_for(tmp_path: Path) -> None:
    write(tmp_path, {**shared(), **files(layouts(SPECS)["esc11"])})
    code = (
        "import sys; from fieldspec_devices import esc11\n"
        "assert esc11.latest.VERSION == esc11.LATEST == '1.17'\n"
        "assert 'fieldspec_devices.esc11.before_1_17' not in sys.modules\n"
        "assert esc11.for_firmware('1.0') is sys.modules['fieldspec_devices.esc11.before_1_17']\n"
    )
    done = subprocess.run([sys.executable, "-I", "-c", f"import sys; sys.path.insert(0, {str(tmp_path)!r})\n{code}"])
    assert done.returncode == 0


def test_names_of_the_device_do_not_hide_those_of_the_package(mill: ModuleType) -> None:
    assert callable(mill.for_firmware)
    assert isinstance(mill.latest, ModuleType)
