"""Tasks as methods of clients while they are made: their arguments, their steps, and why a task has none."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import Name
from fieldspec.language.model.fact import ScalarValue
from fieldspec.language.model.operand import Operand, Operands
from fieldspec.language.model.task import Step, Task, step_text
from fieldspec.language.model.value import Value
from fieldspec.language.model.watches import (
    LASTING,
    MOVING,
    REFUSAL,
    acceptance,
    conditions,
    end_steps,
    halting_task,
    needs_begin,
)
from fieldspec.targets.fact_texts import described, sentence
from fieldspec.targets.python.client_links import seconds
from fieldspec.targets.python.client_names import Argument, ClientNames, NoTask, is_scaled, wanted
from fieldspec.targets.python.naming import TYPES, Scope
from fieldspec.targets.python.text import docstring, item_lines, literal

_LIMIT = 60.0
"""The seconds that a task may take where the manual does not print them."""
ARGUMENTS = frozenset({"self", "limit", "task"})
"""The names that no argument of a task may have."""


@dataclass(frozen=True, slots=True)
class TaskView:
    """A task as a method: what its arguments are and how they are passed on, the type of its result, its docstring.

    `lines` are the lines of the generator that carries it out. A `jog` continues until it is ended.
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
        self.locals: list[str] = []
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

    def window(self, step: Step, value: Value) -> str:
        """The arguments of a target for how far the device may be from it: a keyword of the task, and its unit."""
        if step.within is None:
            return ""
        argument = self.names.argument("window", value)
        known = self.arguments.get("window")
        if known is None:
            name = self.scope.take(argument.name)
            known = self.arguments["window"] = Argument(name, f"float = {float(step.within)!r}", True)
        scale = f", {float(value.scale)!r}" if is_scaled(value) else ""
        return f", {known.name}{scale}"

    def target_of(self, step: Step, value: Value | None, place: str, count: str) -> str:
        """The local variable with the target of a wait, whose `count` is an expression. Raises NoTask."""
        if value is None:
            raise NoTask(f"`{step.target}` is not a number")
        name_argument = f", name={literal(step.target)}" if "/" not in step.target else ""
        name = self.scope.take("target")
        self.locals.append(f"{name} = _Target({place}, {count}{self.window(step, value)}{name_argument})")
        return name

    def accepted(self) -> int:
        """The step after which the device has accepted the command."""
        return acceptance(self.operands, self.task, self.message)

    def waited(self, index: int) -> tuple[Step, ...]:
        """The waits from a step on that hold together."""
        return conditions(self.operands, self.task, index, self.message)

    def wait_call(self, index: int, arguments: str) -> list[str]:
        """The calls that wait for conditions: at first for the begin of a motion, where they may hold from before."""
        if self.task.kind not in MOVING:
            return ["task.settle()", f"task.wait({arguments})"]
        begin_calls = [f"task.begin({arguments})"] if needs_begin(self.task, index, self.accepted()) else []
        return [*begin_calls, f"task.wait({arguments})"]

    def halting(self) -> Task | None:
        """The task that ends the motion of one that has failed."""
        ends = self.task.kind in MOVING and self.task.kind not in LASTING
        return halting_task(self.layout.device, self.message) if ends else None

    def _limit(self, waits: Sequence[Step]) -> float:
        """The seconds that a task may take: the sum of its waits if the manual prints all of them."""
        limits = {limit.place.path: limit for limit in self.layout.device.limits}
        known = [seconds(limits[step.timeout]) if step.timeout in limits else None for step in waits]
        printed = [time for time in known if time is not None]
        return sum(printed) if len(printed) == len(known) else _LIMIT

    def doc(self) -> list[str]:
        """The paragraphs of the docstring."""
        steps = "; ".join(step_text(step) for step in self.task.steps)
        return described(Name.of(self.task.name).title(), self.task, sentence(f"Steps: {steps}"), *self.remarks)

    def view(
        self,
        make: str,
        watched: list[str],
        ending: list[str],
        first: int,
        jog: bool,
        extra: Sequence[str] = (),
        halting: Sequence[str] = (),
    ) -> TaskView:
        """The finished task; `make` is the function that creates it, and `extra` are arguments of this function.

        `ending` are the steps that end it where one from `first` on has failed, and `halting` those that stop the
        device unless it has refused.
        """
        waits = [step for step in self.task.steps if step.action == "wait"]
        limited = bool(waits) and not jog
        bound = "limit" if limited else repr(_LIMIT) if waits else "None"
        typed = [f"{argument.name}: {argument.type}" for argument in self.arguments.values()]
        passed = [f"{argument.name}={argument.name}" for argument in self.arguments.values()]
        if limited:
            typed.append(f"limit: float = {self._limit(waits)!r}")
            passed.append("limit=limit")
        arguments = [literal(self.task.name), bound, *watched, *extra]
        lines = [*item_lines(f"task = self.{make}(", arguments, ")", 8), *self.locals]
        if jog:
            lines += ["return _Jog(", *_steps("    task.run(", self.steps, [], 0), "    task.look,"]
            lines += [f"    lambda: [task.run([{', '.join(ending)}])],", ")"]
        else:
            call = "return task.carry_out(" if make == "task" else "return task.run("
            lines += _steps(call, self.steps, ending, first, halting)
            lines[-1] = ")"
        results = self.results
        result_type = f"tuple[{', '.join(results)}]" if results else "None"
        return TaskView(
            name=self.task.name,
            signature=f", *, {', '.join(typed)}" if typed else "",
            passed=", ".join(passed),
            result=results[0] if len(results) == 1 else result_type,
            jog=jog,
            lines=lines,
            doc=docstring(self.doc(), 8),
        )


def _steps(
    start: str, steps: Sequence[str], ending: Sequence[str], first: int, halting: Sequence[str] = ()
) -> list[str]:
    """The call that carries out steps, one a line; it ends with a comma."""
    margin = " " * (len(start) - len(start.lstrip()))
    lines = [start, f"{margin}    [", *(f"{margin}        {step}," for step in steps), f"{margin}    ],"]
    lines += [f"{margin}    ending=[{', '.join(ending)}]," for _ in range(bool(ending))]
    lines += [f"{margin}    halting=lambda: [{', '.join(halting)}]," for _ in range(bool(halting))]
    lines += [f"{margin}    first={first}," for _ in range(bool(ending or halting))]
    return [*lines, f"{margin}),"]


def condition(
    names: ClientNames, operand: Operand, value: Value | None, stated: Sequence[ScalarValue], place: str, reason: str
) -> str:
    """The expression of a condition: the value that is wanted, or several."""
    numbers, masks = zip(*(wanted(names.layout, operand, value, stated_value) for stated_value in stated), strict=True)
    mask = masks[0]
    options = [f"mask={mask}", f"name={literal(operand.fact.name)}"] if mask else []
    options += [f"reason={literal(reason)}"] if reason != "unready" else []
    return f"_Condition({', '.join([place, *numbers, *options])})"


def reason_of(operand: Operand) -> str:
    """The error of a wait that an operand never ends."""
    return "refused" if REFUSAL in operand.roles else "unready"


def ends(task: Task) -> tuple[int, int] | None:
    """The steps that begin and end what must not go on by itself. Raises NoTask."""
    try:
        return end_steps(task)
    except ValueError as error:
        raise NoTask(str(error)) from None
