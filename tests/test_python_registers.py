"""The generated registers, tables and parameters: addresses, values, and the requests that read and write them."""

from __future__ import annotations

import struct
from typing import Any

import pytest

from fieldspec.codec.layout.device import device_layout
from fieldspec.language.reading.project import read
from fieldspec.targets.python.backend import PACKAGE, files
from layouts import SPECS, TEST_SPECS, layouts, newest
from python_package import codec_error, module_of

WIDGET, GADGET, GIZMO = (module_of(newest(TEST_SPECS, name)) for name in ("widget", "gadget", "gizmo"))
TC100, ESC11 = module_of(newest(SPECS, "tc100")), module_of(newest(SPECS, "esc11"))
CK10, GLIDER = module_of(newest(SPECS, "ck10")), module_of(newest(TEST_SPECS, "glider-x"))
CodecError = codec_error()


@pytest.mark.parametrize(
    ("register", "data", "value"),
    [
        (WIDGET.STATUS_WORD, "8021", WIDGET.Status(0x8021)),
        (WIDGET.POSITION, "FFFFFF9C", -100),
        (WIDGET.ALARM_HISTORY[1], "0001", WIDGET.Alarm.OVERLOAD),
        (WIDGET.ALARM_HISTORY[16], "7777", 0x7777),
        (WIDGET.RATIO, "3FC00000", 1.5),
        (WIDGET.MOVING, "0001", True),
        (WIDGET.UPTIME, "00000000FFFFFFFF", 0xFFFFFFFF),
        (WIDGET.SERIAL_NUMBER, "414243000000000000000000", "ABC"),
        (WIDGET.KEY, "00FF00FF", b"\0\xff\0\xff"),
        (WIDGET.LAMP, "0005", WIDGET.Color.BLUE),
        (WIDGET.LIMIT, "7FFF", 0x7FFF),
        (WIDGET.BALANCE, "FFFFFFFFFFFFFFFE", -2),
        (WIDGET.OUTPUT[3], "80000000", -(2**31)),
        (WIDGET.START, "0001", 1),
        (WIDGET.DIRECTION, "FFFF", WIDGET.Direction.BACKWARDS),
        (WIDGET.WIDE, "80000001", WIDGET.WideStatus(first=True, last=True)),
        (GADGET.ACTUAL, "56781234", 0x12345678),
        (GADGET.TOTAL, "0004000300020001", 0x0001000200030004),
        (GADGET.RATIO, "00003FC0", 1.5),
        (GADGET.BALANCES[1], "FFFEFFFFFFFFFFFF", -2),
        (GADGET.WHOLLY_LITTLE, "78563412", 0x12345678),
        (GIZMO.SPEED, "FEFF", -2),
        (GIZMO.PLACE, "34127856", 0x12345678),
        (GIZMO.ID, "616263000000", "abc"),
    ],
    ids=lambda register: getattr(register, "name", None),
)
def test_a_register_holds_its_value_in_its_bytes(register: Any, data: str, value: Any) -> None:
    assert register.decode(bytes.fromhex(data)) == value
    assert type(register.decode(bytes.fromhex(data))) is type(value)
    assert register.encode(value) == bytes.fromhex(data)
    assert register.from_words(register.to_words(value)) == value


@pytest.mark.parametrize(
    ("register", "value", "reason"),
    [
        (WIDGET.TARGET, 1000000, "out_of_range"),
        (WIDGET.TARGET, "1", "wrong_type"),
        (WIDGET.LIMIT, 0, "out_of_range"),
        (WIDGET.LAMP, 9, "unknown_value"),
        (WIDGET.START, 2, "wrong_const"),
        (WIDGET.PAINT, 2, "unknown_value"),
        (WIDGET.INITIALIZATION, 4, "out_of_range"),
        (WIDGET.MOVING, 2, "out_of_range"),
        (WIDGET.SERIAL_NUMBER, "thirteen chars", "wrong_length"),
        (WIDGET.SERIAL_NUMBER, "é", "unknown_value"),
        (WIDGET.KEY, b"", "wrong_length"),
        (WIDGET.STATUS_WORD, 5, "wrong_type"),
        (WIDGET.RATIO, 1e39, "out_of_range"),
    ],
)
def test_a_register_refuses_what_it_cannot_hold(register: Any, value: Any, reason: str) -> None:
    with pytest.raises(CodecError) as caught:
        register.encode(value)
    assert caught.value.reason == reason
    assert register.name in caught.value.detail


