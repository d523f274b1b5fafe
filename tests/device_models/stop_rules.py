"""Monitors of stops, jogs, power and blocks that follow an input: rules 22 to 31, 35 and 36."""

from __future__ import annotations

from collections.abc import Iterator

from device_models.history import JOGS, LOCKS, MOTIONS, STOPS, Calls, History, Violation, starts
from device_models.motion_rules import _ends_in_motion, _is_clear, _last_before_edge, _owner_number

START_BITS = 0x0B40
TASK_BITS = 0x0030
"""Bits of STW1 that start a motion, and those that let a task go on."""
TRIES = 3
LOCKED = 12


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
        last = _last_before_edge(history, calls, index)
        following = [text for when, text in history.requests if scan <= when <= last][:2]
        if len(following) == 2 and not any(text in ("stop", "off") for text in following):
            yield Violation(22, scan, calls.name, f"{' and '.join(following)} go before the stop")


def a_stop_never_gives_up(history: History) -> Iterator[Violation]:
    """Rule 23: a stop ends with its bits cleared, and is asked for three times where no answer comes."""
    for calls, index, scan in _stop_edges(history):
        last = _last_before_edge(history, calls, index)
        end = next((place for place in range(index, calls.index_at(last) + 1) if calls.ends[place]), None)
        if end is None or calls.abort[end] or (calls.kind == "halt" and "CommandAborted" in calls.ends[end]):
            continue
        when = calls.scans[end]
        word = history.scans[when].word
        if word is not None:
            begins = calls.kind == "halt" and any(text.startswith("start ") for text in history.scans[when].asked)
            if not begins and not _asks_to_stop(word):
                text = f"it ends with {calls.ends[end]}, and the control word {word:04X}H"
                yield Violation(23, when, calls.name, text)
        elif "Error" in calls.ends[end] and calls.error[end] in history.may_move:
            number = sum(text in ("stop", "off") for text in history.asked_between(scan, when))
            if number < TRIES:
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
            if number and begin > scan and "Done" in calls.ends[calls.index_at(begin)] and not calls.busy_at(begin):
                yield Violation(24, begin, calls.name, "Done, and a motion of before begins")


def a_stop_locks_the_axis(history: History) -> Iterator[Violation]:
    """Rules 25 and 26: while a stop is Busy or its input TRUE, other motions end with Error and start nothing."""
    for calls in history.of_kind(*MOTIONS):
        for index, scan in enumerate(calls.scans):
            if not calls.edges[index] or calls.abort[index] or (index and calls.busy[index - 1]):
                continue
            if not any(_locked(lock, scan) for lock in history.of_kind(*LOCKS)):
                continue
            last = _last_before_edge(history, calls, index)
            asked = [text for text in history.asked_between(scan, last) if text.startswith("start ")]
            if any(starts(calls.kind, text[6:]) for text in asked):
                yield Violation(25, scan, calls.name, "it starts although a stop has the axis")
            elif calls.busy[index] and _is_clear(history, scan):
                ending = [calls.ends[place] for place in range(index, calls.index_at(last) + 1) if calls.ends[place]]
                if not ending or "Error" not in ending[0]:
                    text = f"a stop has the axis, and it ends with {ending[0] if ending else 'nothing'}"
                    yield Violation(25, scan, calls.name, text)


def a_stop_is_not_aborted(history: History) -> Iterator[Violation]:
    """Rules 25 and 27: a stop that is Busy ends with CommandAborted by its own Abort alone."""
    for calls in history.of_kind(*LOCKS):
        for index, scan in enumerate(calls.scans):
            if calls.rises(index, "CommandAborted") and not calls.abort[index]:
                yield Violation(27, scan, calls.name, "a stop is aborted")


