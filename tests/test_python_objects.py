"""The generated classes as people use them: enums, scaled values, errors, equality, texts, matching."""

from __future__ import annotations

import copy
import pickle
from dataclasses import replace
from decimal import Decimal
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fieldspec.codec.layout.checksums import checksum as checksum_of
from fieldspec.targets.python.scaling import in_unit, quantity, ratio
from layouts import SPECS, TEST_SPECS, layouts, newest
from python_package import codec_error, module_of, package, runtime

WIDGET, ESC11, TC100 = (
    module_of(newest(TEST_SPECS, "widget")),
    module_of(newest(SPECS, "esc11")),
    module_of(newest(SPECS, "tc100")),
)
CodecError = codec_error()
PACKAGE = package()


def corner(x: int = 0, y: int = 0) -> Any:
    return WIDGET.Corner(x=x, y=y)


# Enums


def test_a_member_that_is_not_available_is_left_out() -> None:
    assert [(member.name, member.value) for member in WIDGET.Color] == [("RED", 0), ("GREEN", 1), ("BLUE", 5)]


def test_an_open_enum_passes_on_a_value_that_it_does_not_list() -> None:
    decoded = WIDGET.ReadCornersResponse.decode(bytes.fromhex("7777"))
    assert decoded.alarm == 0x7777
    assert type(decoded.alarm) is int
    assert decoded.encode() == bytes.fromhex("7777")


def test_a_listed_value_of_an_open_enum_is_a_member() -> None:
    assert WIDGET.ReadCornersResponse.decode(bytes.fromhex("0001")).alarm is WIDGET.Alarm.OVERLOAD


def test_a_closed_enum_refuses_a_value_that_it_does_not_list() -> None:
    with pytest.raises(CodecError) as caught:
        WIDGET.NestResponse.decode(bytes([0, 1, 9]))
    assert (caught.value.reason, caught.value.offset) == ("unknown_value", 2)


def test_a_version_has_the_members_of_its_own() -> None:
    old = module_of(layouts(TEST_SPECS)["widget"][0])
    assert not hasattr(old.Alarm, "OVER_VOLTAGE")
    assert WIDGET.Alarm.OVER_VOLTAGE == 0x100


GLIDER = module_of(newest(TEST_SPECS, "glider-x"))


def test_a_code_is_found_by_what_is_displayed_and_by_its_other_number() -> None:
    alarm = GLIDER.Alarm
    assert (alarm.FIXED_STOP.printed_name, alarm.FIXED_STOP.number) == ("AL.EE0", 78)
    assert alarm.by_printed_name("AL.EE0") is alarm.by_printed_name(" al.ee0 ") is alarm.FIXED_STOP
    assert alarm.by_number(4) is alarm(0x24) is alarm.SYSTEM
    for call in (lambda: alarm.by_printed_name("AL.FFF"), lambda: alarm.by_number(5)):
        with pytest.raises(CodecError) as caught:
            call()
        assert caught.value.reason == "unknown_value"


def test_codes_that_follow_from_others_have_their_numbers() -> None:
    assert [(member.name, member.value) for member in GLIDER.InternalAlarm] == [("SYSTEM", 4), ("FIXED_STOP", 78)]
    assert GLIDER.InternalAlarm.by_printed_name("AL.024") is GLIDER.InternalAlarm.SYSTEM
    assert not hasattr(GLIDER.Path, "by_printed_name")


def test_the_masks_of_bits_are_the_members_that_follow_from_them() -> None:
    function = GLIDER.InputFunction
    assert (function.NONE, function.LIMIT_NEGATIVE, function.USER_5) == (0, 2, 2**31)
    assert GLIDER.INPUT_1_FUNCTION.decode(bytes.fromhex("80000000")) is function.USER_5
    assert GLIDER.INPUT_1_FUNCTION.encode(function.USER_5) == bytes.fromhex("80000000")


# Records


def test_records_are_equal_where_their_fields_are() -> None:
    assert corner(1, 2) == corner(1, 2)
    assert corner(1, 2) != corner(1, 3)
    assert corner(1, 2) != (1, 2)


