"""Tasks and their steps."""

from __future__ import annotations

from fieldspec.language.model.fact import ScalarValue
from fieldspec.language.model.task import ACTIONS, Step, Task
from fieldspec.language.reading.building.context import Entry, free
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence


def task(entry: Entry) -> Task:
    """A task: steps, or a reason why there are none."""
    answers = [key for key in ("steps", "not_applicable", "open") if entry.get(key)]
    if len(answers) != 1:
        text = "it has no answer" if not answers else f"it has both `{answers[0]}` and `{answers[1]}`"
        help = "use one of `steps`, `not_applicable` and `open`"
        entry.refuse("wrong_form", answers[-1] if answers else "task", f"of the task, {text}", help)
    return entry.built(
        Task,
        kind=entry.text("task"),
        steps=tuple(_step(inner) for inner in entry.entries("steps", "")),
    )


def _step(entry: Entry) -> Step:
    actions = [action for action in ACTIONS if entry.get(action)]
    if len(actions) != 1:
        text = "the step has no action" if not actions else f"the step has both `{actions[0]}` and `{actions[1]}`"
        entry.refuse("wrong_form", actions[-1] if actions else "value", text, f"use one of {', '.join(ACTIONS)}")
    action = actions[0] if actions else "read"
    waits = action == "wait"
    arguments_node = entry.get("arguments")
    arguments = arguments_node.values if isinstance(arguments_node, Mapping) else {}
    return entry.built(
        Step,
        action=action,
        target=entry.text(action),
        value=None if waits else entry.value("value"),
        wanted=_awaited_values(entry.get("value")) if waits else (),
        values=free(entry.get("values")),
        arguments={key: node.text for key, node in arguments.items() if isinstance(node, Scalar)},
    )


def _awaited_values(node: Node | None) -> tuple[ScalarValue, ...]:
    """The values that end a wait: one, or the alternatives of a list."""
    nodes = node.items if isinstance(node, Sequence) else (node,)
    return tuple(item.value for item in nodes if isinstance(item, Scalar))
