"""Tasks of clients whose steps send messages."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.language.model.fact import ScalarValue
from fieldspec.language.model.link import Part
from fieldspec.language.model.operand import Operand
from fieldspec.language.model.record import Message
from fieldspec.language.model.task import Step
from fieldspec.language.model.watches import LASTING, before_effect, is_query, last_command, watches
from fieldspec.targets.python.client_names import CODEC, NoTask, raw_number
from fieldspec.targets.python.client_tasks import TaskDraft, TaskView, condition, ends, reason_of
from fieldspec.targets.python.links import Exchange
from fieldspec.targets.python.text import literal


class MessageTask:
    """A task whose steps send messages."""

    def __init__(self, draft: TaskDraft) -> None:
        self.draft, self.names, self.task = draft, draft.names, draft.task
        self.relative: list[tuple[str, str]] = []

    def view(self) -> TaskView:
        """The view of the method that carries out the task."""
        draft, task = self.draft, self.task
        ending, accepted = ends(task), draft.accepted()
        starts: dict[int, int] = {}
        watched: list[str] = []
        index = 0
        while index < len(task.steps):
            starts[index] = len(draft.steps)
            index = self._send(index, watched)
        noted = starts[before_effect(task)]
        for request, target in self.relative:
            draft.steps.insert(noted, f"task.note({request}, {target})")
        moved = starts[accepted] + len(self.relative) if accepted in starts else 0
        stops = self._halting()
        if ending is None:
            return draft.view("message_task", watched, [], moved, False, halting=stops)
        first, last = starts[ending[0]], starts[ending[1]]
        end = draft.steps[last:]
        if task.kind in LASTING:
            del draft.steps[last:]
            return draft.view("message_task", watched, end, first, True)
        return draft.view("message_task", watched, end, first, False, halting=stops)

    def _halting(self) -> list[str]:
        """The steps of the task that ends a motion which has failed."""
        task = self.draft.halting()
        if task is None or any(step.action != "send" for step in task.steps[: last_command(task) + 1]):
            return []
        commands = task.steps[: last_command(task) + 1]
        return [f"task.send({self._request(step, self._exchange(step))})" for step in commands]

    def _exchange(self, step: Step) -> Exchange:
        message = self.draft.target(step).fact
        if step.action != "send" or not isinstance(message, Message):
            raise NoTask(f"`{step.target}` is not a message")
        return self.names.request(message.name)

    def _send(self, index: int, watched: list[str]) -> int:
        """Adds a message with the checks of its response; returns the place of the next message."""
        draft, steps = self.draft, self.task.steps
        step = steps[index]
        exchange = self._exchange(step)
        last = index + 1
        while last < len(steps) and steps[last].action in ("wait", "read"):
            last += 1
        looks = steps[index + 1 : last]
        waits = [look for look in looks if look.action == "wait"]
        reads = [look for look in looks if look.action == "read"]
        request = self._request(step, exchange)
        awaited = ", ".join([request, *(self._awaited(look, exchange, request) for look in waits)])
        if waits:
            for watch in watches(self.names.layout.device, draft.operands, self.task):
                if self._path(watch.operand, exchange) is not None:
                    text = self._condition(watch.operand, (watch.value,), exchange, watch.reason)
                    watched += [text] if text not in watched else []
        if waits and is_query(self.task, index) and index >= before_effect(self.task):
            draft.steps += draft.wait_call(index + 1, awaited)
        elif not reads or waits:
            draft.steps.append(f"task.send({awaited})")
        if reads:
            draft.steps.append(f"task.read({', '.join([request, *(self._result(look, exchange) for look in reads)])})")
        return last

    def _awaited(self, look: Step, exchange: Exchange, request: str) -> str:
        """The argument of a wait: the expression of a condition, or the variable of a target."""
        draft, operand = self.draft, self.draft.target(look)
        if not look.argument:
            return self._condition(operand, look.wanted, exchange, reason_of(operand))
        path = self._path(operand, exchange)
        if path is None:
            raise NoTask(f"`{operand.path}` is not in the response of {exchange.message.name}")
        count = self._count(look.argument)
        target = draft.target_of(look, operand.value, literal(path), count)
        if look.relative:
            self.relative.append((request, target))
        return target

    def _count(self, argument: str) -> str:
        """The expression of an argument in counts, as the field of the request that is sent has it."""
        sending_step = next(step for step in self.task.steps if argument in step.arguments.values())
        exchange = self._exchange(sending_step)
        field = next(name for name, value in sending_step.arguments.items() if value == argument)
        slot = next(slot for slot in exchange.request.stored if slot.title == field)
        if not self.draft.arguments[argument].in_unit:
            return self.draft.arguments[argument].name
        return f"task.count({self._request(sending_step, exchange)}, {literal(slot.name)})"

    def _result(self, look: Step, exchange: Exchange) -> str:
        operand = self.draft.target(look)
        slot = self.names.attribute(exchange, "response", operand.holder)
        if operand.bit is not None or slot is None or slot.field.value is None or slot.is_list:
            raise NoTask(f"`{operand.path}` is not a single value in the response of {exchange.message.name}")
        name = self.names.scaled_name(exchange, "response", slot)
        self.draft.results.append(self.names.answer_type(slot.value))
        return literal(f"message.{name}")

    def _condition(self, operand: Operand, stated: Sequence[ScalarValue], exchange: Exchange, reason: str) -> str:
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