def test_a_record_shows_its_fields() -> None:
    assert repr(corner(1, 2)) == "Corner(x=1, y=2)"
    assert eval(repr(corner(1, 2)), vars(WIDGET)) == corner(1, 2)


def test_a_record_can_be_matched_by_place_and_by_name() -> None:
    match corner(1, 2):
        case WIDGET.Corner(x, y=2):
            assert x == 1
        case _:
            pytest.fail("it does not match")


def test_a_record_has_no_room_for_a_misspelt_field() -> None:
    with pytest.raises(AttributeError):
        corner().z = 1


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda value: pickle.loads(pickle.dumps(value))])
def test_a_record_can_be_copied(copied: Any) -> None:
    nest = WIDGET.NestRequest(
        WIDGET.Nest(
            corner(),
            [corner(1), corner(2)],
            [1, 2, 3],
            [0, 1],
            [1, 2],
            [WIDGET.Status(1)] * 2,
            [True, False],
            ["", "a"],
            255,
        ),
        WIDGET.Color.RED,
    )
    assert copied(nest) == nest
    assert copied(nest).encode() == nest.encode()


def test_constants_measures_and_reserved_fields_are_no_arguments() -> None:
    assert WIDGET.ExchangeRequest.__match_args__ == ("data",)
    assert "magic" not in WIDGET.Nest.__match_args__
    assert "filler" not in WIDGET.Nest.__match_args__
    assert WIDGET.ExchangeRequest([1, 2, 3]).encode() == bytes.fromhex("0003010203")


def test_a_sentinel_is_a_constant_of_its_record() -> None:
    assert WIDGET.Point.NEXT_END == -1
    assert WIDGET.Everything.HALF_IGNORED == 0xFFFF


@pytest.mark.parametrize(
    ("change", "reason", "name"),
    [
        ({"mode": 9}, "unknown_value", "mode"),
        ({"position": 1000000}, "out_of_range", "position"),
        ({"speed": 0}, "out_of_range", "speed"),
        ({"speed": "fast"}, "wrong_type", "speed"),
        ({"speed": 1.5}, "wrong_type", "speed"),
        ({"speed": None}, "wrong_type", "speed"),
        ({"status": "1"}, "wrong_type", "status"),
        ({"dwell": -1}, "out_of_range", "dwell"),
        ({"next": 6}, "out_of_range", "next"),
    ],
)
def test_the_error_names_the_field_that_is_out_of_range(change: dict[str, Any], reason: str, name: str) -> None:
    point = WIDGET.Point(WIDGET.Color.RED, 0, 1, WIDGET.Status(), -1, 0)
    assert point.encode()
    for attribute, value in change.items():
        setattr(point, attribute, value)
    with pytest.raises(CodecError) as caught:
        point.encode()
    assert (caught.value.reason, caught.value.offset) == (reason, None)
    assert caught.value.detail.startswith(f"{name} is ")


def test_an_error_can_be_sent_to_another_process() -> None:
    error = CodecError("wrong_checksum", "so it is", 7)
    again = pickle.loads(pickle.dumps(error))
    assert (again.reason, again.detail, again.offset, str(again)) == ("wrong_checksum", "so it is", 7, str(error))
    assert isinstance(error, ValueError)


# Scaled values


def test_a_scaled_field_is_also_a_value_in_its_unit() -> None:
    record = corner(-1234, 5)
    assert (record.x_mm, record.y_mm) == (-123.4, 0.5)
    record.x_mm = 12.3
    assert record.x == 123


def test_an_offset_belongs_to_the_value_in_the_unit() -> None:
    everything = WIDGET.Everything.decode(bytes(52))
    assert everything.offset_temperature_v == -40
    everything.offset_temperature_v = 25
    assert everything.offset_temperature == 130


def test_a_list_of_scaled_fields_is_also_one_of_values_in_their_unit() -> None:
    nest = WIDGET.Nest(corner(), [], [1, 999, 0], [], [], [], [], [], 0)
    assert nest.samples_percent == [0.1, 99.9, 0.0]
    nest.samples_percent = [1, 2.5, 3]
    assert nest.samples == [10, 25, 30]


