"""Tasks by the fields of cyclic messages, and the clients of these messages."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.needed_bits import needed_bits
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.names import Name
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Flags
from fieldspec.language.model.fact import ScalarValue
from fieldspec.language.model.operand import Operand, Operands
from fieldspec.language.model.raw_numbers import bytes_of_number
from fieldspec.language.model.task import Step, Task
from fieldspec.language.model.watches import LASTING, STARTING, before_effect, watches
from fieldspec.targets.fact_texts import described
from fieldspec.targets.python.client_names import CODEC, Argument, ClientNames, NoTask, is_scaled, raw_number
from fieldspec.targets.python.client_tasks import TaskDraft, TaskView, condition, ends, reason_of
from fieldspec.targets.python.links import Exchange
from fieldspec.targets.python.slots import Slots
from fieldspec.targets.python.text import docstring, literal
from fieldspec.targets.python.writing import tuple_of

_REQUEST, _RESPONSE = "request", "response"


@dataclass(frozen=True, slots=True)
class CyclicView:
    """The client of a cyclic message: its classes, the link, the first request, its tasks."""

    name: str
    link: str
    request: str
    response: str
    initial: str
    tasks: list[TaskView]
    doc: list[str]


def cyclic_view(names: ClientNames, operands: Operands, link: LinkLayout, exchange: Exchange) -> CyclicView:
    """The client of a cyclic message."""
    message = exchange.message
    tasks: list[TaskView] = []
    missing: list[str] = []
    for task in names.layout.device.tasks:
        if message.name not in task.messages:
            continue
        try:
            tasks.append(_CyclicTask(names, operands, task, exchange).view())
        except NoTask as reason:
            missing.append(f" {task.name}: {reason}")
    title = message.message.title or Name.of(message.name).title()
    known = f"{Name.of(link.link.message_name or 'message').title()} {message.message.number}." * (
        message.message.number is not None
    )
    return CyclicView(
        name=Name.of(message.name).pascal(),
        link=f"_{Name.of(link.name).upper()}",
        request=f"{CODEC}.{exchange.request_name}",
        response=f"{CODEC}.{exchange.response_name}",
        initial=literal(initial_bytes(names.layout.device, message.request).hex()),
        tasks=tasks,
        doc=docstring(
            [
                *described(f"The cyclic exchange: {title}", message.message, known),
                *(["Tasks without a method:", *missing] if missing else []),
            ],
            4,
        ),
    )


def initial_bytes(device: Device, record: RecordLayout) -> bytes:
    """The bytes of a request in which everything is 0 but constants and initial values.

    Raises NoTask for a number whose words are exchanged or that is sent as digits, for fields after a list, and where
    nothing says what to send in place of a 0 that is another quantity or is not permitted.
    """
    if record.inner_lists is not None:
        name = record.inner_lists.lists[0].name
        raise NoTask(f"{name} is a list with fields after it, of elements that differ in size, or of packed numbers")
    data = bytearray(record.size or 0)
    for field in record.fields:
        value = field.value
        if value is None:
            continue
        if value.digits or value.text_form is not None:
            raise NoTask(f"{field.name} is sent as characters")
        number = value.const if isinstance(value.const, int) else value.default
        if number is None and value.flags:
            number = _initial_word(device, field, device.flags[value.flags])
        elif number is None and value.offset and not field.field.reserved:
            raise NoTask(f"{field.name} has no default, and its 0 is {value.offset:f} {value.unit}".rstrip())
        if isinstance(number, int) and not isinstance(number, bool) and not field.is_list:
            if field.swapped:
                raise NoTask(f"{field.name} has exchanged words")
            order = "big" if field.order == "big" else "little"
            raw = bytes_of_number(value, number)
            data[field.offset : field.offset + field.size] = raw if order == "big" else raw[::-1]
    return bytes(data)


def _initial_word(device: Device, field: FieldLayout, word: Flags) -> int:
    """The word of which nothing is given. Raises NoTask where something has to be."""
    required = next(iter(needed_bits(word, device.enums)), None)
    if required is not None:
        raise NoTask(f"{required.bit.name} of {field.name} has no default, and its {required.reason}")
    return word.initial


class _CyclicTask:
    """A task that is carried out by one cyclic message."""

    def __init__(self, names: ClientNames, operands: Operands, task: Task, exchange: Exchange) -> None:
        self.names, self.task, self.exchange = names, task, exchange
        self.draft = TaskDraft(names, operands, task, exchange.message.name)
        self.started: list[tuple[str, int]] = []
        self.relative: list[str] = []
        self.pulsed: list[tuple[str, int]] = []

    def view(self) -> TaskView:
        """The view of the method that carries out the task."""
        draft, task, message = self.draft, self.task, self.exchange.message.name
        watched = [
            self._condition(watch.operand, (watch.value,), watch.reason)
            for watch in watches(self.names.layout.device, draft.operands, task, message)
        ]
        first = before_effect(task)
        if first:
            looked = [self._condition(draft.target(step), step.wanted, "unready") for step in task.steps[:first]]
            draft.steps.append(f"task.look({', '.join(looked)})")
        if task.kind == "reset_alarm":
            self._clear_starting()
        noted = len(draft.steps)
        ending = ends(task) if task.kind in LASTING else None
        last: list[str] = []
        index = first
        while index < len(task.steps):
            steps, following = self._calls(index)
            if ending is not None and index >= ending[1]:
                last += steps
            else:
                draft.steps += steps
            index = following
        for target in self.relative:
            draft.steps.insert(noted, f"task.note({target})")
        bits = [
            f"{key}={tuple_of([f'({literal(name)}, 0x{mask:X})' for name, mask in own])}"
            for key, own in (("started", self.started), ("pulsed", self.pulsed))
            if own
        ]
        if task.kind == "servo_on":
            servo = draft.target(task.steps[-1])
            bits.append(f"unless={self._condition(servo, task.steps[-1].wanted, 'unready')}")
        view = draft.view("task", watched, last, 0, ending is not None, bits)
        return replace(view, name=self._name())

    def _calls(self, index: int) -> tuple[list[str], int]:
        """The calls of a step, or of the waits that hold together, and the place of the next one."""
        draft, step = self.draft, self.task.steps[index]
        if step.action != "wait":
            return self._step(step), index + 1
        steps = draft.waited(index)
        return draft.wait_call(index, ", ".join(self._awaited(wait) for wait in steps)), index + len(steps)

    def _awaited(self, step: Step) -> str:
        """The argument of a wait: the expression of a condition, or the variable of a target."""
        draft, operand = self.draft, self.draft.target(step)
        if not step.argument:
            return self._condition(operand, step.wanted, reason_of(operand))
        argument = draft.arguments[step.argument]
        before = next(other for other in self.task.steps if other.action == "write" and other.argument == step.argument)
        count = argument.name
        if argument.in_unit:
            slot = self._slot(draft.target(before), _REQUEST)
            scaled = self.names.scaled_name(self.exchange, _REQUEST, slot)
            count = f"task.count({literal(scaled)}, {argument.name}, {literal(slot.name)})"
        target = draft.target_of(step, operand.value, literal(self._slot(operand, _RESPONSE).name), count)
        if step.relative:
            self.relative.append(target)
        return target

    def _name(self) -> str:
        """The name of the method, without that of the message, which the class has."""
        return self.task.name.removesuffix(f"_{self.exchange.message.name}")

    def _clear_starting(self) -> None:
        path = f"messages/{self.exchange.message.name}/{_REQUEST}/"
        words: dict[str, int] = {}
        for operand in self.draft.operands.all:
            if operand.path.startswith(path) and STARTING & {*operand.roles} and operand.bit is not None:
                slot = self._slot(operand, _REQUEST)
                words[slot.name] = words.get(slot.name, 0) | operand.bit.mask
        self.draft.steps += [f"task.put({literal(name)}, 0x{mask:X}, False)" for name, mask in words.items()]
        if words:
            self.draft.steps.append("task.settle()")
            self.draft.remarks.append(
                "Clears the bits that switch on and start first, so that nothing starts by itself afterwards."
            )

    def _slot(self, operand: Operand, direction: str) -> Slots:
        slot = self.names.attribute(self.exchange, direction, operand.holder)
        if slot is None or slot.field.value is None or slot.is_list:
            raise NoTask(f"`{operand.path}` is not a single value of the {direction} of {self.exchange.message.name}")
        return slot

    def _condition(self, operand: Operand, stated: Sequence[ScalarValue], reason: str) -> str:
        slot = self._slot(operand, _RESPONSE)
        return condition(self.names, operand, slot.value, stated, literal(slot.name), reason)

    def _step(self, step: Step) -> list[str]:
        draft = self.draft
        operand = draft.target(step)
        if step.action == "read" and operand.bit is None:
            slot = self._slot(operand, _RESPONSE)
            draft.results.append(self.names.answer_type(slot.value))
            return [f"task.read({literal(self.names.scaled_name(self.exchange, _RESPONSE, slot))})"]
        slot = self._slot(operand, _REQUEST)
        bit = operand.bit
        if bit is not None and step.action in ("set", "clear", "pulse"):
            place = f"{literal(slot.name)}, 0x{bit.mask:X}"
            if step.action == "pulse":
                self.pulsed.append((slot.name, bit.mask))
                return [f"task.pulse({place})"]
            if step.action == "set" and STARTING & {*operand.roles}:
                self.started.append((slot.name, bit.mask))
            return [f"task.put({place}, {step.action == 'set'})"]
        if step.action != "write" or bit is not None:
            raise NoTask(f"`{step.action} {step.target}` is nothing that a cyclic message can do")
        if not step.argument:
            return [f"task.write({literal(slot.name)}, {raw_number(self.names.layout, slot.value, None, step.value)})"]
        argument: Argument = draft.argument(step.argument, slot.value)
        name = self.names.scaled_name(self.exchange, _REQUEST, slot) if is_scaled(slot.value) else slot.name
        return [f"task.write({literal(name)}, {argument.name})"]
