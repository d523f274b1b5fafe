"""What blocks need to know of the tasks of a device: which of them take over, what they act on, what they say."""

from __future__ import annotations

from fieldspec.model import watches
from fieldspec.model.operand import Operand, Operands
from fieldspec.model.task import Step, Task, step_text
from fieldspec.model.watches import MOVING
from fieldspec.names import Name
from fieldspec.plc.routines.blocks.operands import NoBlock
from fieldspec.plc.routines.blocks.standard import ERRORS, BlockDraft, meanings
from fieldspec.plc.routines.remarks import source

TAKING_OVER = (*MOVING, "servo_off", "stop")
"""The tasks whose start ends the motion of other blocks."""


def target(operands: Operands, step: Step, message: str = "") -> Operand:
    """The operand of a step. Raises NoBlock where it is not exactly one fact."""
    targets = operands.target(step.target, message)
    if len(targets) != 1:
        raise NoBlock(f"`{step.target}` is not one fact")
    return targets[0]


def describe(block: BlockDraft, task: Task, *more: str) -> None:
    """Adds the comment of a block: what it does, its steps as the spec has them, and what is not known."""
    title = Name.of(task.name).title()
    cited = source(task)
    block.remarks.append(f"{title}. {task.doc} {cited}".replace(" .", ".").strip())
    block.remarks.append("Steps: " + "; ".join(step_text(step) for step in task.steps) + ".")
    block.remarks += [f"Note: {note}" for note in task.notes]
    block.remarks += [text for text in more if text]
    block.remarks.append(meanings(ERRORS))
    if not block.levelled:
        block.remarks.append(
            "Nothing starts without a rising edge of Execute, the first scan included. Done, CommandAborted and Error "
            "stay until Execute is FALSE, and at least one scan. Call the block in each scan."
        )


def end_steps(task: Task) -> tuple[int, int] | None:
    """The steps that begin and end what must not go on by itself. Raises NoBlock for what lasts and no step ends."""
    try:
        return watches.end_steps(task)
    except ValueError as error:
        raise NoBlock(str(error)) from None
