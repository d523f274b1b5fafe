"""The conditions of running tasks: what must hold meanwhile, what is checked first, and what has to end."""

from __future__ import annotations

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import ScalarValue
from fieldspec.language.model.operand import Operand, Operands
from fieldspec.language.model.task import Step, Task

MOVING = ("home", "move_absolute", "move_relative", "move_velocity", "jog", "run_point", "grip", "release")
"""The tasks that move, and that an alarm and a servo that is off end."""

LASTING = ("jog", "move_velocity")
"""The tasks that go on until their last step ends them."""

REFUSAL = "fault_code"
"""The role of what shows that a command was not carried out. The condition that a step waits for there must hold from
then on.
"""

ACCEPTING = (REFUSAL, "command_accepted")
"""The roles of what shows that a command was accepted or refused."""

STARTING = frozenset(
    {
        *("switch_on", "servo_enable", "homing_start", "move_start", "move_enable"),
        *("jog_positive", "jog_negative", "jog_start", "point_start"),
    }
)
"""The roles of bits that let something begin or go on. A task that fails clears those that it has set."""


@dataclass(frozen=True, slots=True)
class Watch:
    """A condition that must hold while a task runs: an operand with a value. `reason` is the error where
    it does not.
    """

    operand: Operand
    value: ScalarValue
    reason: str


def watches(device: Device, operands: Operands, task: Task, message: str = "") -> list[Watch]:
    """The conditions that stop a task: an alarm, and for a motion, the servo.

    What shows them is what the tasks that reset the alarm and switch the servo on wait for after their commands. What
    switches on looks at the first of it alone: an emergency stop, which a reset ends too, does not refuse it.
    """
    kinds = {"reset_alarm": "alarm"} if task.kind in (*MOVING, "servo_on") else {}
    if task.kind in MOVING:
        kinds = {**kinds, "servo_on": "servo"}
    lists = [_watches(device, operands, kind, reason, message) for kind, reason in kinds.items()]
    return [watch for watched in lists for watch in (watched if task.kind in MOVING else watched[:1])]


def _watches(device: Device, operands: Operands, kind: str, reason: str, message: str) -> list[Watch]:
    for other in device.tasks:
        if other.kind != kind or not other.steps or (message and message not in other.messages):
            continue
        waits = [step for step in other.steps[last_command(other) + 1 :] if len(step.wanted) == 1]
        pairs = [(operands.target(step.target, message), step.wanted[0]) for step in waits]
        watched = [Watch(targets[0], value, reason) for targets, value in pairs if len(targets) == 1]
        if watched:
            return watched
    return []


def before_effect(task: Task) -> int:
    """How many steps of a task only look whether it may begin: waits, and the messages whose responses they look at."""
    for index, step in enumerate(task.steps):
        asks = is_query(task, index) and task.steps[index + 1].action == "wait"
        if step.action != "wait" and not asks:
            return index
    return 0


def is_query(task: Task, index: int) -> bool:
    """Whether a step sends a message only to look at its response."""
    step, following = task.steps[index], task.steps[index + 1 : index + 2]
    looks = bool(following) and following[0].action in ("wait", "read")
    return step.action == "send" and not step.values and not step.arguments and looks


def is_command(task: Task, index: int) -> bool:
    """Whether a step makes the device do something."""
    return task.steps[index].action not in ("wait", "read") and not is_query(task, index)


def last_command(task: Task) -> int:
    """The step after which a task only looks at the device; -1 where it only looks."""
    return max((index for index in range(len(task.steps)) if is_command(task, index)), default=-1)


def shows_acceptance(operands: Operands, step: Step, message: str = "") -> bool:
    """Whether a step waits for what shows that the device has taken or refused a command."""
    roles = {role for operand in operands.target(step.target, message) for role in operand.roles}
    return step.action == "wait" and bool(roles & {*ACCEPTING})


def acceptance(operands: Operands, task: Task, message: str = "") -> int:
    """The step after which the device has accepted the command of a task that moves.

    That is the wait for the sign of it or, without one, the last command before the device is read.
    """
    first, ends = before_effect(task), end_steps(task) if task.kind in LASTING else None
    steps = range(first, ends[1] if ends is not None else len(task.steps))
    for index in steps:
        if shows_acceptance(operands, task.steps[index], message):
            return index
    command = first
    for index in steps:
        if not is_command(task, index):
            break
        command = index
    return command


def conditions(operands: Operands, task: Task, index: int, message: str = "") -> tuple[Step, ...]:
    """The waits from a step on that hold together, in one look at the device.

    Signs that a command is accepted or refused are awaited separately.
    """
    if shows_acceptance(operands, task.steps[index], message):
        return (task.steps[index],)
    waits: list[Step] = []
    for step in task.steps[index:]:
        if step.action != "wait" or shows_acceptance(operands, step, message):
            break
        waits.append(step)
    return tuple(waits)


def needs_begin(task: Task, index: int, accepted: int) -> bool:
    """Whether the waits from a step on may still show what was before the task moved anything.

    They do not where they compare a position with the target, nor where an earlier wait shows that a motion has begun.
    """
    if task.kind not in MOVING or task.kind in LASTING or index <= accepted:
        return False
    steps = task.steps[index:]
    stop = next((number for number, step in enumerate(steps) if step.action != "wait"), len(steps))
    is_last = all(step.action != "wait" for step in steps[stop:])
    proved = proves_target(task) and any(step.argument for step in steps)
    begun = any(step.action == "wait" for step in task.steps[accepted + 1 : index])
    return is_last and not proved and not begun


def proves_target(task: Task) -> bool:
    """Whether a wait with an argument compares a position with the target."""
    return task.kind in ("move_absolute", "move_relative")


def end_steps(task: Task) -> tuple[int, int] | None:
    """The steps that begin and end what must not go on by itself; None where nothing does.

    What lasts is ended by its last command; what is set and later cleared, by the step that clears it. Raises
    ValueError for what lasts and no step ends.
    """
    first = before_effect(task)
    if task.kind in LASTING:
        last = last_command(task)
        if last <= first:
            raise ValueError("no step ends it")
        return first, last
    for index, step in enumerate(task.steps):
        if step.action == "set":
            for later in range(index + 1, len(task.steps)):
                if (task.steps[later].action, task.steps[later].target) == ("clear", step.target):
                    return index, later
    return None


def halting_task(device: Device, message: str = "") -> Task | None:
    """The task that ends a motion which must not go on: the halt, else the first stop."""
    stops = [
        task
        for task in device.tasks
        if task.kind == "stop" and task.steps and (not message or message in task.messages)
    ]
    return next((task for task in stops if task.halt), stops[0] if stops else None)