@pytest.mark.parametrize(
    ("value", "count"),
    [(0.25, 2), (0.75, 8), (-0.25, -2), (Decimal("0.15"), 2), (Decimal("0.05"), 0), (Fraction(1, 3), 3), (7, 70)],
)
def test_the_nearest_count_is_taken_and_of_two_the_even_one(value: Any, count: int) -> None:
    record = corner()
    record.x_mm = value
    assert record.x == count


@pytest.mark.parametrize("value", [100.06, -100.06, 1e300, float("inf"), float("nan")])
def test_a_value_that_is_out_of_range_is_refused_and_changes_nothing(value: float) -> None:
    record = corner(7)
    with pytest.raises(CodecError) as caught:
        record.x_mm = value
    assert caught.value.reason == "out_of_range"
    assert record.x == 7


@given(
    count=st.integers(-(2**63), 2**63 - 1), ratio=st.sampled_from([(1, 0, 1), (1, 0, 100), (1, -400, 10), (-5, 3, 7)])
)
def test_rounding_is_exact_for_every_count(count: int, ratio: tuple[int, int, int]) -> None:
    a, b, c = ratio
    exact = Fraction(count * a + b, c)
    counts = runtime("_conversions").counts
    ranges = ((-(2**63), 2**63 - 1),)
    assert counts("it", exact, ratio, ranges) == count
    half = exact + Fraction(a, 2 * c)
    if count < 2**63 - 1:
        assert counts("it", half, ratio, ranges) == (count if count % 2 == 0 else count + 1)


@pytest.mark.parametrize(
    ("scale", "offset", "fraction", "expression", "text"),
    [
        ("1", "0", (1, 0, 1), "float(n)", "in mm"),
        ("0.01", "0", (1, 0, 100), "n / 100", "in 0.01 mm"),
        ("0.5", "-40", (1, -80, 2), "(n - 80) / 2", "in 0.5 mm from -40 mm"),
        ("10", "0.25", (40, 1, 4), "(n * 40 + 1) / 4", "in 10 mm from 0.25 mm"),
        ("2", "3", (2, 3, 1), "float(n * 2 + 3)", "in 2 mm from 3 mm"),
        ("-0.1", "0", (-1, 0, 10), "n * -1 / 10", "in -0.1 mm"),
    ],
)
def test_a_scale_is_written_as_whole_numbers(
    scale: str, offset: str, fraction: tuple[int, int, int], expression: str, text: str
) -> None:
    value = replace(SCALED, scale=Decimal(scale), offset=Decimal(offset))
    assert ratio(value) == fraction
    assert in_unit("n", fraction) == expression
    assert eval(expression, {"n": 7}) == float(value.in_unit(7))
    assert quantity(value) == text


SCALED = next(iter(newest(TEST_SPECS, "widget").records["corner"].fields)).value


@given(st.integers(-1000, 1000))
def test_a_count_comes_back_from_its_value_in_the_unit(count: int) -> None:
    record = corner(count)
    record.x_mm = record.x_mm
    assert record.x == count


# Links


def test_a_response_is_of_the_class_that_belongs_to_its_request() -> None:
    frame = bytes.fromhex("06 00 70 05 04 7F")
    assert ESC11.serial.decode_request(frame) == PACKAGE.Request(0, ESC11.ClearPointsRequest(5, 4))
    response = ESC11.serial.decode_response(bytes.fromhex("04 00 03 07"), ESC11.StopRequest)
    assert isinstance(response.message, ESC11.StopResponse)
    assert response.status == ESC11.CommunicationStatus(executing=True, out_of_position=True)


def test_a_refusal_is_a_result_and_no_exception() -> None:
    frame = WIDGET.rtu.encode_exception_response(
        1, 0x03, WIDGET.ExceptionRecord(WIDGET.ExceptionCode.ILLEGAL_DATA_ADDRESS)
    )
    match WIDGET.rtu.decode_response(frame, WIDGET.ReadRegistersRequest):
        case PACKAGE.ExceptionResponse(unit_address=1, code=3, exception=WIDGET.ExceptionRecord(reason)):
            assert reason is WIDGET.ExceptionCode.ILLEGAL_DATA_ADDRESS
        case other:
            pytest.fail(f"it is {other}")


