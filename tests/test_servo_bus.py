"""DYNAMIXEL servos of both protocols: the packets of dynamixel-sdk, and talks with it over a pair of terminals."""

from __future__ import annotations

import os
import random
import threading
import tty
from collections.abc import Iterator
from types import ModuleType
from typing import Any

import dynamixel_sdk as sdk
import pytest

from fieldspec.layout.device import DeviceLayout
from layouts import TEST_SPECS, newest
from python_package import module_of

SERVOS: dict[float, DeviceLayout] = {1.0: newest(TEST_SPECS, "servo"), 2.0: newest(TEST_SPECS, "servo2")}
MEMORY = 0x84


class Servo(threading.Thread):
    """A servo with one memory, which answers with the generated code at the other end of a pair of terminals."""

    def __init__(self, module: ModuleType, descriptor: int) -> None:
        super().__init__(daemon=True)
        self.bus, self.module, self.descriptor = module.bus, module, descriptor
        self.framer = module.bus.request_framer()
        self.memory = bytearray(256)
        self.requests: list[Any] = []

    def run(self) -> None:
        while True:
            try:
                data = os.read(self.descriptor, 4096)
            except OSError:
                return
            for frame in self.framer.feed(data):
                request = self.bus.decode_request(frame)
                self.requests.append(request)
                response = self.response(request.message)
                if request.station != 254:
                    error = self.module.Error(0)
                    os.write(self.descriptor, self.bus.encode_response(request.station, response, error=error))

    def response(self, message: Any) -> Any:
        module = self.module
        if isinstance(message, module.PingRequest):
            has_model = "model" in module.PingResponse.__slots__
            return module.PingResponse(model=1030, firmware=38) if has_model else module.PingResponse()
        if isinstance(message, module.ReadRequest):
            return module.ReadResponse(data=list(self.memory[message.address : message.address + message.size]))
        if isinstance(message, module.WriteRequest):
            self.memory[message.address : message.address + len(message.data)] = bytes(message.data)
            return module.WriteResponse()
        return module.SyncWriteResponse()


@pytest.fixture(params=SERVOS, ids=["protocol 1.0", "protocol 2.0"])
def line(request: pytest.FixtureRequest) -> Iterator[tuple[float, Servo, Any]]:
    """The protocol, a servo, and the port of dynamixel-sdk at the other end."""
    device, host = os.openpty()
    tty.setraw(device)
    tty.setraw(host)
    servo = Servo(module_of(SERVOS[request.param]), device)
    servo.start()
    port = sdk.PortHandler(os.ttyname(host))
    assert port.openPort()
    port.tx_time_per_byte = 200.0  # a loaded machine needs longer than the line
    yield request.param, servo, port
    port.closePort()
    os.close(host)
    os.close(device)


def test_the_library_pings_writes_and_reads(line: tuple[float, Servo, Any]) -> None:
    protocol, servo, port = line
    packets = sdk.PacketHandler(protocol)
    model, result, error = packets.ping(port, 1)
    assert (result, error) == (sdk.COMM_SUCCESS, 0)
    assert protocol == 1.0 or model == 1030
    assert packets.write4ByteTxRx(port, 1, MEMORY, 0x01020304) == (sdk.COMM_SUCCESS, 0)
    assert packets.read4ByteTxRx(port, 1, MEMORY) == (0x01020304, sdk.COMM_SUCCESS, 0)
    for number in (0xFDFFFF, 0xFDFFFFFD):
        servo.memory[MEMORY : MEMORY + 4] = number.to_bytes(4, "little")
        assert packets.read4ByteTxRx(port, 1, MEMORY) == (number, sdk.COMM_SUCCESS, 0)


def test_a_synchronous_write_is_the_packet_of_the_library(line: tuple[float, Servo, Any]) -> None:
    protocol, servo, port = line
    group = sdk.GroupSyncWrite(port, sdk.PacketHandler(protocol), 30, 4)
    for station in (1, 2):
        assert group.addParam(station, [0xFF, 0xFF, station, 0xFD])
    assert group.txPacket() == sdk.COMM_SUCCESS
    sdk.PacketHandler(protocol).ping(port, 3)
    message = servo.requests[0].message
    assert servo.requests[0].station == 254
    assert (message.address, message.size) == (30, 4)
    assert list(message.data) == [1, 0xFF, 0xFF, 1, 0xFD, 2, 0xFF, 0xFF, 2, 0xFD]


class Recorder:
    """A port that records what is written to it."""

    is_using = False

    def __init__(self) -> None:
        self.sent = b""

    def clearPort(self) -> None:
        """There is nothing to clear."""

    def writePort(self, packet: list[int]) -> int:
        """Records a packet."""
        self.sent = bytes(packet)
        return len(packet)


class Stuffing(sdk.Protocol2PacketHandler):
    """The handler of protocol 2.0 that sends what its own function returns; the library drops inserted bytes there."""

    def txPacket(self, port: Recorder, txpacket: list[int]) -> int:
        """Stuffs a packet by the function of the library, adds the CRC of the library, and records it."""
        packet = b"\xff\xff\xfd\0" + bytes(self.addStuffing(txpacket))[4:]
        number = self.updateCRC(0, list(packet), len(packet) - 2)
        port.writePort(list(packet[:-2] + number.to_bytes(2, "little")))
        return int(sdk.COMM_SUCCESS)


@pytest.mark.parametrize("protocol", SERVOS)
def test_requests_are_the_packets_of_the_library(protocol: float) -> None:
    packets = Stuffing() if protocol == 2.0 else sdk.PacketHandler(protocol)
    module, chance = module_of(SERVOS[protocol]), random.Random(7)
    for _ in range(200):
        station, address = chance.randrange(253), chance.randrange(256)
        data = chance.choices((0, 1, 0x55, 0xFD, 0xFD, 0xFF, 0xFF), k=chance.randrange(1, 30))
        port = Recorder()
        assert packets.writeTxOnly(port, station, address, len(data), list(data)) == sdk.COMM_SUCCESS
        assert module.bus.encode_request(station, module.WriteRequest(address=address, data=data)) == port.sent
        assert module.bus.decode_request(port.sent).message.data == data
