"""An audit states for each value that can be written what the device does beyond its range, as far as it is printed."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

import gauge
from fieldspec.language.behaviour.reading import behaviour_of
from fieldspec.tools.audit.statements import beyond_ranges
from simulators import parts_of

WRITABLE = gauge.DEVICE.replace("range: 0..1000,", "range: 0..1000, access: rw,")
SIGNALS = {
    "mdi_velocity": "0..2147483647",
    "mdi_acceleration": "0..16384",
    "mdi_deceleration": "0..16384",
    "velocity_override": "0..32767",
    "torque_reduction": "0..16384",
    "positive_torque_limit": "0..32767",
    "negative_torque_limit": "-32768..0",
}
"""What 3.1 of the HIWIN E prints of the received signals that have fewer values than their words."""


def rows(device: str) -> Iterator[tuple[str, str, str, str]]:
    """Fact, range, answer and the line that prints it, of each value of a device."""
    for fact, ranges, answer, says, _ in beyond_ranges(*parts_of(device))[1].rows:
        yield str(fact), str(ranges), str(answer), says.text() if says is not None else ""


def test_each_signal_with_fewer_values_than_its_word_is_stated_as_not_printed() -> None:
    stated = {(fact.split("/")[-1], ranges) for fact, ranges, answer, _ in rows("hiwin-e") if answer == "not printed"}
    assert stated == set(SIGNALS.items())


def test_each_parameter_beyond_its_range_is_refused_by_the_line_of_the_error_number() -> None:
    stated = [(answer, says) for fact, _, answer, says in rows("hiwin-e") if fact.startswith("parameters/")]
    assert stated == [("refused", "4.3.6 L1420")] * 16


@pytest.mark.parametrize(("device", "source"), [("tc100", "8.3 L1776, 1780, 1782"), ("ck10", "1.4 L238")])
def test_registers_beyond_their_ranges_are_refused_by_the_line_of_the_exception(device: str, source: str) -> None:
    assert {(answer, says) for _, _, answer, says in rows(device)} == {("refused", source)}


def test_a_device_that_refuses_nothing_answers_no_value_beyond_its_range() -> None:
    subject = gauge.subject(WRITABLE)
    behaviour = behaviour_of(subject.spec.tree_at(subject.device.version))
    assert [row[:3] for row in beyond_ranges(subject.layout, behaviour)[1].rows] == [
        ("registers/level", "0..1000", "not printed"),
    ]
