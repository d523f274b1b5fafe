"""Generated codecs talk with pymodbus over sockets and lines of pseudo-terminals, as its client and as its server."""

from __future__ import annotations

import socket
import struct
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import pytest
from pymodbus.client import ModbusSerialClient, ModbusTcpClient
from pymodbus.framer import FramerType
from pymodbus.pdu.device import ModbusDeviceIdentification
from pymodbus.server import ModbusSerialServer, ModbusTcpServer
from pymodbus.simulator import DataType, SimData, SimDevice

from fieldspec.testing import simulation
from layouts import TEST_SPECS, layouts, newest
from pymodbus_server import free_port, running
from python_package import link_of, module_of
from serial_lines import SECONDS, Line, serial_line

STATION = module_of(newest(TEST_SPECS, "station"))
METERS = {layout.device.version: module_of(layout) for layout in layouts(TEST_SPECS)["wattmeter"]}
LINKS = ("tcp", "rtu", "ascii")
IDENTITY = ModbusDeviceIdentification(
    info_name={"VendorName": "Nobody", "ProductCode": "S", "MajorMinorRevision": "1.0"}
)


def big_endian(number: float) -> list[int]:
    """The words of a float, the high one first, as IEEE 754 has them."""
    return list(struct.unpack(">2H", struct.pack(">f", number)))


def simulated() -> SimDevice:
    """What pymodbus serves: all four spaces of the station."""
    coils = SimData(0, values=[False] * 32, datatype=DataType.BITS)
    inputs = SimData(0, values=[number % 3 == 0 for number in range(32)], datatype=DataType.BITS)
    counters = [word for number in range(16) for word in divmod(100000 * number + 7, 0x10000)]
    measurements = SimData(0, values=[*counters, 241, *big_endian(2.5)], datatype=DataType.REGISTERS)
    settings = SimData(0, values=[50, 1, *big_endian(0.1)], datatype=DataType.REGISTERS)
    return SimDevice(1, simdata=([coils], [inputs], [settings], [measurements]))


@contextmanager
def line_to_server(link: str, device: SimDevice) -> Iterator[Line]:
    """A line to a server of pymodbus."""
    if link == "tcp":
        port = free_port()
        with (
            running(lambda: ModbusTcpServer(device, identity=IDENTITY, address=("127.0.0.1", port))),
            socket.create_connection(("127.0.0.1", port), SECONDS) as connection,
        ):
            yield Line(connection.fileno())
        return
    framer = FramerType.RTU if link == "rtu" else FramerType.ASCII
    with (
        serial_line() as (near, path),
        running(lambda: ModbusSerialServer(device, identity=IDENTITY, framer=framer, port=path)),
    ):
        yield Line(near)


class Client:
    """Exchanges messages by the generated codec of a link."""

    def __init__(self, module: Any, link: str, line: Line) -> None:
        self.link, self.line, self.number = link_of(module, link), line, 0
        self.is_tcp = link == "tcp"

    def ask(self, request: Any) -> Any:
        """The message of the response to a request. Raises AssertionError where none comes."""
        self.number += 1
        head = {"transaction": self.number} if self.is_tcp else {}
        self.line.send(self.link.encode_request(1, request, **head))
        framer = self.link.response_framer()
        frames = framer.feed(self.line.receive())
        while not frames and (data := self.line.receive(0.1)):
            frames = framer.feed(data)
        frames = frames or framer.idle()
        assert len(frames) == 1, "no response"
        response = self.link.decode_response(frames[0], request)
        if self.is_tcp:
            assert response.transaction == self.number
        return response

    def read(self, module: Any, register: Any) -> Any:
        """The value of a register."""
        responses = [self.ask(request).message for request in module.read_requests(register)]
        return module.read_value(register, *responses)

    def write(self, module: Any, register: Any, value: Any) -> None:
        """Writes a register."""
        for request in module.write_requests(register, value):
            self.ask(request)


