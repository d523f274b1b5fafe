"""Sentinels in the generated Python: their names, what becomes of None, and no quantity that is sent as one."""

from __future__ import annotations

import math
import struct
from typing import Any

import pytest

from fieldspec.codec.layout.values import number_of_sentinel
from layouts import SPECS, TEST_SPECS, newest
from python_package import codec_error, module_of

CodecError = codec_error()
PROBE = module_of(newest(TEST_SPECS, "probe"))
METER = module_of(newest(TEST_SPECS, "meter"))
TC100 = module_of(newest(SPECS, "tc100"))


def sample(**values: Any) -> Any:
    """A record of the probe with some values, and usual ones for the others."""
    others = {"pair": [1.0, 2.0], "turned": 0.0, "widths": [1.0, math.nan]}
    return PROBE.Sample(**({"exact": 1.0} if "exact_mm" not in values else {}), **others, **values)


def test_a_register_has_its_states_by_name() -> None:
    assert METER.VOLTAGE.absent == {"not_measured": -0x8000}
    assert (METER.VOLTAGE.state_of(-0x8000), METER.VOLTAGE.state_of(230)) == ("not_measured", None)
    assert (METER.POWER.state_of(9999.0), METER.POWER.state_of(math.nan)) == ("overflow", "out_of_range")
    assert PROBE.DISTANCE.state_of(math.nan) == "not_measured"


def test_none_is_the_only_absent_value() -> None:
    assert METER.VOLTAGE.from_unit(None) == -0x8000
    assert math.isnan(PROBE.DISTANCE.from_unit(None))
    assert PROBE.MeasureRequest(limit_mm=None).limit_state == "no_limit"
    record = METER.Sample(voltage_v=None, voltages=[5, 6])
    assert (record.voltage, record.voltage_v, record.voltage_state) == (0xFFFF, None, "not_measured")
    record.voltage_v = 1.5
    assert (record.voltage, record.voltage_v, record.voltage_state) == (15, 1.5, None)
    record.voltage_v = None
    assert record.voltage == METER.Sample.VOLTAGE_NOT_MEASURED


def test_none_is_refused_where_several_values_are_absent() -> None:
    with pytest.raises(CodecError, match=r"not_measured \(nan\) or too_far \(9999\)"):
        sample(distance_mm=None)
    record = METER.Sample(voltage_v=1, voltages=[5, -1])
    with pytest.raises(CodecError, match=r"None is not a single value of voltages: write low \(-1\) or high \(100\)"):
        record.voltages_v = [None, 1]
    assert (record.voltages_state, record.voltages_v) == ([None, "low"], [0.5, None])


def test_none_is_refused_where_no_value_is_absent() -> None:
    with pytest.raises(CodecError, match="ratio is a number, not None"):
        METER.RATIO.from_unit(None)
    with pytest.raises(TypeError, match="is missing 'distance' or 'distance_mm'"):
        sample()


def test_several_states_are_told_apart_both_ways() -> None:
    record = sample(distance=PROBE.Sample.DISTANCE_TOO_FAR)
    assert (record.distance_state, record.distance_mm) == ("too_far", None)
    record.distance = PROBE.Sample.DISTANCE_NOT_MEASURED
    assert (record.distance_state, record.distance_mm) == ("not_measured", None)
    assert record.widths_state == [None, "not_measured"]


@pytest.mark.parametrize(
    ("quantity", "reason"),
    [
        (9999, "out_of_range"),
        (9999.0001, "out_of_range"),
        (301, "out_of_range"),
        (1e39, "out_of_range"),
        ("far", "wrong_type"),
    ],
)
def test_no_quantity_becomes_a_state(quantity: object, reason: str) -> None:
    with pytest.raises(CodecError) as caught:
        sample(distance_mm=quantity)
    assert caught.value.reason == reason


def test_a_floating_point_register_keeps_fractions() -> None:
    assert PROBE.DISTANCE.from_unit(5.5) == 5.5
    assert PROBE.EXACT.from_unit(0.1) == 0.1
    assert PROBE.DISTANCE.from_unit(0.1) == struct.unpack("f", struct.pack("f", 0.1))[0]
    assert PROBE.WIDTH.from_unit(-5.25) == -5.25
    with pytest.raises(CodecError, match=r"not in 0\.\.300"):
        PROBE.DISTANCE.from_unit(300.5)
    with pytest.raises(CodecError, match=r"is 9999, which is sent as 9999\.0 and stands for overflow"):
        METER.POWER.from_unit(9999)


def test_a_count_of_zero_may_be_a_state() -> None:
    with pytest.raises(CodecError, match="whose count 0 stands for start_speed"):
        TC100.MOTION_SPEED.from_unit(0.0)


def test_the_number_of_a_nan_has_its_bits() -> None:
    width = newest(TEST_SPECS, "probe").device.register("width")
    assert width is not None
    number = number_of_sentinel(width.value, width.value.sentinels[0])
    assert struct.pack(">f", number).hex() == "ffffffff"
