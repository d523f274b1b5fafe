"""Clients that block."""

from __future__ import annotations

from time import monotonic, sleep

from ._client import READ, SLEEP, WRITE, drop_input
from ._typing import TYPE_CHECKING, T
from .errors import TransportError

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from ._client import Session, Work
    from ._client_registers import Group, ParameterWork, RegisterWork, Values
    from ._client_tasks import Jog
    from ._parameters import Parameter
    from ._registers import Register, Table
    from ._typing import Quantity
    from .transports import Transport


class BlockingClient:
    """A client of one unit that blocks until it has its answer. It is not for several threads at once."""

    def __init__(self, transport: Transport, session: Session) -> None:
        if getattr(transport, "timeout", 0.0) is None:
            raise ValueError("the transport waits for ever: give it a short time-out, such as timeout=0.05")
        self.transport, self.session = transport, session

    def _run(self, work: Work[T]) -> T:
        return carry_out(work, self.transport)

    def send(self, request: Any, *, unit_address: int | None = None) -> None:
        """Sends a request without a response, such as a broadcast.

        Raises InvalidValueError and TransportError.
        """
        self._run(self.session.send(request, unit_address))


class RegisterClient(BlockingClient):
    """A client with registers. Writes are sent once, reads again where no answer comes."""

    _registers: RegisterWork

    def read(self, register: Register[T]) -> T:
        """The value of a register, or a record of a table. Raises DeviceError."""
        return self._run(self._registers.read(register))

    def read_in_unit(self, register: Register[Any]) -> float | None:
        """The value of a register in its unit; None for one that stands for an absent value. Raises DeviceError."""
        return self._run(self._registers.read_in_unit(register))

    def read_table(self, table: Table[T]) -> list[T]:
        """The records of a table that the device has; it reads how many, and where, first. Raises DeviceError."""
        return self._run(self._registers.read_table(table))

    def read_group(self, group: Group) -> Values:
        """The values of a group of registers, in as few requests as the device permits. Raises DeviceError.

        Registers that the device refuses are in `refused`; what must not be read with others is left out.
        """
        return self._run(self._registers.read_group(group))

    def write(self, register: Register[T], value: T) -> None:
        """Writes a register, or a record of a table. Raises DeviceError.

        After NoAnswerError it is unknown whether the device has the value.
        """
        self._run(self._registers.write(register, value))

    def write_in_unit(self, register: Register[Any], quantity: Quantity | None) -> None:
        """Writes a register by a value in its unit, None for the only absent one. Raises as `write` does."""
        self._run(self._registers.write_in_unit(register, quantity))


class ParameterClient(BlockingClient):
    """A client with parameters that are addressed by number. Writes are sent once."""

    _parameters: ParameterWork

    def read_parameter(self, parameter: Parameter[T], subindex: int = 0) -> T:
        """The value of a parameter, or of one element. Raises DeviceError."""
        return self._run(self._parameters.read(parameter, subindex))

    def read_parameter_in_unit(self, parameter: Parameter[Any], subindex: int = 0) -> float | None:
        """The value of a parameter in its unit; None for one that stands for an absent value. Raises DeviceError."""
        return self._run(self._parameters.read_in_unit(parameter, subindex))

    def read_elements(self, parameter: Parameter[T], first: int = 0, count: int | None = None) -> list[T]:
        """The values of `count` elements of a parameter, of all where it is None. Raises DeviceError."""
        return self._run(self._parameters.read_elements(parameter, first, count))

    def write_parameter(self, parameter: Parameter[T], value: T, subindex: int = 0) -> None:
        """Writes a parameter, or one element. Raises DeviceError.

        After NoAnswerError it is unknown whether the device has the value.
        """
        self._run(self._parameters.write(parameter, value, subindex))

    def write_parameter_in_unit(self, parameter: Parameter[Any], quantity: Quantity | None, subindex: int = 0) -> None:
        """Writes a parameter by a value in its unit, None for the only absent one. Raises as `write_parameter` does."""
        self._run(self._parameters.write_in_unit(parameter, quantity, subindex))


class Motion:
    """A motion within a `with` block, which always ends it."""

    def __init__(self, run: Callable[[Work[None]], None], jog: Jog) -> None:
        self._run, self._jog = run, jog

    def __enter__(self) -> Motion:
        try:
            self._run(self._jog.begin)
        except BaseException:
            self._run(self._jog.end())
            raise
        return self

    def check(self) -> None:
        """Looks whether the device still moves without an alarm. Raises DeviceError."""
        self._run(self._jog.look())

    def __exit__(self, *error: object) -> None:
        self._run(self._jog.end())


def carry_out(work: Work[T], transport: Transport) -> T:
    """Carries out a generator on a transport that blocks. Raises what the generator raises."""
    result: Any = None
    failure: BaseException | None = None
    while True:
        try:
            action, content = work.send(result) if failure is None else work.throw(failure)
        except StopIteration as end:
            done: T = end.value
            return done
        result = failure = None
        try:
            if action == READ:
                result = _read(transport, content[0])
            elif action == WRITE:
                _write(transport, content)
            elif action == SLEEP:
                sleep(content)
            else:
                drop_input(transport)
        except BaseException as error:
            failure = error


def _read(transport: Transport, size: int) -> bytes:
    begin = monotonic()
    try:
        data = transport.read(size)
    except TimeoutError:
        data = b""
    except (OSError, EOFError) as error:
        raise TransportError(str(error)) from error
    if not data and monotonic() - begin < 0.0005:
        sleep(0.001)  # the transport does not wait by itself
    return data or b""


def _write(transport: Transport, data: bytes) -> None:
    try:
        transport.write(data)
    except (OSError, EOFError) as error:
        raise TransportError(str(error)) from error
