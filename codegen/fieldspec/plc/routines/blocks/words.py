"""Blocks for tasks that are carried out over registers."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from fieldspec.layout.record import RegisterLayout
from fieldspec.model.address_space import WORD
from fieldspec.model.device import Device
from fieldspec.model.fact import ScalarValue
from fieldspec.model.operand import REGISTERS, Operand, Operands
from fieldspec.model.task import Step, Task
from fieldspec.model.watches import LASTING, MOVING, REFUSAL, Watch, before_effect, is_last_wait, watches
from fieldspec.plc.routines.blocks.lines import LineDraft
from fieldspec.plc.routines.blocks.operands import NoBlock, argument, constant, holds, kind_of, outputs_of
from fieldspec.plc.routines.blocks.ports import AXIS
from fieldspec.plc.routines.blocks.standard import chain
from fieldspec.plc.routines.blocks.tasks import TAKING_OVER, describe, end_steps, target
from fieldspec.plc.routines.expressions import (
    BITS,
    UINT,
    Elementary,
    Expression,
    Negation,
    Operation,
    Truth,
    Variable,
    Whole,
    converted,
    number,
)
from fieldspec.plc.routines.holders import Words
from fieldspec.plc.routines.routine import Assignment, Draft, Routine, Statement, when
from fieldspec.plc.routines.values import Wire, read, write
from fieldspec.plc.routines.world import World

_SETTLE = "T#100ms"


class Helpers:
    """The functions for single registers that blocks call, each once."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.routines: dict[str, Routine] = {}

    def from_words(self, register: RegisterLayout) -> Routine:
        """What takes the value of a register out of words."""
        return self._once(register, "from_words", self._unpacked)

    def to_words(self, register: RegisterLayout) -> Routine:
        """What puts the value of a register into words."""
        return self._once(register, "to_words", self._packed)

    def _once(self, register: RegisterLayout, way: str, make: Callable[[str, RegisterLayout], Routine]) -> Routine:
        name = self.world.routine(register.name, way)
        if name not in self.routines:
            self.routines[name] = make(name, register)
        return self.routines[name]

    def _draft(self, name: str, register: RegisterLayout, way: str) -> Draft:
        fact = register.register
        about = f"{way}: {fact.printed_name or register.name}. {self.world.comment(fact, fact.value)}".strip()
        return Draft(name, "blocks", self.world.status, about)

    def _holder(self, draft: Draft, remark: str) -> Words:
        array = draft.declare("aWords", self.world.words, "in_out", remark)
        return Words(array, number(0), self.world.layout.device.byte_order)

    def _unpacked(self, name: str, register: RegisterLayout) -> Routine:
        draft = self._draft(name, register, "Words to register")
        holder = self._holder(draft, "is read only")
        kind = self.world.type_of(register.register.answer)
        value = draft.declare(self.world.variable(register.name, kind), kind, "output")
        draft.add(read(draft, self.world, Wire.of_answer(register), holder, 0, value))
        return draft.finished()

    def _packed(self, name: str, register: RegisterLayout) -> Routine:
        draft = self._draft(name, register, "Register to words")
        kind = self.world.type_of(register.register.value)
        value = draft.declare(self.world.variable(register.name, kind), kind, "input")
        holder = self._holder(draft, "receives the words")
        draft.add(write(draft, self.world, Wire.of_register(register), holder, 0, value))
        return draft.finished()


def has_only_registers(operands: Operands, task: Task) -> bool:
    """Whether all steps of a task act on registers."""
    targets = [operands.target(step.target) for step in task.steps]
    return bool(targets) and all(len(named) == 1 and named[0].scope == REGISTERS for named in targets)


def register_of(world: World, operand: Operand) -> RegisterLayout:
    """The register of an operand. Raises NoBlock unless it is single and in the first space of the device."""
    device: Device = world.layout.device
    for register in world.layout.registers:
        if register.register is operand.holder:
            group = next(group for group in device.groups if any(own is register.register for own in group.registers))
            if device.space("").unit != WORD or device.space_name(group.space) != device.space_name(""):
                raise NoBlock(f"{operand.path} is in another address space")
            if register.count > 1 or register.words > world.words.high + 1:
                raise NoBlock(f"{operand.path} is no single number")
            return register
    raise NoBlock(f"{operand.path} is no register")


