"""Monitors of who is responsible, and of what blocks show: rules 15 to 21, 32, 33, 38 and 39."""

from __future__ import annotations

from collections.abc import Iterator

from device_models.axis import Event
from device_models.history import JOGS, MOTIONS, MOVES, SLOW, STOPPING, STOPS, Calls, History, Violation, starts

ALARM = 8
LOCKED = 12
LOST = ("lost request", "lost answer", "late")
LOST_ANSWER = "lost answer"
START_BITS = 0x0B40
TASK_BITS = 0x0030
"""Bits of STW1 that start a motion, and those that let a task go on."""


def somebody_is_responsible(history: History) -> Iterator[Violation]:
    """Rule 15: while the axis moves by a command a block is Busy with it, or an Error says that it may be moving."""
    responsible = history.of_kind(*MOTIONS, *STOPS, "power_off")
    judged: set[int] = set()
    for scan, entry in enumerate(history.scans):
        number = entry.state.number
        if not number or number in judged or not entry.state.velocity:
            continue
        if any(calls.busy_at(scan) for calls in responsible):
            continue
        judged.add(number)
        begin = next((when for when, event in history.events if event.number == number), 0)
        if any(begin < item <= scan for item in history.restarts):
            continue
        if not _disclaimed(history, number, begin, scan):
            yield Violation(15, scan, "axis", f"it moves by command {number}, and no block is responsible")


def who_is_aborted_has_a_successor(history: History) -> Iterator[Violation]:
    """Rules 16, 19 and 20: CommandAborted while its motion goes on needs a command of another that was accepted."""
    for calls, index, scan, number in _ends_in_motion(history, "CommandAborted"):
        if calls.abort[index] or not history.scans[scan].state.velocity:
            continue
        if _has_successor(history, number, scan) or _is_being_stopped(history, number, scan):
            continue
        others = [other for other in history.of_kind(*MOTIONS, *STOPS, "power_off") if other is not calls]
        begun = any(other.edge_before(scan) >= 0 and other.busy_at(scan) for other in others)
        text = "before the device has accepted another command" if begun else "although nobody else has the axis"
        yield Violation(16 if begun else 20, scan, calls.name, f"CommandAborted {text}, and its motion goes on")


def _has_successor(history: History, number: int, scan: int) -> bool:
    """Whether the device has accepted a later command, or a stop, since a motion was accepted."""
    accepted = next(when for when, event in history.events if event.number == number)
    return any(
        (event.kind == "accepted" and event.number > number) or (event.kind == "stop" and event.about != "outside")
        for when, event in history.events
        if accepted <= when <= scan
    )


def _is_stopped(history: History, first: int, last: int) -> bool:
    """Whether a stop has an edge in one of some scans, both included. It has the axis, whatever the device shows."""
    edges = [(calls, calls.edge_before(last)) for calls in history.of_kind(*STOPS)]
    return any(edge >= 0 and calls.scans[edge] >= first for calls, edge in edges)


def _is_being_stopped(history: History, number: int, first: int) -> bool:
    """Whether each telegram from a scan on asks to stop until the device gets one, and a stop answers for it so long.

    Nothing in a telegram shows that a stop is accepted: it has the axis from its edge on, heard or not.
    """
    stops = history.of_kind(*STOPS)
    for scan in range(first, len(history.scans)):
        entry = history.scans[scan]
        stopped = any(event.kind == "stop" and event.about != "outside" for event in entry.events)
        if stopped or not history.is_on(number, scan) or (scan > first and "restart" in entry.disturbed):
            return True
        if entry.word is None or not _asks_to_stop(entry.word) or LOST_ANSWER not in entry.fates:
            return False
        if not any(calls.busy_at(scan) for calls in stops):
            return any(scan in calls.scans and calls.error[calls.index_at(scan)] in history.may_move for calls in stops)
    return True


def _asks_to_stop(word: int) -> bool:
    """Whether a control word lets nothing move."""
    return not word & START_BITS and (word & TASK_BITS != TASK_BITS or word & 0x0F != 0x0F)


