"""CAN buses: identifiers with bits, in all codecs, and talks of a drive of CiA 402 with canopen over a virtual bus.

The objects of the drive are read and written by name; canopen is the node, and then the one that asks.
"""

from __future__ import annotations

import importlib
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import can
import canopen
import pytest
from canopen import objectdictionary as dictionary

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.explain.lines import log_line
from fieldspec.codec.explain.readings import FrameOptions, read_frame, remarks_on
from fieldspec.codec.reference.frames import codec
from fieldspec.codec.reference.records import CodecError
from fieldspec.command.rendering.explanation_text import faults
from fieldspec.language.model.escape import Escape
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of, package, runtime
from random_devices.agreement import JUDGES, Comparison, compare_layout

AXIS = newest(TEST_SPECS, "axis")
MODULE = module_of(AXIS)
OBJECTS = MODULE.objects
STATUS_REQUEST = OBJECTS.read_request(OBJECTS.STATUSWORD)
NODE = 5
TIMEOUT = 20.0
ENTRIES = {
    0x6040: ("controlword", dictionary.UNSIGNED16),
    0x6041: ("statusword", dictionary.UNSIGNED16),
    0x6060: ("mode", dictionary.INTEGER8),
    0x6061: ("mode_display", dictionary.INTEGER8),
    0x6064: ("position", dictionary.INTEGER32),
    0x607A: ("target", dictionary.INTEGER32),
}


def test_codecs_agree_on_random_frames_of_a_can_bus() -> None:
    result = Comparison()
    names = {"python", "javascript", "tcc", "explainer", "script"}
    compare_layout(AXIS, 1, 90, tuple(judge for judge in JUDGES if judge.name in names), result)
    assert result.disagreements == []
    assert set(result.asked) == names


def test_a_frame_is_an_identifier_and_data_for_drivers() -> None:
    frame = MODULE.sdo.encode_request(NODE, STATUS_REQUEST)
    record = MODULE.sdo.can_frame(frame)
    assert (record.identifier, record.data.hex(" "), record.is_extended) == (0x605, "40 41 60 00 00 00 00 00", False)
    assert MODULE.sdo.frame_of(0x605, record.data) == frame
    wide = MODULE.vehicle.can_frame(MODULE.vehicle.encode_request(0x21, MODULE.ReadHoursRequest(), priority=6))
    assert (wide.identifier, wide.data, wide.is_extended) == (0x18FEE521, b"", True)


IDENTIFIERS = [
    (((2, "big", 0, 11),), 11, "0605", 0x605),
    (((2, "little", 0, 11),), 11, "0506", 0x605),
    (((1, "big", 7, 4), (1, "big", 0, 7)), 11, "0C05", 0x605),
    (((4, "little", 8, 18), (1, "big", 0, 8)), 29, "E5FE0000 21", 0x80FEE521),
]


@pytest.mark.parametrize(("fields", "bits", "parts", "identifier"), IDENTIFIERS)
def test_an_identifier_has_its_parts_in_their_bits_and_orders(
    fields: tuple[tuple[int, str, int, int], ...], bits: int, parts: str, identifier: int
) -> None:
    escape = Escape("can", (), b"", 0, "", "", fields, bits)
    assert escape.packed(bytes.fromhex(parts)) == identifier
    assert escape.unpacked(identifier) == bytes.fromhex(parts)


def test_a_number_with_more_bits_than_its_place_is_refused() -> None:
    reference = codec(AXIS).links
    with pytest.raises(CodecError, match="function is 16"):
        reference["pdo"].encode("request", "position_data", {"function": 16, "node": 1, "controlword": 0, "target": 0})
    with pytest.raises(codec_error()):
        MODULE.vehicle.encode_exception_response(1, 1 << 18, MODULE.Reason(reason=1), priority=0)


