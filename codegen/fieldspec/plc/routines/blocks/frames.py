"""Blocks for messages, and for tasks that are carried out by them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from fieldspec.classes import dataclass
from fieldspec.layout.frame import LinkLayout, MessageLayout
from fieldspec.model.operand import Operand, Operands
from fieldspec.model.record import Message
from fieldspec.model.task import Step, Task
from fieldspec.model.watches import LASTING, REFUSAL, before_effect, watches
from fieldspec.names import Name
from fieldspec.plc.routines.answers import judged, received
from fieldspec.plc.routines.blocks.lines import LineDraft
from fieldspec.plc.routines.blocks.operands import NoBlock, argument, constant, holds, outputs_of
from fieldspec.plc.routines.blocks.ports import AXIS, FRAMES, member, own_links
from fieldspec.plc.routines.blocks.standard import ERRORS, chain, meanings
from fieldspec.plc.routines.blocks.tasks import TAKING_OVER, describe, end_steps, target
from fieldspec.plc.routines.blocks.words import opposite, value_of
from fieldspec.plc.routines.expressions import (
    Expression,
    Variable,
)
from fieldspec.plc.routines.parameters import FRAME, parameters_of
from fieldspec.plc.routines.routine import Assignment, Declared, Routine, Statement
from fieldspec.plc.routines.world import World
from fieldspec.plc.routines.wrapping import LENGTH, link_words


@dataclass(frozen=True, slots=True)
class Exchange:
    """A message on a link, and the functions that build its request and parse its response."""

    link: LinkLayout
    message: MessageLayout
    build: Routine
    parse: Routine


def exchange_of(world: World, link: LinkLayout, message: MessageLayout, by_name: Mapping[str, Routine]) -> Exchange:
    """The functions of a message."""
    words = (*link_words(world, link), message.name)
    return Exchange(link, message, by_name[world.routine("build", *words)], by_name[world.routine("parse", *words)])


def add_exchange(
    block: LineDraft,
    exchange: Exchange,
    asked: Mapping[str, Expression],
    answered: Mapping[str, Expression],
    then: Sequence[Statement],
    refused: Sequence[Statement] = (),
) -> int:
    """Adds a step that sends a request and parses the response into variables.

    `then` follows where it is right, and `refused` where the device refuses.
    """
    lent = {FRAME: block.of_port("frame")}
    built = exchange.build.called(**{**lent, **asked, LENGTH: block.of_port("send")})
    parsed = exchange.parse.called(**{**lent, **answered, LENGTH: block.of_port("received")})
    fill = block.attempt(built, tuple(block.ask()), "request")

    def fail(reason: str) -> list[Statement]:
        return [*(refused if reason == "exception" else ()), block.fail(reason)]

    judgement = judged(block.world, exchange.link, exchange.message, block.result, asked, answered, block, fail, then)
    take: list[Statement] = [Assignment(block.result, parsed), *judgement]
    return block.request(fill, take)


def message_block(world: World, exchange: Exchange) -> Routine:
    """The block that exchanges a message."""
    several = link_words(world, exchange.link)
    name = world.block(*several, "send", exchange.message.name)
    block = LineDraft(world, name, f"messages of {exchange.link.name}", FRAMES)
    block.limit()
    asked = {
        declared.variable.name: block.declare(
            declared.variable.name, declared.variable.type, declared.role, declared.remark
        )
        for declared in (*exchange.build.of_role("input"), *exchange.build.of_role("in_out"))
        if declared.variable.name != FRAME
    }

    def output(declared: Declared) -> Variable:
        name = declared.variable.name
        text = f"{name}Answered" if name in asked else name
        return block.declare(text, declared.variable.type, declared.role, declared.remark)

    answer = received(world, exchange.link, exchange.message, exchange.parse, block, output)
    add_exchange(block, exchange, asked, answer.answered, [*answer.taken, block.go(2)], answer.refused)
    message = exchange.message.message
    title = message.title or Name.of(message.name).title()
    block.remarks += [
        f"Sends a message and takes the response: {title}. {world.comment(message, None)}".strip(),
        message.doc,
        meanings(ERRORS),
    ]
    return block.block()


def message_task(world: World, operands: Operands, by_name: Mapping[str, Routine], task: Task) -> Routine:
    """The block for a task whose steps send messages; NoBlock is raised where it cannot be."""
    levelled = task.kind.startswith("read_")
    block = LineDraft(world, world.block(task.name), f"task {task.name}", FRAMES, levelled)
    if task.kind in TAKING_OVER:
        axis = block.struct("axis", AXIS, "the same for all blocks of the device")
        block.take_over(member(world, AXIS, "motion", axis))
    _Sending(world, operands, by_name, block, task).all()
    describe(block, task)
    return block.block()


class _Sending:
    """The steps of a block while they are being added."""

    def __init__(
        self, world: World, operands: Operands, by_name: Mapping[str, Routine], block: LineDraft, task: Task
    ) -> None:
        self.world, self.operands, self.by_name, self.block, self.task = world, operands, by_name, block, task
        self.watches = watches(world.layout.device, operands, task)
        self.sent: list[tuple[int, Step, Exchange]] = []

    def all(self) -> None:
        """Adds the steps: each message with what is looked at in its response."""
        task, block = self.task, self.block
        if before_effect(task):
            raise NoBlock("it waits before it has sent anything")
        ends = end_steps(task)
        if not block.levelled and task.kind not in LASTING:
            block.limit()
        begins: dict[int, int] = {}
        at = 0
        while at < len(task.steps):
            if ends is not None and at == ends[1]:
                block.hold = True
                block.add([])
            begins[at] = block.next
            at = self._sends(at)
        if ends is not None:
            block.ends_by(begins[ends[0]], begins[ends[1]], block.next - 1)

    def _sends(self, at: int) -> int:
        """Adds a message and the steps behind it that look at its response; gives the place of the next one."""
        steps = self.task.steps
        step = steps[at]
        if step.action != "send":
            raise NoBlock(f"`{step.target}` is no message")
        operand = target(self.operands, step)
        exchange = self._exchange(operand)
        last = at + 1
        while last < len(steps) and steps[last].action in ("wait", "read"):
            last += 1
        looks = steps[at + 1 : last]
        asks_again = at > 0 and not step.values and not step.arguments
        if asks_again and any(look.action == "wait" for look in looks):
            self.block.settle_input("T#100ms")
            self.block.settle()
        asked = self._request_arguments(step, exchange)
        answered = {
            declared.variable.name: _local(self.block, declared)
            for declared in exchange.parse.declared
            if declared.role == "output" and declared.variable.name != FRAME
        }
        if len(answered) + 1 < sum(declared.role in ("output", "in_out") for declared in exchange.parse.declared):
            raise NoBlock(f"the response of {exchange.message.name} has more than single values")
        here = self.block.next
        then: list[Statement] = []
        branches: list[tuple[Expression, Sequence[Statement]]] = []
        waits = [look for look in looks if look.action == "wait"]
        if waits:
            for watch in self.watches:
                read = self._seen(watch.operand, exchange, answered)
                if read is not None:
                    test = holds(self.world, watch.operand, watch.operand.value, watch.value, read)
                    branches.append((opposite(test), [self.block.fail(watch.reason)]))
            for look in waits:
                seen = target(self.operands, look)
                read = self._seen(seen, exchange, answered)
                if read is None:
                    raise NoBlock(f"{seen.path} is not in the response of {exchange.message.name}")
                test = holds(self.world, seen, seen.value, value_of(look), read)
                missing = self.block.go(here) if asks_again else self.block.fail("unready")
                if REFUSAL in seen.roles:
                    missing = self.block.fail("exception")
                branches.append((opposite(test), [missing]))
        for look in looks:
            if look.action == "read":
                seen = target(self.operands, look)
                read = self._seen(seen, exchange, answered)
                if read is None:
                    raise NoBlock(f"{seen.path} is not in the response of {exchange.message.name}")
                then += outputs_of(self.block, seen.fact.name, seen, seen.value, read)
        then.append(self.block.go(here + 1))
        add_exchange(self.block, exchange, asked, answered, [chain(branches, then)] if branches else then)
        return last

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
        asked: dict[str, Expression] = {}
        asks, _ = parameters_of(self.world, exchange.link, exchange.message)
        remarks = {declared.variable.name: declared.remark for declared in exchange.build.declared}
        for variable in asks.head.values():
            remark = remarks[variable.name]
            asked[variable.name] = self.block.declared_once(variable.name, variable.type, "input", remark)
        for name, variable in asks.fields.variables.items():
            operand = self.operands.by_path.get(f"messages/{exchange.message.name}/request/{name}")
            if operand is None:
                raise NoBlock(f"the request of {exchange.message.name} has more than single values")
            if name in step.arguments:
                asked[variable.name] = argument(self.block, step.arguments[name], operand, operand.value)
            elif name in step.values:
                value = step.values[name]
                if not isinstance(value, bool | int | str):
                    raise NoBlock(f"{name} of {exchange.message.name} is no single number")
                asked[variable.name] = constant(self.world, operand, operand.value, value, variable.type)
            else:
                raise NoBlock(f"the task does not say what {name} of {exchange.message.name} is")
        if asks.fields.count or any(item.variable.name != FRAME for item in exchange.build.of_role("in_out")):
            raise NoBlock(f"the request of {exchange.message.name} has more than single values")
        return asked

    def _seen(self, operand: Operand, exchange: Exchange, answered: Mapping[str, Variable]) -> Expression | None:
        """The variable of what a response has, where an operand is in it."""
        _, answers = parameters_of(self.world, exchange.link, exchange.message)
        variables: Mapping[str, Variable] = {}
        if operand.scope == f"messages/{exchange.message.name}":
            variables = answers.fields.variables
        elif operand.path.startswith(f"links/{exchange.link.name}/"):
            variables = answers.head
        variable = variables.get(operand.holder.name)
        return answered.get(variable.name) if variable is not None else None


def _local(block: LineDraft, declared: Declared) -> Variable:
    name = declared.variable.name
    for other in block.declared:
        if other.variable.name == name and other.role != "local":
            name = f"{name}Answered"
            break
    return block.declared_once(name, declared.variable.type, "local")
