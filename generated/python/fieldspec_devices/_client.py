"""The exchange of frames by clients, without any input or output of its own.

A client's work is a generator: it yields transport operations, and receives the bytes that arrived. A client that
blocks and a client for asyncio carry out the same generators.
"""

from __future__ import annotations

from time import monotonic

from ._error import CodecError
from ._frames import ExceptionResponse
from ._typing import TYPE_CHECKING, R, T
from .errors import InvalidValueError, NoAnswerError, RefusedError, TransportError

if TYPE_CHECKING:
    from collections.abc import Callable, Generator, Mapping
    from typing import Any, Final, TypeAlias

    from ._framers import Framer
    from ._frames import RequestOf, Response

    Work: TypeAlias = "Generator[tuple[int, Any], Any, T]"

WRITE, READ, SLEEP, DROP = range(4)
"""The operations that a generator yields: bytes to write, a size to read with the remaining seconds, seconds, nothing.
"""
SILENCE: Final = 0.05
"""The seconds of silence that end a frame whose length nothing determines."""


class Link:
    """The link data of a client: its codec, and the pairing of requests and responses.

    Requests have a unit address where it is `addressed`, and responses too unless `answers_addressed` is false.
    `counters` are the parts of a request that number it, each with its lowest and highest number, and `parts` those
    whose values users choose. `echoes` has the parts of the response that repeat parts of the request; those that
    number it have the same names unless it says otherwise. `timeout` is how long a response may take, `pause` how long
    the line is silent before a request, in seconds. `refusal_code` is the code of all exception responses, None where
    it is that of the request, `refused_code` their field that repeats the code of the request, and `reason` the one
    that says why, empty for the first one. `refusal_part` is the part before the body that says so instead, and
    `refusal_names` its members by their numbers. `repeated` has the fields that a response repeats, each with its name
    there, by the class of the request, and `value_counts` a field of the request and one of the response: the values,
    and how many, or reversed. `unanswered` are the classes of requests without a response. `registers` is the name
    of the link if its messages for registers differ.
    """

    def __init__(
        self,
        codec: Any,
        *,
        addressed: bool,
        answers_addressed: bool = True,
        counters: tuple[tuple[str, int, int], ...] = (),
        parts: tuple[str, ...] = (),
        echoes: dict[str, str] | None = None,
        timeout: float = 1.0,
        pause: float = 0.0,
        refusal_code: int | None = None,
        reason: str = "",
        refusal_part: str = "",
        refused_code: str = "",
        refusal_names: Mapping[int, Any] | None = None,
        repeated: dict[Any, tuple[tuple[str, str], ...]] | None = None,
        value_counts: dict[Any, tuple[str, str]] | None = None,
        unanswered: tuple[type[Any], ...] = (),
        registers: str = "",
    ) -> None:
        self.codec, self.addressed, self.counters, self.parts = codec, addressed, counters, parts
        self.answers_addressed = addressed and answers_addressed
        self.echoes = {name: name for name, _, _ in counters}
        self.echoes.update(echoes or {})
        self.timeout, self.pause = timeout, pause
        self.refusal_code, self.refused_code, self.unanswered = refusal_code, refused_code, unanswered
        self.reason, self.refusal_part, self.refusal_names = reason, refusal_part, refusal_names
        self.repeated, self.value_counts = repeated or {}, value_counts or {}
        self.registers = {"link": registers} if registers else {}

    def chosen_parts(self, parts: Mapping[str, Any]) -> dict[str, Any]:
        """The parts of requests that users choose; None stands for no choice. Raises ValueError."""
        chosen = {name: value for name, value in parts.items() if value is not None}
        for name in chosen:
            if name not in self.parts:
                raise ValueError(f"requests on this link have no part {name}")
        for name in self.parts:
            if name not in chosen:
                raise ValueError(f"requests on this link have a part {name}, which needs a value: add its keyword")
        return chosen

    def is_answer(self, reply: Any, request: Any, unit_address: int, head: dict[str, Any]) -> bool:
        """Whether a frame from the device answers a request."""
        if self.answers_addressed and reply.unit_address != unit_address:
            return False
        if any(getattr(reply, echo) != head[name] for name, echo in self.echoes.items()):
            return False
        if isinstance(reply, ExceptionResponse):
            if self.refused_code and getattr(reply.exception, self.refused_code) != request.CODE:
                return False
            return bool(reply.code == (_response_code(request) if self.refusal_code is None else self.refusal_code))
        kind = request.__class__
        for request_name, response_name in self.repeated.get(kind, ()):
            if getattr(reply.message, response_name) != getattr(request, request_name):
                return False
        counts = self.value_counts.get(kind)
        if counts is None:
            return True
        values = (getattr(request, counts[0]), getattr(reply.message, counts[1]))
        return len({value if isinstance(value, int) else len(value) for value in values}) == 1