@pytest.mark.parametrize("link", LINKS)
def test_a_server_of_pymodbus_answers_the_generated_codec_in_all_four_spaces(link: str) -> None:
    with line_to_server(link, simulated()) as line:
        client = Client(STATION, link, line)
        assert client.read(STATION, STATION.DIGITAL_INPUTS.all) == [number % 3 == 0 for number in range(16)]
        assert client.read(STATION, STATION.FAULT) is False
        client.write(STATION, STATION.RELAYS.all, [True, False, True, True, False, False, True, False])
        client.write(STATION, STATION.RELAYS[8], True)
        client.write(STATION, STATION.RELAYS[1], False)
        client.write(STATION, STATION.ENABLE, True)
        assert client.read(STATION, STATION.RELAYS.all) == [False, False, True, True, False, False, True, True]
        assert [client.read(STATION, STATION.RELAYS[number]) for number in (1, 3, 8)] == [False, True, True]
        assert client.read(STATION, STATION.ENABLE) is True
        assert [client.read(STATION, counter) for counter in STATION.COUNTERS][:3] == [7, 100007, 200007]
        assert STATION.SUPPLY.in_unit(client.read(STATION, STATION.SUPPLY)) == pytest.approx(24.1)
        assert client.read(STATION, STATION.POWER) == 2.5
        client.write(STATION, STATION.FILTER_TIME, 75)
        client.write(STATION, STATION.LIMIT, 0.5)
        assert (client.read(STATION, STATION.FILTER_TIME), client.read(STATION, STATION.LIMIT)) == (75, 0.5)


@pytest.mark.parametrize("link", LINKS)
def test_a_server_of_pymodbus_answers_the_other_functions(link: str) -> None:
    with line_to_server(link, simulated()) as line:
        client = Client(STATION, link, line)
        client.ask(STATION.MaskWriteRegisterRequest(address=0, and_mask=0x00F2, or_mask=0x0025))
        assert client.read(STATION, STATION.FILTER_TIME) == (50 & 0xF2) | (0x25 & ~0xF2)
        request = STATION.ReadWriteRegistersRequest(read_address=0, read_word_count=2, write_address=1, values=[2])
        assert client.ask(request).message.values[1] == 2
        request = STATION.ReadDeviceIdentificationRequest(category=1, first_object=0)
        response = client.ask(request).message
        assert [(own.number, own.value) for own in response.objects] == [(0, "Nobody"), (1, "S"), (2, "1.0")]


@pytest.mark.parametrize("link", LINKS)
def test_an_exception_response_of_pymodbus_names_its_code(link: str) -> None:
    with line_to_server(link, simulated()) as line:
        reply = Client(STATION, link, line).ask(STATION.ReadRegistersRequest(address=0x300, word_count=1))
        assert reply.exception.exception_code == 2


@pytest.mark.parametrize("link", ["tcp", "rtu"])
@pytest.mark.parametrize("version", ["1", "2"])
def test_a_float_in_input_registers_is_read_in_both_word_orders(link: str, version: str) -> None:
    module = METERS[version]
    numbers = [230.1, 231.2, 229.9, 1.5, 1e-3, 16777217.0, 99.5]
    words = [big_endian(number) for number in numbers]
    own = [word for pair in words for word in (pair if version == "1" else pair[::-1])]
    bits = SimData(0, values=[False] * 16, datatype=DataType.BITS)
    holding = SimData(0, values=[0, 0], datatype=DataType.REGISTERS)
    device = SimDevice(1, simdata=([bits], [bits], [holding], [SimData(0, values=own, datatype=DataType.REGISTERS)]))
    with line_to_server(link, device) as line:
        client = Client(module, link, line)
        have = [client.read(module, register) for register in (*module.VOLTAGES, *module.CURRENTS, module.EXPORT_SHARE)]
        assert have == [struct.unpack(">f", struct.pack(">f", number))[0] for number in numbers]
        client.write(module, module.RATIO, 2.5)
        assert client.read(module, module.RATIO) == 2.5


