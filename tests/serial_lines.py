"""Lines between two programs: pseudo-terminals, and bytes that come and go."""

from __future__ import annotations

import os
import pty
import select
import tty
from collections.abc import Iterator
from contextlib import contextmanager

SECONDS = 60.0
"""How long a peer may take."""


class Line:
    """Bytes to and from a peer: a socket, or one end of a line."""

    def __init__(self, handle: int) -> None:
        self.handle = handle

    def send(self, data: bytes) -> None:
        """Sends all bytes."""
        os.write(self.handle, data)

    def receive(self, seconds: float = SECONDS) -> bytes:
        """The bytes that have arrived; none where nothing comes in time, or the peer is gone."""
        ready, _, _ = select.select([self.handle], [], [], seconds)
        try:
            return os.read(self.handle, 4096) if ready else b""
        except OSError:
            return b""


@contextmanager
def serial_line() -> Iterator[tuple[int, str]]:
    """One end of a line as a handle, and the path of the other end."""
    near, far = pty.openpty()
    tty.setraw(near)
    tty.setraw(far)
    try:
        yield near, os.ttyname(far)
    finally:
        os.close(near)
        os.close(far)