@pytest.mark.parametrize(
    ("register", "data", "reason"),
    [
        (WIDGET.LAMP, "0009", "unknown_value"),
        (WIDGET.MOVING, "0002", "unknown_value"),
        (WIDGET.POSITION, "0000", "incomplete"),
        (WIDGET.POSITION, "0000000000", "wrong_length"),
        (WIDGET.SERIAL_NUMBER, "FF" * 12, "unknown_value"),
    ],
)
def test_a_register_refuses_bytes_that_mean_nothing(register: Any, data: str, reason: str) -> None:
    with pytest.raises(CodecError) as caught:
        register.decode(bytes.fromhex(data))
    assert caught.value.reason == reason


@pytest.mark.parametrize(
    ("register", "data", "value"),
    [
        (WIDGET.START, "0000", 0),
        (WIDGET.START, "0001", 1),
        (WIDGET.START, "FFFF", 0xFFFF),
        (WIDGET.PAINT, "0001", 1),
        (WIDGET.PAINT, "0002", 2),
        (WIDGET.INITIALIZATION, "0010", 16),
    ],
)
def test_what_starts_an_action_reads_as_the_device_answers(register: Any, data: str, value: int) -> None:
    assert register.decode(bytes.fromhex(data)) == value


def test_a_table_with_a_field_that_can_only_be_read_is_not_written_as_a_whole() -> None:
    slot = WIDGET.slots[1].decode(bytes.fromhex("0003 0001"))
    assert (slot.level, slot.reached) == (3, 1)
    with pytest.raises(CodecError) as caught:
        WIDGET.slots.write_requests(1, WIDGET.Slot(level=5, reached=0))
    assert caught.value.reason == "read_only"


def test_the_range_of_writing_of_a_field_binds_what_is_encoded() -> None:
    assert WIDGET.Slot(level=5, reached=0).encode() == bytes.fromhex("0005 0000")
    with pytest.raises(CodecError) as caught:
        WIDGET.Slot(level=3, reached=0).encode()
    assert (caught.value.reason, "0, 5..9" in caught.value.detail) == ("out_of_range", True)


def test_a_register_knows_its_facts() -> None:
    target = WIDGET.TARGET
    assert (target.address, target.words, target.access, target.unit) == (0x2001, 2, "rw", "mm")
    assert (target.ranges, target.scale, target.offset) == (((-999999, 999999),), 0.01, 0)
    assert (WIDGET.TEMPERATURE.scale, WIDGET.TEMPERATURE.offset) == (0.5, -40)
    assert WIDGET.POSITION.atomic
    assert WIDGET.START.trigger
    assert WIDGET.UNKNOWN_ACCESS.access == ""


def test_a_count_becomes_a_value_in_the_unit_and_back() -> None:
    assert WIDGET.TARGET.in_unit(-1234) == -12.34
    assert WIDGET.TARGET.from_unit(12.344) == 1234
    assert WIDGET.TEMPERATURE.in_unit(130) == 25
    assert WIDGET.TEMPERATURE.from_unit(25.25) == 130
    with pytest.raises(CodecError, match="out_of_range"):
        WIDGET.TARGET.from_unit(10000)
    with pytest.raises(CodecError, match="out_of_range"):
        WIDGET.TARGET.from_unit(float("nan"))


def test_an_array_is_indexed_by_the_numbers_of_the_manual() -> None:
    assert [register.address for register in WIDGET.OUTPUT] == [0x2010, 0x2014, 0x2018]
    assert WIDGET.OUTPUT[1].address == 0x2010
    assert WIDGET.OUTPUT[3].name == "output[3]"
    for number in (0, 4, -1):
        with pytest.raises(IndexError):
            WIDGET.OUTPUT[number]


def test_a_table_is_indexed_by_the_numbers_of_the_manual() -> None:
    assert [WIDGET.points[number].address for number in (1, 2, 5)] == [0x9010, 0x9020, 0x9050]
    assert len(WIDGET.points) == len(list(WIDGET.points)) == 5
    for number in (0, 6, -1):
        with pytest.raises(IndexError):
            WIDGET.points[number]


def test_a_copy_of_a_block_has_the_values_of_the_block() -> None:
    assert (GLIDER.STORED_TURNS.copy_of, GLIDER.STORED_TURNS.address, GLIDER.STORED_TURNS.access) == (
        "turns",
        0x204,
        "ro",
    )
    assert (GLIDER.TURNS.copy_of, GLIDER.TURNS.number, GLIDER.STORED_TURNS.number) == ("", 2, None)
    for register in (GLIDER.TURNS, GLIDER.STORED_TURNS):
        assert register.decode(bytes.fromhex("FFFFFFFFFFFFFFFF")) == 2**64 - 1
    assert GLIDER.STORED_INPUT_1_FUNCTION.decode(bytes(4)) is GLIDER.InputFunction.NONE
    assert GLIDER.register_at(0x200) is GLIDER.STORED_RESOLUTION


