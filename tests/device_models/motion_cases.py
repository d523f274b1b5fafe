"""Records that keep and break the rules of who is responsible."""

from __future__ import annotations

from device_models.monitor_cases import DONE, EDGE, HOME, HOMES, JOG_EDGE, MOVES, MOVING, STANDS, STOP, Case
from device_models.motion_rules import (
    a_valid_position_is_true,
    an_alarm_ends_a_motion,
    nothing_is_done_without_power,
    silence_is_an_error,
    somebody_is_responsible,
    two_edges_start_once,
    who_fails_stops_or_says_so,
    who_is_aborted_has_a_successor,
    who_is_refused_ends_with_an_error,
)

MOTION_CASES = (
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
        who_is_aborted_has_a_successor,
        16,
        ("", HOME, HOMES, f"word:042F {STOP} -Home.Busy +Home.CommandAborted lost", "ask:stop stop:command:1"),
        ("", HOME, HOMES, f"{STOP} -Home.Busy +Home.CommandAborted lost", "word:042F ask:stop stop:command:1"),
    ),
    Case(
        who_is_aborted_has_a_successor,
        16,
        (
            *("", HOME, HOMES, f"word:042F {STOP} -Home.Busy +Home.CommandAborted lost", "lost x9"),
            "-Stop.Busy +Stop.Error Stop.ErrorID=7 lost",
        ),
        (
            *("", HOME, HOMES, f"word:042F {STOP} -Home.Busy +Home.CommandAborted lost", "lost x9"),
            "-Stop.Busy +Stop.Done lost",
        ),
    ),
    Case(
        who_is_aborted_has_a_successor,
        16,
        ("", HOME, HOMES, f"word:042F {STOP} -Home.Busy +Home.CommandAborted lost", "ask:stop stop:command:1"),
        ("", HOME, HOMES, f"word:042F {STOP} -Home.Busy +Home.CommandAborted lost", "word:043F ask:stop"),
    ),
    Case(
        who_is_refused_ends_with_an_error,
        17,
        ("", EDGE, "refused:absolute:0:500", "", "-Move.Busy +Move.Error"),
        ("", EDGE, "refused:absolute:0:500", "", DONE),
    ),
    Case(
        who_is_refused_ends_with_an_error,
        17,
        ("p500", EDGE, "refused:absolute:0:500", "", DONE),
        ("p500 v9", EDGE, "refused:absolute:0:500", "", DONE),
    ),
    Case(
        who_is_refused_ends_with_an_error,
        17,
        ("ms:50", EDGE, "refused:absolute:0:500", "", "-Move.Busy +Move.Error x300"),
        ("ms:50", EDGE, "refused:absolute:0:500", "x300"),
    ),
    Case(
        two_edges_start_once,
        18,
        ("", f"{EDGE} +Other.Execute +Other.Busy", "ask:start_relative", "-Move.Busy +Move.CommandAborted"),
        ("", f"{EDGE} +Other.Execute +Other.Busy", "ask:start_relative", "ask:start_absolute"),
    ),
    Case(
        two_edges_start_once,
        18,
        ("", EDGE, "-Move.Execute", f"{EDGE} +Other.Execute +Other.Busy ask:start_absolute", "ask:start_relative"),
        ("", EDGE, "-Move.Execute", f"{EDGE} +Other.Execute +Other.Busy ask:start_relative", "ask:start_absolute"),
    ),
    Case(
        two_edges_start_once,
        18,
        ("", EDGE, "-Move.Execute", f"{EDGE} +Other.Execute +Other.Busy ask:start_absolute", "ask:start_relative"),
        (
            *("", EDGE, "-Move.Execute ask:start_absolute"),
            *(f"{EDGE} +Other.Execute +Other.Busy ask:start_absolute", "ask:start_relative"),
        ),
    ),
    Case(
        two_edges_start_once,
        18,
        ("", f"{EDGE} +Other.Execute +Other.Busy", "ask:start_relative", "-Move.Busy +Move.CommandAborted"),
        ("", f"{EDGE} +Other.Execute +Other.Busy", "ask:start_relative", DONE),
    ),
    Case(
        two_edges_start_once,
        18,
        ("", f"{EDGE} +Other.Execute +Other.Busy", "ask:start_relative lost", "-Move.Busy +Move.Error Move.ErrorID=2"),
        (
            *("ms:50", f"{EDGE} +Other.Execute +Other.Busy", "ask:start_relative"),
            "-Move.Busy +Move.Error Move.ErrorID=11 x300",
        ),
    ),
    Case(
        two_edges_start_once,
        18,
        (
            *("", f"{HOME} {EDGE}", "-Home.Busy +Home.CommandAborted", "ask:start_absolute", DONE),
            *("+Third.Execute +Third.Busy", "ask:start_absolute"),
        ),
        (
            *("", f"{HOME} {EDGE}", "-Home.Busy +Home.CommandAborted", "ask:start_absolute", DONE),
            *("+Third.Execute +Third.Busy", "ask:start_home"),
        ),
    ),
    Case(
        two_edges_start_once,
        18,
        (
            *("", f"{HOME} {EDGE}", "ask:start_home", "-Move.Busy +Move.CommandAborted"),
            *("+Third.Execute +Third.Busy", "ask:start_absolute"),
        ),
        (
            *("", "+Third.Execute +Third.Busy", f"{HOME} {EDGE}", "ask:start_home", "-Move.Busy +Move.CommandAborted"),
            "ask:start_absolute",
        ),
    ),
    Case(
        two_edges_start_once,
        18,
        ("", f"{JOG_EDGE} +Other.Execute +Other.Busy", "-Jog.JogForward -Jog.Busy +Jog.Done", "ask:start_relative"),
        ("", f"{JOG_EDGE} +Other.Execute +Other.Busy", "", "-Jog.JogForward -Jog.Busy +Jog.Done ask:start_relative"),
    ),
    Case(
        who_fails_stops_or_says_so,
        21,
        ("", EDGE, MOVES, "ask:stop", "-Move.Busy +Move.Error Move.ErrorID=14", "ask:read", "ask:read"),
        ("", EDGE, f"ask:stop {MOVES}", "-Move.Busy +Move.Error Move.ErrorID=14", "ask:read", "ask:read"),
    ),
    Case(
        who_fails_stops_or_says_so,
        21,
        ("", EDGE, MOVES, "-Move.Busy +Move.Error Move.ErrorID=7", "ask:read", "ask:read"),
        ("", EDGE, MOVES, "-Move.Busy +Move.Error Move.ErrorID=9", "ask:read", "ask:read", "ask:stop"),
    ),
    Case(
        who_fails_stops_or_says_so,
        21,
        ("ms:50", EDGE, MOVES, "-Move.Busy +Move.Error Move.ErrorID=6", "ask:off x300"),
        ("ms:50", EDGE, MOVES, "-Move.Busy +Move.Error Move.ErrorID=6", "x300"),
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
        ("", EDGE, "refused:absolute:0:500", "+Other.Execute +Other.Busy", "-Move.Busy +Move.CommandAborted"),
        ("", EDGE, "refused:absolute:0:500", "", "-Move.Busy +Move.CommandAborted"),
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
        ("", EDGE, MOVES, "alarm:3 alarm n0 v0", f"{STOP} -Move.Busy +Move.Error Move.ErrorID=12"),
        ("", EDGE, MOVES, "alarm:3 alarm n0 v0", "-Move.Busy +Move.Error Move.ErrorID=12"),
    ),
    Case(
        an_alarm_ends_a_motion,
        33,
        ("", EDGE, MOVES, "alarm:3 alarm n0 v0", f"{STOP} -Move.Busy +Move.CommandAborted"),
        ("", f"{STOP} -Stop.Execute", EDGE, MOVES, "alarm:3 alarm n0 v0", "-Move.Busy +Move.CommandAborted"),
    ),
    Case(
        an_alarm_ends_a_motion,
        33,
        ("ms:50", EDGE, MOVES, "alarm:3 alarm n0 v0", "-Move.Busy +Move.Error Move.ErrorID=8 x400"),
        ("ms:50", EDGE, MOVES, "alarm:3 alarm n0 v0 x200", "-Move.Busy +Move.Error Move.ErrorID=8 x400"),
    ),
    Case(
        a_valid_position_is_true,
        39,
        ("p500", "+Read.Enable +Read.Valid Read.PositionRaw=500", "-Read.Valid +Read.Error Read.ErrorID=2"),
        ("p500", "+Read.Enable +Read.Valid Read.PositionRaw=500", "+Read.Error Read.ErrorID=2"),
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
        ("p500", "+Read.Enable +Read.Valid Read.PositionRaw=500"),
        ("p500", "+Read.Enable +Read.Valid Read.PositionRaw=1426063360"),
    ),
    Case(
        a_valid_position_is_true,
        39,
        ("p500", "+Read.Enable +Read.Valid Read.PositionRaw=500", "-Read.Enable -Read.Valid"),
        ("p500", "+Read.Enable +Read.Valid Read.PositionRaw=500", "-Read.Enable"),
    ),
    Case(
        a_valid_position_is_true,
        39,
        ("ms:50 p500", "+Read.Enable +Read.Valid Read.PositionRaw=500", "p900 x100", "Read.PositionRaw=900 x300"),
        ("ms:50 p500", "+Read.Enable +Read.Valid Read.PositionRaw=500", "p900 x300"),
    ),
)