def who_is_refused_ends_with_an_error(history: History) -> Iterator[Violation]:
    """Rule 17: a block whose command the device refuses ends with Error, never with Done, nor as if it was followed."""
    for scan, event, owner in history.owners:
        calls = history.blocks[owner]
        if event.kind == "refused" and calls.busy_at(scan) and not history.is_refused_in_place(scan, event):
            ending = _end_after(calls, scan)
            if ending is None:
                if _is_clear(history, scan):
                    yield Violation(17, scan, calls.name, "the device refuses, and it stays Busy")
            elif ending[1] == "Done" and calls.kind not in JOGS and not history.accepted(calls, scan + 1, ending[0]):
                yield Violation(17, ending[0], calls.name, f"Done of a command that was refused in scan {scan}")
            elif ending[1] == "CommandAborted" and not _is_replaced(history, calls, scan, ending[0]):
                text = f"CommandAborted of a command that was refused in scan {scan}"
                yield Violation(17, ending[0], calls.name, text)


def _is_replaced(history: History, calls: Calls, first: int, last: int) -> bool:
    """Whether between two scans another motion was asked for, or the device has got a stop."""
    others = [other for other in history.of_kind(*MOTIONS, *STOPS) if other is not calls]
    asked = any(text in STOPPING for text in history.asked_between(first, last))
    return asked or any(other.edge_before(last) > other.index_at(first - 1) for other in others)


def two_edges_start_once(history: History) -> Iterator[Violation]:
    """Rule 18: of two edges in one scan one starts at most, and who does not start is aborted by the other."""
    together: dict[int, list[tuple[Calls, int]]] = {}
    for calls in history.of_kind(*MOTIONS):
        for index, scan in enumerate(calls.scans):
            if calls.edges[index] and calls.busy[index]:
                together.setdefault(scan, []).append((calls, index))
    for scan, edges in together.items():
        if len(edges) < 2:
            continue
        names = ", ".join(calls.name for calls, _ in edges)
        last = min(_last_before_edge(history, calls, index) for calls, index in edges)
        end = history.after(scan)
        if _is_clear(history, scan) and end <= last and sum(calls.busy_at(end) for calls, _ in edges) > 1:
            yield Violation(18, end, names, "both stay Busy")
        started = [
            text
            for when, text in history.requests
            if scan <= when <= last
            and text.startswith("start ")
            and any(starts(calls.kind, text[6:]) for calls, _ in edges)
            and not (when == scan and _was_asked_before(history, edges, text))
            and not _is_of_a_third(history, edges, scan, when, text)
        ]
        if len(started) > 1:
            yield Violation(18, scan, names, f"{len(started)} starts for two edges")
        elif started:
            yield from _losers(history, [calls for calls, _ in edges if not starts(calls.kind, started[0][6:])], scan)


def _was_asked_before(history: History, edges: list[tuple[Calls, int]], text: str) -> bool:
    """Whether a start in the scan of edges is what a block that was Busy has asked for by an edge before, and not sent.

    What goes out in that very scan may be on its way before the block sees the new edge.
    """
    for calls, index in edges:
        earlier = calls.edge_before(calls.scans[index - 1]) if index and calls.busy[index - 1] else -1
        if earlier < 0 or not starts(calls.kind, text[6:]):
            continue
        if text not in history.asked_between(calls.scans[earlier], calls.scans[index] - 1):
            return True
    return False


def _is_of_a_third(history: History, edges: list[tuple[Calls, int]], scan: int, when: int, text: str) -> bool:
    """Whether a start may be of a block of the same kind as one of two, whose edge came after theirs."""
    pair = [calls for calls, _ in edges]
    for calls in history.of_kind(*MOTIONS):
        index = calls.edge_before(when)
        if calls in pair or index < 0 or not starts(calls.kind, text[6:]):
            continue
        if calls.scans[index] > scan and calls.busy[index] and (calls.busy_at(when - 1) or calls.busy_at(when)):
            return True
    return False


def _losers(history: History, losers: list[Calls], scan: int) -> Iterator[Violation]:
    """Rule 18: the blocks of an edge in a scan that do not start, and end otherwise than aborted by who does."""
    for calls in losers:
        ending = _end_after(calls, scan)
        if ending is None or ending[1] in ("edge", "CommandAborted"):
            continue
        if ending[1] == "Done" and calls.kind in JOGS and ending[0] == calls.scans[calls.index_at(scan) + 1]:
            # Its input has fallen before the first call in which it could show that it has lost.
            continue
        if ending[1] == "Done" or _is_clear(history, scan):
            yield Violation(18, ending[0], calls.name, f"{ending[1]} {ending[2]}, and another was started")


