"""The diff notices every random change that is visible on the wire, and never takes a change of text for one."""

from __future__ import annotations

import random
from collections import Counter
from functools import cache
from pathlib import Path

import pytest

from fieldspec.codec.layout.device import device_layout
from fieldspec.command.rendering.changes import AcceptedChange, Difference, hurts
from fieldspec.language.changes.change import Change, Effect
from fieldspec.language.changes.table import changes
from fieldspec.language.model.device import Device
from fieldspec.language.reading.building.device import built
from fieldspec.language.reading.nodes import Mapping, Scalar
from fieldspec.language.reading.project import read
from mutations import MUTATIONS, mappings, put, scalar

ROOT = Path(__file__).parent
ROUNDS = 1
"""How often each mutation is tried on each device."""

REWORDED = ("doc", "label", "title", "notes", "source", "printed_name", "zero", "one", "when", "problem", "cause")


@cache
def trees() -> dict[str, tuple[Mapping, str]]:
    """The trees of all devices at their newest versions, the real and the made-up ones."""
    trees = {}
    for folder in (ROOT.parent / "specs", ROOT / "specs"):
        files = {path.relative_to(folder).as_posix(): path.read_bytes() for path in sorted(folder.rglob("*.yaml"))}
        project = read(files)
        broken = {finding.span.file.path.partition("/")[0] for finding in project.findings}
        for name, spec in project.devices.items():
            if name not in broken:
                trees[name] = spec.tree_at(spec.versions()[-1]), spec.versions()[-1]
    assert len(trees) > 4
    return trees


@cache
def device(name: str) -> Device:
    return built(*trees()[name])[0]


def difference(noticed: list[Change]) -> list[Difference]:
    return [Difference("old", "new", tuple(map(AcceptedChange, noticed)))]


@cache
def own_identity(name: str) -> str | None:
    return identity(device(name))


def identity(device: Device) -> str | None:
    """The identity of the layout of a device; None if the device has no valid layout."""
    try:
        return device_layout(device).identity
    except (AssertionError, KeyError, IndexError, ValueError):
        return None


def cases() -> list[tuple[str, int]]:
    return [(name, number) for name in trees() for number in range(len(MUTATIONS))]


def mutated(name: str, number: int) -> list[Mapping]:
    """Some mutations of a device's tree."""
    chance = random.Random(f"{name} {number}")
    mutants = [MUTATIONS[number][1](trees()[name][0], chance) for _ in range(ROUNDS)]
    return [tree for tree in mutants if tree is not None]


@pytest.mark.proof(175)
@pytest.mark.parametrize(("name", "number"), cases(), ids=lambda param: str(param))
def test_every_change_on_the_wire_is_noticed_by_its_rule(name: str, number: int) -> None:
    rule = MUTATIONS[number][0]
    for tree in mutated(name, number):
        new = built(tree, trees()[name][1])[0]
        noticed = changes(device(name), new)
        assert hurts(difference(noticed), "breaking"), rule
        assert rule in {change.rule for change in noticed if change.effect.breaking}
        wire = [change.rule for change in noticed if change.effect is Effect.WIRE]
        if wire:
            assert identity(new) != own_identity(name), wire


def test_there_are_enough_mutations_of_every_kind() -> None:
    counter = Counter(MUTATIONS[number][0] for name, number in cases() for _ in mutated(name, number))
    assert sum(counter.values()) >= 200
    assert set(counter) == {rule for rule, _ in MUTATIONS}


@pytest.mark.proof(32)
@pytest.mark.parametrize("name", trees())
@pytest.mark.parametrize("seed", range(8))
def test_changes_of_text_are_never_called_breaking(name: str, seed: int) -> None:
    tree, version = trees()[name]
    chance = random.Random(seed)
    renamed = [
        (*way, key)
        for way, node in mappings(tree)
        for key in REWORDED
        if isinstance(node.values.get(key), Scalar) and not {"restated", "cases", "errata"} & set(way)
    ]
    for way in chance.sample(renamed, min(20, len(renamed))):
        other = "9.9 L99" if way[-1] == "source" else "In other words."
        tree = put(tree, way, scalar(other, tree))
    noticed = changes(device(name), built(tree, version)[0])
    assert bool(noticed) == bool(renamed)
    assert {change.effect for change in noticed} <= {Effect.DOCS}
    assert not hurts(difference(noticed), "behaviour")
