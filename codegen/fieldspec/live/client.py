"""Requests to a device and their responses, over any carrier."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from fieldspec.carriers.carrier import Carrier
from fieldspec.classes import TYPE_CHECKING, dataclass
from fieldspec.layout.device import DeviceLayout
from fieldspec.reference.frames import Decoded, codec
from fieldspec.reference.records import CodecError
from fieldspec.simulator import codecs
from fieldspec.simulator.clock import Clock, SystemClock

if TYPE_CHECKING:
    from typing import Any


class NoAnswerError(Exception):
    """The device has not answered, or not with a frame that answers the request. The message says which."""


class RefusedError(Exception):
    """The device has refused a request. `number` is that of the exception, `name` its name in the spec, or empty."""

    def __init__(self, number: int, name: str) -> None:
        super().__init__(f"exception {number}" + (f", {name}" if name else ""))
        self.number, self.name = number, name


@dataclass(frozen=True, slots=True)
class Timing:
    """The seconds of an exchange: how long a response may take, and how long the line is silent before a request."""

    timeout: float = 1.0
    pause: float = 0.0
    retries: int = 2


Trace = Callable[[str, bytes], None]
"""Called with `request` or `response` and the bytes."""


class Client:
    """Exchanges frames with one unit on one link. It is not for several threads at once."""

    def __init__(
        self,
        layout: DeviceLayout,
        link: str,
        carrier: Carrier,
        unit_address: int,
        timing: Timing | None = None,
        clock: Clock | None = None,
        trace: Trace | None = None,
    ) -> None:
        self.layout, self.carrier, self.unit_address = layout, carrier, unit_address
        self.timing, self.clock = timing or Timing(), clock or SystemClock()
        self.trace = trace
        self.frames = codec(layout).links[link]
        self.framer = codecs.framer(codecs.device_module(layout), link, "response")
        addressed = self.frames.link.request.role("unit_address")
        self.head = {addressed.name: unit_address} if addressed is not None else {}
        self.counters = [part for part in self.frames.link.request.header if part.role == "plain" and part.is_argument]

    def request(self, message: str, values: Mapping[str, Any]) -> bytes:
        """The frame of a request. Parts that only mark it have another number in each. Raises CodecError."""
        for part in self.counters:
            most = part.value.type.high if part.value is not None else 0xFF
            self.head[part.name] = self.head.get(part.name, 0) % most + 1
        return self.frames.encode("request", message, {**self.head, **values})

    def is_answered(self, message: str) -> bool:
        """Whether the device answers a message on this link."""
        return message in self.frames.link.carried("response")

    def send(self, message: str, values: Mapping[str, Any]) -> None:
        """Sends a request that the device does not answer. Raises CodecError and CarrierError."""
        frame = self.request(message, values)
        self._drain()
        self._write(frame)

    def ask(self, message: str, values: Mapping[str, Any], retries: int | None = None) -> Decoded:
        """The response to a request.

        Raises NoAnswerError where the last of all tries has failed, RefusedError, CodecError for values that no
        request can carry, and CarrierError.
        """
        frame = self.request(message, values)
        left = self.timing.retries if retries is None else retries
        try:
            return self._answer(message, frame)
        except NoAnswerError:
            if left <= 0:
                raise
        return self.ask(message, values, left - 1)

    def _answer(self, message: str, frame: bytes) -> Decoded:
        self._drain()
        self._write(frame)
        deadline = self.clock.now() + self.timing.timeout
        if self.framer is not None:
            self.framer.reset()
        received = 0
        while (left := deadline - self.clock.now()) > 0:
            data = self.carrier.read(left)
            received += len(data)
            framed = not self.carrier.datagrams and self.framer is not None
            for answer in self.framer.feed(data) if framed and self.framer is not None else [data] if data else []:
                if self.trace is not None:
                    self.trace("response", answer)
                decoded = self._decoded(message, answer)
                if decoded is not None:
                    return decoded
        raise NoAnswerError(f"{received} bytes came, and no answer" if received else "no answer")

    def _write(self, frame: bytes) -> None:
        self.clock.sleep(self.timing.pause)
        if self.trace is not None:
            self.trace("request", frame)
        self.carrier.write(frame)

    def _drain(self) -> None:
        """Drops what an earlier request has left on the line."""
        while self.carrier.read(0.0005):
            pass

    def _decoded(self, message: str, frame: bytes) -> Decoded | None:
        """The meaning of a response to a message; None for a frame of another unit or message. Raises RefusedError."""
        try:
            decoded = self.frames.decode(frame, "response", message)
        except CodecError:
            return None
        if any(decoded.head.get(name) != number for name, number in self.head.items() if name in decoded.head):
            return None
        if decoded.message is not None and decoded.message.name != message:
            return None
        if decoded.error:
            raise self._refusal(decoded)
        return decoded

    def _refusal(self, decoded: Decoded) -> RefusedError:
        mark = self.frames.link.link.exception_response
        if mark is not None and mark.part:
            number = int(decoded.head[mark.part])
            part = next(part for part in self.frames.link.response.header if part.name == mark.part)
            enum = self.layout.device.enums.get(part.value.enum) if part.value is not None else None
            member = enum.member(number) if enum is not None else None
            return RefusedError(number, member.name if member is not None else "")
        for field in decoded.body.fields if decoded.body is not None else ():
            if field.value is not None and field.value.const is None:
                number = int(decoded.values[field.name])
                member = self.layout.device.enums[field.value.enum].member(number) if field.value.enum else None
                return RefusedError(number, member.name if member is not None else "")
        return RefusedError(0, "")
