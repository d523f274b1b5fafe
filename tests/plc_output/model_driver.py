"""Drives the blocks of a device at random against its model, in episodes that a seed tells apart.

    python tests/plc_output/model_driver.py tc100 50           the rules that 50 episodes break, with an example of each
    python tests/plc_output/model_driver.py tc100 50 30        only those that break rule 30
    python tests/plc_output/model_driver.py tc100 seed 17      all violations of an episode, and what led to the first
    python tests/plc_output/model_driver.py tc100 seed 17 30   the same for the first that breaks rule 30

The device is one of NAMES in model_rigs.py: "hiwin-e 111" has its telegram after it. An episode is the same whenever
it is run with the same blocks.
"""

from __future__ import annotations

import random
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parent.parent))

from model_rigs import FrameRig, rig
from model_values import fitting, invalid

from device_models.draws import Draws
from device_models.history import ENDS, JOG_INPUTS, STARTS, STOPS, History, Scan, Violation
from device_models.monitors import violations

SCANS = 1500
"""Scans of an episode."""
CYCLES = (1, 5, 5, 10, 10, 10, 50, 50, 50, 200, 200)
"""Milliseconds from one scan to the next; one of them in each episode, with some that are longer."""
ALARMS = (1, 3, 9)
WEIGHTS = {"stop": 0.7, "quick_stop": 0.4, "power_off": 0.3, "power_on": 0.4, "reset": 0.4, "read": 0.4, "home": 0.5}
"""How often blocks are touched, by their kinds; the others are 1."""


