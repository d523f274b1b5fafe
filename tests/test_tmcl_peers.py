"""Generated codecs of TMCL talk with pytrinamic over a pseudo-terminal, as its client and as its server."""

from __future__ import annotations

import threading
from typing import Any

import pytest
from pytrinamic.connections import SerialTmclInterface
from pytrinamic.tmcl import TMCLReply, TMCLReplyStatusError, TMCLRequest, TMCLStatus

from layouts import TEST_SPECS, newest
from python_package import link_of, module_of
from serial_lines import SECONDS, Line, serial_line

MOVER = module_of(newest(TEST_SPECS, "mover"))
SERIAL = link_of(MOVER, "serial")


def answer(frame: bytes, values: dict[tuple[int, int], int]) -> bytes:
    """What a module with these axis parameters, by axis and number, answers to a request."""
    request = SERIAL.decode_request(frame)
    asked, status, number = request.message, MOVER.Status.EXECUTED, 0
    match asked:
        case MOVER.GetAxisParameterRequest() if (asked.axis, asked.number) in values:
            number = values[asked.axis, asked.number]
        case MOVER.SetAxisParameterRequest():
            values[asked.axis, asked.number] = number = asked.value
        case MOVER.RotateRightRequest():
            values[asked.axis, 2] = number = asked.value
        case MOVER.MoveToPositionRequest():
            values[asked.axis, 0] = number = asked.value
        case MOVER.StopRequest():
            values[asked.axis, 2] = 0
        case _:
            status = MOVER.Status.WRONG_TYPE
    answered = getattr(MOVER, type(asked).__name__.replace("Request", "Response"))(value=number)
    response = SERIAL.encode_response(request.unit_address, answered, host=2, status=status)
    assert isinstance(response, bytes)
    return response


def serve(line: Line, values: dict[tuple[int, int], int], ended: threading.Event) -> None:
    """Answers requests until the event is set."""
    framer = SERIAL.request_framer()
    while not ended.is_set():
        for frame in framer.feed(line.receive(0.02)):
            line.send(answer(frame, values))


def test_a_client_of_pytrinamic_is_served_by_the_generated_codec() -> None:
    values, ended = {(0, 1): -51200, (1, 4): 1500}, threading.Event()
    with serial_line() as (near, path):
        thread = threading.Thread(target=serve, args=(Line(near), values, ended), daemon=True)
        thread.start()
        client = SerialTmclInterface(path, timeout_s=SECONDS)
        assert client.get_axis_parameter(1, 0, signed=True) == -51200
        assert client.get_axis_parameter(4, 1) == 1500
        client.set_axis_parameter(2, 1, -300)
        client.move_to(0, -12345)
        client.rotate(0, 500)
        assert values == {(0, 1): -51200, (1, 4): 1500, (1, 2): -300, (0, 0): -12345, (0, 2): 500}
        client.stop(0)
        assert values[0, 2] == 0
        with pytest.raises(TMCLReplyStatusError):
            client.get_axis_parameter(99, 0)
        ended.set()
        thread.join(SECONDS)
        client.close()


def exchanged(request: Any, status: int, value: int) -> tuple[TMCLRequest, Any]:
    """The request as pytrinamic reads it, and its answer as the generated codec reads that."""
    asked = TMCLRequest.from_buffer(SERIAL.encode_request(1, request))
    reply = TMCLReply(2, asked.moduleAddress, status, asked.command, value)
    return asked, SERIAL.decode_response(bytes(reply.to_buffer()), request)


def test_requests_and_replies_are_those_of_pytrinamic() -> None:
    request = MOVER.axis.read_request(MOVER.axis.ACTUAL_POSITION, axis=1)
    asked, response = exchanged(request, TMCLStatus.SUCCESS, -51200)
    assert (asked.command, asked.commandType, asked.motorBank, asked.value) == (6, 1, 1, 0)
    assert (response.status, response.message.value) == (MOVER.Status.EXECUTED, -51200)
    request = MOVER.axis.write_request(MOVER.axis.SPEED_LIMIT, 2047, axis=0)
    asked, response = exchanged(request, TMCLStatus.INVALID_VALUE, 2047)
    assert (asked.command, asked.commandType, asked.motorBank, asked.value) == (5, 4, 0, 2047)
    assert response.status == MOVER.Status.INVALID_VALUE
    asked, _ = exchanged(MOVER.MoveToPositionRequest(kind=1, axis=1, value=-5), TMCLStatus.SUCCESS, 0)
    assert (asked.command, asked.commandType, asked.motorBank, asked.value) == (4, 1, 1, 0xFFFFFFFB)
    assert asked.checksum == TMCLRequest(1, 4, 1, 1, -5).checksum
