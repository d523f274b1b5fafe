"""Monitors of edges and outputs, rules 1 to 14 and 40: what a block shows, whatever the device does."""

from __future__ import annotations

from collections.abc import Iterator

from device_models.history import ENDS, JOGS, LOCKS, MOTIONS, Calls, History, Violation, starts
from device_models.motion_rules import _is_replaced

REFUSED = 1
"""The ErrorID of a value that is refused."""
SPEED_STEP = 20.0
"""Counts in a second between two numbers of the coarsest speed, which is 1000 counts in a minute [hiwin 6.6.1]."""


def nothing_in_the_first_scan(history: History) -> Iterator[Violation]:
    """Rule 1: an input that is TRUE in the first scan starts nothing, until it was FALSE."""
    for calls in _edged(history):
        waiting = False
        for index, scan in enumerate(calls.scans):
            waiting = calls.execute[index] if calls.fresh[index] else waiting and calls.execute[index]
            if waiting and (calls.busy[index] or calls.ends[index]):
                yield Violation(1, scan, calls.name, "it works although its input was TRUE in the first scan")
                waiting = False


def an_edge_is_answered_at_once(history: History) -> Iterator[Violation]:
    """Rule 2: in the scan of an edge either Busy or Error is TRUE, and no ending output of before."""
    for calls in _edged(history):
        for index, scan in _edges(calls):
            if calls.abort[index] or (index and calls.busy[index - 1]) or _both_directions(calls, index):
                continue
            if calls.busy[index] == ("Error" in calls.ends[index]) or calls.ends[index] not in ("", "Error"):
                ending = calls.ends[index] or "no end"
                text = f"in the scan of an edge Busy is {calls.busy[index]}, and it shows {ending}"
                yield Violation(2, scan, calls.name, text)


def outputs_exclude_each_other(history: History) -> Iterator[Violation]:
    """Rule 3: of Busy, Done, Error and CommandAborted one at most is TRUE, and Active with Busy; a stop may be both."""
    for calls in history.blocks.values():
        for index, scan in enumerate(calls.scans):
            number = calls.busy[index] + (sum([end in calls.ends[index] for end in ENDS]) if calls.ends[index] else 0)
            if number > 1 and not (calls.kind in LOCKS and number == 2 and calls.ends[index] == "Done"):
                busy = "Busy and " if calls.busy[index] else ""
                yield Violation(3, scan, calls.name, f"{busy}{calls.ends[index]} are TRUE together")
            elif calls.active[index] and not calls.busy[index]:
                yield Violation(3, scan, calls.name, "Active is TRUE without Busy")


def an_error_has_a_number(history: History) -> Iterator[Violation]:
    """Rule 4: ErrorID is not 0 exactly where Error is TRUE."""
    for calls in history.blocks.values():
        for index, scan in enumerate(calls.scans):
            if ("Error" in calls.ends[index]) != (calls.error[index] != 0):
                text = f"Error is {'Error' in calls.ends[index]} and ErrorID {calls.error[index]}"
                yield Violation(4, scan, calls.name, text)


def a_falling_edge_ends_nothing(history: History) -> Iterator[Violation]:
    """Rule 5: where Execute falls while it is Busy, it stays Busy until it has ended."""
    for calls in _edged(history):
        if calls.kind in (*JOGS, "velocity"):
            continue
        for index, scan in enumerate(calls.scans):
            released = calls.kind in LOCKS and "Done" in calls.ends[index - 1]
            if calls.falls_busy(index) and not calls.ends[index] and not released:
                yield Violation(5, scan, calls.name, "Busy falls and nothing says how it has ended")


def an_end_is_seen_once(history: History) -> Iterator[Violation]:
    """Rules 6 and 7: an end is seen in one call where Execute is FALSE, and until it falls where it is TRUE."""
    for calls in _edged(history):
        for index in range(len(calls.scans) - 1):
            ending, following = calls.ends[index], index + 1
            if not ending or calls.edges[following] or calls.fresh[following]:
                continue
            scan, remains = calls.scans[following], calls.ends[following]
            if not calls.execute[index] and remains == ending:
                yield Violation(6, scan, calls.name, f"{ending} stays although Execute is FALSE")
            elif calls.execute[index] and not calls.execute[following] and remains == ending:
                yield Violation(7, scan, calls.name, f"{ending} stays in the scan in which Execute falls")
            elif calls.execute[index] and calls.execute[following] and remains != ending:
                # A stop is not done any more where a motion of before begins late.
                if calls.kind in LOCKS and ending == "Done" and calls.busy[following] and not remains:
                    continue
                yield Violation(7, scan, calls.name, f"{ending} vanishes while Execute is TRUE")


