"""Checks, and proofs of examples, take any device that the schema admits: they find something, or nothing, never raise.

Real and made-up specs are broken at random places: keys and rows are taken out, put elsewhere, given other values. What
is left of a device that no check objects to must be fit for a layout and a codec.
"""

from __future__ import annotations

import random
from functools import lru_cache
from pathlib import Path

import pytest

from example_counts import FACTOR
from fieldspec.codec.layout.device import device_layout
from fieldspec.codec.reference.frames import codec
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.reading.building.device import built
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, children
from fieldspec.language.reading.project import read
from fieldspec.language.reading.scalars import violations_at
from fieldspec.language.reading.versions import Lines, selected
from fieldspec.tools.proofs.running import everything

TESTS = Path(__file__).parent
NUMBERS = (0, 1, 2, 7, 16, 255, 256, 65535, 65536, 2**31, 2**63, 10**18, -1, -(2**31))
WORDS = (
    "missing",
    "point",
    "0..1",
    "5..1",
    "-1, 3..9",
    "1-4",
    "u8",
    "u64",
    "text",
    "bytes",
    "f32",
    "big",
    "little",
    "body",
)
ROUNDS = 2 * FACTOR


@lru_cache(maxsize=1)
def trees() -> tuple[Mapping, ...]:
    """The trees of all devices: the real ones, those made for outputs, and those of the cases."""
    trees = []
    folders = [TESTS.parent / "specs", TESTS / "specs", *sorted(TESTS.glob("cases/*/*"))]
    for folder in folders:
        files = {}
        for path in sorted(path for path in folder.rglob("*.yaml") if path.is_file()):
            inside = path.relative_to(folder).as_posix()
            files[inside if "/" in inside else f"gadget/{inside}"] = path.read_bytes()
        project = read(files)
        if not project.findings:
            trees += [spec.tree for spec in project.devices.values()]
    assert len(trees) > 50
    return tuple(trees)


def changed(node: Node, chance: random.Random, spare: list[Node]) -> Node:
    """The tree with one place changed: a random walk down, then something is taken out, put in or replaced."""
    below = [key for key, _ in children(node)]
    if not below or chance.random() < 0.05:
        return replaced(node, chance, spare)
    key = chance.choice(below)
    if isinstance(node, Mapping) and isinstance(key, str):
        if chance.random() < 0.15 and key != "device":
            return node.without(key)
        return node.with_value(key, changed(node.values[key], chance, spare))
    assert isinstance(node, Sequence)
    assert isinstance(key, int)
    items = list(node.items)
    deed = chance.random()
    if deed < 0.1:
        del items[key]
    elif deed < 0.2:
        items.insert(chance.randrange(len(items) + 1), items[key])
    else:
        items[key] = changed(items[key], chance, spare)
    return Sequence(node.file, node.start, node.end, tuple(items))


def replaced(node: Node, chance: random.Random, spare: list[Node]) -> Node:
    """A replacement of a node: a number, a word, or another node of the same kind."""
    if not isinstance(node, Scalar) or chance.random() < 0.4:
        others = [other for other in chance.sample(spare, min(40, len(spare))) if type(other) is type(node)]
        return chance.choice(others) if others else node
    value: object = chance.choice(NUMBERS) if isinstance(node.value, int) else chance.choice(WORDS)
    if isinstance(node.value, bool):
        value = not node.value
    return Scalar(node.file, node.start, node.end, str(value), False, value)  # type: ignore[arg-type]


def every(node: Node) -> list[Node]:
    nodes = [node]
    for _, inner in children(node):
        nodes += every(inner)
    return nodes


@pytest.mark.proof(10)
@pytest.mark.parametrize("seed", range(64))
def test_checks_never_raise_and_what_passes_has_a_layout(seed: int) -> None:
    chance = random.Random(seed)
    tree = trees()[seed % len(trees())] if seed % 4 else chance.choice(trees()[:6])
    spare = every(tree)
    tried = 0
    for _ in range(ROUNDS * 50):  # few changes of a small tree leave what the schema admits
        broken: Node = tree
        for _ in range(chance.randint(1, 4)):
            broken = changed(broken, chance, spare)
        if not isinstance(broken, Mapping) or "device" not in broken.values or violations_at(broken, []):
            continue
        lines = Lines(broken)
        version = chance.choice(lines.versions())
        whole = selected(broken, version, lines)
        assert isinstance(whole, Mapping)
        device, findings = built(whole, version)
        if not has_errors(everything(device, findings)):
            codec(device_layout(device))
        tried += 1
        if tried == ROUNDS:
            break
    assert tried
