"""Layouts of the real and the made-up specs, for the tests of outputs."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from fieldspec.codec.layout.characters import character_refusals
from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import read

SPECS = Path(__file__).parent.parent / "specs"
TEST_SPECS = Path(__file__).parent / "specs"


@cache
def layouts(root: Path) -> dict[str, list[DeviceLayout]]:
    """The layouts of all devices of a folder of specs: their versions, the oldest first."""
    files = {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in sorted(SPECS.glob("protocols/*.yaml"))}
    files |= {path.relative_to(root).as_posix(): path.read_bytes() for path in sorted(root.rglob("*.yaml"))}
    project = read(files)
    assert not has_errors(project.findings), project.findings[0].message
    return {name: [layout_at(spec, version) for version in spec.versions()] for name, spec in project.devices.items()}


def layout_at(spec: DeviceSpec, version: str) -> DeviceLayout:
    """The layout of a device at a version. Raises AssertionError if the spec has errors."""
    device, findings = spec.at(version)
    assert not has_errors(findings), findings[0].message
    return device_layout(device)


def all_layouts() -> list[DeviceLayout]:
    """All versions of all devices, the real and the made-up ones."""
    return [layout for root in (SPECS, TEST_SPECS) for versions in layouts(root).values() for layout in versions]


def has_digits(layout: DeviceLayout) -> bool:
    """Whether numbers of a device are sent as digits, packed into bits, optional or counted in bits, or tell the end
    of a list, or count bytes of elements that differ in size. Several outputs leave these out.
    """
    bodies = (*layout.records.values(), *(body for message in layout.messages.values() for body in message.bodies))
    fields = [field for body in bodies for field in body.fields]
    return bool(character_refusals(layout, "")) or any(
        field.packing or field.presence or field.continuation or field.counts_sent for field in fields
    )


def newest(root: Path, device: str) -> DeviceLayout:
    """The newest version of a device."""
    return layouts(root)[device][-1]
