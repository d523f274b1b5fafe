"""Runs the comparison of each version with the one before it, to judge what a spec accepts of it."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes import RULES, changes
from fieldspec.changes.judging import Compared, accepts_used
from fieldspec.diagnostics import Diagnostic, has_errors
from fieldspec.reading.project import DeviceSpec


def previous(spec: DeviceSpec, version: str) -> str | None:
    """The version that another one is based on, or that comes before it on its line; None for the first one."""
    if version in spec.bases:
        return spec.bases[version]
    place = spec.lines.place.get(version)
    before = [one for one, (line, order) in spec.lines.place.items() if place and (line, order + 1) == place]
    return before[0] if before else None


def accepted(spec: DeviceSpec) -> list[Diagnostic]:
    """The findings of the acceptances that belong to versions; those of the spec are judged by a comparison with it."""
    return list(accepts_used([*_steps(spec)], {name for name, _, _ in RULES}))


def _steps(spec: DeviceSpec) -> Iterator[Compared]:
    for version in spec.versions():
        before = previous(spec, version)
        new, broken = spec.at(version)
        if before is None or has_errors(broken) or not any(version in one.since for one in new.accepts):
            continue
        old, _ = spec.at(before)
        yield Compared(old, new, changes(old, new), step=True)
