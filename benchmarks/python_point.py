"""The point record of CK10 in Python: decode and encode 64 bytes, against hand-written code and other libraries."""

from __future__ import annotations

from collections.abc import Iterator
from importlib.metadata import version

from peers.can import message
from peers.kaitai import encoded_bytes, reader, writer
from peers.point import CONSTRUCT, FIELDS, Bare, Checked
from rows import Row, printed, timed, use_generated

use_generated()

GROUP = "Python, CK10 point record"
VALUES = dict.fromkeys(FIELDS, 1) | {"position": -12345, "push_torque_ratio": 50, "jump_point": 10127}


def rows() -> Iterator[Row]:
    """The rows."""
    from fieldspec_devices.ck10.v1 import CheckInPosition, Point, PointCommand

    checked, bare = Checked(**VALUES), Bare(**VALUES)
    data = checked.encode()
    point = Point.decode(data)
    named = {**VALUES, "command": PointCommand(1), "check_in_position": CheckInPosition(1)}
    assert point == Point(**named)
    assert point.encode() == bare.encode() == CONSTRUCT.build(VALUES) == data

    kaitai, writing, can = reader("point"), writer("point"), message()
    assert kaitai.from_bytes(data).push_speed == can.decode(data)["push_speed"] == point.push_speed

    def decoded() -> object:
        return Point.decode(data)

    kaitai_point = writing.from_bytes(data)
    kaitai_point._read()

    def by_kaitai() -> bytes:
        return encoded_bytes(kaitai_point, 64)

    assert by_kaitai() == data

    hand, library = "struct, slotted class", f"construct {version('construct')}, compiled"
    yield timed(GROUP, "decode", decoded, hand, lambda: Bare.decode(data), at_most=1.10)
    yield timed(GROUP, "decode", decoded, library, lambda: CONSTRUCT.parse(data), at_least=9)
    peer = f"Kaitai {version('kaitaistruct')}"
    yield timed(GROUP, "decode", decoded, peer, lambda: kaitai.from_bytes(data), at_least=12)
    cantools = f"cantools {version('cantools')}"
    yield timed(GROUP, "decode", decoded, cantools, lambda: can.decode(data), at_least=5.5)
    yield timed(GROUP, "encode", point.encode, f"{hand}, same tests of ranges", checked.encode, at_most=1.10)
    yield timed(GROUP, "encode", point.encode, f"{hand}, no tests of ranges", bare.encode)
    yield timed(GROUP, "encode", point.encode, library, lambda: CONSTRUCT.build(VALUES), at_least=20)
    yield timed(GROUP, "encode", point.encode, f"{peer}, --read-write", by_kaitai, at_least=28)
    yield timed(GROUP, "encode", point.encode, cantools, lambda: can.encode(VALUES), at_least=16)


if __name__ == "__main__":
    printed(rows())