def an_end_has_a_beginning(history: History) -> Iterator[Violation]:
    """Rule 8: an end rises only in a scan before which the block was Busy, or in that of an edge."""
    for calls in _edged(history):
        for index, scan in enumerate(calls.scans):
            new = [end for end in ENDS if calls.rises(index, end)] if calls.ends[index] else []
            before = index > 0 and not calls.fresh[index] and calls.busy[index - 1]
            if new and not before and not calls.edges[index]:
                yield Violation(8, scan, calls.name, f"{new[0]} rises although it was not Busy")


def values_count_at_the_edge(history: History) -> Iterator[Violation]:
    """Rules 9 and 10: what the device is asked for, and how fast, is what the inputs were at the last edge.

    A jog that turns begins with what its inputs are where it stands.
    """
    for calls in history.of_kind("absolute", "relative", "point", *JOGS):
        for scan, event in history.accepted(calls, 0, len(history.scans)):
            index = calls.edge_before(scan)
            if index < 0:
                continue
            rule = 10 if index > 0 and calls.busy[index - 1] else 9
            index = _edge_of(history, calls, index, scan)
            wanted = history.value_of(calls.name, history.scans[calls.scans[index]].inputs)
            if wanted is not None and abs(wanted - event.value) > 0.5:
                text = f"{event.value:g} is asked for, and the inputs were {wanted:g} at the edge"
                yield Violation(rule, scan, calls.name, text)
            last = calls.index_at(scan) if calls.kind in JOGS else index
            inputs = (history.scans[calls.scans[place]].inputs for place in range(index, last + 1))
            speeds = [history.speed_of(calls.name, item) for item in inputs]
            is_right = any(speed is None or abs(speed - event.speed) <= SPEED_STEP for speed in speeds)
            if event.kind == "accepted" and not is_right:
                text = f"the speed {event.speed:g} is asked for, and the inputs were {speeds[0]:g} at the edge"
                yield Violation(rule, scan, calls.name, text)


def _edge_of(history: History, calls: Calls, index: int, scan: int) -> int:
    """The call with the edge that a command accepted in a scan is for; `index` is that of the last edge.

    What goes out over a line in the scan of an edge is what a block that was Busy has asked for before, and not sent.
    """
    if calls.scans[index] != scan or not index or not calls.busy[index - 1] or history.scans[scan].word is not None:
        return index
    earlier = calls.edge_before(calls.scans[index - 1])
    sent = earlier < 0 or history.accepted(calls, calls.scans[earlier], scan - 1)
    return index if sent else earlier


def done_is_for_the_last_edge(history: History) -> Iterator[Violation]:
    """Rules 10 and 11: after an edge, Done is for a command that was sent since; an edge is not swallowed."""
    for calls in history.of_kind("absolute", "relative", "point", "home"):
        for index, scan in _edges(calls):
            if not index or not calls.busy[index - 1]:
                continue
            rule = 10 if calls.busy[index] else 11
            if "CommandAborted" in calls.ends[index] and not calls.abort[index] and not _is_locked(history, scan):
                yield Violation(11, scan, calls.name, "an edge in the scan of CommandAborted is swallowed")
            for following in range(index, calls.edge_after(index)):
                if "Done" not in calls.ends[following]:
                    continue
                accepted = history.accepted(calls, scan, calls.scans[following])
                if not any(_edge_of(history, calls, index, when) == index for when, _ in accepted):
                    text = f"Done since scan {calls.scans[following]} is for what was asked before the edge"
                    yield Violation(rule, scan, calls.name, text)
                break


