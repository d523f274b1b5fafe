"""Lists of records that count the list at their end: codecs read and refuse them alike, and pymodbus judges them."""

from __future__ import annotations

import socket
from pathlib import Path
from typing import Any

import pytest
from pymodbus.pdu.device import ModbusDeviceIdentification
from pymodbus.pdu.mei_message import ReadDeviceInformationResponse
from pymodbus.server import ModbusTcpServer
from pymodbus.simulator import DataType, SimData, SimDevice

from captures.bulk import Sent, decoded, verdicts
from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.reference import CodecError, codec
from fieldspec.command.pipeline import load
from fieldspec.tools.captures.decoding import Choices
from fieldspec.tools.evidence.redaction import Redaction
from fieldspec.tools.evidence.secrets import Secrets
from layouts import SPECS, TEST_SPECS, layout_at, newest
from pymodbus_server import SECONDS, free_port, running
from python_package import codec_error, link_of, module_apart, module_of

FOLDER = Path(__file__).with_name("identified")
FILES = {path.relative_to(FOLDER).as_posix(): path.read_bytes() for path in FOLDER.rglob("*.yaml")}
FILES |= {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in SPECS.glob("protocols/*.yaml")}
TEXTS = {0: b"Nobody", 1: b"N-1", 2: b"1.0", 3: b"https://example.org"}
"""The texts of the nameplate by number."""
LAYOUT = newest(TEST_SPECS, "weigher")
CODEC = codec(LAYOUT)
BUS = link_of(module_of(LAYOUT), "bus")
HEADER = 2
"""The bytes before the data: station and function."""
CURVE = "07 0200 0005 2C31323334"
"""A curve with one point, of 1234 g."""
BODIES = {
    f"02 0103AABBCC 6300 01 {CURVE}": [[[0xAA, 0xBB, 0xCC], []], [[1234]]],
    f"00 00 07 0300 FFFF 2C303030312C30303032 {CURVE}": [[], [[1, 2], [1234]]],
    f"06 01 {CURVE}": ("wrong_measure", 0),
    f"01 0107AABBCCDDEEFF00 01 {CURVE}": ("wrong_measure", 2),
    f"01 0500 01 {CURVE}": ("unknown_value", 1),
    f"02 0101AA 01 {CURVE}": ("wrong_measure", 5),
    "00 01 07 0100 0005": ("wrong_measure", 3),
    "00 01 07 0500 0005 2C31323334": ("wrong_measure", 3),
    "00 01 07 0300 0005 2C31323334": ("incomplete", 12),
    "00 01 07 02": ("incomplete", 4),
    "00 01 08 0200 0005 2C31323334": ("wrong_const", 2),
    f"00 01 {CURVE} {CURVE} {CURVE}": ("wrong_length", 22),
    "00 01": ("incomplete", 2),
    "": ("incomplete", 0),
}
"""Data of a response with tags and curves: their values, or why and at which byte it is refused."""


@pytest.fixture(scope="module")
def nameplate() -> Any:
    """The generated module of the nameplate."""
    return module_apart(layout_at(load(FILES).devices["nameplate"], "1"), "nameplate_devices")


def frame_of(data: str) -> bytes:
    """A response of the bus with the right checksum."""
    return CODEC.links["bus"].with_checksum("response", bytes.fromhex(f"01 44 {data} 00 00"))


@pytest.mark.parametrize("data", BODIES)
def test_records_that_differ_in_size_are_read_and_refused_alike(data: str) -> None:
    frame, wanted = frame_of(data), BODIES[data]
    reasons = explained(LAYOUT, "bus", "response", frame).reasons
    (verdict,) = verdicts(decoded(LAYOUT, [Sent(0, "response", frame)], Choices("bus", "")))
    assert verdict == (reasons[0] if reasons else "ok")
    if isinstance(wanted, list):
        values = CODEC.links["bus"].decode(frame, "response").values
        message = BUS.decode_response(frame).message
        assert [tag["value"] for tag in values["tags"]] == [tag.value for tag in message.tags] == wanted[0]
        weights = [[point.weight for point in curve.points] for curve in message.curves]
        assert weights == [[point["weight"] for point in curve["points"]] for curve in values["curves"]] == wanted[1]
        assert bytes(BUS.encode_response(1, message)) == frame
        assert CODEC.links["bus"].encode("response", "read_tags", {"station": 1, **values}) == frame
        return
    reason, at = wanted
    with pytest.raises(CodecError) as expected:
        CODEC.links["bus"].decode(frame, "response")
    with pytest.raises(codec_error()) as refused:
        BUS.decode_response(frame)
    place = reason, HEADER + at
    assert (expected.value.reason, expected.value.offset) == place
    assert (refused.value.reason, refused.value.offset) == place
    assert reason in reasons


def test_an_explanation_has_each_element_where_it_is_sent() -> None:
    rows = explained(LAYOUT, "bus", "response", frame_of(next(iter(BODIES)))).rows
    places = {row.path: row.offset - HEADER for row in rows if row.kind == "field"}
    assert places["tags[0].value[2]"] == 5
    assert places["tags[1].id"] == 6
    assert places["curves[0].points[0].weight"] == 15


@pytest.mark.parametrize("data", [data for data, wanted in BODIES.items() if isinstance(wanted, list)])
def test_redaction_leaves_records_that_differ_where_they_are(data: str) -> None:
    frame = frame_of(data)
    read = CODEC.links["bus"].decode(frame, "response")
    assert Redaction(LAYOUT, Secrets()).frame("bus", "response", frame, read, {}) == frame


def test_texts_of_a_server_of_pymodbus_are_read(nameplate: Any) -> None:
    identity = ModbusDeviceIdentification(info={number: text.decode() for number, text in TEXTS.items()})
    device = SimDevice(1, simdata=[SimData(0, values=[0], datatype=DataType.REGISTERS)])
    link, port = link_of(nameplate, "tcp"), free_port()
    request = nameplate.ReadIdentificationRequest(category=2, first_object=0)
    with (
        running(lambda: ModbusTcpServer(device, identity=identity, address=("127.0.0.1", port))),
        socket.create_connection(("127.0.0.1", port), SECONDS) as connection,
    ):
        connection.sendall(link.encode_request(1, request, transaction=7))
        framer, frames = link.response_framer(), []
        while not frames:
            frames = framer.feed(connection.recv(1024))
    message = link.decode_response(frames[0], request).message
    assert {own.number: bytes(own.value) for own in message.objects if own.value} == TEXTS
    assert link.encode_response(1, message, transaction=7) == frames[0]


def test_pymodbus_reads_the_texts_that_the_generated_codec_sends(nameplate: Any) -> None:
    objects = [nameplate.Object(number=number, value=list(text)) for number, text in TEXTS.items()]
    response = nameplate.ReadIdentificationResponse(
        category=2, conformity=0x82, more_follows=0, next_object=0, objects=objects
    )
    peer = ReadDeviceInformationResponse()
    peer.decode(response.encode())
    assert (peer.number_of_objects, peer.information) == (4, TEXTS)