class Driver:
    """One episode: what is set, disturbed and called in each scan."""

    def __init__(self, name: str, seed: int, folder: Path) -> None:
        self.dice = random.Random(f"{name} {seed}")
        dice = self.dice
        draws = Draws(f"{name} {seed}", refusal=dice.choice([0.0, 0.0, 0.05]))
        self.rig: Any = rig(name, folder, draws, twice=dice.random() < 0.3)
        self.cycle = dice.choice(CYCLES)
        self.rate = dice.choice([0.3, 1.0, 3.0])
        self.faults = dice.choice([0.0, 0.0, 0.02, 0.1])
        self.rough = dice.random() < 0.5
        self.shuffled = dice.random() < 0.5
        self.patient = dice.random() < 0.3
        self.first = dice.random() < 0.2
        self.gaps: dict[str, int] = {}
        self.order = list(self.rig.names)
        self.blind = 0
        self.starts = {
            block: [name for name in STARTS if (block, name) in self.rig.bench.inputs] for block in self.rig.names
        }
        self.driven = [block for block, names in self.starts.items() if names]

    def run(self, scans: int = SCANS) -> History:
        """Runs the episode."""
        if self.first:
            self._begin_with_inputs()
        if self.dice.random() < 0.8:
            self._switch_on()
        if isinstance(self.rig, FrameRig):
            self.rig.line.chance = self.faults
        while len(self.rig.record) < scans:
            self._scan()
        return self.rig.history  # type: ignore[no-any-return]

    def _begin_with_inputs(self) -> None:
        """Some inputs are TRUE in the first scan, and FALSE after a while."""
        chosen = self.dice.sample(self.driven, self.dice.randint(1, len(self.driven)))
        for level in (True, False):
            for block in chosen:
                self.rig.set(block, **dict.fromkeys(self.starts[block], level))
            self.rig.run(20 if level else 2, self.cycle)

    def _switch_on(self) -> None:
        """Mostly the servo is on and the axis at home, with nothing disturbed."""
        self.rig.run(2, self.cycle)
        for kind in ("power_on", "home"):
            if kind in self.rig.kinds.values():
                self.rig.finish(self.rig.block(kind), max(self.cycle, 20), limit=6.0)

    def _scan(self) -> None:
        seconds = self.cycle / 1000
        for _ in range(3):
            if self.dice.random() < max(0.004, min(0.3, seconds * self.rate)):
                self._touch(self._chosen())
        if self.rough and self.dice.random() < max(0.0005, min(0.02, seconds * 0.1)):
            self._disturb()
        self._line(seconds)
        if self.shuffled and self.dice.random() < 0.05:
            self.dice.shuffle(self.order)
        self.gaps = {block: left - 1 for block, left in self.gaps.items() if left > 1}
        called = [block for block in self.order if block not in self.gaps]
        jitter = self.dice.random() < 0.01
        self.rig.scan(self.cycle * (3 if jitter else 1), called)

    def _chosen(self) -> str:
        """A block to touch: mostly one that moves the axis, or what it needs to move.

        A stop that is asked for is mostly withdrawn soon; a patient driver holds it.
        """
        state = self.rig.model.state
        lacks = {"power_on": not state.servo, "reset": state.alarm, "home": state.servo and not state.homed}
        weights = []
        for block in self.driven:
            kind = self.rig.kinds[block]
            pressed = any(self.rig.bench.now[block, name] for name in self.starts[block])
            hinders = pressed and kind in (*STOPS, "power_off") and not self.patient
            weights.append(WEIGHTS.get(kind, 1.0) * (8.0 if lacks.get(kind) or hinders else 1.0))
        return self.dice.choices(self.driven, weights)[0]

    def _touch(self, block: str) -> None:
        """Changes an input of a block: an edge, a level, a value, Abort."""
        dice, chance = self.dice, self.dice.random()
        names = self.starts[block]
        if chance < 0.7:
            self._press(block, names)
        elif chance < 0.76 and (block, "Abort") in self.rig.bench.inputs:
            self.rig.set(block, Abort=True)
            if dice.random() < 0.9:
                self._single_scan()
                self.rig.set(block, Abort=False)
        else:
            self._revalue(block, dice.random() < 0.15)

    def _single_scan(self) -> None:
        self.rig.scan(self.cycle, [entry for entry in self.order if entry not in self.gaps])

    def _press(self, block: str, names: Sequence[str]) -> None:
        dice = self.dice
        if set(names) <= set(JOG_INPUTS) and dice.random() < 0.1:
            level = dice.random() < 0.5
            self.rig.set(block, **dict.fromkeys(names, level))
            return
        name = dice.choice(names)
        level = not self.rig.bench.now[block, name]
        if level and dice.random() < 0.4:
            self._revalue(block, dice.random() < 0.1)
        self.rig.set(block, **{name: level})
        # A pulse is what most programs give.
        if level and dice.random() < 0.3:
            self._single_scan()
            self.rig.set(block, **{name: False})

    def _revalue(self, block: str, wrong: bool) -> None:
        """Draws the values of a block anew; with a wrong one it is noted until they are drawn again."""
        rig, kind = self.rig, self.rig.kinds[block]
        rig.invalid.discard(block)
        changed = {}
        for (owner, name), of in rig.bench.inputs.items():
            if owner != block:
                continue
            value = fitting(rig.name, kind, name, of, self.dice)
            bad = invalid(rig.name, kind, name, of, self.dice) if wrong and kind != "read" else None
            if bad is not None and value is not None:
                value = bad
                rig.invalid.add(block)
            if value is not None:
                changed[name] = value
        rig.set(block, **changed)

    def _disturb(self) -> None:
        """Something happens from outside."""
        rig, dice = self.rig, self.dice
        about = dice.choice(
            ["alarm", "alarm", "no alarm", "no alarm", "pendant stop", "pendant move", "power cycle", "restart", "gap"]
        )
        if about == "alarm":
            rig.model.set_alarm(dice.choice(ALARMS))
            if dice.random() < 0.7:
                rig.model.set_alarm(0)
        elif about == "no alarm":
            rig.model.set_alarm(0)
        elif about == "pendant stop":
            rig.model.stop_outside()
        elif about == "pendant move":
            rig.model.move_outside()
        elif about == "power cycle":
            rig.model.power_cycle()
        elif about == "restart":
            rig.restart()
            self.gaps.clear()
        else:
            blocks = self.order if dice.random() < 0.5 else dice.sample(self.order, dice.randint(1, len(self.order)))
            self.gaps = dict.fromkeys(blocks, dice.randint(1, 30))
        if about not in ("restart", "gap"):
            rig.disturb(about)
        rig.clear = not self.gaps

    def _line(self, seconds: float) -> None:
        """Lets the line be silent for a while, or telegrams be invalid for some cycles."""
        rig, dice = self.rig, self.dice
        if self.blind:
            self.blind -= 1
        elif self.faults and dice.random() < self.faults / 20:
            self.blind = dice.choice([1, 1, 2, 5, 40])
            unheard = dice.random() < 0.5
            if isinstance(rig, FrameRig):
                rig.line.silent = True
            else:
                rig.lost, rig.unheard = True, unheard
        if not self.blind:
            if isinstance(rig, FrameRig):
                rig.line.silent = False
            else:
                rig.lost = rig.unheard = False
        rig.clear = not self.blind and not self.gaps


