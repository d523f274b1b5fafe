"""What outputs for programmable controllers share: it is of the layout that is asked for, and of all their dialects."""

from __future__ import annotations

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import attributes, replace
from fieldspec.targets.controllers.cache import cached
from fieldspec.targets.controllers.dialects import DIALECTS, STRUCTURED
from fieldspec.targets.controllers.structured.program import program, refusals
from layouts import TEST_SPECS, layout_at, newest
from spec_files import gadget

CLASH = """
enums:
  - {name: grip_mode, source: 1 L1, members: [{value: 0, name: off, source: L1}, {value: 1, name: on, source: L2}]}
  - {name: gripmode, source: 1 L3, members: [{value: 0, name: off, source: L3}, {value: 1, name: on, source: L4}]}
"""


def test_what_is_kept_is_of_the_layout_that_was_asked_for_last() -> None:
    asked: list[DeviceLayout] = []

    @cached
    def number(layout: DeviceLayout) -> int:
        asked.append(layout)
        return len(asked)

    first = newest(TEST_SPECS, "widget")
    second = replace(first)
    assert first == second
    assert [number(layout) for layout in (first, first, second, second, first)] == [1, 1, 2, 2, 3]


@pytest.mark.parametrize("name", ["st", "twincat", "plcopen"])
def test_dialects_that_share_a_program_differ_in_what_people_are_told_alone(name: str) -> None:
    row = DIALECTS[name]
    different = {text for text in attributes(type(row)) if getattr(row, text) != getattr(STRUCTURED, text)}
    assert different <= {"name", "title", "foreign"}


@pytest.mark.parametrize("name", ["st", "twincat", "plcopen"])
def test_what_all_of_them_refuse_is_said_of_each_by_its_title(name: str) -> None:
    (finding,) = refusals(layout_at(gadget(CLASH), "1"), DIALECTS[name])
    assert DIALECTS[name].title in finding.message


def test_a_program_has_the_text_of_each_routine_among_its_objects() -> None:
    widget_program = program(newest(TEST_SPECS, "widget"))
    assert [item.name for item in widget_program.functions] == [routine.name for routine in widget_program.routines]
    assert widget_program.items[-len(widget_program.functions) - 1 :] == (
        widget_program.sizes,
        *widget_program.functions,
    )
