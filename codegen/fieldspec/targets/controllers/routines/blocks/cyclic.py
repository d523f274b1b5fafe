"""Blocks for tasks that are carried out by a telegram: they set the request and look at the response in each scan."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import FieldLayout
from fieldspec.language.model.operand import Operand, Operands
from fieldspec.language.model.task import Step, Task
from fieldspec.language.model.watches import (
    LASTING,
    MOVING,
    REFUSAL,
    STARTING,
    acceptance,
    before_effect,
    conditions,
    is_command,
    needs_begin,
    shows_acceptance,
    watches,
)
from fieldspec.targets.controllers.routines.blocks.kinds import Branch, Executed, Jogging, Kind, Moving, Stopping
from fieldspec.targets.controllers.routines.blocks.operands import NoBlock, argument, constant, kind_of, outputs_of
from fieldspec.targets.controllers.routines.blocks.progress import Conditions, opposite, standstill
from fieldspec.targets.controllers.routines.blocks.standard import BlockDraft, assigned, chain
from fieldspec.targets.controllers.routines.blocks.tasks import end_steps
from fieldspec.targets.controllers.routines.blocks.telegram_places import RequestBit, TelegramPlaces, cleared
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import Expression, Variable, every
from fieldspec.targets.controllers.statements.routine import Assignment, Routine, Statement, when

_BY_LEVEL = frozenset({"homing_start", "jog_positive", "jog_negative", "jog_start"})
"""Those of them that no other motion needs. A block clears them even if another block has taken control."""
_SETTLE = "T#20ms"


class CyclicTask:
    """The steps of a block while they are being added.

    `tasks` is one task, or two that jog in both directions. `known` is what an earlier run knows of steps that others
    go to before they are added, and of arguments.
    """

    def __init__(
        self,
        world: World,
        operands: Operands,
        draft: BlockDraft,
        kind: Kind,
        message: MessageLayout,
        tasks: Sequence[Task],
        known: CyclicTask | None,
    ) -> None:
        self.world, self.operands, self.draft, self.kind = world, operands, draft, kind
        self.message, self.tasks, self.task = message, tasks, tasks[0]
        self.known = known.labels if known is not None else {}
        self.places = TelegramPlaces(world, operands, draft, message)
        self.conditions = Conditions(world, operands, draft, message.name)
        if known is not None:
            self.conditions.arguments.update(known.conditions.arguments)
        if self.task.kind in LASTING:
            self.conditions.standstill = standstill(operands, self.task, message.name)
        self.labels: dict[str, int] = {}
        self.set: list[RequestBit] = []
        self.pulsed: list[RequestBit] = []
        self.setpoints: list[tuple[Expression, Variable]] = []
        self.neutral: list[Statement] = []
        self.lowered: list[Statement] = []
        self.insists: list[Statement] = []
        self.takes_at_edge = False
        self.insisting = False
        self.unsettled = False
        self.prepared = -1
        self.remarks: list[str] = []

    def all(self) -> None:
        """Adds the steps of all tasks of the block."""
        kind, task = self.kind, self.task
        if isinstance(kind, Jogging):
            self._jog(kind)
        elif task.kind in ("stop", "servo_off") and not isinstance(kind, Moving):
            self._insist()
        else:
            waits = any(step.action == "wait" for step in task.steps)
            if waits and task.kind not in LASTING and isinstance(kind, Executed | Moving):
                kind.limit()
            self._look_first()
            if task.kind == "reset_alarm":
                self._safe()
            if isinstance(kind, Moving):
                self._motion(kind)
            else:
                self._walk(task, before_effect(task), len(task.steps))

    def _motion(self, kind: Moving) -> None:
        """Adds the steps of a motion or a halt, and those that end it."""
        task = self.task
        ends = end_steps(task) if task.kind in LASTING else None
        stop = len(task.steps) if ends is None else ends[1]
        self._walk(task, before_effect(task), stop, acceptance(self.operands, task, self.message.name))
        kind.look = self.labels["look"]
        if ends is not None:
            kind.lasts = True
            place, field = self.places.place(self._operand(task.steps[ends[1]]))
            self.neutral.append(Assignment(place, self._value(task.steps[ends[1]], field)))
            self._follow()
        self._end(kind)

    def _jog(self, kind: Jogging) -> None:
        """Adds the steps of a jog: both directions, and its end."""
        draft = self.draft
        self._look_first()
        direction_steps = [draft.go(self.known.get(f"direction {number}", 0)) for number in range(len(self.tasks))]
        if len(self.tasks) > 1:
            draft.add(
                [when(draft.variable("xBackward"), [direction_steps[1]], [direction_steps[0]])], remark="the direction"
            )
        for number, other in enumerate(self.tasks):
            end = end_steps(other)
            assert end is not None
            self.labels[f"direction {number}"] = draft.next
            self._walk(other, end[0], end[1], acceptance(self.operands, other, self.message.name))
            draft.add([draft.go(self.known.get("watch", 0))])
        kind.look = self.labels["watch"] = draft.next
        draft.add([])
        self._end(kind)

    def _end(self, kind: Moving) -> None:
        """Adds the steps that end a motion: bits that keep it going are cleared, and the block waits for standstill."""
        draft = self.draft
        starting = [bit for bit in self.set if bit.roles & STARTING]
        kind.restart = cleared([*starting, *self.pulsed]) + self.neutral + self.lowered
        kind.lowered = cleared(self.pulsed) + self.neutral + self.lowered
        kind.lowered_unless_done = cleared([bit for bit in starting if bit.roles & _BY_LEVEL])
        if self.task.kind not in MOVING:
            kind.restart = [*self.insists, *kind.restart]
            starts = [self.places.bit(bit) for bit in self.places.starting() if "move_start" in bit.roles]
            kind.fresh += [*self.insists, *cleared(starts)]
            kind.at_once = [*draft.action("GoOut"), *self.draft.action("TakeOver")]
        kind.tries, kind.ending = 1, draft.next
        is_standing = self.conditions.stands(self.places.seen)
        reached = self.operands.with_role("speed_reached", self.message.name)
        if is_standing is None and self.neutral and len(reached) == 1:
            # The speed 0 is commanded: the drive says when it has reached it.
            self._settle()
            is_standing = self.conditions.has(reached[0], (True,), self.places.place(reached[0])[0])
        if is_standing is None:
            self.remarks.append(
                "The telegram does not show whether the drive stands: the block ends when it is told to stop."
            )
            draft.add([draft.end()])
        else:
            draft.add([when(every([self.places.valid, is_standing]), [draft.end()])], remark="until the device stands")

    def _insist(self) -> None:
        """Adds a stop: its bits are cleared in each scan, whatever the response, until the drive shows standstill."""
        draft, task, kind = self.draft, self.task, self.kind
        waits: list[Step] = []
        bits: list[RequestBit] = []
        for step in task.steps:
            if step.action == "clear":
                bits.append(self.places.bit(self._operand(step)))
            elif step.action == "set":
                self.insists.append(self.places.bit(self._operand(step)).put(True))
            elif step.action == "wait":
                waits.append(step)
            else:
                raise NoBlock(f"`{step.action} {step.target}` is nothing that can be repeated in each scan")
        self.insisting = True
        if isinstance(kind, Stopping):
            self.takes_at_edge = True
            levels = _BY_LEVEL | {"move_start"}
            bits += [self.places.bit(operand) for operand in self.places.starting() if levels & {*operand.roles}]
            self.remarks.append("It clears the bits that start a motion too, in each scan while it is Busy.")
        elif isinstance(kind, Executed) and waits:
            kind.limit()
        self.insists += cleared(bits)
        draft.settle(_SETTLE)
        computed, test = self.conditions.all_of(waits, self.places.seen) if waits else ([], None)
        if test is None:
            self.remarks.append(
                "The telegram does not show whether the drive stands: Done says that it is told to stop."
            )
        done = self.places.valid if test is None else every([self.places.valid, test])
        draft.add([*computed, when(done, [draft.end()])], remark="until it is there")

    def _look_first(self) -> None:
        """Adds what looks whether the task may begin, and notes what is compared with later.

        Where the drive does not show that it accepts a command, nothing begins while it moves.
        """
        draft, task = self.draft, self.task
        first = task.steps[: before_effect(task)]
        noted = [
            item for step in self.conditions.compared(task) for item in self.conditions.start_of(step, self.places.seen)
        ]
        branches: list[Branch] = []
        confirms = any(shows_acceptance(self.operands, step, self.message.name) for step in task.steps)
        is_standing = self.conditions.stands(self.places.seen) if task.kind in MOVING and not confirms else None
        if is_standing is not None:
            assert isinstance(self.kind, Moving)
            branches.append(self.kind.unready(opposite(is_standing)))
        for step in first:
            _, holds = self.conditions.test(step, self.places.seen)
            branches.append((opposite(holds), [draft.fail("unready")]))
        if branches or noted:
            success = [*noted, draft.go(draft.next + 1)]
            draft.add([chain(branches, success)] if branches else success, remark="whether it may begin")

    def _walk(self, task: Task, first: int, stop: int, accepted_at: int = -1) -> None:
        """Adds steps of a task; a motion has the axis after the step at `accepted_at`."""
        draft = self.draft
        starts_at = max((n for n in range(first, accepted_at + 1) if is_command(task, n)), default=-1)
        index, self.prepared = first, -1
        while index < stop:
            step = task.steps[index]
            last = index + 1
            if step.action == "wait":
                waits = conditions(self.operands, task, index, self.message.name)[: stop - index]
                last = index + len(waits)
                must_begin = needs_begin(task, index, accepted_at)
                takeover = self._taken(index <= accepted_at < last)
                self._waits(task, waits, index > accepted_at >= 0, must_begin, takeover, last == len(task.steps))
            else:
                self._command(task, index, self._taken(index == accepted_at), starts_at)
            if index <= accepted_at < last:
                self.labels["look"] = draft.next
            index = last

    def _taken(self, accepts: bool) -> list[Statement]:
        kind = self.kind
        return self.draft.action("TakeOver") if accepts and isinstance(kind, Moving) and not kind.halts else []

    def _waits(
        self,
        task: Task,
        waits: Sequence[Step],
        moving: bool,
        must_begin: bool,
        takeover: list[Statement],
        is_last: bool,
    ) -> None:
        """Adds a step that waits until conditions hold."""
        draft, kind = self.draft, self.kind
        if self.unsettled:
            self._settle()
        on = draft.end() if is_last else draft.go(draft.next + 1)
        success = [*(bit.put(False) for bit in self.pulsed), *takeover, on]
        refusing = any(REFUSAL in self._operand(step).roles for step in waits)
        if moving and isinstance(kind, Moving) and task.kind in MOVING:
            draft.add(
                self.conditions.judged(kind, waits, self.places.seen, must_begin, success, []),
                remark="until it is there",
            )
            return
        computed, holds = self.conditions.all_of(waits, self.places.seen)
        remark = "whether the drive has accepted the command" if takeover else "until it is there"
        draft.add([*computed, when(holds, success, [draft.fail("exception")] if refusing else [])], remark=remark)

    def _settle(self) -> None:
        self.draft.settle(_SETTLE)
        self.unsettled = False

    def _command(self, task: Task, index: int, takeover: list[Statement], starts_at: int) -> None:
        """Adds a step that changes the request."""
        draft, step = self.draft, task.steps[index]
        operand = self._operand(step)
        dispatch: list[Statement] = []
        if isinstance(self.kind, Moving) and not self.kind.halts and (index == starts_at or takeover):
            dispatch = self.draft.action("GoOut")
        is_last = index + 1 == len(task.steps)
        on = 0 if is_last else draft.next + 1
        if step.action == "read":
            place, field = self.places.place(operand)
            draft.add([*outputs_of(draft, operand.fact.name, operand, field.value, place), draft.go(on)])
        elif step.action == "pulse":
            bit = self.places.bit(operand)
            self.pulsed.append(bit)
            self._change([bit.put(False)], draft.next + 1, index == starts_at)
            self._settle()
            draft.add([*dispatch, bit.put(True), *takeover, draft.go(0 if is_last else draft.next + 1)])
        elif step.action in ("set", "clear"):
            bit = self.places.bit(operand)
            if step.action == "set":
                self.set.append(bit)
            else:
                self.unsettled = True
            if task.kind == "stop":
                self.insists.append(bit.put(step.action == "set"))
            self._change([*dispatch, bit.put(step.action == "set"), *takeover], on, index < starts_at)
        elif step.action == "write" and operand.bit is None:
            place, field = self.places.place(operand)
            if step.argument:
                raw = argument(draft, step.argument, operand, field.value)
                self.conditions.arguments[step.argument] = raw
                if task.kind in LASTING:
                    self.setpoints.append((place, raw))
                    if takeover:
                        draft.add([*dispatch, *takeover, draft.go(on)])
                    return
                value: Expression = raw
            else:
                value = self._value(step, field)
            self._change([*dispatch, Assignment(place, value), *takeover], on, index < starts_at)
        else:
            raise NoBlock(f"`{step.action} {step.target}` is nothing that a telegram can do")

    def _change(self, changes: Sequence[Statement], on: int, prepares: bool) -> None:
        """Adds a step that changes the request; all that `prepares` a start goes into one telegram.

        The drive looks at it when the start comes, in a telegram of its own, and that is some time later.
        """
        draft = self.draft
        if prepares and self.prepared == draft.next - 1:
            before = draft.steps.pop()
            changes, on = [*before.ask[:-1], *changes], on - 1
        draft.add([*changes, draft.go(on)])
        self.prepared = draft.next - 1 if prepares else -1

    def _value(self, step: Step, field: FieldLayout) -> Expression:
        if step.value is None:
            raise NoBlock(f"`{step.target}` is ended by an argument")
        operand = self._operand(step)
        return constant(self.world, operand, field.value, step.value, kind_of(self.world, operand, field.value))

    def _follow(self) -> None:
        """Adds the step in which a motion continues while Execute is TRUE and follows the inputs.

        Where the response shows that the speed is reached, it counts once the command has stood for some time.
        """
        draft = self.draft
        self.remarks.append(
            "While Execute is TRUE, the request follows the inputs; a value that is refused ends the motion. Whatever "
            "ends it, the last step is carried out in the same scan."
        )
        following: list[Statement] = [Assignment(place, raw) for place, raw in self.setpoints]
        reached = self.operands.with_role("speed_reached", self.message.name)
        if len(reached) == 1:
            steady = draft.flag("xSteady", "the command has not changed")
            remark = "how long a commanded speed stands before it may count as reached"
            settled = draft.timer("fbSteady", steady, "SettlingTime", _SETTLE, remark)
            at_speed = draft.declare("InVelocity", steady.type, "output", "the commanded speed is reached")
            place, _ = self.places.place(reached[0])
            is_unchanged = every([target.compared("=", raw) for target, raw in self.setpoints])
            following = [
                Assignment(steady, is_unchanged),
                *following,
                Assignment(at_speed, every([steady, settled, self.conditions.has(reached[0], (True,), place)])),
            ]
            self.lowered += [assigned(steady, False), assigned(at_speed, False)]
        refused = [Assignment(draft.reason, draft.refusal)] if draft.at_start else []
        if draft.at_start:
            draft.add(
                [*draft.at_start, when(draft.unrefused(), following, refused)], remark="the request follows the inputs"
            )
        else:
            draft.add(following, remark="the request follows the inputs")

    def _safe(self) -> None:
        """Adds a step that clears the bits which could start something once the alarm is gone."""
        safe = cleared([self.places.bit(operand) for operand in self.places.starting()])
        if safe:
            self.remarks.append(
                "Clears the bits that switch on and start first, so that nothing moves when the alarm is gone."
            )
            draft = self.draft
            draft.add([*safe, draft.go(draft.next + 1)])
            self._settle()

    def _operand(self, step: Step) -> Operand:
        return self.conditions.operand(step)

    def block(self) -> Routine:
        """The block: the statements of each scan, with the steps in a CASE."""
        draft, kind = self.draft, self.kind
        ending = [draft.variable("xEnding").negated()] if isinstance(kind, Moving) else []
        alarms: list[Statement] = []
        guards: list[Branch] = []
        for watch in watches(self.world.layout.device, self.operands, self.task, self.message.name):
            place, _ = self.places.place(watch.operand)
            test = opposite(self.conditions.has(watch.operand, (watch.value,), place))
            if isinstance(kind, Moving) and watch.reason == "alarm":
                alarms += kind.alarmed([every([draft.variable("xEnding"), self.places.valid, test])])
            guards.append((every([test, draft.unharmed(), *ending]), [draft.fail(watch.reason)]))
        return kind.block(
            insists=self.insisting,
            takes_at_edge=self.takes_at_edge,
            orders=self.insists if self.insisting else alarms,
            watches=[chain(guards)] if guards else [],
        )
