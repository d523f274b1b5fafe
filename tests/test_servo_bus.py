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

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.read_plan import read_plan
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of
from simulators import Unit

SERVOS: dict[float, DeviceLayout] = {1.0: newest(TEST_SPECS, "servo"), 2.0: newest(TEST_SPECS, "servo2")}
MEMORY = 0x84
BEHIND = 0x300
NO_ACCESS = 7


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
                if getattr(request.message, "address", 0) >= BEHIND:
                    refusal = self.bus.encode_exception_response(
                        1, self.module.NoData(), error=self.module.Error(NO_ACCESS)
                    )
                    os.write(self.descriptor, refusal)
                    continue
                response = self.response(request.message)
                if request.unit_address != 254:
                    error = self.module.Error(0)
                    os.write(self.descriptor, self.bus.encode_response(request.unit_address, response, error=error))

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
    port.tx_time_per_byte = 2000.0  # a loaded machine needs longer than the line
    yield request.param, servo, port
    port.closePort()
    os.close(host)
    os.close(device)


def test_the_library_pings_writes_and_reads(line: tuple[float, Servo, Any]) -> None:
    protocol, servo, port = line
    packets = sdk.PacketHandler(protocol)
    model, result, error = packets.ping(port, 1)
    assert (result, error) == (sdk.COMM_SUCCESS, 0)
    assert model == (1030 if protocol == 2.0 else 0)
    assert packets.write4ByteTxRx(port, 1, MEMORY, 0x01020304) == (sdk.COMM_SUCCESS, 0)
    assert packets.read4ByteTxRx(port, 1, MEMORY) == (0x01020304, sdk.COMM_SUCCESS, 0)
    for number in (0xFDFFFF, 0xFDFFFFFD):
        servo.memory[MEMORY : MEMORY + 4] = number.to_bytes(4, "little")
        assert packets.read4ByteTxRx(port, 1, MEMORY) == (number, sdk.COMM_SUCCESS, 0)


@pytest.mark.parametrize("line", [2.0], indirect=True)
def test_the_library_reads_the_error_of_a_status(line: tuple[float, Servo, Any]) -> None:
    _, _, port = line
    packets = sdk.PacketHandler(2.0)
    assert packets.write4ByteTxRx(port, 1, BEHIND, 5) == (sdk.COMM_SUCCESS, NO_ACCESS)
    assert "not available to target address" in packets.getRxPacketError(NO_ACCESS)


def test_a_synchronous_write_is_the_packet_of_the_library(line: tuple[float, Servo, Any]) -> None:
    protocol, servo, port = line
    group = sdk.GroupSyncWrite(port, sdk.PacketHandler(protocol), 30, 4)
    for station in (1, 2):
        assert group.addParam(station, [0xFF, 0xFF, station, 0xFD])
    assert group.txPacket() == sdk.COMM_SUCCESS
    sdk.PacketHandler(protocol).ping(port, 3)
    message = servo.requests[0].message
    assert servo.requests[0].unit_address == 254
    assert (message.address, message.size) == (30, 4)
    assert list(message.data) == [1, 0xFF, 0xFF, 1, 0xFD, 2, 0xFF, 0xFF, 2, 0xFD]


class Recorder:
    """A port that records what is written to it."""

    is_using = False

    def __init__(self) -> None:
        self.sent = b""

    def clearPort(self) -> None:
        """There is nothing to clear."""

    def setPacketTimeout(self, packet_length: int) -> None:
        """Nothing is waited for."""

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


# The control table: registers in a space of bytes.


class Simulated(Servo):
    """A simulated servo at the other end of a pair of terminals."""

    def __init__(self, layout: DeviceLayout, descriptor: int) -> None:
        super().__init__(module_of(layout), descriptor)
        self.unit = Unit(layout.device.id, "bus", folder=TEST_SPECS)

    def run(self) -> None:
        while True:
            try:
                data = os.read(self.descriptor, 4096)
            except OSError:
                return
            for frame in self.framer.feed(data):
                os.write(self.descriptor, self.unit.answer_to(frame).frame)


