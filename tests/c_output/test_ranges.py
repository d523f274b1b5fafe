"""A closed enum and a range are both tested only where the enum has a member outside the range."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.model.encoding import bounds_of, has_single_bytes, is_count, is_odd
from fieldspec.language.model.value import Value
from fieldspec.targets.c.backend import headers
from fieldspec.targets.c.naming import Naming
from layouts import SPECS, TEST_SPECS, layouts

NEWEST = [versions[-1] for root in (SPECS, TEST_SPECS) for versions in layouts(root).values()]


def expected_errors(layout: DeviceLayout, value: Value) -> tuple[bool, bool]:
    """Whether a number outside the enum, and one outside the ranges of the value or of its bits, can be written."""
    sentinels = {sentinel.value for sentinel in value.sentinels}
    enum = layout.device.enums[value.enum] if value.enum else None
    closed = enum is not None and not enum.open
    ranges = value.writable_ranges
    if enum is not None and closed:
        numbers = {member.value for member in enum.members if not member.unavailable}
    else:
        intervals = ranges.intervals if ranges is not None else ()
        numbers = {number for low, high in intervals for number in (low - 1, high + 1)}
    if value.flags and layout.device.flags[value.flags].bounded:
        return closed, True
    low, high = bounds_of(value.encoding)
    attempts = {number for number in numbers if low <= number <= high} - sentinels
    if (is_odd(value.encoding) or not has_single_bytes(value.encoding)) and not closed:
        return closed, True
    return closed, ranges is not None and any(number not in ranges for number in attempts)


@pytest.mark.parametrize("layout", NEWEST, ids=[layout.device.id for layout in NEWEST])
def test_a_register_tests_nothing_that_another_test_implies(layout: DeviceLayout) -> None:
    naming = Naming(layout.device.id)
    text = "".join(headers(layout, naming).values())
    for register in layout.registers:
        value = register.register.value
        if not is_count(value.encoding) or value.const is not None:
            continue
        name = naming.function("register", register.name, "encode")
        function = re.search(rf"{name}\(.*?\n}}\n", text, re.DOTALL)
        assert function is not None
        errors = tuple(naming.own_macro(error) in function[0] for error in ("err_unknown_value", "err_out_of_range"))
        assert errors == expected_errors(layout, value), register.name
