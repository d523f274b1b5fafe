"""Simulated devices and generated clients of UDS talk with udsoncan over datagrams, as its server and as its client."""

from __future__ import annotations

import asyncio
import importlib
import socket
import struct
import threading
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from udsoncan import Request, Response, services
from udsoncan import client as udsoncan_client
from udsoncan.BaseService import BaseService
from udsoncan.configs import default_client_config
from udsoncan.connections import SocketConnection
from udsoncan.exceptions import NegativeResponseException

from fieldspec.testing import SimulatedDevice, simulation
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of, package, runtime
from serial_lines import SECONDS

ECU = newest(TEST_SPECS, "ecu")
MODULE = module_of(ECU)
SPEED, SPEED_LIMIT, TARGET, SERIAL_NUMBER = 0x0110, 0x0100, 0x0200, 0xF18C
VENDOR = 0xBA
"""The first code of the services of vendors, which udsoncan does not know."""

CONFIG: Any = {
    "data_identifiers": {"default": ">H", SPEED: ">H", SPEED_LIMIT: ">H", TARGET: ">i", SERIAL_NUMBER: ">8s"},
    "request_timeout": SECONDS,
    "tolerate_zero_padding": False,
}


@pytest.fixture(scope="module")
def device() -> Iterator[SimulatedDevice]:
    with simulation("ecu", ports={"datagrams": "udp://127.0.0.1:0"}, folder=str(TEST_SPECS)) as simulated:
        yield simulated


@pytest.fixture(scope="module")
def tester(device: SimulatedDevice) -> Iterator[udsoncan_client.Client]:
    """The client of udsoncan, connected to the simulated device."""
    host, _, port = device.place.removeprefix("udp://").rpartition(":")
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as end:
        end.connect((host, int(port)))
        with udsoncan_client.Client(SocketConnection(end), config={**default_client_config, **CONFIG}) as client:
            yield client


# The client of udsoncan


def test_udsoncan_changes_sessions_and_keeps_them(tester: udsoncan_client.Client) -> None:
    response = tester.change_session(services.DiagnosticSessionControl.Session.extendedDiagnosticSession)
    data = response.service_data
    assert (data.session_echo, data.p2_server_max, data.p2_star_server_max) == (3, 0.05, 5.0)
    assert tester.tester_present().positive
    assert tester.ecu_reset(1).service_data.reset_type_echo == 1
    assert tester.ecu_reset(3).service_data.reset_type_echo == 3


def test_udsoncan_reads_and_writes_data_identifiers_of_each_size(tester: udsoncan_client.Client) -> None:
    for identifier, value in ((SPEED_LIMIT, 4321), (TARGET, -123456)):
        assert tester.write_data_by_identifier(identifier, value).positive
        assert tester.read_data_by_identifier(identifier).service_data.values[identifier] == (value,)
    assert tester.read_data_by_identifier(SERIAL_NUMBER).service_data.values[SERIAL_NUMBER] == (b"\0" * 8,)


def test_udsoncan_controls_routines(tester: udsoncan_client.Client) -> None:
    started = tester.start_routine(0x0203).service_data
    assert (started.control_type_echo, started.routine_id_echo, started.routine_status_record) == (1, 0x0203, b"")
    result = tester.get_routine_result(0x0203).service_data
    assert (result.control_type_echo, result.routine_id_echo, result.routine_status_record) == (3, 0x0203, b"\0")


@pytest.mark.parametrize(
    ("call", "arguments", "service", "reason"),
    [
        ("write_data_by_identifier", (SPEED, 1), services.WriteDataByIdentifier, 0x31),
        ("write_data_by_identifier", (SPEED_LIMIT, 6001), services.WriteDataByIdentifier, 0x31),
        ("read_data_by_identifier", (0x01FE,), services.ReadDataByIdentifier, 0x31),
        ("unlock_security_access", (1,), services.SecurityAccess, 0x11),
        ("clear_dtc", (), services.ClearDiagnosticInformation, 0x11),
    ],
)
def test_udsoncan_reads_which_service_is_refused_and_why(
    tester: udsoncan_client.Client, call: str, arguments: tuple[Any, ...], service: Any, reason: int
) -> None:
    tester.config["security_algo"] = lambda level, seed, params: seed
    with pytest.raises(NegativeResponseException) as refused:
        getattr(tester, call)(*arguments)
    assert (refused.value.response.service, refused.value.response.code) == (service, reason)


# A server of udsoncan


class Controller:
    """A server whose requests and responses are those of udsoncan, on a socket for datagrams.

    `data` has the values by their identifiers. `altered` changes a response before it is sent.
    """

    def __init__(self) -> None:
        self.data = {SPEED: b"\x05\xdc", SPEED_LIMIT: b"\x0b\xb8", TARGET: b"\0\0\0\0"}
        self.altered: Callable[[bytes], list[bytes]] = lambda payload: [payload]
        self.seen: list[Request] = []
        self.address = ("", 0)

    def response(self, request: Request) -> Response:
        """What it answers."""
        service, data = request.service, request.data or b""
        identifier = int.from_bytes(data[:2], "big")
        match service:
            case services.ReadDataByIdentifier if identifier in self.data:
                return Response(service, Response.Code.PositiveResponse, data[:2] + self.data[identifier])
            case services.WriteDataByIdentifier if identifier in (SPEED_LIMIT, TARGET):
                self.data[identifier] = data[2:]
                return Response(service, Response.Code.PositiveResponse, data[:2])
            case services.DiagnosticSessionControl:
                session = bytes([request.subfunction or 0])
                return Response(service, Response.Code.PositiveResponse, session + struct.pack(">HH", 25, 500))
            case services.RoutineControl:
                control = bytes([request.subfunction or 0])
                return Response(service, Response.Code.PositiveResponse, control + data + b"\x32")
            case services.ECUReset:
                return Response(service, Response.Code.ConditionsNotCorrect)
        return Response(service, Response.Code.RequestOutOfRange)

    def serve(self, end: socket.socket) -> None:
        """Answers until it gets an empty datagram."""
        while True:
            payload, address = end.recvfrom(4096)
            if not payload:
                return
            request = Request.from_payload(payload)
            self.seen.append(request)
            for sent in self.altered(self.response(request).get_payload()):
                end.sendto(sent, address)


