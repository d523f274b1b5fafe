"""Requests to a device and their responses, over any carrier."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.exception_mark import reason_field
from fieldspec.codec.layout.open_parts import open_parts
from fieldspec.codec.layout.repeated_parts import repeated_fields
from fieldspec.codec.reference.frames import Decoded, codec
from fieldspec.codec.reference.records import CodecError
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.model.enums import Member
from fieldspec.tools.carriers.carrier import Carrier
from fieldspec.tools.simulator import codecs
from fieldspec.tools.simulator.clock import Clock, SystemClock

if TYPE_CHECKING:
    from typing import Any


class UnfitAnswerError(Exception):
    """A response whose bytes are not a value of the requested parameter."""


class NoAnswerError(Exception):
    """The device has not answered, or not with a frame that answers the request. The message says which."""


class RefusedError(Exception):
    """The device has refused a request. `number` is that of the exception, `name` its name in the spec, or empty.

    An exception with a number that the spec does not list proves nothing: the device may have carried out the request,
    or a part of it, before it failed.
    """

    def __init__(self, number: int, name: str, is_known: bool = True) -> None:
        super().__init__(f"exception {number}" + (f", {name}" if name else ""))
        self.number, self.name, self.is_known = number, name, is_known


@dataclass(frozen=True, slots=True)
class Timing:
    """The seconds of an exchange: how long a response may take, and how long the line is silent before a request.

    `retries` says how often a request is sent again where no answer comes.
    """

    timeout: float = 1.0
    pause: float = 0.0
    retries: int = 2


_SILENCE = 0.1
"""The seconds without a byte that end a frame whose length nothing determines; adapters pause for up to 0.02."""

Trace = Callable[[str, bytes], None]
"""Called with `request` or `response` and the bytes."""


@dataclass(frozen=True, slots=True)
class _Request:
    """A request that is asked, perhaps several times."""

    message: str
    values: Mapping[str, Any]


class Client:
    """Exchanges frames with one unit on one link. It is not for several threads at once.

    A response that arrives after its request was given up is not mistaken for the next response: this waits until all
    late answers have come, or can no longer come within another time-out. Requests whose frames have a number that the
    response repeats need not wait. `fixed` has raw values by the names of fields and of parts before the body: a
    request with such a field carries them, unless it has a value of its own.
    """

    def __init__(
        self,
        layout: DeviceLayout,
        link: str,
        carrier: Carrier,
        unit_address: int,
        timing: Timing | None = None,
        clock: Clock | None = None,
        trace: Trace | None = None,
        fixed: Mapping[str, Any] | None = None,
    ) -> None:
        self.fixed = fixed or {}
        self.layout, self.unit_address = layout, unit_address
        self.timing, self.clock = timing or Timing(), clock or SystemClock()
        self.trace = trace
        self.frames = codec(layout).links[link]
        self.framer = codecs.framer(codecs.device_module(layout), link, "response")
        addressed = self.frames.link.request.role("unit_address")
        self.head = {addressed.name: unit_address} if addressed is not None else {}
        parts = open_parts(self.frames.link)
        self.head.update((part.part.name, self.fixed[part.part.name]) for part in parts if part.part.name in self.fixed)
        self.counters = [part for part in parts if part.numbering is not None]
        self.echoes = {part.part.name: part.repeated.name for part in parts if part.repeated is not None}
        answering = self.frames.link.response.role("unit_address")
        if addressed is not None and answering is not None:
            self.echoes[addressed.name] = answering.name
        self._owed = 0
        self._owed_until = 0.0
        self._owed_request: _Request | None = None
        self.connect(carrier)

    def connect(self, carrier: Carrier) -> None:
        """Talks over a carrier from now on, after the pause."""
        self.carrier = carrier
        self._silent_until = self.clock.now() + self.timing.pause

    def request(self, message: str, values: Mapping[str, Any]) -> bytes:
        """The frame of a request. Parts that only mark it have a different number in each. Raises CodecError."""
        fields = self.layout.messages[message].request
        fixed = {name: raw for name, raw in self.fixed.items() if fields.named(name) is not None}
        for part in self.counters:
            assert part.numbering is not None
            low, high = part.numbering
            last = self.head.get(part.part.name)
            self.head[part.part.name] = max(low, min(1, high)) if last is None or last >= high else last + 1
        return self.frames.encode("request", message, {**self.head, **fixed, **values})

    def is_answered(self, message: str) -> bool:
        """Whether the device answers a message on this link."""
        return message in self.frames.link.carried("response")

    def send(self, message: str, values: Mapping[str, Any]) -> None:
        """Sends a request that the device does not answer. Raises CodecError and CarrierError."""
        frame = self.request(message, values)
        self._prepare(None)
        self._write(frame)
        self._silent_until = self.clock.now() + self.timing.pause

    def ask(self, message: str, values: Mapping[str, Any], retries: int | None = None) -> Decoded:
        """The response to a request.

        Raises NoAnswerError where the last of all tries has failed, RefusedError, CodecError for values that no
        request can carry, and CarrierError.
        """
        request = _Request(message, values)
        left = self.timing.retries if retries is None else retries
        while True:
            try:
                return self._answer(request, self.request(message, values))
            except NoAnswerError:
                if left <= 0:
                    raise
            left -= 1

    def _answer(self, request: _Request, frame: bytes) -> Decoded:
        self._prepare(request)
        if self.framer is not None:
            self.framer.reset()
        self._write(frame)
        deadline = self.clock.now() + self.timing.timeout
        if not self.counters:
            self._owed, self._owed_request, self._owed_until = self._owed + 1, request, deadline
        received = 0
        is_new = False
        try:
            while (left := deadline - self.clock.now()) > 0:
                data = self.carrier.read(min(left, _SILENCE) if is_new else left)
                received += len(data)
                if data:
                    is_new = True
                    decoded = next(self._answers(request, data), None)
                elif is_new and self.framer is not None and self.framer.ends_with_silence:
                    is_new = False
                    decoded = next(self._answers_before_silence(request), None)
                else:
                    continue
                if decoded is not None:
                    return self._accepted(decoded)
            decoded = next(self._answers_before_silence(request), None) if is_new else None
            if decoded is not None:
                return self._accepted(decoded)
        finally:
            self._silent_until = self.clock.now() + self.timing.pause
        self._owed_until = deadline + self.timing.timeout
        raise NoAnswerError(f"{received} bytes came, and no answer" if received else "no answer")

    def _accepted(self, decoded: Decoded) -> Decoded:
        """An answer that is not an exception response. Raises RefusedError."""
        self._owed -= self._owed > 0
        if decoded.error:
            raise self._refusal(decoded)
        return decoded

    def _answers(self, request: _Request, data: bytes) -> Iterator[Decoded]:
        """The answers to a request that some bytes complete, refusals among them."""
        framer = None if self.carrier.datagrams else self.framer
        for frame in [data] if framer is None and data else framer.feed(data) if framer is not None else ():
            yield from self._decoded_answers(request, frame)

    def _answers_before_silence(self, request: _Request) -> Iterator[Decoded]:
        """The answers in the bytes so far, of which nothing drops: the rest of a frame may still come."""
        for frame in self.framer.pause() if self.framer is not None and not self.carrier.datagrams else ():
            yield from self._decoded_answers(request, frame)

    def _decoded_answers(self, request: _Request, frame: bytes) -> Iterator[Decoded]:
        if self.trace is not None:
            self.trace("response", frame)
        decoded = self._decoded(request, frame)
        if decoded is not None:
            yield decoded

    def _prepare(self, request: _Request | None) -> None:
        """Waits until the line may be used, and drops what earlier requests have left on it."""
        if self._owed and request is not self._owed_request:
            self._take_late_answers()
        until = self.clock.now() + self.timing.timeout
        while self.carrier.read(0.0005) and self.clock.now() < until:
            pass  # on a bus, others go on talking
        self.clock.sleep(self._silent_until - self.clock.now())

    def _take_late_answers(self) -> None:
        """Waits for outstanding responses, so that none is mistaken for the response to the next request."""
        assert self._owed_request is not None
        while self._owed > 0 and (left := self._owed_until - self.clock.now()) > 0:
            for _ in self._answers(self._owed_request, self.carrier.read(left)):
                self._owed -= 1
                self._silent_until = self.clock.now() + self.timing.pause
        self._owed = 0

    def _write(self, frame: bytes) -> None:
        if self.trace is not None:
            self.trace("request", frame)
        self.carrier.write(frame)

    def _decoded(self, request: _Request, frame: bytes) -> Decoded | None:
        """The meaning of a response to a request; None for a frame that answers something else."""
        try:
            decoded = self.frames.decode(frame, "response", request.message)
        except CodecError:
            return None
        for name, echo in self.echoes.items():
            if echo in decoded.head and decoded.head[echo] != self.head.get(name):
                return None
        if decoded.message is not None and decoded.message.name != request.message:
            return None
        fits = self._refuses(request, decoded) if decoded.error else self._fits(request, decoded)
        return decoded if fits else None

    def _refuses(self, request: _Request, decoded: Decoded) -> bool:
        """Whether an exception response belongs to the request: by its code, and by the values that it repeats."""
        link, message = self.frames.link, self.layout.messages[request.message].message
        mark, coded, response_code = link.link.exception_response, link.request.role("code"), link.response.role("code")
        is_own = mark is not None and mark.code is not None  # then it is the code of all exception responses
        if response_code is not None and not is_own and decoded.head[response_code.name] != message.code_of("response"):
            return False
        fields = decoded.body.fields if decoded.body is not None and coded is not None else ()
        repeated = [field.name for field in fields if coded is not None and field.field.same_as == coded.name]
        return all(decoded.values.get(name) == message.code for name in repeated)

    def _fits(self, request: _Request, decoded: Decoded) -> bool:
        """Whether a response belongs to the request: it repeats the right values, and has the right number of words."""
        layout = self.layout.messages[request.message]
        message, access = layout.message, layout.message.single_access
        for own, other in repeated_fields(layout):
            value = request.values.get(own.name)
            if isinstance(value, float) and access is not None:
                continue  # what a register holds of it is rounded
            if own.name in request.values and decoded.values.get(other.name) != value:
                return False
        if access is None or self.layout.device.bit_access(message) is not None:
            return True
        count_values, received = request.values, decoded.values
        if access.operation == "write":
            count_values, received = received, count_values
        content, count = received.get(access.values), count_values.get(access.count)
        return not isinstance(content, list) or count is None or len(content) == count

    def _refusal(self, decoded: Decoded) -> RefusedError:
        mark = self.frames.link.link.exception_response
        if mark is not None and mark.part:
            number = int(decoded.head[mark.part])
            part = next(part for part in self.frames.link.response.header if part.name == mark.part)
            enum = self.layout.device.enums.get(part.value.enum) if part.value is not None else None
            member = enum.member(number) if enum is not None else None
            return _refused_with(number, member)
        field = reason_field(decoded.body) if decoded.body is not None else None
        if field is None or field.value is None:
            return RefusedError(0, "")
        number = int(decoded.values[field.name])
        member = self.layout.device.enums[field.value.enum].member(number) if field.value.enum else None
        return _refused_with(number, member)


def _refused_with(number: int, member: Member | None) -> RefusedError:
    """The error for an exception, which is listed if it has a member."""
    return RefusedError(number, "" if member is None else member.name, member is not None)
