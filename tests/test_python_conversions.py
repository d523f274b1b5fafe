"""The generated conversions and units of normalised values, against exact fractions."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from example_counts import examples
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.model.value import Conversion
from fieldspec.targets import OUTPUTS
from layouts import TEST_SPECS, all_layouts, newest
from python_package import codec_error, module_of

GLIDER = module_of(newest(TEST_SPECS, "glider-x"))
CodecError = codec_error()
CONVERSIONS = [
    pytest.param(layout, conversion, id=f"{layout.device.id}-{layout.device.version}-{conversion.name}")
    for layout in all_layouts()
    for conversion in layout.device.conversions.values()
]
REFERENCES = st.one_of(
    st.integers(-(2**31), 2**31),
    st.floats(1e-6, 1e9),
    st.floats(-1e9, -1e-6),
    st.decimals(1, 1000, places=3),
    st.fractions(Fraction(1, 7), 1000),
)


def ranges_of(layout: DeviceLayout, conversion: Conversion) -> list[tuple[int, int]]:
    """The counts that the signals of a conversion may have."""
    signal_ranges = {layout.device.signals[name].value.ranges for name in conversion.signals}
    ranges = signal_ranges.pop() if len(signal_ranges) == 1 else None
    return list(ranges.intervals) if ranges else [(conversion.type.low, conversion.type.high)]


def counts_of(layout: DeviceLayout, conversion: Conversion) -> st.SearchStrategy[int]:
    return st.one_of(*(st.integers(low, high) for low, high in ranges_of(layout, conversion)))


@pytest.mark.proof(8)
@pytest.mark.parametrize(("layout", "conversion"), CONVERSIONS)
@examples(60)
@given(data=st.data())
def test_a_count_comes_back_from_its_quantity(
    layout: DeviceLayout, conversion: Conversion, data: st.DataObject
) -> None:
    module = module_of(layout)
    raw, reference = data.draw(counts_of(layout, conversion)), data.draw(REFERENCES.filter(bool))
    quantity = getattr(module, f"{conversion.name}_from_raw")(raw, reference)
    exact = conversion.quantity(raw, Fraction(reference))
    assert quantity == float(exact)
    back = getattr(module, f"{conversion.name}_to_raw")
    assert back(exact, reference) == raw
    assert abs(back(quantity, reference) - raw) <= 1


def ends_of(layout: DeviceLayout, conversion: Conversion) -> list[int]:
    return [end for interval in ranges_of(layout, conversion) for end in interval]


@pytest.mark.parametrize(("layout", "conversion"), CONVERSIONS)
def test_a_quantity_that_no_count_stands_for_is_refused(layout: DeviceLayout, conversion: Conversion) -> None:
    back = getattr(module_of(layout), f"{conversion.name}_to_raw")
    for beyond in (min(ends_of(layout, conversion)) - 1, max(ends_of(layout, conversion)) + 1):
        with pytest.raises(CodecError) as caught:
            back(conversion.quantity(beyond, Fraction(3000)), 3000)
        assert caught.value.reason == "out_of_range"
        assert conversion.name in caught.value.detail
    for quantity, reference in ((1, 0), (1, float("nan")), (1, float("inf")), (float("nan"), 1), (float("inf"), 1)):
        with pytest.raises(CodecError) as caught:
            back(quantity, reference)
        assert caught.value.reason == "out_of_range"


@pytest.mark.parametrize(
    ("name", "raw", "reference", "quantity"),
    [
        ("commanded_speed", 0x40000000, 3000, 3000.0),
        ("commanded_speed", -0x20000000, 3000, -1500.0),
        ("commanded_speed", 1, 2**30, 1.0),
        ("output_torque", 0, 1.27, 1.27),
        ("output_torque", 0x4000, 1.27, 0.0),
        ("output_torque", 0x1000, 4, 3.0),
        ("short_speed", -0x8000, 20, -40.0),
    ],
)
def test_a_count_is_a_share_of_its_reference(name: str, raw: int, reference: float, quantity: float) -> None:
    assert getattr(GLIDER, f"{name}_from_raw")(raw, reference) == quantity
    assert getattr(GLIDER, f"{name}_to_raw")(quantity, reference) == raw


def test_the_nearest_count_is_taken_and_of_two_the_even_one() -> None:
    assert [GLIDER.short_speed_to_raw(Decimal(tenths) / 10, 0x4000) for tenths in (14, 15, 16, 25, 35, -15, -25)] == [
        1,
        2,
        2,
        2,
        4,
        -2,
        -2,
    ]
    assert [GLIDER.output_torque_to_raw(0x4000 - Fraction(n, 2), 0x4000) for n in (1, 3, 5)] == [0, 2, 2]


def test_the_docstring_gives_the_formula_and_what_holds_the_reference() -> None:
    doc = " ".join(GLIDER.commanded_speed_from_raw.__doc__.split())
    assert "reference * raw / 0x40000000" in doc
    assert "actual = NSET / 40000000h * reference" in doc
    assert "Pt317 (`reference_speed`, in rpm)" in doc
    assert "reference * (1 - raw / 0x4000)" in " ".join(GLIDER.output_torque_from_raw.__doc__.split())


def telegram(**changes: Any) -> Any:
    """A telegram with normalised values."""
    message = GLIDER.Telegram11Request(GLIDER.ControlWordPositioning(), 0, 0, 0)
    for name, value in changes.items():
        setattr(message, name, value)
    return message


def test_normalised_values_are_also_values_in_their_units() -> None:
    message = telegram(gain=1500, torque_reduction=0x2000)
    assert (message.gain_per_s, message.torque_reduction_percent) == (1.5, 50.0)
    message.gain_per_s, message.torque_reduction_percent = -0.25, 100
    assert (message.gain, message.torque_reduction) == (-250, 0x4000)
    speed = GLIDER.Telegram3Request(GLIDER.ControlWord(), 0)
    speed.speed_setpoint_percent = -200
    assert speed.speed_setpoint == -(2**31)
    with pytest.raises(CodecError):
        speed.speed_setpoint_percent = 200
    with pytest.raises(CodecError):
        message.torque_reduction_percent = 100.01
    assert speed.speed_setpoint_percent == -200


@settings(deadline=None)
@given(st.integers(-(2**31), 2**31 - 1))
@example(2**31 - 1)
@example(1)
def test_a_normalised_count_is_rounded_once_and_comes_back(raw: int) -> None:
    message = GLIDER.Telegram3Request(GLIDER.ControlWord(), raw)
    assert message.speed_setpoint_percent == float(Fraction(100 * raw, 2**30))
    message.speed_setpoint_percent = message.speed_setpoint_percent
    assert message.speed_setpoint == raw


def test_conversions_have_the_same_names_in_python_and_in_c() -> None:
    layout = newest(TEST_SPECS, "glider-x")
    header = "".join(str(content) for path, content in OUTPUTS["c"].files([layout]).items() if path.endswith(".h"))
    functions = [f"{name}_{end}" for name in layout.device.conversions for end in ("from_raw", "to_raw")]
    assert functions
    assert all(callable(getattr(GLIDER, function)) and f" glider_x_{function}(" in header for function in functions)
