"""Special values that are ranges, as in SAE J1939: the upper byte of a number says that it is an error or missing."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from fieldspec.codec.explain.values import decode_value
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.values import MeaningError, raw_of
from python_package import codec_error, module_apart, runtime
from random_devices.agreement import layouts_of

CASE = Path(__file__).parent / "random_devices" / "cases" / "special_ranges.yaml"
NUMBERS = (0, 1, 0xFAFF, 0xFDFF, 0xFE00, 0xFE01, 0xFE80, 0xFEFF, 0xFF00, 0xFFFE, 0xFFFF)


@pytest.fixture(scope="module")
def layout() -> DeviceLayout:
    return layouts_of(CASE.read_text(encoding="utf-8"))[0]


@pytest.fixture(scope="module")
def module(layout: DeviceLayout) -> Any:
    return module_apart(layout, "special_ranges")


def j1939(number: int) -> str | None:
    """What a number of two bytes is by SAE J1939-71: its upper byte is FE for an error, and FF where there is none."""
    return {0xFE: "error", 0xFF: "not_available"}.get(number >> 8)


def image(module: Any, number: int) -> bytes:
    """The bytes of a record in which only the first field is set."""
    record = module.ThrottleRequest(0, module.Gear(0), module.Lamps(0), 0, [0, 0], 0, [module.Gear(0)] * 2, 1)
    return number.to_bytes(2, "little") + bytes(record.encode())[2:]


@pytest.mark.parametrize("number", NUMBERS)
def test_each_number_of_an_interval_is_explained_by_its_state(layout: DeviceLayout, number: int) -> None:
    field = layout.messages["throttle"].data("request").fields[0]
    assert field.value is not None
    read = decode_value(layout.device, field.value, number.to_bytes(2, "little"), "little", False)
    assert [meaning.name for meaning in read.meanings] == [name for name in (j1939(number),) if name]
    assert (not read.text) == bool(j1939(number))


@pytest.mark.parametrize("number", NUMBERS)
def test_a_record_has_the_state_of_each_number_of_an_interval_and_no_quantity(module: Any, number: int) -> None:
    record = module.ThrottleRequest.decode(image(module, number))
    is_reserved = 0xFAFF < number < 0xFE00  # by SAE J1939-71 neither a quantity that is stated nor a state
    assert record.percent_state == ("out_of_range" if is_reserved else j1939(number))
    assert record.percent_percent == (None if j1939(number) else pytest.approx(number * 0.0025))
    if number != 0xFDFF:  # it is outside of the range, and means nothing
        assert bytes(record.encode()) == image(module, number)


def test_a_column_has_no_number_for_each_number_of_an_interval(module: Any) -> None:
    many = runtime("many")
    columns = many.decode_many(module.ThrottleRequest, b"".join(image(module, number) for number in NUMBERS))
    quantities = many.in_unit(module.ThrottleRequest, "percent", columns["percent"])
    assert [math.isnan(quantity) for quantity in quantities] == [bool(j1939(number)) for number in NUMBERS]


def test_the_least_number_of_an_interval_is_written_for_its_name(layout: DeviceLayout) -> None:
    record = layout.messages["throttle"].data("request")
    assert raw_of(layout.device, (), record, {"percent": "error", "lamps": "faulty"}) == {
        "percent": 0xFE00,
        "lamps": 0xF0,
    }
    with pytest.raises(MeaningError, match="would be the count 65152, which stands for error"):
        raw_of(layout.device, (), record, {"percent": "162.88%"})


def test_a_quantity_whose_count_is_in_an_interval_is_refused(module: Any) -> None:
    record = module.ThrottleRequest.decode(image(module, 0))
    with pytest.raises(codec_error(), match="out_of_range"):
        record.percent_percent = 0xFE80 * 0.0025
