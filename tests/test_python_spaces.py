"""Address spaces and absent values of the generated registers and records."""

from __future__ import annotations

import pytest

from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of

METER, PROBE = module_of(newest(TEST_SPECS, "meter")), module_of(newest(TEST_SPECS, "probe"))
CodecError = codec_error()


def test_a_register_is_read_by_the_message_of_its_space() -> None:
    voltage, station = METER.read_request(METER.VOLTAGE), METER.read_request(METER.STATION)
    assert type(voltage) is METER.ReadInputRegistersRequest
    assert type(station) is METER.ReadHoldingRegistersRequest
    assert voltage.address == station.address == 0
    assert METER.rtu.encode_request(1, voltage) == newest(TEST_SPECS, "meter").device.examples["read-voltage"].frame


def test_a_response_of_another_space_is_no_value_of_a_register() -> None:
    assert METER.read_value(METER.VOLTAGE, METER.ReadInputRegistersResponse(words=[0x8000])) == -0x8000
    with pytest.raises(CodecError, match="wrong_type"):
        METER.read_value(METER.VOLTAGE, METER.ReadHoldingRegistersResponse(values=[5]))


def test_a_space_that_no_message_writes_has_no_request() -> None:
    (request,) = METER.write_requests(METER.STATION, 7)
    assert type(request) is METER.WriteHoldingRegisterRequest
    table = METER.history
    with pytest.raises(CodecError, match="read_only"):
        METER.write_requests(table[0], METER.Sample(voltage=1, voltages=[1, 2]))


def test_an_address_means_a_register_of_a_space() -> None:
    assert METER.register_at(0) is METER.STATION
    assert METER.register_at(0, "input_registers") is METER.VOLTAGE
    assert METER.register_at(0x100) is None
    assert METER.register_at(0x100, "input_registers").name == "history[0]"


def test_a_sentinel_of_a_signed_register_is_no_quantity() -> None:
    assert METER.VOLTAGE.in_unit(-0x8000) is None
    assert METER.VOLTAGE.in_unit(2301) == 230.1
    with pytest.raises(CodecError, match="out_of_range"):
        METER.VOLTAGE.from_unit(-3276.8)


@pytest.mark.parametrize("value", [-10.5, 250.5, float("nan"), float("inf"), 9998.0])
def test_a_float_beyond_its_range_is_refused(value: float) -> None:
    with pytest.raises(CodecError, match="out_of_range"):
        METER.POWER.encode(value)


@pytest.mark.parametrize(("value", "quantity"), [(-10.0, -10.0), (250.0, 250.0), (9999.0, None)])
def test_a_float_within_its_range_and_a_sentinel_are_encoded(value: float, quantity: float | None) -> None:
    assert METER.POWER.decode(METER.POWER.encode(value)) == value
    assert METER.POWER.in_unit(value) == quantity


def test_what_is_no_number_stands_for_an_absent_value() -> None:
    nan = PROBE.DISTANCE.decode(bytes.fromhex("00007FC0"))
    assert PROBE.DISTANCE.in_unit(nan) is None
    assert PROBE.DISTANCE.encode(nan) == bytes.fromhex("00007FC0")
    sample = PROBE.Sample.decode(bytes.fromhex("00007FC0" + "00" * 32 + "0000FFFF00003F80"))
    assert (sample.distance_mm, sample.widths_value) == (None, [None, 1.0])
    sample.distance = 301.0
    with pytest.raises(CodecError, match="out_of_range"):
        sample.encode()
    sample.distance = PROBE.Sample.DISTANCE_NOT_MEASURED
    assert sample.encode()[:4] == bytes.fromhex("00007FC0")