def test_a_record_that_is_in_two_tables_is_one_class() -> None:
    assert CK10.points.record is CK10.flash_points.record
    for layout_table in newest(SPECS, "ck10").tables.values():
        table = getattr(CK10, layout_table.name)
        for element in (layout_table.table.index_from, layout_table.table.indexes[-1]):
            assert table[element].address == layout_table.table.address(element)
            assert CK10.register_at(table[element].address) is not None
    point = CK10.points.record.decode(bytes(64))
    words = [0] * 32
    assert CK10.flash_points[1].from_words(words) == CK10.points[1].from_words(words) == point
    assert CK10.flash_points[1].words == 32


def test_every_register_of_the_layout_is_there() -> None:
    for module, name, root in ((TC100, "tc100", SPECS), (CK10, "ck10", SPECS), (WIDGET, "widget", TEST_SPECS)):
        layout = newest(root, name)
        assert [register.address for register in module.REGISTERS] == [
            register_layout.address for register_layout in layout.registers
        ]
        for register_layout in layout.registers:
            register = module.register_at(register_layout.address)
            assert register is not None
            assert (register.address, register.words) == (register_layout.address, register_layout.words)


def test_a_register_is_found_by_its_address() -> None:
    assert WIDGET.register_at(0x1000) is WIDGET.STATUS_WORD
    assert WIDGET.register_at(0x2014).name == "output[2]"
    assert WIDGET.register_at(0x9030).name == "points[3]"
    assert WIDGET.register_at(0x9031) is None
    assert WIDGET.register_at(0x9060) is None


def test_reading_a_register_takes_one_request() -> None:
    assert WIDGET.read_request(WIDGET.POSITION) == WIDGET.ReadRegistersRequest(0x1010, 2)
    response = WIDGET.ReadRegistersResponse([0xFFFF, 0xFF9C])
    assert WIDGET.read_value(WIDGET.POSITION, response) == -100


def test_writing_one_word_and_several_takes_the_message_for_that() -> None:
    assert WIDGET.write_request(WIDGET.LAMP, WIDGET.Color.BLUE) == WIDGET.WriteRegisterRequest(0x2000, 5)
    assert WIDGET.write_request(WIDGET.TARGET, -100) == WIDGET.WriteRegistersRequest(0x2001, [0xFFFF, 0xFF9C])


def test_a_message_that_reads_one_word_is_sent_as_often_as_it_takes() -> None:
    assert GIZMO.read_requests(GIZMO.PLACE) == [GIZMO.ReadRequest(1), GIZMO.ReadRequest(2)]
    responses = [GIZMO.ReadResponse(1, 0x1234), GIZMO.ReadResponse(2, 0x5678)]
    assert GIZMO.read_value(GIZMO.PLACE, *responses) == 0x12345678
    with pytest.raises(CodecError, match="2 requests"):
        GIZMO.read_request(GIZMO.PLACE)


POINT = WIDGET.Point(WIDGET.Color.BLUE, -100, 50, WIDGET.Status(ready=True), WIDGET.Point.NEXT_END, 70000)


def test_a_record_that_is_longer_than_a_request_may_be_is_split() -> None:
    with pytest.raises(CodecError, match="2 requests"):
        WIDGET.points.write_request(5, POINT)
    requests = WIDGET.points.write_requests(5, POINT)
    words = list(struct.unpack(">8H", POINT.encode()))
    assert requests == [
        WIDGET.WriteRegistersRequest(0x9050, words[:6]),
        WIDGET.WriteRegistersRequest(0x9056, words[6:]),
    ]


def test_the_range_of_the_number_of_words_bounds_a_request() -> None:
    name = "protocols/wire.yaml"
    wire = (TEST_SPECS / name).read_text(encoding="utf-8").replace("u16, range: 1..10", "u16, range: 1..3")
    sources = {f"widget/{path.name}": path.read_bytes() for path in (TEST_SPECS / "widget").glob("*.yaml")}
    spec = read({**sources, name: wire.encode()}).devices["widget"]
    text = files([device_layout(spec.at("2.0")[0])])[f"{PACKAGE}/widget/v2_0.py"]
    assert "for start, count in _spans(register, 3)]" in text


