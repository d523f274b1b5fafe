"""All blocks of a device, and why a task has none."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.names import Name
from fieldspec.language.model.operand import Operands
from fieldspec.language.model.task import Task
from fieldspec.language.model.watches import MOVING
from fieldspec.targets.controllers.routines.blocks.clients import client_blocks
from fieldspec.targets.controllers.routines.blocks.cyclic import CyclicTask
from fieldspec.targets.controllers.routines.blocks.frames import MessageTask, exchange_of, message_block
from fieldspec.targets.controllers.routines.blocks.kinds import Executed, Jogging, Kind, Moving, Reading, Stopping
from fieldspec.targets.controllers.routines.blocks.line_tasks import LineTask
from fieldspec.targets.controllers.routines.blocks.lines import LineDraft
from fieldspec.targets.controllers.routines.blocks.operands import NoBlock
from fieldspec.targets.controllers.routines.blocks.panels import panels
from fieldspec.targets.controllers.routines.blocks.ports import AXIS, FRAMES, cyclic, own_links
from fieldspec.targets.controllers.routines.blocks.standard import BlockDraft
from fieldspec.targets.controllers.routines.blocks.tables import group_blocks, table_blocks
from fieldspec.targets.controllers.routines.blocks.tasks import describe
from fieldspec.targets.controllers.routines.blocks.telegram_places import TelegramPlaces
from fieldspec.targets.controllers.routines.blocks.words import Helpers, WordTask, has_only_registers
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.routine import Routine


@dataclass(frozen=True, slots=True)
class Blocks:
    """The functions and blocks, each after what it calls. `missing` has the reasons of tasks without a block."""

    routines: tuple[Routine, ...]
    missing: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class Job:
    """What becomes one block: a task, or those that jog in both directions, and its name.

    `halts` says that it stops and leaves the axis free.
    """

    name: str
    tasks: tuple[Task, ...]
    halts: bool = False

    @property
    def kind(self) -> str:
        """The kind of its tasks in the schema."""
        return self.tasks[0].kind


def device_blocks(world: World, routines: Sequence[Routine]) -> Blocks:
    """The blocks of a device, for tasks those that a project chooses. `routines` are the functions they may call."""
    blocks: list[Routine] = []
    missing: list[tuple[str, str]] = []
    layout = world.layout
    by_name = {routine.name: routine for routine in routines}
    maker = _Maker(world, by_name)
    kinds: dict[str, str] = {}
    for job in jobs(layout.device.tasks):
        if layout.blocks is not None and not any(task.name in layout.blocks.tasks for task in job.tasks):
            continue
        job_blocks, reason = maker.tried(job)
        blocks += job_blocks
        kinds.update((block.name, "halt" if job.halts else job.kind) for block in job_blocks)
        if reason:
            missing.append((job.tasks[0].name, reason))
    task_blocks = list(blocks)
    if layout.registers:
        blocks += group_blocks(world, by_name)
        blocks += table_blocks(world, by_name)
        blocks += client_blocks(world, by_name, own_links(layout))
    for link in own_links(layout):
        for message in link.exchanged.values():
            if message.message.single_access is None:
                blocks.append(message_block(world, exchange_of(world, link, message, by_name)))
    blocks += panels(world, task_blocks, kinds)
    return Blocks((*maker.helpers.routines.values(), *_distinct(blocks, by_name)), tuple(missing))


def jobs(tasks: Sequence[Task]) -> Iterator[Job]:
    """The blocks of tasks: two that jog in both directions are one, and what halts is a stop and a halt."""
    jogs = [task for task in tasks if task.kind == "jog" and task.steps]
    paired: set[str] = set()
    for task in tasks:
        if task.name in paired:
            continue
        if task.kind == "jog" and task.steps:
            opposite = [
                other
                for other in jogs
                if {task.direction, other.direction} == {"positive", "negative"} and other.messages == task.messages
            ]
            pair = sorted((task, *opposite[:1]), key=lambda other: other.direction == "negative")
            paired |= {other.name for other in pair}
            yield Job("jog" if task.direction else task.name, tuple(pair))
        else:
            yield Job(task.name, (task,))
            if task.halt and task.steps:
                yield Job("halt", (task,), halts=True)


def _distinct(blocks: list[Routine], routines: dict[str, Routine]) -> Iterator[Routine]:
    """The blocks, with a number after a name that is taken: tasks come first and have theirs."""
    used_names = {name.lower() for name in routines}
    for block in blocks:
        number, name = 1, block.name
        while name.lower() in used_names:
            number += 1
            name = f"{block.name}{number}"
        used_names.add(name.lower())
        yield replace(block, name=name)


class _Maker:
    """Makes the blocks of tasks."""

    def __init__(self, world: World, by_name: Mapping[str, Routine]) -> None:
        self.world, self.by_name = world, by_name
        self.operands = Operands(world.layout.device)
        self.helpers = Helpers(world)

    def tried(self, job: Job) -> tuple[list[Routine], str]:
        """The blocks of a job, or the reason why it has none."""
        try:
            return self.blocks(job), ""
        except NoBlock as reason:
            return [], str(reason)

    def blocks(self, job: Job) -> list[Routine]:
        """The blocks of a job. Raises NoBlock where there is none."""
        world, operands, task = self.world, self.operands, job.tasks[0]
        if task.open:
            raise NoBlock(f"an open question. {task.open}")
        if task.not_applicable:
            raise NoBlock(task.not_applicable)
        if task.messages:
            messages = _chosen_messages(world.layout, task)
            return [self._cyclic(job, item) for item in cyclic(world.layout) if item.name in messages]
        if all(has_only_registers(operands, job_task) for job_task in job.tasks):
            return [self._line(job, AXIS)]
        if own_links(world.layout) and all(_sends(job_task) for job_task in job.tasks):
            return [self._line(job, FRAMES)]
        raise NoBlock("its steps act on parameters, or on several kinds of facts: send the messages one by one")

    def _line(self, job: Job, port: str) -> Routine:
        """A block that asks over a line. It is made twice, so that steps know the numbers of those after them."""

        def build(known: LineTask | None) -> tuple[LineDraft, LineTask]:
            draft = LineDraft(self.world, self.world.block(job.name), f"task {job.name}", port)
            draft.kind = _kind(draft, job)
            if port == AXIS:
                return draft, WordTask(self.world, self.operands, self.helpers, draft, job.tasks, known)
            return draft, MessageTask(self.world, self.operands, self.by_name, draft, job.tasks, known)

        _, first = build(None)
        first.all()
        draft, task = build(first)
        task.all()
        describe(draft, job.tasks, Name.of(job.name).title(), *_comments(draft.kind))
        return draft.block()

    def _cyclic(self, job: Job, message: MessageLayout) -> Routine:
        """A block that works with a telegram, generated twice like the blocks of a line."""
        # The telegram comes first, also where a task has it in its name since others have one of the same kind.
        rest = job.name.removesuffix(f"_{message.name}").removeprefix(f"{message.name}_")
        name = self.world.block(message.name, rest)

        def build(known: CyclicTask | None) -> CyclicTask:
            draft = BlockDraft(self.world, name, f"telegram {message.name}")
            TelegramPlaces(self.world, self.operands, draft, message)
            kind = _kind(draft, job)
            return CyclicTask(self.world, self.operands, draft, kind, message, job.tasks, known)

        first = build(None)
        first.all()
        task = build(first)
        task.all()
        describe(task.draft, job.tasks, Name.of(job.name).title(), *task.remarks, *_comments(task.kind))
        return task.block()


def _chosen_messages(layout: DeviceLayout, task: Task) -> tuple[str, ...]:
    """The telegrams of a task: those that a project chooses, all of them where it chooses none."""
    chosen = layout.blocks.messages if layout.blocks is not None else ()
    return tuple(name for name in task.messages if name in chosen) or task.messages


def _kind(draft: BlockDraft, job: Job) -> Kind:
    """The kind of start and end that the block of a job has."""
    if job.kind.startswith("read_"):
        return Reading(draft)
    if job.kind in ("jog", "stop") or job.kind in MOVING or job.halts:
        draft.lend_axis()
    if job.kind == "jog":
        backward = any(task.direction == "negative" for task in job.tasks)
        return Jogging(draft, len(job.tasks) > 1 or not backward, backward)
    if job.kind in MOVING or job.halts:
        return Moving(draft, job.halts)
    return Stopping(draft) if job.kind == "stop" else Executed(draft, abort=False)


_HIDDEN = (
    "The device does not show that it accepts this command, so of two it is unknown which it carries out: it begins "
    "only at standstill and while no other block has a command under way, and no other begins meanwhile; else Error "
    "11. It first halts a motion of its own."
)
_AGAIN = (
    "The stop is sent again if the device moves for longer than StartTime. An accepted command that was not seen to "
    "begin may still begin: then the block is Busy until the device has stood for StartTime."
)


def _comments(kind: Kind) -> tuple[str, ...]:
    """The paragraphs of a block's comment about its start and end."""
    if isinstance(kind, Moving) and kind.hidden:
        return kind.comment, _HIDDEN
    return (kind.comment, _AGAIN) if isinstance(kind, Stopping) and kind.stop else (kind.comment,)


def _sends(task: Task) -> bool:
    return any(step.action == "send" for step in task.steps)
