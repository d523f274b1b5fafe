"""Serial ports and pseudo-terminals."""

from __future__ import annotations

import os
import re
import select
import threading

from fieldspec.foundation.classes import TYPE_CHECKING, replace
from fieldspec.tools.carriers.carrier import CarrierError, LineSettings

if TYPE_CHECKING:
    from serial import SerialBase


try:
    import termios
except ImportError:  # a system without terminals
    _ERRORS: tuple[type[Exception], ...] = (OSError,)
else:
    _ERRORS = (OSError, termios.error)
"""The errors of a port besides pyserial's errors; that for settings which a driver refuses is not an OSError."""

_PSEUDO_TERMINAL = re.compile(r"/dev/(?:pts/|ttys)[0-9]+")
"""The paths of pseudo-terminals on Linux and macOS."""


class PseudoTerminal:
    """A pseudo-terminal: another program opens `name` as if it were a serial port."""

    datagrams = False
    keeps_pauses = True

    def __init__(self) -> None:
        try:
            import pty
            import tty
        except ImportError:
            raise CarrierError("this system has no pseudo-terminals; use a serial port or tcp://HOST:PORT") from None
        self._own, self._other = pty.openpty()
        tty.setraw(self._own)
        tty.setraw(self._other)
        self.name = os.ttyname(self._other)
        self._wake, self._waker = os.pipe()
        self._closing = threading.Lock()
        self._closed = False

    def read(self, seconds: float) -> bytes:
        """The bytes that come within some seconds. Raises CarrierError at the end."""
        if self._closed:
            raise CarrierError(f"{self.name} is closed")
        ready, _, _ = select.select([self._own, self._wake], [], [], seconds)
        if self._wake in ready:
            raise CarrierError(f"{self.name} is closed")
        return os.read(self._own, 4096) if ready else b""

    def write(self, data: bytes) -> None:
        """Sends bytes."""
        while data:
            _, ready, _ = select.select([], [self._own], [], 1.0)
            if not ready:
                return  # nobody reads what the terminal holds already
            data = data[os.write(self._own, data) :]

    def close(self) -> None:
        """Closes the terminal."""
        with self._closing:
            if self._closed:
                return
            self._closed = True
        os.write(self._waker, b".")

    def release(self) -> None:
        """Closes the descriptors after the last reader."""
        for descriptor in (self._own, self._other, self._wake, self._waker):
            os.close(descriptor)


def has_line_settings(place: str) -> bool:
    """Whether a place is a serial line whose rate and parity matter: pseudo-terminals and networks have neither."""
    is_url = "://" in place and not place.startswith("rfc2217://")
    return not is_url and not _PSEUDO_TERMINAL.fullmatch(os.path.realpath(place))


class SerialPort:
    """A serial port, or whatever else pyserial opens by a URL, such as `socket://HOST:PORT` and `rfc2217://HOST:PORT`."""

    datagrams = False

    def __init__(self, url: str, settings: LineSettings) -> None:
        try:
            import serial
        except ImportError:
            raise CarrierError("serial ports need pyserial: pip install 'fieldspec[live]'") from None
        self.name = url
        self._errors: tuple[type[Exception], ...] = (serial.SerialException, ValueError, *_ERRORS)
        self.keeps_pauses = not url.startswith(("socket://", "rfc2217://"))
        if not has_line_settings(url):
            # A pseudo-terminal carries whole bytes: it has neither parity nor a size of characters, and refuses both.
            settings = replace(settings, parity="none", data_bits=8)
        parity = {"none": serial.PARITY_NONE, "even": serial.PARITY_EVEN, "odd": serial.PARITY_ODD}[settings.parity]
        try:
            self._port: SerialBase = serial.serial_for_url(
                url, settings.baud, settings.data_bits, parity, settings.stop_bits, timeout=0.0, write_timeout=5.0
            )
        except self._errors as error:
            # The text of pyserial has the port and the number of the error twice.
            number = getattr(error, "errno", None)
            if isinstance(error, ValueError) and "://" in url:
                forms = "/dev/ttyUSB0, COM3, socket://HOST:PORT, tcp://HOST:PORT, can://socketcan/can0"
                raise CarrierError(f"{url} is not a port; write one of the forms {forms}") from None
            is_file = os.path.isfile(url)
            reason = "it is a file, not a port" if is_file else os.strerror(number) if number else error
            raise CarrierError(f"cannot open {url}: {reason}") from None

    def read(self, seconds: float) -> bytes:
        """The bytes that come within some seconds. Raises CarrierError at the end."""
        try:
            self._port.timeout = seconds
            data = self._port.read(1)
            if data:
                self._port.timeout = 0.0
                data += self._port.read(4096)
        except self._errors as error:
            raise CarrierError(f"{self.name}: {error}") from None
        except (TypeError, AttributeError) as error:  # what a port raises that is closed meanwhile
            raise CarrierError(f"{self.name}: {error}") from None
        return bytes(data)

    def write(self, data: bytes) -> None:
        """Sends bytes. Raises CarrierError."""
        try:
            self._port.write(data)
            self._port.flush()
        except self._errors as error:
            raise CarrierError(f"{self.name}: {error}") from None

    def close(self) -> None:
        """Closes the port."""
        self._port.close()
