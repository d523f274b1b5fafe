"""Each monitor finds what breaks its rule in a record that is written by hand, and nothing where the rule is kept."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import pytest

from device_models.history import History, Violation
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
from device_models.stop_rules import (
    a_halt_is_aborted_by_a_successor,
    a_jog_ends_with_its_input,
    a_jog_stops_itself,
    a_jog_turns_at_standstill,
    a_stop_at_standstill_is_done,
    a_stop_comes_next,
    a_stop_is_done_at_standstill,
    a_stop_is_not_aborted,
    a_stop_locks_the_axis,
    a_stop_never_gives_up,
    both_directions_are_none,
    nothing_starts_while_it_is_locked,
    power_comes_at_the_first_try,
    who_follows_falls_to_neutral,
)

KINDS = {
    "Move": "absolute",
    "Other": "relative",
    "Home": "home",
    "Jog": "jog",
    "Stop": "stop",
    "Halt": "halt",
    "Speed": "velocity",
    "Power": "power_on",
    "Read": "read",
}
EDGE = "+Move.Execute +Move.Busy"
MOVES = "ask:start_absolute accepted:absolute:1:500 began:absolute:1:500 n1 v100"
JOGS = "ask:start_jog_forward accepted:jog_forward:1:1 began:jog_forward:1:1 n1 v100"
MOVING = "began:absolute:1:500 w0 n1 v100"
STANDS = "reached:absolute:1:500 n0 v0"
DONE = "-Move.Busy +Move.Done"
AWAY = "-Move.Execute -Move.Done"


@dataclass(frozen=True)
class Case:
    """A monitor, a record that keeps its rule, and one that breaks it."""

    monitor: Callable[[History], object]
    rule: int
    keeps: tuple[str, ...]
    breaks: tuple[str, ...]


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
        silence_is_an_error,
        38,
        ("ms:50", EDGE, "lost x500", "-Move.Busy +Move.Error Move.ErrorID=2"),
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
    Case(
        a_stop_comes_next,
        22,
        ("", "+Stop.Execute +Stop.Busy ask:read", "ask:stop"),
        ("", "+Stop.Execute +Stop.Busy", "ask:read", "ask:stop"),
    ),
    Case(
        a_stop_comes_next,
        22,
        ("ms:50", "+Stop.Execute +Stop.Busy", "ask:stop x300"),
        ("ms:50", "+Stop.Execute +Stop.Busy", "x300"),
    ),
    Case(
        a_stop_comes_next,
        22,
        ("word:043F", "word:042F +Stop.Execute +Stop.Busy"),
        ("word:043F", "+Stop.Execute +Stop.Busy", "word:042F"),
    ),
    Case(
        a_stop_never_gives_up,
        23,
        ("word:043F", "word:042F +Stop.Execute +Stop.Busy", "-Stop.Busy +Stop.Error"),
        ("word:043F", "+Stop.Execute +Stop.Busy", "-Stop.Busy +Stop.Error"),
    ),
    Case(
        a_stop_never_gives_up,
        23,
        ("", "+Stop.Execute +Stop.Busy", *("ask:stop",) * 3, "-Stop.Busy +Stop.Error Stop.ErrorID=2"),
        ("", "+Stop.Execute +Stop.Busy", "ask:stop", "-Stop.Busy +Stop.Error Stop.ErrorID=2"),
    ),
    Case(
        a_stop_never_gives_up,
        23,
        ("", "+Stop.Execute +Stop.Busy", "ask:stop stop:command", "-Stop.Busy +Stop.Error Stop.ErrorID=8"),
        ("", "+Stop.Execute +Stop.Busy", "ask:stop", "-Stop.Busy +Stop.Error Stop.ErrorID=8"),
    ),
    Case(
        a_stop_is_done_at_standstill,
        24,
        ("n1 v100", "+Stop.Execute +Stop.Busy", "n0 v0", "-Stop.Busy +Stop.Done"),
        ("n1 v100", "+Stop.Execute +Stop.Busy", "", "-Stop.Busy +Stop.Done"),
    ),
    Case(
        a_stop_is_done_at_standstill,
        24,
        ("w1", "+Stop.Execute +Stop.Busy", "+Stop.Done", "began:absolute:1 w0 n1 v9"),
        ("w1", "+Stop.Execute +Stop.Busy", "-Stop.Busy +Stop.Done", "began:absolute:1 w0 n1 v9"),
    ),
    Case(
        a_stop_locks_the_axis,
        25,
        ("", EDGE, "-Move.Execute", "+Stop.Execute +Stop.Busy", "", "+Move.Execute", "-Move.Busy +Move.CommandAborted"),
        ("", EDGE, "-Move.Execute", "+Stop.Execute +Stop.Busy", "", "+Move.Execute", DONE),
    ),
    Case(
        a_stop_locks_the_axis,
        25,
        ("", "+Stop.Execute +Stop.Busy", "", "skip:Stop +Move.Execute +Move.Error"),
        ("", "+Stop.Execute +Stop.Busy", "", f"skip:Stop {EDGE}", DONE),
    ),
    Case(
        a_stop_locks_the_axis,
        25,
        ("", "+Stop.Execute +Stop.Busy", "-Stop.Busy +Stop.Error", "+Move.Execute +Move.Error"),
        ("", "+Stop.Execute +Stop.Busy", "-Stop.Busy +Stop.Error", EDGE, DONE),
    ),
    Case(
        nothing_starts_while_it_is_locked,
        25,
        (
            "",
            "+Stop.Execute +Stop.Busy",
            "-Stop.Busy +Stop.Done",
            "-Stop.Execute -Stop.Done",
            EDGE,
            "ask:start_absolute",
        ),
        ("", EDGE, "+Stop.Execute +Stop.Busy", "ask:stop", "ask:start_absolute"),
    ),
    Case(
        nothing_starts_while_it_is_locked,
        26,
        ("", EDGE, "ask:start_absolute"),
        (
            "",
            "+Stop.Execute +Stop.Busy",
            "",
            EDGE,
            "-Stop.Busy -Stop.Execute +Stop.Done",
            "-Stop.Done",
            "ask:start_absolute",
        ),
    ),
    Case(
        a_halt_is_aborted_by_a_successor,
        20,
        ("", "+Halt.Execute +Halt.Busy", "accepted:absolute:1", "-Halt.Busy +Halt.CommandAborted"),
        ("", "+Halt.Execute +Halt.Busy", EDGE, "-Halt.Busy +Halt.CommandAborted"),
    ),
    Case(
        a_stop_locks_the_axis,
        25,
        ("ms:50", "+Stop.Execute +Stop.Busy", "", f"{EDGE}", "-Move.Busy +Move.Error x300"),
        ("ms:50", "+Stop.Execute +Stop.Busy", "", f"{EDGE}", f"{DONE} x300"),
    ),
    Case(
        a_stop_is_not_aborted,
        27,
        ("", "+Stop.Execute +Stop.Busy", "+Stop.Abort -Stop.Busy +Stop.CommandAborted"),
        ("", "+Stop.Execute +Stop.Busy", "-Stop.Busy +Stop.CommandAborted"),
    ),
    Case(
        a_stop_at_standstill_is_done,
        28,
        ("ms:50", "+Stop.Execute +Stop.Busy", "x50", "-Stop.Busy +Stop.Done x300"),
        ("ms:50", "+Stop.Execute +Stop.Busy", "x300"),
    ),
    Case(
        a_jog_ends_with_its_input,
        29,
        ("", "+Jog.JogForward +Jog.Busy", JOGS, "-Jog.JogForward", "ask:read", "ask:stop"),
        ("", "+Jog.JogForward +Jog.Busy", JOGS, "-Jog.JogForward", "ask:read", "ask:read"),
    ),
    Case(
        a_jog_ends_with_its_input,
        29,
        ("", "+Jog.JogForward +Jog.Busy", JOGS, "-Jog.JogForward", "ask:stop", "n0 v0", "-Jog.Busy"),
        ("", "+Jog.JogForward +Jog.Busy", JOGS, "-Jog.JogForward", "ask:stop", "-Jog.Busy"),
    ),
    Case(
        a_jog_ends_with_its_input,
        29,
        ("", "+Jog.JogForward +Jog.Busy", JOGS, "-Jog.JogForward +Jog.JogBackward", "ask:stop", "ask:read"),
        ("", "+Jog.JogForward +Jog.Busy", JOGS, "-Jog.JogForward +Jog.JogBackward", "ask:read", "ask:read"),
    ),
    Case(
        a_jog_ends_with_its_input,
        29,
        ("word:053F", "+Jog.JogForward +Jog.Busy", JOGS, "+Jog.JogBackward word:043F ask:stop"),
        ("word:053F", "+Jog.JogForward +Jog.Busy", JOGS, "+Jog.JogBackward"),
    ),
    Case(
        a_jog_ends_with_its_input,
        29,
        ("ms:50", "+Jog.JogForward +Jog.Busy", JOGS, "-Jog.JogForward ask:stop", "x300"),
        ("ms:50", "+Jog.JogForward +Jog.Busy", JOGS, "-Jog.JogForward", "x300"),
    ),
    Case(
        a_jog_turns_at_standstill,
        31,
        ("", "+Jog.JogForward +Jog.Busy", JOGS, "n0 v0", "+Jog.JogBackward accepted:jog_backward:2"),
        ("", "+Jog.JogForward +Jog.Busy", JOGS, "", "+Jog.JogBackward accepted:jog_backward:2"),
    ),
    Case(
        a_jog_stops_itself,
        30,
        ("", "+Jog.JogForward +Jog.Busy", JOGS, *("ask:stop",) * 3, "-Jog.Busy +Jog.Error Jog.ErrorID=2", ""),
        ("", "+Jog.JogForward +Jog.Busy", JOGS, "ask:stop", "-Jog.Busy +Jog.Error Jog.ErrorID=2", ""),
    ),
    Case(
        a_jog_stops_itself,
        30,
        ("", "+Jog.JogForward +Jog.Busy", JOGS, "accepted:absolute:2", "-Jog.Busy +Jog.CommandAborted", ""),
        ("", "+Jog.JogForward +Jog.Busy", JOGS, EDGE, "-Jog.Busy +Jog.CommandAborted", ""),
    ),
    Case(
        both_directions_are_none,
        31,
        ("ms:50", "+Jog.JogForward +Jog.Busy", JOGS, "+Jog.JogBackward", "n0 v0 x300"),
        ("ms:50", "+Jog.JogForward +Jog.Busy", JOGS, "+Jog.JogBackward", "x300"),
    ),
    Case(
        power_comes_at_the_first_try,
        35,
        ("ms:50 off", "+Power.Execute +Power.Busy", "-Power.Busy +Power.Done x300"),
        ("ms:50 off", "+Power.Execute +Power.Busy", "-Power.Busy +Power.Error Power.ErrorID=9 x300"),
    ),
    Case(
        who_follows_falls_to_neutral,
        36,
        ("", "+Speed.Execute +Speed.Busy ask:speed_5", "lost", "ask:speed_0"),
        ("", "+Speed.Execute +Speed.Busy ask:speed_5", "lost", "ask:speed_5"),
    ),
    Case(
        who_follows_falls_to_neutral,
        36,
        ("", "+Speed.Execute +Speed.Busy ask:speed_5", "-Speed.Execute ask:speed_0"),
        ("", "+Speed.Execute +Speed.Busy ask:speed_5", "-Speed.Execute ask:speed_5"),
    ),
)


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case.monitor.__name__} {case.rule}")
def test_a_monitor_finds_what_breaks_its_rule_and_nothing_else(case: Case) -> None:
    findings: list[Violation] = list(case.monitor(record_of(KINDS, case.breaks)))  # type: ignore[call-overload]
    assert case.rule in [item.rule for item in findings]
    assert [str(item) for item in case.monitor(record_of(KINDS, case.keeps))] == []  # type: ignore[attr-defined]


def test_each_monitor_has_a_case() -> None:
    assert {monitor.__name__ for monitor in MONITORS} == {case.monitor.__name__ for case in CASES}