def test_a_record_is_put_together_from_its_responses() -> None:
    assert WIDGET.points.read_request(5) == WIDGET.ReadRegistersRequest(0x9050, 8)
    words = list(struct.unpack(">8H", POINT.encode()))
    responses = [WIDGET.ReadRegistersResponse(part) for part in (words[:6], words[6:])]
    assert WIDGET.points.read_value(5, *responses) == POINT


def test_words_that_are_missing_are_refused() -> None:
    with pytest.raises(CodecError) as caught:
        WIDGET.points.read_value(5, WIDGET.ReadRegistersResponse([1, 2, 3]))
    assert caught.value.reason == "incomplete"


def test_an_atomic_register_is_never_split() -> None:
    register = type(WIDGET.POSITION)("wide", 0x10, 20, WIDGET.POSITION.value, atomic=True)
    with pytest.raises(CodecError, match="one request"):
        WIDGET.read_requests(register)


def test_a_register_that_can_only_be_read_is_not_written() -> None:
    with pytest.raises(CodecError) as caught:
        WIDGET.write_request(WIDGET.POSITION, 5)
    assert caught.value.reason == "read_only"


def test_the_points_of_a_manual_are_at_the_printed_addresses() -> None:
    layout = newest(SPECS, "tc100")
    for element in layout.device.tables["points"].elements:
        assert TC100.points[element.index].address == element.first


def test_a_parameter_is_carried_as_the_number_that_its_message_has() -> None:
    parameters = WIDGET.parameters
    assert parameters.write_request(parameters.HOME, WIDGET.Direction.BACKWARDS) == WIDGET.WriteOneRequest(2, 0xFFFF)
    assert parameters.read_request(parameters.STROKE) == WIDGET.ReadOneRequest(1)
    assert parameters.read_value(parameters.STROKE, WIDGET.ReadOneResponse(1, 125)) == 125
    assert parameters.read_value(parameters.KIND, WIDGET.ReadOneResponse(0, 1)) is WIDGET.Alarm.OVERLOAD
    assert parameters[2] is parameters.HOME
    with pytest.raises(IndexError):
        parameters[6]


def test_a_parameter_refuses_what_it_cannot_hold() -> None:
    parameters = WIDGET.parameters
    for value, reason in ((10000, "out_of_range"), (-1, "out_of_range"), ("1", "wrong_type")):
        with pytest.raises(CodecError) as caught:
            parameters.write_request(parameters.STROKE, value)
        assert caught.value.reason == reason
    with pytest.raises(CodecError) as caught:
        parameters.write_request(parameters.BITS, WIDGET.Status())
    assert caught.value.reason == "read_only"
    with pytest.raises(CodecError):
        parameters.HOME.from_raw(7)


def test_all_parameters_go_in_one_message_in_the_order_of_their_numbers() -> None:
    raws = [1, 125, 0xFFFF, 0, 0x8021, 1]
    values = WIDGET.parameters.from_raws(raws)
    assert values["home"] is WIDGET.Direction.BACKWARDS
    assert values["enabled"] is True
    assert WIDGET.parameters.to_raws(values) == raws
    with pytest.raises(CodecError, match="missing"):
        WIDGET.parameters.to_raws({})


def test_a_version_without_a_message_for_one_parameter_has_no_request_for_it() -> None:
    old = module_of(layouts(TEST_SPECS)["widget"][0])
    assert not hasattr(old.parameters, "write_request")


def test_the_parameters_of_a_manual_are_written_by_its_message() -> None:
    request = ESC11.parameters.write_request(ESC11.parameters[1], 100)
    assert request == ESC11.WriteParameterRequest(1, 100)
    assert len(ESC11.parameters) == 32


def test_a_sentinel_of_a_record_is_no_quantity() -> None:
    example = newest(TEST_SPECS, "widget").device.examples["everything-ascii"]
    record = WIDGET.Everything.decode(bytes.fromhex(example.frame[5:-4].decode()))
    assert (record.half, record.half_mm) == (0xFFFF, None)
    record.half_mm = 1.5
    assert (record.half, record.half_mm) == (150, 1.5)
    with pytest.raises(CodecError, match="out_of_range"):
        record.half_mm = 655.35


def test_a_sentinel_of_a_register_is_no_quantity() -> None:
    assert (WIDGET.LIMIT.in_unit(0x7FFF), WIDGET.LIMIT.in_unit(5)) == (None, 5.0)
    speed = TC100.MOTION_SPEED
    assert (speed.in_unit(0), speed.in_unit(50)) == (None, 50.0)
    with pytest.raises(CodecError, match="whose count 0 stands for"):
        speed.from_unit(0.0)
