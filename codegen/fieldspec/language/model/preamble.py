"""A byte before a frame, of which a sender sends some and a receiver takes more or fewer."""

from __future__ import annotations

from fieldspec.foundation.classes import dataclass


@dataclass(frozen=True, slots=True)
class Preamble:
    """The byte is sent `sent` times before each frame; a receiver takes it from `least` to `most` times."""

    byte: int
    least: int
    most: int
    sent: int

    @property
    def start(self) -> bytes:
        """The bytes of which no receiver takes fewer, which count as the beginning of the start delimiter."""
        return bytes((self.byte,)) * self.least

    @property
    def further(self) -> bytes:
        """The bytes that are sent before these."""
        return bytes((self.byte,)) * (self.sent - self.least)

    @property
    def spare(self) -> int:
        """How many bytes a receiver takes before the least ones."""
        return self.most - self.least

    def surplus(self, frame: bytes) -> int:
        """How many bytes of a frame come before the least ones."""
        return max(0, min(len(frame) - len(frame.lstrip(bytes((self.byte,)))) - self.least, self.spare))

    def text(self) -> str:
        """`5 times FF; receivers take 5 to 20`"""
        bounds = str(self.least) if self.least == self.most else f"{self.least} to {self.most}"
        return f"{self.sent} times {self.byte:02X}; receivers take {bounds}"
