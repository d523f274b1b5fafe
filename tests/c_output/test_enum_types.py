"""Values of closed enums have the types of these enums in C, and never a number that is not a member."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compilers import compiled

from fieldspec.targets.c.backend import headers
from fieldspec.targets.c.naming import Naming
from layouts import SPECS, TEST_SPECS, layouts

CAST = """
#include "tc100_v2_0.h"
int main(void)
{
    static const uint8_t unknown[] = {0x00, 0x02};
    uint8_t bytes[] = {0xAA, 0xAA};
    volatile unsigned number = 256;
    tc100_servo_command servo = TC100_SERVO_COMMAND_SERVO_OFF;
    if (tc100_reg_motion_command_encode((tc100_motion_command)number, bytes) != TC100_ERR_UNKNOWN_VALUE) return 1;
    if (bytes[0] != 0xAA || bytes[1] != 0xAA) return 2;
    if (tc100_reg_servo_decode(unknown, &servo) != TC100_ERR_UNKNOWN_VALUE) return 3;
    return servo == TC100_SERVO_COMMAND_SERVO_OFF ? 0 : 4;
}
"""


@pytest.mark.parametrize(
    ("compiler", "flags"),
    [("sanitized", ()), ("g++", ()), ("tcc", ()), ("gcc", ("-fshort-enums",)), ("clang", ("-fshort-enums",))],
    ids=["sanitized", "g++", "tcc", "gcc-short", "clang-short"],
)
def test_a_number_that_is_no_member_is_refused_and_never_becomes_an_enum(
    tmp_path: Path, compiler: str, flags: tuple[str, ...]
) -> None:
    layout = layouts(SPECS)["tc100"][-1]
    for path, text in headers(layout, Naming("tc100")).items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    source = tmp_path / "cast.c"
    source.write_text(CAST, encoding="utf-8")
    program = compiled(compiler, source, tmp_path / "cast", *flags)
    assert subprocess.run([str(program)], check=False).returncode == 0


def test_values_of_closed_enums_have_their_types_and_others_say_why_not() -> None:
    text = "".join(headers(layouts(TEST_SPECS)["widget"][-1], Naming("widget")).values())
    assert "widget_reg_paint_encode(widget_color value, " in text
    assert "widget_reg_paint_decode(const uint8_t *in, uint16_t *out)" in text
    assert "An integer, as the device may answer what color does not have." in text
    assert "widget_reg_direction_decode(const uint8_t *in, widget_direction *out)" in text
