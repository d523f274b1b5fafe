"""Monitors of stops, jogs, power and blocks that follow an input: rules 22 to 31, 35 and 36."""

from __future__ import annotations

from collections.abc import Iterator

from device_models.history import JOGS, LOCKS, MOTIONS, STOPPING, STOPS, Calls, History, Violation, starts
from device_models.motion_rules import (
    LOCKED,
    LOST_ANSWER,
    START_BITS,
    _asks_to_stop,
    _ends_in_motion,
    _is_being_stopped,
    _is_clear,
    _last_before_edge,
    _owner_number,
)

JOG_BITS = 0x0300
TRIES = 3
LATELY = 3
"""Scans in which the control word may still be that of a motion that has ended."""


def a_stop_comes_next(history: History) -> Iterator[Violation]:
    """Rule 22: after the edge of a stop, the next request that is not on its way is the stop; so is a telegram."""
    for calls, index, scan in _stop_edges(history):
        if calls.abort[index] or not calls.busy[index]:
            continue
        word = history.scans[scan].word
        if word is not None:
            if not _asks_to_stop(word):
                yield Violation(22, scan, calls.name, f"the telegram after the edge has the control word {word:04X}H")
            continue
        # What another block has asked for in this scan, before the stop was called, is on its way.
        if any(text in STOPPING for text in history.scans[scan].asked):
            continue
        last = _last_before_edge(history, calls, index)
        following = next(((when, text) for when, text in history.requests if scan < when <= last), None)
        if following is None:
            if history.after(scan) <= last and _is_called(calls, scan, history.after(scan)):
                yield Violation(22, scan, calls.name, "nothing is sent")
        elif following[1] not in STOPPING and _is_called(calls, scan, following[0]):
            yield Violation(22, scan, calls.name, f"{following[1]} goes before the stop")


def _is_called(calls: Calls, first: int, last: int) -> bool:
    """Whether a block is called in each of some scans, both included."""
    return calls.index_at(last) - calls.index_at(first) == last - first


def a_stop_never_gives_up(history: History) -> Iterator[Violation]:
    """Rule 23: a stop ends with its bits cleared, and is asked for three times where no answer comes.

    A halt does not lock the axis: where it stands, a motion that was asked for since has the bits that let tasks go on.
    """
    for calls, index, scan in _stop_edges(history):
        last = _last_before_edge(history, calls, index)
        end = next((place for place in range(index, calls.index_at(last) + 1) if calls.ends[place]), None)
        if end is None or calls.abort[end] or (calls.kind == "halt" and "CommandAborted" in calls.ends[end]):
            continue
        when = calls.scans[end]
        word = history.scans[when].word
        if word is not None:
            begins = calls.kind == "halt" and any(text.startswith("start ") for text in history.scans[when].asked)
            prepares = calls.kind == "halt" and not word & START_BITS and _is_succeeded(history, scan, when)
            if not begins and not prepares and not _asks_to_stop(word):
                text = f"it ends with {calls.ends[end]}, and the control word {word:04X}H"
                yield Violation(23, when, calls.name, text)
            elif not any(_asks_to_stop(entry.word or 0) for entry in history.scans[scan : when + 1]):
                yield Violation(23, when, calls.name, "it ends, and its bits were never cleared")
        elif "Error" in calls.ends[end] and not _others_lock(history, calls, scan, when):
            number = sum(text in STOPPING for text in history.asked_between(scan, when))
            heard = any(event.kind == "stop" for at, event in history.events if scan <= at <= when)
            if number < TRIES and not (heard and calls.error[end] not in history.may_move):
                text = f"Error {calls.error[end]} after {number} tries to stop"
                yield Violation(23, when, calls.name, text)


def a_stop_is_done_at_standstill(history: History) -> Iterator[Violation]:
    """Rule 24: a stop is done where the axis stands, and a start of before that begins late makes it FALSE again."""
    for calls in history.of_kind(*STOPS):
        for index, scan in enumerate(calls.scans):
            if not calls.rises(index, "Done"):
                continue
            states = [history.scans[when].state for when in (max(scan - 1, 0), scan)]
            if all(state.number and state.velocity for state in states):
                yield Violation(24, scan, calls.name, f"Done at {states[1].velocity:.0f} counts in a second")
                continue
            number = states[1].waiting
            begin = _begin_of(history, number)
            if not number or begin <= scan or (calls.kind == "halt" and _is_of_successor(history, calls, scan, number)):
                continue
            if "Done" in calls.ends[calls.index_at(begin)] and not calls.busy_at(begin):
                yield Violation(24, begin, calls.name, "Done, and a motion of before begins")
                continue
            # Done beside Busy is FALSE again as soon as an exchange can show that it moves.
            end = history.after(begin)
            last = calls.index_at(end) if end < len(history.scans) else -1
            moves = all(item.state.number == number and item.state.velocity for item in history.scans[begin + 1 : end])
            if last >= 0 and moves and all("Done" in calls.ends[place] for place in range(index, last + 1)):
                yield Violation(24, end, calls.name, "it stays Done while a motion of before goes on")


