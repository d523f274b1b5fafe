"""Counts which mutants of the compiler are noticed: `make mutants-compiler`, or this file with EACH, SEED and folders.

Each mutant is judged in a copy of the package: by the recorded outputs, which must come out as they are, then by the
tests that are nearest to its folder, until one fails. A mutant that no judge notices survives. The exit code is 1 where
fewer than 90 of 100 are noticed.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from queue import SimpleQueue

from compiler_mutants import Mutant, sample

TESTS = Path(__file__).resolve().parent
PACKAGE = TESTS.parent / "codegen" / "fieldspec"
PROCESSES = 2
EACH = 12
GOAL = 90
PATIENCE = 300
"""Seconds that a judge may take; a mutant that takes longer is noticed."""

OUTPUTS = "outputs"
CASES = "test_cases.py"
USAGES = "docs_output/test_usages.py"


@dataclass(frozen=True)
class Judges:
    """What is asked about a folder of the compiler: recorded outputs, and groups of tests, the nearest ones first.

    `{stem}` in a group is the name of the changed module.
    """

    outputs: str
    tests: tuple[str, ...] = ()


JUDGES = {
    "reading": Judges(
        "vectors python",
        (
            CASES,
            "test_reading_keys.py test_reading_overlays.py test_reading_paths.py test_reading_project.py",
            "test_reading_scalars.py test_reading_versions.py test_reading_expanding.py test_reading_yaml.py",
            "test_versions_bad_input.py test_schema.py test_checksums.py test_servo_bus.py test_editor.py",
        ),
    ),
    "checks": Judges("", (f"{CASES} -k {{stem}}", f"{CASES} test_check_helpers.py test_bits.py test_allowances.py")),
    "layout": Judges(
        "vectors python c",
        (
            "test_reference.py",
            f"test_checksums.py {CASES}",
            "test_escapes.py test_idle_reads.py test_cli_encode.py test_frame_layouts.py",
            "test_explanation.py",
        ),
    ),
    "changes": Judges(
        "docs", ("test_changes.py test_changes_attributes.py test_cli_diff.py", "test_changes_mutations.py")
    ),
    "reference": Judges(
        "vectors", ("test_reference.py test_checksums.py test_escapes.py test_bits.py", "random_devices")
    ),
    "proofs": Judges("vectors", (f"test_errata.py {CASES}", "test_allowances.py test_versions_of_devices.py")),
    "model": Judges(
        "vectors python c docs", (CASES, "test_quantities.py test_checksums.py test_servo_bus.py test_bits.py")
    ),
    "plc": Judges(
        "st twincat iec scl kv plcopen",
        (
            "test_kv_output.py test_hmi_output.py test_plc_checksums.py",
            f"{CASES} -k plc",
            "plc_output/test_standard_text.py plc_memory",
        ),
    ),
    "backends/c": Judges("c", ("c_output/test_printer.py c_output/test_ranges.py", "random_devices", "c_output")),
    "backends/docs": Judges("docs", ("docs_output/test_tables.py docs_output/test_markdown.py", "docs_output")),
    "backends/hmi": Judges("hmi", ("test_hmi_output.py",)),
    "backends/iec": Judges("iec", ("plc_output/test_standard_text.py",)),
    "backends/js": Judges("js", (USAGES, "js_output", "random_devices")),
    "backends/kv": Judges("kv", ("test_kv_output.py",)),
    "backends/plcopen": Judges("plcopen", ("plc_output/test_standard_text.py plc_output/test_judges.py",)),
    "backends/python": Judges(
        "python",
        (
            "test_python_records.py test_python_registers.py test_python_flags.py test_python_choices.py",
            "test_python_many.py test_python_conversions.py test_python_parameters.py test_python_framers.py",
            f"test_python_client_tasks.py {USAGES} device/test_client.py",
            "random_devices",
        ),
    ),
    "backends/queries": Judges("queries", ("queries_output",)),
    "backends/scl": Judges("scl", ("plc_output/test_scl_execution.py",)),
    "backends/st": Judges("st", (f"{USAGES} test_plc_kept.py", f"{CASES} -k plc", "plc_output/test_judges.py")),
    "backends/twincat": Judges("twincat", ("plc_output/test_judges.py",)),
    "backends/vectors": Judges("vectors", ("test_vectors.py test_idle_reads.py",)),
    "backends/wireshark": Judges("wireshark", ("wireshark_output",)),
}


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
        shutil.copytree(TESTS.parent / "specs", folder / "specs")
        paths = os.pathsep.join((str(self.package.parent), str(TESTS)))
        # No module of a mutant stays compiled, and what it has computed is not found by the next one.
        self.environment = {**os.environ, "PYTHONPATH": paths, "PYTHONDONTWRITEBYTECODE": "1", "CI": ""}

    def judge(self, folder: str, mutant: Mutant, unfit: frozenset[tuple[str, str]] = frozenset()) -> Verdict:
        """Asks the judges of a folder about a mutant, but those that are not fit."""
        path = self.package / mutant.path
        source, times = path.read_bytes(), path.stat()
        path.write_bytes(mutant.applied(source))
        os.utime(path, (times.st_atime, times.st_mtime + 1000))
        try:
            asked = [(name, call) for name, call in calls(folder, mutant.path) if (folder, name) not in unfit]
            return Verdict(folder, mutant, next((name for name, call in asked if self.fails(call)), ""))
        finally:
            path.write_bytes(source)
            os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))

    def fails(self, call: list[str]) -> bool:
        """Whether a judge fails, or takes too long."""
        with tempfile.TemporaryDirectory(prefix="fieldspec-mutant-") as cache:
            environment = {**self.environment, "FIELDSPEC_CACHE": cache}
            run = subprocess.Popen(
                call,
                cwd=TESTS.parent,
                env=environment,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
                start_new_session=True,
            )
            try:
                # No test has the words of a group in its name: that is no verdict.
                return run.wait(PATIENCE) not in (0, 5)
            except subprocess.TimeoutExpired:
                os.killpg(run.pid, 9)
                run.wait()
                return True


def calls(folder: str, path: str) -> Iterator[tuple[str, list[str]]]:
    """The judges of a folder in turn: their names, and the commands that fail where they notice a mutant."""
    judges = JUDGES[folder]
    if judges.outputs:
        yield OUTPUTS, [sys.executable, str(TESTS / "recorded_outputs.py"), *judges.outputs.split()]
    for group in judges.tests:
        words = group.format(stem=Path(path).stem).split()
        tests = [str(TESTS / word) if (TESTS / word).exists() else word for word in words]
        yield group, [sys.executable, "-m", "pytest", "-q", "-x", "-n", "0", "-p", "no:cacheprovider", *tests]


def verdicts(folders: list[str], each: int, seed: int, processes: int = PROCESSES) -> Iterator[Verdict]:
    """The verdicts about mutants of each folder, in order. A judge that refuses the right compiler is not asked."""
    drawn = [(folder, mutant) for folder in folders for mutant in sample(PACKAGE, folder, each, seed)]
    with tempfile.TemporaryDirectory(prefix="fieldspec-mutants-") as place, ThreadPoolExecutor(processes) as pool:
        copies: SimpleQueue[Copy] = SimpleQueue()
        for number in range(processes):
            copies.put(Copy(Path(place) / str(number)))

        right, unfit = copies.get(), set[tuple[str, str]]()
        for folder in folders:
            for name, call in calls(folder, folder):
                if right.fails(call):
                    print(f"{folder}: {name} fails without a mutant too, and is not asked", flush=True)
                    unfit.add((folder, name))
        copies.put(right)

        def judged(item: tuple[str, Mutant]) -> Verdict:
            copy = copies.get()
            try:
                return copy.judge(*item, frozenset(unfit))
            finally:
                copies.put(copy)

        yield from pool.map(judged, drawn)


def table(results: list[Verdict]) -> Iterator[str]:
    """The share of mutants that are noticed, as rows of Markdown, by folder."""
    yield "| folder | mutants | noticed | by recorded outputs | by tests |"
    yield "|---|---|---|---|---|"
    for folder in [*dict.fromkeys(verdict.folder for verdict in results), "all"]:
        own = [verdict for verdict in results if folder in ("all", verdict.folder)]
        noticed, outputs = sum(bool(v.judge) for v in own), sum(v.judge == OUTPUTS for v in own)
        share = f"{noticed} ({100 * noticed / len(own):.0f} %)"
        yield f"| {folder} | {len(own)} | {share} | {outputs} | {noticed - outputs} |"


def main(each: int = EACH, seed: int = 1, *, folders: list[str]) -> int:
    """Prints each mutant that nobody notices, then the table. Returns the exit code."""
    results = []
    for verdict in verdicts(folders or list(JUDGES), each, seed):
        results.append(verdict)
        if not verdict.judge:
            print(f"survives: {verdict.mutant}", flush=True)
    print("\n".join(table(results)))
    return int(100 * sum(bool(verdict.judge) for verdict in results) < GOAL * len(results))


if __name__ == "__main__":
    sys.exit(main(*(int(word) for word in sys.argv[1:3]), folders=sys.argv[3:]))
