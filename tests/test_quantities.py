"""A number or quantity that people write means the same in checks, in the layout and at the command line."""

from __future__ import annotations

import math
from decimal import Decimal

import pytest

from fieldspec.codec.explain.entered import nearest
from fieldspec.codec.layout.values import MeaningError, raw_value
from fieldspec.foundation.classes import replace
from fieldspec.language.checks.numbers import in_counts
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.language.model.quantity import count_of, quantity_of
from fieldspec.language.model.value import Sentinel, Value
from layouts import TEST_SPECS, newest

DEVICE = newest(TEST_SPECS, "widget").device
DISTANCE = Value(
    type=PRIMITIVES["i32"],
    size=4,
    characters=None,
    byte_order="",
    scale=Decimal("0.01"),
    scale_text="0.01",
    offset=Decimal(0),
    unit="mm",
    ranges=None,
    default=None,
    const=None,
    enum="",
    flags="",
    parameter=None,
    sentinels=(),
)


BROKEN = Sentinel(value=15, name="broken", doc="", sources=())


def in_layout(text: str) -> object:
    """The count that the layout makes of a text; None where it refuses it."""
    try:
        return raw_value(DEVICE, "distance", DISTANCE, text)
    except MeaningError:
        return None


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("0", 0),
        ("7", 7),
        ("-7", -7),
        ("0x1F", 31),
        ("007", None),
        ("-00", None),
        ("0b1", None),
        ("1_000", None),
        ("20.00 mm", 2000),
        ("20mm", 2000),
        ("0.07 mm", 7),
        ("007 mm", None),
        ("20  mm", None),
        ("20 cm", 20000),
        ("1.5 m", 150000),
        ("1 s", None),
        ("1 furlong", None),
        ("20", 20),
        ("far", None),
        ("", None),
    ],
)
def test_checks_and_layout_read_a_text_alike(text: str, count: int | None) -> None:
    assert (in_counts(DEVICE, DISTANCE, text), in_layout(text)) == (count, count)


@pytest.mark.parametrize(("text", "raw"), [("20.00 mm", 2000), ("20.004 mm", 2000), ("007 mm", None), ("20 cm", 20000)])
def test_the_nearest_count_is_of_the_same_quantities(text: str, raw: int | None) -> None:
    count = nearest(DEVICE, DISTANCE, text)
    assert (count.raw if count is not None else None) == raw


def test_a_count_has_no_unit_and_a_quantity_needs_one() -> None:
    assert (count_of("20 mm"), quantity_of("20"), quantity_of("-1.5 V")) == (None, None, (Decimal("-1.5"), "V"))


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("0.5", 0.5),
        ("-2.5e-3", -0.0025),
        ("7", 7.0),
        ("1_0", None),
        ("nan", None),
        ("inf", math.inf),
        ("-inf", -math.inf),
        ("1e999", None),
        (" 1", None),
        ("007", None),
        ("٣", None),
    ],
)
def test_a_floating_point_number_is_written_in_plain_digits(text: str, number: float | None) -> None:
    value = replace(DISTANCE, type=PRIMITIVES["f32"], scale=Decimal(1), unit="")
    if number is None:
        with pytest.raises(MeaningError, match="is not a number; write it as"):
            raw_value(DEVICE, "ratio", value, text)
    else:
        assert raw_value(DEVICE, "ratio", value, text) == number


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("2", 2),
        ("2.0", 20),
        ("-0.500", -5),
        ("+0.1", 1),
        ("0.0", 0),
        ("0x2", 2),
        ("2.", None),
        (".5", None),
        ("2e0", None),
    ],
)
def test_a_decimal_point_makes_the_scaled_number_of_a_value_without_a_unit(text: str, count: int | None) -> None:
    value = replace(DISTANCE, scale=Decimal("0.1"), unit="")
    assert in_counts(DEVICE, value, text) == count
    if count is None:
        with pytest.raises(MeaningError, match=r"or the scaled number with a decimal point, such as 2\.0"):
            raw_value(DEVICE, "ratio", value, text)
    else:
        assert raw_value(DEVICE, "ratio", value, text) == count


def test_a_number_with_a_point_in_a_spec_is_the_same_scaled_number() -> None:
    value = replace(DISTANCE, scale=Decimal("0.1"), unit="")
    assert (in_counts(DEVICE, value, -0.5), raw_value(DEVICE, "ratio", value, -0.5)) == (-5, -5)
    with pytest.raises(MeaningError, match="with its unit it may be a fraction"):
        raw_value(DEVICE, "distance", DISTANCE, -0.5)


def test_a_scaled_number_between_two_counts_gets_the_help_of_its_neighbours() -> None:
    value = replace(DISTANCE, scale=Decimal("0.1"), unit="")
    with pytest.raises(MeaningError, match=r"a whole number of counts of 0\.1; the nearest ones are 1\.9 and 2\.0$"):
        raw_value(DEVICE, "ratio", value, "1.95")
    with pytest.raises(MeaningError, match=r"`1\.5` would be the count 15, which stands for broken"):
        raw_value(DEVICE, "ratio", replace(value, sentinels=(BROKEN,)), "1.5")


@pytest.mark.parametrize("scale", [Decimal(1), Decimal("0.01")])
def test_a_point_alone_makes_no_quantity_of_a_count_or_of_a_value_with_a_unit(scale: Decimal) -> None:
    value = replace(DISTANCE, scale=scale, unit="" if scale == 1 else "mm")
    assert in_counts(DEVICE, value, "2.0") is None
    with pytest.raises(MeaningError, match="is not a number"):
        raw_value(DEVICE, "ratio", value, "2.0")


def test_a_quantity_between_two_counts_gets_the_help_of_its_neighbours() -> None:
    value = replace(DISTANCE, scale=Decimal("0.1"), offset=Decimal(-5), unit="mm")
    with pytest.raises(MeaningError, match=r"the nearest ones are 1\.2mm and 1\.3mm; it has the offset -5 mm"):
        raw_value(DEVICE, "distance", value, "1.23mm")
