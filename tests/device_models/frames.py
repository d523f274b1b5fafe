"""Frames of Modbus RTU and of the packets with a sum, written by hand, and a line that does to them what lines do."""

from __future__ import annotations

import struct
from collections.abc import Callable
from dataclasses import dataclass, field

from device_models.draws import Draws


def crc(body: bytes) -> bytes:
    """CRC-16 of Modbus, the low byte first [tc100 8.4 L1970-1977, ck10 1.2 L118]."""
    check = 0xFFFF
    for byte in body:
        check ^= byte
        for _ in range(8):
            check = check >> 1 ^ (0xA001 if check & 1 else 0)
    return struct.pack("<H", check)


def with_crc(body: bytes) -> bytes:
    """A frame with its CRC."""
    return body + crc(body)


def packet(body: bytes) -> bytes:
    """A packet of the ESC11 with its sum, whose first byte is the number of all bytes [esc11 8.1 L257-268]."""
    whole = bytes([len(body) + 2]) + body
    return whole + bytes([sum(whole) & 0xFF])


@dataclass
class Exchange:
    """A request on its way: what will arrive, and when. `request` is what was sent."""

    request: bytes
    answer: bytes | None
    remaining: float
    fate: str


@dataclass
class Line:
    """Carries requests to a device and answers back, and loses, damages and delays them.

    `chance` is how likely each of the faults is. `foreign` makes an answer of another station of one of the device, and
    `alike` says whether nothing in two answers tells which request they are for: only a pause could, so a late one is
    lost then.
    `fates` are those of the next exchanges, ahead of all that is drawn. A device that is `silent` answers nothing.
    """

    draws: Draws
    answer: Callable[[bytes], bytes | None]
    foreign: Callable[[bytes], bytes]
    alike: Callable[[bytes, bytes], bool]
    latency: tuple[float, float]
    timeout: float
    chance: float = 0.0
    silent: bool = False
    fates: list[str] = field(default_factory=list)
    late: bytes | None = None

    FAULTS = ("lost request", "lost answer", "damaged", "foreign", "late")

    def send(self, request: bytes) -> Exchange:
        """Sends a request."""
        dice = self.draws.dice
        fate = "good"
        if self.fates:
            fate = self.fates.pop(0)
        elif self.silent:
            fate = "lost request"
        elif dice.random() < self.chance:
            fate = dice.choice(self.FAULTS)
        reply = None if fate == "lost request" else self.answer(request)
        delay = dice.uniform(*self.latency)
        # An answer that was late for the request before is what arrives first.
        late, self.late = self.late, None
        if late is not None and not (reply is not None and self.alike(late, reply)):
            return Exchange(request, late, min(delay, 0.001), "overtaken")
        if reply is None or fate in ("lost request", "lost answer"):
            return Exchange(request, None, self.timeout, fate)
        if fate == "late":
            self.late = reply
            return Exchange(request, None, self.timeout, fate)
        if fate == "damaged":
            index = dice.randrange(len(reply))
            reply = reply[:index] + bytes([reply[index] ^ 1 << dice.randrange(8)]) + reply[index + 1 :]
        if fate == "foreign":
            reply = self.foreign(reply)
        return Exchange(request, reply, delay, fate)