def test_a_response_to_something_else_is_refused() -> None:
    frame = WIDGET.rtu.encode_response(1, WIDGET.StopResponse())
    assert isinstance(WIDGET.rtu.decode_response(frame).message, WIDGET.StopResponse)
    with pytest.raises(CodecError) as caught:
        WIDGET.rtu.decode_response(frame, WIDGET.ReadRegistersRequest(0, 1))
    assert caught.value.reason == "unknown_code"


@pytest.mark.parametrize("station", [17, -1, 256, "1", None])
def test_a_station_that_there_is_not_is_refused(station: Any) -> None:
    for message in (WIDGET.ReadRegistersRequest(0, 1), WIDGET.WriteRegistersRequest(0, [1]), WIDGET.StopRequest()):
        for link in (WIDGET.rtu, WIDGET.ascii):
            with pytest.raises(CodecError) as caught:
                link.encode_request(station, message)
            assert caught.value.detail.startswith("station is ")


def test_a_frame_that_is_too_long_for_its_length_is_refused() -> None:
    frames = runtime("_frames").Frames(">B", "sum8", length=0, length_name="length", longest=255)
    assert len(frames.joined([0], bytes(253))) == 255
    with pytest.raises(CodecError) as caught:
        frames.joined([0], bytes(254))
    assert caught.value.reason == "wrong_length"


@pytest.mark.parametrize(
    ("frame", "reason", "offset"),
    [
        (b"", "wrong_mark", 0),
        (b":", "wrong_mark", 1),
        (b":0103\r", "wrong_mark", 6),
        (b":01 3\r\n", "not_hex", 3),
        (b":013\r\n", "wrong_length", 4),
        (b":0103\r\n", "incomplete", 2),
        (b":010310000002EB\r\n", "wrong_checksum", 6),
    ],
)
def test_what_is_wrong_with_characters_is_told_by_its_place(frame: bytes, reason: str, offset: int) -> None:
    with pytest.raises(CodecError) as caught:
        WIDGET.ascii.decode_request(frame)
    assert (caught.value.reason, caught.value.offset) == (reason, offset)


def test_characters_may_be_lower_case() -> None:
    frame = WIDGET.ascii.encode_request(1, WIDGET.ReadRegistersRequest(0x1000, 2))
    assert WIDGET.ascii.decode_request(frame.lower()).message == WIDGET.ReadRegistersRequest(0x1000, 2)


@pytest.mark.parametrize("form", [bytearray, memoryview])
def test_a_frame_may_be_in_any_kind_of_bytes(form: Any) -> None:
    for link in (WIDGET.rtu, WIDGET.ascii):
        for request in (WIDGET.ReadRegistersRequest(0x1000, 2), WIDGET.ExchangeRequest([1, 2])):
            assert link.decode_request(form(link.encode_request(1, request))).message == request


@given(st.binary(max_size=300))
def test_the_fast_crc_is_that_of_the_standard(data: bytes) -> None:
    checks = runtime("_checks")
    for name in ("crc16_modbus", "lrc", "sum8"):
        assert getattr(checks, name)(data) == checksum_of(name, data)


def checked(text: str) -> bytes:
    """A frame with its CRC."""
    data = bytes.fromhex(text)
    return data + checksum_of("crc16_modbus", data).to_bytes(2, "little")


def test_numbers_beyond_those_that_may_be_sent_are_read_as_they_came() -> None:
    request = TC100.rtu.decode_request(checked("C8 03 10 00 12 34"))
    assert (request.unit_address, request.message) == (200, TC100.ReadRegistersRequest(0x1000, 0x1234))
    response = TC100.rtu.decode_response(checked("C8 06 10 00 12 34"))
    assert (response.unit_address, response.message) == (200, TC100.WriteRegisterResponse(0x1000, 0x1234))


def test_a_link_knows_its_unit_addresses() -> None:
    assert WIDGET.packet.unit_addresses == ((0, 7), (32, 39))
    assert (WIDGET.rtu.unit_addresses, WIDGET.rtu.broadcast) == (((1, 16),), 0)
    assert WIDGET.packet.broadcast is None
