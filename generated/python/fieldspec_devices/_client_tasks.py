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
    MotionError,
    NoAnswerError,
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
TRIES: Final = 3
"""How often a client tries to stop a device."""


class Condition:
    """A value that something must have, or one of several: all of it, or the bits of a `mask`.

    `place` is a register, a parameter, or the path of an attribute of a response. `reason` is what is wrong where it
    does not hold: alarm, servo, refused or unready.
    """

    __slots__ = ("mask", "name", "place", "reason", "wanted")

    def __init__(self, place: Any, *numbers: float, mask: int = 0, name: str = "", reason: str = "unready") -> None:
        self.place, self.wanted, self.mask, self.reason = place, numbers, mask, reason
        self.name: str = name or _name(place)

    def holds(self, value: Any) -> bool:
        """Whether a value is one that is wanted."""
        number = raw(value)
        return (number & self.mask if self.mask else number) in self.wanted

    def error(self, task: str, value: Any) -> DeviceError:
        """The exception for a value that is not a wanted one."""
        text = f"{task}: {self.name} is {value!r}"
        if self.reason == "alarm":
            return AlarmError(text)
        if self.reason == "servo":
            return ServoOffError(text)
        if self.reason == "refused":
            return RefusedError(text, int(raw(value)))
        return NotReadyError(text)


class Target:
    """A number of counts that something must have reached. `window` is how far it may be away, in units of `scale`."""

    __slots__ = ("count", "name", "place", "scale", "window")

    def __init__(self, place: Any, count: int, window: float = 0.0, scale: float = 1.0, *, name: str = "") -> None:
        if not 0 <= window < float("inf"):
            raise InvalidValueError(f"a window of {window!r}: it is 0 or more")
        self.place, self.count, self.window, self.scale = place, int(count), window, scale
        self.name: str = name or _name(place)

    def holds(self, value: Any) -> bool:
        """Whether a value is as near as it must be."""
        return bool(abs(raw(value) - self.count) * abs(self.scale) <= self.window * (1 + 1e-9))


def _name(place: Any) -> str:
    return place if isinstance(place, str) else str(place.name)


def raw(value: Any) -> Any:
    """The number of a value: the word of bits, 0 or 1 of a truth, the number of a member."""
    return getattr(value, "raw", value)


def repeated(steps: Callable[[], Sequence[Work[Any]]]) -> Work[None]:
    """Carries out what stops a device, again where its answer is lost, damaged or a refusal."""
    left = TRIES
    while True:
        left -= 1
        try:
            for step in steps():
                yield from step
            return
        except (NoAnswerError, InvalidAnswerError, RefusedError):
            if not left:
                raise


