"""Function blocks that exchange a message, in the way of PLCopen: a rising edge starts, and every end has its output.

A block knows the protocol and nothing of the line. It asks for a frame to be sent, and is told of the one that came.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from fieldspec.classes import dataclass, replace
from fieldspec.layout.frame import LinkLayout, MessageLayout
from fieldspec.plc.routines.expressions import (
    BOOL,
    INT,
    TIME,
    TIMER,
    UINT,
    Elementary,
    Expression,
    Member,
    Negation,
    Operation,
    Truth,
    Type,
    Variable,
    Whole,
    compared,
    converted,
    either,
    every,
    number,
    plus,
)
from fieldspec.plc.routines.frames import head_members
from fieldspec.plc.routines.routine import Assignment, Condition, Declared, Routine, Statement, Timing, when
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
    """The variables that all blocks have."""

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
    """A block while it is being made."""

    def __init__(self, world: World, link: LinkLayout, message: MessageLayout, build: Routine, parse: Routine) -> None:
        self.world, self.link, self.message, self.build, self.parse = world, link, message, build, parse
        self.declared: list[Declared] = []
        self.status = world.status
        self.asked = {declared.variable.name: declared.variable for declared in build.of_role("input")}
        self.answered: dict[str, Variable] = {}
        self.taken = {
            declared.variable.name.lower()
            for declared in (*build.declared, *parse.declared)
            if declared.role != "local"
        }

    def _declare(self, name: str, kind: Type, role: str, remark: str = "", initial: str = "") -> Variable:
        """A variable of the block itself; where a value of the message has its name, a number stands behind it."""
        which, tried = 1, name
        while tried.lower() in self.taken:
            which += 1
            tried = f"{name}{which}"
        self.taken.add(tried.lower())
        variable = Variable(tried, kind)
        self.declared.append(Declared(variable, role, remark, initial))
        return variable

    def block(self, name: str) -> Routine:
        """The whole block."""
        execute = self._declare(
            "Execute", BOOL, "input", "a rising edge starts; the other inputs stay until Busy is FALSE"
        )
        abort = self._declare("Abort", BOOL, "input", "ends the exchange with CommandAborted")
        self.declared += self.build.of_role("input")
        timeout = self._declare("tTimeout", TIME, "input", "for each try", "T#500ms")
        retries = self._declare("iRetries", INT, "input", "how often the request is sent again", "2")
        received = self._declare("xReceived", BOOL, "input", "its rising edge says that aFrame holds iReceived bytes")
        count = self._declare("iReceived", INT, "input", "how many bytes of aFrame were received")
        failed = self._declare("xFailed", BOOL, "input", "aFrame cannot be sent")
        lent = {
            declared.variable.name: declared
            for declared in (*self.build.of_role("in_out"), *self.parse.of_role("in_out"))
        }
        remarks = {"aFrame": "what is sent, and then what was received"}
        self.declared += [replace(declared, remark=remarks.get(key, declared.remark)) for key, declared in lent.items()]
        done = self._declare("Done", BOOL, "output")
        busy = self._declare("Busy", BOOL, "output")
        aborted = self._declare("CommandAborted", BOOL, "output")
        error = self._declare("Error", BOOL, "output")
        error_id = self._declare("ErrorID", UINT, "output", "0, or why Error is TRUE")
        send = self._declare("xSend", BOOL, "output", "its rising edge asks to send iSend bytes of aFrame")
        size = self._declare("iSend", INT, "output", "how many bytes of aFrame are to be sent")
        status = self._declare("eStatus", self.status.type, "output", "what the last function has returned")
        self._answers()
        standard = _Standard(
            *(execute, abort, timeout, retries, received, failed, done, busy, aborted, error, error_id, send)
        )
        body = self._body(standard, count, size, status)
        return Routine(name, self.build.group, None, tuple(self.declared), body, tuple(self._remarks()))

    def _remarks(self) -> Iterator[str]:
        title = self.message.message.title or self.message.name.replace("_", " ")
        more = self.world.comment(self.message.message, None)
        yield f"Exchanges a message on {self.link.name}: {title}. {more}".strip()
        yield "ErrorID: " + "; ".join(f"{code} {text}" for code, text in ERRORS.values()) + "."
        yield (
            "Nothing starts without a rising edge of Execute, the first scan included. Done, CommandAborted and Error "
            "stay until Execute is FALSE, and at least one scan. Call the block in each scan."
        )

    def _answers(self) -> None:
        """Declares what the answer gives: as outputs, or apart where the request has a value of the same name."""
        for declared in self.parse.of_role("output"):
            name = declared.variable.name
            if name in self.asked:
                self.answered[name] = self._declare(f"{name}Answered", declared.variable.type, "local")
            else:
                self.declared.append(declared)
                self.answered[name] = declared.variable

    def _body(self, standard: _Standard, count: Variable, size: Variable, status: Variable) -> tuple[Statement, ...]:
        before = self._declare("xExecuteBefore", BOOL, "local", "so that nothing starts in the first scan", "TRUE")
        received_before = self._declare("xReceivedBefore", BOOL, "local")
        edge, arrived = self._declare("xEdge", BOOL, "local"), self._declare("xArrived", BOOL, "local")
        state, tries = self._declare("iState", INT, "local"), self._declare("iTry", INT, "local")
        reason, timer = self._declare("uiReason", UINT, "local"), self._declare("fbTimeout", TIMER, "local")

        def in_state(which: int) -> Expression:
            return compared(state, "=", number(which))

        def ended(output: Variable, why: Expression | None = None) -> list[Statement]:
            first = [Assignment(standard.error_id, why)] if why is not None else []
            return [
                *first,
                *(Assignment(output, Truth(True)), Assignment(standard.busy, Truth(False))),
                *(Assignment(standard.send, Truth(False)), Assignment(state, number(_IDLE))),
            ]

        def because(key: str) -> Whole:
            return Whole(ERRORS[key][0], UINT)

        def noted(key: str) -> list[Statement]:
            return [Assignment(reason, because(key))]

        def called(routine: Routine, length: Variable, outputs: dict[str, Variable]) -> Assignment:
            names = [declared.variable for declared in routine.declared if declared.role != "local"]
            arguments: dict[str, Expression] = {
                variable.name: outputs.get(variable.name, variable) for variable in names
            }
            return Assignment(status, routine.called(**{**arguments, LENGTH: length}))

        again: list[Statement] = [Assignment(standard.send, Truth(False)), Assignment(state, number(_AGAIN))]
        good = compared(status, "=", self.status.of("ok"))
        refused = compared(status, "=", self.status.of("refused"))
        wrong = compare_answer(self.world, self.link, self.message, self.asked, self.answered)
        differs = wrong["other"]
        branches: list[tuple[Expression, list[Statement]]] = [
            (Negation(either([good, refused])), noted("damaged")),
            *((test, noted("station")) for test in wrong["station"]),
            (refused, ended(standard.error, because("exception"))),
            *([(either(differs), noted("other"))] if differs else []),
        ]
        judged = Condition(tuple((test, tuple(body)) for test, body in branches), tuple(ended(standard.done)))
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
            when(arrived, [called(self.parse, count, self.answered), judged]),
            when(every([in_state(_WAIT), standard.failed]), [Assignment(reason, because("transport")), *again]),
            when(every([in_state(_WAIT), Member(timer, "Q", BOOL)]), again),
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


def compare_answer(
    world: World,
    link: LinkLayout,
    message: MessageLayout,
    asked: Mapping[str, Expression],
    answered: Mapping[str, Expression],
) -> dict[str, list[Expression]]:
    """The tests that find an answer to be of another station, or to another request, by their names in ERRORS.

    Both mappings go by the names of the parameters that build the request and parse the answer. Only an access to
    registers repeats in its answer what was asked: values of the same name, and how many words there are.
    """
    stations = [name for name in _station_names(world, link) if name in asked and name in answered]
    tests: dict[str, list[Expression]] = {
        "station": [compared(answered[name], "<>", asked[name]) for name in stations],
        "other": [],
    }
    access = message.message.accesses
    if access is None:
        return tests
    tests["other"] += [
        compared(answered[name], "<>", variable)
        for name, variable in asked.items()
        if name in answered and name not in stations and isinstance(variable.type, Elementary)
    ]
    if access.count:
        elements = f"{world.variable(access.values, INT)}Count"
        for record, ours, theirs in ((message.request, asked, answered), (message.response, answered, asked)):
            field = record.named(access.count)
            if field is None or field.value is None:
                continue
            kind = world.type_of(field.value)
            words = ours.get(world.variable(access.count, kind))
            if words is not None and elements in theirs and isinstance(kind, Elementary):
                carried: Expression = words
                if world.layout.device.bit_access(message.message) is not None:
                    carried = Operation("/", (Operation("+", (words, Whole(7, kind)), kind), Whole(8, kind)), kind)
                tests["other"].append(compared(converted(theirs[elements], kind), "<>", carried))
    return tests


def _station_names(world: World, link: LinkLayout) -> list[str]:
    """The variables for the station in a response."""
    parts = [part for part in head_members(link.response) if part.role == "unit_address"]
    values = [(part.name, part.value) for part in parts if part.value is not None]
    return [world.variable(name, world.type_of(value)) for name, value in values]
