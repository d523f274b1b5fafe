"""Kills builds at random moments and checks what they leave after: `python tests/interruptions.py [BUILDS] [SEED]`."""

from __future__ import annotations

import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

from bounded import wait_until

SPECS = Path(__file__).resolve().parent.parent / "specs"
OUTPUTS = "c,vectors"


class Place:
    """Specs in two states and the outputs of both; builds switch from one to the other.

    The specs are those of all devices but some, which the suite spares itself.
    """

    def __init__(self, folder: Path, without: tuple[str, ...] = ()) -> None:
        self.folder, self.out = folder, folder / "out"
        self.states: list[dict[str, bytes]] = []
        for number in range(2):
            specs = self.specs(number)
            shutil.copytree(SPECS, specs, ignore=shutil.ignore_patterns(*without))
            if number:
                shutil.rmtree(specs / "esc11")
                for path in specs.glob("*/device.yaml"):
                    path.write_text(path.read_text("utf-8").replace("name: ", "name: New ", 1), encoding="utf-8")
            assert self.build(number).wait() == 0
            self.states.append(self.files())

    def specs(self, number: int) -> Path:
        return self.folder / f"specs{number}"

    def build(self, number: int) -> subprocess.Popen[bytes]:
        """Starts a build in its own process group."""
        words = ["build", "--no-cache", "--to", OUTPUTS, "--specs", str(self.specs(number)), "--out", str(self.out)]
        environment = {**os.environ, "FIELDSPEC_CACHE": str(self.folder / "cache")}
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        command = [sys.executable, "-m", "fieldspec", *words]
        return subprocess.Popen(command, env=environment, start_new_session=True, **quiet)  # type: ignore[call-overload,no-any-return]

    def files(self) -> dict[str, bytes]:
        """The current outputs: contents by path."""
        return {
            path.relative_to(self.out).as_posix(): path.read_bytes()
            for path in self.out.rglob("*")
            if path.is_file() and not path.relative_to(self.out).parts[0].startswith(".fieldspec-")
        }

    def left_over(self) -> list[str]:
        return [path.name for path in self.out.glob(".fieldspec-*")]


def alive(group: int) -> bool:
    """Whether a process of a process group is running."""
    try:
        os.killpg(group, 0)
    except ProcessLookupError:
        return False
    return True


def kill(place: Place, number: int, after: float) -> str:
    """Kills one build after some seconds and returns the state of its outputs. Raises AssertionError."""
    building = place.build(number)
    try:
        building.wait(after)
    except subprocess.TimeoutExpired:
        building.send_signal(signal.SIGKILL)
        building.wait()
    wait_until(lambda: not alive(building.pid))  # a worker that outlives its parent hangs
    before = place.files()
    state = "whole" if before in place.states else "mixed"
    if place.left_over():
        state += ", left over"
    next_build = place.build(number)
    assert next_build.wait() == 0, "the next build fails"
    assert place.files() == place.states[number], "the next build does not repair"
    assert place.left_over() == [], "something is left"
    return state


def soak(builds: int, seed: int, without: tuple[str, ...] = ()) -> Counter[str]:
    """Kills so many builds and counts the states in which they leave the outputs."""
    chance = random.Random(seed)
    counts: Counter[str] = Counter()
    with tempfile.TemporaryDirectory() as folder:
        place = Place(Path(folder), without)
        start = time.monotonic()
        assert place.build(0).wait() == 0
        whole = time.monotonic() - start
        for turn in range(builds):
            counts[kill(place, 1 - turn % 2, chance.uniform(0, whole * 1.05))] += 1
    return counts


if __name__ == "__main__":
    number, seed = (int(word) for word in (sys.argv[1:] + ["50", "1"][len(sys.argv) - 1 :]))
    for what, times in sorted(soak(number, seed).items()):
        print(f"{times} of {number} killed builds left outputs: {what}")
    print("each was repaired by the next build; no process outlived its parent")
