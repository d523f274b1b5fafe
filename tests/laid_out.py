"""Layouts of specs, for the tests of what is made from them."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from fieldspec.diagnostics import has_errors
from fieldspec.layout.device import DeviceLayout, device_layout
from fieldspec.reading.project import read

SPECS = Path(__file__).parent.parent / "specs"
MADE_UP = Path(__file__).parent / "specs"


@cache
def layouts(root: Path) -> dict[str, list[DeviceLayout]]:
    """The layouts of all devices of a folder of specs: their versions, the oldest first."""
    files = {path.relative_to(root).as_posix(): path.read_bytes() for path in sorted(root.rglob("*.yaml"))}
    found: dict[str, list[DeviceLayout]] = {}
    for name, spec in read(files).devices.items():
        versions = [spec.at(version) for version in spec.versions()]
        if not any(has_errors(findings) for _, findings in versions):
            found[name] = [device_layout(device) for device, _ in versions]
    return found


def all_layouts() -> list[DeviceLayout]:
    """All versions of all devices, the real and the made-up ones."""
    return [laid for root in (SPECS, MADE_UP) for versions in layouts(root).values() for laid in versions]


def newest(root: Path, device: str) -> DeviceLayout:
    """The newest version of a device."""
    return layouts(root)[device][-1]