def test_the_offset_of_an_error_counts_the_identifier_first_and_then_the_data_as_the_guide_says() -> None:
    bus = codec(newest(TEST_SPECS, "ecu-can")).links["bus"]
    frame = bytearray(newest(TEST_SPECS, "ecu-can").device.examples["speed"].frame)
    frame[8] ^= 0xFF  # byte 0 of the data, after an identifier of one u16
    with pytest.raises(CodecError) as refused:
        bus.decode(bytes(frame), "request")
    assert refused.value.offset == 2
    frame[4] = 7  # the number of data in the packet
    with pytest.raises(CodecError) as refused:
        bus.decode(bytes(frame), "request")
    assert (refused.value.reason, refused.value.offset) == ("wrong_mark", 4)


@pytest.mark.parametrize(
    ("at", "byte", "text"),
    [
        (0, 0x80, "it is not a CAN frame with an identifier of 11 bits"),
        (4, 7, "byte 4 says 7 bytes of data, but there are 8"),
        (6, 1, "the three bytes after the data length are not zero"),
    ],
)
def test_what_is_wrong_with_the_header_of_a_frame_is_said_alike(at: int, byte: int, text: str) -> None:
    frame = bytearray(MODULE.sdo.encode_request(NODE, STATUS_REQUEST))
    frame[at] = byte
    with pytest.raises(codec_error(), match=text):
        MODULE.sdo.decode_request(bytes(frame))
    with pytest.raises(CodecError, match=text):
        codec(AXIS).links["sdo"].decode(bytes(frame), "request")
    assert [row.verdict for row in explained(AXIS, "sdo", "request", bytes(frame)).rows] == [f"wrong: {text}"]


def test_the_page_of_a_device_says_which_bits_of_the_identifier_a_part_is() -> None:
    from fieldspec.targets.docs.backend import files

    pages = [text for path, text in files([AXIS]).items() if path.endswith(".md")]
    text = "\n".join(page for page in pages if isinstance(page, str))
    assert "bits 7..10" in text
    assert "the first parts are the bits 26..28, 8..25, 0..7 of an identifier with 29 bits" in text


def test_explanations_say_identifier_and_count_the_bytes_of_the_data() -> None:
    frame = MODULE.sdo.encode_request(NODE, STATUS_REQUEST)
    rows = explained(AXIS, "sdo", "request", frame).rows
    assert [(row.at, row.sent, row.path) for row in rows] == [
        ("identifier", "605", "function"),
        ("identifier", "", "node"),
        ("0", "", "command"),
        ("1", "", "index"),
        ("3", "", "subindex"),
        ("4", "", "unused"),
    ]
    wide = MODULE.vehicle.encode_request(0x21, MODULE.ReadHoursRequest(), priority=6)
    assert [(row.at, row.sent) for row in explained(AXIS, "vehicle", "request", wide).rows[:2]] == [
        ("identifier", "18FEE521"),
        ("identifier", ""),
    ]


def test_faults_name_the_identifier_or_the_byte_of_the_data() -> None:
    frame = bytearray(MODULE.sdo.encode_request(NODE, STATUS_REQUEST))
    frame[1:8] = bytes.fromhex("00 07 05 08 00 00 00")
    frame[8] = 0xFF
    (fault,) = faults(explained(AXIS, "sdo", "request", bytes(frame)))
    assert fault.startswith(
        "wrong: function in the identifier: should be one of 0x0C with 0x40 at byte 0 of the data, "
    )
    data = MODULE.PositionDataResponse(statusword=MODULE.Statusword(0x1637), position=-1000)
    frame = bytearray(MODULE.pdo.encode_response(NODE, data, function=3)[:-1])
    frame[4] = 5
    fault = next(faults(explained(AXIS, "pdo", "response", bytes(frame), "position_data")))
    assert fault == "wrong: position at byte 2 of the data: 1 byte is missing for position"
    options = FrameOptions((("pdo", "response"),))
    texts = list(remarks_on(AXIS, read_frame(AXIS, bytes(frame), options), 0, options))
    assert texts[-1] == "the data of the frame have 5 bytes; position_data response has 6"


