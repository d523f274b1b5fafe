"""Tasks of clients: their steps in order, with what must hold meanwhile, as generators."""

from __future__ import annotations

from contextlib import suppress
from operator import attrgetter

from ._client import SLEEP
from ._error import CodecError
from ._flags import Flags
from ._registers import Register
from ._typing import TYPE_CHECKING
from .errors import (
    AlarmError,
    DeviceError,
    InvalidAnswerError,
    InvalidValueError,
    NotReadyError,
    RefusedError,
    ServoOffError,
    TimeLimitError,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any, Final

    from ._client import Session, Work
    from ._client_registers import ParameterWork, RegisterWork
    from ._parameters import Parameter
    from ._typing import Quantity

POLL: Final = 0.02
"""The seconds between two looks at what a task waits for."""


class Condition:
    """A value that something must have: all of it, or the bits of a `mask`.

    `place` is a register, a parameter, or the path of an attribute of a response. `reason` is what is wrong where it
    does not hold: alarm, servo, refused or unready.
    """

    __slots__ = ("mask", "name", "place", "reason", "wanted")

    def __init__(self, place: Any, wanted: float, *, mask: int = 0, name: str = "", reason: str = "unready") -> None:
        self.place, self.wanted, self.mask, self.reason = place, wanted, mask, reason
        self.name: str = name or (place if isinstance(place, str) else place.name)

    def holds(self, value: Any) -> bool:
        """Whether a value is the one that is wanted."""
        number = raw(value)
        return bool((number & self.mask if self.mask else number) == self.wanted)

    def error(self, task: str, value: Any) -> DeviceError:
        """The exception for a value that is not the wanted one."""
        text = f"{task}: {self.name} is {value!r}"
        if self.reason == "alarm":
            return AlarmError(text)
        if self.reason == "servo":
            return ServoOffError(text)
        if self.reason == "refused":
            return RefusedError(text, int(raw(value)))
        return NotReadyError(text)


def raw(value: Any) -> Any:
    """The number of a value: the word of bits, 0 or 1 of a truth, the number of a member."""
    return getattr(value, "raw", value)


class Task:
    """A task that is carried out once. `limit` is the time in seconds that it may take, None for any time.

    `watched` must hold while it waits.
    """

    def __init__(self, session: Session, name: str, limit: float | None, watched: Sequence[Condition] = ()) -> None:
        self.session, self.name, self.watched = session, name, list(watched)
        self.limit = limit
        self.deadline: float | None = None

    def run(self, steps: Sequence[Work[Any]], ending: Sequence[Work[Any]] = (), first: int = 0) -> Work[Any]:
        """Carries out the steps; the result is that of the step that reads, or of several as a tuple.

        Where a step fails from the place `first` on, the steps of the `ending` are carried out, as far as they can be.
        """
        if self.limit is not None:
            self.deadline = self.session.now() + self.limit
        results = []
        for at, step in enumerate(steps):
            try:
                result = yield from step
            except GeneratorExit:
                raise
            except BaseException:
                for last in ending if at >= first else ():
                    with suppress(DeviceError):
                        yield from last
                raise
            if result is not None:
                results.append(result)
        return results[0] if len(results) == 1 else tuple(results) or None

    def late(self) -> bool:
        """Whether the time of the task is over."""
        return self.deadline is not None and self.session.now() >= self.deadline

    def settle(self) -> Work[None]:
        """Waits until the device can show what it was asked for."""
        yield SLEEP, self.session.settle

    def refuse(self, condition: Condition) -> Work[None]:
        """From here on, the condition must hold: the device shows there what it has refused."""
        self.watched.append(condition)
        yield from ()


class RegisterTask(Task):
    """A task over registers and parameters."""

    def __init__(
        self,
        session: Session,
        name: str,
        limit: float | None,
        watched: Sequence[Condition] = (),
        registers: RegisterWork | None = None,
        parameters: ParameterWork | None = None,
    ) -> None:
        super().__init__(session, name, limit, watched)
        self.registers, self.parameters = registers, parameters

    def _read(self, place: Any) -> Work[Any]:
        if isinstance(place, Register):
            assert self.registers is not None
            return self.registers.read(place)
        assert self.parameters is not None
        return self.parameters.read(place)

    def look(self, *conditions: Condition) -> Work[None]:
        """Reads what must hold before anything starts. Raises the exception of the first that does not."""
        for condition in (*self.watched, *conditions):
            value = yield from self._read(condition.place)
            if not condition.holds(value):
                raise condition.error(self.name, value)

    def wait(self, condition: Condition) -> Work[None]:
        """Waits until a condition holds. Raises TimeLimitError, and the exceptions of what is watched."""
        while True:
            yield from self.look()
            value = yield from self._read(condition.place)
            if condition.holds(value):
                return
            if self.late():
                raise TimeLimitError(f"{self.name}: {condition.name} is still {value!r}")
            yield SLEEP, POLL

    def read(self, place: Register[Any] | Parameter[Any], in_unit: bool) -> Work[Any]:
        """The value, or the value in its unit."""
        value = yield from self._read(place)
        return place.in_unit(value) if in_unit else value

    def read_element(self, parameter: Parameter[Any], subindex: int) -> Work[Any]:
        """The value of one element of a parameter."""
        assert self.parameters is not None
        return self.parameters.read(parameter, subindex)

    def read_elements(self, parameter: Parameter[Any]) -> Work[list[Any]]:
        """The values of all elements of a parameter."""
        assert self.parameters is not None
        return self.parameters.read_elements(parameter)

    def write(self, place: Any, value: Any) -> Work[None]:
        """Writes a value, which is encoded at once."""
        if isinstance(place, Register):
            assert self.registers is not None
            return self.registers.write(place, value)
        assert self.parameters is not None
        return self.parameters.write(place, value)

    def write_in_unit(self, place: Register[Any] | Parameter[Any], quantity: Quantity) -> Work[None]:
        """Writes a value in its unit, which is encoded at once."""
        try:
            count = place.from_unit(quantity)
        except CodecError as error:
            raise InvalidValueError(str(error)) from error
        return self.write(place, count)

    def change(self, place: Any, mask: int, bits: int) -> Work[None]:
        """Changes bits of a word, and leaves the others as they are."""
        word = yield from self._read(place)
        changed = int(raw(word)) & ~mask | bits
        yield from self.write(place, word.__class__(changed) if isinstance(word, Flags) else changed)


class MessageTask(Task):
    """A task of messages, whose responses show what the device does."""

    def look(self) -> Work[None]:
        """Nothing: what is watched is in the responses."""
        yield from ()

    def request(self, kind: Callable[..., Any], **fields: Any) -> Any:
        """A request, whose values are checked at once."""
        try:
            request = kind(**fields)
            request.encode()
        except CodecError as error:
            raise InvalidValueError(str(error)) from error
        return request

    def send(self, request: Any, *conditions: Condition) -> Work[Any]:
        """Sends a request once. Its response must show what is watched, and the conditions."""
        reply = yield from self.session.ask(request, 0)
        self._compare(reply, (*self.watched, *conditions) if conditions else ())

    def read(self, request: Any, *paths: str) -> Work[Any]:
        """Values in the response to a request that only reads."""
        reply = yield from self.session.ask(request)
        values = tuple(_attribute(reply, path) for path in paths)
        return values[0] if len(values) == 1 else values

    def wait(self, request: Any, *conditions: Condition) -> Work[None]:
        """Sends a request until its response shows the conditions. Raises TimeLimitError."""
        while True:
            reply = yield from self.session.ask(request)
            self._compare(reply, self.watched)
            missing = [each for each in conditions if not each.holds(_attribute(reply, each.place))]
            if not missing:
                return
            if self.late():
                value = _attribute(reply, missing[0].place)
                raise TimeLimitError(f"{self.name}: {missing[0].name} is still {value!r}")
            yield SLEEP, POLL

    def _compare(self, reply: Any, conditions: Sequence[Condition]) -> None:
        for condition in conditions:
            value = _attribute(reply, condition.place)
            if not condition.holds(value):
                raise condition.error(self.name, value)


def _attribute(reply: Any, path: str) -> Any:
    try:
        return attrgetter(path)(reply)
    except CodecError as error:
        raise InvalidAnswerError(str(error)) from error


class Jog:
    """A jog: what begins it, what looks whether it may go on, and what ends it.

    `look` and `end` make a new generator at each call.
    """

    def __init__(self, begin: Work[None], look: Callable[[], Work[None]], end: Callable[[], Work[None]]) -> None:
        self.begin, self.look, self.end = begin, look, end


class DeviceWork:
    """What the client of a device does, as generators."""

    def __init__(self, session: Session) -> None:
        self.session = session

    def register_task(self, name: str, limit: float | None, *watched: Condition) -> RegisterTask:
        """A task over registers and parameters."""
        registers, parameters = getattr(self, "registers", None), getattr(self, "parameters", None)
        return RegisterTask(self.session, name, limit, watched, registers, parameters)

    def message_task(self, name: str, limit: float | None, *watched: Condition) -> MessageTask:
        """A task of messages."""
        return MessageTask(self.session, name, limit, watched)