def word_block(world: World, operands: Operands, helpers: Helpers, task: Task) -> Routine:
    """The block for a task; NoBlock is raised where it cannot be."""
    levelled = task.kind.startswith("read_")
    block = LineDraft(world, world.block(task.name), f"task {task.name}", AXIS, levelled)
    maker = _Maker(world, operands, helpers, block, task)
    if task.kind in TAKING_OVER:
        block.take_over(block.of_port("motion"))
    maker.all()
    describe(block, task)
    return block.block()


class _Maker:
    """The steps of a block while they are being added."""

    def __init__(self, world: World, operands: Operands, helpers: Helpers, block: LineDraft, task: Task) -> None:
        self.world, self.operands, self.helpers, self.block, self.task = world, operands, helpers, block, task
        self.watches = watches(world.layout.device, operands, task)
        self.watches = [watch for watch in self.watches if watch.operand.scope == REGISTERS]

    def all(self) -> None:
        """Adds the steps."""
        task, block = self.task, self.block
        first = before_effect(task)
        ends = end_steps(task)
        begins: dict[int, int] = {}
        if task.kind in MOVING or first:
            self._looks(self.watches, [(self._target(step), step) for step in task.steps[:first]], once=True)
        if not block.levelled and task.kind not in LASTING:
            block.limit()
        at = first
        while at < len(task.steps):
            begins[at] = block.next
            if ends is not None and task.kind in LASTING and at == ends[1]:
                self._lasting()
                begins[at] = block.next
            at = self._step(at)
        if ends is not None:
            after = begins.get(ends[1] + 1, block.next)
            block.hold = task.kind in LASTING
            block.ends_by(begins[ends[0]], begins[ends[1]], after - 1)

    def _target(self, step: Step) -> Operand:
        return target(self.operands, step)

    def _step(self, at: int) -> int:
        """Adds a step of the task, or several that write bits of one word; gives the place of the next one."""
        step = self.task.steps[at]
        operand = self._target(step)
        if step.action == "read":
            self._reads(operand)
        elif step.action == "wait" and REFUSAL in operand.roles:
            self.watches.append(Watch(operand, value_of(step), "exception"))
        elif step.action == "wait":
            if is_last_wait(self.task, step):
                self.block.settle_input(_SETTLE)
                self.block.settle()
            self._looks(self.watches, [(operand, step)], once=False)
        elif operand.bit is not None:
            return self._bits(at)
        elif step.action == "write":
            self._writes(operand, self._value(operand, step))
        else:
            raise NoBlock(f"{operand.path} is not a bit")
        return at + 1

    def _value(self, operand: Operand, step: Step) -> Expression:
        register = register_of(self.world, operand)
        if step.argument:
            return argument(self.block, step.argument, operand, register.register.value)
        assert step.value is not None
        kind = kind_of(self.world, operand, register.register.value)
        return constant(self.world, operand, register.register.value, step.value, kind)

    def _address(self, register: RegisterLayout, writing: bool) -> list[Statement]:
        port = self.block.of_port
        return [
            Assignment(port("write"), Truth(writing)),
            Assignment(port("address"), Whole(register.address, UINT)),
            Assignment(port("count"), number(register.words)),
        ]

    def _variable(self, register: RegisterLayout) -> Variable:
        kind = self.world.type_of(register.register.answer)
        return self.block.declared_once(self.world.variable(f"{register.name}_read", kind), kind, "local")

    def _asks(self, register: RegisterLayout, then: Sequence[Statement]) -> int:
        """Adds a step that reads a register into its variable."""
        helper = self.helpers.from_words(register)
        variable = self._variable(register)
        call = helper.called(
            **{declared.variable.name: variable for declared in helper.of_role("output")},
            aWords=self.block.of_port("words"),
        )
        take = self.block.attempt(call, tuple(then), "damaged")
        return self.block.request(self.block.ask(*self._address(register, False)), take)

    def _writes(self, operand: Operand, value: Expression) -> None:
        """Adds a step that writes a register."""
        register = register_of(self.world, operand)
        helper = self.helpers.to_words(register)
        call = helper.called(
            **{declared.variable.name: value for declared in helper.of_role("input")},
            aWords=self.block.of_port("words"),
        )
        fill = self.block.attempt(call, tuple(self.block.ask(*self._address(register, True))), "request")
        self.block.request(fill, [self.block.go(self.block.next + 1)])

    def _bits(self, at: int) -> int:
        """Adds steps that change bits of one word and leave the others: consecutive writes together."""
        steps = self.task.steps
        operand = self._target(steps[at])
        last = at + 1
        if steps[at].action == "write":
            while (
                last < len(steps)
                and steps[last].action == "write"
                and self._target(steps[last]).holder is operand.holder
            ):
                last += 1
        if not operand.readable:
            raise NoBlock(f"{operand.holder.name} cannot be read, so that none of its bits can be written alone")
        register = register_of(self.world, operand)
        word = self._variable(register)
        if steps[at].action == "pulse":
            self._asks(register, [_masked(word, operand, False), self.block.go(self.block.next + 1)])
            self._writes(operand, word)
            self.block.settle_input(_SETTLE)
            self.block.settle()
        # What a later step sets may still be set by a task that failed: then it would count for the new values.
        changes: list[Statement] = [
            _masked(word, self._target(later), False)
            for later in steps[last:]
            if later.action == "set" and self._target(later).holder is operand.holder and steps[at].action == "write"
        ]
        for step in steps[at:last]:
            changes += self._changed(self._target(step), step, word)
        self._asks(register, [*changes, self.block.go(self.block.next + 1)])
        self._writes(operand, word)
        return last

    def _changed(self, operand: Operand, step: Step, word: Variable) -> list[Statement]:
        """What changes bits in a word that was read."""
        bit = operand.bit
        assert bit is not None
        if step.action != "write":
            return [_masked(word, operand, step.action != "clear")]
        if bit.width > 1:
            raise NoBlock(f"{operand.path} is several bits")
        if not step.argument:
            return [_masked(word, operand, bool(step.value))]
        value = argument(self.block, step.argument, operand, None)
        return [when(value, [_masked(word, operand, True)], [_masked(word, operand, False)])]

    def _reads(self, operand: Operand) -> None:
        register = register_of(self.world, operand)
        value = register.register.answer
        filled = outputs_of(self.block, operand.fact.name, operand, value, self._variable(register))
        self._asks(register, [*filled, self.block.go(self.block.next + 1)])

    def _looks(self, watched: Sequence[Watch], wanted: Sequence[tuple[Operand, Step]], once: bool) -> None:
        """Adds steps that read what is watched and what is waited for: `once`, or until it is there."""
        needed = [register_of(self.world, watch.operand) for watch in watched]
        needed += [register_of(self.world, operand) for operand, _ in wanted]
        registers = list({id(register): register for register in needed}.values())
        first, last = self.block.next, self.block.next + len(registers) - 1
        for register in registers:
            behind = self.block.next == last
            wrong = [
                (self._missing(watch), [self.block.fail(watch.reason)])
                for watch in watched
                if register_of(self.world, watch.operand) is register
            ]
            go: Statement = self.block.go(self.block.next + 1)
            if behind and wanted:
                tests = [(self._missing(Watch(o, value_of(step), "")), o) for o, step in wanted]
                missing = [test for test, _ in tests]
                otherwise = self.block.fail("unready") if once else self.block.go(first)
                go = chain([(test, [otherwise]) for test in missing], [go])
            elif behind and not once:
                go = self.block.go(first)
            self._asks(register, [chain(wrong, [go])] if wrong else [go])

    def _missing(self, watch: Watch) -> Expression:
        register = register_of(self.world, watch.operand)
        variable = self._variable(register)
        test = holds(self.world, watch.operand, register.register.answer, watch.value, variable)
        return opposite(test)

    def _lasting(self) -> None:
        """Adds the steps in which a motion goes on, until Execute is FALSE."""
        if self.watches:
            self._looks(self.watches, [], once=False)
        else:
            self.block.add([])


def value_of(step: Step) -> ScalarValue:
    """What a step waits for. Raises NoBlock where that is an argument, or one of several values."""
    if len(step.wanted) != 1:
        raise NoBlock(f"what `{step.target}` is waited for is no single value")
    return step.wanted[0]


_OPPOSITES = {"=": "<>", "<>": "="}


def opposite(test: Expression) -> Expression:
    """NOT of a comparison or of a truth."""
    if isinstance(test, Operation) and test.operator in _OPPOSITES:
        return Operation(_OPPOSITES[test.operator], test.operands, test.type)
    return Negation(test)


def _masked(word: Variable, operand: Operand, on: bool) -> Statement:
    """What sets a bit of a word to 1 or 0."""
    assert operand.bit is not None
    return masked(word, operand.bit.mask, on)


def masked(word: Expression, mask: int, on: bool) -> Statement:
    """What sets bits of a word to 1 or 0."""
    kind = word.type
    assert isinstance(kind, Elementary)
    bits = BITS[kind.size]
    literal = Whole(mask if on else bits.high & ~mask, bits, True)
    changed = Operation("OR" if on else "AND", (converted(word, bits), literal), bits)
    return Assignment(word, converted(changed, kind))
