"""What those who carry out tasks need to know: what must hold meanwhile, what is looked at first, what has to end."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.classes import dataclass
from fieldspec.model.device import Device
from fieldspec.model.fact import ScalarValue
from fieldspec.model.operand import Operand, Operands
from fieldspec.model.task import Step, Task

MOVING = ("home", "move_absolute", "move_relative", "move_velocity", "jog", "run_point")
"""The tasks that move, and that an alarm and a servo that is off end."""

LASTING = ("jog", "move_velocity")
"""The tasks that go on until their last step ends them."""

REFUSAL = "fault_code"
"""The role of what shows that a command was not carried out. What a step waits for there must hold from then on."""

STARTING = frozenset(
    {
        *("switch_on", "servo_enable", "homing_start", "move_start", "move_enable"),
        *("jog_positive", "jog_negative", "jog_start", "point_start"),
    }
)
"""The roles of bits that let something begin or go on. A task that fails clears those that it has set."""


@dataclass(frozen=True, slots=True)
class Watch:
    """What must hold while a task goes on: an operand with a value. `reason` is the error where it does not."""

    operand: Operand
    value: ScalarValue
    reason: str


def watches(device: Device, operands: Operands, task: Task, message: str = "") -> list[Watch]:
    """What a task is watched by: no alarm, and where it moves, the servo.

    What shows them is what the tasks that reset the alarm and switch the servo on wait for last.
    """
    kinds = {"reset_alarm": "alarm"} if task.kind in (*MOVING, "servo_on") else {}
    if task.kind in MOVING:
        kinds = {**kinds, "servo_on": "servo"}
    return list(_watches(device, operands, kinds, message))


def _watches(device: Device, operands: Operands, kinds: dict[str, str], message: str) -> Iterator[Watch]:
    for kind, reason in kinds.items():
        for other in device.tasks:
            if other.kind != kind or not other.steps or (message and message not in other.messages):
                continue
            last = other.steps[-1]
            targets = operands.target(last.target, message)
            if last.action == "wait" and last.value is not None and len(targets) == 1:
                yield Watch(targets[0], last.value, reason)
                break


def before_effect(task: Task) -> int:
    """How many steps of a task only look whether it may begin."""
    count = 0
    for step in task.steps:
        if step.action != "wait":
            break
        count += 1
    return count if count < len(task.steps) else 0


def is_last_wait(task: Task, step: Step) -> bool:
    """Whether no step behind this one waits.

    The last wait may still show the end of what was before, so the device gets time before it. The others show that
    something has begun, which may be over soon.
    """
    waits = [other for other in task.steps if other.action == "wait"]
    return waits[-1] is step


def end_steps(task: Task) -> tuple[int, int] | None:
    """The steps that begin and end what must not go on by itself; None where nothing does.

    What lasts is ended by its last step; what is set and later cleared, by the step that clears it. Raises ValueError
    for what lasts and no step ends.
    """
    first = before_effect(task)
    if task.kind in LASTING:
        if len(task.steps) - first < 2:
            raise ValueError("no step ends it")
        return first, len(task.steps) - 1
    for at, step in enumerate(task.steps):
        if step.action == "set":
            for later in range(at + 1, len(task.steps)):
                if (task.steps[later].action, task.steps[later].target) == ("clear", step.target):
                    return at, later
    return None