def values_out_of_range_are_refused(history: History) -> Iterator[Violation]:
    """Rule 12: a value out of range is Error 1 in the scan of the edge, and nothing is sent.

    A block that is Busy with its own motion ends that first, and then it is Error 1. So it does where another block
    aborts that motion in the scan of the edge.
    """
    for calls in _edged(history):
        for index, scan in _edges(calls):
            if calls.name not in history.scans[scan].invalid or calls.abort[index]:
                continue
            end = calls.edge_after(index)
            last = calls.scans[end] - 1 if end < len(calls.scans) else len(history.scans) - 1
            if history.accepted(calls, scan, last):
                yield Violation(12, scan, calls.name, "it is sent although a value is out of range")
            ends_first = index > 0 and calls.busy[index - 1] and calls.busy[index]
            place = next((item for item in range(index, end) if calls.ends[item]), None) if ends_first else index
            if place is None:
                if history.after(scan) <= last and history.clear_until[scan] > history.after(scan):
                    yield Violation(12, scan, calls.name, "a value out of range, and it stays Busy")
                continue
            when, begin = calls.scans[place], calls.scans[max(calls.begin_before(scan), 0)]
            another = calls.error[place] != REFUSED and not _is_locked(history, when)
            if "CommandAborted" in calls.ends[place] and ends_first and _is_locked(history, when):
                continue
            was_busy = index > 0 and calls.busy[index - 1]
            if "CommandAborted" in calls.ends[place] and was_busy and _is_replaced(history, calls, begin, when):
                continue
            if calls.ends[place] != "Error" or (another and not (ends_first and _is_hindered(history, begin, when))):
                text = f"a value out of range ends with {calls.ends[place] or 'nothing'} {calls.error[place]}"
                yield Violation(12, when, calls.name, text)


def _is_hindered(history: History, first: int, last: int) -> bool:
    """Whether between two scans something else than a value may be what a block ends with."""
    return history.clear_until[first] <= last or any(entry.state.alarm for entry in history.scans[first : last + 1])


def a_start_has_an_edge(history: History) -> Iterator[Violation]:
    """Rules 13, 26, 33, 38 and 40: each start has an edge of its own since the controller was switched on."""
    for asked in (True, False):
        used: dict[str, int] = {}
        for scan, about in _starts(history, asked):
            owners = [calls for calls in history.of_kind(*MOTIONS) if starts(calls.kind, about)]
            edges = {calls.name: calls.edge_before(scan) for calls in owners}
            for calls in owners:
                # What goes out in the scan of an edge is what a block that was Busy has asked for before.
                earlier = calls.edge_before(scan - 1) if calls.busy_at(scan - 1) else -1
                if earlier > used.get(calls.name, -1):
                    edges[calls.name] = earlier
            fresh = [name for name, index in edges.items() if index >= 0 and used.get(name, -1) < index]
            names = ", ".join(edges) or "none"
            if fresh:
                used[fresh[0]] = edges[fresh[0]]
            elif any(index >= 0 for index in edges.values()):
                yield Violation(38, scan, names, f"a second {about} for one edge")
            else:
                yield Violation(13, scan, names, f"{about} without an edge")


def the_first_telegram_starts_nothing(history: History) -> Iterator[Violation]:
    """Rule 40: after a restart, the bits that switch on, enable and start are 0 in the first telegram."""
    for scan in {0, *history.restarts} if history.scans else ():
        word = history.scans[scan].word
        if word is not None and word & 0x0B49:
            yield Violation(40, scan, "telegram", f"the first control word is {word:04X}H")


def _both_directions(calls: Calls, index: int) -> bool:
    """Whether both directions of a jog are asked for in a call, or were in the one before."""
    return any(len(item) == 2 and all(item) for item in calls.directions[max(index - 1, 0) : index + 1])


def _is_locked(history: History, scan: int) -> bool:
    """Whether a stop is Busy or asked for."""
    return any(
        lock.busy_at(scan) or (lock.index_at(scan) >= 0 and lock.execute[lock.index_at(scan)])
        for lock in history.of_kind(*LOCKS)
    )


def _starts(history: History, asked: bool) -> Iterator[tuple[int, str]]:
    """The starts that are on the wire, or those that the device accepts."""
    if asked:
        yield from ((scan, text[6:]) for scan, text in history.requests if text.startswith("start "))
    else:
        ignored = ("outside", "velocity")
        for scan, event in history.events:
            if event.kind == "accepted" and event.about not in ignored:
                yield scan, event.about


def _edged(history: History) -> list[Calls]:
    """The blocks that work by an edge."""
    return [calls for calls in history.blocks.values() if calls.kind not in ("read", "other")]


def _edges(calls: Calls) -> list[tuple[int, int]]:
    """The calls with an edge, and their scans."""
    return [(index, scan) for index, scan in enumerate(calls.scans) if calls.edges[index]]


OUTPUT_RULES = (
    nothing_in_the_first_scan,
    an_edge_is_answered_at_once,
    outputs_exclude_each_other,
    an_error_has_a_number,
    a_falling_edge_ends_nothing,
    an_end_is_seen_once,
    an_end_has_a_beginning,
    values_count_at_the_edge,
    done_is_for_the_last_edge,
    values_out_of_range_are_refused,
    a_start_has_an_edge,
    the_first_telegram_starts_nothing,
)
