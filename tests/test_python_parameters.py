"""Numbered parameters: sets that share the numbers on the wire, families, elements, and messages that carry them."""

from __future__ import annotations

import copy
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from example_counts import examples
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.registers import Parameter, ParameterSet
from layouts import SPECS, TEST_SPECS, all_layouts, layouts, newest
from python_package import codec_error, module_of, package

GLIDER = module_of(newest(TEST_SPECS, "glider-x"))
HIWIN = module_of(newest(SPECS, "hiwin-e"))
WIDGET, ESC11 = module_of(newest(TEST_SPECS, "widget")), module_of(newest(SPECS, "esc11"))
CodecError = codec_error()
pnu, servo, profile, monitor = GLIDER.pnu, GLIDER.servo, GLIDER.profile, GLIDER.monitor
SETS = [
    pytest.param(layout, parameter_set, id=f"{layout.device.id}-{layout.device.version}-{parameter_set.name}")
    for layout in all_layouts()
    for parameter_set in layout.device.parameters.values()
]


@pytest.mark.parametrize(("layout", "parameter_set"), SETS)
def test_every_row_of_a_set_is_told_as_the_spec_tells_it(layout: DeviceLayout, parameter_set: ParameterSet) -> None:
    module = module_of(layout)
    space = getattr(module, parameter_set.space)
    for row in parameter_set.parameters:
        for place in range(row.count):
            parameter = space(parameter_set.base + row.number + place)
            assert facts(parameter) == facts_of(row, parameter_set, place)
            assert parameter is getattr(module, parameter_set.name)[row.number + place]
    assert len(getattr(module, parameter_set.name)) == sum(row.count for row in parameter_set.parameters)


def facts(parameter: Any) -> dict[str, Any]:
    """The facts of a generated parameter."""
    names = ("name", "printed_name", "number", "wire_number", "set", "type", "access", "default", "unit", "elements")
    more = ("restart", "applies_to", "messages", "only", "reserved", "ranges")
    return {name: getattr(parameter, name) for name in (*names, *more)}


def facts_of(row: Parameter, parameter_set: ParameterSet, place: int) -> dict[str, Any]:
    """The facts of the parameter in the spec."""
    value, number = row.value, row.number + place
    ranges = value.writable_ranges
    full = ranges is None or ranges.intervals == ((value.type.low, value.type.high),)
    narrow = is_count(value.encoding) and value.const is None and not full
    is_number = not (value.enum or value.flags or value.const is not None)
    return {
        "name": row.name if row.count == 1 else f"{row.name}[{place}]",
        "printed_name": row.printed_name if row.printed_name and row.count == 1 else parameter_set.number_text(number),
        "number": number,
        "wire_number": parameter_set.base + number,
        "set": parameter_set.name,
        "type": value.type.name,
        "access": row.access,
        "default": value.default,
        "unit": value.unit if is_number else "",
        "elements": row.elements,
        "restart": row.restart,
        "applies_to": row.applies_to,
        "messages": row.messages,
        "only": row.only,
        "reserved": row.reserved,
        "ranges": ranges.intervals if narrow and ranges else (),
    }


@pytest.mark.parametrize(("layout", "parameter_set"), SETS)
@examples(40)
@given(data=st.data())
def test_a_number_is_found_in_the_set_that_has_it(
    layout: DeviceLayout, parameter_set: ParameterSet, data: st.DataObject
) -> None:
    numbers = st.one_of(st.integers(0, 0xFFFF), st.integers(parameter_set.base - 2, parameter_set.base + 0x1002))
    number = data.draw(numbers)
    space, expected = (
        getattr(module_of(layout), parameter_set.space),
        layout.device.parameter_at(parameter_set.space, number),
    )
    assert (number in space) == (expected is not None) if hasattr(space, "sets") else True
    if expected is None:
        with pytest.raises(ValueError, match=f"no number {number} ") as caught:
            space(number)
        assert caught.value.reason == "unknown_value"  # type: ignore[attr-defined]
        return
    parameter = space(number)
    assert (parameter.set, parameter.number, parameter.wire_number) == (expected[0].name, expected[1], number)


def test_of_a_number_without_a_row_only_what_is_known_is_told() -> None:
    parameter = pnu(0x2100)
    assert (parameter.printed_name, parameter.number, parameter.wire_number, parameter.set) == (
        "Pt100",
        0x100,
        0x2100,
        "servo",
    )
    assert (parameter.name, parameter.type, parameter.access, parameter.default, parameter.source) == (
        "",
        "",
        "",
        None,
        "",
    )
    assert repr(parameter) == "<parameter Pt100>"
    assert servo[0x100].wire_number == 0x2100
    for call in (lambda: parameter.decode(b""), lambda: parameter.encode(1)):
        with pytest.raises(CodecError, match="Pt100"):
            call()