@pytest.mark.parametrize(
    "text",
    [
        "605#4041600000000000",
        "(1436509052.249713) vcan0 605#4041600000000000",
        "  vcan0  605   [8]  40 41 60 00 00 00 00 00",
    ],
)
def test_lines_of_candump_are_frames(text: str) -> None:
    line = log_line(text, [link.link for link in AXIS.links.values()])
    assert line is not None
    assert line.frame == MODULE.sdo.encode_request(NODE, STATUS_REQUEST)


# canopen


def objects() -> dictionary.ObjectDictionary:
    """The objects of the drive, and what canopen needs to map process data."""
    result = dictionary.ObjectDictionary()
    for index, (name, kind) in ENTRIES.items():
        result.add_object(_variable(name, index, 0, kind, "ro" if index in (0x6041, 0x6061, 0x6064) else "rw"))
    speeds = dictionary.ODRecord("homing_speeds", 0x6099)
    speeds.add_member(_variable("highest", 0x6099, 0, dictionary.UNSIGNED8, "ro", 2))
    for subindex, name in ((1, "switch_search"), (2, "zero_search")):
        speeds.add_member(_variable(name, 0x6099, subindex, dictionary.UNSIGNED32, "rw"))
    result.add_object(speeds)
    for offset in (0x1400, 0x1800):
        result.add_object(dictionary.ODRecord(f"communication_{offset:x}", offset))
        result.add_object(dictionary.ODArray(f"mapping_{offset:x}", offset + 0x200))
    return result


def _variable(name: str, index: int, subindex: int, kind: int, access: str, default: int = 0) -> dictionary.ODVariable:
    variable = dictionary.ODVariable(name, index, subindex)
    variable.data_type, variable.default, variable.access_type = kind, default, access
    return variable


class Bus:
    """Two ends of a virtual CAN bus: a network of canopen, and a driver for the generated code."""

    def __init__(self, channel: str) -> None:
        self.network = canopen.Network()
        self.network.connect(interface="virtual", channel=channel)
        self.driver = can.Bus(interface="virtual", channel=channel)

    def send(self, link: Any, frame: bytes) -> None:
        """Sends a frame of the generated code."""
        record = link.can_frame(frame)
        self.driver.send(
            can.Message(arbitration_id=record.identifier, data=record.data, is_extended_id=record.is_extended)
        )

    def receive(self, link: Any) -> bytes:
        """A frame for the generated code."""
        message = self.driver.recv(TIMEOUT)
        assert message is not None
        return bytes(link.frame_of(message.arbitration_id, message.data))

    def ask(self, request: Any) -> Any:
        """The answer to a request for an object."""
        self.send(MODULE.sdo, MODULE.sdo.encode_request(NODE, request))
        return MODULE.sdo.decode_response(self.receive(MODULE.sdo), request)

    def read(self, entry: Any, subindex: int = 0) -> Any:
        """The value of an object of the node."""
        answer = self.ask(OBJECTS.read_request(entry, subindex=subindex)).message
        return OBJECTS.read_value(entry, answer, subindex)

    def write(self, entry: Any, value: Any, subindex: int = 0) -> Any:
        """The answer of the node to a write."""
        return self.ask(OBJECTS.write_request(entry, value, subindex=subindex))


@pytest.fixture
def bus(request: pytest.FixtureRequest) -> Iterator[Bus]:
    """A bus of its own for each test."""
    result = Bus(Path(request.node.nodeid).name)
    yield result
    result.network.disconnect()
    result.driver.shutdown()


def test_generated_code_reads_and_writes_the_objects_of_a_node_of_canopen_by_name(bus: Bus) -> None:
    node = bus.network.create_node(NODE, objects())
    node.sdo[0x6041].raw, node.sdo[0x6064].raw, node.sdo[0x6061].raw = 0x0237, -123456, 6
    status = bus.read(OBJECTS.STATUSWORD)
    assert (status.raw, status.operation_enabled, status.fault) == (0x0237, True, False)
    assert bus.read(OBJECTS.POSITION) == -123456
    assert bus.read(OBJECTS.MODE_DISPLAY) == MODULE.Mode.HOMING
    bus.write(OBJECTS.CONTROLWORD, MODULE.Controlword(0x0F))
    bus.write(OBJECTS.TARGET, -10)
    bus.write(OBJECTS.MODE, MODULE.Mode.PROFILE_POSITION)
    bus.write(OBJECTS.HOMING_SPEEDS, 70000, OBJECTS.HOMING_SPEEDS.index("zero_search"))
    assert [node.sdo[index].raw for index in (0x6040, 0x607A, 0x6060)] == [0x0F, -10, 1]
    assert (node.sdo[0x6099][2].raw, bus.read(OBJECTS.HOMING_SPEEDS), bus.read(OBJECTS.HOMING_SPEEDS, 2)) == (
        70000,
        2,
        70000,
    )


