"""State machines from the section `behaviour`: its machines, and the rules that enter their states."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.model.machines import StateMachine, Transition
from fieldspec.language.reading.building.context import Entry
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, mappings

_SECTION = "behaviour"


def state_machines(root: Entry) -> tuple[StateMachine, ...]:
    """The state machines of a device, in the order of the spec."""
    parts = list(root.named(_SECTION, _SECTION))
    return tuple(
        entry.built(
            StateMachine,
            states=entry.texts("machine"),
            transitions=tuple(_transitions(entry, parts)),
        )
        for entry in parts
        if entry.get("machine") is not None
    )


def _transitions(machine: Entry, parts: list[Entry]) -> Iterator[Transition]:
    name, states = machine.text("name"), machine.texts("machine")
    own = f"state/{name}"
    for entry in parts:
        actions = list(mappings(entry.get("rule")))
        entered = [action for action in actions if _scalar_text(action.values.get("enter")) == name]
        target = _scalar_text(entered[-1].values.get("state")) if entered else ""  # the others are over at once
        if target not in states:
            continue
        conditions = {key: _texts(node) for key, node in _pairs(entry.get("if"))}
        origins = conditions.get(own, tuple(state for state in states if state != target))
        yield entry.built(
            Transition,
            origins=tuple(state for state in origins if state in states),
            target=target,
            event=next(((kind, ", ".join(_texts(node))) for kind, node in _pairs(entry.get("when"))), ()),
            conditions=tuple((key, values) for key, values in conditions.items() if key != own),
            actions=tuple(_action(action) for action in actions if action not in entered),
        )


def _pairs(node: Node | None) -> Iterator[tuple[str, Node]]:
    if isinstance(node, Mapping):
        yield from node.values.items()


def _scalar_text(node: Node | None) -> str:
    return node.text if isinstance(node, Scalar) else ""


def _texts(node: Node) -> tuple[str, ...]:
    if isinstance(node, Sequence):
        return tuple(_scalar_text(item) for item in node.items)
    return (_scalar_text(node),)


def _action(action: Mapping) -> str:
    """`stop immediate`, `set alarm_code to 0`: an action in words, as far as it consists of names and numbers."""
    words = []
    for number, (key, node) in enumerate(action.values.items()):
        if isinstance(node, Scalar) and (number == 0 or key in ("to", "at", "state")):
            words += [key, node.text]
    return " ".join(words)