def a_stop_at_standstill_is_done(history: History) -> Iterator[Violation]:
    """Rule 28: at standstill a stop is done within a bounded time; a halt is refused while a stop has the axis."""
    for calls, index, scan in _stop_edges(history):
        if not scan or not _is_clear(history, scan) or history.scans[scan - 1].state.velocity:
            continue
        end = history.after(scan)
        places = range(index, calls.index_at(end) + 1)
        if any(calls.abort[place] or (calls.edges[place] and place > index) for place in places):
            continue
        if calls.kind == "halt" and any(calls.error[place] == LOCKED for place in places):
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
            if calls.execute[index - 1] and not calls.execute[index] and history.is_on(number, scan):
                following = [item for item in history.requests if item[0] >= scan][:2]
                texts = [text for _, text in following]
                last = following[-1][0] if following else scan
                stopped = any(text in ("stop", "off") for text in texts) or _is_followed(history, number, last)
                if len(texts) == 2 and not stopped:
                    yield Violation(29, scan, calls.name, f"{' and '.join(texts)} go before the stop")
            state = history.scans[scan].state
            if not (calls.busy[index] or calls.ends[index]) and number and state.number == number and state.velocity:
                yield Violation(29, scan, calls.name, "it is not Busy any more, and the axis has not come to a halt")


def a_jog_stops_itself(history: History) -> Iterator[Violation]:
    """Rule 30: a jog that ends while it moves has asked for the stop, three times if need be, or has a successor."""
    for end in ("CommandAborted", "Error", ""):
        for calls, _, scan, number in _ends_in_motion(history, end):
            if calls.kind not in JOGS or _is_followed(history, number, scan + 1):
                continue
            accepted = next(when for when, event in history.events if event.number == number)
            asked = sum(text in ("stop", "off") for text in history.asked_between(accepted, scan + 1))
            stopped = any(event.kind == "stop" for when, event in history.events if accepted <= when <= scan + 1)
            if not stopped and asked < TRIES and scan + 1 < len(history.scans):
                yield Violation(30, scan, calls.name, f"it ends with {end or 'nothing'}, and the axis jogs on")


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
            if (fell or calls.falls_busy(index)) and any(text != "speed 0" for text in following):
                yield Violation(36, scan, calls.name, f"its input falls or it ends, and it asks for {following[-1]}")


def _stop_edges(history: History) -> Iterator[tuple[Calls, int, int]]:
    for calls in history.of_kind(*STOPS):
        for index, scan in enumerate(calls.scans):
            if calls.edges[index]:
                yield calls, index, scan


def _asks_to_stop(word: int) -> bool:
    """Whether a control word lets nothing move."""
    return not word & START_BITS and (word & TASK_BITS != TASK_BITS or word & 0x0F != 0x0F)


def _is_followed(history: History, number: int, last: int) -> bool:
    """Whether the device has accepted a later command than a motion by a scan."""
    return any(event.kind == "accepted" and event.number > number and when <= last for when, event in history.events)


def _begin_of(history: History, number: int) -> int:
    """The scan in which a motion begins; 0 where it does not."""
    return next((when for when, event in history.events if event.kind == "began" and event.number == number), 0)


def _locked(lock: Calls, scan: int) -> bool:
    """Whether a stop has the axis before the calls of a scan, and still after them."""
    before, now = lock.index_at(scan - 1), lock.index_at(scan)
    if before < 0 or now <= before or lock.edge_before(scan - 1) < 0 or lock.edges[now]:
        return False
    if any(end in lock.ends[place] for end in ("Error", "CommandAborted") for place in (before, now)):
        return False
    begun = lock.busy[before] or (lock.execute[before] and "Done" in lock.ends[before])
    return begun and (lock.busy[now] or lock.execute[now])


STOP_RULES = (
    a_stop_comes_next,
    a_stop_never_gives_up,
    a_stop_is_done_at_standstill,
    a_stop_locks_the_axis,
    a_stop_is_not_aborted,
    a_stop_at_standstill_is_done,
    a_jog_ends_with_its_input,
    a_jog_stops_itself,
    both_directions_are_none,
    power_comes_at_the_first_try,
    who_follows_falls_to_neutral,
)
