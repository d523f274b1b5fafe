"""Blocks for tasks that are carried out over registers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from fieldspec.codec.layout.read_plan import read_plan
from fieldspec.codec.layout.record import RegisterLayout
from fieldspec.language.model.address_space import WORD
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Bit
from fieldspec.language.model.operand import REGISTERS, Operand, Operands
from fieldspec.language.model.task import Step, Task
from fieldspec.language.model.value import Value
from fieldspec.language.model.watches import before_effect, conditions
from fieldspec.targets.controllers.routines.blocks.line_tasks import Decide, LineTask, Unit
from fieldspec.targets.controllers.routines.blocks.lines import LineDraft
from fieldspec.targets.controllers.routines.blocks.operands import NoBlock, argument, bit_of_argument, constant, kind_of
from fieldspec.targets.controllers.routines.blocks.progress import Seen
from fieldspec.targets.controllers.routines.drafts import Draft
from fieldspec.targets.controllers.routines.holders import Words
from fieldspec.targets.controllers.routines.named_numbers import mask_of, named
from fieldspec.targets.controllers.routines.values import Wire, read, write
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import (
    BITS,
    INT,
    UINT,
    Elementary,
    Expression,
    Negation,
    Operation,
    Truth,
    Variable,
    number,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Routine, Statement, when

_SETTLE = "T#100ms"


class Helpers:
    """The functions for single registers that blocks call, each made once."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.routines: dict[str, Routine] = {}
        self.runs = [range(block.start, block.end) for block in read_plan(world.layout).blocks if not block.space]

    def from_words(self, register: RegisterLayout) -> Routine:
        """The function that takes the value of a register out of words."""
        return self._once(register, "from_words", self._unpacked)

    def to_words(self, register: RegisterLayout) -> Routine:
        """The function that puts the value of a register into words."""
        return self._once(register, "to_words", self._packed)

    def _once(
        self, register: RegisterLayout, direction: str, make: Callable[[str, RegisterLayout], Routine]
    ) -> Routine:
        name = self.world.routine(register.name, direction)
        if name not in self.routines:
            self.routines[name] = make(name, register)
        return self.routines[name]

    def _draft(self, name: str, register: RegisterLayout, direction: str) -> Draft:
        fact = register.register
        description = (
            f"{direction}: {fact.printed_name or register.name}. {self.world.comment(fact, fact.value)}".strip()
        )
        return Draft(self.world, name, "blocks", description)

    def _holder(self, draft: Draft, first: Expression, remark: str) -> Words:
        array = draft.declare("aWords", self.world.words, "in_out", remark)
        return Words(array, first, self.world.layout.device.byte_order)

    def _unpacked(self, name: str, register: RegisterLayout) -> Routine:
        draft = self._draft(name, register, "Words to register")
        first = draft.declare("iFirst", INT, "input", "where its first word is")
        holder = self._holder(draft, first, "is read only")
        kind = self.world.type_of(register.register.answer)
        value = draft.declare(self.world.variable(register.name, kind), kind, "output")
        draft.add(read(draft, Wire.of_answer(register), holder, value))
        return draft.finished()

    def _packed(self, name: str, register: RegisterLayout) -> Routine:
        draft = self._draft(name, register, "Register to words")
        kind = self.world.type_of(register.register.value)
        value = draft.declare(self.world.variable(register.name, kind), kind, "input")
        holder = self._holder(draft, number(0), "receives the words")
        draft.add(write(draft, Wire.of_register(register), holder, value))
        return draft.finished()


def has_only_registers(operands: Operands, task: Task) -> bool:
    """Whether all steps of a task act on registers."""
    targets = [operands.target(step.target) for step in task.steps]
    return bool(targets) and all(
        len(operands_of_step) == 1 and operands_of_step[0].scope == REGISTERS for operands_of_step in targets
    )


def register_of(world: World, operand: Operand) -> RegisterLayout:
    """The register of an operand. Raises NoBlock unless it is single and in the first space of the device."""
    device: Device = world.layout.device
    for register in world.layout.registers:
        if register.register is operand.holder:
            group = next(group for group in device.groups if any(own is register.register for own in group.registers))
            if device.space("").unit != WORD or device.space_name(group.space) != device.space_name(""):
                raise NoBlock(f"{operand.path} is in another address space")
            if register.count > 1 or register.words > world.words.high + 1:
                raise NoBlock(f"{operand.path} is not a single number")
            return register
    raise NoBlock(f"{operand.path} is not a register")