def episode(name: str, seed: int, folder: Path, scans: int = SCANS) -> History:
    """What was recorded in an episode."""
    return Driver(name, seed, folder).run(scans)


def scan_texts(history: History, violation: Violation, before: int = 60, after: int = 5) -> list[str]:
    """What changed scan by scan before a violation."""
    result: list[str] = []
    texts: dict[str, str] = {}
    first, last = max(0, violation.scan - before), min(len(history.scans), violation.scan + after)
    for number in range(first, last):
        scan, state = history.scans[number], history.scans[number].state
        now = {name: _block_text(scan, name) for name in history.kinds}
        changes = [f"{name}({text})" for name, text in now.items() if text != texts.get(name, "")]
        events = [f"{event.kind} {event.about} {event.value:g} #{event.number}" for event in scan.events]
        happened = [*scan.disturbed, *scan.asked, *(fate for fate in scan.fates if fate != "good"), *events]
        flags = [word for word, on in (("on", state.servo), ("home", state.homed), ("ALARM", state.alarm)) if on]
        axis = f"{' '.join(flags)} moves {state.number} waits {state.waiting}"
        if changes or happened or axis != texts.get(""):
            word = "" if scan.word is None else f" {scan.word:04X}H"
            place = f"at {state.position:.0f} by {state.velocity:.0f}"
            result.append(f"{number:5} {' '.join(changes)} | {axis} {place}{word} {happened or ''}")
        texts = {**now, "": axis}
    return result


def _block_text(scan: Scan, block: str) -> str:
    """The inputs and outputs of a block that are TRUE, and its ErrorID."""
    inputs = [name for (owner, name), value in scan.inputs.items() if owner == block and value is True]
    outputs = [name for name in ("Busy", *ENDS, "Valid") if scan.outputs.get((block, name))]
    number = scan.outputs.get((block, "ErrorID"), 0)
    called = "" if scan.called is None or block in scan.called else " not called"
    return f"{' '.join(inputs)}>{' '.join(outputs)}{number or ''}{called}"


def main(arguments: Sequence[str]) -> None:
    """Prints what episodes break."""
    name, *rest = arguments
    folder = Path(tempfile.gettempdir()) / "fieldspec-models"
    folder.mkdir(exist_ok=True)
    if rest and rest[0] == "seed":
        history = episode(name, int(rest[1]), folder)
        broken = violations(history)
        wanted = [item for item in broken if len(rest) < 3 or item.rule == int(rest[2])]
        print(*broken, sep="\n")
        if wanted:
            print(*scan_texts(history, wanted[0]), sep="\n")
        return
    counts: dict[tuple[int, str], tuple[int, str]] = {}
    for seed in range(int(rest[0]) if rest else 20):
        for item in violations(episode(name, seed, folder)):
            if len(rest) > 1 and item.rule != int(rest[1]):
                continue
            number, example = counts.get((item.rule, item.block), (0, f"seed {seed}: {item}"))
            counts[item.rule, item.block] = (number + 1, example)
    for _, (number, example) in sorted(counts.items()):
        print(f"{number:6} times, {example}")


if __name__ == "__main__":
    main(sys.argv[1:])
