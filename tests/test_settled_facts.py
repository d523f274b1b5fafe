"""Checks do not judge again what they have judged: what they find depends on nothing that is settled, or has passed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from importlib import import_module
from pathlib import Path

import pytest

from fieldspec.command.pipeline import load
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import replace
from fieldspec.language.checks import settled, table
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact
from test_cases import FOLDERS, name

CHECKS = [
    own
    for own, _ in table.CHECKS
    if {"of_values", "of_words"} & vars(import_module(f"fieldspec.language.checks.{own}")).keys()
]
CASES = [folder for folder in FOLDERS if folder.parent.name in CHECKS]


def devices(folder: Path) -> list[Device]:
    project = load({f"gadget/{path.name}": path.read_bytes() for path in sorted(folder.glob("*.yaml"))})
    return [spec.at(version)[0] for spec in project.devices.values() for version in spec.versions()]


def findings(device: Device, facts: Iterable[tuple[Fact, tuple[object, ...]]]) -> list[Diagnostic]:
    """The findings of the checks where some facts are settled."""
    settled._OPEN.clear()
    table._VERDICTS.clear()
    settled._SETTLED = ByIdentity()
    for fact, relatives in facts:
        settled._SETTLED[fact] = relatives
    return [finding for own in CHECKS for finding in table.run_named(device, own)]


@pytest.mark.parametrize("folder", CASES, ids=name)
def test_findings_in_a_fact_are_the_same_where_all_others_are_settled(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(settled, "_SETTLED", settled._SETTLED)
    for device in devices(folder):
        expected = findings(device, ())
        everything = settled.OpenFacts(device)
        facts = [*everything.words, *((fact, relatives) for fact, _, relatives in everything.values)]
        elsewhere = findings(device, facts)
        single = [
            finding
            for fact, _ in facts
            for finding in findings(device, [pair for pair in facts if pair[0] is not fact])
            if finding not in elsewhere
        ]
        assert set(map(repr, [*elsewhere, *single])) == set(map(repr, expected))


def test_a_fact_with_a_finding_is_judged_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(settled, "_SETTLED", ByIdentity())
    folder = next(folder for folder in CASES if folder.name.startswith("failing"))
    for device in devices(folder):
        first = table.run(device)
        settled._OPEN.clear()
        assert table.run(device) == first


def test_a_check_runs_again_only_where_what_it_has_read_differs_or_its_findings_have_moved(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    runs: list[str] = []

    def limits_ordered(device: Device) -> Iterator[Diagnostic]:
        runs.append(device.title)
        if device.title:
            yield Diagnostic("limits_ordered", device.title, device.place.whole)

    monkeypatch.setattr(table, "_VERDICTS", {})
    monkeypatch.setitem(table._BY_NAME, "limits_ordered", limits_ordered)
    (device,) = devices(next(folder for folder in CASES if folder.name == "passing"))
    titled = replace(device, title="Another")
    copies = [device, replace(device, doc="Another"), titled, replace(titled, doc="Another"), device]
    assert [len(table.run_named(copy, "limits_ordered")) for copy in copies] == [0, 0, 1, 1, 0]
    assert runs == [device.title, "Another"]
    device.place.whole.file.past = True
    assert [len(table.run_named(copy, "limits_ordered")) for copy in copies] == [0, 0, 1, 1, 0]
    assert runs == [device.title, *["Another"] * 3]
