"""What blocks wait for: conditions that hold together, and whether a motion has begun and where it has ended."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction as Ratio

from fieldspec.language.model.fact import ScalarValue
from fieldspec.language.model.operand import Operand, Operands
from fieldspec.language.model.task import Step, Task
from fieldspec.language.model.watches import Watch, halting_task, last_command, proves_target, shows_acceptance
from fieldspec.targets.controllers.routines.blocks.kinds import Branch, Moving, Stopping
from fieldspec.targets.controllers.routines.blocks.operands import NoBlock, holds, unit_of
from fieldspec.targets.controllers.routines.blocks.standard import REASONS, BlockDraft, assigned, chain
from fieldspec.targets.controllers.routines.blocks.tasks import target
from fieldspec.targets.controllers.routines.scaling import times
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import (
    LREAL,
    Conversion,
    Elementary,
    Expression,
    Fraction,
    Negation,
    Operation,
    Variable,
    compared,
    either,
    every,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Statement, when

Seen = Callable[[Operand], "Expression | None"]
"""What shows a fact where a block looks: its raw number, the word of a bit, or None where it is not to be seen."""
_START = "how long the device may stand before it moves, or off its target; not printed"


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
            return [], compared(raw, "=", expected)
        away = _difference(raw, expected)
        if step.relative:
            away = Operation("-", (_difference(raw, self._at_start(step, raw)), _real(expected)), LREAL)
        if operand.value is not None and operand.value.scaled:
            away = times(away, Ratio(operand.value.scale))
        distance = self.draft.declared_once("lrAway", LREAL, "local", "how far it is from where it was sent")
        computed: list[Statement] = [Assignment(distance, away)]
        if step.within is None:
            return computed, compared(distance, "=", Fraction("0.0"))
        window = self._window(step, operand)
        minus = Operation("-", (Fraction("0.0"), window), LREAL)
        return computed, every([compared(distance, "<=", window), compared(distance, ">=", minus)])

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
        draft = self.draft
        standing = draft.flag("xStanding", "the device stands")
        moved = draft.flag("xMoved", "the device was seen to move")
        idle = draft.timer("fbStanding", standing, "StartTime", "T#2s", _START)
        for flag in (standing, moved):
            kind.forget_first(flag)
        moves = when(Negation(standing), [assigned(moved, True), *draft.action("SeeMotion")])
        return [Assignment(standing, is_standing), moves], (every([idle, Negation(moved)]), [draft.fail("idle")])

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
        reached_flag = draft.flag("xReached", "all conditions hold in one read")
        standing = draft.flag("xStanding", "the device stands")
        idle = draft.timer("fbStanding", standing, "StartTime", "T#2s", _START)
        body = [
            *computed,
            Assignment(reached_flag, reached),
            Assignment(standing, reached_flag if is_standing is None else is_standing),
        ]
        fresh, wrong = [standing], [draft.fail("idle")]
        evidence: list[Expression] = []
        if is_standing is not None:
            moved = draft.flag("xMoved", "the device was seen to move")
            fresh.append(moved)
            body.append(when(Negation(standing), [assigned(moved, True), *draft.action("SeeMotion")]))
            wrong = [when(moved, [draft.fail("short")], wrong)]
            evidence.append(moved)
        enough: Expression = reached_flag
        if must_begin:
            changed = draft.flag("xChanged", "a condition did not hold: the motion has begun")
            fresh.append(changed)
            body.append(when(Negation(reached_flag), [assigned(changed, True)]))
            enough = every([reached_flag, changed])
        elif any(step.argument for step in steps):
            enough = every([reached_flag, either([self._away(), *evidence, idle])])
        for flag in fresh:
            kind.forget_first(flag)
        return [*body, chain([(enough, success), (idle, wrong)], repeat)]

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
        that is sent too often might restart its ramp each time.
        """
        draft = self.draft
        computed, is_standing = self.all_of(steps, value_of)
        standing = draft.flag("xStanding", "the device stands")
        kind.forget_first(standing)
        idle = draft.timer("fbStanding", standing, "StartTime", "T#2s", _START)
        moving = draft.flag("xMoving", "the device moves although it was told to stop")
        kind.forget_first(moving)
        long = draft.timer("fbMoving", moving, "StartTime", "T#2s", _START)
        unseen = draft.of_axis("unseen")
        may_begin: list[Expression] = [unseen, Negation(idle)]
        if isinstance(kind, Moving):
            # With an alarm, or without its servo, the device has given up what it had accepted.
            known = (REASONS[reason] for reason in ("alarm", "servo"))
            may_begin += [compared(draft.variable("uiFirstReason"), "<>", reason) for reason in known]
        waits = when(every(may_begin), [repeat, assigned(moving, False)], [assigned(unseen, False), *success])
        onward = when(long, [resend, assigned(moving, False)], [repeat, assigned(moving, True)])
        return [*computed, Assignment(standing, is_standing), when(standing, [waits], [onward])]


def standstill(operands: Operands, task: Task, message: str = "") -> tuple[Step, ...]:
    """The waits of a task after its last command, without those for an acceptance."""
    following = task.steps[last_command(task) + 1 :]
    return tuple(step for step in following if step.action == "wait" and not shows_acceptance(operands, step, message))


_OPPOSITES = {"=": "<>", "<>": "="}


def opposite(test: Expression) -> Expression:
    """The negation of a comparison or of a truth."""
    if isinstance(test, Operation) and test.operator in _OPPOSITES:
        return Operation(_OPPOSITES[test.operator], test.operands, test.type)
    return Negation(test)


def _real(value: Expression) -> Expression:
    kind = value.type
    assert isinstance(kind, Elementary)
    if kind.family not in ("signed", "unsigned"):
        raise NoBlock("what it compares is not a whole number")
    return Conversion(value, LREAL)


def _difference(first: Expression, second: Expression) -> Expression:
    return Operation("-", (_real(first), _real(second)), LREAL)