def test_a_run_of_parameters_is_a_tuple() -> None:
    assert [parameter.wire_number for parameter in monitor.UNUSED] == list(range(0x4100, 0x4105))
    assert pnu(0x4102) is monitor.UNUSED[2]
    assert (pnu(0x4102).name, pnu(0x4102).printed_name, pnu(0x4102).reserved) == ("unused[2]", "Ut102", True)
    assert pnu(0x4105).name == ""


def test_numbers_are_constants() -> None:
    assert GLIDER.PnuNumber.REFERENCE_SPEED == 0x2317
    assert pnu(GLIDER.PnuNumber.FAULT_CODES) is profile.FAULT_CODES
    assert WIDGET.ParametersNumber.HOME == 2
    assert HIWIN.PnuNumber.REFERENCE_SPEED_ROTARY == 0x2317


def test_parameters_are_attributes_of_their_set() -> None:
    assert servo.REFERENCE_SPEED is pnu(0x2317)
    assert "REFERENCE_SPEED" in dir(servo)
    assert not hasattr(servo, "REFERENCE_SPED")
    assert copy.copy(servo).REFERENCE_SPEED.name == "reference_speed"
    with pytest.raises(AttributeError):
        servo.REFERENCE_SPEED = 1


def test_rows_are_made_when_one_is_asked_for() -> None:
    module = module_of(layouts(TEST_SPECS)["glider-x"][0])
    fresh = type(module.servo)("servo", module._servo_rows, base=0x2000)
    assert object.__getattribute__(fresh, "_index") == {}
    assert fresh[0x317].name == "reference_speed"
    assert len(object.__getattribute__(fresh, "_index")) == len(fresh) == 3


def test_a_count_of_a_parameter_is_also_a_value_in_its_unit() -> None:
    torque = servo.REFERENCE_TORQUE
    assert (torque.unit, torque.scale, torque.in_unit(1270)) == ("Nm", 0.001, 1.27)
    assert torque.from_unit(1.2704) == 1270
    with pytest.raises(CodecError):
        torque.from_unit(-1)
    with pytest.raises(CodecError):
        servo.REFERENCE_SPEED.from_unit(0)


def test_a_request_that_reads_is_made_by_number_element_and_count() -> None:
    request = pnu.read_request(servo.REFERENCE_SPEED, element_count=1)
    assert request == GLIDER.ReadParameterRequest(element_count=1, number=0x2317, subindex=0)
    frame = GLIDER.channel.encode_request(request, reference=7)
    assert frame == bytes.fromhex("07 01 00 01 23 17 00 00")
    assert pnu.read_request(profile.FAULT_CODES, element_count=2, subindex=6).subindex == 6
    assert pnu.read_request(pnu(0x2100), element_count=0).number == 0x2100


def read(format_: str, *values: Any) -> Any:
    """A response."""
    return GLIDER.ReadParameterResponse(GLIDER.Format[format_], values)


@pytest.mark.parametrize(
    ("number", "response", "value"),
    [
        (0x2317, read("UNSIGNED16", 3000), 3000),
        (0x2317, read("WORD", 3000), 3000),
        (0x225B, read("INTEGER32", 2**31 - 1), 2**31 - 1),
        (0x4095, read("UNSIGNED16", 0x24), GLIDER.Alarm.SYSTEM),
        (0x4095, read("UNSIGNED16", 0x25), 0x25),
        (0x2317, read("INTEGER8", -1), 0xFFFF),
        (0x2100, read("FLOATING", 1.5), 1.5),
        (0x2100, read("BOOLEAN", True), True),
    ],
)
def test_the_value_of_a_response_is_that_of_its_parameter(number: int, response: Any, value: Any) -> None:
    decoded = pnu.read_value(pnu(number), response)
    assert (decoded, type(decoded)) == (value, type(value))


@pytest.mark.parametrize(
    ("number", "response", "reason"),
    [
        (0x2317, read("FLOATING", 1.5), "wrong_type"),
        (0x2317, read("INTEGER32", 70000), "out_of_range"),
        (0x2317, read("UNSIGNED16", 1, 2), "wrong_length"),
    ],
)
def test_a_response_that_does_not_suit_its_parameter_is_refused(number: int, response: Any, reason: str) -> None:
    with pytest.raises(CodecError) as caught:
        pnu.read_value(pnu(number), response)
    assert caught.value.reason == reason


def test_the_elements_of_an_array_have_meanings_of_their_own() -> None:
    codes = pnu.read_values(profile.FAULT_CODES, read("UNSIGNED16", 0x24, 0, 0xEE0))
    assert codes == [GLIDER.Alarm.SYSTEM, 0, GLIDER.Alarm.FIXED_STOP]
    identification = profile.IDENTIFICATION
    assert [(subindex.name, subindex.indices, subindex.reserved) for subindex in identification.subindices] == [
        ("maker", ((0, 0),), False),
        ("firmware", ((1, 1),), False),
        ("", ((2, 4),), True),
    ]
    assert identification.subindex(3) is identification.subindices[2]
    assert identification.subindex(5) is None
    assert pnu.read_values(identification, read("UNSIGNED16", 0xAAA, 110)) == [0xAAA, 110]
    assert pnu.read_value(identification, read("UNSIGNED16", 110), 1) == 110
    assert pnu.read_value(identification, read("UNSIGNED16", 1)) == 1
    with pytest.raises(CodecError) as caught:
        pnu.write_values_request(identification, [1, 110])
    assert caught.value.reason in ("wrong_const", "read_only")


