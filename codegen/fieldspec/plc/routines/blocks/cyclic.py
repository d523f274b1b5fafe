"""Blocks for tasks that are carried out by a telegram: they set the request and look at the response in each scan."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.classes import dataclass
from fieldspec.layout.frame import MessageLayout
from fieldspec.layout.record import FieldLayout
from fieldspec.model.operand import Operand, Operands
from fieldspec.model.task import Step, Task
from fieldspec.model.watches import LASTING, REFUSAL, STARTING, before_effect, is_last_wait, watches
from fieldspec.plc.routines.blocks.operands import NoBlock, argument, constant, holds, kind_of, outputs_of
from fieldspec.plc.routines.blocks.ports import axis_key, member
from fieldspec.plc.routines.blocks.standard import BlockDraft, chain
from fieldspec.plc.routines.blocks.tasks import TAKING_OVER, describe, end_steps, target
from fieldspec.plc.routines.blocks.words import masked, opposite, value_of
from fieldspec.plc.routines.expressions import (
    BOOL,
    TIMER,
    Expression,
    Member,
    Negation,
    Truth,
    Variable,
    compared,
    every,
)
from fieldspec.plc.routines.routine import Assignment, Routine, Statement, when
from fieldspec.plc.routines.world import World

_BY_LEVEL = frozenset({"homing_start", "jog_positive", "jog_negative", "jog_start"})
"""Those of them that no other motion needs. A block clears them even where another one has taken over."""
_REQUEST, _RESPONSE = "request", "response"


def cyclic_block(world: World, operands: Operands, message: MessageLayout, task: Task) -> Routine:
    """The block for a task with one telegram; NoBlock is raised where it cannot be."""
    named = message.name in task.name
    name = world.block(task.name) if named else world.block(message.name, task.name)
    levelled = task.kind.startswith("read_")
    block = BlockDraft(world, name, f"telegram {message.name}", levelled)
    maker = _Maker(world, operands, block, message, task)
    if task.kind in TAKING_OVER:
        block.take_over(member(world, axis_key(message), "motion", maker.axis))
    maker.all()
    describe(block, task, maker.remark)
    return maker.block_of()


@dataclass(frozen=True, slots=True)
class _Bit:
    """A bit of the request: its word, its mask, and the roles of what it stands for."""

    word: Expression
    mask: int
    roles: frozenset[str]

    def put(self, on: bool) -> Statement:
        """The statement that sets or clears it."""
        return masked(self.word, self.mask, on)


class _Maker:
    """The steps of a block while they are being added."""

    def __init__(self, world: World, operands: Operands, block: BlockDraft, message: MessageLayout, task: Task) -> None:
        self.world, self.operands, self.block, self.message, self.task = world, operands, block, message, task
        self.axis = block.struct("axis", axis_key(message), "the same for all blocks of the telegram")
        self.set: list[_Bit] = []
        self.pulsed: list[_Bit] = []
        self.setpoints: list[tuple[Expression, Variable]] = []
        self.ending: list[Statement] = []
        self.lowered: list[Statement] = []
        self.commanding: Variable | None = None
        self.remark = ""

    def all(self) -> None:
        """Adds the steps."""
        task, block = self.task, self.block
        waiting = [step for step in task.steps if step.action == "wait"]
        first = before_effect(task)
        ends = end_steps(task) if task.kind in LASTING else None
        if waiting and task.kind not in LASTING and not block.levelled:
            block.limit()
        if first:
            missing = [self._missing(step) for step in task.steps[:first]]
            branches: list[tuple[Expression, Sequence[Statement]]] = [
                (test, [block.fail("unready")]) for test in missing
            ]
            block.add([chain(branches, [block.go(2)])])
        if task.kind == "reset_alarm":
            self._safe()
        for at, step in enumerate(task.steps[first:], first):
            if ends is not None and at == ends[1]:
                self._lasting()
            self._step(step)

    def _lasting(self) -> None:
        """Adds the step in which a motion goes on, until Execute is FALSE. What is commanded follows its inputs.

        Where the response shows that the speed is reached, it counts once the command has stood for some time.
        """
        block = self.block
        end = block.go(block.next + 1)
        following: list[Statement] = []
        if self.setpoints:
            self.remark = (
                "While Execute is TRUE, the request follows the inputs. The last step is carried out whatever ends the "
                "block."
            )
            commanding = self.commanding = block.declare("xCommanding", BOOL, "local")
            following = [
                Assignment(commanding, Truth(True)),
                *(Assignment(place, raw) for place, raw in self.setpoints),
            ]
            reached = self.operands.with_role("speed_reached", self.message.name)
            if len(reached) == 1:
                block.settle_input("T#20ms")
                steady = block.steady = block.declare("xSteady", BOOL, "local")
                at_speed = block.declare("InVelocity", BOOL, "output", "the commanded speed is reached")
                place, field = self._place(reached[0])
                shown = holds(self.world, reached[0], field.value, True, place)
                same = every([compared(place, "=", raw) for place, raw in self.setpoints])
                settled = Member(block.declared_once("fbSettle", TIMER, "local"), "Q", BOOL)
                following = [
                    Assignment(steady, same),
                    *following,
                    Assignment(at_speed, every([steady, settled, shown])),
                ]
                self.lowered += [Assignment(steady, Truth(False)), Assignment(at_speed, Truth(False))]
        converted = [*block.at_start, when(block.unharmed(), following)] if following else []
        block.add([when(Negation(block.start), [end], converted)])

    def _safe(self) -> None:
        """Clears first what would let something go on when the alarm is gone."""
        bits = [self._bit(operand) for operand in self._starting()]
        words: dict[Expression, int] = {}
        for bit in bits:
            words[bit.word] = words.get(bit.word, 0) | bit.mask
        if words:
            self.remark = (
                "Clears the bits that switch on and start first, so that nothing goes on by itself when the alarm is "
                "gone."
            )
            self.block.settle_input("T#20ms")
            go = self.block.go(self.block.next + 1)
            self.block.add([*(masked(word, mask, False) for word, mask in words.items()), go])
            self.block.settle()

    def _starting(self) -> list[Operand]:
        path = f"messages/{self.message.name}/{_REQUEST}/"
        return [
            operand
            for operand in self.operands.all
            if operand.path.startswith(path) and STARTING & {*operand.roles} and operand.bit is not None
        ]

    def _operand(self, step: Step) -> Operand:
        return target(self.operands, step, self.message.name)

    def _place(self, operand: Operand) -> tuple[Expression, FieldLayout]:
        """The member of the port for the field of an operand."""
        for name, record in ((_REQUEST, self.message.request), (_RESPONSE, self.message.response)):
            for field in record.fields:
                if field.field is operand.holder and field.value is not None:
                    struct = member(self.world, axis_key(self.message), name, self.axis)
                    kind = self.world.type_of(field.value)
                    return Member(struct, self.world.member(record.name, field.name), kind), field
        raise NoBlock(f"{operand.path} is not in {self.message.name}")

    def _bit(self, operand: Operand) -> _Bit:
        if operand.bit is None:
            raise NoBlock(f"{operand.path} is not a bit")
        word, _ = self._place(operand)
        return _Bit(word, operand.bit.mask, frozenset(operand.roles))

    def _missing(self, step: Step) -> Expression:
        operand = self._operand(step)
        place, field = self._place(operand)
        return opposite(holds(self.world, operand, field.value, value_of(step), place))

    def _step(self, step: Step) -> None:
        block, operand = self.block, self._operand(step)
        on = block.next + 1
        if step.action == "wait":
            if is_last_wait(self.task, step):
                block.settle_input("T#20ms")
                block.settle()
            then = [*(bit.put(False) for bit in self.pulsed), block.go(block.next + 1)]
            refused = [block.fail("exception")] if REFUSAL in operand.roles else []
            block.add([when(opposite(self._missing(step)), then, refused)])
        elif step.action == "read":
            place, field = self._place(operand)
            block.add([*outputs_of(block, operand.fact.name, operand, field.value, place), block.go(on)])
        elif step.action == "pulse":
            bit = self._bit(operand)
            self.pulsed.append(bit)
            block.settle_input("T#20ms")
            block.add([bit.put(False), block.go(on)])
            block.settle()
            block.add([bit.put(True), block.go(block.next + 1)])
        elif step.action in ("set", "clear"):
            bit = self._bit(operand)
            if step.action == "set":
                self.set.append(bit)
            block.add([bit.put(step.action == "set"), block.go(on)])
        elif step.action == "write" and operand.bit is None:
            place, field = self._place(operand)
            if step.argument:
                value: Expression = argument(block, step.argument, operand, field.value)
                assert isinstance(value, Variable)
                if self.task.kind in LASTING:
                    self.setpoints.append((place, value))
                    return
            else:
                assert step.value is not None
                kind = kind_of(self.world, operand, field.value)
                value = constant(self.world, operand, field.value, step.value, kind)
            block.add([Assignment(place, value), block.go(on)])
            if self.task.kind in LASTING and step is self.task.steps[-1]:
                self.ending.append(Assignment(place, value))
        else:
            raise NoBlock(f"`{step.action} {step.target}` is nothing that a telegram can do")

    def block_of(self) -> Routine:
        """The block."""
        block = self.block
        begin = block.begins()
        valid = member(self.world, axis_key(self.message), "valid", self.axis)
        wrong: list[tuple[Expression, Sequence[Statement]]] = [(Negation(valid), [block.fail("transport")])]
        for watch in watches(self.world.layout.device, self.operands, self.task, self.message.name):
            place, field = self._place(watch.operand)
            test = opposite(holds(self.world, watch.operand, field.value, watch.value, place))
            wrong.append((test, [block.fail(watch.reason)]))
        steps = block.selected([step.ask for step in block.steps])
        working = when(Negation(block.busy), begin, [chain(wrong), when(block.unharmed(), steps)])
        tail = [block.again()] if block.levelled else self._tail()
        return block.finished([*block.timers(), *block.edges, working, when(block.busy, tail)])

    def _tail(self) -> list[Statement]:
        block = self.block
        assert block.abort is not None
        low = [bit.put(False) for bit in self.pulsed]
        starting = [bit for bit in self.set if bit.roles & STARTING]
        own = [bit.put(False) for bit in starting if bit.roles & _BY_LEVEL]
        undone = [bit.put(False) for bit in starting if not bit.roles & _BY_LEVEL]
        late = [when(block.late, [block.fail("late")])] if block.late is not None else []
        taken = [Negation(block.displaced)] if block.displaced is not None else []
        undoing = [when(every([*taken, Negation(block.done)]), undone)] if undone else []
        owning = [when(Negation(block.done), own)] if own else []
        ending = self.ending
        if self.commanding is not None:
            ending = [when(self.commanding, [*ending, Assignment(self.commanding, Truth(False))])]
        return [*late, block.outcome(), block.over(*low, *owning, *undoing, *self.lowered, *ending)]