def who_fails_stops_or_says_so(history: History) -> Iterator[Violation]:
    """Rule 21: after Abort or an error a stop is among the next two requests, or ErrorID says that it may be moving."""
    for end in ("CommandAborted", "Error"):
        for calls, index, scan, number in _ends_in_motion(history, end):
            if (
                calls.kind in JOGS
                or calls.error[index] in history.may_move
                or (end != "Error" and not calls.abort[index])
            ):
                continue
            if not _stopped(history, number, scan):
                how = f"Error {calls.error[index]}" if end == "Error" else "Abort"
                yield Violation(21, scan, calls.name, f"{how}, and its motion goes on without a stop")


def nothing_is_done_without_power(history: History) -> Iterator[Violation]:
    """Rule 32: with the servo off, or with an alarm, a motion ends with Error and never with Done."""
    for calls in history.of_kind(*MOTIONS):
        if calls.kind == "velocity":
            continue
        for index, scan in enumerate(calls.scans):
            if not calls.edges[index] or not scan:
                continue
            last = _last_before_edge(history, calls, index)
            states = [history.scans[when].state for when in range(scan - 1, last + 1)]
            if any(state.servo and not state.alarm for state in states):
                continue
            done = calls.kind not in JOGS
            if done and any("Done" in calls.ends[following] for following in range(index, calls.edge_after(index))):
                yield Violation(32, scan, calls.name, "Done without power, or with an alarm")
            elif _is_clear(history, scan) and history.after(scan) <= last and calls.busy_at(history.after(scan)):
                yield Violation(32, scan, calls.name, "without power, or with an alarm, it stays Busy")


def an_alarm_ends_a_motion(history: History) -> Iterator[Violation]:
    """Rule 33: an alarm while it moves is Error 8 within one poll."""
    for scan, event in history.events:
        if event.kind != "alarm" or not scan or not history.scans[scan - 1].state.number:
            continue
        number = history.scans[scan - 1].state.number
        for calls in history.of_kind(*MOTIONS):
            if not calls.busy_at(scan) or _owner_number(history, calls, scan) != number:
                continue
            ending = _end_after(calls, scan)
            if ending is None:
                if _is_clear(history, scan + 1) and history.scans[scan].clear:
                    yield Violation(33, scan, calls.name, "an alarm, and it stays Busy")
            elif ending[1] == "Done" and not _was_reached(history, number, ending[0]):
                yield Violation(33, ending[0], calls.name, f"Done after the alarm of scan {scan}")
            elif ending[1:] in (("CommandAborted", 0), ("Error", LOCKED)) and _is_stopped(history, scan, ending[0]):
                continue
            elif ending[1] == "CommandAborted" and not _has_successor(history, number, ending[0]):
                yield Violation(33, ending[0], calls.name, f"CommandAborted after the alarm of scan {scan}")
            elif ending[0] > history.after(scan) and _is_clear(history, scan + 1):
                yield Violation(33, ending[0], calls.name, f"the alarm of scan {scan} ends it so late")
            elif ending[1] == "Error" and ending[2] != ALARM and ending[2] not in history.may_move:
                if not all(history.scans[when].state.alarm for when in range(scan, ending[0] + 1)):
                    continue
                text = f"the alarm of scan {scan} is Error {ending[2]}"
                yield Violation(33, ending[0], calls.name, text)


def silence_is_an_error(history: History) -> Iterator[Violation]:
    """Rule 38: where no answer comes any more, what is asked for by an edge ends with Error within a bounded time."""
    for calls in history.of_kind(*MOVES, "home", "power_on", "power_off", "reset"):
        for index, scan in enumerate(calls.scans):
            if not calls.edges[index] or not calls.busy[index]:
                continue
            end = history.after(scan, 2)
            last = _last_before_edge(history, calls, index)
            fates = [fate for entry in history.scans[scan:end] for fate in entry.fates]
            if end <= last and len(fates) > 5 and set(fates) <= set(LOST) and calls.busy_at(end):
                yield Violation(38, scan, calls.name, "it stays Busy although nothing answers")


