"""Ready programs: a block that calls the blocks of an axis; its inputs and outputs are for a panel."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from fieldspec.foundation.names import Name
from fieldspec.language.model.watches import MOVING
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    UINT,
    WORD,
    Expression,
    Output,
    StructType,
    Variable,
    Whole,
    either,
    every,
)
from fieldspec.targets.controllers.statements.interfaces import OWN, BlockVariables
from fieldspec.targets.controllers.statements.routine import Assignment, Condition, Invocation, Routine, Statement

_TASKS: Mapping[str, tuple[str, str, str]] = {
    "servo_on": ("Servo", "energizes the axis; FALSE takes the energy away", "Ready"),
    "servo_off": ("", "", ""),
    "reset_alarm": ("Reset", "a rising edge resets an alarm, once its cause is removed", ""),
    "home": ("Home", "a rising edge searches the home position", "Homed"),
    "move_absolute": ("MoveAbsolute", "a rising edge moves to the position", "Moved"),
    "move_velocity": ("MoveVelocity", "moves at the speed while it is TRUE", "InVelocity"),
    "grip": ("Grip", "a rising edge closes and grips", "Gripped"),
    "release": ("Release", "a rising edge opens", "Released"),
    "jog": ("", "", ""),
    "read_position": ("", "", "PositionValid"),
    "read_alarm": ("", "", "AlarmValid"),
    "stop": ("Stop", "a rising edge stops; the axis is locked while it is TRUE", "Stopped"),
}
"""The kinds of tasks that a panel has, in the order of the calls: its input, what that does, and its output."""
_STARTS = ("Execute", "Abort", "Enable", "JogForward", "JogBackward")
_RESTS = "; not while something moves, which would have to wait for the line"
_JOGS = {"JogForward": "moves forward while it is TRUE", "JogBackward": "moves backward while it is TRUE"}


def panels(world: World, blocks: Sequence[Routine], kinds: Mapping[str, str]) -> Iterator[Routine]:
    """The ready programs of a device: one for the line, and one for each telegram, as far as blocks move something.

    `kinds` are the kinds of the tasks by the names of the blocks, of which the first of a kind is called.
    """
    groups: dict[str, dict[str, Routine]] = {}
    for block in blocks:
        group = block.group if block.group.startswith("telegram ") else ""
        groups.setdefault(group, {}).setdefault(kinds[block.name], block)
    for group, by_kind in groups.items():
        if set(by_kind) & set(MOVING):
            yield _Panel(world, group.removeprefix("telegram "), by_kind).block()


class _Panel:
    """A ready program while it is being made."""

    def __init__(self, world: World, message: str, blocks: Mapping[str, Routine]) -> None:
        self.has_status = world.names.has_status
        self.name = world.block(*filter(None, (message,)), "panel")
        self.group = f"telegram {message}" if message else "ready program"
        self.blocks = {kind: blocks[kind] for kind in _TASKS if kind in blocks}
        self.variables = BlockVariables(self.name)
        self.rests: list[Variable] = []
        self.body: list[Statement] = []

    def block(self) -> Routine:
        """The ready program."""
        instances = {kind: self._called(kind, block) for kind, block in self.blocks.items()}
        for kind, instance in instances.items():
            done = _TASKS[kind][2]
            if done:
                ends = self._outputs(kind)
                end = next(end for end in ("InVelocity", "Done", "Valid") if end in ends)
                self._gives(done, Output(instance, end, BOOL))
            if kind.startswith("read_"):
                self._read_values(kind, instance)
        self._errors(instances.values())
        return Routine(self.name, self.group, None, tuple(self.variables.declared), tuple(self.body), self._remarks())

    def _outputs(self, kind: str) -> set[str]:
        return {declared.variable.name for declared in self.blocks[kind].of_role("output")}

    def _called(self, kind: str, block: Routine) -> Variable:
        """Adds the call of a block, and gives its instance."""
        instance = self.variables.declare(f"fb{Name.of(kind).pascal()}", StructType(block.name, is_block=True), "local")
        arguments: list[tuple[str, Expression]] = []
        for declared in block.declared:
            variable = declared.variable
            if declared.role == "in_out":
                arguments.append((variable.name, self._lent(variable, declared.remark)))
            elif declared.role == "input" and (variable.name in _STARTS or not declared.initial):
                arguments.append((variable.name, self._argument(kind, variable, declared.remark)))
        if kind in MOVING and any(name == "Frames" for name, _ in arguments):
            self.rests.append(instance)
        self.body.append(Invocation(instance, tuple(sorted(arguments, key=lambda item: item[0] not in _STARTS))))
        return instance

    def _lent(self, variable: Variable, remark: str) -> Variable:
        return self.variables.declared_once(variable.name, variable.type, "in_out", remark)

    def _argument(self, kind: str, variable: Variable, remark: str) -> Expression:
        """The value of an input of a block."""
        if variable.name == "Enable":
            remark_text = f"reads position and alarm again and again{_RESTS if self.rests else ''}"
            shows = self.variables.declared_once("Show", BOOL, "input", remark_text, "TRUE")
            return every([shows, *(Output(block, "Busy", BOOL).negated() for block in self.rests)])
        if variable.name in _JOGS:
            return self.variables.declared_once(variable.name, BOOL, "input", _JOGS[variable.name])
        if variable.name != "Execute":
            return self.variables.declared_once(variable.name, variable.type, "input", remark)
        if kind == "servo_off":
            name, remark_text, _ = _TASKS["servo_on"]
            return self.variables.declared_once(name, BOOL, "input", remark_text).negated()
        name, remark_text, _ = _TASKS[kind]
        if kind == "servo_on" and "servo_off" not in self.blocks:
            remark_text = "a rising edge energizes the axis"
        return self.variables.declared_once(name, BOOL, "input", remark_text)

    def _gives(self, name: str, value: Output) -> None:
        self.body.append(Assignment(self.variables.declare(name, BOOL, "output"), value))

    def _read_values(self, kind: str, instance: Variable) -> None:
        """Adds the values that a block has read."""
        for declared in self.blocks[kind].of_role("output"):
            variable = declared.variable
            if variable.name not in OWN:
                taken_names = {item.variable.name for item in self.variables.declared}
                name = f"{variable.name}Read" if variable.name in taken_names else variable.name
                output = self.variables.declare(name, variable.type, "output", declared.remark)
                self.body.append(Assignment(output, Output(instance, variable.name, variable.type)))

    def _errors(self, instances: Iterable[Variable]) -> None:
        """Adds the error of the first block that has one."""
        error = self.variables.declare("Error", BOOL, "output", "a block has an error; it stays as long as its input")
        name, kind = ("Status", WORD) if self.has_status else ("ErrorID", UINT)
        number = self.variables.declare(name, kind, "output", "0, or the reason of that error")
        called = list(instances)
        first = [
            (Output(instance, "Error", BOOL), (Assignment(number, Output(instance, name, kind)),))
            for instance in called
        ]
        self.body += [
            Assignment(error, either([test for test, _ in first])),
            Assignment(number, Whole(0, kind, self.has_status)),
            Condition(tuple(first)),
        ]

    def _remarks(self) -> tuple[str, ...]:
        return (
            "Ready program: set the inputs and look at the outputs from a panel or from your own program. Nothing "
            "moves without a rising edge, a reset of an alarm and a stop move nothing.",
            "Call it in each scan, and after it what serves its port.",
        )
