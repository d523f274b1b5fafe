"""`fieldspec diff`: the differences between two versions or two states of the specs, and whom they affect."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator

from fieldspec.command.console.streams import print_document
from fieldspec.command.console.terminal import print_blocks, print_findings
from fieldspec.command.console.usage import UsageError
from fieldspec.command.rendering.changes import AcceptedChange, Difference, hurts
from fieldspec.command.sources.spec_states import SpecState, spec_state
from fieldspec.foundation.classes import dataclass
from fieldspec.language.changes.acceptances import ComparedVersions, accepts_used, judged_changes, rules_known
from fieldspec.language.changes.rules.facts import device_added, device_removed
from fieldspec.language.changes.table import RULES, changes
from fieldspec.language.diagnostics import Diagnostic, in_order
from fieldspec.tools.proofs.running import previous

REVIEWS = ("sarif", "github")
"""The formats for code reviews."""


def run(arguments: argparse.Namespace) -> int:
    """Prints the changes. Exit code 1 where `--fail-on` applies, or where a spec accepts a change that is not there.

    Raises UsageError.
    """
    bare_paths = arguments.format in REVIEWS
    old, new = (spec_state(text, arguments.specs, bare_paths) for text in (arguments.old, arguments.new))
    compared = list(_comparisons(old, new))
    differences = [*_devices(old, new), *(_difference(comparison) for comparison in compared)]
    unused = _unused(compared)
    if arguments.format in REVIEWS:
        from fieldspec.command.rendering.changes import findings

        print_findings([*findings(differences), *unused], arguments.format, "")
    elif arguments.format == "text":
        from fieldspec.command.rendering.changes_formats import blocks

        print_blocks(blocks(differences))
    else:
        from fieldspec.command.rendering.changes_formats import format_changes

        print_document(format_changes(differences, arguments.format))
    if unused and arguments.format not in REVIEWS:
        from fieldspec.command.rendering.finding_text import rendered

        print_document(rendered(unused), sys.stderr)
    failed = arguments.fail_on is not None and hurts(differences, arguments.fail_on)
    return 1 if failed or unused else 0


@dataclass(frozen=True, slots=True)
class _Compared:
    """Comparisons that are shown together: the same device at several versions. `old` and `new` are labels."""

    old: str
    new: str
    by_version: dict[str, ComparedVersions]


def _comparisons(old: SpecState, new: SpecState) -> Iterator[_Compared]:
    """The comparisons of two states, device by device."""
    for device in _common(old, new):
        before, after = old.spec(device), new.spec(device)
        common = [version for version in after.versions() if version in before.versions()]
        if old.version or new.version or not common:
            yield _pair(old, new, device)
            continue
        by_version = {version: _of(old, new, device, version, version) for version in common}
        yield _Compared(old.label(device), new.label(device), by_version)
        for version in after.versions():
            based_on = previous(after, version)
            if version not in common and based_on is not None:
                step = _of(new, new, device, based_on, version)
                yield _Compared(new.label(device, based_on), new.label(device, version), {version: step})


def _common(old: SpecState, new: SpecState) -> list[str]:
    """The devices to compare: the requested one, or all that both states have. Raises UsageError."""
    stated = {spec_state.device for spec_state in (old, new) if spec_state.device}
    if len(stated) > 1:
        raise UsageError(f"{old.device} and {new.device} are different devices; compare two versions of one device")
    if stated:
        return sorted(stated)
    common = [device for device in sorted(new.project.devices) if device in old.project.devices]
    if not common and old.project.devices.keys() != new.project.devices.keys():
        raise UsageError(f"{old.name} and {new.name} have no device in common")
    if len(common) > 1 and (old.version or new.version):
        raise UsageError(f"say which device the version belongs to: choose from {', '.join(common)}")
    return common


def _pair(old: SpecState, new: SpecState, device: str) -> _Compared:
    """The comparison of the requested versions; a state without one takes the same version, or its newest."""
    before, after = old.version, new.version
    if not before:
        known = old.spec(device).versions()
        before = after if after in known else known[-1]
    if not after:
        known = new.spec(device).versions()
        after = before if before in known else known[-1]
    pair = _of(old, new, device, before, after)
    return _Compared(old.label(device, before), new.label(device, after), {after: pair})


def _of(old: SpecState, new: SpecState, device: str, before: str, after: str) -> ComparedVersions:
    first, second = old.at(device, before), new.at(device, after)
    spec = new.spec(device)
    return ComparedVersions(first, second, changes(first, second), step=previous(spec, after) == before)


def _difference(compared: _Compared) -> Difference:
    """The changes of a comparison; a change at several versions appears once."""
    versions_of: dict[tuple[object, ...], list[str]] = {}
    change_of: dict[tuple[object, ...], AcceptedChange] = {}
    for version, step in compared.by_version.items():
        for judged in judged_changes(step):
            change = judged.change
            key = (
                change.rule,
                change.effect,
                change.path,
                change.message,
                change.old,
                change.new,
                judged.accepted is None,
            )
            versions_of.setdefault(key, []).append(version)
            change_of[key] = AcceptedChange(change, judged.accepted)
    all_changes = [
        AcceptedChange(
            entry.change,
            entry.accepted,
            tuple(versions_of[key]) if len(versions_of[key]) < len(compared.by_version) else (),
        )
        for key, entry in change_of.items()
    ]
    return Difference(compared.old, compared.new, tuple(sorted(all_changes, key=lambda entry: entry.change.order())))


def _devices(old: SpecState, new: SpecState) -> Iterator[Difference]:
    """The devices that only one state has, where whole folders are compared."""
    if old.device or new.device:
        return
    removed = [device for device in old.project.devices if device not in new.project.devices]
    come = [device for device in new.project.devices if device not in old.project.devices]
    entries = [
        *(AcceptedChange(device_removed(old.at(device, ""))) for device in removed),
        *(AcceptedChange(device_added(new.at(device, ""))) for device in come),
    ]
    if entries:
        yield Difference(old.name, new.name, tuple(sorted(entries, key=lambda entry: entry.change.order())))


def _unused(compared: list[_Compared]) -> list[Diagnostic]:
    """The findings about acceptances that accept nothing."""
    rules = {name for name, _, _ in RULES}
    by_device: dict[str, list[ComparedVersions]] = {}
    for step in (step for comparison in compared for step in comparison.by_version.values()):
        by_device.setdefault(step.new.id, []).append(step)
    findings: list[Diagnostic] = []
    for steps in by_device.values():
        findings += rules_known((entry for step in steps for entry in step.new.accepts), rules)
        findings += accepts_used(steps)
    return in_order(findings)