def test_what_may_be_written_may_be_less_than_what_is_read() -> None:
    assert pnu.read_value(servo.INITIALIZATION, read("UNSIGNED16", 32)) == 32
    assert pnu.write_request(servo.INITIALIZATION, 1).values == (1,)
    with pytest.raises(CodecError) as caught:
        pnu.write_request(servo.INITIALIZATION, 32)
    assert caught.value.reason == "out_of_range"


def test_a_request_that_writes_has_the_format_of_its_parameter() -> None:
    request = pnu.write_request(servo.REFERENCE_SPEED, 1500)
    assert request == GLIDER.WriteParameterRequest(0x2317, GLIDER.Format.UNSIGNED16, (1500,))
    wide = pnu.write_request(servo.RANGE_HIGH, 5)
    assert (wide.format, wide.values) == (GLIDER.Format.INTEGER32, (5,))
    assert pnu.write_values_request(servo.REFERENCE_SPEED, [1, 2]).values == (1, 2)


def test_a_format_may_be_given_and_must_be_where_none_suits() -> None:
    with pytest.raises(CodecError, match="reference_torque"):
        pnu.write_request(servo.REFERENCE_TORQUE, 1270)
    request = pnu.write_request(servo.REFERENCE_TORQUE, 1270, format=GLIDER.Format.INTEGER32)
    assert GLIDER.channel.encode_request(request, reference=1) == bytes.fromhex("01 02 00 24 2A 04 01 00 00 04 F6")
    assert pnu.write_request(pnu(0x2100), 40, format=GLIDER.Format.WORD).values == (40,)
    with pytest.raises(CodecError, match="Pt100"):
        pnu.write_request(pnu(0x2100), 40)


@pytest.mark.parametrize(
    ("number", "value", "reason"),
    [
        (0x2317, 0, "out_of_range"),
        (0x2317, 65536, "out_of_range"),
        (0x2317, "1", "wrong_type"),
        (922, 1, "read_only"),
    ],
)
def test_a_value_that_a_parameter_cannot_have_is_not_written(number: int, value: Any, reason: str) -> None:
    with pytest.raises(CodecError) as caught:
        pnu.write_request(pnu(number), value)
    assert caught.value.reason == reason


def test_a_set_alone_is_found_by_its_numbers_on_the_wire() -> None:
    assert ESC11.parameters(1) is ESC11.parameters[1]
    with pytest.raises(CodecError) as caught:
        ESC11.parameters(32)
    assert caught.value.reason == "unknown_value"
    with pytest.raises(IndexError):
        ESC11.parameters[32]


def test_the_families_of_a_manual_are_found() -> None:
    assert (HIWIN.pnu(0x2100).printed_name, HIWIN.pnu(0x2100).name) == ("Pt100", "")
    assert HIWIN.pnu(0x2317).applies_to == ("rotary",)
    assert (HIWIN.pnu(964).elements, HIWIN.pnu(964).subindices[0].name) == (7, "manufacturer")
    assert HIWIN.pnu(0x2317) is HIWIN.servo_parameters.REFERENCE_SPEED_ROTARY
    assert isinstance(HIWIN.pnu(0x3056), package().Parameter)
    with pytest.raises(CodecError):
        HIWIN.pnu(0x1000)


def test_the_channel_of_a_manual_carries_values_by_their_parameters() -> None:
    reference, channel = HIWIN.servo_parameters.REFERENCE_TORQUE, HIWIN.parameter_channel
    request = HIWIN.pnu.read_request(reference, element_count=0)
    frame = channel.encode_request(request, request_reference=5)
    assert frame == bytes.fromhex("05 01 00 01 10 00 24 2A 00 00")
    reply = channel.decode_response(bytes.fromhex("05 01 00 01 07 01 00 00 04 F6"), request)
    assert reference.in_unit(HIWIN.pnu.read_value(reference, reply.message)) == 1.27
    back = HIWIN.pnu.write_request(reference, reference.from_unit(1.27), element_count=0)
    frame = channel.encode_request(back, request_reference=6)
    assert frame == bytes.fromhex("06 02 00 01 10 00 24 2A 00 00 07 01 00 00 04 F6")
    refused = channel.decode_response(bytes.fromhex("05 81 00 01 44 01 00 01"), request)
    assert refused.exception.error_number is HIWIN.ParameterErrorNumber.VALUE_NOT_CHANGEABLE
    assert (refused.code, refused.request_reference) == (1, 5)


def test_what_only_some_models_have_says_so() -> None:
    assert monitor.ALARM_CODE.only == ("X",)
    assert HIWIN.pnu(0x3063).only == ("E2",)
