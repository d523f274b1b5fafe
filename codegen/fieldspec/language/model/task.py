"""What people do with a device, as steps over its facts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.fact import Citation, Fact, Place, ScalarValue

ACTIONS = ("write", "set", "clear", "pulse", "send", "read", "wait")
"""The action of a step on its target."""
OF_GRIPPERS = ("grip", "release")
"""The kinds of tasks that only grippers have; a device states all others, or why it lacks them."""


@dataclass(frozen=True, slots=True)
class Step:
    """One step. `action` is one of ACTIONS, `target` a role or the path of an operand.

    `value` is what is written, None where there is none or an `argument` is. `wanted` has the values that end a wait,
    empty for an `argument`: the target has to be what the argument says or, where it is `relative`, to have changed by
    it since the task began; `within` is how far it may be away, in its unit, None for no distance. `argument_bit` is
    the bit of the argument that is written, None for all of it. `values` and `arguments` are by field of a message's
    request. `timeout` is the path of a limit, or empty.
    """

    place: Place
    action: str
    target: str
    value: ScalarValue
    wanted: tuple[ScalarValue, ...]
    argument: str
    argument_bit: int | None
    within: Decimal | None
    relative: bool
    values: Mapping[str, object]
    arguments: Mapping[str, str]
    timeout: str
    doc: str
    sources: tuple[Citation, ...]


def step_text(step: Step) -> str:
    """A step as people read it: `write command = homing`, `wait in_position = 1, at most limits/reply`."""
    text = f"{step.action} {step.target}"
    value = stated_text(step)
    if value:
        text += f" = {value}"
    fields = [f"{name} = {value_text(value)}" for name, value in step.values.items()]
    fields += [f"{name} = {argument_text(argument)}" for name, argument in step.arguments.items()]
    if fields:
        text += f" with {', '.join(fields)}"
    return f"{text}, at most {step.timeout}" if step.timeout else text


def stated_text(step: Step) -> str:
    """The value that a step writes or waits for: `homing`, `stopped or abnormal_stop`, `<position>`, `start +
    <distance>`.
    """
    if step.argument:
        text = argument_text(step.argument)
        if step.argument_bit is not None:
            text = f"bit {step.argument_bit} of {text}"
        text = f"start + {text}" if step.relative else text
        return f"{text} within {step.within}" if step.within is not None else text
    values = step.wanted if step.action == "wait" else () if step.value is None else (step.value,)
    return " or ".join(value_text(value) for value in values)


def argument_text(name: str) -> str:
    """The name of an argument in angle brackets."""
    return f"<{name}>"


def value_text(value: object) -> str:
    """A value of a step; truth values as the spec writes them."""
    return str(value).lower() if isinstance(value, bool) else str(value)


@dataclass(frozen=True, slots=True, kw_only=True)
class Task(Fact):
    """A task. It has `steps`, or says why it is `not_applicable`, or which question is `open`.

    `kind` is its word in the schema. With `messages`, the steps work with each of these cyclic messages by itself. A
    stop with `halt` leaves the axis free for the next command. `direction` is positive, negative, or empty.
    """

    kind: str
    halt: bool
    direction: str
    messages: tuple[str, ...]
    steps: tuple[Step, ...]
    not_applicable: str
    open: str

    def bits_of(self, argument: str) -> list[Step]:
        """The steps that write single bits of an argument, the lowest bit first."""
        steps = [step for step in self.steps if step.argument == argument and step.argument_bit is not None]
        return sorted(steps, key=lambda step: step.argument_bit or 0)

    def arguments(self) -> Iterator[str]:
        """The arguments that the user of the task chooses, each once, in the order of the steps."""
        earlier: set[str] = set()
        for step in self.steps:
            for name in (step.argument, *step.arguments.values()):
                if name and name not in earlier:
                    earlier.add(name)
                    yield name
