"""What all carriers have in common."""

from __future__ import annotations

from typing import Protocol

from fieldspec.foundation.classes import dataclass


class CarrierError(OSError):
    """A carrier that cannot be opened, or that is gone. The message says which and why."""


class Carrier(Protocol):
    """A connection that reads and writes bytes."""

    name: str
    """Where the other side finds it: a path or an address."""

    datagrams: bool
    """Whether bytes come in pieces that belong together."""

    keeps_pauses: bool
    """Whether pauses between bytes come from the sender, as on a serial line. A network adds pauses of its own."""

    def read(self, seconds: float) -> bytes:
        """The bytes that come within some seconds; empty if none do. Raises CarrierError at the end."""

    def write(self, data: bytes) -> None:
        """Sends bytes. Raises CarrierError."""

    def close(self) -> None:
        """Closes the connection. A read that waits ends too."""


@dataclass(frozen=True, slots=True)
class LineSettings:
    """The settings of a serial line. `parity` is `none`, `even` or `odd`."""

    baud: int = 9600
    data_bits: int = 8
    parity: str = "none"
    stop_bits: int = 1

    @property
    def text(self) -> str:
        """`19200 baud, 8 data bits, parity none, 1 stop bit`"""
        plural = "s" * (self.stop_bits != 1)
        return f"{self.baud} baud, {self.data_bits} data bits, parity {self.parity}, {self.stop_bits} stop bit{plural}"

    def seconds(self, characters: float) -> float:
        """The seconds that a number of characters takes on the line."""
        bits = 1 + self.data_bits + (self.parity != "none") + self.stop_bits
        return characters * bits / self.baud
