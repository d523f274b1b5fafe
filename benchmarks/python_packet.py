"""Packets with a sum in Python: build and parse one, against hand-written code and construct."""

from __future__ import annotations

from collections.abc import Iterator
from importlib.metadata import version

from peers.packet import CONSTRUCT, GripOpen
from rows import Row, printed, timed, use_generated

use_generated()

GROUP = "Python, ESC11 packet"
FRAME = bytes.fromhex("0E 00 24 F4 01 00 00 20 03 00 00 32 46 C2")
VALUES = {"address": 0, "lower": 500, "upper": 800, "speed": 50, "force": 70}


def rows() -> Iterator[Row]:
    """The rows."""
    from fieldspec_devices.esc11.v1_17 import GripOpenWithZoneRequest, serial

    def built() -> bytes:
        return serial.encode_request(0, GripOpenWithZoneRequest(500, 800, 50, 70))

    def parsed() -> object:
        return serial.decode_request(FRAME)

    def both() -> object:
        return serial.decode_request(serial.encode_request(0, GripOpenWithZoneRequest(500, 800, 50, 70)))

    def by_hand() -> object:
        return GripOpen.parse(GripOpen(0, 500, 800, 50, 70).build())

    def by_construct() -> object:
        return CONSTRUCT.parse(CONSTRUCT.build({"body": {"value": VALUES}}))

    assert built() == GripOpen(0, 500, 800, 50, 70).build() == FRAME
    assert by_construct().body.value.upper == serial.decode_request(FRAME).message.zone_limit_2 == 800
    hand = "struct, one pack and unpack, sum()"
    yield timed(GROUP, "build", built, hand, lambda: GripOpen(0, 500, 800, 50, 70).build())
    yield timed(GROUP, "parse", parsed, hand, lambda: GripOpen.parse(FRAME))
    yield timed(GROUP, "build and parse", both, hand, by_hand, at_most=1.15)
    yield timed(
        GROUP, "build and parse", both, f"construct {version('construct')}, compiled", by_construct, at_least=33
    )


if __name__ == "__main__":
    printed(rows())