class WordTask(LineTask):
    """Adds the steps of a block that reads and writes registers."""

    def __init__(
        self,
        world: World,
        operands: Operands,
        helpers: Helpers,
        draft: LineDraft,
        tasks: Sequence[Task],
        known: LineTask | None,
    ) -> None:
        super().__init__(world, operands, draft, tasks, known)
        self.helpers = helpers
        self.watches = [watch for watch in self.watches if watch.operand.scope == REGISTERS]

    def units(self, task: Task, first: int, stop: int) -> Iterable[Unit]:
        """See `LineTask`."""
        index = first
        while index < stop:
            step = task.steps[index]
            last = index + 1
            if step.action == "wait":
                waits = conditions(self.operands, task, index)[: stop - index]
                last = index + len(waits)
                yield Unit(index, last, False, waits)
            elif step.action == "read":
                yield Unit(index, last, False, (), (step,))
            else:
                holder = self.target(step).holder
                while (
                    step.action == "write"
                    and self.target(step).bit is not None
                    and last < stop
                    and task.steps[last].action == "write"
                    and self.target(task.steps[last]).holder is holder
                ):
                    last += 1
                yield Unit(index, last, True)
            index = last

    def first_units(self) -> Iterable[tuple[Task, Unit]]:
        """See `LineTask`."""
        first = before_effect(self.task)
        yield self.task, Unit(0, first, False, self.task.steps[:first])

    def watching_unit(self) -> tuple[Task, Unit] | None:
        """See `LineTask`."""
        return (self.task, Unit(0, 0, False)) if self.watches else None

    def seen(self, task: Task, unit: Unit) -> Seen:
        """See `LineTask`."""
        if unit.commands:
            return lambda operand: None
        return lambda operand: self._variable(register_of(self.world, operand))

    def content(self, operand: Operand) -> Value | None:
        """See `LineTask`."""
        return register_of(self.world, operand).register.answer

    def perform(self, task: Task, unit: Unit, operands: Sequence[Operand], decide: Decide, remark: str) -> None:
        """See `LineTask`. Raises NoBlock for what is not a bit."""
        if not unit.commands:
            self._observe(operands, decide, remark)
            return
        step = task.steps[unit.index]
        operand = self.target(step)
        if operand.bit is not None:
            self._bits(task, unit, decide, remark)
        elif step.action == "write":
            self._writes(operand, self._value(operand, step), decide, remark)
        else:
            raise NoBlock(f"{operand.path} is not a bit")

    def _value(self, operand: Operand, step: Step) -> Expression:
        register = register_of(self.world, operand)
        if step.argument:
            raw = argument(self.draft, step.argument, operand, register.register.value)
            self.conditions.arguments[step.argument] = raw
            return raw
        assert step.value is not None
        kind = kind_of(self.world, operand, register.register.value)
        return constant(self.world, operand, register.register.value, step.value, kind)

    def _address(self, register: RegisterLayout, words: int, writing: bool) -> list[Statement]:
        port = self.draft.of_port
        first = named(register.address, UINT, register.name, "address", hexadecimal=True)
        return [
            Assignment(port("write"), Truth(writing)),
            Assignment(port("address"), first),
            Assignment(port("count"), number(words)),
        ]

    def _variable(self, register: RegisterLayout) -> Variable:
        kind = self.world.type_of(register.register.answer)
        return self.draft.declared_once(self.world.variable(f"{register.name}_read", kind), kind, "local")

    def _runs(self, operands: Iterable[Operand]) -> list[list[RegisterLayout]]:
        """The registers of some operands, in runs that one request reads."""
        registers = {id(register): register for register in (register_of(self.world, item) for item in operands)}
        runs: list[list[RegisterLayout]] = []
        limit = self.world.words.high + 1
        for register in sorted(registers.values(), key=lambda register: register.address):
            first = runs[-1][0] if runs else register
            end = register.address + register.words
            is_contiguous = any(run.start <= first.address and end <= run.stop for run in self.helpers.runs)
            if runs and is_contiguous and end - first.address <= limit:
                runs[-1].append(register)
            else:
                runs.append([register])
        return runs

    def _observe(self, operands: Sequence[Operand], decide: Decide, remark: str) -> None:
        """Adds steps that read registers into their variables, and decide."""
        runs = self._runs(operands)
        following = self.draft.next + len(runs)
        for run in runs:
            success = decide(following) if run is runs[-1] else [self.draft.go(self.draft.next + 1)]
            self._asks(run, success, remark)

    def _asks(self, run: Sequence[RegisterLayout], success: Sequence[Statement], remark: str = "") -> None:
        """Adds a step that reads a run of registers."""
        first = run[0].address
        calls: list[Expression] = []
        for register in run:
            helper = self.helpers.from_words(register)
            outputs = {declared.variable.name: self._variable(register) for declared in helper.of_role("output")}
            offset = number(register.address - first)
            calls.append(helper.called(**outputs, iFirst=offset, aWords=self.draft.of_port("words")))
        success = self.draft.attempts(calls, tuple(success), "damaged")
        words = max(register.address + register.words for register in run) - first
        self.draft.request(self.draft.ask(*self._address(run[0], words, False)), success, remark)

    def _writes(self, operand: Operand, value: Expression, decide: Decide, remark: str = "") -> None:
        """Adds a step that writes a register."""
        draft, register = self.draft, register_of(self.world, operand)
        helper = self.helpers.to_words(register)
        call = helper.called(
            **{declared.variable.name: value for declared in helper.of_role("input")},
            aWords=draft.of_port("words"),
        )
        address = self._address(register, register.words, True)
        fill = draft.attempts([call], tuple(draft.ask(*address)), "request")
        draft.request(fill, decide(draft.next + 1), remark)

    def _next(self, following: int) -> list[Statement]:
        return [self.draft.go(following)]

    def _bits(self, task: Task, unit: Unit, decide: Decide, remark: str) -> None:
        """Adds steps that change bits of one word and leave the others: consecutive writes together."""
        steps = task.steps
        operand = self.target(steps[unit.index])
        if not operand.readable:
            raise NoBlock(f"{operand.holder.name} cannot be read, so that none of its bits can be written alone")
        register = register_of(self.world, operand)
        word = self._variable(register)
        action = steps[unit.index].action
        if action == "pulse":
            self._asks([register], [_masked(word, operand, False), self.draft.go(self.draft.next + 1)])
            self._writes(operand, word, self._next)
            self.draft.settle(_SETTLE)
        # What a later step sets may still be set by a task that failed: then it would count for the new values.
        changes: list[Statement] = [
            _masked(word, self.target(later), False)
            for later in steps[unit.behind :]
            if later.action == "set" and self.target(later).holder is operand.holder and action == "write"
        ]
        for step in steps[unit.index : unit.behind]:
            changes += self._changed(task, self.target(step), step, word)
        self._asks([register], [*changes, self.draft.go(self.draft.next + 1)])
        self._writes(operand, word, decide, remark)

    def _changed(self, task: Task, operand: Operand, step: Step, word: Variable) -> list[Statement]:
        """The statements that change the bits of an operand in a word that was read."""
        bit = operand.bit
        assert bit is not None
        if step.action != "write":
            return [_masked(word, operand, step.action != "clear")]
        if bit.width > 1:
            raise NoBlock(f"{operand.path} is several bits")
        if not step.argument:
            return [_masked(word, operand, bool(step.value))]
        if step.argument_bit is not None:
            value = bit_of_argument(self.draft, task, step)
        else:
            value = argument(self.draft, step.argument, operand, None)
        return [when(value, [_masked(word, operand, True)], [_masked(word, operand, False)])]


def _masked(word: Variable, operand: Operand, on: bool) -> Statement:
    """The statement that sets or clears the bit of an operand in a word."""
    assert operand.bit is not None
    return masked(word, [operand.bit], on)


def masked(word: Expression, changed: Iterable[Bit], on: bool) -> Statement:
    """The statement that sets or clears some bits of a word."""
    kind = word.type
    assert isinstance(kind, Elementary)
    bits = BITS[kind.size]
    by_place = {bit.first: bit for bit in changed}
    masks = [mask_of(by_place[first], bits) for first in sorted(by_place)]
    mask = masks[0] if len(masks) == 1 else Operation("OR", tuple(masks), bits)
    operands = (word.converted(bits), mask if on else Negation(mask, bits))
    return Assignment(word, Operation("OR" if on else "AND", operands, bits).converted(kind))