class Task:
    """A task that is carried out once. `limit` is the time in seconds that it may take, None for any time.

    `watched` must hold while it waits.
    """

    def __init__(self, session: Session, name: str, limit: float | None, watched: Sequence[Condition] = ()) -> None:
        self.session, self.name, self.watched = session, name, list(watched)
        self.limit = limit
        self.deadline: float | None = None

    def run(
        self,
        steps: Sequence[Work[Any]],
        ending: Sequence[Work[Any]] = (),
        halting: Callable[[], Sequence[Work[Any]]] | None = None,
        first: int = 0,
    ) -> Work[Any]:
        """Carries out the steps; the result is that of the step that reads, or of several as a tuple.

        Where a step fails from the place `first` on, the steps of the `ending` are carried out, as far as they can be,
        and before them those that `halting` makes, which stop the device, unless it has refused.
        """
        if self.limit is not None:
            self.deadline = self.session.now() + self.limit
        results = []
        for index, step in enumerate(steps):
            try:
                result = yield from step
            except GeneratorExit:
                raise
            except BaseException as error:
                if index >= first:
                    if halting is not None and not isinstance(error, RefusedError):
                        with suppress(DeviceError):
                            yield from repeated(halting)
                    for last in ending:
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
        """Waits until the device can show the requested state."""
        yield SLEEP, self.session.settle

    def refuse(self, condition: Condition) -> Work[None]:
        """From here on, the condition must hold: the device shows there what it has refused."""
        self.watched.append(condition)
        yield from ()

    def until(self, conditions: Sequence[Condition | Target], look: Callable[[], Work[list[Any]]]) -> Work[None]:
        """Looks at the device until all conditions hold at once. `look` gives the values for them.

        Raises TimeLimitError, and MotionError where the device stands for longer than a motion may take to begin, and
        not at its target.
        """
        standing: float | None = None
        while True:
            values = yield from look()
            missing = [pair for pair in zip(conditions, values, strict=True) if not pair[0].holds(pair[1])]
            if not missing:
                return
            condition, value = missing[0]
            if any(isinstance(other, Condition) for other, _ in missing):
                standing = None
            elif standing is None:
                standing = self.session.now()
            elif self.session.now() - standing >= self.session.begin:
                numbers = getattr(condition, "count", None)
                raise MotionError(f"{self.name}: the device stands, and {condition.name} is {value!r}, not {numbers}")
            if self.late():
                raise TimeLimitError(f"{self.name}: {condition.name} is still {value!r}")
            yield SLEEP, POLL

    def until_begun(self, conditions: Sequence[Condition | Target], look: Callable[[], Work[list[Any]]]) -> Work[None]:
        """Looks at the device until the conditions do not all hold, since a motion has begun. Raises MotionError."""
        end = self.session.now() + self.session.begin
        while True:
            values = yield from look()
            if not all(condition.holds(value) for condition, value in zip(conditions, values, strict=True)):
                return
            if self.session.now() >= end:
                raise MotionError(f"{self.name}: no motion has begun")
            yield SLEEP, POLL


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

    def _values(self, conditions: Sequence[Condition | Target]) -> Work[list[Any]]:
        """The values of places, each read once; what is watched must hold."""
        yield from self.look()
        values: dict[int, Any] = {}
        for condition in conditions:
            if id(condition.place) not in values:
                values[id(condition.place)] = yield from self._read(condition.place)
        return [values[id(condition.place)] for condition in conditions]

    def begin(self, *conditions: Condition | Target) -> Work[None]:
        """Waits until the conditions do not all hold. Raises MotionError, and the exceptions of what is watched."""
        yield from self.until_begun(conditions, lambda: self._values(conditions))

    def wait(self, *conditions: Condition | Target) -> Work[None]:
        """Waits until conditions hold. Raises TimeLimitError, MotionError, and the exceptions of what is watched."""
        yield from self.until(conditions, lambda: self._values(conditions))

    def note(self, target: Target) -> Work[None]:
        """Adds what the place of a target shows now: the target is that far away."""
        value = yield from self._read(target.place)
        target.count += int(raw(value))

    def count(self, place: Register[Any] | Parameter[Any], quantity: Quantity) -> int:
        """The counts of a value in its unit."""
        try:
            return int(raw(place.from_unit(quantity)))
        except CodecError as error:
            raise InvalidValueError(str(error)) from error

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
        holder: Any = self.registers if isinstance(place, Register) else self.parameters
        work: Work[None] = holder.write(place, value)
        return work

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

    def write_bits(self, place: Any, number: int, *masks: int) -> Work[None]:
        """Writes a number, which is checked at once, into bits of a word, the lowest first."""
        if not 0 <= number < 1 << len(masks):
            raise InvalidValueError(f"{number} is not in 0..{(1 << len(masks)) - 1}")
        return self.change(place, sum(masks), sum(mask for bit, mask in enumerate(masks) if number >> bit & 1))


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
        reply = self.reply = yield from self.session.ask(request, 0)
        self._compare(reply, (*self.watched, *conditions) if conditions else ())

    def read(self, request: Any, *paths: str) -> Work[Any]:
        """Values in the response to a request that only reads."""
        reply = yield from self.session.ask(request)
        values = tuple(_attribute(reply, path) for path in paths)
        return values[0] if len(values) == 1 else values

    def _values(self, request: Any, conditions: Sequence[Condition | Target]) -> Work[list[Any]]:
        reply = yield from self.session.ask(request)
        self._compare(reply, self.watched)
        return [_attribute(reply, condition.place) for condition in conditions]

    def begin(self, request: Any, *conditions: Condition | Target) -> Work[None]:
        """Sends a request until its response does not show all conditions, unless that to the command did not.

        Raises MotionError.
        """
        heads = [condition for condition in conditions if "." not in condition.place]
        if all(condition.holds(_attribute(self.reply, condition.place)) for condition in heads):
            yield from self.until_begun(conditions, lambda: self._values(request, conditions))

    def wait(self, request: Any, *conditions: Condition | Target) -> Work[None]:
        """Sends a request until its response shows the conditions. Raises TimeLimitError and MotionError."""
        yield from self.until(conditions, lambda: self._values(request, conditions))

    def note(self, request: Any, target: Target) -> Work[None]:
        """Adds what the response to a request shows now: the target is that far away."""
        reply = yield from self.session.ask(request)
        target.count += int(raw(_attribute(reply, target.place)))

    def count(self, request: Any, name: str) -> int:
        """The counts of a field of a request."""
        return int(raw(getattr(request, name)))

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

    `look` and `steps` make new generators at each call.
    """

    def __init__(
        self, begin: Work[None], look: Callable[[], Work[None]], steps: Callable[[], Sequence[Work[Any]]]
    ) -> None:
        self.begin, self.look, self.steps = begin, look, steps

    def end(self) -> Work[None]:
        """Stops the device. Raises DeviceError."""
        yield from repeated(self.steps)


class DeviceWork:
    """The work of a device's client, as generators."""

    def __init__(self, session: Session) -> None:
        self.session = session

    def register_task(self, name: str, limit: float | None, *watched: Condition) -> RegisterTask:
        """A task over registers and parameters."""
        registers, parameters = getattr(self, "registers", None), getattr(self, "parameters", None)
        return RegisterTask(self.session, name, limit, watched, registers, parameters)

    def message_task(self, name: str, limit: float | None, *watched: Condition) -> MessageTask:
        """A task of messages."""
        return MessageTask(self.session, name, limit, watched)
