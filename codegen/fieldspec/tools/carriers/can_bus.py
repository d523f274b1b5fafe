"""CAN buses, by the drivers of python-can."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any
from urllib.parse import parse_qsl, unquote, urlsplit

from fieldspec.tools.carriers.carrier import CarrierError

if TYPE_CHECKING:
    import can

HEADER, EXTENDED, REMOTE = 8, 1 << 31, 1 << 30
"""The bytes before the data of a frame as SocketCAN has it in captures, and the flags of an identifier of 29 bits and
of a remote request.
"""

_DIGITS = 9
"""The most digits of a bit rate."""


class CanBus:
    """A CAN bus. `can://virtual/test` is the channel `test` of the interface `virtual`, both as python-can names them.

    A frame is what SocketCAN has in captures: the identifier in four bytes, the number of the data, three zeros, the
    data; none in a remote request. Frames of errors are left out.
    """

    datagrams = True
    keeps_pauses = True

    def __init__(self, url: str) -> None:
        interface, channel, bitrate = _address(url)
        try:
            import can
        except ImportError:
            raise CarrierError("CAN buses need python-can: pip install 'fieldspec[live]'") from None
        self.name = url
        options: Any = {"bitrate": bitrate} if bitrate else {}
        self._message = can.Message
        self._errors = (can.CanError, OSError, ValueError)
        try:
            self._bus: Any = can.Bus(channel, interface, **options)
        except Exception as error:  # a driver raises whatever its library does
            raise CarrierError(f"cannot open {url}: {error}") from None
        self._closing = threading.Lock()
        self._closed = False

    def read(self, seconds: float) -> bytes:
        """The frame that comes within some seconds; empty if none does. Raises CarrierError at the end."""
        if self._closed:
            raise CarrierError(f"{self.name} is closed")
        try:
            message: can.Message | None = self._bus.recv(max(seconds, 0.0))
        except self._errors as error:
            raise CarrierError(f"{self.name}: {error}") from None
        if message is None or message.is_error_frame or message.is_fd:
            return b""
        identifier = message.arbitration_id | EXTENDED * bool(message.is_extended_id)
        identifier |= REMOTE * bool(message.is_remote_frame)
        return identifier.to_bytes(4, "big") + bytes([message.dlc, 0, 0, 0]) + bytes(message.data)

    def write(self, data: bytes) -> None:
        """Sends a frame. Raises CarrierError."""
        identifier = int.from_bytes(data[:4], "big")
        message = self._message(
            arbitration_id=identifier & ~(EXTENDED | REMOTE),
            is_extended_id=bool(identifier & EXTENDED),
            is_remote_frame=bool(identifier & REMOTE),
            dlc=data[4],
            data=data[HEADER:],
        )
        try:
            self._bus.send(message, timeout=1.0)
        except self._errors as error:
            raise CarrierError(f"{self.name}: {error}") from None

    def close(self) -> None:
        """Closes the bus. A read that waits ends too."""
        with self._closing:
            if not self._closed:
                self._closed = True
                self._bus.shutdown()


def _address(url: str) -> tuple[str, str, int]:
    """The interface, the channel and the bit rate of an address; 0 without one. Raises CarrierError."""
    parts = urlsplit(url)
    channel = unquote(parts.path.removeprefix("/"))
    if not parts.netloc or not channel:
        raise CarrierError(f"{url} is not a CAN bus; write it as can://INTERFACE/CHANNEL, as in can://socketcan/can0")
    bitrate = 0
    for key, text in parse_qsl(parts.query, keep_blank_values=True):
        if key != "bitrate" or not text.isdecimal() or len(text) > _DIGITS:
            raise CarrierError(f"{url}: {key}={text} is not an option; write ?bitrate=500000")
        bitrate = int(text)
    return parts.netloc, channel, bitrate
