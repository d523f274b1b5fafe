"""The vectors have the example frames as data for other codecs."""

from __future__ import annotations

import json
import re
import struct
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from pymodbus.framer import FramerAscii, FramerRTU
from pymodbus.pdu import DecodePDU

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.read_plan import read_plan
from fieldspec.codec.reference import CodecError, codec
from fieldspec.targets.vectors.backend import files
from layouts import SPECS, TEST_SPECS, layouts
from shared_results import shared

FORMAT = Path(__file__).parent.parent / "docs" / "vectors.md"
VERSIONS = {name: versions for root in (SPECS, TEST_SPECS) for name, versions in layouts(root).items()}


@cache
def texts() -> dict[str, str]:
    """The output of each device."""
    return shared("vectors", lambda: {name: next(iter(files(VERSIONS[name]).values())) for name in VERSIONS})


def text(device: str) -> str:
    return texts()[device]


@cache
def document(device: str) -> dict[str, Any]:
    vectors: dict[str, Any] = json.loads(text(device))
    return vectors


def layout_at(device: str, version: str) -> DeviceLayout:
    return next(layout for layout in VERSIONS[device] if layout.device.version == version)


VECTORS = [
    pytest.param(device, vector, id=f"{device}-{vector['id']}-{vector['versions'][0]}")
    for device in VERSIONS
    for vector in document(device)["vectors"]
]
TAKEN = [param for param in VECTORS if not param.values[1]["refused"]]


def as_json(raw: object) -> object:
    """A raw value of the reference as JSON has it."""
    if isinstance(raw, bytes):
        return raw.hex()
    if isinstance(raw, list):
        return [as_json(item) for item in raw]
    if isinstance(raw, dict):
        return {name: as_json(item) for name, item in raw.items()}
    return raw


def decoder(framer: type[FramerRTU] | type[FramerAscii], direction: str, frame: bytes) -> Any:
    """A frame as another implementation of the protocol decodes it; it verifies delimiters and checksum."""
    pdus = DecodePDU(direction == "request")
    length, station, _, data = framer(pdus).decode(frame)
    assert length == len(frame)
    pdu = pdus.decode(data)
    assert pdu is not None
    pdu.dev_id = station
    return pdu


@pytest.mark.parametrize("device", VERSIONS)
def test_the_file_is_readable_text(device: str) -> None:
    output = text(device)
    assert output.endswith("}\n")
    assert "\\u" not in output
    assert output == json.dumps(json.loads(output), ensure_ascii=False, indent=1) + "\n"


@pytest.mark.parametrize("device", VERSIONS)
def test_the_file_names_the_identity_of_each_version(device: str) -> None:
    assert document(device)["identities"] == {layout.device.version: layout.identity for layout in VERSIONS[device]}


@pytest.mark.parametrize("device", VERSIONS)
def test_every_example_of_every_version_is_there_once(device: str) -> None:
    wanted = [(layout.device.version, name) for layout in VERSIONS[device] for name in layout.device.examples]
    listing = [(version, vector["id"]) for vector in document(device)["vectors"] for version in vector["versions"]]
    assert sorted(listing) == sorted(wanted)


def test_the_format_is_documented() -> None:
    read = document("widget")["idle_reads"][0]
    keys = [*document("widget"), *document("widget")["vectors"][0], *read]
    documented = re.findall(
        r"`(\w+)`",
        "\n".join(line.split("|")[1] for line in FORMAT.read_text("utf-8").splitlines() if line.startswith("| `")),
    )
    assert documented == keys


@pytest.mark.parametrize(("device", "vector"), TAKEN)
def test_the_reference_decodes_the_right_bytes_to_the_values(device: str, vector: dict[str, Any]) -> None:
    for version in vector["versions"]:
        link = codec(layout_at(device, version)).links[vector["link"]]
        decoded = link.decode(bytes.fromhex(vector["right"]), vector["direction"], vector["message"] or "")
        shape = link.link.frame(vector["direction"])
        parts = [part for part in shape.header if part.name in decoded.head]
        head = {part.name: shape.stated_number(part, decoded.head[part.name]) for part in parts}
        assert vector["values"] == as_json({**head, **decoded.values})
        assert vector["error"] == decoded.error


