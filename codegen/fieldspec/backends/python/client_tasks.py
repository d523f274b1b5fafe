"""Tasks as methods of clients: their arguments, their steps, and why a task has none."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.fact_texts import described, sentence
from fieldspec.backends.python.client_links import seconds
from fieldspec.backends.python.client_names import CODEC, Argument, ClientNames, NoTask, is_scaled, raw_number, wanted
from fieldspec.backends.python.links import Exchange
from fieldspec.backends.python.naming import TYPES, Scope
from fieldspec.backends.python.text import docstring, item_lines, literal
from fieldspec.classes import dataclass
from fieldspec.model.fact import ScalarValue
from fieldspec.model.link import Part
from fieldspec.model.operand import PARAMETERS, REGISTERS, Operand, Operands
from fieldspec.model.record import Message
from fieldspec.model.registers import Parameter, Register, Subindex
from fieldspec.model.task import Step, Task, step_text
from fieldspec.model.value import Value
from fieldspec.model.watches import LASTING, REFUSAL, before_effect, end_steps, is_last_wait, watches
from fieldspec.names import Name

_LIMIT = 60.0
"""The seconds that a task may take where the manual does not print them."""
ARGUMENTS = frozenset({"self", "limit", "task"})
"""The names that no argument of a task may have."""


@dataclass(frozen=True, slots=True)
class TaskView:
    """A task as a method: what its arguments are and how they are passed on, the type of its result, its docstring.

    `lines` are those of the generator that carries it out. A `jog` goes on until it is ended.
    """

    name: str
    signature: str
    passed: str
    result: str
    jog: bool
    lines: list[str]
    doc: list[str]


class TaskDraft:
    """A task while its steps are added."""

    def __init__(self, names: ClientNames, operands: Operands, task: Task, message: str = "") -> None:
        self.names, self.operands, self.task, self.message = names, operands, task, message
        self.layout = names.layout
        self.scope = Scope(ARGUMENTS, TYPES)
        self.arguments: dict[str, Argument] = {}
        self.results: list[str] = []
        self.steps: list[str] = []
        self.remarks: list[str] = []

    def target(self, step: Step) -> Operand:
        """The operand of a step. Raises NoTask where it is not exactly one fact."""
        targets = self.operands.target(step.target, self.message)
        if len(targets) != 1:
            raise NoTask(f"`{step.target}` is not one fact")
        return targets[0]

    def argument(self, name: str, value: Value) -> Argument:
        """An argument of the task, which several steps may share. Raises NoTask where it means two things."""
        if name not in self.arguments:
            argument = self.names.argument(name, value)
            self.arguments[name] = Argument(self.scope.take(argument.name), argument.type, argument.in_unit)
        elif self.arguments[name].in_unit != is_scaled(value):
            raise NoTask(f"{name} means two things")
        return self.arguments[name]

    def _limit(self, waits: Sequence[Step]) -> float:
        """The seconds that a task may take: those of its waits where the manual prints all of them."""
        limits = {limit.place.path: limit for limit in self.layout.device.limits}
        known = [seconds(limits[step.timeout]) if step.timeout in limits else None for step in waits]
        printed = [time for time in known if time is not None]
        return sum(printed) if len(printed) == len(known) else _LIMIT

    def doc(self) -> list[str]:
        """The paragraphs of the docstring."""
        steps = "; ".join(step_text(step) for step in self.task.steps)
        return described(Name.of(self.task.name).title(), self.task, sentence(f"Steps: {steps}"), *self.remarks)

    def view(
        self, make: str, watched: list[str], ending: list[str], first: int, jog: bool, more: Sequence[str] = ()
    ) -> TaskView:
        """The finished task; `make` is the function that creates it, and `more` are arguments of this function.

        `ending` are the steps that end it where one from `first` on has failed.
        """
        waits = [step for step in self.task.steps if step.action == "wait"]
        limited = bool(waits) and not jog
        typed = [f"{argument.name}: {argument.type}" for argument in self.arguments.values()]
        passed = [f"{argument.name}={argument.name}" for argument in self.arguments.values()]
        if limited:
            typed.append(f"limit: float = {self._limit(waits)!r}")
            passed.append("limit=limit")
        arguments = [literal(self.task.name), "limit" if limited else "None", *watched, *more]
        lines = item_lines(f"task = self.{make}(", arguments, ")", 8)
        if jog:
            lines += ["return _Jog(", *_steps("    task.run(", self.steps, [], 0), "    task.look,"]
            lines += [f"    lambda: task.run([{', '.join(ending)}]),", ")"]
        else:
            lines += _steps(
                "return task.carry_out(" if make == "task" else "return task.run(", self.steps, ending, first
            )
            lines[-1] = ")"
        results = self.results
        several = f"tuple[{', '.join(results)}]" if results else "None"
        return TaskView(
            name=self.task.name,
            signature=f", *, {', '.join(typed)}" if typed else "",
            passed=", ".join(passed),
            result=results[0] if len(results) == 1 else several,
            jog=jog,
            lines=lines,
            doc=docstring(self.doc(), 8),
        )


def _steps(start: str, steps: Sequence[str], ending: Sequence[str], first: int) -> list[str]:
    """The call that carries out steps, one a line; it ends with a comma."""
    margin = " " * (len(start) - len(start.lstrip()))
    lines = [start, f"{margin}    [", *(f"{margin}        {step}," for step in steps), f"{margin}    ],"]
    if ending:
        lines += [f"{margin}    [{', '.join(ending)}],", f"{margin}    {first},"]
    return [*lines, f"{margin}),"]


def task_view(names: ClientNames, operands: Operands, task: Task) -> TaskView:
    """The method of a task. Raises NoTask."""
    if task.open:
        raise NoTask(f"an open question. {task.open}")
    if task.not_applicable:
        raise NoTask(task.not_applicable)
    draft = TaskDraft(names, operands, task)
    scopes = {draft.target(step).scope for step in task.steps}
    if scopes <= {REGISTERS, PARAMETERS}:
        return _WordTask(draft).view()
    if task.steps[0].action == "send":
        return _MessageTask(draft).view()
    raise NoTask("its steps act on several kinds of facts")


def condition(
    names: ClientNames, operand: Operand, value: Value | None, stated: ScalarValue, place: str, reason: str
) -> str:
    """The expression of a condition."""
    number, mask = wanted(names.layout, operand, value, stated)
    more = [f"mask={mask}", f"name={literal(operand.fact.name)}"] if mask else []
    more += [f"reason={literal(reason)}"] if reason != "unready" else []
    return f"_Condition({', '.join([place, number, *more])})"


def wait_value(step: Step) -> ScalarValue:
    """What a step waits for. Raises NoTask where that is an argument, or one of several values."""
    if len(step.wanted) != 1:
        raise NoTask(f"what `{step.target}` is waited for is no single value")
    return step.wanted[0]


def ends(task: Task) -> tuple[int, int] | None:
    """The steps that begin and end what must not go on by itself. Raises NoTask."""
    try:
        return end_steps(task)
    except ValueError as error:
        raise NoTask(str(error)) from None


class _WordTask:
    """A task over registers and parameters."""

    def __init__(self, draft: TaskDraft) -> None:
        self.draft, self.names, self.task = draft, draft.names, draft.task
        self.begins: dict[int, int] = {}

    def view(self) -> TaskView:
        """The method."""
        draft, task = self.draft, self.task
        watched = [
            self._condition(watch.operand, watch.value, watch.reason)
            for watch in watches(self.names.layout.device, draft.operands, task)
            if watch.operand.scope in (REGISTERS, PARAMETERS)
        ]
        first = before_effect(task)
        ending = ends(task)
        looked = [self._condition(draft.target(step), wait_value(step), "unready") for step in task.steps[:first]]
        if watched or looked:
            draft.steps.append(f"task.look({', '.join(looked)})")
        jog = task.kind in LASTING
        for at, step in enumerate(task.steps[first:], first):
            self.begins[at] = len(draft.steps)
            draft.steps += self._step(at, step)
        if ending is None:
            return draft.view("register_task", watched, [], 0, False)
        last = self._step(ending[1], task.steps[ending[1]])
        if jog:
            del draft.steps[self.begins[ending[1]] :]
        return draft.view("register_task", watched, last, self.begins[ending[0]], jog)

    def _condition(self, operand: Operand, stated: ScalarValue, reason: str) -> str:
        value = getattr(operand.holder, "value", None)
        return condition(self.names, operand, value, stated, self.names.place(operand), reason)

    def _step(self, at: int, step: Step) -> list[str]:
        draft = self.draft
        operand = draft.target(step)
        if step.action == "read" and isinstance(operand.fact, Subindex):
            return [self._read_element(operand.fact)]
        place, fact = self.names.place(operand), operand.holder
        assert isinstance(fact, Register | Parameter)
        if step.action == "wait":
            if REFUSAL in operand.roles:
                return [f"task.refuse({self._condition(operand, wait_value(step), 'refused')})"]
            settling = ["task.settle()"] if is_last_wait(self.task, step) else []
            return [*settling, f"task.wait({self._condition(operand, wait_value(step), 'unready')})"]
        if step.action == "read":
            return [self._read(operand, place, fact)]
        if operand.bit is not None:
            return self._bits(at, step, operand, place)
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
            raise NoTask(f"`{element.name}` is no single number")
        self.draft.results.append(self.names.answer_type(element.value, True))
        return f"task.read_element({self.names.owner(element)}, {indices[0][0]})"

    def _bits(self, at: int, step: Step, operand: Operand, place: str) -> list[str]:
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
            for after in self.task.steps[at + 1 :]
            if after.action == "set"
            and (other := self.draft.target(after)).holder is operand.holder
            and other.bit is not None
        ]
        before = self.task.steps[at - 1] if at else None
        again = before is not None and before.action == "write" and self.draft.target(before).holder is operand.holder
        cleared = [f"task.change({place}, 0x{other.mask:X}, 0x0)" for other in later if not again]
        if not step.argument:
            return [*cleared, f"{change}0x{bit.mask if step.value else 0:X})"]
        if step.argument not in self.draft.arguments:
            self.draft.arguments[step.argument] = Argument(self.draft.scope.take(step.argument), "bool", False)
        argument = self.draft.arguments[step.argument]
        return [*cleared, f"{change}0x{bit.mask:X} if {argument.name} else 0)"]


class _MessageTask:
    """A task whose steps send messages."""

    def __init__(self, draft: TaskDraft) -> None:
        self.draft, self.names, self.task = draft, draft.names, draft.task

    def view(self) -> TaskView:
        """The method."""
        draft, task = self.draft, self.task
        if before_effect(task):
            raise NoTask("it waits before it has sent anything")
        ending = ends(task)
        begins: dict[int, int] = {}
        watched: list[str] = []
        at = 0
        while at < len(task.steps):
            begins[at] = len(draft.steps)
            at = self._send(at, watched)
        if ending is None:
            return draft.view("message_task", watched, [], 0, False)
        last = draft.steps[begins[ending[1]] :]
        if task.kind in LASTING:
            del draft.steps[begins[ending[1]] :]
        return draft.view("message_task", watched, last, begins[ending[0]], task.kind in LASTING)

    def _send(self, at: int, watched: list[str]) -> int:
        """Adds a message with what is looked at in its response; gives the place of the next one."""
        draft, steps = self.draft, self.task.steps
        step = steps[at]
        message = draft.target(step).fact
        if step.action != "send" or not isinstance(message, Message):
            raise NoTask(f"`{step.target}` is no message")
        exchange = self.names.request(message.name)
        last = at + 1
        while last < len(steps) and steps[last].action in ("wait", "read"):
            last += 1
        looks = steps[at + 1 : last]
        waits = [look for look in looks if look.action == "wait"]
        reads = [look for look in looks if look.action == "read"]
        again = at > 0 and not step.values and not step.arguments
        request = self._request(step, exchange)
        conditions = []
        for look in waits:
            operand = draft.target(look)
            reason = "refused" if REFUSAL in operand.roles else "unready"
            conditions.append(self._condition(operand, wait_value(look), exchange, reason))
        if waits:
            for watch in watches(self.names.layout.device, draft.operands, self.task):
                if self._path(watch.operand, exchange) is not None:
                    text = self._condition(watch.operand, watch.value, exchange, watch.reason)
                    watched += [text] if text not in watched else []
        if waits and again:
            draft.steps += ["task.settle()", f"task.wait({', '.join([request, *conditions])})"]
        elif not reads or waits:
            draft.steps.append(f"task.send({', '.join([request, *conditions])})")
        if reads:
            draft.steps.append(f"task.read({', '.join([request, *(self._result(look, exchange) for look in reads)])})")
        return last

    def _result(self, look: Step, exchange: Exchange) -> str:
        operand = self.draft.target(look)
        slot = self.names.attribute(exchange, "response", operand.holder)
        if operand.bit is not None or slot is None or slot.field.value is None or slot.is_list:
            raise NoTask(f"`{operand.path}` is no single value in the response of {exchange.message.name}")
        name = self.names.scaled_name(exchange, "response", slot)
        self.draft.results.append(self.names.answer_type(slot.value))
        return literal(f"message.{name}")

    def _condition(self, operand: Operand, stated: ScalarValue, exchange: Exchange, reason: str) -> str:
        path = self._path(operand, exchange)
        if path is None:
            raise NoTask(f"`{operand.path}` is not in the response of {exchange.message.name}")
        value = getattr(operand.holder, "value", None)
        return condition(self.names, operand, value, stated, literal(path), reason)

    def _path(self, operand: Operand, exchange: Exchange) -> str | None:
        """The path of an attribute of the response; None where it is not in it."""
        if isinstance(operand.holder, Part):
            links = [link for link in self.names.layout.links.values() if exchange.message.name in link.messages]
            carried = [link for link in links if operand.path.startswith(f"links/{link.name}/")]
            return operand.holder.name if carried and len(links) == 1 else None
        slot = self.names.attribute(exchange, "response", operand.holder)
        own = operand.scope == f"messages/{exchange.message.name}"
        return f"message.{slot.name}" if slot is not None and own and not slot.is_list else None

    def _request(self, step: Step, exchange: Exchange) -> str:
        arguments = [f"{CODEC}.{exchange.request_name}"]
        for slot in exchange.request.stored:
            title = slot.title
            if slot.field.value is None or slot.is_list:
                raise NoTask(f"the request of {exchange.message.name} has more than single values")
            if title in step.arguments:
                argument = self.draft.argument(step.arguments[title], slot.value)
                name = self.names.scaled_name(exchange, "request", slot) if argument.in_unit else slot.name
                arguments.append(f"{name}={argument.name}")
            elif title in step.values:
                number = raw_number(self.names.layout, slot.value, None, step.values[title])
                boolean = slot.type == "bool"
                arguments.append(f"{slot.name}={bool(number) if boolean else number}")
            else:
                raise NoTask(f"the task does not say what {title} of {exchange.message.name} is")
        return f"task.request({', '.join(arguments)})"
