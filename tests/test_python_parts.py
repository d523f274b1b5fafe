"""A large device is several modules in Python, which are compiled one by one, and used as one."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.pipeline import layouts as layouts_of
from fieldspec.command.pipeline import load
from fieldspec.targets.python import parts
from fieldspec.targets.python.backend import files, shared
from layouts import TEST_SPECS, layouts

sys.path.insert(0, str(Path(__file__).parent.parent / "benchmarks"))

from peers import registers

ASKED = """
import sys
from fieldspec_devices.{package} import {module} as device
names = sorted(name for name in device.__all__)
assert all(hasattr(device, name) for name in names)
print(names)
for register in device.REGISTERS:
    print(register)
"""


def devices_large_in_parts() -> list[DeviceLayout]:
    return [versions[-1] for versions in layouts(TEST_SPECS).values() if len(versions[-1].registers) > 3]


LAYOUTS = devices_large_in_parts()


def write_package(folder: Path, layout: DeviceLayout) -> list[str]:
    """Writes the package of a device; the paths of its modules."""
    own = files([layout])
    for path, text in {**shared(), **own}.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text, "utf-8")
    return list(own)


def answer(folder: Path, module: str) -> str:
    """What a program prints of a device."""
    package, name = module.removesuffix(".py").split("/")[1:]
    program = ASKED.format(package=package, module=name)
    environment = {**os.environ, "PYTHONPATH": str(folder)}
    return subprocess.run(
        [sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=True
    ).stdout


@pytest.mark.proof(6)
@pytest.mark.parametrize("layout", LAYOUTS, ids=[layout.device.id for layout in LAYOUTS])
def test_a_device_in_parts_has_the_names_and_registers_of_one_in_a_piece(
    layout: DeviceLayout, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    module, *_ = write_package(tmp_path / "whole", layout)
    expected = answer(tmp_path / "whole", module)
    monkeypatch.setattr(parts, "MOST", 300)
    paths = write_package(tmp_path / "parts", layout)
    assert len([path for path in paths if re.search(r"/_v\w+_\d+\.py$", path)]) > 1
    assert answer(tmp_path / "parts", module) == expected


def test_the_first_import_of_many_registers_takes_little_memory(tmp_path: Path) -> None:
    project = load({path: text.encode() for path, text in registers.spec(4000).items()})
    (device,) = project.devices.values()
    module = write_package(tmp_path, layouts_of(device)[-1])[0].removesuffix(".py").replace("/", ".")
    program = f"import {module}; print(open('/proc/self/status').read())"
    environment = {**os.environ, "PYTHONPATH": str(tmp_path), "PYTHONDONTWRITEBYTECODE": "1"}
    run = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=True)
    kilobytes = re.search(r"VmHWM:\s+(\d+) kB", run.stdout)
    assert kilobytes is not None
    assert int(kilobytes[1]) < 100_000
