"""Whoever watches a device asks the same again and again: that is answered fast, and from the present."""

from __future__ import annotations

import sys
from types import FrameType
from typing import Any

import pytest

from fieldspec.tools.simulator.noted import Noted
from simulators import Unit

FRAME = bytes.fromhex("01 03 10 00 00 01 80 CA")

CHANGES = {
    "an item": lambda words: words.__setitem__(1, 7),
    "an item taken away": lambda words: words.__delitem__(1),
    "an update": lambda words: words.update({1: 7}),
    "a union": lambda words: words.__ior__({1: 7}),
    "a default": lambda words: words.setdefault(2, 7),
    "a pop": lambda words: words.pop(1),
    "the last item taken": lambda words: words.popitem(),
    "nothing left": lambda words: words.clear(),
    "another content": lambda words: words.replace({1: 7}),
}


@pytest.fixture
def unit() -> Unit:
    return Unit("tc100", "rtu")


def calls_of_answer(unit: Unit) -> int:
    """How many functions are called for one answer."""
    count = 0

    def note_call(frame: FrameType, event: str, argument: Any) -> None:
        nonlocal count
        count += event in ("call", "c_call")

    sys.setprofile(note_call)
    try:
        unit.wait(0.01)
        unit.answer_to(FRAME)
    finally:
        sys.setprofile(None)
    return count


def test_answering_a_request_again_takes_an_eighth_of_the_calls_that_judging_it_takes(unit: Unit) -> None:
    first = calls_of_answer(unit)
    assert calls_of_answer(unit) < min(first / 8, 300)


def test_a_request_that_is_repeated_gets_the_value_of_the_present(unit: Unit) -> None:
    answers = []
    for speed in (5, 6, 5):
        unit.write(0x2014, speed)
        answers.append(unit.read(0x2014))
    assert answers == [[5], [6], [5]]


def test_what_signals_show_goes_on_in_a_motion_while_the_same_request_is_repeated(unit: Unit) -> None:
    unit.write(0x201E, 3)
    unit.wait(10)
    unit.write(0x2002, 0, 20000)
    unit.write(0x201E, 1)
    positions = set()
    for _ in range(4):
        unit.wait(0.1)
        positions.add(tuple(unit.read(0x100A, 2)))
    assert len(positions) == 4


@pytest.mark.parametrize("change", CHANGES)
def test_a_noted_dictionary_counts(change: str) -> None:
    words: Noted[int, int] = Noted()
    words.watch([1, 2])
    words.replace({1: 5})
    before = words.changes
    CHANGES[change](words)
    assert words.changes > before


@pytest.mark.parametrize(("watched_key", "value"), [(1, 5), (2, 6)])
def test_a_noted_dictionary_does_not_count_what_is_there_already_or_is_not_watched(
    watched_key: int, value: int
) -> None:
    words: Noted[int, int] = Noted()
    words.watch([watched_key])
    words.replace({1: 5})
    before = words.changes
    words[1] = value
    assert words.changes == before