def a_valid_position_is_true(history: History) -> Iterator[Violation]:
    """Rules 39 and 40: a valid position is one that the device had lately; that of another station is none.

    So is one that nobody asks for any more, or that stands beside an error.
    """
    for calls in history.of_kind("read"):
        for index, scan in enumerate(calls.scans):
            entry = history.scans[scan]
            if not entry.outputs.get((calls.name, "Valid")):
                continue
            if not calls.execute[index] or "Error" in calls.ends[index]:
                beside = "an error" if calls.execute[index] else "Enable FALSE"
                yield Violation(39, scan, calls.name, f"Valid is TRUE with {beside}")
            position = history.position_of(calls.name, entry.outputs)
            if position is None:
                continue
            # What is shown after a gap in the calls is what was read before it.
            first = calls.scans[index - 1] if index else scan
            before = calls.scans[max(index - 1, 0)]
            while first and (history.times[before] - history.times[first] < history.patience or before - first < SLOW):
                first -= 1
            places = [history.scans[when].state.position for when in range(first, scan + 1)]
            if not min(places) - 5 <= position <= max(places) + 5:
                yield Violation(
                    39, scan, calls.name, f"the position {position:g} is valid, and the axis never was there"
                )


def _was_reached(history: History, number: int, last: int) -> bool:
    """Whether a motion has come to its target by a scan."""
    return any(event.kind == "reached" and event.number == number for scan, event in history.events if scan <= last)


def _owner_number(history: History, calls: Calls, scan: int) -> int:
    """The number of the last command of a block that was accepted since it is Busy; 0 where there is none."""
    edge = calls.begin_before(scan)
    begun: list[tuple[int, Event]] = history.accepted(calls, calls.scans[edge], scan) if edge >= 0 else []
    return begun[-1][1].number if begun else 0


def _ends_in_motion(history: History, end: str) -> Iterator[tuple[Calls, int, int, int]]:
    """Where blocks end while the motion that they have asked for is on: with the call, the scan and the motion."""
    for calls in history.of_kind(*MOTIONS):
        for index, scan in enumerate(calls.scans):
            if not calls.falls_busy(index) or end not in calls.ends[index] or (calls.ends[index] and not end):
                continue
            number = _owner_number(history, calls, scan)
            if history.is_on(number, scan):
                yield calls, index, scan, number


def _stopped(history: History, number: int, scan: int) -> bool:
    """Whether a stop was on the wire since a motion was accepted, or is among the next two requests."""
    accepted = next(when for when, event in history.events if event.number == number)
    asked = history.asked_between(accepted, scan)
    begin = max((place for place, text in enumerate(asked) if text.startswith("start ")), default=0)
    return any(text in STOPPING for text in asked[begin:]) or history.stop_follows(scan + 1, 2) is not False


def _disclaimed(history: History, number: int, begin: int, scan: int) -> bool:
    """Whether who was responsible for a motion has said since it was accepted that the device may be moving.

    That is its block, a stop, or the last block that was Busy.
    """
    names = {owner for _, event, owner in history.owners if event.kind == "accepted" and event.number == number}
    names |= {calls.name for calls in history.of_kind(*STOPS)}
    blocks = history.of_kind(*MOTIONS, *STOPS)
    for calls in blocks:
        for index in range(max(calls.index_at(begin), 0), calls.index_at(scan) + 1):
            when = calls.scans[index]
            if when < begin or not calls.rises(index, "Error") or calls.error[index] not in history.may_move:
                continue
            if calls.name in names or not any(other.busy_at(when) for other in blocks):
                return True
    return False


def _end_after(calls: Calls, scan: int) -> tuple[int, str, int] | None:
    """How a block that is Busy after a scan ends before its next edge: the scan, the output and the ErrorID."""
    for index in range(max(calls.index_at(scan), 0) + 1, len(calls.scans)):
        if calls.edges[index] or calls.fresh[index]:
            return calls.scans[index], "edge", 0
        if calls.ends[index]:
            return calls.scans[index], calls.ends[index], calls.error[index]
    return None


def _last_before_edge(history: History, calls: Calls, index: int) -> int:
    """The last scan before the next edge of a block."""
    end = calls.edge_after(index)
    return calls.scans[end] - 1 if end < len(calls.scans) else len(history.scans) - 1


def _is_clear(history: History, scan: int) -> bool:
    """Whether nothing is disturbed for as long as a few exchanges take, and the record goes on so long."""
    end = history.after(scan) if scan < len(history.scans) else len(history.scans)
    return end < len(history.scans) and history.clear_until[scan] > end


MOTION_RULES = (
    somebody_is_responsible,
    who_is_aborted_has_a_successor,
    who_is_refused_ends_with_an_error,
    two_edges_start_once,
    who_fails_stops_or_says_so,
    nothing_is_done_without_power,
    an_alarm_ends_a_motion,
    silence_is_an_error,
    a_valid_position_is_true,
)
