"""What functions for programmable controllers express of a device, and what they leave out."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.bases import base_refusals
from fieldspec.codec.layout.characters import character_refusals
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.inner_list_refusals import inner_list_refusals
from fieldspec.codec.layout.omissions import Expressed, expressed
from fieldspec.codec.layout.refusal import Refusal
from fieldspec.codec.layout.segments import piece_refusals
from fieldspec.foundation.classes import replace
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic
from fieldspec.language.model.operand import Operands
from fieldspec.language.model.task import Task
from fieldspec.language.model.watches import watches
from fieldspec.targets.controllers.dialects import Dialect
from fieldspec.targets.controllers.narrowing import absent_reals, number_refusals
from fieldspec.targets.controllers.routines.telegrams import telegrams
from fieldspec.targets.controllers.structs import fixed


def for_dialect(layout: DeviceLayout, dialect: Dialect) -> Expressed:
    """A device without what a dialect has no functions for, and without the tasks that need it."""
    refusals = [
        *number_refusals(layout, dialect),
        *absent_reals(layout, dialect),
        *character_refusals(layout, dialect.title, for_controllers=True),
        *base_refusals(layout, dialect.title, for_controllers=True),
        *inner_list_refusals(layout, dialect.title, for_controllers=True),
        *piece_refusals(layout, dialect.title),
        *_long_telegrams(layout, dialect),
    ]
    result = expressed(layout, refusals)
    return replace(result, layout=_without_tasks(layout, result.layout)) if result.omissions else result


def _long_telegrams(layout: DeviceLayout, dialect: Dialect) -> Iterator[Refusal]:
    """A refusal of each telegram that no frame of a fieldbus carries."""
    for message in telegrams(layout):
        for data in message.bodies:
            if data.size and fixed(data) and data.size > dialect.longest_image:
                stated = message.message
                text = f"{message.name} has {data.size} bytes of process data; {dialect.title} takes "
                text += f"{dialect.longest_image}"
                finding = Diagnostic("plc_telegrams_fit", text, stated.place["name"], help=LEAVE_OUT)
                yield Refusal(stated, finding)


def _without_tasks(layout: DeviceLayout, remaining: DeviceLayout) -> DeviceLayout:
    """The remaining device, whose tasks do not apply where they need what is left out, or are watched by it."""
    operands = Operands(layout.device)
    present = {operand.path for operand in Operands(remaining.device).all}
    tasks = []
    for task in layout.device.tasks:
        paths = dict.fromkeys(_needed(layout, operands, task, set(remaining.messages)))
        absent = [path for path in paths if path not in present]
        reason = f"it needs {', '.join(absent)}, which {'is' if len(absent) == 1 else 'are'} left out"
        tasks.append(replace(task, not_applicable=task.not_applicable or reason) if absent and not task.open else task)
    return replace(remaining, device=replace(remaining.device, tasks=tuple(tasks)))


def _needed(layout: DeviceLayout, operands: Operands, task: Task, messages: set[str]) -> Iterator[str]:
    """The paths of the operands of a task and of what it is watched by.

    Omitted telegrams of a task with several telegrams do not count, unless all of them are omitted.
    """
    names = [name for name in task.messages if name in messages] or [*task.messages] or [""]
    for name in names:
        for step in task.steps:
            yield from (operand.path for operand in operands.target(step.target, name))
        yield from (watch.operand.path for watch in watches(layout.device, operands, task, name))
