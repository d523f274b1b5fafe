"""Function blocks that exchange a message, in the way of PLCopen: a rising edge starts, and every end has its output.

A block knows the protocol and nothing of the line. It asks for a frame to be sent, and is told of the one that came.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.foundation.classes import replace
from fieldspec.targets.controllers.routines.answers import Received, judged, received
from fieldspec.targets.controllers.routines.named_numbers import named
from fieldspec.targets.controllers.routines.parameters import FRAME
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.routines.wrapping import framed, link_words
from fieldspec.targets.controllers.sources.expansion import Expansion, source
from fieldspec.targets.controllers.statements.expressions import UINT, Expression, Variable, Whole
from fieldspec.targets.controllers.statements.routine import STATUSES, Declared, Routine, Variables

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


def meanings(errors: Mapping[str, tuple[int, str]]) -> str:
    """A line of a comment that says what the numbers of ErrorID mean."""
    return "ErrorID: " + ", ".join(f"{code} {text}" for code, text in errors.values()) + "."


def exchange_blocks(world: World, link: LinkLayout, routines: Sequence[Routine]) -> Iterator[Routine]:
    """A block for each message of a link that reads or writes registers; `routines` are those that it may call."""
    if not framed(link):
        return
    by_name = {routine.name: routine for routine in routines}
    for message in link.exchanged.values():
        if message.message.accesses is not None:
            words = (*link_words(world, link), message.name)
            build, parse = by_name[world.routine("build", *words)], by_name[world.routine("parse", *words)]
            yield _block(world, link, message, build, parse, world.block(*words))


def judging_slots(world: World) -> dict[str, Any]:
    """What every source may name that judges answers."""
    return {
        "StatusType": world.status.type,
        "Status": {name: world.status.of(name) for name, _ in STATUSES},
        "Reason": reasons(ERRORS),
    }


def _block(
    world: World, link: LinkLayout, message: MessageLayout, build: Routine, parse: Routine, name: str
) -> Routine:
    """The block that exchanges a message: the slots of `exchange.st`."""
    request_values: dict[str, Expression] = {
        declared.variable.name: declared.variable for declared in (*build.of_role("input"), *build.of_role("in_out"))
    }
    parameters = [declared for declared in (*build.declared, *parse.declared) if declared.role != "local"]
    variables = Variables(*(declared.variable.name for declared in parameters))
    frame = "what is sent, and then what was received"
    answer: list[Received] = []

    def output(declared: Declared) -> Variable:
        """Declares an output for a part of the response; where the request has the name, another one."""
        variable = declared.variable
        if variable.name in request_values:
            return variables.declare(f"{variable.name}Answered", variable.type, declared.role, declared.remark)
        variables.declared.append(declared)
        return variable

    def outputs() -> Sequence[Declared]:
        answer.append(received(world, link, message, parse, variables, output))
        return ()

    slots = {
        **judging_slots(world),
        "link": link.name,
        "title": message.message.title or message.name.replace("_", " "),
        "comment": world.comment(message.message, None),
        "errors": meanings(ERRORS),
        "build": build,
        "parse": parse,
        "inputs": build.of_role("input"),
        "lent": [
            replace(item, remark=frame if item.variable.name == FRAME else item.remark)
            for item in build.of_role("in_out")
        ],
        "outputs": outputs,
        "asked": request_values,
    }
    expansion = Expansion(source("exchange"), variables, slots, {})
    response, own = answer[0], {item.variable.name: item.variable for item in parse.of_role("in_out")}
    status = expansion.scope["eStatus"]
    expansion.scope |= {
        "answered": {**own, **response.answered},
        "taken": response.taken,
        "refused": response.refused,
        "answer": judged(world, link, message, status, request_values, response.answered, variables),
    }
    return expansion.routine(name, build.group)
