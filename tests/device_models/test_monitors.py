"""Each monitor finds what breaks its rule in a record that is written by hand, and nothing where the rule is kept."""

from __future__ import annotations

import pytest

from device_models.history import Violation
from device_models.monitor_cases import AWAY, DONE, EDGE, KINDS, MOVES, MOVING, STANDS, Case
from device_models.monitors import MONITORS
from device_models.motion_rules import (
    a_valid_position_is_true,
    an_alarm_ends_a_motion,
    done_is_at_the_target,
    home_is_done_by_this_run,
    nothing_is_done_without_power,
    silence_is_an_error,
    somebody_is_responsible,
    two_edges_start_once,
    who_fails_stops_or_says_so,
    who_is_aborted_has_a_successor,
    who_is_refused_ends_with_an_error,
)
from device_models.output_rules import (
    a_falling_edge_ends_nothing,
    a_start_has_an_edge,
    an_edge_is_answered_at_once,
    an_end_has_a_beginning,
    an_end_is_seen_once,
    an_error_has_a_number,
    done_is_for_the_last_edge,
    nothing_in_the_first_scan,
    outputs_exclude_each_other,
    the_first_telegram_starts_nothing,
    values_count_at_the_edge,
    values_out_of_range_are_refused,
)
from device_models.record_texts import record_of
from device_models.stop_cases import STOP_CASES

