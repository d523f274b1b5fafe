"""What must go with a fact that a version removes: errata, examples, notes and tasks that are about it."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.diagnostics import Diagnostic, Label
from fieldspec.reading.findings import quoted
from fieldspec.reading.nodes import Mapping, Node, Scalar, children, identity, mappings

_SECTIONS = ("errata", "examples", "notes", "tasks")
_PATHS = ("fact", "about", "subject", "write", "set", "clear", "pulse", "read", "wait")
"""The keys under which these sections have paths of facts."""


def removal_findings(tree: Mapping, removed: list[tuple[Scalar, Node]]) -> Iterator[Diagnostic]:
    """A finding for each removed fact that others are still about: its path in the overlay, and its node."""
    for path, fact in removed:
        about = [(section, item) for section in _SECTIONS for item in mappings(tree.values.get(section))]
        starts = _starts(tree)
        items = [(section, item) for section, item in about if _is_about(item, path.text, fact, starts)]
        if items:
            names = [f"{section}/{identity(item)}" for section, item in items]
            labels = tuple(Label(item.span, "this one") for _, item in items[:1])
            text = f"{quoted(path.text)} goes, and {_joined(names)} {'is' if len(names) == 1 else 'are'} about it"
            entries = ", ".join(f"{{fact: {name}, reason: ...}}" for name in names)
            help = f"remove what goes with it, too: {entries}; or change it under `changes`"
            yield Diagnostic("overlay_removal_incomplete", text, path.span, labels, help)


def _joined(names: list[str]) -> str:
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def _starts(tree: Mapping) -> frozenset[str]:
    """The fields of messages that have the address of a register."""
    messages = list(mappings(tree.values.get("messages")))
    accesses = [access for message in messages if isinstance(access := message.values.get("accesses"), Mapping)]
    accesses += [step for message in messages for step in mappings(message.values.get("access_steps"))]
    return frozenset(_text(access.values.get("start")) for access in accesses)


def _is_about(item: Mapping, path: str, fact: Node, starts: frozenset[str]) -> bool:
    section, _, name = path.partition("/")
    if section == "messages" and _text(item.values.get("message")) == name:
        return True
    if section == "registers" and isinstance(fact, Mapping):
        values, at = item.values.get("values"), fact.values.get("at")
        if isinstance(values, Mapping) and isinstance(at, Scalar):
            addresses = [values.values[key] for key in starts if key in values.values]
            if any(isinstance(address, Scalar) and _number(address) == _number(at) for address in addresses):
                return True
    return any(text == path or text.startswith(f"{path}/") for text in _paths(item))


def _paths(node: Node, key: str = "") -> Iterator[str]:
    """The texts under keys that have paths."""
    if isinstance(node, Scalar):
        if key in _PATHS:
            yield node.text
        return
    for step, inner in children(node):
        yield from _paths(inner, step if isinstance(step, str) else key)


def _number(scalar: Scalar) -> int | None:
    try:
        return int(scalar.text, 0)
    except ValueError:
        return None


def _text(node: Node | None) -> str:
    return node.text if isinstance(node, Scalar) else ""
