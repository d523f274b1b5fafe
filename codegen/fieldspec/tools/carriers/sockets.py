"""TCP connections and UDP datagrams."""

from __future__ import annotations

import socket
from contextlib import suppress
from urllib.parse import urlsplit

from fieldspec.tools.carriers.carrier import CarrierError


def address(url: str) -> tuple[str, int]:
    """The host and the port of `tcp://HOST:PORT`. Raises CarrierError."""
    try:
        parts = urlsplit(url)
        host, port = parts.hostname, parts.port
    except ValueError as error:
        raise CarrierError(f"{url} is not an address: {error}") from None
    if not host or port is None:
        raise CarrierError(f"{url} is not an address; write it as {parts.scheme or 'tcp'}://HOST:PORT")
    return host, port


def _place(scheme: str, own: tuple[str, int]) -> str:
    host = f"[{own[0]}]" if ":" in own[0] else own[0]
    return f"{scheme}://{host}:{own[1]}"


class Connection:
    """One TCP connection."""

    datagrams = False
    keeps_pauses = False

    def __init__(self, connected: socket.socket, name: str) -> None:
        self._socket, self.name = connected, name
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    @classmethod
    def opened(cls, url: str, seconds: float = 5.0) -> Connection:
        """A connection to a server. Raises CarrierError."""
        try:
            return cls(socket.create_connection(address(url), seconds), url)
        except OSError as error:
            raise CarrierError(f"cannot connect to {url}: {error.strerror or error}") from None

    def read(self, seconds: float) -> bytes:
        """The bytes that come within some seconds. Raises CarrierError at the end."""
        try:
            self._socket.settimeout(max(seconds, 0.0001))
            data = self._socket.recv(4096)
        except TimeoutError:
            return b""
        except OSError as error:
            raise CarrierError(f"{self.name}: {error.strerror or error}") from None
        if not data:
            raise CarrierError(f"{self.name}: the other side has closed the connection")
        return data

    def write(self, data: bytes) -> None:
        """Sends bytes. Raises CarrierError."""
        try:
            self._socket.settimeout(5.0)
            self._socket.sendall(data)
        except OSError as error:
            raise CarrierError(f"{self.name}: {error.strerror or error}") from None

    def close(self) -> None:
        """Closes the connection."""
        with suppress(OSError):  # the other side may have been faster
            self._socket.shutdown(socket.SHUT_RDWR)
        self._socket.close()


class Listener:
    """Accepts TCP connections."""

    def __init__(self, url: str) -> None:
        host, port = address(url)
        family = socket.AF_INET6 if ":" in host else socket.AF_INET
        try:
            self._socket = socket.create_server((host, port), family=family)
        except OSError as error:
            raise CarrierError(f"cannot listen on {url}: {error.strerror or error}") from None
        self._socket.settimeout(0.2)
        self.name = _place("tcp", self._socket.getsockname()[:2])
        self._closed = False

    def accept(self) -> Connection | None:
        """The next connection; None if none comes for a while. Raises CarrierError at the end."""
        if self._closed:
            raise CarrierError(f"{self.name} is closed")
        try:
            connected, peer = self._socket.accept()
        except TimeoutError:
            return None
        except OSError as error:
            raise CarrierError(f"{self.name}: {error.strerror or error}") from None
        return Connection(connected, _place("tcp", peer[:2]))

    def close(self) -> None:
        """Closes the listening socket."""
        self._closed = True
        self._socket.close()


class Datagrams:
    """UDP. A server answers the sender of the last datagram, a client sends to the address of its URL."""

    datagrams = True
    keeps_pauses = False

    def __init__(self, url: str, server: bool) -> None:
        host, port = address(url)
        self._server = server
        self._peer: tuple[str, int] | None = None
        try:
            info = socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM)[0]
            self._socket = socket.socket(info[0], socket.SOCK_DGRAM)
            if server:
                self._socket.bind(info[4])
            else:
                self._socket.connect(info[4])
        except OSError as error:
            raise CarrierError(f"cannot open {url}: {error.strerror or error}") from None
        self.name = _place("udp", self._socket.getsockname()[:2]) if server else url
        self._closed = False

    def read(self, seconds: float) -> bytes:
        """The datagram that comes within some seconds. Raises CarrierError at the end."""
        if self._closed:
            raise CarrierError(f"{self.name} is closed")
        try:
            self._socket.settimeout(max(min(seconds, 0.2), 0.0001))
            data, peer = self._socket.recvfrom(65536)
        except TimeoutError:
            return b""
        except ConnectionError:
            return b""  # nobody has listened to what was sent before
        except OSError as error:
            raise CarrierError(f"{self.name}: {error.strerror or error}") from None
        self._peer = peer
        return data

    def write(self, data: bytes) -> None:
        """Sends a datagram. Raises CarrierError."""
        try:
            if not self._server:
                self._socket.send(data)
            elif self._peer is not None:
                self._socket.sendto(data, self._peer)
        except ConnectionError:
            pass  # nobody listens, which datagrams do not tell
        except OSError as error:
            raise CarrierError(f"{self.name}: {error.strerror or error}") from None

    def close(self) -> None:
        """Closes the socket."""
        self._closed = True
        self._socket.close()