TEXTS = ("Nobody", "S" * 200, "1.0")
"""The texts of the station's identification."""


class Server:
    """A station that keeps bits and words, served by the generated codec of a link."""

    def __init__(self, link: str, line: Line) -> None:
        self.link, self.line, self.is_tcp = link_of(STATION, link), line, link == "tcp"
        self.bits = {"coils": [0] * 32, "discrete_inputs": [number % 3 == 0 for number in range(32)]}
        self.words = {"holding_registers": [50, 1, 0, 0], "input_registers": list(range(1000, 1036))}

    def run(self, ended: threading.Event) -> None:
        """Answers requests until the event is set."""
        framer = self.link.request_framer()
        while not ended.is_set():
            for frame in framer.feed(self.line.receive(0.05)):
                self.line.send(self._answer(frame))

    def _answer(self, frame: bytes) -> bytes:
        request = self.link.decode_request(frame)
        head = {"transaction": request.transaction} if self.is_tcp else {}
        try:
            message = self._response(request.message)
        except IndexError:
            refusal = STATION.ExceptionRecord(exception_code=2)
            answer = self.link.encode_exception_response(request.unit_address, request.message.CODE, refusal, **head)
        else:
            answer = self.link.encode_response(request.unit_address, message, **head)
        assert isinstance(answer, bytes)
        return answer

    def _response(self, asked: Any) -> Any:
        name = type(asked).__name__.removesuffix("Request")
        if name in ("ReadCoils", "ReadDiscreteInputs"):
            space = self.bits["coils" if name == "ReadCoils" else "discrete_inputs"]
            bits = _cut(space, asked.address, asked.bit_count)
            return getattr(STATION, f"{name}Response")(bits=_packed(bits))
        if name in ("ReadRegisters", "ReadInputRegisters"):
            space = self.words["holding_registers" if name == "ReadRegisters" else "input_registers"]
            return getattr(STATION, f"{name}Response")(values=_cut(space, asked.address, asked.word_count))
        if name == "WriteCoil":
            self.bits["coils"][asked.address] = int(asked.value == 0xFF00)
            return STATION.WriteCoilResponse(address=asked.address, value=asked.value)
        if name == "WriteCoils":
            for place in range(asked.bit_count):
                self.bits["coils"][asked.address + place] = asked.bits[place // 8] >> place % 8 & 1
            return STATION.WriteCoilsResponse(address=asked.address, bit_count=asked.bit_count)
        if name == "WriteRegister":
            self.words["holding_registers"][asked.address] = asked.value
            return STATION.WriteRegisterResponse(address=asked.address, value=asked.value)
        if name == "ReadDeviceIdentification":
            last = asked.first_object if asked.category == 4 else 2
            objects = [
                STATION.IdentificationObject(number=number, value=TEXTS[number])
                for number in range(asked.first_object, last + 1)
            ]
            return STATION.ReadDeviceIdentificationResponse(
                category=asked.category, conformity=0x81, more_follows=0, next_object=0, objects=objects
            )
        assert name == "WriteRegisters", name
        _cut(self.words["holding_registers"], asked.address, len(asked.values))
        self.words["holding_registers"][asked.address : asked.address + len(asked.values)] = asked.values
        return STATION.WriteRegistersResponse(address=asked.address, word_count=len(asked.values))


def _cut(space: Sequence[int], address: int, count: int) -> list[int]:
    """Neighbouring bits or words. Raises IndexError where the space has not all of them."""
    if address + count > len(space):
        raise IndexError(address)
    return list(space[address : address + count])


def _packed(bits: Sequence[int]) -> list[int]:
    """Bits in bytes, written another way than in the code that is tested."""
    text = "".join(str(int(bit)) for bit in bits)
    return [int(text[at : at + 8][::-1], 2) for at in range(0, len(text), 8)]


@contextmanager
def served(link: str) -> Iterator[tuple[Any, Server]]:
    """A client of pymodbus, connected to a server of generated codecs."""
    ended = threading.Event()
    if link == "tcp":
        with socket.create_server(("127.0.0.1", 0)) as listening:
            client: Any = ModbusTcpClient("127.0.0.1", port=listening.getsockname()[1], timeout=SECONDS)
            assert client.connect()
            connection, _ = listening.accept()
            with connection:
                yield from _answering(link, Line(connection.fileno()), client, ended)
        return
    framer = FramerType.RTU if link == "rtu" else FramerType.ASCII
    with serial_line() as (near, path):
        client = ModbusSerialClient(path, framer=framer, timeout=SECONDS)
        assert client.connect()
        yield from _answering(link, Line(near), client, ended)


def _answering(link: str, line: Line, client: Any, ended: threading.Event) -> Iterator[tuple[Any, Server]]:
    server = Server(link, line)
    thread = threading.Thread(target=server.run, args=(ended,), daemon=True)
    thread.start()
    try:
        yield client, server
    finally:
        ended.set()
        thread.join(SECONDS)
        client.close()


@pytest.mark.parametrize("link", LINKS)
def test_a_client_of_pymodbus_is_served_by_the_generated_codec_in_all_four_spaces(link: str) -> None:
    with served(link) as (client, server):
        assert client.read_discrete_inputs(0, count=17, device_id=1).bits[:17] == [n % 3 == 0 for n in range(17)]
        assert not client.write_coil(8, True, device_id=1).isError()
        assert not client.write_coils(0, [True, False, True, True, False], device_id=1).isError()
        assert client.read_coils(0, count=9, device_id=1).bits[:9] == [True, False, True, True] + [False] * 4 + [True]
        assert server.bits["coils"][:9] == [1, 0, 1, 1, 0, 0, 0, 0, 1]
        assert client.read_input_registers(3, count=30, device_id=1).registers == list(range(1003, 1033))
        assert not client.write_register(0, 75, device_id=1).isError()
        assert not client.write_registers(1, [2, *big_endian(0.5)], device_id=1).isError()
        assert client.read_holding_registers(0, count=4, device_id=1).registers == [75, 2, *big_endian(0.5)]
        assert client.read_holding_registers(3, count=2, device_id=1).exception_code == 2


PRINTED = (
    ("ReadCoils", "01 0013 0013", {"address": 19, "bit_count": 19}, "01 03 CD6B05", {"bits": [0xCD, 0x6B, 5]}),
    (
        "ReadDiscreteInputs",
        "02 00C4 0016",
        {"address": 196, "bit_count": 22},
        "02 03 ACDB35",
        {"bits": [0xAC, 0xDB, 0x35]},
    ),
    (
        "ReadRegisters",
        "03 006B 0003",
        {"address": 107, "word_count": 3},
        "03 06 022B 0000 0064",
        {"values": [555, 0, 100]},
    ),
    ("ReadInputRegisters", "04 0008 0001", {"address": 8, "word_count": 1}, "04 02 000A", {"values": [10]}),
    ("WriteCoil", "05 00AC FF00", {"address": 172, "value": 0xFF00}, "05 00AC FF00", {"address": 172, "value": 0xFF00}),
    ("WriteRegister", "06 0001 0003", {"address": 1, "value": 3}, "06 0001 0003", {"address": 1, "value": 3}),
    (
        *("WriteCoils", "0F 0013 000A 02 CD01", {"address": 19, "bit_count": 10, "bits": [0xCD, 1]}),
        *("0F 0013 000A", {"address": 19, "bit_count": 10}),
    ),
    (
        *("WriteRegisters", "10 0001 0002 04 000A 0102", {"address": 1, "values": [10, 0x102]}),
        *("10 0001 0002", {"address": 1, "word_count": 2}),
    ),
    (
        *("MaskWriteRegister", "16 0004 00F2 0025", {"address": 4, "and_mask": 0xF2, "or_mask": 0x25}),
        *("16 0004 00F2 0025", {"address": 4, "and_mask": 0xF2, "or_mask": 0x25}),
    ),
    (
        "ReadWriteRegisters",
        "17 0003 0006 000E 0003 06 00FF 00FF 00FF",
        {"read_address": 3, "read_word_count": 6, "write_address": 14, "values": [255, 255, 255]},
        "17 0C 00FE 0ACD 0001 0003 000D 00FF",
        {"values": [254, 0xACD, 1, 3, 13, 255]},
    ),
)
"""The examples of the MODBUS Application Protocol Specification V1.1b3, chapter 6, without the frame around them."""


@pytest.mark.parametrize(("name", "asked", "request_values", "answered", "response_values"), PRINTED)
def test_the_examples_of_the_specification_of_modbus_are_encoded_and_decoded(
    name: str, asked: str, request_values: dict[str, Any], answered: str, response_values: dict[str, Any]
) -> None:
    link = link_of(STATION, "tcp")
    request = getattr(STATION, f"{name}Request")(**request_values)
    response = getattr(STATION, f"{name}Response")(**response_values)
    for direction, pdu, message in (("request", asked, request), ("response", answered, response)):
        body = bytes.fromhex(pdu)
        frame = struct.pack(">HHHB", 0x1501, 0, len(body) + 1, 0x11) + body
        assert getattr(link, f"encode_{direction}")(0x11, message, transaction=0x1501) == frame
        decoded = getattr(link, f"decode_{direction}")(frame)
        assert (decoded.unit_address, decoded.transaction, decoded.message) == (0x11, 0x1501, message)


def test_a_simulated_station_serves_its_bits_to_a_client_of_pymodbus() -> None:
    with simulation("station", folder=str(TEST_SPECS), ports={"tcp": "tcp://127.0.0.1:0"}) as station:
        host, _, port = station.places["tcp"].removeprefix("tcp://").rpartition(":")
        client = ModbusTcpClient(host, port=int(port), timeout=SECONDS)
        assert client.connect()
        try:
            assert not client.write_coils(0, [True, False, True], device_id=1).isError()
            assert not client.write_coil(8, True, device_id=1).isError()
            assert not client.write_coil(0, False, device_id=1).isError()
            assert client.read_coils(0, count=9, device_id=1).bits[:9] == [False, False, True] + [False] * 5 + [True]
            assert client.write_coil(0x0B, True, device_id=1).isError()
        finally:
            client.close()


def test_a_simulated_station_carries_out_the_steps_of_functions_22_and_23() -> None:
    with simulation("station", folder=str(TEST_SPECS), ports={"tcp": "tcp://127.0.0.1:0"}) as station:
        host, _, port = station.places["tcp"].removeprefix("tcp://").rpartition(":")
        client = ModbusTcpClient(host, port=int(port), timeout=SECONDS)
        assert client.connect()

        def settings() -> list[int]:
            return client.read_holding_registers(0, count=2, device_id=1).registers

        try:
            asked = {"read_address": 0, "read_count": 2, "write_address": 0, "device_id": 1}
            assert client.readwrite_registers(**asked, values=[0x0123, 1]).registers == [0x0123, 1]
            assert settings() == [0x0123, 1]
            assert not client.mask_write_register(address=0, and_mask=0xF2, or_mask=0x25, device_id=1).isError()
            assert settings() == [(0x0123 & 0xF2) | (0x25 & ~0xF2), 1]
            before = settings()
            # What cannot be written or read is refused before anything is written.
            assert client.readwrite_registers(**asked, values=[7, 3]).exception_code == 3
            assert client.readwrite_registers(**{**asked, "read_address": 0x300}, values=[7, 2]).exception_code == 2
            assert client.readwrite_registers(**{**asked, "write_address": 0x300}, values=[7, 2]).exception_code == 2
            assert client.mask_write_register(address=0, and_mask=0, or_mask=0xFFFF, device_id=1).exception_code == 3
            assert client.mask_write_register(address=0x300, and_mask=0, or_mask=0, device_id=1).exception_code == 2
            assert settings() == before
        finally:
            client.close()
