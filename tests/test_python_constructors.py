"""Records of the generated Python are made of raw values or, by keyword, of quantities in their units."""

from __future__ import annotations

import re
from decimal import Decimal
from fractions import Fraction
from functools import partial
from inspect import signature
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from example_counts import examples
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from layouts import SPECS, TEST_SPECS, all_layouts, newest
from python_package import built, codec_error, module_of, outcome, record_class
from random_values import values_of

CodecError = codec_error()
WIDGET = module_of(newest(TEST_SPECS, "widget"))
ESC11 = module_of(newest(SPECS, "esc11"))


def quantities_of(record: type[Any]) -> list[str]:
    """The properties of a class that have a field in its unit, and that its constructor takes.

    It takes none whose scale depends on another field.
    """
    return [
        name
        for name, member in vars(record).items()
        if isinstance(member, property) and name not in record.__match_args__ and name in signature(record).parameters
    ]


def field_of(record: type[Any], quantity: str) -> str:
    """The field of a quantity, which its docstring names first."""
    match = re.match(r"\s*`(\w+)`", getattr(record, quantity).__doc__)
    assert match is not None
    return match[1]


def scaled_records(layout: DeviceLayout) -> list[RecordLayout]:
    """The records and messages of a device that have a quantity."""
    module = module_of(layout)
    messages = [data for message in layout.messages.values() for data in message.bodies]
    return [record for record in [*layout.records.values(), *messages] if quantities_of(record_class(module, record))]


SCALED = [
    pytest.param(layout, record, id=f"{layout.device.id}-{layout.device.version}-{record.name}")
    for layout in all_layouts()
    for record in scaled_records(layout)
]


@pytest.mark.proof(42)
@pytest.mark.parametrize(("layout", "record"), SCALED)
@examples(10)
@given(data=st.data())
def test_quantities_make_the_record_that_their_setters_make(
    layout: DeviceLayout, record: RecordLayout, data: st.DataObject
) -> None:
    expected = built(module_of(layout), layout, record, data.draw(values_of(layout, record)))
    arguments = {name: getattr(expected, name) for name in expected.__match_args__}
    for quantity in quantities_of(type(expected)):
        amount = getattr(expected, quantity)
        is_absent = amount is None or (isinstance(amount, list) and None in amount)
        if not is_absent and data.draw(st.booleans()):
            if outcome(partial(setattr, expected, quantity, amount))[0]:
                continue  # a raw value out of range is not a quantity, either
            del arguments[field_of(type(expected), quantity)]
            arguments[quantity] = amount
    assert repr(type(expected)(**arguments)) == repr(expected)


@pytest.mark.parametrize(
    ("quantity", "count"),
    [(20.00, 2000), (-1, -100), (Decimal("0.015"), 2), (Fraction(1, 3), 33), (0.005, 1), (0.015, 1)],
)
def test_a_request_takes_a_quantity_and_rounds_it_to_the_nearest_count(quantity: Any, count: int) -> None:
    request = ESC11.MoveRelativeRequest(distance_mm=quantity, speed=50)
    assert request == ESC11.MoveRelativeRequest(count, 50)
    assert request.encode() == ESC11.MoveRelativeRequest(distance=count, speed=50).encode()


def test_one_field_may_be_raw_and_another_a_quantity() -> None:
    assert WIDGET.Corner(5, y_mm=1.2) == WIDGET.Corner(x_mm=0.5, y=12) == WIDGET.Corner(5, 12)


def test_a_list_of_quantities_makes_a_list_of_counts() -> None:
    others: dict[str, Any] = {
        **{name: [] for name in ("colors", "alarms", "words", "switches", "titles")},
        "color": 255,
    }
    nest = WIDGET.Nest(WIDGET.Corner(0, 0), [], samples_percent=[1, Decimal("2.5"), 3], **others)
    assert nest.samples == [10, 25, 30]


@pytest.mark.parametrize("quantity", [1e9, -1e9, float("nan"), float("inf"), Decimal("NaN"), "1", [1]])
def test_a_quantity_is_refused_as_the_setter_refuses_it(quantity: Any) -> None:
    request = ESC11.MoveRelativeRequest(0, 50)
    with pytest.raises(CodecError) as expected:
        request.distance_mm = quantity
    with pytest.raises(CodecError) as caught:
        ESC11.MoveRelativeRequest(distance_mm=quantity, speed=50)
    assert str(caught.value) == str(expected.value)
    assert caught.value.reason == ("wrong_type" if isinstance(quantity, (str, list)) else "out_of_range")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"speed": 50}, "is missing 'distance' or 'distance_mm'"),
        ({"distance": 1}, "is missing 'speed'"),
        ({"distance_mm": 1}, "is missing 'speed'"),
        ({"distance": 1, "distance_mm": 1, "speed": 50}, "takes only one of 'distance' or 'distance_mm'"),
        ({"distance_m": 1, "speed": 50}, "unexpected keyword argument 'distance_m'"),
    ],
)
def test_a_field_has_exactly_one_of_its_two_arguments(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(TypeError, match=message):
        ESC11.MoveRelativeRequest(**arguments)


def test_a_quantity_has_no_place_among_the_raw_values() -> None:
    with pytest.raises(TypeError, match="takes only one of 'distance' or 'distance_mm'"):
        ESC11.MoveRelativeRequest(2000, 50, 20.00)
