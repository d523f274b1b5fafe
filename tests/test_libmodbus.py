"""libmodbus builds every request of TC100 and CK10 and parses every response, and it answers the generated codec."""

from __future__ import annotations

import json
import threading
from collections.abc import Iterator
from functools import cache
from typing import Any

import pytest

import libmodbus
from bounded import HANGING
from layouts import SPECS, newest
from libmodbus import ModbusError
from python_package import module_of
from serial_lines import Line, serial_line

DEVICES = ("ck10", "tc100")
VECTORS = SPECS.parent / "generated" / "vectors"
FUNCTIONS = {"ck10": {3, 6, 16, 17}, "tc100": {3, 6, 16}}
STATION = 7


def crc(data: bytes) -> bytes:
    """The checksum of a frame on the line, bit by bit, as the standard describes it."""
    register = 0xFFFF
    for byte in data:
        register ^= byte
        for _ in range(8):
            register = register >> 1 ^ (0xA001 if register & 1 else 0)
    return register.to_bytes(2, "little")


def rtu(vector: dict[str, Any]) -> bytes:
    """An example frame as RTU has it: the station, the function and the body are the same in ASCII."""
    data = bytes.fromhex(vector["right"])
    if vector["link"] == "ascii":
        assert (data[:1], data[-2:]) == (b":", b"\r\n")
        data = bytes.fromhex(data[1:-4].decode())
        return data + crc(data)
    assert crc(data[:-2]) == data[-2:]
    return data


@cache
def vectors(device: str) -> dict[str, dict[str, Any]]:
    """The example frames of a device by their ids."""
    entries = json.loads((VECTORS / f"{device}.json").read_text("utf-8"))["vectors"]
    return {entry["id"]: entry for entry in entries}


def requests(device: str) -> Iterator[Any]:
    """The requests among the example frames. No stack builds those with a function that the device does not have."""
    for vector in vectors(device).values():
        if vector["direction"] == "request" and not vector["refused"]:
            yield pytest.param(device, vector, id=f"{device} {vector['id']}")


def responses(device: str) -> Iterator[Any]:
    """The responses among the example frames, each with its request."""
    for vector in vectors(device).values():
        request = vectors(device).get(vector["reply_to"] or "")
        if vector["direction"] == "response" and request is not None and not request["refused"]:
            yield pytest.param(device, request, vector, id=f"{device} {vector['id']}")


def call(context: Any, values: dict[str, Any]) -> Any:
    """Lets libmodbus carry out what the values of a request say."""
    libmodbus.checked(libmodbus.library().modbus_set_slave(context, values["station"]))
    function = values["function"]
    if function == 3:
        return libmodbus.read_registers(context, values["address"], values["word_count"])
    if function == 6:
        return libmodbus.write_register(context, values["address"], values["value"])
    if function == 16:
        return libmodbus.write_registers(context, values["address"], values["values"])
    assert function == 17
    return libmodbus.report_server_id(context)


def exchange(values: dict[str, Any], length: int, response: bytes, seconds: float = 3) -> tuple[bytes, Any]:
    """The request that libmodbus sends, of so many bytes, and its result of the response, which may be an error."""
    results: list[Any] = []
    with serial_line() as (near, path), libmodbus.stack(path, seconds) as context:
        line = Line(near)

        def run() -> None:
            try:
                results.append(call(context, values))
            except ModbusError as error:
                results.append(error)

        thread = threading.Thread(target=run, daemon=True)
        thread.start()
        sent = b""
        while len(sent) < length and (data := line.receive()):
            sent += data
        if response:
            line.send(response)
        thread.join(HANGING)
        sent += line.receive(0)
    return sent, results[0]


@pytest.mark.proof(40)
@pytest.mark.parametrize(("device", "request_vector"), [case for device in DEVICES for case in requests(device)])
def test_libmodbus_builds_the_same_request(device: str, request_vector: dict[str, Any]) -> None:
    frame = rtu(request_vector)
    sent, _ = exchange(request_vector["values"], len(frame), b"", 0.01)
    assert sent.hex() == frame.hex()


@pytest.mark.parametrize(("device", "request_vector", "vector"), [case for d in DEVICES for case in responses(d)])
def test_libmodbus_parses_the_response(device: str, request_vector: dict[str, Any], vector: dict[str, Any]) -> None:
    values, frame = vector["values"], rtu(vector)
    _, result = exchange(request_vector["values"], len(rtu(request_vector)), frame)
    if vector["error"]:
        assert isinstance(result, ModbusError)
        assert result.code == values["exception_code"]
    elif request_vector["values"]["function"] == 3:
        assert result == values["values"]
    elif request_vector["values"]["function"] == 17:
        assert result == frame[3:-2]
    else:
        assert result is None


@pytest.mark.parametrize("device", DEVICES)
def test_the_example_frames_have_every_function(device: str) -> None:
    functions = {case.values[1]["values"]["function"] for case in requests(device)}
    assert functions == FUNCTIONS[device]


def test_libmodbus_notices_a_damaged_response() -> None:
    request, response = vectors("ck10")["rtu-status-request"], rtu(vectors("ck10")["rtu-status-response"])
    damaged = bytes([*response[:5], response[5] ^ 1, *response[6:]])
    _, result = exchange(request["values"], len(rtu(request)), damaged)
    assert isinstance(result, ModbusError)


def registers(module: Any) -> Iterator[Any]:
    """All registers of a generated module, of groups each one."""
    for register in module.REGISTERS:
        yield from register if hasattr(register, "__iter__") else (register,)


def asked(module: Any, line: Line, request: Any) -> Any:
    """The message with which a station answers a request of the generated codec."""
    link = module.rtu
    line.send(link.encode_request(STATION, request))
    framer = link.response_framer()
    frames = framer.feed(line.receive())
    while not frames and (data := line.receive(1)):
        frames = framer.feed(data)
    assert len(frames) == 1, "no response"
    response = link.decode_response(frames[0], request)
    assert response.unit_address == STATION
    assert getattr(response, "exception", None) is None
    return response.message


def raw_words(register: Any, number: int) -> list[int]:
    """Words for a register that differ from those of its neighbours."""
    return [(number * 7919 + place * 31 + 1) & 0xFFFF for place in range(register.words)]


def write_and_read(module: Any, line: Line, number: int, register: Any) -> None:
    """Writes words with functions 16 and 6, and reads them by the requests that the codec makes for the register."""
    words = raw_words(register, number)
    asked(module, line, module.WriteRegistersRequest(address=register.address, values=words))
    asked(module, line, module.WriteRegisterRequest(address=register.address, value=words[0]))
    answers = [asked(module, line, request) for request in module.read_requests(register)]
    assert [word for answer in answers for word in answer.values] == words, register.name


@pytest.mark.parametrize("device", DEVICES)
def test_libmodbus_answers_reads_and_writes_of_every_register(device: str) -> None:
    module = module_of(newest(SPECS, device))
    count = 0
    with serial_line() as (near, path), libmodbus.server(path, STATION):
        for count, register in enumerate(registers(module), 1):
            write_and_read(module, Line(near), count, register)
    assert count > 50
