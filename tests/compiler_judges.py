"""Counts which mutants of the compiler are noticed: `make mutants-compiler`, or this file with EACH, SEED and folders.

Each mutant is judged in a copy of the package, by the commands that `CONTRIBUTING.md` names for its module, in their
order, until one fails; the tests that failed are then run without the mutant, and pass. A mutant that no judge notices
survives. The exit code is 1 where fewer than 85 of 100 are noticed, where no command is named for a module, and where
what failed fails without the mutant too.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from queue import SimpleQueue

from compiler_mutants import Mutant, changeable, sample

TESTS = Path(__file__).resolve().parent
ROOT = TESTS.parent
PACKAGE = ROOT / "codegen" / "fieldspec"
GUIDE = ROOT / "CONTRIBUTING.md"
PROCESSES = 1
EACH = 12
GOAL = 85
PROCESSOR_SECONDS = 300
"""The time that a process of a judge may compute; a mutant that takes more is noticed."""
PATIENCE = 1200
"""Seconds after which a judge counts as hanging, on a busy machine too."""

RECORDED = "python tests/recorded_outputs.py "
PYTEST = "pytest "


class Unfit(Exception):
    """A command that fails without a mutant too, and so would notice every mutant."""


@cache
def rows(text: str) -> tuple[tuple[tuple[str, ...], tuple[str, ...]], ...]:
    """The rows of the table of tests: the folders, which end with a slash, and modules; and the commands for them."""
    table = re.search(r"^\| you change \| run \|.*\n\|---.*\n((?:\|.*\n)+)", text, re.M)
    assert table is not None
    result = []
    for line in table[1].splitlines():
        places, commands = (re.findall(r"`([^`]+)`", cell) for cell in line.split(" | ")[:2])
        paths = (place.removeprefix("codegen/fieldspec/") for place in places)
        result.append((tuple(paths), tuple(word for word in commands if word.startswith((RECORDED, PYTEST)))))
    return tuple(result)


def commands(path: str, text: str | None = None) -> list[str]:
    """The commands for a module: those of the row that names it, or of the one that names the nearest folder above."""
    named: dict[str, list[str]] = {}
    for places, judges in rows(GUIDE.read_text("utf-8") if text is None else text):
        for place in places:
            if path == place or (place.endswith("/") and path.startswith(place)):
                named.setdefault(place, []).extend(judges)
    return named[max(named, key=len)] if named else []


def folders(package: Path = PACKAGE) -> list[str]:
    """All folders of the compiler with code that can be changed; `.` is the package itself."""
    names = sorted({path.relative_to(package).parent.as_posix() for path in package.rglob("*.py")})
    return [name for name in names if changeable(package, name)]


@dataclass(frozen=True)
class Verdict:
    """The judge that notices a mutant, or none."""

    folder: str
    mutant: Mutant
    judge: str


class Copy:
    """A copy of the compiler in a folder of its own, in which one file at a time is changed."""

    def __init__(self, folder: Path) -> None:
        self.package = folder / "codegen" / PACKAGE.name
        shutil.copytree(PACKAGE, self.package)
        # The shared protocols stand beside the compiler.
        shutil.copytree(ROOT / "specs", folder / "specs")
        paths = os.pathsep.join((str(self.package.parent), str(TESTS)))
        # No module of a mutant stays compiled, and what it has computed is not found by the next one.
        self.environment = {**os.environ, "PYTHONPATH": paths, "PYTHONDONTWRITEBYTECODE": "1", "CI": ""}

    def judge(self, folder: str, mutant: Mutant) -> Verdict:
        """Asks the judges of the module of a mutant. Raises `Unfit` where one refuses the right compiler too."""
        path = self.package / mutant.path
        source, times = path.read_bytes(), path.stat()
        with tempfile.TemporaryDirectory(prefix="fieldspec-failures-") as memory:
            path.write_bytes(mutant.applied(source))
            os.utime(path, (times.st_atime, times.st_mtime + 1000))
            try:
                judge = next((name for name in commands(mutant.path) if self.fails(name, memory)), "")
            finally:
                path.write_bytes(source)
                os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))
            if judge and self.fails(judge, memory):
                raise Unfit(f"fails without a mutant too: {judge}")
        return Verdict(folder, mutant, judge)

    def fails(self, command: str, memory: str) -> bool:
        """Whether a command fails, or takes too long: of its tests those that failed last, which a folder remembers."""
        with tempfile.TemporaryDirectory(prefix="fieldspec-mutant-") as cache:
            environment = {**self.environment, "FIELDSPEC_CACHE": cache}
            run = subprocess.Popen(
                ["sh", "-c", f'ulimit -t {PROCESSOR_SECONDS} && exec "$@"', "sh", *call(command, memory)],
                cwd=ROOT,
                env=environment,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                start_new_session=True,
            )
            try:
                return run.wait(PATIENCE) != 0
            except subprocess.TimeoutExpired:
                os.killpg(run.pid, 9)
                run.wait()
                return True


def call(command: str, memory: str) -> list[str]:
    """A command of the table as a call that fails where it notices a mutant, and ends with the first failing test.

    Tests that failed before by the memory of a folder are run alone.
    """
    program, *words = command.split()
    if program == "python":
        return [sys.executable, *words]
    matches = [[path.relative_to(ROOT).as_posix() for path in sorted(ROOT.glob(word))] for word in words]
    assert all(matches), f"CONTRIBUTING.md names tests that are not there: {command}"
    tests = [path for paths in matches for path in paths]
    return [sys.executable, "-m", "pytest", "-q", "-x", "-n", "0", "--lf", "-o", f"cache_dir={memory}", *tests]


def verdicts(drawn: list[tuple[str, Mutant]], processes: int = PROCESSES) -> Iterator[Verdict]:
    """The verdicts about mutants, in order."""
    with tempfile.TemporaryDirectory(prefix="fieldspec-mutants-") as place, ThreadPoolExecutor(processes) as pool:
        copies: SimpleQueue[Copy] = SimpleQueue()
        for number in range(processes):
            copies.put(Copy(Path(place) / str(number)))

        def judged(item: tuple[str, Mutant]) -> Verdict:
            copy = copies.get()
            try:
                return copy.judge(*item)
            finally:
                copies.put(copy)

        yield from pool.map(judged, drawn)


def table(results: list[Verdict]) -> Iterator[str]:
    """The share of mutants that are noticed, as rows of Markdown, by folder."""
    yield "| folder | mutants | noticed | by recorded outputs | by tests |"
    yield "|---|---|---|---|---|"
    for folder in [*dict.fromkeys(verdict.folder for verdict in results), "all"]:
        own = [verdict for verdict in results if folder in ("all", verdict.folder)]
        noticed, outputs = sum(bool(v.judge) for v in own), sum(v.judge.startswith(RECORDED) for v in own)
        share = f"{noticed} ({100 * noticed / len(own):.0f} %)"
        yield f"| {folder} | {len(own)} | {share} | {outputs} | {noticed - outputs} |"


def chosen(names: list[str]) -> list[str]:
    """The folders with these names and those inside them; all folders without a name."""
    return [folder for folder in folders() if not names or any(f"{folder}/".startswith(f"{name}/") for name in names)]


def main(each: int = EACH, seed: int = 1, *, names: list[str]) -> int:
    """Prints each mutant that nobody notices, then the table. Returns the exit code."""
    drawn = [(folder, mutant) for folder in chosen(names) for mutant in sample(PACKAGE, folder, each, seed)]
    unjudged = sorted({mutant.path for _, mutant in drawn if not commands(mutant.path)})
    if unjudged or not drawn:
        print(f"{GUIDE.name} names no tests for: {', '.join(unjudged or names)}")
        return 1
    results = []
    try:
        for verdict in verdicts(drawn):
            results.append(verdict)
            if not verdict.judge:
                print(f"survives: {verdict.mutant}", flush=True)
    except Unfit as error:
        print(error)
        return 1
    print("\n".join(table(results)))
    return int(100 * sum(bool(verdict.judge) for verdict in results) < GOAL * len(results))


if __name__ == "__main__":
    sys.exit(main(*(int(word) for word in sys.argv[1:3]), names=sys.argv[3:]))