def a_stop_locks_the_axis(history: History) -> Iterator[Violation]:
    """Rule 25: while a stop is Busy or its input TRUE, an edge of another block ends with Error."""
    for calls in history.of_kind(*MOTIONS):
        for index, scan in enumerate(calls.scans):
            if not calls.edges[index] or calls.abort[index]:
                continue
            if not any(_locked(lock, scan) for lock in history.of_kind(*LOCKS)):
                continue
            last = _last_before_edge(history, calls, index)
            # A motion that goes on until the stop is accepted may end as aborted by it.
            good = ("Error", "CommandAborted") if index and calls.busy[index - 1] else ("Error",)
            ending = next(
                (calls.ends[place] for place in range(index, calls.index_at(last) + 1) if calls.ends[place]), ""
            )
            if ending not in (*good, "") or (not ending and _is_clear(history, scan) and history.after(scan) <= last):
                text = f"a stop has the axis, and it ends with {ending or 'nothing'}"
                yield Violation(25, scan, calls.name, text)


def nothing_starts_while_it_is_locked(history: History) -> Iterator[Violation]:
    """Rules 25 and 26: while a stop is Busy or its input TRUE no start is on the wire, nor one of then afterwards."""
    blocks = history.of_kind(*MOTIONS)
    for scan, text in history.requests:
        if not text.startswith("start "):
            continue
        if any(_locked(lock, scan) for lock in history.of_kind(*LOCKS)):
            yield Violation(25, scan, "axis", f"{text} is on the wire although a stop has the axis")
            continue
        owners = [calls for calls in blocks if starts(calls.kind, text[6:])]
        edges = [calls.scans[calls.edge_before(scan)] for calls in owners if calls.edge_before(scan) >= 0]
        if edges and all(any(_locked(lock, edge) for lock in history.of_kind(*LOCKS)) for edge in edges):
            yield Violation(26, scan, "axis", f"{text} is on the wire, and its edge was while a stop had the axis")


def a_stop_is_not_aborted(history: History) -> Iterator[Violation]:
    """Rules 25 and 27: a stop that is Busy ends with CommandAborted by its own Abort alone."""
    for calls in history.of_kind(*LOCKS):
        for index, scan in enumerate(calls.scans):
            if calls.rises(index, "CommandAborted") and not calls.abort[index]:
                yield Violation(27, scan, calls.name, "a stop is aborted")


def a_halt_is_aborted_by_a_successor(history: History) -> Iterator[Violation]:
    """Rules 16 and 20: a halt of a moving axis is aborted by what the device has accepted of another since its edge."""
    for calls in history.of_kind("halt"):
        for index, scan in enumerate(calls.scans):
            if not calls.rises(index, "CommandAborted") or not history.scans[scan].state.velocity:
                continue
            edge = calls.edge_before(scan)
            first = calls.scans[edge] if edge >= 0 else scan
            accepted = any(
                event.kind in ("accepted", "stop") and event.about != "outside" and first <= when <= scan
                for when, event in history.events
            )
            if not accepted and not _others_lock(history, calls, scan, scan):
                yield Violation(20, scan, calls.name, "a halt is aborted, and the device has accepted nothing since")


def a_stop_at_standstill_is_done(history: History) -> Iterator[Violation]:
    """Rule 28: at standstill a stop is done within a bounded time; a halt is refused while a stop has the axis."""
    for calls, index, scan in _stop_edges(history):
        if not scan or not _is_clear(history, scan) or history.scans[scan - 1].state.velocity:
            continue
        end = history.after(scan)
        places = range(index, calls.index_at(end) + 1)
        if any(calls.abort[place] or (calls.edges[place] and place > index) for place in places):
            continue
        locked = any(calls.error[place] == LOCKED for place in places)
        if locked and _others_lock(history, calls, scan, end):
            continue
        good = ("Done", "CommandAborted") if calls.kind == "halt" else ("Done",)
        if not any(end in calls.ends[place] for place in places for end in good):
            ending = next((calls.ends[place] for place in places if calls.ends[place]), "nothing")
            yield Violation(28, scan, calls.name, f"at standstill it ends with {ending}")


