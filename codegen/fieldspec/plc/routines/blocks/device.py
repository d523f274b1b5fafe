"""All blocks of a device, and why a task has none."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.classes import dataclass, replace
from fieldspec.model.operand import Operands
from fieldspec.model.task import Task
from fieldspec.plc.routines.blocks.clients import client_blocks
from fieldspec.plc.routines.blocks.cyclic import cyclic_block
from fieldspec.plc.routines.blocks.frames import exchange_of, message_block, message_task
from fieldspec.plc.routines.blocks.operands import NoBlock
from fieldspec.plc.routines.blocks.ports import cyclic, own_links
from fieldspec.plc.routines.blocks.tables import group_blocks, table_blocks
from fieldspec.plc.routines.blocks.words import Helpers, has_only_registers, word_block
from fieldspec.plc.routines.routine import Routine
from fieldspec.plc.routines.world import World


@dataclass(frozen=True, slots=True)
class Blocks:
    """The functions and blocks, each behind what it calls. `missing` has the reasons of tasks without a block."""

    routines: tuple[Routine, ...]
    missing: tuple[tuple[str, str], ...]


def device_blocks(world: World, routines: Sequence[Routine]) -> Blocks:
    """The blocks of a device; `routines` are the functions that they may call."""
    blocks: list[Routine] = []
    missing: list[tuple[str, str]] = []
    helpers = Helpers(world)
    layout = world.layout
    by_name = {routine.name: routine for routine in routines}
    operands = Operands(layout.device)
    for task in layout.device.tasks:
        task_blocks, reason = _tried(world, operands, helpers, by_name, task)
        blocks += task_blocks
        if reason:
            missing.append((task.name, reason))
    if layout.registers:
        blocks += group_blocks(world, by_name)
        blocks += table_blocks(world, by_name)
        blocks += client_blocks(world, by_name, own_links(layout))
    for link in own_links(layout):
        for message in link.exchanged.values():
            if message.message.accesses is None:
                blocks.append(message_block(world, exchange_of(world, link, message, by_name)))
    return Blocks((*helpers.routines.values(), *_distinct(blocks, by_name)), tuple(missing))


def _distinct(blocks: list[Routine], others: dict[str, Routine]) -> Iterator[Routine]:
    """The blocks, with a number behind a name that is taken: tasks come first and have theirs."""
    taken = {name.lower() for name in others}
    for block in blocks:
        number, name = 1, block.name
        while name.lower() in taken:
            number += 1
            name = f"{block.name}{number}"
        taken.add(name.lower())
        yield replace(block, name=name)


def _tried(
    world: World, operands: Operands, helpers: Helpers, by_name: dict[str, Routine], task: Task
) -> tuple[list[Routine], str]:
    """The blocks of a task, or why it has none."""
    try:
        return list(_of_task(world, operands, helpers, by_name, task)), ""
    except NoBlock as reason:
        return [], str(reason)


def _of_task(
    world: World, operands: Operands, helpers: Helpers, by_name: dict[str, Routine], task: Task
) -> Iterator[Routine]:
    if task.open:
        raise NoBlock(f"an open question. {task.open}")
    if task.not_applicable:
        raise NoBlock(task.not_applicable)
    if task.messages:
        for message in cyclic(world.layout):
            if message.name in task.messages:
                yield cyclic_block(world, operands, message, task)
    elif has_only_registers(operands, task):
        yield word_block(world, operands, helpers, task)
    elif own_links(world.layout) and _sends(operands, task):
        yield message_task(world, operands, by_name, task)
    else:
        raise NoBlock("its steps act on parameters, or on several kinds of facts: send the messages one by one")


def _sends(operands: Operands, task: Task) -> bool:
    return any(step.action == "send" for step in task.steps)
