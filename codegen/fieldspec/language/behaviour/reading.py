"""Reads the section `behaviour` of the tree of a version, which fits the schema."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.behaviour.part import ACTION_KEYS, PART_KEYS, Behaviour, Part, Product, Term
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.fact import Place
from fieldspec.language.reading.building.context import Entry
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, mappings

if TYPE_CHECKING:
    from typing import Any

SECTION = "behaviour"


def behaviour_of(tree: Mapping) -> Behaviour:
    """The behaviour of a device at a version. A part without a kind is left out: `findings` names it."""
    parts = []
    for node in mappings(tree.values.get(SECTION)):
        kinds = kinds_of(node, PART_KEYS)
        if kinds:
            parts.append(_part(node, kinds[0]))
    return Behaviour(tuple(parts))


def kinds_of(node: Mapping, kinds: object) -> list[str]:
    """The keys of a part or an action that make its kind."""
    return [kind for kind in node.values if isinstance(kinds, type(PART_KEYS)) and kind in kinds]


def _part(node: Mapping, kind: str) -> Part:
    findings: list[Diagnostic] = []
    name = node.values.get("name")
    text = name.text if isinstance(name, Scalar) else ""
    entry = Entry(node, f"{SECTION}/{text}", findings)
    keys = {key: _value(child) for key, child in node.values.items()}
    if kind == "rule":
        keys["rule"] = tuple(_actions(node.values["rule"], entry.path))
    standard = node.values.get("standard")
    clause = ""
    if isinstance(standard, Mapping):
        clause = ", ".join(child.text for child in standard.values.values() if isinstance(child, Scalar))
    return Part(kind, text, entry.place(), keys, entry.text("assumed"), entry.sources, clause)


def _actions(node: Node, path: str) -> Iterator[Part]:
    for number, item in enumerate(mappings(node)):
        kinds = kinds_of(item, ACTION_KEYS)
        if kinds:
            place = Place(f"{path}/rule/{number}", item, item.values)
            yield Part(kinds[0], "", place, {key: _value(child) for key, child in item.values.items()})


def _value(node: Node) -> Any:
    if isinstance(node, Scalar):
        return node.value
    if isinstance(node, Sequence):
        return tuple(_value(item) for item in node.items)
    if node.values.keys() & {"product", "bits"}:
        return _product(node)
    return {key: _value(child) for key, child in node.values.items()}


def _product(node: Mapping) -> Product:
    def terms(key: str) -> tuple[Term, ...]:
        child = node.values.get(key)
        items = child.items if isinstance(child, Sequence) else ()
        values = [item.value for item in items if isinstance(item, Scalar)]
        return tuple(value for value in values if value is not None)

    other = node.values.get("or")
    alternative = other.value if isinstance(other, Scalar) else None
    return Product(terms("product"), terms("over"), alternative, terms("bits"))
