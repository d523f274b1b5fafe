"""Carries out what a generated Python client does, against a model, in a time that nobody waits for.

A client is a generator of actions for its transport: write bytes, read some within a time, sleep, drop what has come.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from typing import Any

from device_models.draws import Draws
from device_models.frames import Line

WRITE, READ, SLEEP, DROP = range(4)
SLICE = 0.05
"""Seconds that a read waits at most, as the time-out of a serial port does."""


class Carrier:
    """The transport of a client and its clock. `at` has what is to happen at a time, by the time.

    A model is given with what answers a frame, so that a drive with telegrams may be carried as well.
    """

    def __init__(self, model: Any, draws: Draws, answer: Callable[[bytes], bytes | None] | None = None) -> None:
        self.model, self.now = model, 0.0
        latency = getattr(model, "latency", (0.001, 0.002))
        foreign = getattr(model, "foreign", lambda frame: frame)
        alike = getattr(model, "alike", lambda first, second: True)
        self.line = Line(draws, answer or model.answer, foreign, alike, latency, 1.0)
        self.coming: list[tuple[float, bytes]] = []
        self.asked: list[str] = []
        self.later: list[tuple[Callable[[], bool], Callable[[], object]]] = []

    def when(self, condition: Callable[[], bool], action: Callable[[], object]) -> None:
        """Lets something happen once, as soon as a condition holds."""
        self.later.append((condition, action))

    def serve(self, client: Any) -> Any:
        """Makes a client use this carrier and its clock, and gives it back."""
        client.session.now = lambda: self.now
        client._run = self.run
        return client

    def run(self, work: Generator[tuple[int, Any], Any, Any]) -> Any:
        """Carries out a generator; raises what it raises."""
        result: Any = None
        while True:
            try:
                action, content = work.send(result)
            except StopIteration as end:
                return end.value
            result = None
            if action == WRITE:
                self._write(bytes(content))
            elif action == READ:
                result = self._read(*content)
            elif action == SLEEP:
                self.pass_time(content)
            else:
                assert action == DROP
                self.coming = [item for item in self.coming if item[0] > self.now]

    def pass_time(self, seconds: float) -> None:
        """Some time goes by."""
        while seconds > 0:
            step = min(seconds, 0.01)
            self.model.pass_time(step)
            self.now += step
            seconds -= step
            due = [entry for entry in self.later if entry[0]()]
            self.later = [entry for entry in self.later if entry not in due]
            for _, action in due:
                action()

    def _write(self, data: bytes) -> None:
        if hasattr(self.model, "foreign"):
            self.asked.append(self.model.meaning(data))
        exchange = self.line.send(data)
        if exchange.answer is not None:
            self.coming.append((self.now + exchange.remaining, exchange.answer))

    def _read(self, size: int, seconds: float) -> bytes:
        end = self.now + min(seconds, SLICE)
        if not self.coming or self.coming[0][0] > end:
            self.pass_time(max(end - self.now, 0.001))
            return b""
        moment, data = self.coming.pop(0)
        self.pass_time(max(moment - self.now, 0.0))
        if data[size:]:
            self.coming.insert(0, (self.now, data[size:]))
        return data[:size]
