"""A carrier between a client and a simulated device in memory, in the time of a clock that nobody waits for."""

from __future__ import annotations

from typing import Any

from fieldspec.tools.carriers.carrier import CarrierError
from fieldspec.tools.simulator import codecs
from fieldspec.tools.simulator.clock import ManualClock
from fieldspec.tools.simulator.faults import Faults
from fieldspec.tools.simulator.line import Line
from fieldspec.tools.simulator.server import Answer
from fieldspec.tools.simulator.simulation import usual_place
from simulators import Unit


class Wire:
    """The carrier. `true_answer` is what the device has answered to the last request, before any fault.

    `arrived` is what the client has read since then.
    """

    name = "wire"

    def __init__(self, unit: Unit, faults: Faults, clock: ManualClock, message: str) -> None:
        self.unit, self.faults, self.clock, self.message = unit, faults, clock, message
        self.datagrams = usual_place(unit.codec.link).startswith("udp:")
        self.coming: list[tuple[float, bytes, bool]] = []
        self.true_answer = Answer(b"", "")
        self.arrived = b""
        own = unit.server.answer

        def answer(*arguments: Any) -> Answer:
            self.true_answer = own(*arguments)
            return self.true_answer

        unit.server.answer = answer  # type: ignore[method-assign]
        self.open()

    def open(self) -> None:
        """Connects, again after the connection was lost."""
        module = codecs.device_module(self.unit.engine.layout)

        def framing() -> codecs.Framer | None:
            return None if self.datagrams else codecs.framer(module, self.unit.link, "request")

        self.line = Line(self.unit.server, self.unit.link, framing, self.faults, lambda *event: None, self.message)

    def write(self, data: bytes) -> None:
        self.true_answer = Answer(b"", "")
        self.arrived = b""
        now = self.clock.now()
        sendings = [*self.line.feed(now, data), *self.line.idle(now)]
        self.coming += [(now + sending.seconds, sending.data, sending.hang_up) for sending in sendings]
        self.coming.sort(key=lambda item: item[0])

    def read(self, seconds: float) -> bytes:
        end = self.clock.now() + seconds
        if not self.coming or self.coming[0][0] > end:
            self.clock.sleep(seconds)
            return b""
        at, data, hang_up = self.coming.pop(0)
        self.clock.sleep(at - self.clock.now())
        if hang_up:
            raise CarrierError("the connection was closed")
        self.arrived += data
        return data

    def close(self) -> None:
        self.coming.clear()
