"""What is recorded scan by scan of blocks, a line and a device, and what can be read off it."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from device_models.axis import Event, State

MOVES = ("absolute", "relative", "point")
JOGS = ("jog", "jog_forward", "jog_backward")
MOTIONS = (*MOVES, "home", *JOGS, "velocity")
"""Kinds of blocks that move an axis."""
STOPS = ("stop", "quick_stop", "halt")
LOCKS = ("stop", "quick_stop")
"""Kinds that keep all others from moving it while their input is TRUE."""
POWER = ("power_on", "power_off")
STOPPING = ("stop", "off")
"""What is asked for where an axis is to stop."""
ENDS = ("Done", "CommandAborted", "Error")
JOG_INPUTS = {"JogForward": "jog_forward", "JogBackward": "jog_backward"}
SLOW = 150
"""Scans in which the blocks of a device exchange what they have to, however long a scan is."""
STARTS = ("Execute", "Enable", *JOG_INPUTS)
"""Inputs that make a block work."""


STANDING = State()
"""An axis at its home, with power."""


@dataclass
class Scan:
    """One scan, and what the device does until the next.

    `inputs` and `outputs` are by block and name. `asked` is what requests on the wire mean, `fates` how exchanges have
    ended, `word` the control word of a telegram. `invalid` has the blocks with a value out of range. `disturbed` says
    what happened to the controller or the device in this scan; `clear` that the line and the device are sound.
    """

    milliseconds: int = 10
    inputs: Mapping[tuple[str, str], float] = field(default_factory=dict)
    outputs: Mapping[tuple[str, str], float] = field(default_factory=dict)
    called: frozenset[str] | None = None
    asked: Sequence[str] = ()
    fates: Sequence[str] = ()
    events: Sequence[Event] = ()
    state: State = STANDING
    disturbed: Sequence[str] = ()
    invalid: frozenset[str] = frozenset()
    clear: bool = True
    word: int | None = None


@dataclass(frozen=True)
class Violation:
    """A rule that a block has broken in a scan."""

    rule: int
    scan: int
    block: str
    text: str

    def __str__(self) -> str:
        return f"rule {self.rule}, scan {self.scan}, {self.block}: {self.text}"


@dataclass
class Calls:
    """A block, call by call: the number of the scan, its inputs and outputs.

    `edges` is whether a call has seen a rising edge, `fresh` whether it is the first one after a restart.
    """

    name: str
    kind: str
    scans: list[int] = field(default_factory=list)
    execute: list[bool] = field(default_factory=list)
    edges: list[bool] = field(default_factory=list)
    fresh: list[bool] = field(default_factory=list)
    abort: list[bool] = field(default_factory=list)
    busy: list[bool] = field(default_factory=list)
    ends: list[str] = field(default_factory=list)
    error: list[int] = field(default_factory=list)
    active: list[bool] = field(default_factory=list)
    directions: list[tuple[bool, ...]] = field(default_factory=list)
    _before: dict[int, int] = field(default_factory=dict)

    def index_at(self, scan: int) -> int:
        """The index of the last call in a scan or before it; -1 where there is none."""
        low, high = 0, len(self.scans)
        while low < high:
            middle = (low + high) // 2
            if self.scans[middle] <= scan:
                low = middle + 1
            else:
                high = middle
        return low - 1

    def busy_at(self, scan: int) -> bool:
        """Whether it was Busy after a scan."""
        index = self.index_at(scan)
        return index >= 0 and self.busy[index]

    def edge_before(self, scan: int) -> int:
        """The index of the last call with an edge in a scan or before it, since a restart; -1 where there is none."""
        index = self.index_at(scan)
        while index >= 0 and not self.edges[index]:
            if self.fresh[index]:
                return -1
            index -= 1
        return index

    def begin_before(self, scan: int) -> int:
        """The index of the edge since which it has been Busy, up to a scan; -1 where there is none."""
        index = self.edge_before(scan)
        while index > 0 and self.busy[index - 1] and not self.fresh[index]:
            earlier = self.edge_before(self.scans[index - 1])
            if earlier < 0:
                break
            index = earlier
        return index

    def edge_after(self, index: int) -> int:
        """The index of the next call with an edge or after a restart; the number of calls where there is none."""
        following = index + 1
        while following < len(self.scans) and not (self.edges[following] or self.fresh[following]):
            following += 1
        return following

    def rises(self, index: int, end: str) -> bool:
        """Whether an ending output becomes TRUE in a call, or anew after an edge."""
        if end not in self.ends[index]:
            return False
        return index == 0 or self.fresh[index] or end not in self.ends[index - 1] or self.edges[index]

    def falls_busy(self, index: int) -> bool:
        """Whether Busy becomes FALSE in a call."""
        return index > 0 and not self.fresh[index] and self.busy[index - 1] and not self.busy[index]


class History:
    """The scans of one run, with the blocks by name and kind.

    `value_of` gives the value that a block asks the device for with some inputs, `speed_of` how fast, and `position_of`
    the position that it shows, all in counts, or None. `may_move` has the numbers of ErrorID that say that the device
    may be moving, and `patience` is how many milliseconds the exchanges of a few blocks take.
    """

    def __init__(
        self,
        scans: Sequence[Scan],
        kinds: Mapping[str, str],
        value_of: Callable[[str, Mapping[tuple[str, str], float]], float | None] = lambda block, inputs: None,
        position_of: Callable[[str, Mapping[tuple[str, str], float]], float | None] = lambda block, outputs: None,
        may_move: Iterable[int] = (2, 3, 4, 5, 7),
        patience: int = 5000,
        speed_of: Callable[[str, Mapping[tuple[str, str], float]], float | None] = lambda block, inputs: None,
    ) -> None:
        self.scans, self.kinds, self.patience, self.speed_of = scans, kinds, patience, speed_of
        self.value_of, self.position_of, self.may_move = value_of, position_of, frozenset(may_move)

    @cached_property
    def blocks(self) -> dict[str, Calls]:
        """Each block call by call."""
        return {name: self._calls(name, kind) for name, kind in self.kinds.items()}

    def of_kind(self, *kinds: str) -> list[Calls]:
        """The blocks of some kinds."""
        return [block for block in self.blocks.values() if block.kind in kinds]

    @cached_property
    def times(self) -> list[int]:
        """The time at the end of each scan, in milliseconds."""
        total, result = 0, []
        for scan in self.scans:
            total += scan.milliseconds
            result.append(total)
        return result

    @cached_property
    def clear_until(self) -> list[int]:
        """For each scan, the first scan at or after it in which something was disturbed."""
        result, following = [0] * len(self.scans), len(self.scans)
        for index in range(len(self.scans) - 1, -1, -1):
            scan = self.scans[index]
            if not scan.clear or scan.disturbed:
                following = index
            result[index] = following
        return result

    @cached_property
    def events(self) -> list[tuple[int, Event]]:
        """All events of the device with their scans."""
        return [(number, event) for number, scan in enumerate(self.scans) for event in scan.events]

    @cached_property
    def requests(self) -> list[tuple[int, str]]:
        """All that was asked on the wire with its scan."""
        return [(number, asked) for number, scan in enumerate(self.scans) for asked in scan.asked]

    @cached_property
    def restarts(self) -> list[int]:
        """The scans before which the controller was switched on."""
        return [number for number, scan in enumerate(self.scans) if "restart" in scan.disturbed]

    def after(self, scan: int, times: int = 1) -> int:
        """The scan by which a few exchanges are over on a sound line; the number of scans where the record ends before.

        Where scans are slow, what counts is how many of them an exchange takes.
        """
        wanted = self.times[scan] + times * self.patience
        index = scan + times * SLOW
        while index < len(self.scans) and self.times[index] < wanted:
            index += 1
        return min(index, len(self.scans))

    @cached_property
    def owners(self) -> list[tuple[int, Event, str]]:
        """The commands that the device has accepted or refused, each with the block that has sent it.

        Of two instances it is the one whose edge has not had its command yet; then the one with that value.
        """
        result: list[tuple[int, Event, str]] = []
        used: dict[str, int] = {}
        for scan, event in self.events:
            if event.kind not in ("accepted", "refused"):
                continue
            edges = {
                calls.name: calls.edge_before(scan)
                for calls in self.of_kind(*MOTIONS)
                if starts(calls.kind, event.about)
            }
            if not edges:
                continue

            def preference(name: str, edges: dict[str, int] = edges, scan: int = scan, event: Event = event) -> Any:
                index, calls = edges[name], self.blocks[name]
                wanted = self.value_of(name, self.scans[calls.scans[index]].inputs) if index >= 0 else None
                return (
                    index > used.get(name, -1),
                    wanted is not None and abs(wanted - event.value) <= 0.5,
                    calls.busy_at(scan),
                    calls.scans[index] if index >= 0 else -1,
                )

            owner = max(edges, key=preference)
            used[owner] = max(used.get(owner, -1), edges[owner])
            result.append((scan, event, owner))
        return result

    def accepted(self, calls: Calls, first: int, last: int) -> list[tuple[int, Event]]:
        """The commands of a block that the device has accepted between two scans, both included.

        A move that is refused where the axis stands at its target is one of them: it is done.
        """
        return [
            (scan, event)
            for scan, event, owner in self.owners
            if first <= scan <= last
            and owner == calls.name
            and (event.kind == "accepted" or self.is_refused_in_place(scan, event))
        ]

    def is_refused_in_place(self, scan: int, event: Event) -> bool:
        """Whether the device refuses a move to where the axis stands. A block may see only that it stands there."""
        state = self.scans[scan].state
        stands = not state.number and not state.velocity and abs(state.position - event.value) <= 0.5
        return event.kind == "refused" and event.about == "absolute" and stands

    def stop_follows(self, first: int, most: int) -> bool | None:
        """Whether a stop is among the next requests from a scan on; None where the record ends too early to say.

        Where nothing at all is sent for as long as a few exchanges take, no stop follows.
        """
        place = bisect_left(self.requests, (first, ""))
        following = [text for _, text in self.requests[place : place + most]]
        if any(text in STOPPING for text in following):
            return True
        return False if len(following) == most or self.after(first) < len(self.scans) else None

    def is_on(self, number: int, scan: int) -> bool:
        """Whether a motion is carried out, or about to be, after a scan."""
        state = self.scans[scan].state
        return bool(number) and number in (state.number, state.waiting)

    def asked_between(self, first: int, last: int) -> list[str]:
        """What was asked in some scans, both included."""
        return [asked for scan in self.scans[max(first, 0) : last + 1] for asked in scan.asked]

    def _calls(self, name: str, kind: str) -> Calls:
        calls = Calls(name, kind)
        keys = [(name, text) for text in STARTS if self.scans and (name, text) in self.scans[0].inputs]
        abort, busy, active, error = ((name, text) for text in ("Abort", "Busy", "Active", "ErrorID"))
        ends = [(end, (name, end)) for end in ENDS]
        before: tuple[bool, ...] | None = None
        restarted, ready = True, False
        for number, scan in enumerate(self.scans):
            restarted = restarted or "restart" in scan.disturbed
            if scan.called is not None and name not in scan.called:
                continue
            levels = tuple([bool(scan.inputs[key]) for key in keys])
            outputs = scan.outputs
            if restarted:
                before = None
            calls.scans.append(number)
            calls.execute.append(True in levels)
            # A jog needs both inputs FALSE first, after a restart and after it has failed.
            failed = bool(calls.ends) and calls.ends[-1] in ("Error", "CommandAborted")
            free = before is not None and (True not in before or (ready and not failed))
            ready = len(keys) < 2 or free
            calls.edges.append(before not in (None, levels) and ready and _rising(before, levels))
            calls.fresh.append(restarted)
            calls.abort.append(bool(scan.inputs.get(abort)))
            calls.busy.append(bool(outputs.get(busy)))
            calls.ends.append("".join([end for end, key in ends if outputs.get(key)]))
            calls.active.append(bool(outputs.get(active)))
            calls.error.append(int(outputs.get(error, 0)))
            calls.directions.append(levels)
            before, restarted = levels, False
        return calls


def _rising(before: tuple[bool, ...], now: tuple[bool, ...]) -> bool:
    """Whether a block has something to begin: an input rises, or one of two directions alone remains.

    Both directions at once are none.
    """
    if len(now) == 2 and all(now):
        return False
    if len(now) == 2 and before == (True, True):
        return sum(now) == 1
    return any(new and not old for old, new in zip(before, now, strict=True))


def starts(kind: str, about: str) -> bool:
    """Whether a block of a kind may have asked for a motion."""
    return kind == about or (kind == "jog" and about in JOGS) or (kind in JOGS and about == "jog")