CASES = (
    Case(nothing_in_the_first_scan, 1, ("+Move.Execute", "", "-Move.Execute", EDGE), (EDGE, "")),
    Case(nothing_in_the_first_scan, 1, ("", EDGE), ("", EDGE, "restart")),
    Case(an_edge_is_answered_at_once, 2, ("", EDGE), ("", "+Move.Execute")),
    Case(an_edge_is_answered_at_once, 2, ("", "+Move.Execute +Move.Error"), ("", f"{EDGE} +Move.Done")),
    Case(outputs_exclude_each_other, 3, ("+Stop.Done +Stop.Busy",), ("+Move.Done +Move.Busy",)),
    Case(an_error_has_a_number, 4, ("+Move.Error Move.ErrorID=2",), ("+Move.Error",)),
    Case(an_error_has_a_number, 4, ("",), ("Move.ErrorID=2",)),
    Case(a_falling_edge_ends_nothing, 5, ("", EDGE, "-Move.Execute"), ("", EDGE, "-Move.Execute -Move.Busy")),
    Case(
        an_end_is_seen_once,
        6,
        ("", EDGE, "-Move.Execute", DONE, "-Move.Done"),
        ("", EDGE, "-Move.Execute", DONE, ""),
    ),
    Case(an_end_is_seen_once, 7, ("", EDGE, DONE, "", AWAY), ("", EDGE, DONE, "-Move.Done")),
    Case(an_end_is_seen_once, 7, ("", EDGE, DONE, AWAY), ("", EDGE, DONE, "-Move.Execute")),
    Case(
        an_end_is_seen_once,
        7,
        ("", "+Stop.Execute +Stop.Busy", "-Stop.Busy +Stop.Done", "+Stop.Busy -Stop.Done"),
        ("", "+Stop.Execute +Stop.Busy", "-Stop.Busy +Stop.Done", "-Stop.Done"),
    ),
    Case(an_end_has_a_beginning, 8, ("", EDGE, DONE), ("", "+Move.Done")),
    Case(
        values_count_at_the_edge,
        9,
        ("Move.value=500", EDGE, f"Move.value=700 {MOVES}"),
        ("Move.value=700", EDGE, f"Move.value=500 {MOVES}"),
    ),
    Case(
        values_count_at_the_edge,
        10,
        ("Move.value=300", EDGE, "-Move.Execute", "+Move.Execute Move.value=500", MOVES),
        ("Move.value=500", EDGE, "-Move.Execute", "+Move.Execute Move.value=300", MOVES),
    ),
    Case(
        done_is_for_the_last_edge,
        10,
        ("", EDGE, MOVES, "-Move.Execute", "+Move.Execute", "accepted:absolute:2:700 n2", DONE),
        ("", EDGE, MOVES, "-Move.Execute", "+Move.Execute", DONE),
    ),
    Case(
        done_is_for_the_last_edge,
        11,
        ("", EDGE, MOVES, "-Move.Execute", "+Move.Execute -Move.Busy +Move.Error"),
        ("", EDGE, MOVES, "-Move.Execute", f"+Move.Execute {DONE}"),
    ),
    Case(
        values_out_of_range_are_refused,
        12,
        ("", "invalid:Move +Move.Execute +Move.Error Move.ErrorID=1"),
        ("", f"invalid:Move {EDGE}"),
    ),
    Case(
        values_out_of_range_are_refused,
        12,
        ("", "invalid:Move +Move.Execute +Move.Error Move.ErrorID=1"),
        ("", "invalid:Move +Move.Execute +Move.Error Move.ErrorID=1", MOVES),
    ),
    Case(
        values_out_of_range_are_refused,
        12,
        ("", EDGE, "-Move.Execute", "invalid:Move +Move.Execute", "-Move.Busy +Move.Error Move.ErrorID=1"),
        ("", EDGE, "-Move.Execute", "invalid:Move +Move.Execute", DONE),
    ),
    Case(
        values_out_of_range_are_refused,
        12,
        ("ms:50", EDGE, "-Move.Execute", "invalid:Move +Move.Execute", "-Move.Busy +Move.Error Move.ErrorID=1 x300"),
        ("ms:50", EDGE, "-Move.Execute", "invalid:Move +Move.Execute", "x300"),
    ),
    Case(a_start_has_an_edge, 13, ("", EDGE, "skip:Move", MOVES), (EDGE, MOVES)),
    Case(a_start_has_an_edge, 13, ("", EDGE, MOVES), ("", EDGE, "restart", MOVES)),
    Case(a_start_has_an_edge, 38, ("", EDGE, MOVES), ("", EDGE, MOVES, "ask:start_absolute")),
    Case(
        somebody_is_responsible,
        15,
        ("", EDGE, MOVES, f"{STANDS} {DONE}"),
        ("", EDGE, MOVES, DONE),
    ),
    Case(
        somebody_is_responsible,
        15,
        ("", EDGE, MOVES, "-Move.Busy +Move.Error Move.ErrorID=2"),
        ("", EDGE, MOVES, "-Move.Busy +Move.Error Move.ErrorID=6"),
    ),
    Case(
        somebody_is_responsible,
        15,
        ("", EDGE, "accepted:absolute:1 w1", "stop:command", "-Move.Busy +Move.Error Move.ErrorID=2", MOVING),
        ("", EDGE, "accepted:absolute:1 w1", "stop:command", "-Move.Busy +Move.CommandAborted", MOVING),
    ),
    Case(
        somebody_is_responsible,
        15,
        ("", EDGE, MOVES, "+Other.Error Other.ErrorID=2", ""),
        ("", EDGE, MOVES, "+Other.Error Other.ErrorID=2", DONE),
    ),
    Case(
        who_is_aborted_has_a_successor,
        16,
        (
            *("", EDGE, MOVES, "+Other.Execute +Other.Busy", "accepted:relative:2:10 w2"),
            "-Move.Busy +Move.CommandAborted",
        ),
        ("", EDGE, MOVES, "+Other.Execute +Other.Busy -Move.Busy +Move.CommandAborted"),
    ),
    Case(
        who_is_aborted_has_a_successor,
        20,
        ("", EDGE, MOVES, "interrupted:absolute:1 n0 v0", "-Move.Busy +Move.CommandAborted"),
        ("", EDGE, MOVES, "-Move.Busy +Move.CommandAborted"),
    ),
    Case(
        who_is_refused_ends_with_an_error,
        17,
        ("", EDGE, "refused:absolute", "", "-Move.Busy +Move.Error"),
        ("", EDGE, "refused:absolute", "", DONE),
    ),
    Case(
        who_is_refused_ends_with_an_error,
        17,
        ("ms:50", EDGE, "refused:absolute", "", "-Move.Busy +Move.Error x300"),
        ("ms:50", EDGE, "refused:absolute", "x300"),
    ),
    Case(
        two_edges_start_once,
        18,
        ("", f"{EDGE} +Other.Execute +Other.Busy", "ask:start_relative", "-Move.Busy +Move.CommandAborted"),
        ("", f"{EDGE} +Other.Execute +Other.Busy", "ask:start_relative", "ask:start_absolute"),
    ),
    Case(
        who_fails_stops_or_says_so,
        21,
        ("", EDGE, MOVES, "-Move.Busy +Move.Error Move.ErrorID=6", "ask:stop", ""),
        ("", EDGE, MOVES, "-Move.Busy +Move.Error Move.ErrorID=6", "ask:read", "ask:read"),
    ),
    Case(
        who_fails_stops_or_says_so,
        21,
        ("", EDGE, MOVES, "+Move.Abort -Move.Busy +Move.CommandAborted", "ask:stop", ""),
        ("", EDGE, MOVES, "+Move.Abort -Move.Busy +Move.CommandAborted", "ask:read", "ask:read"),
    ),
    Case(
        who_is_refused_ends_with_an_error,
        17,
        ("", EDGE, "refused:absolute", "+Other.Execute +Other.Busy", "-Move.Busy +Move.CommandAborted"),
        ("", EDGE, "refused:absolute", "", "-Move.Busy +Move.CommandAborted"),
    ),
    Case(
        two_edges_start_once,
        18,
        ("ms:50", f"{EDGE} +Other.Execute +Other.Busy", "-Move.Busy +Move.CommandAborted x300"),
        ("ms:50", f"{EDGE} +Other.Execute +Other.Busy", "x300"),
    ),
    Case(
        nothing_is_done_without_power,
        32,
        ("off", EDGE, "", "-Move.Busy +Move.Error Move.ErrorID=10"),
        ("off", EDGE, "", DONE),
    ),
    Case(
        nothing_is_done_without_power, 32, ("ms:50 alarm", EDGE, f"{DONE} well", "x300"), ("ms:50 alarm", EDGE, "x300")
    ),
    Case(
        an_alarm_ends_a_motion,
        33,
        ("", EDGE, MOVES, "alarm:3 alarm n0 v0", "-Move.Busy +Move.Error Move.ErrorID=8"),
        ("", EDGE, MOVES, "alarm:3 alarm n0 v0", "-Move.Busy +Move.Error Move.ErrorID=10"),
    ),
    Case(
        an_alarm_ends_a_motion,
        33,
        ("ms:50", EDGE, MOVES, "alarm:3 alarm n0 v0", "-Move.Busy +Move.Error Move.ErrorID=8 x300"),
        ("ms:50", EDGE, MOVES, "alarm:3 alarm n0 v0", "x300"),
    ),
    Case(
        an_alarm_ends_a_motion,
        33,
        ("", EDGE, MOVES, "alarm:3 alarm n0 v0", "stop:command", "-Move.Busy +Move.CommandAborted"),
        ("", EDGE, MOVES, "alarm:3 alarm n0 v0", "-Move.Busy +Move.CommandAborted"),
    ),
    Case(
        an_alarm_ends_a_motion,
        33,
        ("ms:50", EDGE, MOVES, "alarm:3 alarm n0 v0", "-Move.Busy +Move.Error Move.ErrorID=8 x400"),
        ("ms:50", EDGE, MOVES, "alarm:3 alarm n0 v0 x200", "-Move.Busy +Move.Error Move.ErrorID=8 x400"),
    ),
    Case(
        home_is_done_by_this_run,
        34,
        ("", "+Home.Execute +Home.Busy", "accepted:home:1 n1", "reached:home:1 n0", "-Home.Busy +Home.Done"),
        ("", "+Home.Execute +Home.Busy", "accepted:home:1 n1", "interrupted:home:1 n0", "-Home.Busy +Home.Done"),
    ),
    Case(done_is_at_the_target, 37, ("", EDGE, MOVES, STANDS, DONE), ("", EDGE, MOVES, DONE)),
    Case(done_is_at_the_target, 37, ("", EDGE, MOVES, STANDS, DONE), ("", EDGE, DONE)),
    Case(
        done_is_at_the_target,
        37,
        ("p500", EDGE, "ask:start_absolute accepted:absolute:1:500 w1", DONE),
        ("p400", EDGE, "ask:start_absolute accepted:absolute:1:500 w1", DONE),
    ),
    Case(
        a_start_has_an_edge,
        38,
        ("", EDGE, "-Move.Execute", f"+Move.Execute {MOVES}", "ask:start_absolute"),
        ("", EDGE, "-Move.Execute", f"+Move.Execute {MOVES}", "ask:start_absolute", "ask:start_absolute"),
    ),
    Case(
        two_edges_start_once,
        18,
        ("", EDGE, "-Move.Execute", f"{EDGE} ask:start_absolute +Other.Execute +Other.Busy", "ask:start_relative"),
        ("", f"{EDGE} ask:start_absolute +Other.Execute +Other.Busy", "ask:start_relative"),
    ),
    Case(
        silence_is_an_error,
        38,
        ("ms:50", EDGE, "lost x250", "-Move.Busy +Move.Error Move.ErrorID=2"),
        ("ms:50", EDGE, "lost x900"),
    ),
    Case(
        a_valid_position_is_true,
        39,
        ("p500", "+Read.Enable +Read.Valid Read.diPositionRaw=500"),
        ("p500", "+Read.Enable +Read.Valid Read.diPositionRaw=1426063360"),
    ),
    Case(
        a_valid_position_is_true,
        39,
        ("p500", "+Read.Enable +Read.Valid Read.diPositionRaw=500", "-Read.Enable -Read.Valid"),
        ("p500", "+Read.Enable +Read.Valid Read.diPositionRaw=500", "-Read.Enable"),
    ),
    Case(
        a_valid_position_is_true,
        39,
        ("ms:50 p500", "+Read.Enable +Read.Valid Read.diPositionRaw=500", "p900 x100", "Read.diPositionRaw=900 x300"),
        ("ms:50 p500", "+Read.Enable +Read.Valid Read.diPositionRaw=500", "p900 x300"),
    ),
    Case(the_first_telegram_starts_nothing, 40, ("word:0406", "word:040F"), ("word:040F",)),
    Case(the_first_telegram_starts_nothing, 40, ("word:0406",), ("word:0406", "restart word:0047")),
)


@pytest.mark.parametrize("case", [*CASES, *STOP_CASES], ids=lambda case: f"{case.monitor.__name__} {case.rule}")
def test_a_monitor_finds_what_breaks_its_rule_and_nothing_else(case: Case) -> None:
    findings: list[Violation] = list(case.monitor(record_of(KINDS, case.breaks)))  # type: ignore[call-overload]
    assert case.rule in [item.rule for item in findings]
    assert [str(item) for item in case.monitor(record_of(KINDS, case.keeps))] == []  # type: ignore[attr-defined]


def test_each_monitor_has_a_case() -> None:
    assert {monitor.__name__ for monitor in MONITORS} == {case.monitor.__name__ for case in (*CASES, *STOP_CASES)}
