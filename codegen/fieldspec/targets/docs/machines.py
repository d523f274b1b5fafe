"""State machines: a drawing of each, and a table of what leads from one state to another."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.html_text import clean
from fieldspec.language.model.machines import StateMachine, Transition
from fieldspec.targets.docs.context import Context, cited
from fieldspec.targets.docs.document import (
    Arrow,
    Block,
    Line,
    Paragraph,
    Section,
    StateDrawing,
    TableColumn,
    TableRow,
    cell,
    code,
    joined,
    styled,
    table,
    text_piece,
)

COLUMNS = (
    TableColumn("No.", "number", unbroken=True),
    TableColumn("From", unbroken=True),
    TableColumn("To", unbroken=True),
    TableColumn("When", "wide", unbroken=True),
    TableColumn("Then"),
    TableColumn("Assumed", "wide"),
    TableColumn("Source", "source"),
)
INTRODUCTION = (
    "The states of the simulated device. Transitions that the manual does not print are marked as assumed, and "
    "dashed in the drawings."
)
_EVENTS = {
    "write": "{} is written",
    "receive": "{} comes",
    "rises": "{} becomes 1",
    "falls": "{} becomes 0",
    "event": "{}",
}


def state_machines(context: Context) -> Section:
    """All state machines with transitions."""
    inner = tuple(_machine(machine) for machine in context.device.machines if machine.transitions)
    introduction = (Paragraph((text_piece(INTRODUCTION),)),) if inner else ()
    return Section("behaviour", (text_piece("State machines"),), introduction, inner)


def _machine(machine: StateMachine) -> Section:
    blocks: list[Block] = []
    if machine.assumed:
        blocks.append(Paragraph((styled("assumed: ", "strong"), text_piece(machine.assumed))))
    title = clean(" ".join(machine.name.split("_")))
    blocks.append(StateDrawing(f"State machine {title}", machine.states, tuple(_arrows(machine))))
    rows = [_transition_row(machine, number, transition) for number, transition in enumerate(machine.transitions, 1)]
    blocks.append(table(f"Transitions of {title}", COLUMNS, rows))
    if machine.sources:
        blocks.append(Paragraph((text_piece("Source of the states: "), *cited(machine.sources))))
    return Section(machine.place.path, (code(machine.name),), tuple(blocks))


def _arrows(machine: StateMachine) -> Iterator[Arrow]:
    """An arrow for each two states between which transitions lead, with the numbers of these."""
    numbers: dict[tuple[int, int], list[int]] = {}
    for number, transition in enumerate(machine.transitions, 1):
        target = machine.states.index(transition.target)
        for origin in dict.fromkeys(map(machine.states.index, transition.origins)):
            if origin != target:
                numbers.setdefault((origin, target), []).append(number)
    for (origin, target), own in sorted(numbers.items()):
        assumed = all(machine.transitions[number - 1].assumed for number in own)
        yield Arrow(origin, target, ", ".join(map(str, own)), assumed)


def _transition_row(machine: StateMachine, number: int, transition: Transition) -> TableRow:
    return TableRow(
        (
            cell(str(number)),
            cell(*((code(state),) for state in transition.origins)),
            cell((code(transition.target),)),
            cell(*_reasons(transition)),
            cell(*((text_piece(action),) for action in transition.actions if action)),
            cell(transition.assumed),
            cell(cited(transition.sources)),
        ),
        f"{machine.place.path}/{transition.name}",
    )


def _reasons(transition: Transition) -> Iterator[Line]:
    """The event and the conditions, each in a line."""
    if transition.event:
        before, _, suffix = _EVENTS[transition.event[0]].partition("{}")
        yield (text_piece(before), code(transition.event[1]), text_piece(suffix))
    for signal, values in transition.conditions:
        texts = joined(((code(value),) for value in values), " or ")
        yield (code(signal), text_piece(" is "), *texts)
