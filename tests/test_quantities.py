"""A number or quantity that people write means the same in checks, in the layout and at the command line."""

from __future__ import annotations

from decimal import Decimal

import pytest

from fieldspec.checks.numbers import in_counts
from fieldspec.classes import replace
from fieldspec.explain.parameters import nearest
from fieldspec.layout.values import MeaningError, raw_value
from fieldspec.model.quantity import count_of, quantity_of
from fieldspec.model.value import PRIMITIVES, Value
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
        ("inf", None),
        ("1e999", None),
        (" 1", None),
        ("007", None),
        ("٣", None),
    ],
)
def test_a_floating_point_number_is_written_in_plain_digits(text: str, number: float | None) -> None:
    value = replace(DISTANCE, type=PRIMITIVES["f32"], scale=Decimal(1), unit="")
    if number is None:
        with pytest.raises(MeaningError, match="is no number; write it as"):
            raw_value(DEVICE, "ratio", value, text)
    else:
        assert raw_value(DEVICE, "ratio", value, text) == number


def test_a_quantity_between_two_counts_gets_the_help_of_its_neighbours() -> None:
    value = replace(DISTANCE, scale=Decimal("0.1"), offset=Decimal(-5), unit="mm")
    with pytest.raises(MeaningError, match=r"the nearest ones are 1\.2mm and 1\.3mm; it has the offset -5 mm"):
        raw_value(DEVICE, "distance", value, "1.23mm")
