"""Clients for asyncio."""

from __future__ import annotations

from ._client import READ, SLEEP, WRITE, drop_input
from ._typing import TYPE_CHECKING, T
from .errors import TransportError

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable
    from typing import Any

    from ._client import Session, Work
    from ._client_registers import Group, ParameterWork, RegisterWork, Values
    from ._client_tasks import Jog
    from ._parameters import Parameter
    from ._registers import Register, Table
    from ._typing import Quantity
    from .transports import AsyncTransport


class AsyncBaseClient:
    """A client of one unit for asyncio. It is for one task at a time."""

    def __init__(self, transport: AsyncTransport, session: Session) -> None:
        self.transport, self.session = transport, session

    async def _run(self, work: Work[T]) -> T:
        return await carry_out_async(work, self.transport)

    async def send(self, request: Any, *, unit_address: int | None = None) -> None:
        """Sends a request without a response, such as a broadcast.

        Raises InvalidValueError and TransportError.
        """
        await self._run(self.session.send(request, unit_address))


class AsyncRegisterClient(AsyncBaseClient):
    """A client with registers. Writes are sent once, reads again where no answer comes."""

    _registers: RegisterWork

    async def read(self, register: Register[T]) -> T:
        """The value of a register, or a record of a table. Raises DeviceError."""
        return await self._run(self._registers.read(register))

    async def read_in_unit(self, register: Register[Any]) -> float | None:
        """The value of a register in its unit; None for one that stands for an absent value. Raises DeviceError."""
        return await self._run(self._registers.read_in_unit(register))

    async def read_table(self, table: Table[T]) -> list[T]:
        """The records of a table that the device has; it reads how many, and where, first. Raises DeviceError."""
        return await self._run(self._registers.read_table(table))

    async def read_group(self, group: Group) -> Values:
        """The values of a group of registers, in as few requests as the device permits. Raises DeviceError.

        Registers that the device refuses are in `refused`; what must not be read with others is left out.
        """
        return await self._run(self._registers.read_group(group))

    async def write(self, register: Register[T], value: T) -> None:
        """Writes a register, or a record of a table. Raises DeviceError.

        After NoAnswerError it is unknown whether the device has the value.
        """
        await self._run(self._registers.write(register, value))

    async def write_in_unit(self, register: Register[Any], quantity: Quantity | None) -> None:
        """Writes a register by a value in its unit, None for the only absent one. Raises as `write` does."""
        await self._run(self._registers.write_in_unit(register, quantity))


class AsyncParameterClient(AsyncBaseClient):
    """A client with parameters that are addressed by number. Writes are sent once."""

    _parameters: ParameterWork

    async def read_parameter(self, parameter: Parameter[T], subindex: int = 0) -> T:
        """The value of a parameter, or of one element. Raises DeviceError."""
        return await self._run(self._parameters.read(parameter, subindex))

    async def read_parameter_in_unit(self, parameter: Parameter[Any], subindex: int = 0) -> float | None:
        """The value of a parameter in its unit; None for one that stands for an absent value. Raises DeviceError."""
        return await self._run(self._parameters.read_in_unit(parameter, subindex))

    async def read_elements(self, parameter: Parameter[T], first: int = 0, count: int | None = None) -> list[T]:
        """The values of `count` elements of a parameter, of all where it is None. Raises DeviceError."""
        return await self._run(self._parameters.read_elements(parameter, first, count))

    async def write_parameter(self, parameter: Parameter[T], value: T, subindex: int = 0) -> None:
        """Writes a parameter, or one element. Raises DeviceError.

        After NoAnswerError it is unknown whether the device has the value.
        """
        await self._run(self._parameters.write(parameter, value, subindex))

    async def write_parameter_in_unit(
        self, parameter: Parameter[Any], quantity: Quantity | None, subindex: int = 0
    ) -> None:
        """Writes a parameter by a value in its unit, None for the only absent one. Raises as `write_parameter` does."""
        await self._run(self._parameters.write_in_unit(parameter, quantity, subindex))


class AsyncMotion:
    """A motion within an `async with` block, which always ends it."""

    def __init__(self, run: Callable[[Work[None]], Awaitable[None]], jog: Jog) -> None:
        self._run, self._jog = run, jog

    async def __aenter__(self) -> AsyncMotion:
        try:
            await self._run(self._jog.begin)
        except BaseException:
            await self._run(self._jog.end())
            raise
        return self

    async def check(self) -> None:
        """Looks whether the device still moves without an alarm. Raises DeviceError."""
        await self._run(self._jog.look())

    async def __aexit__(self, *error: object) -> None:
        await self._run(self._jog.end())


async def carry_out_async(work: Work[T], transport: AsyncTransport) -> T:
    """Carries out a generator on a transport for asyncio. Raises what the generator raises."""
    from asyncio import sleep as pause

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
                result = await _read_async(transport, *content)
            elif action == WRITE:
                await _write_async(transport, content)
            elif action == SLEEP:
                await pause(content)
            else:
                drop_input(transport)
        except BaseException as error:
            failure = error


async def _read_async(transport: AsyncTransport, size: int, seconds: float) -> bytes:
    from asyncio import CancelledError, ensure_future, wait
    from asyncio import TimeoutError as AsyncTimeoutError

    # Before Python 3.12, wait_for forgets that it is cancelled where bytes come at that moment: a move would go on.
    reading = ensure_future(transport.read(size))
    try:
        await wait({reading}, timeout=seconds)
    except CancelledError:
        reading.cancel()
        await wait({reading})
        if not reading.cancelled():
            reading.exception()
        raise
    reading.cancel()
    await wait({reading})
    if reading.cancelled():
        return b""
    try:
        return reading.result()
    except (TimeoutError, AsyncTimeoutError):
        return b""
    except ConnectionRefusedError as error:
        if not getattr(transport, "datagrams", False):
            raise TransportError(str(error)) from error
        return b""  # nobody has listened to what was sent before
    except (OSError, EOFError) as error:
        raise TransportError(str(error)) from error


async def _write_async(transport: AsyncTransport, data: bytes) -> None:
    try:
        await transport.write(data)
    except (OSError, EOFError) as error:
        raise TransportError(str(error)) from error
