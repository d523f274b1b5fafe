"""Blocks that carry the accesses to registers of one device as frames of a link, with a repetition where it is safe."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.language.model.record import RegisterAccess
from fieldspec.targets.controllers.routines.answers import judged
from fieldspec.targets.controllers.routines.blocks.frames import Exchange, exchange_of
from fieldspec.targets.controllers.routines.blocks.ports import (
    ABANDONED,
    ANSWERED,
    ASKED,
    AXIS,
    FRAMES,
    FREE,
    POSTPONED,
    PRESSING,
    URGENT,
    increment,
    member,
)
from fieldspec.targets.controllers.routines.blocks.standard import ERRORS, chain, meanings
from fieldspec.targets.controllers.routines.parameters import FRAME, parameters_of
from fieldspec.targets.controllers.routines.records import is_user_field
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.routines.wrapping import LENGTH, link_words
from fieldspec.targets.controllers.statements.expressions import (
    INT,
    UDINT,
    UINT,
    Element,
    Elementary,
    Expression,
    Negation,
    StructType,
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
from fieldspec.targets.controllers.statements.expressions import WORD as WORD_TYPE
from fieldspec.targets.controllers.statements.routine import Assignment, Loop, Routine, Statement, Variables, when

_IDLE, _ASK, _WAIT, _ANSWER = range(4)


def client_block(world: World, link: LinkLayout, by_name: Mapping[str, Routine]) -> Routine | None:
    """The block that serves the port of a device by a link; None where the link does not read and write registers."""
    reading: Exchange | None = None
    single: Exchange | None = None
    multiple: Exchange | None = None
    device = world.layout.device
    for message in link.exchanged.values():
        access = device.word_access(message.message)
        if access is None or device.space_name(access.space) != device.space_name(""):
            continue
        exchange = exchange_of(world, link, message, by_name)
        if not _usable(world, exchange, access):
            continue
        if access.operation == "read":
            reading = reading or (exchange if access.count else None)
        elif access.count:
            multiple = multiple or exchange
        else:
            single = single or exchange
    if reading is None or (single is None and multiple is None):
        return None
    return _Client(world, link, reading, single, multiple).block()


def _usable(world: World, exchange: Exchange, access: RegisterAccess) -> bool:
    """Whether a request has no fields but the station, the address, the number and the words."""
    fields = {field.name for field in exchange.message.request.fields if is_user_field(field)}
    return fields <= {access.start, access.count, access.values}


class _Client:
    """Makes the block that serves the port of a device by a link."""

    def __init__(
        self, world: World, link: LinkLayout, reading: Exchange, single: Exchange | None, multiple: Exchange | None
    ) -> None:
        self.world, self.link = world, link
        self.exchanges = {"reading": reading, "single": single, "several": multiple}
        self.variables = Variables()
        self.axis = self._struct(AXIS, "axis")
        self.frames = self._struct(FRAMES, "frames")
        self.result = self._declare("eStatus", world.status.type, "output", "what the last function has returned")
        self.reason = self._declare("uiReason", UINT, "local")
        self.words = self._declare("aWordsAnswered", world.words, "local", "given to the axis once they are its own")
        self.taken, self.request = (
            self._declare("udiTaken", UDINT, "local"),
            self._declare("udiRequest", UDINT, "local"),
        )

    def _declare(self, name: str, kind: Type, role: str, remark: str = "", initial: str = "") -> Variable:
        return self.variables.declare(name, kind, role, remark, initial)

    def _struct(self, key: str, name: str) -> Variable:
        kind = StructType(self.world.names.structs[key])
        return self._declare(self.world.variable(name, kind), kind, "in_out")

    def _of_axis(self, name: str) -> Expression:
        return member(self.world, AXIS, name, self.axis)

    def _of_frames(self, name: str) -> Expression:
        return member(self.world, FRAMES, name, self.frames)

    def block(self) -> Routine:
        """The block: its variables, its statements and its remarks."""
        world = self.world
        retries = self._declare("iRetries", INT, "input", "how often reading is tried again; writing never is", "2")
        step, tries = self._declare("iStep", INT, "local"), self._declare("iTry", INT, "local")
        axis_state, state = self._of_axis("state"), self._of_frames("state")
        urgent, busy = self._of_axis("urgent"), self._of_frames("urgent")
        own = compared(self._of_axis("request"), "=", self.taken)
        waited = every([compared(axis_state, "=", number(ASKED)), own])

        def go(to: int) -> Statement:
            return Assignment(step, number(to))

        kinds = [(name, exchange) for name, exchange in self.exchanges.items() if exchange is not None]
        count = self._of_axis("count")
        tests: dict[str, Expression] = {"reading": Negation(self._of_axis("write"))}
        if self.exchanges["single"] is not None:
            tests["single"] = compared(count, "=", number(1))
        builds: list[tuple[Expression, Sequence[Statement]]] = []
        parses: list[tuple[Expression, Sequence[Statement]]] = []
        last_build: Sequence[Statement] = [self._fail("request")]
        last_parse: Sequence[Statement] = ()
        for name, exchange in kinds:
            built, parsed = self._built(exchange), self._parsed(exchange)
            if name in tests:
                builds.append((tests[name], built))
                parses.append((tests[name], parsed))
            else:
                last_build, last_parse = built, parsed
        no_reason = Assignment(self.reason, Whole(0, UINT))
        none = compared(self.reason, "=", Whole(0, UINT))
        request = self._of_frames("request")
        goes_first = when(compared(urgent, ">", number(PRESSING)), [Assignment(self._of_frames("first"), request)])
        send_request = [increment(request), Assignment(self.request, request), goes_first]
        send_request += [Assignment(state, number(ASKED)), go(_WAIT)]
        room = world.words.high + 1
        wrong_count = either([compared(count, "<", number(1)), compared(count, ">", number(room))])
        asking: list[Statement] = [
            no_reason,
            chain([(wrong_count, [self._fail("request")]), *builds], last_build),
            when(none, send_request, [go(_ANSWER)]),
        ]
        error = self._of_frames("error")
        waiting: list[Statement] = [
            Assignment(state, number(FREE)),
            chain(
                [
                    (compared(self._of_frames("answered"), "<>", self.request), [self._fail("other")]),
                    (compared(error, "<>", Whole(0, UINT)), [Assignment(self.reason, error)]),
                    (waited, [chain(parses, last_parse)]),
                ]
            ),
            go(_ANSWER),
            when(
                every(
                    [
                        compared(self.reason, "<>", Whole(0, UINT)),
                        compared(self.reason, "<>", Whole(ERRORS["exception"][0], UINT)),
                        Negation(self._of_axis("write")),
                        waited,
                        compared(tries, "<", retries),
                        compared(urgent, "=", number(0)),
                    ]
                ),
                [Assignment(tries, plus(tries, 1)), go(_ASK)],
            ),
        ]
        index = self._declare("iAt", INT, "local")
        word = Assignment(*(Element(words, index, WORD_TYPE) for words in (self._of_axis("words"), self.words)))
        passed_on = when(
            every([none, Negation(self._of_axis("write"))]), [Loop(index, number(0), plus(count, -1), (word,))]
        )
        answering: list[Statement] = [
            chain(
                [
                    (
                        waited,
                        [
                            *(passed_on, Assignment(self._of_axis("error"), self.reason)),
                            Assignment(self._of_axis("answered"), self.taken),
                            Assignment(axis_state, number(ANSWERED)),
                        ],
                    ),
                    (compared(axis_state, "=", number(ABANDONED)), [Assignment(axis_state, number(FREE))]),
                ]
            ),
            go(_IDLE),
        ]
        begin = [Assignment(self.taken, self._of_axis("request")), Assignment(tries, number(0)), go(_ASK)]
        may_send = either([compared(busy, "=", number(0)), compared(urgent, ">", number(0))])
        waits = every([compared(urgent, ">", number(0)), compared(step, "=", number(_ASK))])
        unsent = either([compared(step, "=", number(_IDLE)), compared(step, "=", number(_ASK))])
        other = compared(self._of_axis("first"), "<>", self._of_axis("request"))
        gives_way = every(
            [compared(urgent, ">", number(PRESSING)), compared(axis_state, "=", number(ASKED)), other, unsent]
        )
        postponed = [
            Assignment(self._of_axis("error"), Whole(POSTPONED, UINT)),
            Assignment(self._of_axis("answered"), self._of_axis("request")),
            Assignment(axis_state, number(ANSWERED)),
            go(_IDLE),
        ]
        body: list[Statement] = [
            when(gives_way, postponed),
            when(
                compared(step, "=", number(_IDLE)),
                [
                    chain(
                        [
                            (compared(axis_state, "=", number(ASKED)), begin),
                            (compared(axis_state, "=", number(ABANDONED)), [Assignment(axis_state, number(FREE))]),
                        ]
                    )
                ],
            ),
            chain(
                [
                    (every([compared(step, "=", number(_ASK)), Negation(waited)]), [go(_ANSWER)]),
                    (every([compared(step, "=", number(_ASK)), compared(state, "=", number(FREE)), may_send]), asking),
                    (every([compared(step, "=", number(_WAIT)), compared(state, "=", number(ANSWERED))]), waiting),
                ]
            ),
            when(compared(step, "=", number(_ANSWER)), answering),
            when(waits, [Assignment(busy, number(URGENT))]),
            when(compared(urgent, ">", number(0)), [Assignment(urgent, plus(urgent, -1))]),
        ]
        name = world.block(*link_words(world, self.link), "client")
        remarks = (
            f"Carries the accesses to the registers of one device as frames of {self.link.name}. Call it in each scan, "
            "behind the blocks of the device and before the block that sends and receives its frames.",
            "Several devices may share the frames of one line. A request to write is sent once, fail a device may "
            "have carried it out although its answer is lost.",
            meanings(ERRORS),
        )
        return Routine(
            name, f"messages of {self.link.name}", None, self.variables.needed(tuple(body)), tuple(body), remarks
        )

    def _fail(self, reason: str) -> Statement:
        return Assignment(self.reason, Whole(ERRORS[reason][0], UINT))

    def _arguments(self, exchange: Exchange) -> dict[str, Expression]:
        """The arguments of the function that builds a request."""
        access = exchange.message.message.accesses
        assert access is not None
        words, count = self._of_axis("words"), self._of_axis("count")
        asks, _ = parameters_of(self.world, exchange.link, exchange.message)
        arguments: dict[str, Expression] = {}
        remarks = {declared.variable.name: declared.remark for declared in exchange.build.declared}
        for variable in asks.head.values():
            name, remark = variable.name, remarks[variable.name]
            arguments[name] = self.variables.declared_once(name, variable.type, "input", remark)
        by_name = {access.start: self._of_axis("address"), access.count: count}
        for field, variable in asks.fields.variables.items():
            if field != access.values:
                arguments[variable.name] = _converted(by_name[field], variable.type)
            elif variable.type == self.world.words:
                arguments[variable.name] = words
            else:
                arguments[variable.name] = _converted(Element(words, number(0), WORD_TYPE), variable.type)
        if asks.fields.count is not None:
            arguments[asks.fields.count.name] = count
        return arguments

    def _built(self, exchange: Exchange) -> list[Statement]:
        lent = {FRAME: self._of_frames("frame"), LENGTH: self._of_frames("send")}
        return [
            Assignment(self.result, exchange.build.called(**{**self._arguments(exchange), **lent})),
            when(compared(self.result, "<>", self.world.status.of("ok")), [self._fail("request")]),
        ]

    def _parsed(self, exchange: Exchange) -> list[Statement]:
        response_values: dict[str, Expression] = {}
        for declared in (*exchange.parse.of_role("output"), *exchange.parse.of_role("in_out")):
            variable = declared.variable
            if variable.type == self.world.words:
                response_values[variable.name] = self.words
            elif variable.name != FRAME:
                response_values[variable.name] = self.variables.local(f"{variable.name}Answered", variable.type)
        lent = {FRAME: self._of_frames("frame"), LENGTH: self._of_frames("received")}
        judgement = judged(
            self.world,
            exchange.link,
            exchange.message,
            self.result,
            self._arguments(exchange),
            response_values,
            self.variables,
            lambda reason: [self._fail(reason)],
            (),
        )
        return [Assignment(self.result, exchange.parse.called(**{**response_values, **lent})), *judgement]


def _converted(value: Expression, kind: Type) -> Expression:
    assert isinstance(kind, Elementary)
    return converted(value, kind)


def client_blocks(world: World, by_name: Mapping[str, Routine], links: Sequence[LinkLayout]) -> Iterator[Routine]:
    """The blocks of all links that read and write registers."""
    for link in links:
        block = client_block(world, link, by_name)
        if block is not None:
            yield block