@pytest.fixture
def controller() -> Iterator[tuple[Controller, Any]]:
    """The server, and a transport to it."""
    served = Controller()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as end:
        end.bind(("127.0.0.1", 0))
        served.address = end.getsockname()
        thread = threading.Thread(target=served.serve, args=(end,), daemon=True)
        thread.start()
        with runtime("transports").udp(*served.address) as transport:
            yield served, transport
            transport.write(b"")
            thread.join(SECONDS)


def client_module() -> Any:
    """The module with the clients of the device."""
    return importlib.import_module(f"{package().__name__}.ecu.client")


def client_of(transport: Any, **options: Any) -> Any:
    return client_module().Client(transport, **options)


def test_a_client_reads_and_writes_parameters_of_a_server_of_udsoncan(controller: tuple[Controller, Any]) -> None:
    served, transport = controller
    client = client_of(transport)
    assert client.read_parameter(MODULE.words.SPEED) == 1500
    client.write_parameter(MODULE.words.SPEED_LIMIT, 4321)
    client.write_parameter(MODULE.longs.TARGET_POSITION, -1000)
    assert (served.data[SPEED_LIMIT], served.data[TARGET]) == (b"\x10\xe1", b"\xff\xff\xfc\x18")
    assert client.read_parameter(MODULE.longs.TARGET_POSITION) == -1000
    assert {request.service for request in served.seen} == {
        services.ReadDataByIdentifier,
        services.WriteDataByIdentifier,
    }


def test_a_client_asks_a_server_of_udsoncan(controller: tuple[Controller, Any]) -> None:
    client = client_of(controller[1])
    session = client.ask(MODULE.ChangeSessionRequest(MODULE.Session.EXTENDED)).message
    assert (session.session, session.p2, session.extended_p2) == (MODULE.Session.EXTENDED, 25, 500)
    assert client.ask(MODULE.ReadRoutineRequest(0x0203)).message.progress == 50


def test_a_client_for_asyncio_asks_a_server_of_udsoncan(controller: tuple[Controller, Any]) -> None:
    async def talk() -> None:
        transport = await runtime("transports").async_udp(*controller[0].address)
        client = client_module().AsyncClient(transport)
        assert await client.read_parameter(MODULE.words.SPEED) == 1500
        with pytest.raises(runtime("errors").RefusedError):
            await client.ask(MODULE.ResetRequest())
        transport.close()

    asyncio.run(talk())


def test_a_client_reads_negative_responses_of_udsoncan(controller: tuple[Controller, Any]) -> None:
    client = client_of(controller[1])
    for request, service, reason in (
        (MODULE.ResetRequest(), 0x11, MODULE.NegativeResponseCode.CONDITIONS_NOT_CORRECT),
        (MODULE.KeepSessionRequest(), 0x3E, MODULE.NegativeResponseCode.REQUEST_OUT_OF_RANGE),
    ):
        with pytest.raises(runtime("errors").RefusedError) as refused:
            client.ask(request)
        assert refused.value.number == reason
        assert refused.value.exception == MODULE.NegativeResponse(refused_service=service, reason=reason)


def test_a_client_does_not_take_what_answers_another_service(controller: tuple[Controller, Any]) -> None:
    served, transport = controller
    client = client_of(transport, timeout=0.1, retries=0)
    request = b"\x22\x01\x10"
    late = Response(services.TesterPresent, 0, b"\0"), Response(services.ECUReset, Response.Code.GeneralReject)
    for foreign in (request + b"\0\0", *(answer.get_payload() for answer in late)):
        served.altered = lambda payload, foreign=foreign: [foreign, payload]  # type: ignore[misc]
        assert client.read_parameter(MODULE.words.SPEED) == 1500
        served.altered = lambda payload, foreign=foreign: [foreign]  # type: ignore[misc]
        with pytest.raises(runtime("errors").NoAnswerError):
            client.read_parameter(MODULE.words.SPEED)


def test_udsoncan_refuses_the_codes_that_our_codec_refuses() -> None:
    for frame in (bytes.fromhex("2201 1005DC"), bytes.fromhex("5E")):
        with pytest.raises(codec_error()):
            MODULE.datagrams.decode_response(frame, MODULE.ReadWordRequest)
        assert not Response.from_payload(frame).valid
    with pytest.raises(codec_error()):
        MODULE.datagrams.decode_request(bytes.fromhex("62 01 10"))
    assert Request.from_payload(bytes.fromhex("62 01 10")).service is None


def test_the_codes_are_those_of_udsoncan() -> None:
    for message in (own for own in ECU.messages.values() if (own.message.code or 0) < VENDOR):
        service = BaseService.from_request_id(message.message.code)
        assert message.message.is_answered is (message.message.response_code is not None)
        assert message.message.response_code in (None, service.response_id())
    for member in MODULE.NegativeResponseCode:
        name = Response.Code.get_name(member) or ""
        assert name.replace("_", "").lower() == member.name.replace("_", "").lower()
