"""A packet that opens a gripper within a zone: length, address, command, two positions, speed, force, and the sum."""

from __future__ import annotations

import struct

import construct as c

WHOLE = struct.Struct("<BBBiiBBB")
BODY = struct.Struct("<BBBiiBB")
SUMS = [bytes([byte]) for byte in range(256)]


class GripOpen:
    """The packet, by hand: one pack or unpack, the sum by `sum`, and the same tests as the generated one has."""

    __slots__ = ("address", "force", "lower", "speed", "upper")

    def __init__(self, address: int, lower: int, upper: int, speed: int, force: int) -> None:
        self.address = address
        self.lower = lower
        self.upper = upper
        self.speed = speed
        self.force = force

    def build(self) -> bytes:
        """The frame."""
        if not 0 <= self.address <= 15:
            raise ValueError(f"address is {self.address}")
        if not -134217727 <= self.lower <= 134217727:
            raise ValueError(f"lower is {self.lower}")
        if not -134217727 <= self.upper <= 134217727:
            raise ValueError(f"upper is {self.upper}")
        if not 0 <= self.speed <= 100:
            raise ValueError(f"speed is {self.speed}")
        if not 0 <= self.force <= 100:
            raise ValueError(f"force is {self.force}")
        data = BODY.pack(14, self.address, 0x24, self.lower, self.upper, self.speed, self.force)
        return data + SUMS[sum(data) & 255]

    @classmethod
    def parse(cls, frame: bytes) -> GripOpen:
        """The packet of a frame."""
        if len(frame) != 14:
            raise ValueError(f"{len(frame)} bytes")
        length, address, command, lower, upper, speed, force, check = WHOLE.unpack(frame)
        if length != 14 or command != 0x24:
            raise ValueError(f"length {length}, command {command}")
        if sum(frame) - check & 255 != check:
            raise ValueError("sum")
        return cls(address, lower, upper, speed, force)


CONSTRUCT = c.Struct(
    "body"
    / c.RawCopy(
        c.Struct(
            "length" / c.Const(14, c.Int8ub),
            "address" / c.Int8ub,
            "command" / c.Const(0x24, c.Int8ub),
            "lower" / c.Int32sl,
            "upper" / c.Int32sl,
            "speed" / c.Int8ub,
            "force" / c.Int8ub,
        )
    ),
    "check" / c.Checksum(c.Int8ub, lambda data: sum(data) & 255, c.this.body.data),
).compile()
