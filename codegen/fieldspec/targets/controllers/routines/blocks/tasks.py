"""What blocks need to know of the tasks of a device: what they act on, how motions end, what they say."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.foundation.names import Name
from fieldspec.language.model import watches
from fieldspec.language.model.operand import Operand, Operands
from fieldspec.language.model.task import Step, Task, step_text
from fieldspec.language.model.watches import MOVING
from fieldspec.targets.controllers.routines.blocks.operands import NoBlock
from fieldspec.targets.controllers.routines.blocks.standard import ERRORS, BlockDraft
from fieldspec.targets.controllers.routines.exchanges import meanings
from fieldspec.targets.controllers.routines.remarks import source


def target(operands: Operands, step: Step, message: str = "") -> Operand:
    """The operand of a step. Raises NoBlock where it is not exactly one fact."""
    targets = operands.target(step.target, message)
    if len(targets) != 1:
        raise NoBlock(f"`{step.target}` is not one fact")
    return targets[0]


def end_steps(task: Task) -> tuple[int, int] | None:
    """The steps that begin and end what must not go on by itself. Raises NoBlock for what lasts and no step ends."""
    try:
        return watches.end_steps(task)
    except ValueError as error:
        raise NoBlock(str(error)) from None


def describe(block: BlockDraft, tasks: Sequence[Task], title: str, *further_remarks: str) -> None:
    """Adds the comment of a block: what it does, its steps as the spec has them, and what is not known."""
    for task in tasks:
        head = title if len(tasks) == 1 else Name.of(task.name).title()
        block.remarks.append(f"{head}. {task.doc} {source(task)}".replace(" .", ".").strip())
        block.remarks.append("Steps: " + "; ".join(step_text(step) for step in task.steps) + ".")
    notes = dict.fromkeys(note for task in tasks for note in task.notes)
    block.remarks += [f"Note: {note}" for note in notes]
    block.remarks += [text for text in further_remarks if text]
    block.remarks.append(meanings(block.world, ERRORS))
    if tasks[0].kind in MOVING:
        block.remarks.append(
            "It takes the axis over when the device has accepted its command, and the block before it ends with "
            "CommandAborted. Where its command may be on its way, it ends the motion before it says Error. After 2, "
            "3, 7 and 9 the device may be moving: whether it has heard of the end is not known."
        )
