"""Blocks for tasks that are carried out over a line: the order of their steps, whatever the line carries."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Sequence

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.operand import Operand, Operands
from fieldspec.language.model.task import Step, Task
from fieldspec.language.model.value import Value
from fieldspec.language.model.watches import (
    MOVING,
    REFUSAL,
    acceptance,
    before_effect,
    halting_task,
    is_command,
    last_command,
    needs_begin,
    shows_acceptance,
    watches,
)
from fieldspec.targets.controllers.routines.blocks.kinds import Branch, Executed, Jogging, Moving, Stopping
from fieldspec.targets.controllers.routines.blocks.lines import LineDraft
from fieldspec.targets.controllers.routines.blocks.operands import outputs_of
from fieldspec.targets.controllers.routines.blocks.progress import Conditions, Seen, opposite
from fieldspec.targets.controllers.routines.blocks.standard import chain
from fieldspec.targets.controllers.routines.blocks.tasks import end_steps, target
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import Variable
from fieldspec.targets.controllers.statements.routine import Assignment, Statement, when

Decide = Callable[[int], list[Statement]]
"""The handling of a response, by the number of the next step."""


@dataclass(frozen=True, slots=True)
class Unit:
    """Steps of a task that belong together, from `index` to before `after`: what is sent, and what is read.

    If `again`, it is read repeatedly, with some time between.
    """

    index: int
    behind: int
    commands: bool
    waits: tuple[Step, ...] = ()
    reads: tuple[Step, ...] = ()
    again: bool = False


class LineTask(ABC):
    """The steps of a block while they are being added.

    `tasks` is one task, or two that jog in both directions. `known` is what an earlier run knows of steps that others
    go to before they are added, and of arguments.
    """

    def __init__(
        self, world: World, operands: Operands, draft: LineDraft, tasks: Sequence[Task], known: LineTask | None
    ) -> None:
        self.world, self.operands, self.draft, self.tasks = world, operands, draft, tasks
        self.known = known.labels if known is not None else {}
        self.task = tasks[0]
        self.labels: dict[str, int] = {}
        self.watches = watches(world.layout.device, operands, self.task)
        self.conditions = Conditions(world, operands, draft)
        if known is not None:
            self.conditions.arguments.update(known.conditions.arguments)
        self.fault_before: Variable | None = None

    @abstractmethod
    def units(self, task: Task, first: int, stop: int) -> Iterable[Unit]:
        """The units of the steps of a task from `first` to before `stop`."""

    @abstractmethod
    def first_units(self) -> Iterable[tuple[Task, Unit]]:
        """The units whose responses are judged before the first command, with their tasks."""

    @abstractmethod
    def watching_unit(self) -> tuple[Task, Unit] | None:
        """The unit that is read while a motion lasts; None where no response shows anything."""

    @abstractmethod
    def seen(self, task: Task, unit: Unit) -> Seen:
        """The function that gives the raw number of an operand in the response to a unit."""

    @abstractmethod
    def perform(self, task: Task, unit: Unit, operands: Sequence[Operand], decide: Decide, remark: str) -> None:
        """Adds the steps that send a unit's commands, or request its operands, and then decide."""

    def target(self, step: Step) -> Operand:
        """The operand of a step."""
        return target(self.operands, step)

    def all(self) -> None:
        """Adds the steps of all tasks of the block."""
        kind, task = self.draft.kind, self.task
        whole = len(task.steps)
        if isinstance(kind, Jogging):
            self._jog(kind)
        elif isinstance(kind, Moving):
            self._motion(kind)
        elif isinstance(kind, Stopping):
            self._walk(task, 0, whole, self.draft.action("TakeOver"), last_command(task))
            kind.stop = self.labels["accepted"]
        else:
            if isinstance(kind, Executed):
                kind.limit()
            first = before_effect(task)
            if first:
                self._look_first()
            takes = task.kind == "servo_off"
            takeover = self.draft.action("Increment", count=self.draft.of_axis("motion")) if takes else []
            self._walk(task, first, whole, takeover, acceptance(self.operands, task) if takes else -1)

    def _motion(self, kind: Moving) -> None:
        """Adds the steps of a motion, or of a halt, and those that end it."""
        task = self.task
        kind.limit()
        first = before_effect(task)
        if task.kind in MOVING:
            self._look_first()
        self._walk(
            task,
            first,
            len(task.steps),
            self.draft.action("TakeOver"),
            acceptance(self.operands, task),
            begins_motion=True,
        )
        kind.look = self.labels["look"]
        if task.kind not in MOVING:
            kind.ending, kind.stop = 1, kind.commands[-1]
            return
        halting, ends = halting_task(self.world.layout.device), end_steps(task)
        if halting is not None:
            kind.ending = self.draft.next
            following = last_command(halting) + 1
            shows = following < len(halting.steps)
            # The stop is accepted: it ends whatever moves, the motion of another block too.
            accepted, accepted_at = self.draft.action("TakeOver"), acceptance(self.operands, halting)
            self._walk(halting, 0, following, accepted, accepted_at, ending=True, last=not shows and ends is None)
            kind.stop = self.draft.next - 1
            if ends is not None:
                self._walk(task, ends[1], ends[1] + 1, ending=True, last=not shows)
            self._walk(halting, following, len(halting.steps), ending=True)

    def _jog(self, kind: Jogging) -> None:
        """Adds the steps of a jog: both directions, what is watched meanwhile, and its end."""
        task, draft = self.task, self.draft
        self._look_first()
        ends = [end_steps(other) for other in self.tasks]
        direction_steps = [draft.go(self.known.get(f"direction {number}", 0)) for number in range(len(self.tasks))]
        if len(self.tasks) > 1:
            draft.add(
                [when(draft.variable("xBackward"), [direction_steps[1]], [direction_steps[0]])], remark="the direction"
            )
        for number, (other, end) in enumerate(zip(self.tasks, ends, strict=True)):
            assert end is not None
            self.labels[f"direction {number}"] = draft.next
            accepted_at = acceptance(self.operands, other)
            on = self.known.get("watch", 0)
            self._walk(
                other, end[0], end[1], self.draft.action("TakeOver"), accepted_at, begins_motion=True, behind_all=on
            )
        kind.look = self.labels["watch"] = draft.next
        watching = self.watching_unit()
        if watching is None:
            draft.add([], remark="it moves until its input ends it")
        else:
            this_step, value_of = draft.next, self.seen(*watching)
            branches = self.conditions.watched(self.watches, value_of)
            operands = [watch.operand for watch in self.watches]
            is_standing = self.conditions.stands(value_of)
            moves: list[Statement] = []
            if is_standing is not None:
                operands += [self.target(step) for step in self.conditions.standstill]
                moves, idle = self.conditions.begun(kind, is_standing)
                branches.append(idle)
            self.perform(
                *watching, operands, lambda following: [*moves, chain(branches, [draft.go(this_step)])], "it moves"
            )
        kind.ending = draft.next
        assert ends[0] is not None
        last = ends[0][1]
        self._walk(task, last, last + 1, self.draft.action("TakeOver"), last, ending=True)
        kind.stop = draft.next - 1
        self._walk(task, last + 1, len(task.steps), ending=True)

    def _look_first(self) -> None:
        """Adds what looks whether the task may begin, and notes what is compared with later.

        Where the device does not show that it accepts a command, nothing begins while it moves: it would be unknown
        which of two commands it carries out.
        """
        draft, task, conditions = self.draft, self.task, self.conditions
        refusals = [step for step in task.steps if step.action == "wait" and REFUSAL in self.target(step).roles]
        confirms = any(shows_acceptance(self.operands, step) for step in task.steps)
        must_stand = () if confirms else conditions.standstill
        for own, unit in self.first_units():
            value_of = self.seen(own, unit)
            noted: list[Statement] = []
            operands = [watch.operand for watch in self.watches]
            looks = (*unit.waits, *must_stand, *conditions.compared(task), *refusals)
            operands += [self.target(step) for step in looks]
            for step in conditions.compared(task):
                noted += conditions.start_of(step, value_of) if value_of(self.target(step)) is not None else []
            for step in refusals[:1]:
                if value_of(self.target(step)) is not None:
                    remark = "an earlier fault hides a refusal"
                    self.fault_before = draft.flag("xFaultBefore", remark)
                    computed, absent = conditions.test(step, value_of)
                    noted += [*computed, Assignment(self.fault_before, opposite(absent))]
            branches = conditions.watched(self.watches, value_of)
            for step in unit.waits:
                computed, holds = conditions.test(step, value_of)
                branches.append((opposite(holds), [draft.fail("unready")]))
            is_standing = conditions.stands(value_of) if must_stand else None
            if is_standing is not None:
                assert isinstance(draft.kind, Moving)
                branches.append(draft.kind.unready(opposite(is_standing)))
            visible = [operand for operand in operands if value_of(operand) is not None]
            if visible:
                self.perform(own, unit, visible, self._first(branches, noted), "whether it may begin")

    def _first(self, branches: list[Branch], noted: list[Statement]) -> Decide:
        def decide(following: int) -> list[Statement]:
            success = [*noted, self.draft.go(following)]
            return [chain(branches, success)] if branches else success

        return decide

    def _walk(
        self,
        task: Task,
        first: int,
        stop: int,
        accepted: Sequence[Statement] = (),
        accepted_at: int = -1,
        begins_motion: bool = False,
        ending: bool = False,
        last: bool | None = None,
        behind_all: int = 0,
    ) -> None:
        """Adds steps of a task. The `accepted` statements follow the step at `accepted_at`.

        If it `begins_motion`, later waits are judged as a motion; `ending` a motion is not watched. `last` says that
        nothing comes after, by default where these are the last steps of the task; `behind_all` is the step that comes
        after instead.
        """
        draft, kind = self.draft, self.draft.kind
        command = max((n for n in range(first, accepted_at + 1) if is_command(task, n)), default=-1)
        ends = stop == len(task.steps) if last is None else last
        units = list(self.units(task, first, stop))
        for unit in units:
            is_last = unit is units[-1]
            accepts = unit.index <= accepted_at < unit.behind
            is_moving = begins_motion and unit.index > accepted_at
            extra = accepted if accepts else ()

            def go(step: int, is_last: bool = is_last) -> Statement:
                if is_last and behind_all:
                    return draft.go(behind_all)
                return draft.end() if is_last and ends else draft.go(step)

            waits_at = next((n for n in range(unit.index, unit.behind) if task.steps[n].action == "wait"), -1)
            must_begin = waits_at >= 0 and needs_begin(task, waits_at, accepted_at)
            self._add(task, unit, extra, go, is_moving, must_begin, ending)
            if begins_motion and unit.index <= command < unit.behind and isinstance(kind, Moving):
                kind.commands.append(draft.next - 1)
            if accepts:
                self.labels["accepted"], self.labels["look"] = draft.next - 1, draft.next

    def _add(
        self,
        task: Task,
        unit: Unit,
        extra: Sequence[Statement],
        go: Callable[[int], Statement],
        is_moving: bool,
        must_begin: bool,
        ending: bool,
    ) -> None:
        """Adds the steps of a unit, with the decision on its response."""
        draft, kind, conditions = self.draft, self.draft.kind, self.conditions
        value_of, this_step = self.seen(task, unit), draft.next
        own = not ending and (unit.commands or bool(unit.waits))
        refusing = [step for step in unit.waits if REFUSAL in self.target(step).roles]
        watched = self.watches if own and not refusing else []
        operands = [self.target(step) for step in (*unit.waits, *unit.reads)]
        operands += [watch.operand for watch in watched]
        judged = is_moving and isinstance(kind, Moving) and task.kind in MOVING and bool(unit.waits)
        if judged:
            operands += [self.target(step) for step in conditions.standstill]
        branches = conditions.watched(watched, value_of)
        alarms: list[Statement] = []
        if ending and isinstance(kind, Moving):
            alarming = [watch for watch in self.watches if watch.reason == "alarm"]
            operands += [watch.operand for watch in alarming]
            alarms = kind.alarmed([test for test, _ in conditions.watched(alarming, value_of)])
        stops = bool(unit.waits) and not refusing and not unit.commands and (ending or task.kind == "stop")

        def decide(following: int) -> list[Statement]:
            success = [*extra, go(following)]
            for step in unit.reads:
                operand = self.target(step)
                raw = value_of(operand)
                assert raw is not None
                success[:0] = outputs_of(draft, operand.fact.name, operand, self.content(operand), raw)
            if judged:
                assert isinstance(kind, Moving)
                body = conditions.judged(kind, unit.waits, value_of, must_begin, success, [draft.go(this_step)])
            elif stops:
                assert isinstance(kind, Moving | Stopping)
                resend = draft.go(kind.ending if ending and isinstance(kind, Moving) else 1)
                body = conditions.stopped(kind, unit.waits, value_of, success, draft.go(this_step), resend)
            elif unit.waits:
                computed, holds = conditions.all_of(unit.waits, value_of)
                missing: list[Statement] = [draft.go(this_step)]
                if refusing:
                    missing = self._refused()
                elif unit.commands:
                    missing = [draft.fail("unready")]
                body = [*computed, when(holds, success, missing)]
            else:
                body = success
            return [*alarms, chain(branches, body)] if branches else [*alarms, *body]

        if refusing:
            remark = "whether the device has accepted the command"
        elif unit.commands:
            remark = "ends the motion" if ending else ""
        else:
            remark = "until it is there" if unit.waits else ""
        self.perform(task, unit, [operand for operand in operands if value_of(operand) is not None], decide, remark)

    def content(self, operand: Operand) -> Value | None:
        """The value of an operand when it is read."""
        return operand.value

    def _refused(self) -> list[Statement]:
        """The statements for a refused command: the device continues its earlier motion."""
        kind, refused = self.draft.kind, self.draft.fail("exception")
        if not isinstance(kind, Moving):
            return [refused]
        if self.fault_before is None:
            return [refused]
        return [Assignment(self.draft.variable("xSent"), self.fault_before), refused]
