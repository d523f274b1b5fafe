"""Records that keep and break the rules of Done, and of what comes back by itself."""

from __future__ import annotations

from device_models.done_rules import (
    a_reading_recovers,
    done_is_at_the_target,
    home_is_done_by_this_run,
    what_waits_for_the_device_ends,
)
from device_models.monitor_cases import DONE, EDGE, HOME, HOMED, MOVES, POINT, STANDS, STOP, Case

POINT_REACHED = "accepted:point:1 reached:point:1 n0 p0"

DONE_CASES = (
    Case(
        home_is_done_by_this_run,
        34,
        ("", "+Home.Execute +Home.Busy", "accepted:home:1 n1", "reached:home:1 n0", "-Home.Busy +Home.Done"),
        ("", "+Home.Execute +Home.Busy", "accepted:home:1 n1", "interrupted:home:1 n0", "-Home.Busy +Home.Done"),
    ),
    Case(
        home_is_done_by_this_run,
        34,
        ("", HOME, "accepted:home:1 n1", "stop:outside interrupted:home:1 n0", "-Home.Busy +Home.Done"),
        ("", HOME, "accepted:home:1 n1 lost-home", "stop:outside interrupted:home:1 n0", "home -Home.Busy +Home.Done"),
    ),
    Case(
        home_is_done_by_this_run,
        34,
        ("", HOME, "accepted:home:1 n1", "stop:outside interrupted:home:1 n0", "-Home.Busy +Home.Done"),
        ("", HOME, "accepted:home:1 n1", "stop:command interrupted:home:1 n0", "-Home.Busy +Home.Done"),
    ),
    Case(
        home_is_done_by_this_run,
        34,
        ("", HOME, "accepted:home:1 n1", "restart -Home.Execute -Home.Busy", HOME, HOMED, "-Home.Busy +Home.Done"),
        ("", HOME, "accepted:home:1 n1", "-Home.Execute -Home.Busy", HOME, HOMED, "-Home.Busy +Home.Done"),
    ),
    Case(
        home_is_done_by_this_run,
        34,
        ("", HOME, "accepted:home:1 n1", "restart -Home.Execute -Home.Busy", HOME, HOMED, "-Home.Busy +Home.Done"),
        ("", HOME, "accepted:home:1 n1", f"restart -Home.Execute -Home.Busy {HOMED}", HOME, "-Home.Busy +Home.Done"),
    ),
    Case(
        done_is_at_the_target,
        37,
        ("", POINT, "accepted:point:1 n1", "stop:outside interrupted:point:1 n0", "-Point.Busy +Point.Done"),
        ("", POINT, "accepted:point:1 n1", "stop:outside:1:1 interrupted:point:1 n0", "-Point.Busy +Point.Done"),
    ),
    Case(
        done_is_at_the_target,
        37,
        ("", POINT, "accepted:point:1 n1", "stop:outside interrupted:point:1 n0", "-Point.Busy +Point.Done"),
        ("", POINT, "accepted:point:1 n1", "stop:command interrupted:point:1 n0", "-Point.Busy +Point.Done"),
    ),
    Case(
        done_is_at_the_target,
        37,
        (
            *("", POINT, "accepted:point:1 n1", "stop:outside:1:1 interrupted:point:1 n0 good x3"),
            *("stop-ended:outside", "-Point.Busy +Point.Done"),
        ),
        (
            *("", POINT, "accepted:point:1 n1", "stop:outside:1:1 interrupted:point:1 n0 good x4"),
            *("stop-ended:outside", "-Point.Busy +Point.Done"),
        ),
    ),
    Case(
        done_is_at_the_target,
        37,
        ("", POINT, "accepted:point:1 n1", "stop:outside interrupted:point:1 n0", "-Point.Busy +Point.Done"),
        ("", EDGE, "accepted:absolute:1:500 n1", "stop:outside interrupted:absolute:1 n0", DONE),
    ),
    Case(
        done_is_at_the_target,
        37,
        ("", EDGE, MOVES, STANDS, f"{DONE} alarm"),
        ("", EDGE, MOVES, f"{STANDS} alarm", DONE),
    ),
    Case(
        done_is_at_the_target,
        37,
        ("", EDGE, MOVES, STANDS, "p900", "", "", DONE),
        ("", EDGE, MOVES, STANDS, "p900 x9", DONE),
    ),
    Case(
        done_is_at_the_target,
        37,
        ("", EDGE, MOVES, "reached:absolute:1:500 n0 v0 p505", DONE),
        ("", EDGE, MOVES, "reached:absolute:1:500 n0 v0 p520", DONE),
    ),
    Case(
        done_is_at_the_target,
        37,
        ("p500", EDGE, "accepted:absolute:1:500 w1", DONE),
        ("p500", EDGE, "accepted:absolute:1:500 w1 v50", DONE),
    ),
    Case(
        what_waits_for_the_device_ends,
        40,
        ("ms:50 off", "+Power.Execute +Power.Busy", "lost", "", "-Power.Busy +Power.Done x300"),
        ("ms:50 off", "+Power.Execute +Power.Busy", "lost", "x300"),
    ),
    Case(
        what_waits_for_the_device_ends,
        40,
        ("ms:50 off", "+Power.Execute +Power.Busy", "-Power.Busy +Power.Error Power.ErrorID=8 x300"),
        ("ms:50 off", "+Power.Execute +Power.Busy x300"),
    ),
    Case(
        what_waits_for_the_device_ends,
        40,
        ("ms:50 off", "+Power.Execute +Power.Busy", "+Off.Execute +Off.Busy x400"),
        ("ms:50 off", "+Power.Execute +Power.Busy", "+Off.Execute +Off.Done x400"),
    ),
    Case(
        what_waits_for_the_device_ends,
        40,
        (
            "ms:50 off",
            "+Power.Execute +Power.Busy",
            "power-cycle",
            "x1000",
            "-Power.Busy +Power.Error Power.ErrorID=9 x900",
        ),
        ("ms:50 off", "+Power.Execute +Power.Busy", "power-cycle", "x2000"),
    ),
    Case(
        what_waits_for_the_device_ends,
        40,
        ("ms:50 alarm alarm:3", "+Reset.Execute +Reset.Busy x400"),
        ("ms:50 alarm alarm:3", "cause-gone:alarm", "+Reset.Execute +Reset.Busy x400"),
    ),
    Case(
        what_waits_for_the_device_ends,
        40,
        (
            "ms:50 off",
            "+Power.Execute +Power.Busy",
            "+Stop.Execute +Stop.Busy",
            "-Stop.Busy +Stop.Done",
            "lost",
            "x400",
        ),
        ("ms:50 off", "+Stop.Execute +Stop.Busy", "-Stop.Busy", "+Power.Execute +Power.Busy", "lost", "x400"),
    ),
    Case(
        a_reading_recovers,
        40,
        ("ms:50", "lost", "+Read.Enable +Read.Error x50", "-Read.Enable -Read.Error x300"),
        ("ms:50", "lost", "+Read.Enable +Read.Error x350"),
    ),
    Case(
        a_reading_recovers,
        40,
        ("ms:50", "+Read.Enable +Read.Valid", "-Read.Valid +Read.Error lost", "x150", "-Read.Error +Read.Valid x300"),
        ("ms:50", "+Read.Enable +Read.Valid", "-Read.Valid +Read.Error lost", "x300"),
    ),
    Case(
        a_reading_recovers,
        40,
        ("ms:50", "+Read.Enable +Read.Error", f"{STOP}", "-Stop.Busy +Stop.Done x200", "-Read.Error +Read.Valid x300"),
        ("ms:50", f"{STOP}", "-Stop.Busy +Stop.Done", "+Read.Enable +Read.Error x201", "-Read.Error +Read.Valid x300"),
    ),
    Case(done_is_at_the_target, 37, ("", EDGE, MOVES, STANDS, DONE), ("", EDGE, MOVES, DONE)),
    Case(done_is_at_the_target, 37, ("", EDGE, MOVES, STANDS, DONE), ("", EDGE, DONE)),
    Case(
        done_is_at_the_target,
        37,
        ("", POINT, POINT_REACHED, "accepted:outside:2 n2", "n0 p900", "x9", "-Point.Busy +Point.Done"),
        ("", POINT, POINT_REACHED, "p900", "x9", "-Point.Busy +Point.Done"),
    ),
    Case(
        home_is_done_by_this_run,
        34,
        ("n1", HOME, "accepted:home:2 n1 w2", "reached:home:1 n0 w2", "-Home.Busy +Home.Done"),
        ("n1", HOME, "reached:home:1 n0", "accepted:home:2 w2", "-Home.Busy +Home.Done"),
    ),
    Case(
        done_is_at_the_target,
        37,
        ("", EDGE, MOVES, "stop:outside interrupted:absolute:1 n0 v0 p492", "", DONE),
        ("", EDGE, MOVES, "stop:outside interrupted:absolute:1 n0 v0 p480", "", DONE),
    ),
    Case(
        done_is_at_the_target,
        37,
        ("p500", EDGE, "refused:absolute:0:500", "", DONE),
        ("p400", EDGE, "refused:absolute:0:500", "", DONE),
    ),
    Case(
        done_is_at_the_target,
        37,
        ("p500", EDGE, "ask:start_absolute accepted:absolute:1:500 w1", DONE),
        ("p400", EDGE, "ask:start_absolute accepted:absolute:1:500 w1", DONE),
    ),
)
