"""The reference codec against the manuals' frames and against another Modbus stack."""

from __future__ import annotations

import ast
from pathlib import Path

import construct
import pytest
from pymodbus.framer import FramerAscii, FramerRTU
from pymodbus.pdu import DecodePDU
from pymodbus.pdu.other_message import ReportDeviceIdResponse

import fieldspec.codec.reference
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.values import raw_values
from fieldspec.codec.reference import CodecError, codec
from fieldspec.codec.reference.parameters import data_of_value, value_of_bytes
from fieldspec.language.model.texts import Example
from layouts import SPECS, TEST_SPECS, all_layouts, newest

EXAMPLES = [
    pytest.param(layout, example, id=f"{layout.device.id}-{layout.device.version}-{example.id}")
    for layout in all_layouts()
    for example in layout.device.examples.values()
]
MODBUS = {"rtu": FramerRTU, "ascii": FramerAscii}
PDU = {
    "address": "address",
    "word_count": "count",
    "value": "registers",
    "values": "registers",
    "exception_code": "exception_code",
}
"""The names of the fields of our messages in the other stack."""

JUDGED = [param for param in EXAMPLES if param.values[0].device.id in ("tc100", "ck10") and param.values[1].message]
GLIDER = newest(TEST_SPECS, "glider-x")


@pytest.mark.parametrize(("layout", "example"), EXAMPLES)
def test_an_example_decodes_to_its_values_or_is_refused_with_its_reason(layout: DeviceLayout, example: Example) -> None:
    link = codec(layout).links[example.link]
    if example.refused:
        with pytest.raises(CodecError) as caught:
            link.decode(example.frame, example.direction, example.message)
        assert caught.value.reason == example.refused
        return
    decoded = link.decode(example.frame, example.direction, example.message)
    example_values = raw_values(layout, example)
    assert _within(example_values, {**decoded.head, **decoded.values})


def _within(expected: object, decoded: object) -> bool:
    if isinstance(expected, dict) and isinstance(decoded, dict):
        return all(name in decoded and _within(value, decoded[name]) for name, value in expected.items())
    if isinstance(expected, list) and isinstance(decoded, list):
        return len(expected) == len(decoded) and all(map(_within, expected, decoded))
    return expected == decoded


def test_all_frames_of_both_manuals_are_examples() -> None:
    printed = {
        device: sum(example.origin == "printed" for example in newest(SPECS, device).device.examples.values())
        for device in ("tc100", "esc11")
    }
    assert printed["tc100"] == 13
    assert printed["esc11"] >= 80


@pytest.mark.parametrize(("layout", "example"), JUDGED)
def test_another_modbus_stack_reads_the_same_from_a_frame(layout: DeviceLayout, example: Example) -> None:
    framer = MODBUS[example.link](DecodePDU(is_server=example.direction == "request"))
    used, pdu = framer.handleFrame(example.frame, 0, 0)
    assert used == len(example.frame)
    assert pdu is not None
    values = codec(layout).links[example.link].decode(example.frame, example.direction, example.message)
    decoded = {**values.head, **values.values}
    assert pdu.dev_id == decoded["station"]
    code = layout.messages[example.message].message.code
    assert code is not None
    assert pdu.function_code == (code | 0x80 if example.exception_response else code)
    for name, value in decoded.items():
        if name in PDU:
            pdu_value = getattr(pdu, PDU[name])
            assert pdu_value == ([value] if name == "value" else value)


def test_another_modbus_stack_reads_an_identity() -> None:
    layout = newest(SPECS, "ck10")
    example = layout.device.examples["identity-response"]
    _, pdu = MODBUS[example.link](DecodePDU(is_server=False)).handleFrame(example.frame, 0, 0)
    assert isinstance(pdu, ReportDeviceIdResponse)
    values = codec(layout).links[example.link].decode(example.frame, "response", example.message).values
    identity, state = values["server_id"], values["run_status"]
    assert (pdu.identifier, pdu.status) == (bytes([identity]), state == 0xFF)


@pytest.mark.parametrize("cut", [1, 2, 5])
def test_a_frame_that_is_cut_short_is_refused(cut: int) -> None:
    layout = newest(SPECS, "esc11")
    example = next(iter(layout.device.examples.values()))
    with pytest.raises(CodecError) as caught:
        codec(layout).links[example.link].decode(example.frame[:-cut], example.direction, example.message)
    assert caught.value.reason in ("incomplete", "wrong_length")


def test_the_made_up_devices_have_layouts() -> None:
    assert TEST_SPECS.is_dir()
    assert {layout.device.id for layout in all_layouts()} >= {"tc100", "esc11", "ck10", "hiwin-e", "widget", "glider-x"}


@pytest.mark.parametrize(
    ("data", "values"),
    [
        ("06 01 0B B8", [3000]),
        ("42 02 0B B8 FF FF", [3000, 65535]),
        ("04 01 FF FF FF FF", [-1]),
        ("02 03 FF 00 01", [-1, 0, 1]),
        ("08 01 3F C0 00 00", [1.5]),
        ("01 02 00 01", [0, 1]),
    ],
)
def test_a_choice_is_a_switch_in_the_struct_of_its_record(data: str, values: list[int | float]) -> None:
    struct = codec(GLIDER).records["read_parameter_response"]
    parsed = struct.parse(bytes.fromhex(data))
    assert list(parsed["values"]) == values
    assert struct.build(parsed) == bytes.fromhex(data)


