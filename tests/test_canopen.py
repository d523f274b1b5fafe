"""The protocol CANopen: any object, network management, heartbeats and emergencies, with canopen over a virtual bus."""

from __future__ import annotations

import struct
import threading
from typing import Any

import canopen
import pytest
from canopen import objectdictionary as dictionary

from layouts import TEST_SPECS, newest
from python_package import module_of
from test_can import NODE, TIMEOUT, Bus, bus

__all__ = ["bus"]
NODE_LAYOUT = newest(TEST_SPECS, "node")
MODULE = module_of(NODE_LAYOUT)
KINDS = {1: dictionary.INTEGER8, 2: dictionary.UNSIGNED16, 3: dictionary.UNSIGNED24, 4: dictionary.REAL32}
BYTES = {1: b"\xfe", 2: b"\x37\x02", 3: b"\x01\x02\x03", 4: struct.pack("<f", -1.5)}


def objects() -> dictionary.ObjectDictionary:
    """An object of each size, at 2000h."""
    result = dictionary.ObjectDictionary()
    record = dictionary.ODRecord("values", 0x2000)
    for subindex, kind in KINDS.items():
        variable = dictionary.ODVariable(f"value_{subindex}", 0x2000, subindex)
        variable.data_type, variable.access_type = kind, "rw"
        record.add_member(variable)
    result.add_object(record)
    return result


def ask(bus: Bus, request: Any) -> Any:
    """The answer to a request, or the abort."""
    bus.send(MODULE.sdo, MODULE.sdo.encode_request(NODE, request))
    return MODULE.sdo.decode_response(bus.receive(MODULE.sdo), request)


@pytest.mark.proof(2)
@pytest.mark.parametrize("size", KINDS)
def test_an_object_of_any_size_is_read_and_written(bus: Bus, size: int) -> None:
    node = bus.network.create_node(NODE, objects())
    kind = getattr(MODULE, f"Download{size}Request")
    request = kind(index=0x2000, subindex=size, data=BYTES[size])
    assert isinstance(ask(bus, request).message, kind.response_type())
    assert bytes(node.sdo[0x2000][size].data) == BYTES[size]
    answer = ask(bus, MODULE.UploadRequest(index=0x2000, subindex=size)).message
    assert (answer.size.name, answer.data[:size]) == (f"BYTES_{size}", BYTES[size])


def test_an_unknown_subindex_is_aborted(bus: Bus) -> None:
    bus.network.create_node(NODE, objects())
    reply = ask(bus, MODULE.UploadRequest(index=0x2000, subindex=9))
    assert reply.exception.reason is MODULE.AbortCode.UNKNOWN_SUBINDEX


def test_the_abort_codes_are_those_of_canopen() -> None:
    assert {int(code) for code in MODULE.AbortCode} == set(canopen.SdoAbortedError.CODES)


@pytest.mark.proof(2)
@pytest.mark.parametrize("state", ["OPERATIONAL", "STOPPED", "PRE-OPERATIONAL", "RESET", "RESET COMMUNICATION"])
def test_network_management_is_what_canopen_sends(bus: Bus, state: str) -> None:
    bus.network.add_node(NODE, objects()).nmt.state = state
    request = MODULE.nmt.decode_request(bus.receive(MODULE.nmt)).message
    kinds = {
        "OPERATIONAL": MODULE.StartNodeRequest,
        "STOPPED": MODULE.StopNodeRequest,
        "PRE-OPERATIONAL": MODULE.EnterPreOperationalRequest,
        "RESET": MODULE.ResetNodeRequest,
        "RESET COMMUNICATION": MODULE.ResetCommunicationRequest,
    }
    assert request == kinds[state](node=NODE)


def test_canopen_reads_a_heartbeat_and_an_emergency(bus: Bus) -> None:
    node = bus.network.add_node(NODE, objects())
    beat = MODULE.NodeHeartbeatResponse(state=MODULE.NodeState.OPERATIONAL)
    register = MODULE.ErrorRegister(0x11)
    failure = MODULE.NodeEmergencyResponse(
        error_code=0x8130, error_register=register, manufacturer_data=[1, 2, 3, 4, 5]
    )
    emergency = threading.Timer(
        0.1, lambda: bus.send(MODULE.emergency, MODULE.emergency.encode_response(NODE, failure))
    )
    emergency.start()
    error = node.emcy.wait(0x8130, TIMEOUT)
    assert (error.code, error.register, error.data) == (0x8130, 0x11, b"\x01\x02\x03\x04\x05")
    heartbeat = threading.Timer(0.1, lambda: bus.send(MODULE.heartbeat, MODULE.heartbeat.encode_response(NODE, beat)))
    heartbeat.start()
    node.nmt.wait_for_heartbeat(TIMEOUT)
    assert node.nmt.state == "OPERATIONAL"
