"""Every version in the specs of the devices, also those without outputs of their own."""

from __future__ import annotations

from functools import cache

import pytest

from fieldspec.codec.layout.device import device_layout
from fieldspec.language.checks import table as checks
from fieldspec.language.model.device import Device
from fieldspec.language.reading.project import Project, read
from layouts import SPECS


@cache
def project() -> Project:
    return read({path.relative_to(SPECS).as_posix(): path.read_bytes() for path in sorted(SPECS.rglob("*.yaml"))})


def device_at(name: str, version: str) -> Device:
    device, findings = project().devices[name].at(version)
    assert findings == [], version
    return device


FIRMWARE = {
    "tc100": ["before-2.0", "2.0"],
    "esc11": ["before-1.17", "1.17"],
    "ck10": ["1"],
    "hiwin-e": [
        *("before-2.8.16", "2.8.16", "2.12.5", "2.14.4", "before-3.12.5", "3.12.5", "3.14.4", "before-4.14.4", "4.14.4")
    ],
}
BESIDE = {"tc100": ["V1", "V2"], "hiwin-e": ["E1", "E2", *(f"manual-1.{edition}" for edition in range(8))]}
"""Versions that are combined with a firmware: hardware, series, editions of the manual."""

LEFT_OUT = {"4.14.4+E1": ("parameter_numbers_ascending",)}
"""Facts of the other series alone leave gaps in the numbers that the manual prints."""

ALL = [(name, version) for name, versions in FIRMWARE.items() for version in versions]
JOINED = [(name, f"{FIRMWARE[name][-1]}+{other}") for name, others in BESIDE.items() for other in others]


def test_all_versions_in_the_manuals_are_present() -> None:
    for name, spec in project().devices.items():
        declared = set(spec.lines.place) or {"1"}
        assert declared == {*FIRMWARE[name], *BESIDE.get(name, ())}, name


@pytest.mark.parametrize(("name", "version"), [*ALL, *JOINED])
def test_a_version_passes_the_checks_whether_it_is_built_or_not(name: str, version: str) -> None:
    findings = [
        finding for finding in checks.run(device_at(name, version)) if finding.code not in LEFT_OUT.get(version, ())
    ]
    assert [finding.message for finding in findings] == []


def test_versions_of_lines_that_are_not_built_have_the_wire_layout_of_a_built_one() -> None:
    spec = project().devices["hiwin-e"]
    built = {device_layout(device_at("hiwin-e", version)).identity for version in spec.versions()}
    others = [version for version in FIRMWARE["hiwin-e"] if version not in spec.versions()]
    assert len(others) == 5
    assert {device_layout(device_at("hiwin-e", version)).identity for version in others} <= built


@pytest.mark.parametrize(("name", "version"), ALL)
def test_versions_that_are_built_differ_on_the_wire(name: str, version: str) -> None:
    identities = [device_layout(device_at(name, version)).identity for version in project().devices[name].versions()]
    assert len(set(identities)) == len(identities)