@pytest.mark.parametrize(("device", "vector"), [param for param in VECTORS if param.values[1]["refused"]])
def test_the_reference_refuses_what_must_be_refused(device: str, vector: dict[str, Any]) -> None:
    link = codec(layout_at(device, vector["versions"][-1])).links[vector["link"]]
    with pytest.raises(CodecError) as caught:
        link.decode(bytes.fromhex(vector["right"]), vector["direction"], vector["message"] or "")
    assert (caught.value.reason, vector["values"]) == (vector["refused"], None)


@pytest.mark.parametrize(("device", "vector"), [param for param in TAKEN if param.values[0] in ("tc100", "ck10")])
def test_another_modbus_stack_reads_the_same(device: str, vector: dict[str, Any]) -> None:
    framer = FramerRTU if vector["link"] == "rtu" else FramerAscii
    pdu = decoder(framer, vector["direction"], bytes.fromhex(vector["right"]))
    values = vector["values"]
    assert pdu.dev_id == values["station"]
    if vector["error"]:
        assert (pdu.function_code, pdu.exception_code) == (values["function"] | 0x80, values["exception_code"])
        return
    assert pdu.function_code == values["function"]
    if "address" in values:
        assert pdu.address == values["address"]
    if "values" in values or "value" in values:
        assert pdu.registers == values.get("values", [values.get("value")])


READS = [
    pytest.param(device, read, id=f"{device}-{read['address']:04X}-{read['versions'][0]}")
    for device in VERSIONS
    for read in document(device)["idle_reads"]
]


@pytest.mark.parametrize(("device", "read"), READS)
def test_the_reference_decodes_both_frames_of_a_read(device: str, read: dict[str, Any]) -> None:
    for version in read["versions"]:
        link = codec(layout_at(device, version)).links[read["link"]]
        for direction in ("request", "response"):
            decoded = link.decode(bytes.fromhex(read[direction]["right"]), direction, read["message"])
            assert read[direction]["values"] == as_json({**decoded.head, **decoded.values})


@pytest.mark.parametrize(("device", "read"), [param for param in READS if param.values[0] in ("tc100", "ck10")])
def test_another_modbus_stack_reads_the_registers_of_an_idle_device(device: str, read: dict[str, Any]) -> None:
    framer = FramerRTU if read["link"] == "rtu" else FramerAscii
    request = decoder(framer, "request", bytes.fromhex(read["request"]["right"]))
    assert (request.address, request.count) == (read["address"], read["words"])
    response = decoder(framer, "response", bytes.fromhex(read["response"]["right"]))
    assert response.registers == read["response"]["values"]["values"]


@pytest.mark.parametrize("device", ["tc100", "ck10", "widget"])
def test_the_registers_of_every_block_of_the_read_plan_are_read(device: str) -> None:
    for layout in VERSIONS[device]:
        version = layout.device.version
        reads = [read for read in document(device)["idle_reads"] if version in read["versions"]]
        names = {name.partition("[")[0] for read in reads for name in read["registers"]}
        planned = {name.partition("[")[0] for block in read_plan(layout).blocks for name in block.names}
        assert names >= planned


# The letters that struct gives the formats of the manual's table 4.3.5.
FORMATS = {1: "?", 2: "b", 3: "h", 4: "i", 5: "B", 6: "H", 7: "I", 8: "f", 0x41: "B", 0x42: "H", 0x43: "I"}
CHANNEL = [param for param in TAKEN if param.values[1]["link"] == "parameter_channel"]


