"""Runs the comparison of each version with the one before it, to judge what a spec accepts of it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.reading.project import DeviceSpec

if TYPE_CHECKING:
    from fieldspec.changes.judging import Compared


def previous(spec: DeviceSpec, version: str) -> str | None:
    """The version that another one is based on, or that comes before it on its line; None for the first one."""
    if version in spec.bases:
        return spec.bases[version]
    place = spec.lines.place.get(version)
    before = [one for one, (line, order) in spec.lines.place.items() if place and (line, order + 1) == place]
    return before[0] if before else None


def accepted(spec: DeviceSpec) -> list[Diagnostic]:
    """The findings of the acceptances that belong to versions; those of the spec are judged by a comparison with it."""
    if not any("accepts" in tree.values for tree in (spec.tree, *spec.trees.values())):
        return []
    from fieldspec.changes import RULES
    from fieldspec.changes.judging import accepts_used, rules_known

    devices = {version: spec.at(version)[0] for version in spec.versions()}
    rules = {name for name, _, _ in RULES}
    named = (one for device in devices.values() for one in device.accepts)
    return [*rules_known(named, rules), *accepts_used([*_steps(spec, devices)])]


def _steps(spec: DeviceSpec, devices: Mapping[str, Device]) -> Iterator[Compared]:
    from fieldspec.changes import changes
    from fieldspec.changes.judging import Compared

    for version, new in devices.items():
        before = previous(spec, version)
        if before is not None and any(version in one.since for one in new.accepts):
            old = devices[before] if before in devices else spec.at(before)[0]
            yield Compared(old, new, changes(old, new), step=True)
