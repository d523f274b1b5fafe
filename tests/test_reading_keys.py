"""No key of the language is overlooked: building the model reads each one that the schema allows."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import random_specs
from fieldspec.language.reading.building.device import built
from fieldspec.language.reading.findings import SYNONYMS
from fieldspec.language.reading.nodes import CHECKED, Mapping, Node, Sequence, with_checked_keys
from fieldspec.language.reading.project import read
from fieldspec.language.schema import Schema, resolved, schema

SEEDS = 400
# Random specs hardly ever have them: the default length of parameters, which only texts have, and what checksums cover.
RARE = """
device: {id: gadget, name: G, vendor: V, manual: {title: T, file: f, sha256: "%s", lines: 1}}
parameters: [{name: a, defaults: {type: text, length: 4}, rows: [{number: 1, name: b}]}]
registers: [{group: c, defaults: {type: text, length: 4}, rows: [{at: 1, name: d}]}]
links: [{name: e, request: [{name: f, role: checksum, covers: {from: g, to: h}}]}]
""" % ("0" * 64)
PROTOCOL = b"protocol: {id: wire, title: A protocol}\n"

# Settled on the nodes, before the model is built: which protocols are laid under, and which version a fact holds for.
# Copies of blocks are written out as groups, and which lines share outputs is no matter of one version.
SETTLED_BEFORE = {
    *(
        "uses",
        "protocol",
        "links",
        "messages",
        "since",
        "until",
        "only",
        "copies",
        "like",
        "audit",
        "reviews",
        "behaviour",
    ),
}

# How the manual is audited, and who has compared it: no part of the device, and read where audits are made.
OF_AUDITS = ("manual_section", "manual_pattern", "left_out", "unprinted", "review")

# What a simulator does, with the standards that say so: read by the simulator.
OF_SIMULATION = ("behaviour", "standard")

Key = tuple[str, str]


class Watched(dict[str, Node]):
    """The values of a mapping; they record the keys that are read."""

    def __init__(self, values: dict[str, Node], name: str, asked: set[Key]) -> None:
        super().__init__(values)
        self.name, self.asked = name, asked

    def get(self, key: str, default: Any = None) -> Any:
        self.asked.add((self.name, key))
        return super().get(key, default)

    def __getitem__(self, key: str) -> Node:
        self.asked.add((self.name, key))
        return super().__getitem__(key)


def watched(node: Node, part: Schema, name: str, declared: set[Key], asked: set[Key]) -> Node:
    """The tree with watched mappings; its keys are added to `declared`."""
    name = part.get("$ref", name).removeprefix("#/$defs/")
    part = resolved(part)
    if isinstance(node, Sequence):
        items = tuple(watched(item, part.get("items", {}), f"{name}[]", declared, asked) for item in node.items)
        return Sequence(node.file, node.start, node.end, items)
    if not isinstance(node, Mapping):
        return node
    node, known = with_checked_keys(node), part.get("properties", {})
    known = {**known, **resolved(known.get(CHECKED, {})).get("properties", {})}
    declared.update((name, key) for key in node.values if key in known)
    values = {
        key: watched(value, known.get(key, {}), f"{name}.{key}", declared, asked) for key, value in node.values.items()
    }
    return Mapping(node.file, node.start, node.end, Watched(values, name, asked), node.keys)


def test_every_key_is_read() -> None:
    declared: set[Key] = set()
    asked: set[Key] = set()
    for text in (RARE, *map(random_specs.spec, range(SEEDS))):
        files = {"gadget/device.yaml": text.encode(), "protocols/wire.yaml": PROTOCOL}
        for spec in read(files).devices.values():
            for version in spec.versions():
                tree = watched(spec.tree_at(version), schema(), "", declared, asked)
                assert isinstance(tree, Mapping)
                built(tree, version)
    assert len(declared) > 350
    # Restatements and reports are read key by key, whatever the keys are.
    passed_over = {
        (name, key)
        for name, key in declared - asked
        if not name.startswith(("claim", "report", "copy", ".audit", ".reviews", *OF_AUDITS, *OF_SIMULATION))
        and key not in SETTLED_BEFORE
    }
    assert passed_over == set()


def test_words_of_other_tools_lead_to_keys_of_the_language() -> None:
    keys = {key for part in [schema(), *schema()["$defs"].values()] for key in _keys(part)}
    assert {own for meant in SYNONYMS.values() for own in meant} <= keys


def _keys(part: Schema) -> Iterator[str]:
    """All keys of a part of the schema and of the parts in it."""
    for key, inner in part.get("properties", {}).items():
        yield key
        yield from _keys(inner)
    if isinstance(part.get("items"), dict):
        yield from _keys(part["items"])
