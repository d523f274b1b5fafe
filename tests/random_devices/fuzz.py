"""Compares all codecs on random devices for some time: `make fuzz-specs SECONDS=600`, or this file, seconds and a seed.

`--judges framers,python` asks only these, about every device.
`--statistics 2000` counts instead how many of so many devices have each key of the language, its forms, and its pairs.
Every processor draws devices of its own. A device on which judges disagree is shrunk and written to `cases/`, which the
tests run from then on.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import sys
import time
from collections import Counter
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from dataclasses import dataclass, field, replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from hypothesis import Phase, given
from hypothesis import seed as seeded
from hypothesis import strategies as st
from hypothesis.errors import Flaky

from random_devices.agreement import JUDGES, Comparison, Judge, compare
from random_devices.devices import devices, text_of
from random_devices.draft import Spec
from random_devices.key_counts import statistics
from steady_draws import steady

CASES = Path(__file__).parent / "cases"
FRAMES = 100
BATCH = 20
"""Devices that are drawn from one seed."""
PATIENCE = 90
"""Seconds in which a device is shrunk."""
_SECONDS_A_LINE = 60


@dataclass
class Tally:
    """The totals of some devices. `cases` has the text of each shrunk device, by its first disagreement."""

    devices: int = 0
    clean: int = 0
    frames: int = 0
    codes: Counter[str] = field(default_factory=Counter)
    asked: Counter[str] = field(default_factory=Counter)
    cases: dict[str, str] = field(default_factory=dict)

    def add(self, other: Tally) -> None:
        """Adds the totals of others."""
        self.devices += other.devices
        self.clean += other.clean
        self.frames += other.frames
        self.codes += other.codes
        self.asked += other.asked
        self.cases |= other.cases

    def report(self) -> str:
        """The totals in words."""
        lines = [
            f"{self.devices} devices, {self.clean} of them without findings, {self.frames} frames",
            "asked: " + ", ".join(f"{name} {count}" for name, count in sorted(self.asked.items())),
            "findings: " + ", ".join(f"{code} {count}" for code, count in self.codes.most_common(8)),
            f"{len(self.cases)} devices on which judges disagree",
        ]
        return "\n".join([*lines, *(f"  {text}" for text in self.cases)])


@dataclass
class Shrinking:
    """The shortest device so far on which judges disagree, the seed of its frames, and since when there is one."""

    disagreement: str = ""
    text: str = ""
    seed: int = 0
    start: float = 0.0

    @property
    def is_over(self) -> bool:
        """Whether a shorter device is no longer looked for."""
        return bool(self.text) and time.monotonic() > self.start + PATIENCE

    def add(self, disagreement: str, text: str, seed: int) -> None:
        """Takes a device, if it is shorter."""
        self.start = self.start or time.monotonic()
        if not self.text or len(text) < len(self.text):
            self.disagreement, self.text, self.seed = disagreement, text, seed


def batch(seed: int, count: int = BATCH, judges: tuple[Judge, ...] = JUDGES, frames: int = FRAMES) -> Tally:
    """Compares the judges on the devices of a seed. The first one on which they disagree is shrunk."""
    tally, shrinking = Tally(), Shrinking()

    def run(spec: Spec, number: int) -> None:
        if shrinking.is_over:
            return
        try:
            result = compare(spec, number, frames, judges)
        except Exception as error:
            result = Comparison(disagreements=[f"compiler: {type(error).__name__}: {error}"])
        if result.disagreements:
            shrinking.add(result.disagreements[0], text_of(spec), number)
            raise AssertionError(result.disagreements[0])
        if shrinking.text:
            return
        tally.devices += 1
        tally.clean += not result.findings
        tally.frames += result.frames
        tally.codes.update(set(result.findings))
        tally.asked.update(result.asked)

    limits = steady(count, Phase.generate, Phase.shrink)
    try:
        seeded(seed)(limits(given(devices(), st.integers(0, 9999))(run)))()
    except (AssertionError, Flaky):
        # Hypothesis raises what the device raises or, where its time is over, that it is no longer wrong.
        if not shrinking.text:
            raise
        tally.devices += 1
        tally.cases[shrinking.disagreement] = f"# seed {shrinking.seed}\n{shrinking.text}"
    return tally


def batch_of(seed: int, names: tuple[str, ...]) -> Tally:
    """Compares all judges on the devices of a seed, or only some, which are then asked about every device."""
    judges = tuple(replace(judge, every=1) for judge in JUDGES if judge.name in names)
    return batch(seed, judges=judges) if names else batch(seed)


def store(tally: Tally) -> None:
    """Writes the shrunk devices to the cases of the tests."""
    for disagreement, text in tally.cases.items():
        name = hashlib.sha256(text.encode()).hexdigest()[:8]
        first = " ".join(disagreement.split())[:110]
        (CASES / f"{name}.yaml").write_text(f"# {first}\n{text}", encoding="utf-8", newline="\n")


def main(seconds: int, seed: int, processes: int, names: tuple[str, ...] = ()) -> int:
    """Draws devices in some processes for some seconds and returns the exit code: 1 if judges disagree on one."""
    end = time.monotonic() + seconds
    total, next_line = Tally(), time.monotonic() + _SECONDS_A_LINE
    with ProcessPoolExecutor(processes) as pool:
        running: set[Future[Tally]] = set()
        while time.monotonic() < end or running:
            while time.monotonic() < end and len(running) < processes + 1:
                running.add(pool.submit(batch_of, seed, names))
                seed += 1
            done, running = wait(running, return_when=FIRST_COMPLETED)
            for future in done:
                tally = future.result()
                store(tally)
                total.add(tally)
            if time.monotonic() > next_line:
                next_line += _SECONDS_A_LINE
                text = f"{total.devices} devices, {total.frames} frames, {len(total.cases)} disagreements"
                print(text, file=sys.stderr, flush=True)
    print(total.report())
    return 1 if total.cases else 0


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("seconds", type=int, nargs="?", default=60)
    parser.add_argument("seed", type=int, nargs="?", default=int(time.time()))
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--judges", default="", metavar="NAME,...", help="ask only these, about every device")
    parser.add_argument("--statistics", type=int, metavar="DEVICES", help="count what so many devices have, and end")
    return parser.parse_args()


if __name__ == "__main__":
    arguments = _arguments()
    if arguments.statistics:
        print(statistics(arguments.statistics, arguments.seed, arguments.processes))
        sys.exit(0)
    chosen = tuple(filter(None, arguments.judges.split(",")))
    if unknown := set(chosen) - {judge.name for judge in JUDGES}:
        sys.exit(f"there is no judge {', '.join(sorted(unknown))}")
    sys.exit(main(arguments.seconds, arguments.seed, arguments.processes, chosen))