def a_jog_ends_with_its_input(history: History) -> Iterator[Violation]:
    """Rule 29: where the input of a jog falls, the stop is among the next two requests; it is Busy until it stands."""
    for calls in history.of_kind(*JOGS):
        for index, scan in enumerate(calls.scans):
            if not index or calls.fresh[index] or not calls.busy[index - 1]:
                continue
            number = _owner_number(history, calls, scan)
            if _releases(calls, index) and history.is_on(number, scan) and not _is_stopped(history, number, scan):
                following = [when for when, _ in history.requests if when >= scan][:2]
                last = following[-1] if following else scan
                word = history.scans[scan].word
                if word is not None and word & JOG_BITS:
                    yield Violation(29, scan, calls.name, f"the telegram after it has the control word {word:04X}H")
                elif history.stop_follows(scan, 2) is False and not _is_followed(history, number, last):
                    yield Violation(29, scan, calls.name, "two other requests, or none, go before the stop")
            state = history.scans[scan].state
            if not (calls.busy[index] or calls.ends[index]) and number and state.number == number and state.velocity:
                yield Violation(29, scan, calls.name, "it is not Busy any more, and the axis has not come to a halt")


def _is_stopped(history: History, number: int, last: int) -> bool:
    """Whether the device has obeyed a stop of a motion that it was carrying out, by a scan."""
    return any(
        event.kind == "stop" and event.about != "outside" and event.number == number and when <= last
        for when, event in history.events
    )


def _releases(calls: Calls, index: int) -> bool:
    """Whether the direction that was asked for alone is asked for no more, or no more alone."""
    before, now = calls.directions[index - 1], calls.directions[index]
    return before != now and sum(before) == 1


def a_jog_stops_itself(history: History) -> Iterator[Violation]:
    """Rule 30: a jog that ends while it moves has asked for the stop, three times if need be, or has a successor."""
    for end in ("CommandAborted", "Error", ""):
        for calls, _, scan, number in _ends_in_motion(history, end):
            if calls.kind not in JOGS or _is_followed(history, number, scan + 1):
                continue
            if end == "CommandAborted" and _is_being_stopped(history, number, scan):
                continue
            accepted = next(when for when, event in history.events if event.number == number)
            asked = sum(text in STOPPING for text in history.asked_between(accepted, scan + 1))
            stopped = any(
                event.kind == "stop" and event.about != "outside" and accepted <= when <= scan + 1
                for when, event in history.events
            )
            # Each telegram without the bits of a jog asks for its end, whether it is heard or not.
            words = [entry.word for entry in history.scans[max(scan - TRIES + 1, 0) : scan + 1]]
            if all(word is not None and not word & JOG_BITS for word in words):
                continue
            if end == "Error" and _is_withdrawn(history, scan):
                continue
            if not stopped and asked < TRIES and scan + 1 < len(history.scans):
                yield Violation(30, scan, calls.name, f"it ends with {end or 'nothing'}, and the axis jogs on")


def _is_withdrawn(history: History, first: int) -> bool:
    """Whether the telegram of a scan is lost, and each from then on has no bit of a jog until the device gets one."""
    entries = history.scans[first:]
    is_lost = any(fate.startswith("lost") for fate in entries[0].fates)
    lost = next((place for place, entry in enumerate(entries) if "good" in entry.fates), len(entries))
    return is_lost and all(entry.word is not None and not entry.word & JOG_BITS for entry in entries[: lost + 1])


def both_directions_are_none(history: History) -> Iterator[Violation]:
    """Rule 31: with both inputs of a jog TRUE, the axis comes to a halt."""
    for calls in history.of_kind("jog"):
        for index, scan in enumerate(calls.scans):
            if len(calls.directions[index]) < 2 or not all(calls.directions[index]):
                continue
            if index and all(calls.directions[index - 1]) and not calls.fresh[index]:
                continue
            end = history.after(scan)
            if not _is_clear(history, scan):
                continue
            both = all(all(calls.directions[place]) for place in range(index, calls.index_at(end) + 1))
            number = _owner_number(history, calls, end)
            if both and number and history.scans[end].state.number == number and history.scans[end].state.velocity:
                yield Violation(31, end, calls.name, "both directions are asked for, and it moves")


def a_jog_turns_at_standstill(history: History) -> Iterator[Violation]:
    """Rule 31: a jog asks for the other direction where the axis stands."""
    signs = {"jog_forward": 1, "jog_backward": -1}
    for scan, event, owner in history.owners:
        if event.kind != "accepted" or event.about not in signs or history.blocks[owner].kind not in JOGS or not scan:
            continue
        state = history.scans[scan - 1].state
        before = {item.number: item.about for when, item, _ in history.owners if when <= scan}.get(state.number)
        if before in signs and state.number and state.velocity * signs[event.about] < 0:
            yield Violation(31, scan, owner, f"it turns at {state.velocity:.0f} counts in a second")


