"""What blocks wait for: conditions that hold together, and whether a motion has begun and where it has ended."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction as Ratio
from typing import Any

from fieldspec.language.model.fact import ScalarValue
from fieldspec.language.model.operand import Operand, Operands
from fieldspec.language.model.task import Step, Task
from fieldspec.language.model.watches import Watch, halting_task, last_command, proves_target, shows_acceptance
from fieldspec.targets.controllers.routines.blocks.kinds import Branch, Moving, Stopping
from fieldspec.targets.controllers.routines.blocks.operands import NoBlock, holds, unit_of
from fieldspec.targets.controllers.routines.blocks.standard import BlockDraft
from fieldspec.targets.controllers.routines.blocks.tasks import target
from fieldspec.targets.controllers.routines.scaling import times
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import (
    LREAL,
    Elementary,
    Expression,
    Fraction,
    Operation,
    Variable,
    either,
    every,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Statement

Seen = Callable[[Operand], "Expression | None"]
"""What shows a fact where a block looks: its raw number, the word of a bit, or None where it is not to be seen."""
_START = "how long the device may stand before it moves, or off its target; not printed"
_STANDING = "xStanding", "the device stands"
_MOVED = "xMoved", "the device was seen to move"


class Conditions:
    """The conditions that a block waits for. `arguments` has raw numbers by argument, `message` is the telegram."""

    def __init__(self, world: World, operands: Operands, draft: BlockDraft, message: str = "") -> None:
        self.world, self.operands, self.draft, self.message = world, operands, draft, message
        self.arguments: dict[str, Variable] = {}
        self.windows: dict[str, Variable] = {}
        halting = halting_task(world.layout.device, message)
        self.standstill = () if halting is None else standstill(operands, halting, message)

    def operand(self, step: Step) -> Operand:
        """The operand of a step."""
        return target(self.operands, step, self.message)

    def compared(self, task: Task) -> list[Step]:
        """The waits whose operand is compared with its value before the command."""
        return [step for step in task.steps if step.action == "wait" and step.argument and proves_target(task)]

    def start_of(self, step: Step, value_of: Seen) -> list[Statement]:
        """What notes where the device is before the command: the value there, and whether that is away from the target.

        An axis near the target may not have begun to move yet, or need no motion at all.
        """
        raw = self._raw(step, value_of)
        noted: list[Statement] = [Assignment(self._at_start(step, raw), raw)] if step.relative else []
        if step.argument in self.arguments:
            computed, reached = self.test(step, value_of)
            noted += [*computed, Assignment(self._away(), opposite(reached))]
        return noted

    def _away(self) -> Variable:
        return self.draft.flag("xAway", "the device was away from its target before the command")

    def _at_start(self, step: Step, raw: Expression) -> Variable:
        fact = self.operand(step).fact.name
        name = f"{self.world.variable(fact, raw.type)}AStartTime"
        return self.draft.declared_once(name, raw.type, "local", "what it was before the command")

    def _raw(self, step: Step, value_of: Seen) -> Expression:
        operand = self.operand(step)
        raw = value_of(operand)
        if raw is None:
            raise NoBlock(f"{operand.path} is not where the block looks")
        return raw

    def test(self, step: Step, value_of: Seen) -> tuple[list[Statement], Expression]:
        """The preceding computation, and whether the condition of a wait holds.

        Raises NoBlock for an argument that nothing sends, and for what is not to be seen.
        """
        raw, operand = self._raw(step, value_of), self.operand(step)
        if not step.argument:
            return [], self.has(operand, step.wanted, raw)
        if step.argument not in self.arguments:
            raise NoBlock(f"no earlier step sends the value that `{step.target}` waits for")
        expected = self.arguments[step.argument]
        if step.within is None and not step.relative and expected.type == raw.type:
            return [], raw.compared("=", expected)
        away = _difference(raw, expected)
        if step.relative:
            away = _difference(raw, self._at_start(step, raw)).combined("-", _real(expected))
        if operand.value is not None and operand.value.scaled:
            away = times(away, Ratio(operand.value.scale))
        distance = self.draft.declared_once("lrAway", LREAL, "local", "how far it is from where it was sent")
        computed: list[Statement] = [Assignment(distance, away)]
        if step.within is None:
            return computed, distance.compared("=", Fraction("0.0"))
        window = self._window(step, operand)
        minus = Fraction("0.0").combined("-", window)
        return computed, every([distance.compared("<=", window), distance.compared(">=", minus)])

    def _window(self, step: Step, operand: Operand) -> Variable:
        """The input for the distance within which a device counts as at its target."""
        if step.argument not in self.windows:
            remark = f"how far from its target the device may be at the end, in {unit_of(operand)}"
            digits = f"{step.within:f}"
            initial = digits if "." in digits else f"{digits}.0"
            self.windows[step.argument] = self.draft.declare("Window", LREAL, "input", remark, initial)
        return self.windows[step.argument]

    def has(self, operand: Operand, values: Sequence[ScalarValue], raw: Expression) -> Expression:
        """Whether a fact has one of some values."""
        return either([holds(self.world, operand, operand.value, value, raw) for value in values])

    def all_of(self, steps: Sequence[Step], value_of: Seen) -> tuple[list[Statement], Expression]:
        """The statements that compute conditions, and whether all of them hold."""
        computed: list[Statement] = []
        tests: list[Expression] = []
        for step in steps:
            statements, test = self.test(step, value_of)
            computed += statements
            tests.append(test)
        return computed, every(tests)

    def stands(self, value_of: Seen) -> Expression | None:
        """Whether the device stands, by the waits of the task that stops it; None where one of them is not visible."""
        tests: list[Expression] = []
        for step in self.standstill:
            raw = value_of(self.operand(step))
            if raw is None:
                return None
            tests.append(self.has(self.operand(step), step.wanted, raw))
        return every(tests) if tests else None

    def watched(self, watches: Sequence[Watch], value_of: Seen) -> list[Branch]:
        """The branches that fail the block where a watched fact no longer has its value."""
        branches: dict[str, list[Expression]] = {}
        for watch in watches:
            raw = value_of(watch.operand)
            if raw is not None:
                branches.setdefault(watch.reason, []).append(opposite(self.has(watch.operand, (watch.value,), raw)))
        return [(either(tests), [self.draft.fail(reason)]) for reason, tests in branches.items()]

    def begun(self, kind: Moving, is_standing: Expression) -> tuple[list[Statement], Branch]:
        """Sees whether a motion that lasts has begun; the branch is for one that has not: it may be refused."""
        flags = {"xStanding": self._fresh(kind, *_STANDING), "xMoved": self._fresh(kind, *_MOVED)}
        idle = self._idle(flags["xStanding"])
        statements = self.draft.action("SeeStanding", **flags, is_standing=is_standing, shows_motion=True)
        return statements, (every([idle, flags["xMoved"].negated()]), [self.draft.fail("idle")])

    def _fresh(self, kind: Moving | Stopping, name: str, remark: str) -> Variable:
        """A flag that is FALSE where the block starts."""
        flag = self.draft.flag(name, remark)
        kind.forget_first(flag)
        return flag

    def _idle(self, standing: Variable) -> Expression:
        return self.draft.timer("fbStanding", standing, "StartTime", "T#2s", _START)

    def judged(
        self,
        kind: Moving,
        steps: Sequence[Step],
        value_of: Seen,
        must_begin: bool,
        success: Sequence[Statement],
        repeat: Sequence[Statement],
    ) -> list[Statement]:
        """Judges a motion: whether it is where it is to be, has not begun, or has ended before.

        If it `must_begin`, the condition may belong to the motion before: it must first be seen not to hold.
        """
        draft = self.draft
        computed, reached = self.all_of(steps, value_of)
        is_standing = self.stands(value_of)
        flags = {"xReached": draft.flag("xReached", "all conditions hold in one read")}
        flags["xStanding"] = self._fresh(kind, *_STANDING)
        slots: dict[str, Any] = {"computed": computed, "reached": reached, "success": success, "repeat": repeat}
        slots["is_idle"] = self._idle(flags["xStanding"])
        if is_standing is not None:
            flags["xMoved"] = self._fresh(kind, *_MOVED)
        if must_begin:
            flags["xChanged"] = self._fresh(kind, "xChanged", "a condition did not hold: the motion has begun")
        has_target = not must_begin and any(step.argument for step in steps)
        if has_target:
            flags["xAway"] = self._away()
        slots["is_standing"] = flags["xReached"] if is_standing is None else is_standing
        truths = {"shows_motion": is_standing is not None, "must_begin": must_begin, "has_target": has_target}
        return draft.action("JudgeMotion", **flags, **slots, **truths)

    def stopped(
        self,
        kind: Moving | Stopping,
        steps: Sequence[Step],
        value_of: Seen,
        success: Sequence[Statement],
        repeat: Statement,
        resend: Statement,
    ) -> list[Statement]:
        """Judges a stop: what stands may still begin to move where a command before was not seen to do so.

        A device that moves for long is stopped again: it may have begun a command that it had accepted before. A stop
        that is sent too often might restart its ramp each time. With an alarm, or without its servo, it has given up
        what it had accepted.
        """
        computed, is_standing = self.all_of(steps, value_of)
        standing = self._fresh(kind, *_STANDING)
        idle = self._idle(standing)
        moving = self._fresh(kind, "xMoving", "the device moves although it was told to stop")
        return self.draft.action(
            "JudgeStop",
            computed=computed,
            is_standing=is_standing,
            xStanding=standing,
            is_idle=idle,
            xMoving=moving,
            is_long=self.draft.timer("fbMoving", moving, "StartTime", "T#2s", _START),
            is_motion=isinstance(kind, Moving),
            success=success,
            repeat=[repeat],
            resend=[resend],
        )


def standstill(operands: Operands, task: Task, message: str = "") -> tuple[Step, ...]:
    """The waits of a task after its last command, without those for an acceptance."""
    following = task.steps[last_command(task) + 1 :]
    return tuple(step for step in following if step.action == "wait" and not shows_acceptance(operands, step, message))


_OPPOSITES = {"=": "<>", "<>": "="}


def opposite(test: Expression) -> Expression:
    """The negation of a comparison or of a truth."""
    if isinstance(test, Operation) and test.operator in _OPPOSITES:
        return Operation(_OPPOSITES[test.operator], test.operands, test.type)
    return test.negated()


def _real(value: Expression) -> Expression:
    kind = value.type
    assert isinstance(kind, Elementary)
    if kind.family not in ("signed", "unsigned"):
        raise NoBlock("what it compares is not a whole number")
    return value.converted(LREAL)


def _difference(first: Expression, second: Expression) -> Expression:
    return _real(first).combined("-", _real(second))