@pytest.mark.parametrize(("device", "vector"), CHANNEL)
def test_a_decoder_by_hand_reads_the_same_from_the_parameter_channel(device: str, vector: dict[str, Any]) -> None:
    frame, request = bytes.fromhex(vector["right"]), vector["direction"] == "request"
    names = ["request_reference", "request_id" if request else "response_id", "do_id", "parameter_count"]
    values: dict[str, Any] = dict(zip(names, struct.unpack(">4B", frame[:4]), strict=True))
    assert vector["error"] == bool(values[names[1]] & 0x80)
    values[names[1]] &= 0x7F
    assert vector["message"] == {1: "read_parameter", 2: "write_parameter"}.get(values[names[1]])
    rest = frame[4:]
    if request:
        address = ("attribute", "element_count", "parameter_number", "subindex")
        values |= dict(zip(address, struct.unpack(">BBHH", rest[:6]), strict=True))
        rest = rest[6:]
    if vector["error"]:
        values |= dict(zip(("format", "value_count", "error_number"), struct.unpack(">BBH", rest), strict=True))
    elif rest:
        form, count = rest[:2]
        numbers = list(struct.unpack(f">{count}{FORMATS[form]}", rest[2:]))
        values |= {"format": form, "value_count": count, "values": numbers}
    assert vector["values"] == values


CYCLIC = [
    param for param in TAKEN if param.values[0] in ("hiwin-e", "glider-x") and param.values[1]["link"] == "cyclic"
]


@pytest.mark.parametrize(("device", "vector"), CYCLIC)
def test_process_data_are_the_words_of_their_values_where_the_manual_prints_them(
    device: str, vector: dict[str, Any]
) -> None:
    message = layout_at(device, vector["versions"][0]).device.messages[vector["message"]]
    fields = message.request.fields if vector["direction"] == "request" else message.response.fields
    words: dict[int, int] = {}
    for field in fields:
        first, last = field.word_span or (0, 0)
        for number in range(first, last + 1):
            words[number] = vector["values"][field.name] >> 16 * (last - number) & 0xFFFF
    assert sorted(words) == list(range(1, len(words) + 1))
    assert vector["right"] == "".join(f"{words[number]:04x}" for number in sorted(words))


@pytest.mark.parametrize(("device", "vector"), [param for param in TAKEN if param.values[0] == "esc11"])
def test_packets_have_the_length_and_the_sum_that_their_manual_asks_for(device: str, vector: dict[str, Any]) -> None:
    frame = bytes.fromhex(vector["right"])
    assert (frame[0], frame[-1]) == (len(frame), sum(frame[:-1]) % 256)
    assert frame[1] == vector["values"]["address"]


@pytest.mark.parametrize(("device", "vector"), VECTORS)
def test_the_verdict_says_whether_print_and_right_bytes_differ(device: str, vector: dict[str, Any]) -> None:
    printed = vector["printed"]
    assert (printed is None) == (vector["origin"] == "computed" or vector["elided"] != [])
    if printed is not None and vector["printed_characters"] == vector["characters"]:
        assert (printed != vector["right"]) == (vector["verdict"] != "ok")
    if vector["verdict"] != "ok":
        assert vector["errata"]


@pytest.mark.parametrize(("device", "vector"), VECTORS)
def test_characters_are_those_of_the_right_bytes(device: str, vector: dict[str, Any]) -> None:
    link = layout_at(device, vector["versions"][0]).links[vector["link"]].link
    if link.transmission == "hex_ascii":
        assert vector["characters"].encode("ascii") == bytes.fromhex(vector["right"])
    else:
        assert vector["characters"] is None


def test_a_misprint_has_the_printed_bytes_beside_the_right_ones() -> None:
    (vector,) = [candidate for candidate in document("esc11")["vectors"] if candidate["id"] == "excite-motor-request"]
    assert (vector["printed"], vector["right"], vector["verdict"]) == ("0500310117", "0500310137", "misprint")
    assert vector["errata"] == ["excite-request-checksum"]


def test_a_frame_that_the_manual_does_not_decide_is_open() -> None:
    (vector,) = [candidate for candidate in document("esc11")["vectors"] if candidate["id"] == "reset-alarm-response"]
    assert vector["verdict"] == "open"
