"""Runs the benchmarks and writes `docs/benchmarks.md` with its plot: `python benchmarks/run.py [FILE...]`.

With names of files, such as `command_line`, only these are run, and the rows of the others stay as they were; what has
been measured is kept in `benchmarks/results.json`.
"""

from __future__ import annotations

import json
import os
import platform
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from plot import drawn
from remarks import BY_GROUP, REMARKS
from rows import ROOT, Row

HERE = ROOT / "benchmarks"
RESULTS = HERE / "results.json"
PAGE = ROOT / "docs" / "benchmarks.md"
PLOT = ROOT / "docs" / "benchmarks.svg"
BUSY = 1.0
"""The load from which on it is mentioned."""
FILES = (
    "python_modbus",
    "python_point",
    "python_telegram",
    "python_packet",
    "python_framer",
    "python_import",
    "python_many",
    "queries",
    "device",
    "captures",
    "dissectors",
    "javascript",
    "c_instructions",
    "c_cortex",
    "c_compiling",
    "compiler",
    "yaml_reading",
    "builds",
    "watching",
    "editing",
    "command_line",
)
HEAD = """\
# Benchmarks

This page compares the time, size and memory of the compiler and its outputs with peers. A *peer* is hand-written code
or another tool that does the same work. fieldspec and the peer are timed alternately. The ratios therefore also apply
to other machines, but the times do not.

The ratio is the value of fieldspec ("ours") divided by the value of the peer ("theirs"). If the goal is *at least*, the
ratio is the value of the peer divided by the value of fieldspec. [benchmarks/README.md](../benchmarks/README.md)
describes the method.

`{command}` writes this page. It was written on {machine}.

![Ours and the peers](benchmarks.svg)
"""


def main(names: list[str]) -> int:
    """Runs benchmarks, and writes the page."""
    results = json.loads(RESULTS.read_text("utf-8")) if RESULTS.exists() else {}
    for name in names or FILES:
        print(f"running {name}", file=sys.stderr, flush=True)
        load = round(os.getloadavg()[0], 1) if hasattr(os, "getloadavg") else 0.0
        ran = subprocess.run([sys.executable, str(HERE / f"{name}.py")], stdout=subprocess.PIPE, text=True, cwd=HERE)
        if ran.returncode:
            print(f"{name} has failed; its rows stay as they were", file=sys.stderr)
            continue
        results[name] = {"load": load, "rows": [json.loads(line) for line in ran.stdout.splitlines()]}
    RESULTS.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    write(results)
    return 0


def write(results: dict[str, Any]) -> None:
    """Writes the page and the plot of what has been measured."""
    rows = [Row(**row) for name in FILES if name in results for row in results[name]["rows"]]
    PAGE.write_text("\n".join(_lines(rows, results)), encoding="utf-8")
    drawn(rows, PLOT)
    missed = [row for row in rows if not row.met]
    print(f"{len(rows)} rows, {len(missed)} goals missed", file=sys.stderr)


def _lines(rows: list[Row], results: dict[str, Any]) -> Iterator[str]:
    yield HEAD.format(command="make bench", machine=machine())
    with_goal = [row for row in rows if row.at_most is not None or row.at_least is not None]
    met = sum(row.met for row in with_goal)
    yield f"{met} of {len(with_goal)} goals are met."
    # A note says of its rows what they were measured by, and when.
    busy = [name for name in FILES if results.get(name, {}).get("load", 0) > BUSY and "note" not in results[name]]
    if busy:
        most = max(results[name]["load"] for name in busy)
        yield (
            f"\nThese benchmarks began while the machine had a load of up to {most}, in part from an earlier "
            f"benchmark, so their times by the clock can be too long: {', '.join(f'`{name}`' for name in busy)}."
        )
    yield from (f"\n`{name}`: {results[name]['note']}" for name in FILES if results.get(name, {}).get("note"))
    if missing := [name for name in FILES if name not in results]:
        yield f"\nNot measured yet: {', '.join(f'`{name}`' for name in missing)}."
    for group in dict.fromkeys(row.group for row in rows):
        own = [row for row in rows if row.group == group]
        yield f"\n## {group}\n"
        yield "| subject | ours | peer | theirs | ratio | goal | met |"
        yield "|---|---:|---|---:|---:|---:|---|"
        yield from map(_row, own)
        yield from _reasons(group, [row for row in own if not row.met])
    yield ""


def _reasons(group: str, missed: list[Row]) -> Iterator[str]:
    """Why rows of a group miss their goals, each reason with the subjects of its rows."""
    subjects: dict[str, dict[str, None]] = {}
    for row in missed:
        reason = REMARKS.get((group, row.name), BY_GROUP.get(group, ""))
        subjects.setdefault(reason, {})[row.name] = None
    for reason, names in subjects.items():
        if reason:
            misses = "misses its goal" if len(names) == 1 else "miss their goals"
            yield f"\nWhy {', '.join(f'*{name}*' for name in names)} {misses}: {reason}"


def _row(row: Row) -> str:
    goal = "" if row.at_most is None else f"at most {row.at_most:g}"
    goal = f"at least {row.at_least:g}" if row.at_least is not None else goal
    met = "" if not goal else "yes" if row.met else f"no, by {_missed(row)}"
    theirs = f"{_number(row.peers)} {row.unit}" if row.peers or row.ratio else ""
    cells = (row.name, f"{_number(row.ours)} {row.unit}", row.peer, theirs, f"{row.ratio:g}", goal, met)
    return f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in cells)} |"


def _missed(row: Row) -> str:
    limit = row.at_most if row.at_most is not None else row.at_least
    assert limit is not None
    if not limit or not row.ratio:
        return f"{row.ratio:g}"
    times = row.ratio / limit if row.at_most is not None else limit / row.ratio
    return f"{(times - 1) * 100:.0f} %" if times < 2 else f"{times:.2g} times"


def _number(value: float) -> str:
    return f"{value:,.0f}" if value >= 100 else f"{value:g}"


def machine() -> str:
    """The machine, as far as it matters to a reader."""
    model = ""
    if Path("/proc/cpuinfo").exists():
        lines = Path("/proc/cpuinfo").read_text("utf-8").splitlines()
        model = next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "")
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30 if hasattr(os, "sysconf") else 0
    python = f"{platform.python_implementation()} {platform.python_version()}"
    return (
        f"{model or platform.machine()}, {os.cpu_count()} processors, {memory:.0f} GiB, {platform.system()}, {python}"
    )


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