def _response_code(request: Any) -> int | None:
    """The code of the response to a request; that of the request where the device never answers it."""
    code: int | None = getattr(request, "_RESPONSE", request).CODE
    return code


class Session:
    """The conversation with one unit on one link, as generators. It is not for several threads at once.

    `settle` and `begin` are the seconds until a device shows the requested state, and begins a motion. `parts` has the
    parts of requests that users choose. Raises ValueError for those that the link does not have, or that lack.
    """

    def __init__(
        self,
        link: Link,
        unit_address: int,
        datagrams: bool,
        *,
        timeout: float | None,
        pause: float | None,
        retries: int,
        settle: float,
        begin: float = 2.0,
        parts: Mapping[str, Any] | None = None,
    ) -> None:
        self.link, self.unit_address, self.retries = link, unit_address, retries
        self.settle, self.begin, self.datagrams = settle, begin, datagrams
        self.timeout = link.timeout if timeout is None else timeout
        self.pause = link.pause if pause is None else pause
        self.now: Callable[[], float] = monotonic
        make = None if datagrams else getattr(link.codec, "response_framer", None)
        self._framer: Framer | None = make() if make is not None else None
        self._head = link.chosen_parts(parts or {}) | {name: high for name, _, high in link.counters}
        self._silent_until = self._owed_until = 0.0
        self._owed = 0
        self._owed_request: Any = None

    def ask(self, request: RequestOf[R], retries: int | None = None) -> Work[Any]:
        """The response to a request, which is sent again where no answer comes, `retries` times.

        Raises InvalidValueError, NoAnswerError, RefusedError and TransportError.
        """
        if request.__class__ in self.link.unanswered:
            raise InvalidValueError(f"{request.__class__.__name__} has no response on this link: use `send`")
        retries_left = self.retries if retries is None else retries
        while True:
            try:
                return (yield from self._exchanged(request))
            except NoAnswerError:
                if retries_left <= 0:
                    raise
            retries_left -= 1

    def send(self, request: Any, unit_address: int | None = None) -> Work[None]:
        """Sends a request without a response. Raises InvalidValueError and TransportError."""
        frame = self._frame(request, self.unit_address if unit_address is None else unit_address)
        yield from self._ready()
        yield WRITE, frame
        self._silent_until = self.now() + self.pause

    def _frame(self, request: Any, unit_address: int) -> bytes:
        link, head = self.link, self._head
        for name, low, high in link.counters:
            head[name] = head[name] + 1 if head[name] < high else low
        try:
            if link.addressed:
                frame: bytes = link.codec.encode_request(unit_address, request, **head)
            else:
                frame = link.codec.encode_request(request, **head)
        except CodecError as error:
            raise InvalidValueError(str(error)) from error
        except AttributeError as error:
            links = [name[4:] for name in dir(request) if name.startswith("_to_")]
            if error.obj is not request or not links:
                raise
            text = f"{request.__class__.__name__} is not sent on this link, but on {', '.join(links)}"
            raise InvalidValueError(text) from error
        return frame

    def _ready(self, request: Any = None) -> Work[None]:
        """Waits until the line may be used, and drops what an earlier request has left on it."""
        left = self._silent_until - self.now()
        if left > 0:
            yield SLEEP, left
        if self._owed and request is not self._owed_request:
            yield from self._late_answers()
        yield DROP, None

    def _late_answers(self) -> Work[None]:
        """Waits for outstanding responses, so that none is mistaken for the next one."""
        framer, received = self._framer, b""
        while self._owed > 0 and (left := self._owed_until - self.now()) > 0:
            data = yield READ, (65536 if framer is None else framer.missing, left)
            received = data if self.datagrams else received + data
            for frame in [received] if framer is None else framer.feed(data):
                self._owed -= self._answer(frame, self._owed_request) is not None
        self._owed = 0

    def _exchanged(self, request: RequestOf[R]) -> Work[Any]:
        frame = self._frame(request, self.unit_address)
        yield from self._ready(request)
        framer = self._framer
        if framer is not None:
            framer.reset()
        yield WRITE, frame
        received = b""
        is_new = False
        heard = self.now()
        deadline = heard + self.timeout
        if not self.link.counters:
            self._owed, self._owed_request, self._owed_until = self._owed + 1, request, deadline
        while (left := deadline - self.now()) > 0:
            wait = left if framer is None or not is_new else min(left, SILENCE)
            data = yield READ, (65536 if framer is None else framer.missing, wait)
            if data:
                received = data if self.datagrams else received + data
                heard, is_new = self.now(), True
                answers = [received] if framer is None else framer.feed(data)
            elif framer is not None and is_new and self.now() - heard >= SILENCE and framer.ends_with_silence:
                # Nothing drops: the rest of a frame that has begun may still come.
                answers, is_new = framer.pause(), False
            else:
                continue
            reply = self._answer_among(answers, request)
            if reply is not None:
                return reply
        # Garbage may have looked like the beginning of a longer frame, and the answer like the rest of it.
        reply = self._answer_among(framer.pause() if framer is not None and is_new else [], request)
        if reply is not None:
            return reply
        self._owed_until = deadline + self.timeout
        self._silent_until = self.now() + self.pause
        raise NoAnswerError("bytes came, but no answer" if received else "no answer")

    def _answer_among(self, frames: list[bytes], request: RequestOf[R]) -> Response[R] | None:
        """The response among some frames; None for none. Raises RefusedError for an exception response."""
        for frame in frames:
            reply = self._answer(frame, request)
            if reply is None:
                continue
            self._owed -= self._owed > 0
            self._silent_until = self.now() + self.pause
            if isinstance(reply, ExceptionResponse):
                raise refusal(reply, self.link)
            return reply
        return None

    def _answer(self, frame: bytes, request: RequestOf[R]) -> Response[R] | ExceptionResponse[Any] | None:
        """The response in a frame; None for a frame that answers something else."""
        try:
            reply: Response[R] | ExceptionResponse[Any] = self.link.codec.decode_response(frame, request)
        except CodecError:
            return None
        return reply if self.link.is_answer(reply, request, self.unit_address, self._head) else None


def refusal(reply: ExceptionResponse[Any], link: Link) -> RefusedError:
    """The error for an exception response: a part or a field of it has its number, or else its first field."""
    exception = reply.exception
    names = (link.reason,) if link.reason else exception.__match_args__
    first = getattr(exception, names[0]) if names else 0
    if link.refusal_part:
        first = getattr(reply, link.refusal_part)
        first = link.refusal_names.get(first, first) if link.refusal_names else getattr(first, "raw", first)
    name = getattr(first, "name", "")
    text = f"the device refuses the request: exception {int(first)}" + (f", {name.lower()}" if name else "")
    return RefusedError(text, int(first), exception)


def drop_input(transport: Any) -> None:
    """Drops what a transport has received, if it keeps anything. Raises TransportError."""
    drop = getattr(transport, "reset_input_buffer", None)
    try:
        if drop is not None:
            drop()
    except (OSError, EOFError) as error:
        raise TransportError(str(error)) from error


def link_named(links: Mapping[str, Link], name: str) -> Link:
    """The link of a client with a name. Raises ValueError."""
    if name not in links:
        raise ValueError(f"there is no link {name!r}; known are {', '.join(links)}")
    return links[name]