def test_a_selector_without_a_case_cannot_be_parsed_in_the_struct_of_its_record() -> None:
    with pytest.raises(construct.ConstructError):
        codec(GLIDER).records["read_parameter_response"].parse(bytes.fromhex("03 01 00 00"))


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        ("06 02 0B B8", "wrong_measure"),
        ("06 01 0B", "incomplete"),
        ("06 01 0B B8 00", "wrong_length"),
        ("03 01 0B B8", "unknown_value"),
        ("01 01 02", "unknown_value"),
    ],
)
def test_values_that_do_not_fit_their_format_are_refused(data: str, reason: str) -> None:
    with pytest.raises(CodecError) as caught:
        codec(GLIDER).links["channel"].decode(bytes.fromhex("07 01 00" + data), "response")
    assert caught.value.reason == reason


@pytest.mark.parametrize(
    ("form", "values", "reason"),
    [(6, [65536], "out_of_range"), (2, [-129], "out_of_range"), (3, [1], "unknown_value"), (6, [], "wrong_length")],
)
def test_values_that_a_format_cannot_hold_are_not_encoded(form: int, values: list[int], reason: str) -> None:
    message = {"reference": 7, "axis": 0, "format": form, "values": values}
    with pytest.raises(CodecError) as caught:
        codec(GLIDER).links["channel"].encode("response", "read_parameter", message)
    assert caught.value.reason == reason


def test_a_frame_without_a_code_is_decoded_as_the_message_that_is_named() -> None:
    link = codec(GLIDER).links["cyclic"]
    frame = bytes.fromhex("00 03 20 00 00 00")
    assert link.decode(frame, "request", "telegram_3").values == {"control": 3, "speed_setpoint": 0x20000000}
    assert link.decode(frame, "response", "telegram_3").values == {"status": 3, "speed_actual": 0x20000000}
    with pytest.raises(CodecError) as caught:
        link.decode(frame, "request")
    assert caught.value.reason == "unknown_code"


def test_a_message_of_another_link_is_unknown() -> None:
    with pytest.raises(CodecError) as caught:
        codec(GLIDER).links["channel"].encode("request", "telegram_3", {})
    assert caught.value.reason == "unknown_code"


@pytest.mark.parametrize(("number", "size"), [(1, 3), (3, 5), (5, 6), (7, 7)])
def test_a_parameter_is_as_many_bytes_of_its_field_as_the_field_for_their_number_says(number: int, size: int) -> None:
    meter = newest(TEST_SPECS, "flowmeter")
    parameter = meter.device.parameters["settings"].numbered(number)
    field = meter.messages["read_setting"].response.named("data")
    assert parameter is not None
    assert field is not None
    data = bytes(range(0x81, 0x89))
    read = value_of_bytes(meter.device, field, parameter.value, {"size": size, "data": data})
    assert read == int.from_bytes(data[:size], "little")


DECODING = {
    *("decoded_text", "digits_bytes", "digits_number", "in_unit"),
    *("number_in", "sentinel", "text_bytes", "text_fault"),
}
"""What other decoders have of digits, texts, quantities, special values and numbers."""


def test_the_reference_shares_no_code_that_decodes() -> None:
    folder = Path(fieldspec.codec.reference.__file__).parent
    trees = [ast.parse(path.read_text("utf-8")) for path in folder.glob("*.py")]
    nodes = [node for tree in trees for node in ast.walk(tree)]
    modules = {node.module or "" for node in nodes if isinstance(node, ast.ImportFrom)}
    folders = {".".join(module.split(".")[1:3]) for module in modules if module.startswith("fieldspec.")}
    foundation = {"foundation.caches", "foundation.classes", "foundation.exhaustive"}
    assert folders <= {*foundation, "codec.layout", "language.model", "codec.reference"}
    names = {name.name for node in nodes if isinstance(node, ast.ImportFrom) for name in node.names}
    names |= {node.attr for node in nodes if isinstance(node, ast.Attribute)}
    assert names & DECODING == set()


@pytest.mark.parametrize(
    ("register", "raw", "order", "swapped", "data"),
    [
        ("target", 0x01020304, "big", False, "01 02 03 04"),
        ("target", 0x01020304, "little", False, "04 03 02 01"),
        ("target", 0x01020304, "big", True, "03 04 01 02"),
        ("serial_number", b"AB", "big", False, "41 42 00 00 00 00 00 00 00 00 00 00"),
    ],
)
def test_a_value_in_a_field_of_bytes_has_its_bytes_in_an_order(
    register: str, raw: int | bytes, order: str, swapped: bool, data: str
) -> None:
    registers = {layout.name: layout.register for layout in newest(TEST_SPECS, "widget").registers}
    assert data_of_value(registers[register].value, raw, order, swapped).hex(" ") == data
