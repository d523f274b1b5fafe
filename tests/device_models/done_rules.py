"""Monitors of Done, and of what comes back by itself: rules 34, 37 and 40."""

from __future__ import annotations

from collections.abc import Iterator

from device_models.axis import Event
from device_models.history import LOCKS, MOVES, POWER, STOPS, Calls, History, Violation
from device_models.motion_rules import _is_clear, _last_before_edge

WINDOW = 10.5
"""How far from its target an axis is at its target, in counts: the windows of the rigs, and a rounding."""
LIMIT = 65000
"""Milliseconds until a task is given up at the latest: 60 s, and an exchange."""
LOOKS = 4
"""Calls and exchanges between what a device shows and what a block says of it."""


def home_is_done_by_this_run(history: History) -> Iterator[Violation]:
    """Rule 34: Home is done where its own run has set the home."""
    yield from _done_is_reached(history, ("home",), 34)


def done_is_at_the_target(history: History) -> Iterator[Violation]:
    """Rule 37: a move is done where the device has accepted it, and has reached the target, or stood there before."""
    yield from _done_is_reached(history, MOVES, 37)


def what_waits_for_the_device_ends(history: History) -> Iterator[Violation]:
    """Rule 40: where all is well again, what switches the servo or resets an alarm ends, unless another undoes it.

    What a device has forgotten, as it was switched off and on, is not sent again (rule 38): the time limit ends it. So
    it does with a reset that comes before what has caused the alarm is gone.
    """
    for calls in history.of_kind(*POWER, "reset"):
        for index, scan in enumerate(calls.scans):
            before = calls.scans[max(index - 1, 0)]
            returns = history.clear_until[before] == before
            if not (calls.edges[index] or returns) or not calls.busy[index] or not _is_clear(history, scan):
                continue
            edge = calls.scans[max(calls.edge_before(scan), 0)]
            forgotten = any("power cycle" in entry.disturbed for entry in history.scans[edge : scan + 1])
            caused = calls.kind == "reset" and _has_cause(history, edge)
            end = history.after(scan, -(-LIMIT // history.patience) if forgotten or caused else 1)
            if end >= history.clear_until[scan]:
                continue
            others = [other for other in history.of_kind(*POWER, "reset", *LOCKS) if other is not calls]
            hindered = any(other.busy_at(when) for other in others for when in range(edge, end + 1))
            if end <= _last_before_edge(history, calls, index) and not hindered and _stays(calls, index, end):
                yield Violation(40, end, calls.name, "nothing is disturbed, and it stays Busy")


def a_reading_recovers(history: History) -> Iterator[Violation]:
    """Rule 40: a block that reads is Valid again where all is well. Each stop goes before it, and takes its time."""
    for calls in history.of_kind("read"):
        judged = -1
        for index, scan in enumerate(calls.scans):
            if scan <= judged or not calls.execute[index] or not _is_clear(history, scan):
                continue
            judged = history.after(scan, 1 + _stops_between(history, scan, history.after(scan)))
            places = range(index, calls.index_at(judged) + 1)
            enabled = all(calls.execute[place] for place in places) and len(places) == judged - scan + 1
            if enabled and not any(
                history.scans[calls.scans[place]].outputs.get((calls.name, "Valid")) for place in places
            ):
                yield Violation(40, judged, calls.name, "nothing is disturbed, and it is not Valid again")


def _stops_between(history: History, first: int, last: int) -> int:
    """The number of edges of stops in some scans, both included."""
    edges = [
        scan for calls in history.of_kind(*STOPS) for scan, edge in zip(calls.scans, calls.edges, strict=True) if edge
    ]
    return sum(first <= scan <= last for scan in edges)


def _has_cause(history: History, scan: int) -> bool:
    """Whether what has caused an alarm is there in a scan."""
    causes = [event.kind for when, event in history.events if when <= scan and event.kind in ("alarm", "cause gone")]
    return bool(causes) and causes[-1] == "alarm"


def _stays(calls: Calls, index: int, last: int) -> bool:
    """Whether a block is called in each scan up to the last one, and Busy in all of them."""
    places = range(index, calls.index_at(last) + 1)
    return len(places) == last - calls.scans[index] + 1 and all(calls.busy[place] for place in places)


def _done_is_reached(history: History, kinds: tuple[str, ...], rule: int) -> Iterator[Violation]:
    for calls in history.of_kind(*kinds):
        for index, scan in enumerate(calls.scans):
            if not calls.rises(index, "Done"):
                continue
            edge = calls.edge_before(scan)
            begun = history.accepted(calls, calls.scans[edge], scan) if edge >= 0 else []
            if not begun and edge >= 0 and calls.kind == "home":
                begun = _homing_before_restart(history, calls.scans[edge], scan)
            if not begun:
                yield Violation(rule, scan, calls.name, "Done, and the device has accepted no command for it")
                continue
            accepted, command = begun[-1]
            reached = _place_reached(history, command, accepted, scan)
            state = history.scans[scan].state
            if reached is None:
                if not _is_hidden(history, command, accepted, scan) and not _is_near(history, command, accepted, scan):
                    text = f"Done at {state.position:g}, and {command.value:g} is not reached"
                    yield Violation(rule, scan, calls.name, text)
            elif _is_moved_unseen(history, command, accepted, scan):
                continue
            elif not _was_there(history, _looks_from(history, calls, index, accepted), scan, reached):
                text = f"Done at {state.position:g}, and the last looks do not show that it stands at {reached:g}"
                yield Violation(rule, scan, calls.name, text)


def _homing_before_restart(history: History, edge: int, last: int) -> list[tuple[int, Event]]:
    """The homing that a device has accepted before its controller was switched on, and ends after an edge.

    A device that is homing takes no second start, and shows the block the home that is set after its edge.
    """
    restarted = max((scan for scan in history.restarts if scan <= edge), default=-1)
    ended = {
        event.number
        for scan, event in history.events
        if edge < scan <= last and event.about == "home" and event.kind == "reached"
    }
    return [
        (edge, event)
        for scan, event in history.events
        if scan < restarted and event.kind == "accepted" and event.number in ended
    ]


def _place_reached(history: History, command: Event, accepted: int, last: int) -> float | None:
    """Where a command has led the axis by a scan; None where it has not come there.

    An absolute move to where it stands already, or near, moves nothing. A homing that was going on sets the home, too.
    """
    for scan, event in history.events:
        is_homing = command.about == event.about == "home" and scan > accepted
        if scan <= last and event.kind == "reached" and (event.number == command.number or is_homing):
            return command.value if command.about == "absolute" else history.scans[scan].state.position
    state = history.scans[last].state
    near = command.about == "absolute" and abs(state.position - command.value) <= 0.5
    return command.value if near and not state.number else None


def _is_near(history: History, command: Event, accepted: int, last: int) -> bool:
    """Whether something outside has stopped a move so near its target that the window of the block holds it."""
    origin = history.scans[max(accepted - 1, 0)].state.position if command.about == "relative" else 0.0
    state = history.scans[last].state
    is_move = command.about in ("absolute", "relative") and not state.velocity
    return is_move and abs(state.position - origin - command.value) <= WINDOW


def _is_hidden(history: History, command: Event, accepted: int, last: int) -> bool:
    """Whether something outside has stopped a motion, and nothing that the device shows tells that from its end.

    The target of a point is not in the registers; a homing may leave the home of before set all the while.
    """
    homed = all(entry.state.homed for entry in history.scans[accepted : last + 1])
    return (command.about == "point" or (command.about == "home" and homed)) and any(
        event.kind == "stop" and event.about == "outside" and not (event.value and _is_seen(history, when, last))
        for when, event in history.events
        if accepted <= when <= last
    )


def _is_moved_unseen(history: History, command: Event, accepted: int, last: int) -> bool:
    """Whether something outside has moved an axis since its point, whose target is not in the registers."""
    return command.about == "point" and any(
        event.kind == "accepted" and event.about == "outside" and accepted < scan <= last
        for scan, event in history.events
    )


def _is_seen(history: History, first: int, last: int) -> bool:
    """Whether a stop that is shown from a scan on is shown for so long that each block has looked meanwhile."""
    ended = next((when for when, event in history.events if first <= when <= last and event.kind == "stop ended"), last)
    fates = [fate for entry in history.scans[first:ended] for fate in entry.fates]
    return ended == last or fates.count("good") >= LOOKS


def _was_there(history: History, first: int, last: int, place: float) -> bool:
    """Whether the axis stood at a place, without an alarm, in one of some scans, the last one not included."""
    return any(
        not seen.alarm and not seen.velocity and abs(seen.position - place) <= WINDOW
        for seen in (entry.state for entry in history.scans[first:last])
    )


def _looks_from(history: History, calls: Calls, index: int, accepted: int) -> int:
    """The first scan that what a block shows in a call may be from: some calls and exchanges before, if accepted."""
    scan = calls.scans[index]
    first = calls.scans[max(index - LOOKS, 0)]
    exchanges = [when for when in range(scan) if history.scans[when].fates and history.scans[when].word is None]
    return max(accepted, min(first, *exchanges[-LOOKS:], scan))


DONE_RULES = (
    home_is_done_by_this_run,
    done_is_at_the_target,
    what_waits_for_the_device_ends,
    a_reading_recovers,
)
