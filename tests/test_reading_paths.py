"""Paths lead to facts, also to rows within groups; a change affects only the fact at the end of its path."""

from __future__ import annotations

import pytest

from fieldspec.language.reading.nodes import Node, Scalar, changed, exact, find, keys
from fieldspec.language.reading.yaml_reader import decoded, parsed

TEXT = b"""
registers:
  - group: first
    rows:
      - {name: speed, range: one}
      - {name: torque, range: two}
  - group: second
    rows:
      - {name: place, range: three}
enums:
  - name: mode
    members:
      - {name: off, value: four}
      - {name: group, value: five}
"""
PLACES = {
    "registers/speed/range": ("one", ["registers", 0, "rows", 0, "range"]),
    "registers/torque/range": ("two", ["registers", 0, "rows", 1, "range"]),
    "registers/place/range": ("three", ["registers", 1, "rows", 0, "range"]),
    "enums/mode/off/value": ("four", ["enums", 0, "members", 0, "value"]),
    "enums/mode/members/group/value": ("five", ["enums", 0, "members", 1, "value"]),
    "enums/0/members/1/value": ("five", ["enums", 0, "members", 1, "value"]),
}
NOWHERE = (
    "registers/none/range",
    "registers/speed/none",
    "registers/9",
    "enums/mode/none/value",
    "none",
    "enums/speed",
)


def tree() -> Node:
    node, findings = parsed(decoded("gadget/device.yaml", TEXT)[0])
    assert node is not None
    assert findings == []
    for path in PLACES:
        scalar = find(node, path)
        assert isinstance(scalar, Scalar)
        scalar.value = scalar.text
    return node


def other(node: Node) -> Node:
    assert isinstance(node, Scalar)
    return Scalar(node.file, node.start, node.end, "new", False, "new")


@pytest.mark.parametrize("path", PLACES)
def test_a_path_leads_to_one_fact(path: str) -> None:
    text, steps = PLACES[path]
    node = tree()
    scalar = find(node, path)
    assert isinstance(scalar, Scalar)
    assert scalar.text == text
    assert keys(node, path) == steps


@pytest.mark.parametrize("path", PLACES)
def test_a_change_affects_one_fact_alone(path: str) -> None:
    node = tree()
    before = repr(exact(node))
    changed_node = changed(node, path, other)
    assert changed_node is not None
    assert repr(exact(changed_node)) == before.replace(repr(PLACES[path][0]), "'new'")
    assert repr(exact(node)) == before


@pytest.mark.parametrize("path", NOWHERE)
def test_a_path_that_leads_nowhere_finds_and_changes_nothing(path: str) -> None:
    node = tree()
    assert find(node, path) is None
    assert keys(node, path) is None
    assert changed(node, path, other) is None


def test_a_change_that_is_refused_returns_none() -> None:
    assert changed(tree(), "registers/place/range", lambda node: None) is None
