"""Cyclic messages of clients, such as telegrams: the request stays, and each exchange brings a new response."""

from __future__ import annotations

from ._client import SLEEP
from ._client_tasks import Condition, Target, Task, raw
from ._error import CodecError
from ._typing import TYPE_CHECKING
from .errors import DeviceError, InvalidValueError

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from ._client import Session, Work

Bits = tuple[str, int]
"""A field of the request, and the mask of some of its bits."""


class CyclicWork:
    """The exchange of one cyclic message, as generators. `cycle` is the time between two exchanges in seconds.

    `request` is what is sent in each exchange, and `response` the last that has come.
    """

    def __init__(self, session: Session, request: Any, cycle: float) -> None:
        self.session, self.request, self.cycle = session, request, cycle
        self.response: Any = None

    def exchange(self) -> Work[Any]:
        """Sends the request, and returns the response."""
        reply = yield from self.session.ask(self.request)
        self.response = reply.message
        return self.response

    def run(self, seconds: float) -> Work[None]:
        """Exchanges for some seconds, once in each cycle."""
        end = self.session.now() + seconds
        while self.session.now() < end:
            yield from self.exchange()
            yield SLEEP, self.cycle

    def task(
        self,
        name: str,
        limit: float | None,
        *watched: Condition,
        started: Sequence[Bits] = (),
        pulsed: Sequence[Bits] = (),
        unless: Condition | None = None,
    ) -> CyclicTask:
        """A task."""
        return CyclicTask(self, name, limit, watched, started=started, pulsed=pulsed, unless=unless)

    def put(self, name: str, mask: int, on: bool) -> None:
        """Sets or clears bits of a field of the request."""
        word = int(raw(getattr(self.request, name)))
        setattr(self.request, name, word | mask if on else word & ~mask)


class CyclicTask(Task):
    """A task by the fields of a cyclic message. Watched values are checked in each exchange.

    `started` are the bits that let something go on, which a task that fails clears; `pulsed` are those that every task
    clears at its end. Where `unless` holds already, nothing is done.
    """

    def __init__(
        self,
        work: CyclicWork,
        name: str,
        limit: float | None,
        watched: Sequence[Condition] = (),
        *,
        started: Sequence[Bits] = (),
        pulsed: Sequence[Bits] = (),
        unless: Condition | None = None,
    ) -> None:
        super().__init__(work.session, name, limit, watched)
        self.work, self.started, self.pulsed, self.unless = work, started, pulsed, unless

    def carry_out(self, steps: Sequence[Work[Any]]) -> Work[Any]:
        """Carries out the steps; the result is that of the step that reads."""
        if self.unless is not None:
            response = yield from self.work.exchange()
            if self.unless.holds(getattr(response, self.unless.place)):
                return None
        try:
            result = yield from self.run(steps)
        except GeneratorExit:
            raise
        except BaseException:
            yield from self._cleared((*self.started, *self.pulsed))
            raise
        if self.pulsed:
            yield from self._cleared(self.pulsed)
        return result

    def _cleared(self, bits: Sequence[Bits]) -> Work[None]:
        for name, mask in bits:
            self.work.put(name, mask, False)
        try:
            yield from self.work.exchange()
        except DeviceError:
            return  # the request is right for the next exchange

    def look(self, *conditions: Condition) -> Work[Any]:
        """Exchanges once. Raises the exception of the first condition that does not hold."""
        response = yield from self.work.exchange()
        for condition in (*self.watched, *conditions):
            value = getattr(response, condition.place)
            if not condition.holds(value):
                raise condition.error(self.name, value)

    def put(self, name: str, mask: int, on: bool) -> Work[None]:
        """Sets or clears bits of the request, and exchanges it."""
        self.work.put(name, mask, on)
        yield from self.look()
        yield SLEEP, self.work.cycle

    def write(self, name: str, value: Any) -> Work[None]:
        """Sets a field of the request, which is checked at once."""
        self._trial(name, value)
        return self._set_field(name, value)

    def _trial(self, name: str, value: Any) -> Any:
        """A copy of the request with a value. Raises InvalidValueError."""
        trial = self.work.request.__class__.decode(self.work.request.encode())
        try:
            setattr(trial, name, value)
            trial.encode()
        except CodecError as error:
            raise InvalidValueError(str(error)) from error
        return trial

    def _set_field(self, name: str, value: Any) -> Work[None]:
        setattr(self.work.request, name, value)
        yield from ()

    def pulse(self, name: str, mask: int) -> Work[None]:
        """Clears a bit, lets the device see it, and sets it."""
        yield from self.put(name, mask, False)
        yield from self.settle()
        yield from self.put(name, mask, True)

    def settle(self) -> Work[None]:
        """Exchanges until the device can show the requested state."""
        end = self.session.now() + self.session.settle
        while True:
            yield from self.look()
            if self.session.now() >= end:
                return
            yield SLEEP, self.work.cycle

    def _values(self, conditions: Sequence[Condition | Target]) -> Work[list[Any]]:
        yield from self.look()
        values = [getattr(self.work.response, condition.place) for condition in conditions]
        for condition, value in zip(conditions, values, strict=True):
            if isinstance(condition, Condition) and condition.reason == "refused" and not condition.holds(value):
                raise condition.error(self.name, value)
        return values

    def begin(self, *conditions: Condition | Target) -> Work[None]:
        """Exchanges until the conditions do not all hold. Raises MotionError, and the exceptions of what is watched."""
        yield from self.until_begun(conditions, lambda: self._values(conditions))

    def wait(self, *conditions: Condition | Target) -> Work[None]:
        """Exchanges until conditions hold. Raises TimeLimitError, MotionError, and the errors of watched values."""
        yield from self.until(conditions, lambda: self._values(conditions))

    def note(self, target: Target) -> Work[None]:
        """Adds what the response shows now: the target is that far away."""
        yield from self.look()
        target.count += int(raw(getattr(self.work.response, target.place)))

    def count(self, name: str, value: Any, attribute: str) -> int:
        """The counts of a value in its unit: an attribute of the request that has it."""
        return int(raw(getattr(self._trial(name, value), attribute)))

    def read(self, name: str) -> Work[Any]:
        """A field of the response."""
        yield from self.look()
        return getattr(self.work.response, name)