@pytest.fixture(params=SERVOS, ids=["protocol 1.0", "protocol 2.0"])
def simulated(request: pytest.FixtureRequest) -> Iterator[tuple[float, Simulated, Any]]:
    """The protocol, a simulated servo, and the port of dynamixel-sdk at the other end."""
    device, host = os.openpty()
    tty.setraw(device)
    tty.setraw(host)
    servo = Simulated(SERVOS[request.param], device)
    servo.start()
    port = sdk.PortHandler(os.ttyname(host))
    assert port.openPort()
    port.tx_time_per_byte = 200.0
    yield request.param, servo, port
    port.closePort()
    os.close(host)
    os.close(device)


def test_the_library_reads_and_writes_the_registers_of_a_simulated_servo(
    simulated: tuple[float, Simulated, Any],
) -> None:
    protocol, servo, port = simulated
    packets, module = sdk.PacketHandler(protocol), servo.module
    goal, size = module.GOAL_POSITION, module.GOAL_POSITION.words
    assert size == (2 if protocol == 1.0 else 4)
    write, read = (getattr(packets, f"{verb}{size}ByteTxRx") for verb in ("write", "read"))
    assert write(port, 1, goal.address, 700) == (sdk.COMM_SUCCESS, 0)
    assert read(port, 1, goal.address) == (700, sdk.COMM_SUCCESS, 0)
    assert packets.read1ByteTxRx(port, 1, module.ID.address) == (1, sdk.COMM_SUCCESS, 0)
    assert packets.read2ByteTxRx(port, 1, module.MODEL_NUMBER.address)[0] == (12 if protocol == 1.0 else 1060)
    assert packets.write1ByteTxRx(port, 1, module.ID.address, 7)[0] == sdk.COMM_SUCCESS
    assert packets.read1ByteTxRx(port, 1, module.ID.address)[0] == 7


@pytest.mark.parametrize("protocol", SERVOS)
def test_requests_for_registers_are_the_packets_of_the_library(protocol: float) -> None:
    packets = Stuffing() if protocol == 2.0 else sdk.PacketHandler(protocol)
    module, chance = module_of(SERVOS[protocol]), random.Random(3)
    for register in (entry for entry in module.REGISTERS if hasattr(entry, "words")):
        port = Recorder()
        assert packets.readTx(port, 1, register.address, register.words) == sdk.COMM_SUCCESS
        assert module.bus.encode_request(1, module.read_request(register)) == port.sent
        if register.access == "ro":
            with pytest.raises(codec_error()):
                module.write_request(register, 0)
            continue
        value = chance.randrange(*(register.ranges or ((0, 2),))[0])
        data, port = list(value.to_bytes(register.words, "little")), Recorder()
        assert packets.writeTxOnly(port, 1, register.address, len(data), data) == sdk.COMM_SUCCESS
        assert module.bus.encode_request(1, module.write_request(register, value)) == port.sent
        assert module.read_value(register, module.ReadResponse(data=data)) == value


def test_neighbouring_bytes_are_read_together_and_explained_by_their_registers() -> None:
    layout = SERVOS[2.0]
    blocks = [(block.start, block.words) for block in read_plan(layout).blocks]
    assert blocks == [(0, 10), (104, 43)]
    unit = Unit("servo2", "bus", folder=TEST_SPECS)
    unit.ask("write", address=116, data=[0xF6, 0xFF, 0xFF, 0xFF])
    request = unit.codec.encode("request", "read", {**unit.head, "address": 116, "size": 6})
    response = unit.answer_to(request).frame
    explanation = explained(layout, "bus", "response", response, "read", request)
    rows = [(row.path, row.address, row.words, row.unit, row.number) for row in explanation.registers]
    assert rows == [("goal_position", 116, 4, "byte", -10), ("realtime_tick", 120, 2, "byte", 0)]
