"""What must go with a fact that a version removes: errata, examples, notes, tasks and changes that are about it."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Mapping as Table

from fieldspec.foundation.classes import dataclass
from fieldspec.language.diagnostics import Diagnostic, Label
from fieldspec.language.reading.findings import quoted
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, children, identity, keys, mappings

_SECTIONS = ("errata", "examples", "notes", "tasks")
_PATHS = ("fact", "about", "subject", "write", "set", "clear", "pulse", "read", "wait")
"""The keys under which these sections have paths of facts."""


@dataclass(frozen=True, slots=True)
class RemovedFact:
    """A fact that an overlay removes: its path there, its node, and what contains it, which may have its space."""

    path: Scalar
    fact: Node
    holder: Node


def removed_changes(base: Mapping, overlay: Mapping) -> Iterator[Diagnostic]:
    """A finding for each change of a fact that the same overlay removes; all paths are of the base."""
    removed = [(path, keys(base, path.text)) for path in _facts(overlay, "removes")]
    for path in _facts(overlay, "changes"):
        changed_keys = keys(base, path.text)
        other = next(
            (
                own
                for own, removed_keys in removed
                if changed_keys and removed_keys and changed_keys[: len(removed_keys)] == removed_keys
            ),
            None,
        )
        if other is not None:
            text = f"{quoted(other.text)} is removed by this overlay, so the change has no effect"
            help = "remove the change; what is added again under `adds` states its new values there"
            yield Diagnostic("overlay_changes_nothing", text, path.span, (Label(other.span, "removed here"),), help)


def _facts(overlay: Mapping, part: str) -> list[Scalar]:
    """The paths of the entries of one list of an overlay."""
    paths = (entry.values.get("fact") for entry in mappings(overlay.values.get(part)))
    return [path for path in paths if isinstance(path, Scalar)]


def removal_findings(tree: Mapping, removed: list[RemovedFact]) -> Iterator[Diagnostic]:
    """A finding for each removed fact that others are still about."""
    for removed_fact in removed:
        path = removed_fact.path
        candidates = [(section, item) for section in _SECTIONS for item in mappings(tree.values.get(section))]
        starts = _starts(tree, removed_fact)
        items = [
            (section, item) for section, item in candidates if _is_about(item, path.text, removed_fact.fact, starts)
        ]
        if items:
            names = [f"{section}/{identity(item)}" for section, item in items]
            labels = tuple(Label(item.span, "this one") for _, item in items[:1])
            text = f"{quoted(path.text)} goes, and {_joined(names)} {'is' if len(names) == 1 else 'are'} about it"
            entries = ", ".join(f"{{fact: {name}, reason: ...}}" for name in names)
            help = f"remove what goes with it, too: {entries}; or change it under `changes`"
            yield Diagnostic("overlay_removal_incomplete", text, path.span, labels, help)


def _joined(names: list[str]) -> str:
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def _starts(tree: Mapping, removed_fact: RemovedFact) -> dict[str, frozenset[str]]:
    """By message, the fields with an address in the space of a removed register."""
    first = next((identity(space) for space in mappings(tree.values.get("spaces"))), None) or ""
    holder = removed_fact.holder
    space = (_scalar_text(holder.values.get("space")) if isinstance(holder, Mapping) else "") or first
    starts = {}
    for message in mappings(tree.values.get("messages")):
        accesses = mappings(message.values.get("accesses"))
        own = (access for access in accesses if (_scalar_text(access.values.get("space")) or first) == space)
        starts[identity(message) or ""] = frozenset(_scalar_text(access.values.get("start")) for access in own)
    return starts


def _is_about(item: Mapping, path: str, fact: Node, starts: Table[str, frozenset[str]]) -> bool:
    section, _, name = path.partition("/")
    if section == "messages" and _scalar_text(item.values.get("message")) == name:
        return True
    if section == "registers" and isinstance(fact, Mapping):
        values, address_node = item.values.get("values"), fact.values.get("at")
        if isinstance(values, Mapping) and isinstance(address_node, Scalar):
            names = starts.get(_scalar_text(item.values.get("message")), frozenset())
            addresses = [values.values[key] for key in names if key in values.values]
            if any(
                isinstance(address, Scalar) and _scalar_number(address) == _scalar_number(address_node)
                for address in addresses
            ):
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


def _scalar_number(scalar: Scalar) -> int | None:
    try:
        return int(scalar.text, 0)
    except ValueError:
        return None


def _scalar_text(node: Node | None) -> str:
    return node.text if isinstance(node, Scalar) else ""