def test_a_value_of_another_size_is_none_of_the_object(bus: Bus) -> None:
    wide = dictionary.ObjectDictionary()
    wide.add_object(_variable("statusword", 0x6041, 0, dictionary.UNSIGNED32, "ro"))
    bus.network.create_node(NODE, wide)
    with pytest.raises(codec_error(), match="statusword has 2 bytes, not 4"):
        bus.read(OBJECTS.STATUSWORD)


def test_elements_that_can_only_be_read_are_not_written() -> None:
    for entry, subindex, name in ((OBJECTS.STATUSWORD, 0, "statusword"), (OBJECTS.HOMING_SPEEDS, 0, "homing_speeds.")):
        with pytest.raises(codec_error(), match=f"{name}.*can only be read"):
            OBJECTS.write_request(entry, 2, subindex=subindex)


@pytest.mark.parametrize(
    ("entry", "subindex", "reason"),
    [
        (OBJECTS.VELOCITY, 0, MODULE.AbortCode.UNKNOWN_OBJECT),
        (OBJECTS.HOMING_SPEEDS, 9, MODULE.AbortCode.UNKNOWN_SUBINDEX),
    ],
)
def test_what_a_node_of_canopen_aborts_is_an_exception_response(
    bus: Bus, entry: Any, subindex: int, reason: Any
) -> None:
    bus.network.create_node(NODE, objects())
    reply = bus.ask(OBJECTS.read_request(entry, subindex=subindex))
    assert (reply.unit_address, reply.code, reply.exception) == (
        NODE,
        0xC,
        MODULE.Abort(index=entry.wire_number, subindex=subindex, reason=reason),
    )


def test_a_node_of_canopen_refuses_to_write_what_can_only_be_read(bus: Bus) -> None:
    bus.network.create_node(NODE, objects())
    reply = bus.ask(MODULE.Download1Request(index=0x6099, subindex=0, data=b"\x07"))
    assert reply.exception.reason is MODULE.AbortCode.READ_ONLY


def test_canopen_raises_the_abort_of_an_exception_response(bus: Bus) -> None:
    def refuse() -> None:
        request = MODULE.sdo.decode_request(bus.receive(MODULE.sdo)).message
        reason = MODULE.AbortCode.READ_ONLY
        abort = MODULE.Abort(index=0x607A, subindex=0, reason=reason)
        assert request == OBJECTS.write_request(OBJECTS.TARGET, 1)
        bus.send(MODULE.sdo, MODULE.sdo.encode_exception_response(NODE, abort))

    drive = threading.Thread(target=refuse, daemon=True)
    drive.start()
    with pytest.raises(canopen.SdoAbortedError) as aborted:
        bus.network.add_node(NODE, objects()).sdo[0x607A].raw = 1
    drive.join(TIMEOUT)
    assert aborted.value.code == 0x06010002


