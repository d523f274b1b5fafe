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
from fieldspec.plc.routines.blocks.lines import LineDraft
from fieldspec.plc.routines.blocks.operands import NoBlock, argument, constant, holds, outputs_of
from fieldspec.plc.routines.blocks.ports import AXIS, FRAMES, member, own_links
from fieldspec.plc.routines.blocks.standard import ERRORS, chain, meanings
from fieldspec.plc.routines.blocks.tasks import TAKING_OVER, describe, end_steps, target
from fieldspec.plc.routines.blocks.words import opposite, value_of
from fieldspec.plc.routines.exchanges import compare_answer
from fieldspec.plc.routines.expressions import (
    Expression,
    Negation,
    Variable,
    compared,
    either,
)
from fieldspec.plc.routines.frames import head_members
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
) -> int:
    """Adds a step that sends a request and parses the response into variables; `then` follows where it is right."""
    frame = block.of_port("frame")
    lent = {"aFrame": frame}
    built = exchange.build.called(**{**lent, **asked, LENGTH: block.of_port("send")})
    parsed = exchange.parse.called(**{**lent, **answered, LENGTH: block.of_port("received")})
    fill = block.attempt(built, tuple(block.ask()), "request")
    status = block.status
    refused = compared(block.result, "=", status.of("refused"))
    wrong = compare_answer(block.world, exchange.link, exchange.message, asked, answered)
    branches: list[tuple[Expression, Sequence[Statement]]] = [
        (Negation(either([block.good, refused])), [block.fail("damaged")]),
        *((either(wrong[reason]), [block.fail(reason)]) for reason in ("station",) if wrong[reason]),
        (refused, [block.fail("exception")]),
        *((either(wrong[reason]), [block.fail(reason)]) for reason in ("other",) if wrong[reason]),
    ]
    take: list[Statement] = [Assignment(block.result, parsed), chain(branches, then)]
    return block.request(fill, take)


def message_block(world: World, exchange: Exchange) -> Routine:
    """The block that exchanges a message."""
    several = link_words(world, exchange.link)
    name = world.block(*several, "send", exchange.message.name)
    block = LineDraft(world, name, f"messages of {exchange.link.name}", FRAMES)
    block.limit()
    asked: dict[str, Variable] = {}
    for declared in (*exchange.build.of_role("input"), *exchange.build.of_role("in_out")):
        if declared.variable.name != "aFrame":
            asked[declared.variable.name] = _lent(block, declared)
    answered: dict[str, Expression] = {}
    for declared in (*exchange.parse.of_role("output"), *exchange.parse.of_role("in_out")):
        text = declared.variable.name
        if text != "aFrame":
            lent = asked.get(text)
            if lent is not None and declared.role == "in_out" and lent.type == declared.variable.type:
                answered[text] = lent
            else:
                answered[text] = _answer(block, declared, lent is not None)
    add_exchange(block, exchange, asked, answered, [block.go(2)])
    message = exchange.message.message
    title = message.title or Name.of(message.name).title()
    block.remarks += [
        f"Sends a message and takes the response: {title}. {world.comment(message, None)}".strip(),
        message.doc,
        meanings(ERRORS),
    ]
    return block.block()


def _lent(block: LineDraft, declared: Declared) -> Variable:
    return block.declared_once(declared.variable.name, declared.variable.type, declared.role, declared.remark)


def _answer(block: LineDraft, declared: Declared, repeated: bool) -> Variable:
    name = f"{declared.variable.name}Answered" if repeated else declared.variable.name
    role = "local" if repeated and declared.role == "output" else declared.role
    return block.declared_once(name, declared.variable.type, role, declared.remark)


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
            if declared.role == "output" and declared.variable.name != "aFrame"
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
        heads = {
            self.world.variable(part.name, self.world.type_of(part.value))
            for part in head_members(exchange.link.request)
            if part.value is not None
        }
        asked: dict[str, Expression] = {}
        by_variable = {
            self.world.variable(field.name, self.world.type_of(field.value)): field.name
            for field in exchange.message.request.fields
            if field.value is not None
        }
        for declared in exchange.build.of_role("input"):
            variable = declared.variable
            if variable.name in heads:
                asked[variable.name] = self.block.declared_once(variable.name, variable.type, "input", declared.remark)
                continue
            name = by_variable.get(variable.name, "")
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
        if any(declared.variable.name != "aFrame" for declared in exchange.build.of_role("in_out")):
            raise NoBlock(f"the request of {exchange.message.name} has more than single values")
        return asked

    def _seen(self, operand: Operand, exchange: Exchange, answered: Mapping[str, Variable]) -> Expression | None:
        """The variable of what a response has, where an operand is in it."""
        in_message = operand.scope == f"messages/{exchange.message.name}"
        in_head = operand.path.startswith(f"links/{exchange.link.name}/")
        content = operand.value if operand.bit is None else getattr(operand.holder, "value", None)
        if not (in_message or in_head) or content is None:
            return None
        return answered.get(self.world.variable(operand.holder.name, self.world.type_of(content)))


def _local(block: LineDraft, declared: Declared) -> Variable:
    name = declared.variable.name
    for other in block.declared:
        if other.variable.name == name and other.role != "local":
            name = f"{name}Answered"
            break
    return block.declared_once(name, declared.variable.type, "local")
