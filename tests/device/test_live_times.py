"""The times of `live`: the silence that a manual prints before each request, and answers that come too late."""

from __future__ import annotations

import argparse

import pytest

from fieldspec.command.live.connection import connected
from fieldspec.tools.live.client import Client, NoAnswerError, Timing
from fieldspec.tools.simulator.clock import ManualClock
from fieldspec.tools.simulator.faults import Fault, Faults
from simulators import Unit, parts_of
from wires import Wire


@pytest.mark.parametrize(("device", "seconds"), [("esc11", 0.2), ("tc100 rtu", 3.5 * 10 / 19200), ("hiwin-e", 0.0)])
def test_the_printed_silence_is_kept_unless_another_one_is_asked_for(device: str, seconds: float) -> None:
    name, _, link = device.partition(" ")
    options = {"link": link or None, "unit": None, "baud": None, "parity": None, "data_bits": None, "timeout": 1.0}
    options |= {"retries": 0, "trace": False}
    for pause, expected in ((None, seconds), (0.7, 0.7)):
        arguments = argparse.Namespace(**options, pause=pause, fixed=[], format="text")
        with connected(parts_of(name)[0], arguments) as client:
            assert client.timing.pause == pytest.approx(expected)


def test_requests_are_as_far_apart_as_the_manual_prints() -> None:
    unit, clock = Unit("esc11", "serial"), ManualClock()
    wire = Wire(unit, Faults(), clock, "")
    sent: list[float] = []
    original = wire.write
    wire.write = lambda data: (sent.append(clock.now()), original(data))[1]  # type: ignore[method-assign]
    client = Client(unit.engine.layout, "serial", wire, 1, Timing(1.0, 0.2, 0), clock)
    answered = []
    for _ in range(3):
        client.ask("read_current_position", {})
        answered.append(clock.now())
    gaps = [begin - end for begin, end in zip(sent[1:], answered, strict=False)]
    assert all(gap > 0.199999 for gap in gaps), gaps


def test_a_late_answer_is_not_taken_for_that_to_the_next_request() -> None:
    unit, clock = Unit("tc100", "rtu"), ManualClock()
    wire = Wire(unit, Faults([Fault("late_answer", request=1, seconds=0.9)]), clock, "")
    client = Client(unit.engine.layout, "rtu", wire, 1, Timing(0.5, 0.0, 0), clock)
    unit.engine.memory.words["", 0x9013], unit.engine.memory.words["", 0x9033] = 11, 22
    with pytest.raises(NoAnswerError):
        client.ask("read_registers", {"address": 0x9013, "word_count": 1})
    assert client.ask("read_registers", {"address": 0x9033, "word_count": 1}).values["values"] == [22]


def test_an_answer_with_another_number_of_words_is_none() -> None:
    unit, clock = Unit("tc100", "rtu"), ManualClock()
    wire = Wire(unit, Faults(), clock, "")
    client = Client(unit.engine.layout, "rtu", wire, 1, Timing(0.5, 0.0, 0), clock)
    frame = unit.codec.encode("response", "read_registers", {**unit.head, "values": [1, 2]})
    wire.write = lambda data: wire.coming.append((clock.now(), frame, False))  # type: ignore[method-assign]
    with pytest.raises(NoAnswerError):
        client.ask("read_registers", {"address": 0x2014, "word_count": 1})
