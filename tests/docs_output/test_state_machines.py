"""State machines are drawn without an arrow over another one, and a table says the same."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator
from itertools import combinations

import pytest

from docs_output.documented import documentation
from fieldspec.language.model.machines import StateMachine
from fieldspec.targets.docs.document import Arrow, StateDrawing
from fieldspec.targets.docs.drawing import state_drawing
from layouts import SPECS, newest

ARROW = re.compile(r'<path class="arrow[^"]*" d="M(\d+) (\d+)H(\d+)V(\d+)H(\d+)"')
DRIVE = newest(SPECS, "hiwin-e").device.machines[0]
PAGES = ("hiwin-e/2.14.4.html", "tc100/2.0.html", "ck10/1.html", "esc11/1.17.html")


def segments(svg: str) -> Iterator[tuple[int, str, int, tuple[int, int]]]:
    """The lines of all arrows: the number of the arrow, the direction, the place across it, and the extent."""
    for number, path in enumerate(ARROW.findall(svg)):
        edge, start, out, end, tip = map(int, path)
        for kind, place, ends in (("H", start, (edge, out)), ("V", out, (start, end)), ("H", end, (out, tip))):
            yield number, kind, place, (min(ends), max(ends))


def drawings() -> Iterator[StateDrawing]:
    chance = random.Random(4)
    for count in range(2, 9):
        for _ in range(20):
            ways = [(a, b) for a in range(count) for b in range(count) if a != b]
            chosen = sorted(chance.sample(ways, min(len(ways), chance.randint(1, 9))))
            arrows = tuple(Arrow(a, b, str(at), chance.random() < 0.5) for at, (a, b) in enumerate(chosen))
            yield StateDrawing("State machine x", tuple(f"state_{at}" for at in range(count)), arrows)


def test_no_arrow_lies_on_another() -> None:
    for drawing in drawings():
        svg = state_drawing(drawing)
        lines = list(segments(svg))
        assert len(lines) == 3 * len(drawing.arrows)
        for (number, kind, place, low), (other, other_kind, other_place, high) in combinations(lines, 2):
            if number != other and (kind, place) == (other_kind, other_place):
                assert max(low[0], high[0]) > min(low[1], high[1]), drawing


def test_the_states_of_a_drive_are_those_of_its_rules() -> None:
    assert DRIVE.states[:2] == ("switching_on_inhibited", "ready_for_switching_on")
    ways = {transition.name: (transition.origins, transition.target) for transition in DRIVE.transitions}
    assert len(ways) == 13
    assert ways["switch_on"] == (("ready_for_switching_on",), "switched_on")
    assert ways["inhibited_by_off_2"] == (DRIVE.states[1:], "switching_on_inhibited")
    (off,) = (transition for transition in DRIVE.transitions if transition.name == "disable")
    assert (off.conditions, off.actions) == ((("servo_enable", ("false",)),), ("stop immediate",))


@pytest.mark.parametrize("page", PAGES)
def test_every_transition_is_in_the_drawing_and_in_the_table(page: str) -> None:
    text = documentation()[page]
    machines: tuple[StateMachine, ...] = newest(SPECS, page.partition("/")[0]).device.machines
    for machine in machines:
        if not machine.transitions:
            continue
        section = text.partition(f'<section id="{machine.place.path}">')[2].partition("</section>")[0]
        labels = re.findall(r'class="number" x="\d+" y="\d+">([^<]*)<', section)
        numbers = {int(number) for label in labels for number in label.split(", ")}
        leaving = [transition.origins != (transition.target,) for transition in machine.transitions]
        assert numbers == {number for number, leaves in enumerate(leaving, 1) if leaves}
        for transition in machine.transitions:
            assert f'<tr id="{machine.place.path}/{transition.name}"' in section
        for state in machine.states:
            assert f">{state}</text>" in section
            if len(machine.states) > 1:
                assert state in section.partition('aria-label="')[2].partition('"')[0]