def test_canopen_reads_and_writes_what_generated_code_answers(bus: Bus) -> None:
    sent: list[Any] = []

    def answer() -> None:
        status = OBJECTS.STATUSWORD.to_bytes(MODULE.Statusword(0x0237)).ljust(4, b"\0")
        position = OBJECTS.POSITION.to_bytes(-7)
        at = {"index": 0x6064, "subindex": 0}
        for response in (
            MODULE.UploadResponse(size=MODULE.UploadSize.BYTES_2, index=0x6041, subindex=0, data=status),
            MODULE.UploadResponse(size=MODULE.UploadSize.BYTES_4, data=position, **at),
            MODULE.Download4Response(index=0x607A, subindex=0),
            MODULE.Download1Response(index=0x6060, subindex=0),
        ):
            sent.append(MODULE.sdo.decode_request(bus.receive(MODULE.sdo)).message)
            bus.send(MODULE.sdo, MODULE.sdo.encode_response(NODE, response))

    drive = threading.Thread(target=answer, daemon=True)
    drive.start()
    node = bus.network.add_node(NODE, objects())
    assert (node.sdo[0x6041].raw, node.sdo[0x6064].raw) == (0x0237, -7)
    node.sdo[0x607A].raw = 100_000
    node.sdo[0x6060].raw = 8
    drive.join(TIMEOUT)
    expected = [OBJECTS.write_request(OBJECTS.TARGET, 100_000), OBJECTS.write_request(OBJECTS.MODE, 8)]
    assert sent == [OBJECTS.read_request(entry) for entry in (OBJECTS.STATUSWORD, OBJECTS.POSITION)] + expected


def test_process_data_are_those_of_canopen_both_ways(bus: Bus) -> None:
    node = bus.network.add_node(NODE, objects())
    received, sent = node.rpdo[1], node.tpdo[1]
    received.cob_id, sent.cob_id = 0x200 + NODE, 0x180 + NODE
    for index in (0x6040, 0x607A):
        received.add_variable(index)
    for index in (0x6041, 0x6064):
        sent.add_variable(index)
    received["controlword"].raw, received["target"].raw = 0x1F, -1000
    received.transmit()
    request = MODULE.pdo.decode_request(bus.receive(MODULE.pdo), MODULE.PositionDataRequest)
    assert (request.function, request.unit_address) == (4, NODE)
    assert (request.message.controlword.raw, request.message.target) == (0x1F, -1000)
    sent.enabled = True
    sent.subscribe()
    data = MODULE.PositionDataResponse(statusword=MODULE.Statusword(0x1637), position=-1000)
    timer = threading.Timer(0.1, lambda: bus.send(MODULE.pdo, MODULE.pdo.encode_response(NODE, data, function=3)))
    timer.start()
    assert sent.wait_for_reception(TIMEOUT) is not None
    assert (sent["statusword"].raw, sent["position"].raw) == (0x1637, -1000)


def test_a_generated_client_asks_a_node_of_canopen(bus: Bus) -> None:
    node = bus.network.create_node(NODE, objects())
    node.sdo[0x6064].raw = -123456
    client = importlib.import_module(f"{package().__name__}.axis.client")
    drive = client.Client(runtime("transports").CanTransport(bus.driver, can.Message), unit_address=NODE)
    bus.network.send_message(0x701, b"\x05")
    assert drive.read_parameter(OBJECTS.POSITION) == -123456
    drive.write_parameter(OBJECTS.TARGET, 77)
    drive.write_parameter(OBJECTS.HOMING_SPEEDS, 500, 1)
    assert (node.sdo[0x607A].raw, drive.read_parameter(OBJECTS.HOMING_SPEEDS, 1)) == (77, 500)
    with pytest.raises(runtime("errors").InvalidValueError, match="can only be read"):
        drive.write_parameter(OBJECTS.HOMING_SPEEDS, 2, 0)
    with pytest.raises(runtime("errors").RefusedError) as refused:
        drive.read_parameter(OBJECTS.PROFILE_VELOCITY)
    assert (refused.value.number, refused.value.exception.index) == (0x06020000, 0x6081)


def test_a_client_does_not_speak_where_nothing_says_which_identifier() -> None:
    client = importlib.import_module(f"{package().__name__}.axis.client")
    with pytest.raises(TypeError, match="link"):
        client.Client(None, link="pdo")


def test_a_node_is_started_as_canopen_starts_it(bus: Bus) -> None:
    bus.network.add_node(NODE, objects()).nmt.state = "OPERATIONAL"
    assert MODULE.nmt.decode_request(bus.receive(MODULE.nmt)).message == MODULE.StartNodeRequest(node=NODE)
