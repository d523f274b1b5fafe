"""WebSockets: browsers talk to a simulated device over them, as pages cannot open serial ports or TCP connections.

A WebSocket is open to every page of the world that a browser on this machine displays, so a server answers only those
that are files or come from this machine, and only with the key in the address that it prints.
"""

from __future__ import annotations

import hmac
import re
import secrets
import threading
from collections.abc import Callable, Mapping
from contextlib import suppress
from http import HTTPStatus
from urllib.parse import parse_qs, quote, unquote

from websockets.exceptions import ConnectionClosed
from websockets.http11 import Request, Response
from websockets.sync.server import Server, ServerConnection, serve
from websockets.typing import Origin

from fieldspec.tools.carriers.carrier import CarrierError

HOST = "127.0.0.1"
ORIGINS = (
    None,  # a program
    Origin("null"),  # a page that is a file
    re.compile(r"https?://(localhost|127\.0\.0\.1|\[::1\])(:[0-9]+)?"),
)
"""Who may connect. Pages of others can claim to be a file, but they do not know the key."""

MOST_BYTES = 65536
"""The size of a message."""


class WebSocket:
    """One connection of a browser. Each message of bytes is a piece of a stream, or a datagram.

    Raises CarrierError where the browser has left already.
    """

    keeps_pauses = False

    def __init__(self, connection: ServerConnection, datagrams: bool) -> None:
        self._connection, self.datagrams = connection, datagrams
        try:
            self.name = "ws://{}:{}".format(*connection.remote_address)
        except OSError as error:
            raise CarrierError(f"the browser has left: {error.strerror}") from None

    def read(self, seconds: float) -> bytes:
        """The bytes that come within some seconds. Raises CarrierError at the end, and for a message of text."""
        try:
            data = self._connection.recv(timeout=seconds)
        except TimeoutError:
            return b""
        except ConnectionClosed:
            raise CarrierError(f"{self.name}: the browser has closed the connection") from None
        if isinstance(data, str):
            self._connection.close(1003, "send bytes")
            raise CarrierError(f"{self.name}: the browser sends text")
        return data

    def write(self, data: bytes) -> None:
        """Sends bytes. Raises CarrierError."""
        try:
            self._connection.send(data)
        except ConnectionClosed:
            raise CarrierError(f"{self.name}: the browser has closed the connection") from None

    def close(self) -> None:
        """Closes the connection."""
        with suppress(OSError):
            self._connection.close()


def _link(request: Request) -> str:
    """The link that a request names, without the key after it."""
    return unquote(request.path.partition("?")[0].removeprefix("/"))


class WebServer:
    """Serves links to browsers on this machine, each at a path with its name.

    `datagrams` says of each link whether a message is a whole frame. `run` serves a connection to a link until it ends.
    Raises CarrierError if the port cannot be opened.
    """

    def __init__(self, port: int, datagrams: Mapping[str, bool], run: Callable[[str, WebSocket], None]) -> None:
        self._datagrams, self._run = datagrams, run
        self._key = secrets.token_urlsafe(9)
        try:
            self._server: Server = serve(
                self._handle,
                HOST,
                port,
                origins=ORIGINS,
                process_request=self._refusal,
                compression=None,
                server_header=None,
                close_timeout=1,
                max_size=MOST_BYTES,
            )
        except (OSError, OverflowError) as error:
            reason = getattr(error, "strerror", None) or error
            raise CarrierError(f"cannot listen on port {port}: {reason}") from None
        self.port: int = self._server.socket.getsockname()[1]
        self._connections: set[WebSocket] = set()
        self._thread = threading.Thread(target=self._server.serve_forever, daemon=True)
        self._thread.start()

    def address(self, link: str) -> str:
        """The address of a link, with the key."""
        return f"ws://{HOST}:{self.port}/{quote(link)}?key={self._key}"

    def _refusal(self, connection: ServerConnection, request: Request) -> Response | None:
        """The answer to a request for something else; None for one that may go on."""
        key = parse_qs(request.path.partition("?")[2]).get("key", [""])[0]
        if not hmac.compare_digest(key.encode(errors="surrogateescape"), self._key.encode()):
            return connection.respond(HTTPStatus.FORBIDDEN, "The address has no key, or that of another start.\n")
        if _link(request) not in self._datagrams:
            return connection.respond(HTTPStatus.NOT_FOUND, f"The links are {', '.join(self._datagrams)}.\n")
        return None

    def _handle(self, connection: ServerConnection) -> None:
        assert connection.request is not None
        link = _link(connection.request)
        try:
            carrier = WebSocket(connection, self._datagrams[link])
        except CarrierError:
            return
        self._connections.add(carrier)
        try:
            self._run(link, carrier)
        finally:
            self._connections.discard(carrier)

    def close(self) -> None:
        """Closes the server with all its connections."""
        self._server.shutdown()
        for carrier in list(self._connections):
            carrier.close()
        self._thread.join(5.0)
