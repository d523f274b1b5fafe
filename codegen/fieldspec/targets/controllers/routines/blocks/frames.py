"""Blocks for messages, and for tasks that are carried out by them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.names import Name
from fieldspec.language.model.operand import Operand, Operands
from fieldspec.language.model.record import Message
from fieldspec.language.model.task import Step, Task
from fieldspec.language.model.watches import MOVING, before_effect, halting_task, is_command, last_command
from fieldspec.targets.controllers.routines.answers import judged, received
from fieldspec.targets.controllers.routines.blocks.kinds import handshake_slots
from fieldspec.targets.controllers.routines.blocks.line_tasks import Decide, LineTask, Unit
from fieldspec.targets.controllers.routines.blocks.lines import LineDraft
from fieldspec.targets.controllers.routines.blocks.operands import NoBlock, argument, constant
from fieldspec.targets.controllers.routines.blocks.ports import FRAMES, own_links, port_members
from fieldspec.targets.controllers.routines.blocks.progress import Seen
from fieldspec.targets.controllers.routines.blocks.standard import TRANSFER_ERRORS
from fieldspec.targets.controllers.routines.exchanges import meanings
from fieldspec.targets.controllers.routines.parameters import FRAME, parameters_of
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.routines.wrapping import link_words
from fieldspec.targets.controllers.sources.expansion import Expansion, source
from fieldspec.targets.controllers.statements.expressions import Expression, Variable
from fieldspec.targets.controllers.statements.routine import Declared, Routine, Statement


@dataclass(frozen=True, slots=True)
class Exchange:
    """A message on a link, and the functions that build its request and parse its response."""

    link: LinkLayout
    message: MessageLayout
    build: Routine
    parse: Routine


def exchange_of(world: World, link: LinkLayout, message: MessageLayout, by_name: Mapping[str, Routine]) -> Exchange:
    """A message on a link with the functions that build and parse it."""
    words = (*link_words(world, link), message.name)
    return Exchange(link, message, by_name[world.routine("build", *words)], by_name[world.routine("parse", *words)])


def add_exchange(
    block: LineDraft,
    exchange: Exchange,
    request_values: Mapping[str, Expression],
    response_values: Mapping[str, Expression],
    success: Sequence[Statement],
    refused: Sequence[Statement] = (),
    remark: str = "",
) -> int:
    """Adds a step that sends a request and parses the response into variables.

    `success` follows where it is right, and `refused` where the device refuses.
    """
    status = block.result
    judgement = judged(block.world, exchange.link, exchange.message, status, request_values, response_values, block)
    slots = {
        **handshake_slots(block.world),
        "Diagnostics": status,
        "uiReason": block.reason,
        "stPort": block.port,
        "ask": block.ask(),
        "success": success,
        "refused": refused,
        "answer": {
            **judgement,
            "build": exchange.build,
            "parse": exchange.parse,
            "asked": request_values,
            "answered": response_values,
        },
    }
    step = Expansion(source("message_step"), block, slots, port_members(block.world))
    return block.request(step.action("Send"), step.action("Receive"), remark)


def message_block(world: World, exchange: Exchange) -> Routine:
    """The block that exchanges a message."""
    link_name = link_words(world, exchange.link)
    name = world.block(*link_name, "send", exchange.message.name)
    block = LineDraft.executed(world, name, f"messages of {exchange.link.name}", FRAMES)
    block.limit()
    inputs = {
        declared.variable.name: block.declare(
            declared.variable.name, declared.variable.type, declared.role, declared.remark
        )
        for declared in (*exchange.build.of_role("input"), *exchange.build.of_role("in_out"))
        if declared.variable.name != FRAME
    }

    def output(declared: Declared) -> Variable:
        name = declared.variable.name
        text = f"{name}Answered" if name in inputs else name
        return block.declare(text, declared.variable.type, declared.role, declared.remark)

    answer = received(world, exchange.link, exchange.message, exchange.parse, block, output)
    add_exchange(block, exchange, inputs, answer.answered, [*answer.taken, block.end()], answer.refused)
    message = exchange.message.message
    title = message.title or Name.of(message.name).title()
    block.remarks += [
        f"Sends a message and takes the response: {title}. {world.comment(message, None)}".strip(),
        message.doc,
        meanings(world, TRANSFER_ERRORS),
    ]
    return block.block()


class MessageTask(LineTask):
    """Adds the steps of a block that sends messages."""

    def __init__(
        self,
        world: World,
        operands: Operands,
        by_name: Mapping[str, Routine],
        draft: LineDraft,
        tasks: Sequence[Task],
        known: LineTask | None,
    ) -> None:
        super().__init__(world, operands, draft, tasks, known)
        self.by_name = by_name

    def units(self, task: Task, first: int, stop: int) -> Iterable[Unit]:
        """See `LineTask`. Raises NoBlock for what is not a message."""
        index = first
        while index < stop:
            step = task.steps[index]
            if step.action != "send":
                raise NoBlock(f"`{step.target}` is not a message")
            last = index + 1
            while last < stop and task.steps[last].action in ("wait", "read"):
                last += 1
            looks = task.steps[index + 1 : last]
            waits = tuple(look for look in looks if look.action == "wait")
            reads = tuple(look for look in looks if look.action == "read")
            commands = is_command(task, index)
            yield Unit(index, last, commands, waits, reads, again=index > 0 and bool(waits) and not commands)
            index = last

    def first_units(self) -> Iterable[tuple[Task, Unit]]:
        """See `LineTask`."""
        task, first = self.task, before_effect(self.task)
        looks = [(task, replace(unit, again=False)) for unit in self.units(task, 0, first)]
        compared_later = self.conditions.compared(task)
        later = self.units(task, first, len(task.steps))
        at_start = [unit for unit in later if any(wait in compared_later for wait in unit.waits)]
        looks += [(task, Unit(unit.index, unit.behind, False)) for unit in at_start]
        if task.kind in MOVING and all(self.conditions.stands(self.seen(*look)) is None for look in looks):
            looks += [(own, replace(unit, waits=(), again=False)) for own, unit in self._standing()]
        return looks

    def _standing(self) -> Iterable[tuple[Task, Unit]]:
        """The units in which the task that stops the device waits for standstill."""
        halting = halting_task(self.world.layout.device)
        if halting is not None:
            for unit in self.units(halting, last_command(halting) + 1, len(halting.steps)):
                if unit.waits:
                    yield halting, unit

    def watching_unit(self) -> tuple[Task, Unit] | None:
        """See `LineTask`."""
        for unit in self.units(self.task, last_command(self.task) + 1, len(self.task.steps)):
            value_of = self.seen(self.task, unit)
            if any(value_of(watch.operand) is not None for watch in self.watches):
                return self.task, Unit(unit.index, unit.behind, False, again=True)
        return None

    def seen(self, task: Task, unit: Unit) -> Seen:
        """See `LineTask`."""
        exchange = self._exchange(self.target(task.steps[unit.index]))
        variables = self._answered(exchange)
        return lambda operand: self._seen(operand, exchange, variables)

    def perform(self, task: Task, unit: Unit, operands: Sequence[Operand], decide: Decide, remark: str) -> None:
        """See `LineTask`. Raises NoBlock for what is not in the response."""
        step = task.steps[unit.index]
        exchange = self._exchange(self.target(step))
        value_of = self.seen(task, unit)
        for look in (*unit.waits, *unit.reads):
            if value_of(self.target(look)) is None:
                raise NoBlock(f"{self.target(look).path} is not in the response of {exchange.message.name}")
        if unit.again:
            self.draft.settle("T#100ms")
        request_values = self._request_arguments(step, exchange)
        success = decide(self.draft.next + 1)
        add_exchange(self.draft, exchange, request_values, self._answered(exchange), success, remark=remark)

    def _answered(self, exchange: Exchange) -> dict[str, Variable]:
        """The local variables for the values in a response, by the names of the parsing function's outputs."""
        variables = {
            declared.variable.name: _local(self.draft, declared)
            for declared in exchange.parse.declared
            if declared.role == "output" and declared.variable.name != FRAME
        }
        if len(variables) + 1 < sum(declared.role in ("output", "in_out") for declared in exchange.parse.declared):
            raise NoBlock(f"the response of {exchange.message.name} has more than single values")
        return variables

    def _exchange(self, operand: Operand) -> Exchange:
        assert isinstance(operand.fact, Message)
        for link in own_links(self.world.layout):
            message = link.carried("response").get(operand.fact.name)
            if message is None and operand.fact.name in link.messages:
                raise NoBlock(f"{operand.fact.name} is not answered on {link.name}")
            if message is not None and not message.message.is_requested:
                raise NoBlock(f"only the device sends {operand.fact.name}")
            if message is not None:
                return exchange_of(self.world, link, message, self.by_name)
        raise NoBlock(f"{operand.fact.name} is on no link with frames")

    def _request_arguments(self, step: Step, exchange: Exchange) -> dict[str, Expression]:
        """The arguments of the function that builds the request."""
        request_values: dict[str, Expression] = {}
        asks, _ = parameters_of(self.world, exchange.link, exchange.message)
        remarks = {declared.variable.name: declared.remark for declared in exchange.build.declared}
        for variable in asks.head.values():
            remark = remarks[variable.name]
            request_values[variable.name] = self.draft.declared_once(variable.name, variable.type, "input", remark)
        for name, variable in asks.fields.variables.items():
            operand = self.operands.by_path.get(f"messages/{exchange.message.name}/request/{name}")
            if operand is None:
                raise NoBlock(f"the request of {exchange.message.name} has more than single values")
            if name in step.arguments:
                raw = argument(self.draft, step.arguments[name], operand, operand.value)
                request_values[variable.name] = self.conditions.arguments[step.arguments[name]] = raw
            elif name in step.values:
                value = step.values[name]
                if not isinstance(value, bool | int | str):
                    raise NoBlock(f"{name} of {exchange.message.name} is not a single number")
                request_values[variable.name] = constant(self.world, operand, operand.value, value, variable.type)
            else:
                raise NoBlock(f"the task does not say what {name} of {exchange.message.name} is")
        if asks.fields.count or any(item.variable.name != FRAME for item in exchange.build.of_role("in_out")):
            raise NoBlock(f"the request of {exchange.message.name} has more than single values")
        return request_values

    def _seen(
        self, operand: Operand, exchange: Exchange, response_variables: Mapping[str, Variable]
    ) -> Expression | None:
        """The variable that holds the value of an operand in a response; None where the response does not have it."""
        _, answers = parameters_of(self.world, exchange.link, exchange.message)
        variables: Mapping[str, Variable] = {}
        if operand.scope == f"messages/{exchange.message.name}":
            variables = answers.fields.variables
        elif operand.path.startswith(f"links/{exchange.link.name}/"):
            variables = answers.head
        variable = variables.get(operand.holder.name)
        return response_variables.get(variable.name) if variable is not None else None


def _local(block: LineDraft, declared: Declared) -> Variable:
    return block.declared_once(f"{declared.variable.name}Answered", declared.variable.type, "local")