def power_comes_at_the_first_try(history: History) -> Iterator[Violation]:
    """Rule 35: switching on is done at the first try, where no alarm and no stop is in the way."""
    for calls in history.of_kind("power_on"):
        for index, scan in enumerate(calls.scans):
            if not calls.edges[index] or not scan or not _is_clear(history, scan):
                continue
            end = history.after(scan)
            places = range(index, calls.index_at(end) + 1)
            alarm = any(history.scans[when].state.alarm for when in range(scan - 1, end + 1))
            disturbed = any(calls.abort[place] or (calls.edges[place] and place > index) for place in places)
            others = history.of_kind(*LOCKS, "power_off", "reset")
            busy = any(
                other.busy_at(when) or (other.kind in LOCKS and _locked(other, when))
                for other in others
                for when in (scan - 1, scan, end)
            )
            later = any(other.edge_before(end) > other.index_at(scan - 1) for other in others)
            if alarm or disturbed or busy or later:
                continue
            if not any("Done" in calls.ends[place] for place in places):
                ending = next((calls.ends[place] for place in places if calls.ends[place]), "nothing")
                yield Violation(35, scan, calls.name, f"switching on ends with {ending}")


def who_follows_falls_to_neutral(history: History) -> Iterator[Violation]:
    """Rule 36: a block that follows its input asks for no speed in the scan in which its input falls or it ends."""
    for calls in history.of_kind("velocity"):
        for index, scan in enumerate(calls.scans):
            fell = index > 0 and calls.execute[index - 1] and not calls.execute[index]
            following = [text for text in history.scans[scan].asked if text.startswith("speed ")]
            blind = scan > 0 and calls.execute[index] and LOST_ANSWER in history.scans[scan - 1].fates
            if (fell or calls.falls_busy(index) or blind) and any(text != "speed 0" for text in following):
                reason = "its telegram is invalid" if blind else "its input falls or it ends"
                yield Violation(36, scan, calls.name, f"{reason}, and it asks for {following[-1]}")


def _stop_edges(history: History) -> Iterator[tuple[Calls, int, int]]:
    for calls in history.of_kind(*STOPS):
        for index, scan in enumerate(calls.scans):
            if calls.edges[index]:
                yield calls, index, scan


def _others_lock(history: History, calls: Calls, first: int, last: int) -> bool:
    """Whether another stop has the axis before one of some scans, or after it."""
    others = [lock for lock in history.of_kind(*LOCKS) if lock is not calls]
    return any(
        lock.busy_at(when) or (lock.index_at(when) >= 0 and lock.execute[lock.index_at(when)])
        for lock in others
        for when in range(max(first - 1, 0), min(last + 1, len(history.scans)))
    )


def _is_succeeded(history: History, first: int, last: int) -> bool:
    """Whether the axis stands, and a motion is Busy, or was lately, whose edge was not before a scan."""
    lately = range(max(first, last - LATELY), last + 1)
    motions = [calls for calls in history.of_kind(*MOTIONS) if any(calls.busy_at(scan) for scan in lately)]
    edges = [(calls, calls.edge_before(last)) for calls in motions]
    stands = not history.scans[last].state.velocity
    return stands and any(edge >= 0 and calls.scans[edge] >= first for calls, edge in edges)


def _is_of_successor(history: History, halt: Calls, last: int, number: int) -> bool:
    """Whether the device has accepted a motion in the scan in which a halt ends, of a block called after its edge."""
    edge = halt.scans[max(halt.edge_before(last), 0)]
    owner = next((name for scan, event, name in history.owners if scan == last and event.number == number), "")
    return bool(owner) and history.blocks[owner].scans[max(history.blocks[owner].edge_before(last), 0)] >= edge


def _is_followed(history: History, number: int, last: int) -> bool:
    """Whether the device has accepted a later command than a motion by a scan."""
    return any(event.kind == "accepted" and event.number > number and when <= last for when, event in history.events)


def _begin_of(history: History, number: int) -> int:
    """The scan in which a motion begins; 0 where it does not."""
    return next((when for when, event in history.events if event.kind == "began" and event.number == number), 0)


def _locked(lock: Calls, scan: int) -> bool:
    """Whether a stop has the axis before the calls of a scan, and still after them."""
    before, now = lock.index_at(scan - 1), lock.index_at(scan)
    if before < 0 or lock.edge_before(scan - 1) < 0 or lock.fresh[now]:
        return False
    begun = lock.busy[before] or (lock.execute[before] and lock.ends[before] != "")
    return begun and (lock.busy[now] or lock.execute[now])


STOP_RULES = (
    a_stop_comes_next,
    a_stop_never_gives_up,
    a_stop_is_done_at_standstill,
    a_stop_locks_the_axis,
    nothing_starts_while_it_is_locked,
    a_stop_is_not_aborted,
    a_halt_is_aborted_by_a_successor,
    a_stop_at_standstill_is_done,
    a_jog_ends_with_its_input,
    a_jog_stops_itself,
    both_directions_are_none,
    a_jog_turns_at_standstill,
    power_comes_at_the_first_try,
    who_follows_falls_to_neutral,
)
