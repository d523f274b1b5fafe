"""The diff takes any two devices that can be read: it finds changes, or none, and never raises."""

from __future__ import annotations

import random

import pytest

from fieldspec.language.changes.acceptances import ComparedVersions, accepts_used, judged_changes
from fieldspec.language.changes.table import changes
from fieldspec.language.reading.building.device import built
from fieldspec.language.reading.nodes import Mapping, Node
from fieldspec.language.reading.scalars import violations_at
from fieldspec.language.reading.versions import Lines, selected
from test_checks_never_raise import changed, every, trees

ROUNDS = 8


@pytest.mark.proof(5)
@pytest.mark.parametrize("seed", range(32))
def test_broken_devices_are_compared(seed: int) -> None:
    chance = random.Random(seed)
    tree = trees()[seed % len(trees())] if seed % 4 else chance.choice(trees()[:6])
    spare = every(tree)
    lines = Lines(tree)
    version = lines.versions()[-1]
    whole = selected(tree, (version,), lines)
    assert isinstance(whole, Mapping)
    sound = built(whole, version)[0]
    compared = 0
    for _ in range(ROUNDS * 5):
        broken: Node = whole
        for _ in range(chance.randint(1, 5)):
            broken = changed(broken, chance, spare)
        if not isinstance(broken, Mapping) or "device" not in broken.values or violations_at(broken, []):
            continue
        device = built(broken, version)[0]
        for old, new in ((sound, device), (device, sound)):
            noticed = changes(old, new)
            assert [change for change in noticed if change.old == change.new] == []
            comparison = ComparedVersions(old, new, noticed, step=True)
            assert len(judged_changes(comparison)) == len(noticed)
            list(accepts_used([comparison]))
        compared += 1
        if compared == ROUNDS:
            break
    assert compared
