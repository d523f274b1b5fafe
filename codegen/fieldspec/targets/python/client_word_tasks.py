"""Tasks of clients over registers and parameters."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.language.model.fact import ScalarValue
from fieldspec.language.model.operand import PARAMETERS, REGISTERS, Operand
from fieldspec.language.model.registers import Parameter, Register, Subindex
from fieldspec.language.model.task import Step
from fieldspec.language.model.watches import LASTING, REFUSAL, before_effect, is_command, last_command, watches
from fieldspec.targets.python.client_names import Argument, NoTask, is_scaled, raw_number
from fieldspec.targets.python.client_tasks import TaskDraft, TaskView, condition, ends

_SCOPES = (REGISTERS, PARAMETERS)


class WordTask:
    """A task over registers and parameters."""

    def __init__(self, draft: TaskDraft) -> None:
        self.draft, self.names, self.task = draft, draft.names, draft.task
        self.begins: dict[int, int] = {}
        self.relative: list[str] = []

    def view(self) -> TaskView:
        """The view of the method that carries out the task."""
        draft, task = self.draft, self.task
        watched = [
            self._condition(watch.operand, (watch.value,), watch.reason)
            for watch in watches(self.names.layout.device, draft.operands, task)
            if watch.operand.scope in _SCOPES
        ]
        first = before_effect(task)
        ending = ends(task)
        looked = [self._condition(draft.target(step), step.wanted, "unready") for step in task.steps[:first]]
        if watched or looked:
            draft.steps.append(f"task.look({', '.join(looked)})")
        noted = len(draft.steps)
        accepted = draft.accepted()
        jog = task.kind in LASTING
        index = first
        while index < len(task.steps):
            self.begins[index] = len(draft.steps)
            index = self._add(index)
        for target in self.relative:
            draft.steps.insert(noted, f"task.note({target})")
        commands = [self.begins[step] for step in self.begins if step <= accepted and is_command(task, step)]
        moved = max(commands, default=0)
        stops = self._halting()
        if ending is None:
            return draft.view("register_task", watched, [], moved + len(self.relative), False, halting=stops)
        begin, last = self.begins[ending[0]], self.begins[ending[1]]
        if jog:
            end = draft.steps[last:]
            del draft.steps[last:]
            return draft.view("register_task", watched, end, begin, True)
        end = self._step(ending[1], task.steps[ending[1]])
        return draft.view("register_task", watched, end, begin, False, halting=stops)

    def _halting(self) -> list[str]:
        """The steps of the task that ends a motion which has failed."""
        task = self.draft.halting()
        if task is None or any(self.draft.target(step).scope not in _SCOPES for step in task.steps):
            return []
        last = last_command(task)
        return [call for index in range(last + 1) for call in self._step(index, task.steps[index])]

    def _add(self, index: int) -> int:
        """Adds the calls of a step, or of the waits that hold together; gives the place of the next one."""
        draft, step = self.draft, self.task.steps[index]
        if step.action != "wait":
            draft.steps += self._step(index, step)
            return index + 1
        steps = draft.waited(index)
        operand = draft.target(step)
        if REFUSAL in operand.roles:
            draft.steps.append(f"task.refuse({self._condition(operand, step.wanted, 'refused')})")
        else:
            draft.steps += draft.wait_call(index, ", ".join(self._awaited(wait) for wait in steps))
        return index + len(steps)

    def _awaited(self, step: Step) -> str:
        """The argument of a wait: the expression of a condition, or the variable of a target."""
        draft, operand = self.draft, self.draft.target(step)
        if not step.argument:
            return self._condition(operand, step.wanted, "unready")
        before = next(other for other in self.task.steps if other.action == "write" and other.argument == step.argument)
        commanded, argument = draft.target(before), draft.arguments[step.argument]
        count = f"task.count({self.names.place(commanded)}, {argument.name})" if argument.in_unit else argument.name
        target = draft.target_of(step, operand.value, self.names.place(operand), count)
        if step.relative:
            self.relative.append(target)
        return target

    def _condition(self, operand: Operand, stated: Sequence[ScalarValue], reason: str) -> str:
        value = getattr(operand.holder, "value", None)
        return condition(self.names, operand, value, stated, self.names.place(operand), reason)

    def _step(self, index: int, step: Step) -> list[str]:
        draft = self.draft
        operand = draft.target(step)
        if step.action == "read" and isinstance(operand.fact, Subindex):
            return [self._read_element(operand.fact)]
        place, fact = self.names.place(operand), operand.holder
        assert isinstance(fact, Register | Parameter)
        if step.action == "read":
            return [self._read(operand, place, fact)]
        if operand.bit is not None:
            return self._bits(index, step, operand, place)
        if step.action != "write":
            raise NoTask(f"`{operand.path}` is not a bit")
        if not step.argument:
            return [f"task.write({place}, {raw_number(self.names.layout, fact.value, None, step.value)})"]
        argument = draft.argument(step.argument, fact.value)
        return [f"task.write{'_in_unit' if argument.in_unit else ''}({place}, {argument.name})"]

    def _read(self, operand: Operand, place: str, fact: Register | Parameter) -> str:
        draft = self.draft
        if operand.bit is not None:
            raise NoTask(f"`{operand.path}` is a bit")
        if isinstance(fact, Parameter) and fact.elements is not None:
            draft.results.append(f"list[{self.names.answer_type(fact.value, True)}]")
            return f"task.read_elements({place})"
        draft.results.append(self.names.answer_type(fact.value, fact.trigger))
        return f"task.read({place}, {is_scaled(fact.value)})"

    def _read_element(self, element: Subindex) -> str:
        indices = element.indices.intervals
        if len(indices) > 1 or indices[0][0] != indices[0][1] or is_scaled(element.value):
            raise NoTask(f"`{element.name}` is not a single number")
        self.draft.results.append(self.names.answer_type(element.value, True))
        return f"task.read_element({self.names.owner(element)}, {indices[0][0]})"

    def _bits(self, index: int, step: Step, operand: Operand, place: str) -> list[str]:
        bit = operand.bit
        assert bit is not None
        if not operand.readable:
            raise NoTask(f"`{operand.holder.name}` cannot be read, so that none of its bits can be written alone")
        change = f"task.change({place}, 0x{bit.mask:X}, "
        if step.action == "pulse":
            return [f"{change}0)", "task.settle()", f"{change}0x{bit.mask:X})"]
        if step.action in ("set", "clear"):
            return [f"{change}0x{bit.mask if step.action == 'set' else 0:X})"]
        if bit.width > 1:
            raise NoTask(f"`{operand.path}` is several bits")
        # What a later step sets may still be set by a task that failed: then it would count for the new values.
        later = [
            other.bit
            for after in self.task.steps[index + 1 :]
            if after.action == "set"
            and (other := self.draft.target(after)).holder is operand.holder
            and other.bit is not None
        ]
        before = self.task.steps[index - 1] if index else None
        is_rewritten = (
            before is not None and before.action == "write" and self.draft.target(before).holder is operand.holder
        )
        cleared = [f"task.change({place}, 0x{other.mask:X}, 0x0)" for other in later if not is_rewritten]
        if not step.argument:
            return [*cleared, f"{change}0x{bit.mask if step.value else 0:X})"]
        if step.argument_bit is not None:
            return [*cleared, *self._number(step, operand, place)]
        if step.argument not in self.draft.arguments:
            self.draft.arguments[step.argument] = Argument(self.draft.scope.take(step.argument), "bool", False)
        argument = self.draft.arguments[step.argument]
        return [*cleared, f"{change}0x{bit.mask:X} if {argument.name} else 0)"]

    def _number(self, step: Step, operand: Operand, place: str) -> list[str]:
        """The call that writes all bits of a number at once, at the step of its lowest bit."""
        draft = self.draft
        if step.argument_bit:
            return []
        argument = Argument(draft.scope.take(step.argument), "int", False)
        draft.arguments[step.argument] = argument
        masks: list[str] = []
        for other in self.task.bits_of(step.argument):
            target = draft.target(other)
            if target.holder is not operand.holder or target.bit is None:
                raise NoTask(f"the bits of {step.argument} are not in one word")
            masks.append(f"0x{target.bit.mask:X}")
        return [f"task.write_bits({place}, {argument.name}, {', '.join(masks)})"]
