"""Transports of clients over TCP, UDP and CAN buses, for programs that block and for asyncio.

A client takes anything with `read` and `write`: a port of pyserial with a `timeout`, or an object of yours.
"""

from __future__ import annotations

from socket import IPPROTO_TCP, SOCK_DGRAM, TCP_NODELAY, create_connection, getaddrinfo
from socket import socket as Socket

from ._can import CanFrame
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from asyncio import StreamReader, StreamWriter
    from typing import Any, Protocol

    class Transport(Protocol):
        """What carries the bytes of a client that blocks."""

        def read(self, size: int, /) -> bytes | None:
            """At most `size` bytes. It may return fewer, and none when its own time-out is over, which must be short.

            A transport of datagrams returns one datagram.
            """

        def write(self, data: bytes, /) -> object:
            """Sends bytes."""

    class AsyncTransport(Protocol):
        """What carries the bytes of a client for asyncio."""

        async def read(self, size: int, /) -> bytes:
            """At most `size` bytes, as soon as one is there. A transport of datagrams returns one datagram."""
            ...

        async def write(self, data: bytes, /) -> object:
            """Sends bytes."""


class SocketTransport:
    """A connected socket. `datagrams`: each frame is a datagram."""

    def __init__(self, connected: Socket, timeout: float = 0.05) -> None:
        self.datagrams = connected.type == SOCK_DGRAM
        self._socket = connected
        self._timeout = timeout
        connected.settimeout(timeout)

    def read(self, size: int) -> bytes:
        """At most `size` bytes; none when the time-out is over. Raises OSError, and EOFError at the end."""
        try:
            data = self._socket.recv(size)
        except TimeoutError:
            return b""
        except ConnectionRefusedError:
            if self.datagrams:
                return b""  # nobody has listened to what was sent before
            raise
        if not data and not self.datagrams:
            raise EOFError("the other side has closed the connection")
        return data

    def write(self, data: bytes) -> None:
        """Sends bytes. Raises OSError."""
        self._socket.sendall(data)

    def reset_input_buffer(self) -> None:
        """Drops what has come and was not read."""
        self._socket.setblocking(False)
        try:
            while self._socket.recv(65536):
                pass
        except OSError:
            pass  # nothing is left, or the next read says why not
        finally:
            self._socket.settimeout(self._timeout)

    def close(self) -> None:
        """Closes the socket."""
        self._socket.close()

    def __enter__(self) -> SocketTransport:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()


class AsyncSocketTransport:
    """A connected socket for asyncio. `datagrams`: each frame is a datagram."""

    def __init__(self, connected: Socket) -> None:
        self.datagrams = connected.type == SOCK_DGRAM
        self._socket = connected
        connected.setblocking(False)

    async def read(self, size: int) -> bytes:
        """At most `size` bytes. Raises OSError, and EOFError at the end."""
        from asyncio import get_running_loop

        data = await get_running_loop().sock_recv(self._socket, size)
        if not data and not self.datagrams:
            raise EOFError("the other side has closed the connection")
        return data

    async def write(self, data: bytes) -> None:
        """Sends bytes. Raises OSError."""
        from asyncio import get_running_loop

        await get_running_loop().sock_sendall(self._socket, data)

    def reset_input_buffer(self) -> None:
        """Drops what has come and was not read."""
        try:
            while self._socket.recv(65536):
                pass
        except OSError:
            pass  # nothing is left, or the next read says why not

    def close(self) -> None:
        """Closes the socket."""
        self._socket.close()

    async def __aenter__(self) -> AsyncSocketTransport:
        return self

    async def __aexit__(self, *error: object) -> None:
        self.close()


class CanTransport:
    """A bus of python-can, `message` is its class `can.Message`: `CanTransport(can.Bus(...), can.Message)`."""

    datagrams = True

    def __init__(self, bus: Any, message: Any, timeout: float = 0.05) -> None:
        self._bus, self._message, self._timeout = bus, message, timeout

    def read(self, size: int) -> bytes:
        """A frame, for which `size` does not matter; none when the time-out is over. Raises what the bus raises."""
        message = self._bus.recv(self._timeout)
        if message is None or message.is_error_frame or message.is_fd:
            return b""
        kind = message.is_extended_id, message.is_remote_frame, message.dlc
        return CanFrame(message.arbitration_id, bytes(message.data), *kind).frame()

    def write(self, data: bytes) -> None:
        """Sends a frame. Raises what the bus raises."""
        frame = CanFrame.of(data)
        self._bus.send(
            self._message(
                arbitration_id=frame.identifier,
                data=frame.data,
                is_extended_id=frame.is_extended,
                is_remote_frame=frame.is_remote,
                dlc=frame.dlc,
            )
        )

    def close(self) -> None:
        """Ends the bus."""
        self._bus.shutdown()

    def __enter__(self) -> CanTransport:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()


class StreamTransport:
    """A reader and a writer of asyncio, such as those that pyserial-asyncio opens."""

    datagrams = False

    def __init__(self, reader: StreamReader, writer: StreamWriter) -> None:
        self._reader, self._writer = reader, writer

    async def read(self, size: int) -> bytes:
        """At most `size` bytes. Raises EOFError at the end."""
        data = await self._reader.read(size)
        if not data:
            raise EOFError("the other side has closed the connection")
        return data

    async def write(self, data: bytes) -> None:
        """Sends bytes."""
        self._writer.write(data)
        await self._writer.drain()


def tcp(host: str, port: int, *, timeout: float = 5.0) -> SocketTransport:
    """A TCP connection, opened within `timeout` seconds. Raises OSError."""
    return SocketTransport(_connected(host, port, timeout))


def udp(host: str, port: int) -> SocketTransport:
    """Datagrams to and from an address. Raises OSError."""
    return SocketTransport(_datagrams(host, port))


async def async_tcp(host: str, port: int, *, timeout: float = 5.0) -> AsyncSocketTransport:
    """A TCP connection, opened within `timeout` seconds. Raises OSError."""
    from asyncio import to_thread

    return AsyncSocketTransport(await to_thread(_connected, host, port, timeout))


async def async_udp(host: str, port: int) -> AsyncSocketTransport:
    """Datagrams to and from an address. Raises OSError."""
    from asyncio import to_thread

    return AsyncSocketTransport(await to_thread(_datagrams, host, port))


def _connected(host: str, port: int, timeout: float) -> Socket:
    connected = create_connection((host, port), timeout)
    connected.setsockopt(IPPROTO_TCP, TCP_NODELAY, 1)
    return connected


def _datagrams(host: str, port: int) -> Socket:
    family, kind, protocol, _, address = getaddrinfo(host, port, type=SOCK_DGRAM)[0]
    opened = Socket(family, kind, protocol)
    opened.connect(address)
    return opened
