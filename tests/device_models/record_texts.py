"""Records of scans written by hand, a line each, for the tests of the monitors.

A line has what changes in a scan; all else stays as it was:

    +Move.Execute -Move.Busy     an input or an output rises, falls
    Move.ErrorID=8 Read.PositionRaw=500   a number
    ask:start_absolute           a request on the wire
    accepted:absolute:1:500:90   an event of the device, with the number of the motion, a value and a speed
    n1 w2 v100 p500              the motion that is carried out, that waits, velocity, position
    on off home lost-home alarm well
    restart   power-cycle   skip:Move   invalid:Move   word:043F   good   lost   ms:50   x200
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from device_models.axis import Event, State
from device_models.history import STARTS, History, Scan

FLAGS: dict[str, dict[str, Any]] = {
    "on": {"servo": True},
    "off": {"servo": False},
    "home": {"homed": True},
    "lost-home": {"homed": False},
    "alarm": {"alarm": True},
    "well": {"alarm": False},
}
NUMBERS = {"n": ("number", int), "w": ("waiting", int), "v": ("velocity", float), "p": ("position", float)}
EVENTS = ("accepted", "refused", "began", "reached", "interrupted", "stop", "stop-ended", "alarm", "cause-gone")


class Record:
    """A record in the making."""

    def __init__(self, kinds: Mapping[str, str]) -> None:
        self.kinds = kinds
        self.inputs: dict[tuple[str, str], float] = {}
        for name, kind in kinds.items():
            starts = ("JogForward", "JogBackward") if kind == "jog" else ("Enable" if kind == "read" else "Execute",)
            self.inputs |= {(name, start): False for start in (*starts, "Abort")}
        self.outputs: dict[tuple[str, str], float] = {}
        self.state = State()
        self.scans: list[Scan] = []
        self.word: int | None = None
        self.milliseconds = 10

    def line(self, text: str) -> None:
        """Adds the scans of a line."""
        scan, times = Scan(), 1
        skipped: set[str] = set()
        for item in text.split():
            head, _, rest = item.partition(":")
            if item[0] in "+-":
                self._set(item[1:], item[0] == "+")
            elif "=" in item:
                name, _, value = item.partition("=")
                self._set(name, float(value))
            elif head in EVENTS and rest:
                scan.events = (*scan.events, self._event(item))
            elif head == "ask":
                scan.asked = (*scan.asked, rest.replace("_", " "))
            elif item in FLAGS:
                self.state = replace(self.state, **FLAGS[item])
            elif item[0] in NUMBERS and item[1:].lstrip("-").isdigit():
                name, kind = NUMBERS[item[0]]
                self.state = replace(self.state, **{name: kind(item[1:])})
            elif item[0] == "x":
                times = int(item[1:])
            else:
                skipped |= self._other(head, rest, scan)
        scan.inputs, scan.outputs, scan.state = dict(self.inputs), dict(self.outputs), self.state
        scan.word, scan.milliseconds = self.word, self.milliseconds
        scan.called = frozenset(set(self.kinds) - skipped)
        self.scans.append(scan)
        quiet = replace(scan, events=(), asked=(), disturbed=())
        self.scans += [quiet] * (times - 1)

    def _set(self, name: str, value: float) -> None:
        block, _, variable = name.partition(".")
        values = self.inputs if (block, variable) in self.inputs or variable in STARTS else self.outputs
        if variable[0].islower() and not variable.endswith("Raw"):
            values = self.inputs
        values[block, variable] = value

    @staticmethod
    def _event(item: str) -> Event:
        kind, about, *numbers = item.split(":")
        number, value, speed = (*numbers, "0", "0", "0")[:3]
        return Event(kind.replace("-", " "), about, int(number), float(value), float(speed))

    def _other(self, head: str, rest: str, scan: Scan) -> set[str]:
        if head == "skip":
            return {rest}
        if head in ("restart", "power-cycle"):
            scan.disturbed = (head.replace("-", " "),)
        elif head == "invalid":
            scan.invalid = frozenset({rest})
        elif head == "word":
            self.word = int(rest, 16)
        elif head == "ms":
            self.milliseconds = int(rest)
        elif head == "good":
            scan.fates = ("good",)
        else:
            assert head == "lost", head
            scan.clear, scan.fates = False, ("lost answer",)
        return set()


def record_of(kinds: Mapping[str, str], lines: Sequence[str]) -> History:
    """The record that some lines describe. The value and the speed of a block are its inputs so named."""
    record = Record(kinds)
    for text in lines:
        record.line(text)
    return History(
        record.scans,
        kinds,
        lambda block, inputs: inputs.get((block, "value")),
        lambda block, outputs: outputs.get((block, "PositionRaw")),
        speed_of=lambda block, inputs: inputs.get((block, "speed")),
    )
