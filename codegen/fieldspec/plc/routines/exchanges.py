"""Function blocks that exchange a message, in the way of PLCopen: a rising edge starts, and every end has its output.

A block knows the protocol and nothing of the line. It asks for a frame to be sent, and is told of the one that came.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from fieldspec.classes import dataclass, replace
from fieldspec.layout.frame import LinkLayout
from fieldspec.layout.message import MessageLayout
from fieldspec.plc.routines.answers import Received, judged, received
from fieldspec.plc.routines.expressions import (
    BOOL,
    INT,
    TIME,
    TIMER,
    UINT,
    Expression,
    Member,
    Negation,
    Truth,
    Variable,
    Whole,
    compared,
    either,
    every,
    number,
    plus,
)
from fieldspec.plc.routines.parameters import FRAME
from fieldspec.plc.routines.routine import (
    Assignment,
    Condition,
    Declared,
    Routine,
    Statement,
    Timing,
    Variables,
    when,
)
from fieldspec.plc.routines.world import World
from fieldspec.plc.routines.wrapping import LENGTH, framed, link_words

_IDLE, _BUILD, _WAIT, _AGAIN = range(4)
ERRORS = {
    "request": (1, "the request cannot be built: eStatus says why"),
    "timeout": (2, "there was no answer in time"),
    "damaged": (3, "the answer is damaged or none to this message: eStatus says why"),
    "station": (4, "another station has answered"),
    "other": (5, "the answer is to another request"),
    "exception": (6, "the device refuses: further outputs say why"),
    "transport": (7, "the frame could not be sent"),
}
"""The numbers of ErrorID, and what they mean."""


def exchange_blocks(world: World, link: LinkLayout, routines: Sequence[Routine]) -> Iterator[Routine]:
    """A block for each message of a link that reads or writes registers; `routines` are those that it may call."""
    if not framed(link):
        return
    by_name = {routine.name: routine for routine in routines}
    for message in link.exchanged.values():
        if message.message.accesses is not None:
            words = (*link_words(world, link), message.name)
            build, parse = by_name[world.routine("build", *words)], by_name[world.routine("parse", *words)]
            yield _Exchange(world, link, message, build, parse).block(world.block(*words))


@dataclass(frozen=True, slots=True)
class _Standard:
    """The variables that the body of every exchange block uses."""

    execute: Variable
    abort: Variable
    timeout: Variable
    retries: Variable
    received: Variable
    failed: Variable
    done: Variable
    busy: Variable
    aborted: Variable
    error: Variable
    error_id: Variable
    send: Variable


class _Exchange:
    """Makes the block that exchanges a message."""

    def __init__(self, world: World, link: LinkLayout, message: MessageLayout, build: Routine, parse: Routine) -> None:
        self.world, self.link, self.message, self.build, self.parse = world, link, message, build, parse
        self.status = world.status
        inputs = (*build.of_role("input"), *build.of_role("in_out"))
        self.asked = {declared.variable.name: declared.variable for declared in inputs}
        messages = [
            declared.variable.name for declared in (*build.declared, *parse.declared) if declared.role != "local"
        ]
        self.variables = Variables(*messages)
        self.declared, self._declare = self.variables.declared, self.variables.declare

    def block(self, name: str) -> Routine:
        """The block that exchanges the message: its variables and its statements."""
        execute = self._declare(
            "Execute", BOOL, "input", "a rising edge starts; the other inputs stay until Busy is FALSE"
        )
        abort = self._declare("Abort", BOOL, "input", "ends the exchange with CommandAborted")
        self.declared += self.build.of_role("input")
        timeout = self._declare("tTimeout", TIME, "input", "for each try", "T#500ms")
        retries = self._declare("iRetries", INT, "input", "how often the request is sent again", "2")
        arrived = self._declare("xReceived", BOOL, "input", "its rising edge says that aFrame holds iReceived bytes")
        count = self._declare("iReceived", INT, "input", "how many bytes of aFrame were received")
        failed = self._declare("xFailed", BOOL, "input", "aFrame cannot be sent")
        frame = "what is sent, and then what was received"
        self.declared += [
            replace(declared, remark=frame if declared.variable.name == FRAME else declared.remark)
            for declared in self.build.of_role("in_out")
        ]
        done = self._declare("Done", BOOL, "output")
        busy = self._declare("Busy", BOOL, "output")
        aborted = self._declare("CommandAborted", BOOL, "output")
        error = self._declare("Error", BOOL, "output")
        error_id = self._declare("ErrorID", UINT, "output", "0, or why Error is TRUE")
        send = self._declare("xSend", BOOL, "output", "its rising edge asks to send iSend bytes of aFrame")
        size = self._declare("iSend", INT, "output", "how many bytes of aFrame are to be sent")
        status = self._declare("eStatus", self.status.type, "output", "what the last function has returned")
        answer = received(self.world, self.link, self.message, self.parse, self.variables, self._output)
        standard = _Standard(
            *(execute, abort, timeout, retries, arrived, failed, done, busy, aborted, error, error_id, send)
        )
        body = self._body(standard, count, size, status, answer)
        return Routine(name, self.build.group, None, self.variables.needed(body), body, tuple(self._remarks()))

    def _remarks(self) -> Iterator[str]:
        title = self.message.message.title or self.message.name.replace("_", " ")
        comment = self.world.comment(self.message.message, None)
        yield f"Exchanges a message on {self.link.name}: {title}. {comment}".strip()
        yield "ErrorID: " + "; ".join(f"{code} {text}" for code, text in ERRORS.values()) + "."
        yield (
            "Nothing starts without a rising edge of Execute, the first scan included. Done, CommandAborted and Error "
            "stay until Execute is FALSE, and at least one scan. Call the block in each scan."
        )

    def _output(self, declared: Declared) -> Variable:
        """Declares an output for a part of the response; where the request has the name, another one."""
        variable = declared.variable
        if variable.name in self.asked:
            return self._declare(f"{variable.name}Answered", variable.type, declared.role, declared.remark)
        self.declared.append(declared)
        return variable

    def _body(
        self, standard: _Standard, count: Variable, size: Variable, status: Variable, answer: Received
    ) -> tuple[Statement, ...]:
        before = self._declare("xExecuteBefore", BOOL, "local", "so that nothing starts in the first scan", "TRUE")
        received_before = self._declare("xReceivedBefore", BOOL, "local")
        edge, arrived = self._declare("xEdge", BOOL, "local"), self._declare("xArrived", BOOL, "local")
        state, tries = self._declare("iState", INT, "local"), self._declare("iTry", INT, "local")
        reason, timer = self._declare("uiReason", UINT, "local"), self._declare("fbTimeout", TIMER, "local")

        def in_state(expected: int) -> Expression:
            return compared(state, "=", number(expected))

        def ended(output: Variable, error_code: Expression | None = None) -> list[Statement]:
            first = [Assignment(standard.error_id, error_code)] if error_code is not None else []
            return [
                *first,
                *(Assignment(output, Truth(True)), Assignment(standard.busy, Truth(False))),
                *(Assignment(standard.send, Truth(False)), Assignment(state, number(_IDLE))),
            ]

        def because(key: str) -> Whole:
            return Whole(ERRORS[key][0], UINT)

        def noted(key: str) -> list[Statement]:
            return [Assignment(reason, because(key))]

        def called(routine: Routine, length: Variable, outputs: Mapping[str, Expression]) -> Assignment:
            names = [declared.variable for declared in routine.declared if declared.role != "local"]
            arguments: dict[str, Expression] = {
                variable.name: outputs.get(variable.name, variable) for variable in names
            }
            return Assignment(status, routine.called(**{**arguments, LENGTH: length}))

        repeat: list[Statement] = [Assignment(standard.send, Truth(False)), Assignment(state, number(_AGAIN))]
        good = compared(status, "=", self.status.of("ok"))
        bodies = {
            **{key: noted(key) for key in ("damaged", "station", "other")},
            "exception": [*answer.refused, *ended(standard.error, because("exception"))],
        }
        right = [*answer.taken, *ended(standard.done)]
        values = (self.asked, answer.answered, self.variables)
        judgement = judged(self.world, self.link, self.message, status, *values, bodies.__getitem__, right)
        reset = [Assignment(variable, Truth(False)) for variable in (standard.done, standard.aborted, standard.error)]
        idle = [
            when(
                either([edge, Negation(standard.execute)]),
                [*reset, Assignment(standard.error_id, Whole(0, UINT))],
            ),
            when(
                edge,
                [
                    *(Assignment(standard.busy, Truth(True)), Assignment(tries, number(0))),
                    Assignment(state, number(_BUILD)),
                ],
            ),
        ]
        building: list[Statement] = [
            called(self.build, size, {}),
            when(
                good,
                [
                    *(Assignment(standard.send, Truth(True)), Assignment(reason, because("timeout"))),
                    Assignment(state, number(_WAIT)),
                ],
                ended(standard.error, because("request")),
            ),
        ]
        waiting: list[Statement] = [
            when(arrived, [called(self.parse, count, answer.answered), *judgement]),
            when(every([in_state(_WAIT), standard.failed]), [Assignment(reason, because("transport")), *repeat]),
            when(every([in_state(_WAIT), Member(timer, "Q", BOOL)]), repeat),
        ]
        repeating = [
            when(
                compared(tries, "<", standard.retries),
                [Assignment(tries, plus(tries, 1)), Assignment(state, number(_BUILD))],
                ended(standard.error, reason),
            )
        ]
        return (
            Timing(timer, in_state(_WAIT), standard.timeout),
            Assignment(edge, every([standard.execute, Negation(before)])),
            Assignment(before, standard.execute),
            Assignment(arrived, every([standard.received, Negation(received_before)])),
            Assignment(received_before, standard.received),
            Condition(
                (
                    (in_state(_IDLE), tuple(idle)),
                    (standard.abort, tuple(ended(standard.aborted))),
                    (in_state(_BUILD), tuple(building)),
                    (in_state(_WAIT), tuple(waiting)),
                ),
                tuple(repeating),
            ),
        )
