"""Function blocks that exchange a message, in the way of PLCopen: a rising edge starts, and every end has its output.

A block knows the protocol and nothing of the line. It asks for a frame to be sent, and is told of the one that came.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.targets.controllers.routines.answers import Received, judged, received
from fieldspec.targets.controllers.routines.named_numbers import named
from fieldspec.targets.controllers.routines.parameters import FRAME
from fieldspec.targets.controllers.routines.status_words import status_word
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.routines.wrapping import framed, link_words
from fieldspec.targets.controllers.sources.expansion import Expansion, source
from fieldspec.targets.controllers.statements.expressions import UINT, Expression, Variable, Whole
from fieldspec.targets.controllers.statements.interfaces import BlockVariables
from fieldspec.targets.controllers.statements.routine import STATUSES, Declared, Routine

ERRORS = {
    "request": (1, "a value is refused"),
    "timeout": (2, "no answer"),
    "damaged": (3, "a damaged answer"),
    "station": (4, "another station"),
    "other": (5, "another request"),
    "exception": (6, "the device refuses"),
    "transport": (7, "nothing sent or received"),
}
"""The numbers of ErrorID, and what they mean."""


def reasons(errors: Mapping[str, tuple[int, str]]) -> dict[str, Whole]:
    """The numbers of ErrorID as constants: `ERROR_TIMEOUT`"""
    return {key: named(code, UINT, "error", key) for key, (code, _) in errors.items()}


def meanings(world: World, errors: Mapping[str, tuple[int, str]]) -> str:
    """A line of a comment that says what the numbers of ErrorID mean."""
    subject = "status, low byte" if world.names.has_status else "ErrorID"
    return f"{subject}: " + ", ".join(f"{code} {text}" for code, text in errors.values()) + "."


def exchange_blocks(world: World, link: LinkLayout, routines: Sequence[Routine]) -> Iterator[Routine]:
    """A block for each message of a link that reads or writes registers; `routines` are those that it may call."""
    if not framed(link):
        return
    by_name = {routine.name: routine for routine in routines}
    for message in link.exchanged.values():
        if message.message.single_access is not None:
            words = (*link_words(world, link), message.name)
            build, parse = by_name[world.routine("build", *words)], by_name[world.routine("parse", *words)]
            yield _block(world, link, message, build, parse, world.block(*words))


def judging_slots(world: World) -> dict[str, Any]:
    """The names for every source that judges responses."""
    return {
        "StatusType": world.status.type,
        "Codec": {name: world.status.of(name) for name, _ in STATUSES},
        "Reason": reasons(ERRORS),
        "has_status": world.names.has_status,
        "status_word": lambda: status_word(world),
        "has_number": not world.names.has_status,
    }


def _block(
    world: World, link: LinkLayout, message: MessageLayout, build: Routine, parse: Routine, name: str
) -> Routine:
    """The block that exchanges a message: the slots of `exchange.st`."""
    request_values: dict[str, Expression] = {}
    variables = BlockVariables()
    answer: list[Received] = []

    def request_part(role: str) -> Sequence[Declared]:
        """Declares what the request needs."""
        for declared in build.of_role(role):
            name, kind = declared.variable.name, declared.variable.type
            own, remark = (name, declared.remark) if name != FRAME else ("Frame", "what is sent, and then received")
            request_values[name] = variables.declare(own, kind, role, remark)
        return ()

    def output(declared: Declared) -> Variable:
        """Declares an output for a part of the response; where the request has the name, another one."""
        name = declared.variable.name
        text = f"{name}Answered" if name in request_values else name
        return variables.declare(text, declared.variable.type, declared.role, declared.remark)

    def outputs() -> Sequence[Declared]:
        answer.append(received(world, link, message, parse, variables, output))
        return ()

    slots = {
        **judging_slots(world),
        "link": link.name,
        "title": message.message.title or message.name.replace("_", " "),
        "comment": world.comment(message.message, None),
        "errors": meanings(world, ERRORS),
        "build": build,
        "parse": parse,
        "inputs": lambda: request_part("input"),
        "lent": lambda: request_part("in_out"),
        "outputs": outputs,
        "asked": request_values,
    }
    expansion = Expansion(source("exchange"), variables, slots, {})
    response = answer[0]
    status = expansion.scope["Diagnostics"]
    expansion.scope |= {
        "answered": {FRAME: request_values[FRAME], **response.answered},
        "taken": response.taken,
        "refused": response.refused,
        "answer": judged(world, link, message, status, request_values, response.answered, variables),
    }
    return expansion.routine(name, build.group)
