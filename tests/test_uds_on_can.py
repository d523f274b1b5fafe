"""UDS in single frames of a CAN bus: udsoncan over can-isotp talks with simulated devices and generated clients."""

from __future__ import annotations

import importlib
import struct
import threading
from collections.abc import Iterator
from typing import Any

import can
import isotp
import pytest
from udsoncan import Request, Response, services
from udsoncan import client as udsoncan_client
from udsoncan.configs import default_client_config
from udsoncan.connections import PythonIsoTpConnection

from fieldspec.testing import simulation
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of, package, runtime
from serial_lines import SECONDS

MODULE = module_of(newest(TEST_SPECS, "ecu-can"))
ASKS, ANSWERS = 0x7E0, 0x7E8
SPEED_LIMIT, SPEED = 0x0100, 0x0110
CONFIG: Any = {"data_identifiers": {SPEED_LIMIT: ">H", SPEED: ">H"}, "request_timeout": SECONDS}


def layer(bus: can.BusABC, sends: int, receives: int) -> isotp.CanStack:
    """The transport of can-isotp, which sends and receives with these identifiers."""
    return isotp.CanStack(bus, address=isotp.Address(isotp.AddressingMode.Normal_11bits, txid=sends, rxid=receives))


@pytest.fixture
def tester(request: pytest.FixtureRequest) -> Iterator[udsoncan_client.Client]:
    """The client of udsoncan on the bus of a simulated device."""
    channel = request.node.name
    ports = {"bus": f"can://virtual/{channel}"}
    with (
        simulation("ecu-can", ports=ports, folder=str(TEST_SPECS)),
        can.Bus(interface="virtual", channel=channel) as bus,
    ):
        connection = PythonIsoTpConnection(layer(bus, ASKS, ANSWERS))
        with udsoncan_client.Client(connection, config={**default_client_config, **CONFIG}) as client:
            yield client


def test_udsoncan_reads_and_writes_over_single_frames(tester: udsoncan_client.Client) -> None:
    data = tester.change_session(3).service_data
    assert (data.session_echo, data.p2_server_max, data.p2_star_server_max) == (3, 0.05, 5.0)
    assert tester.write_data_by_identifier(SPEED_LIMIT, 4321).positive
    assert tester.read_data_by_identifier(SPEED_LIMIT).service_data.values == {SPEED_LIMIT: (4321,)}
    assert tester.tester_present().positive


def answer(request: Request) -> Response:
    """What a server with one data identifier answers."""
    data = request.data or b""
    if request.service is services.ReadDataByIdentifier and data == struct.pack(">H", SPEED):
        return Response(request.service, Response.Code.PositiveResponse, data + b"\x05\xdc")
    return Response(request.service, Response.Code.RequestOutOfRange)


@pytest.fixture
def client(request: pytest.FixtureRequest) -> Iterator[Any]:
    """The generated client on the bus of a server of udsoncan."""
    channel, ended = request.node.name, threading.Event()
    with can.Bus(interface="virtual", channel=channel) as theirs, can.Bus(interface="virtual", channel=channel) as bus:
        stack = layer(theirs, ANSWERS, ASKS)

        def serve() -> None:
            while not ended.wait(0.002):
                stack.process()
                if (payload := stack.recv()) is not None:
                    stack.send(answer(Request.from_payload(bytes(payload))).get_payload())

        thread = threading.Thread(target=serve, daemon=True)
        thread.start()
        transport = runtime("transports").CanTransport(bus, can.Message)
        yield importlib.import_module(f"{package().__name__}.ecu_can.client").Client(transport, timeout=SECONDS)
        ended.set()
        thread.join(SECONDS)


def test_a_client_reads_values_and_refusals_of_a_server_of_udsoncan(client: Any) -> None:
    assert client.read_parameter(MODULE.words.SPEED) == 1500
    with pytest.raises(runtime("errors").RefusedError) as refused:
        client.read_parameter(MODULE.words.SPEED_LIMIT)
    reason = MODULE.NegativeResponseCode.REQUEST_OUT_OF_RANGE
    assert refused.value.exception == MODULE.NegativeResponse(refused_service=0x22, reason=reason)


@pytest.mark.parametrize("data", ["03 22 01 10 CC CC CC CC", "04 22 01 10", "13 22 01 10", "05 62 01 10 05"])
def test_padded_and_longer_frames_are_refused(data: str) -> None:
    with pytest.raises(codec_error()):
        MODULE.bus.decode_request(MODULE.bus.frame_of(ASKS, bytes.fromhex(data)))
