"""A closed enum and a range are both tested only where the enum has a member outside the range."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compiling import compiled

from fieldspec.backends.c.backend import header
from fieldspec.backends.c.naming import Naming
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.value import Kind, Value
from layouts import SPECS, TEST_SPECS, layouts

NEWEST = [versions[-1] for root in (SPECS, TEST_SPECS) for versions in layouts(root).values()]


def expected_errors(layout: DeviceLayout, value: Value) -> tuple[bool, bool]:
    """Whether a number outside the enum, and a member of the enum outside the range, can be written."""
    sentinels = {sentinel.value for sentinel in value.sentinels}
    enum = layout.device.enums[value.enum] if value.enum else None
    closed = enum is not None and not enum.open
    ranges = value.writable_ranges
    if enum is not None and closed:
        numbers = {member.value for member in enum.members if not member.unavailable}
    else:
        intervals = ranges.intervals if ranges is not None else ()
        numbers = {number for low, high in intervals for number in (low - 1, high + 1)}
    attempts = {number for number in numbers if value.type.low <= number <= value.type.high} - sentinels
    return closed, ranges is not None and any(number not in ranges for number in attempts)


@pytest.mark.parametrize("layout", NEWEST, ids=[layout.device.id for layout in NEWEST])
def test_a_register_tests_nothing_that_another_test_implies(layout: DeviceLayout) -> None:
    naming = Naming(layout.device.id)
    text = header(layout, naming)
    for register in layout.registers:
        value = register.register.value
        if value.type.kind is not Kind.INTEGER or value.const is not None:
            continue
        name = naming.function("register", register.name, "encode")
        function = re.search(rf"{name}\(.*?\n}}\n", text, re.DOTALL)
        assert function is not None
        errors = tuple(naming.own_macro(error) in function[0] for error in ("err_unknown_value", "err_out_of_range"))
        assert errors == expected_errors(layout, value), register.name


CAST = """
#include "tc100_v2_0.h"
int main(void)
{
    static const uint8_t unknown[] = {0x00, 0x02};
    uint8_t bytes[] = {0xAA, 0xAA};
    volatile unsigned number = 5;
    tc100_servo_command servo = TC100_SERVO_COMMAND_SERVO_OFF;
    if (tc100_reg_motion_command_encode((tc100_motion_command)number, bytes) != TC100_ERR_UNKNOWN_VALUE) return 1;
    if (bytes[0] != 0xAA || bytes[1] != 0xAA) return 2;
    if (tc100_reg_servo_decode(unknown, &servo) != TC100_ERR_UNKNOWN_VALUE) return 3;
    return servo == TC100_SERVO_COMMAND_SERVO_OFF ? 0 : 4;
}
"""


def test_a_number_that_is_no_member_is_refused_and_never_becomes_an_enum(tmp_path: Path) -> None:
    layout = layouts(SPECS)["tc100"][-1]
    (tmp_path / "tc100_v2_0.h").write_text(header(layout, Naming("tc100")), encoding="utf-8")
    source = tmp_path / "cast.c"
    source.write_text(CAST, encoding="utf-8")
    for compiler in ("sanitized", "g++", "tcc"):
        program = compiled(compiler, source, tmp_path / "cast")
        assert subprocess.run([str(program)], check=False).returncode == 0, compiler


def test_values_of_closed_enums_have_their_types_and_others_say_why_not() -> None:
    layout = layouts(MADE_UP)["widget"][-1]
    text = header(layout, Naming("widget"))
    assert "widget_reg_paint_encode(widget_color value, " in text
    assert "widget_reg_paint_decode(const uint8_t *in, uint16_t *out)" in text
    assert "An integer, as the device may answer what color does not have." in text
    assert "widget_reg_direction_decode(const uint8_t *in, widget_direction *out)" in text
