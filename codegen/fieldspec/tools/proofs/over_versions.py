"""Findings of all versions of a device together: each once, with the versions that it is about."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from fieldspec.foundation.classes import replace
from fieldspec.language.checks.finding import allowances, enumeration
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device

_Key = tuple[str, str, str, int]


def without_needed(
    devices: Mapping[str, Device], by_version: Mapping[str, Sequence[Diagnostic]]
) -> dict[str, list[Diagnostic]]:
    """The findings by version, without findings of allowances that another version needs.

    A fact that one version has may leave a hole in the others, and a spec has only one place to allow it.
    """
    of_allowances = {
        version: {_key(finding) for finding in findings if finding.code == "allowances_used"}
        for version, findings in by_version.items()
    }
    if not any(of_allowances.values()):
        return {version: [*findings] for version, findings in by_version.items()}
    needed_keys: set[_Key] = set()
    for version, keys in of_allowances.items():
        stated = {
            (allowance.fact.place["allow"].file.path, allowance.fact.place["allow"].start)
            for allowance in allowances(devices[version])
        }
        other_keys = set().union(*of_allowances.values()) - keys
        needed_keys |= {key for key in other_keys if key[2:] in stated}
    return {
        version: [finding for finding in findings if _key(finding) not in needed_keys]
        for version, findings in by_version.items()
    }


def of_versions(by_version: Mapping[str, Sequence[Diagnostic]], versions: Sequence[str]) -> Iterator[Diagnostic]:
    """The findings of some versions, each once. The text of one that not all versions have names those that do."""
    having: dict[_Key, list[str]] = {}
    first: dict[_Key, Diagnostic] = {}
    for findings in by_version.values():
        for finding in findings:
            first.setdefault(_key(finding), finding)
    for version in versions:
        for key in {_key(finding): None for finding in by_version[version]}:
            having.setdefault(key, []).append(version)
    for key, finding in first.items():
        own = having[key]
        if len(own) == len(versions):
            yield finding
        else:
            yield replace(finding, message=f"{finding.message} (in {enumeration(own)})")


def _key(finding: Diagnostic) -> _Key:
    return finding.code, finding.message, finding.span.file.path, finding.span.start
