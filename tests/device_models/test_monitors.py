"""Each monitor finds what breaks its rule in a record that is written by hand, and nothing where the rule is kept."""

from __future__ import annotations

import pytest

from device_models.done_cases import DONE_CASES
from device_models.history import Violation
from device_models.monitor_cases import KINDS, Case
from device_models.monitors import MONITORS
from device_models.motion_cases import MOTION_CASES
from device_models.output_cases import OUTPUT_CASES
from device_models.record_texts import record_of
from device_models.stop_cases import STOP_CASES

CASES = (*OUTPUT_CASES, *MOTION_CASES, *DONE_CASES, *STOP_CASES)


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case.monitor.__name__} {case.rule}")
def test_a_monitor_finds_what_breaks_its_rule_and_nothing_else(case: Case) -> None:
    findings: list[Violation] = list(case.monitor(record_of(KINDS, case.breaks)))  # type: ignore[call-overload]
    assert case.rule in [item.rule for item in findings]
    assert [str(item) for item in case.monitor(record_of(KINDS, case.keeps))] == []  # type: ignore[attr-defined]


def test_each_monitor_has_a_case() -> None:
    assert {monitor.__name__ for monitor in MONITORS} == {case.monitor.__name__ for case in CASES}
