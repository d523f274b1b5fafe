"""Blocks for messages, and for tasks that are carried out by them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from fieldspec.classes import dataclass
from fieldspec.layout.frame import LinkLayout, MessageLayout
from fieldspec.model.operand import Operand, Operands
from fieldspec.model.record import Message
from fieldspec.model.task import Step, Task
from fieldspec.model.watches import before_effect, is_command, last_command
from fieldspec.names import Name
from fieldspec.plc.routines.blocks.line_tasks import Decide, LineTask, Unit
from fieldspec.plc.routines.blocks.lines import LineDraft
from fieldspec.plc.routines.blocks.operands import NoBlock, argument, constant
from fieldspec.plc.routines.blocks.ports import FRAMES, own_links
from fieldspec.plc.routines.blocks.progress import Seen
from fieldspec.plc.routines.blocks.standard import ERRORS, chain, meanings
from fieldspec.plc.routines.exchanges import compare_answer
from fieldspec.plc.routines.expressions import Expression, Negation, Variable, compared, either
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
    remark: str = "",
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
    return block.request(fill, take, remark)


def message_block(world: World, exchange: Exchange) -> Routine:
    """The block that exchanges a message."""
    several = link_words(world, exchange.link)
    name = world.block(*several, "send", exchange.message.name)
    block = LineDraft.executed(world, name, f"messages of {exchange.link.name}", FRAMES)
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
    add_exchange(block, exchange, asked, answered, [block.end()])
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


class MessageTask(LineTask):
    """The steps of a block that sends messages."""

    def __init__(
        self,
        world: World,
        operands: Operands,
        by_name: Mapping[str, Routine],
        draft: LineDraft,
        tasks: Sequence[Task],
        known: dict[str, int],
    ) -> None:
        super().__init__(world, operands, draft, tasks, known)
        self.by_name = by_name

    def units(self, task: Task, first: int, behind: int) -> Iterable[Unit]:
        index = first
        while index < behind:
            step = task.steps[index]
            if step.action != "send":
                raise NoBlock(f"`{step.target}` is no message")
            last = index + 1
            while last < behind and task.steps[last].action in ("wait", "read"):
                last += 1
            looks = task.steps[index + 1 : last]
            waits = tuple(look for look in looks if look.action == "wait")
            reads = tuple(look for look in looks if look.action == "read")
            yield Unit(index, last, is_command(task, index), waits, reads)
            index = last

    def first_units(self) -> Iterable[Unit]:
        first = before_effect(self.task)
        looks = list(self.units(self.task, 0, first))
        compared_later = self.conditions.relative(self.task.steps)
        for unit in self.units(self.task, first, len(self.task.steps)):
            if any(wait in compared_later for wait in unit.waits):
                looks.append(Unit(unit.index, unit.behind, False))
        return looks

    def watching_unit(self) -> tuple[Task, Unit] | None:
        for unit in self.units(self.task, last_command(self.task) + 1, len(self.task.steps)):
            seen = self.seen(self.task, unit)
            if any(seen(watch.operand) is not None for watch in self.watches):
                return self.task, Unit(unit.index, unit.behind, False)
        return None

    def seen(self, task: Task, unit: Unit) -> Seen:
        exchange = self._exchange(self.target(task.steps[unit.index]))
        answered = self._answered(exchange)
        return lambda operand: self._seen(operand, exchange, answered)

    def perform(self, task: Task, unit: Unit, needed: Sequence[Operand], decide: Decide, remark: str) -> None:
        step = task.steps[unit.index]
        exchange = self._exchange(self.target(step))
        seen = self.seen(task, unit)
        for look in (*unit.waits, *unit.reads):
            if seen(self.target(look)) is None:
                raise NoBlock(f"{self.target(look).path} is not in the response of {exchange.message.name}")
        if not unit.commands and task.steps[: unit.index]:
            self.draft.settle("T#100ms")
        asked = self._request_arguments(step, exchange)
        then = decide(self.draft.next + 1)
        add_exchange(self.draft, exchange, asked, self._answered(exchange), then, remark)

    def _answered(self, exchange: Exchange) -> dict[str, Variable]:
        """The variables for what a response has."""
        answered = {
            declared.variable.name: _local(self.draft, declared)
            for declared in exchange.parse.declared
            if declared.role == "output" and declared.variable.name != "aFrame"
        }
        if len(answered) + 1 < sum(declared.role in ("output", "in_out") for declared in exchange.parse.declared):
            raise NoBlock(f"the response of {exchange.message.name} has more than single values")
        return answered

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
                asked[variable.name] = self.draft.declared_once(variable.name, variable.type, "input", declared.remark)
                continue
            name = by_variable.get(variable.name, "")
            operand = self.operands.by_path.get(f"messages/{exchange.message.name}/request/{name}")
            if operand is None:
                raise NoBlock(f"the request of {exchange.message.name} has more than single values")
            if name in step.arguments:
                raw = argument(self.draft, step.arguments[name], operand, operand.value)
                asked[variable.name] = self.conditions.arguments[step.arguments[name]] = raw
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
    return block.declared_once(f"{declared.variable.name}Answered", declared.variable.type, "local")
