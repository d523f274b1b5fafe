"""Modbus requests in Python: build and parse one with its check, against hand-written code and other libraries."""

from __future__ import annotations

from collections.abc import Iterator
from importlib.metadata import version

from peers import modbus
from peers.kaitai import encoded_bytes, reader, writer
from rows import Row, printed, timed, use_generated

use_generated()

GROUP = "Python, Modbus request"
FRAME = bytes.fromhex("01 03 10 00 00 01 80 CA")


def rows() -> Iterator[Row]:
    """The rows."""
    from pymodbus.framer import FramerRTU
    from pymodbus.pdu import DecodePDU
    from pymodbus.pdu.register_message import ReadHoldingRegistersRequest

    from fieldspec_devices.tc100.v2_0 import ReadRegistersRequest, rtu

    framer = FramerRTU(DecodePDU(True))

    def built() -> bytes:
        return rtu.encode_request(1, ReadRegistersRequest(0x1000, 1))

    def parsed() -> object:
        return rtu.decode_request(FRAME)

    def both() -> object:
        return rtu.decode_request(rtu.encode_request(1, ReadRegistersRequest(0x1000, 1)))

    def by_hand() -> object:
        return modbus.ReadRequest.parse(modbus.ReadRequest(1, 0x1000, 1).build())

    def by_position() -> object:
        return modbus.read(modbus.encoded_bytes(1, modbus.Message(0x1000, 1)))

    def by_pymodbus() -> object:
        framer.buildFrame(ReadHoldingRegistersRequest(address=0x1000, count=1, dev_id=1))
        return framer.handleFrame(FRAME, 1, 0)

    def by_construct() -> object:
        values = {"station": 1, "start": 0x1000, "count": 1}
        return modbus.CONSTRUCT.parse(modbus.CONSTRUCT.build({"body": {"value": values}}))

    assert built() == modbus.ReadRequest(1, 0x1000, 1).build() == FRAME
    assert modbus.encoded_bytes(1, modbus.Message(0x1000, 1)) == FRAME
    assert by_construct().body.value.start == 0x1000
    kaitai, writing = reader("request"), writer("request")

    def read_by_kaitai() -> object:
        request = kaitai.from_bytes(FRAME)
        if modbus.crc16(FRAME[:6]) != request.check:
            raise ValueError("CRC")
        return request

    def by_kaitai() -> object:
        request = writing()
        request.station, request.function, request.start, request.count = 1, 3, 0x1000, 1
        request.check = 0
        data = encoded_bytes(request, 8)[:6]
        frame = data + modbus.crc16(data).to_bytes(2, "little")
        parsed = writing.from_bytes(frame)
        parsed._read()
        if modbus.crc16(frame[:6]) != parsed.check:
            raise ValueError("CRC")
        return frame, parsed

    assert by_kaitai()[0] == FRAME
    hand = "struct, CRC by a loop over 256 entries"
    yield timed(GROUP, "build", built, hand, lambda: modbus.ReadRequest(1, 0x1000, 1).build())
    yield timed(GROUP, "parse", parsed, hand, lambda: modbus.ReadRequest.parse(FRAME))
    yield timed(GROUP, "build and parse", both, hand, by_hand, at_most=0.55)
    position = "the least by hand"
    yield timed(GROUP, "build and parse", both, position, by_position)
    yield timed(GROUP, "build and parse", both, f"pymodbus {version('pymodbus')}", by_pymodbus, at_least=8)
    yield timed(
        GROUP, "build and parse", both, f"construct {version('construct')}, compiled", by_construct, at_least=30
    )
    peer = f"Kaitai {version('kaitaistruct')}"
    yield timed(GROUP, "build and parse", both, f"{peer}, --read-write, CRC by hand", by_kaitai, at_least=13)
    yield timed(GROUP, "parse", parsed, f"{peer}, a class that only reads, CRC by hand", read_by_kaitai)


if __name__ == "__main__":
    printed(rows())
