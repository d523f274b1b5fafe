"""The compiler as a whole process, from specs to files, against a hand-written one and against other compilers.

The hand-written one is the floor: it knows one device in one form, and proves nothing. What each makes differs: the C
header of ours has a self-test beside it, and the documentation comes as HTML and Markdown.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path
from statistics import median

from peers import registers
from processes import BIN, FIELDSPEC, PYTHON, Took, compared, in_turns, limited
from rows import ROOT, Row, printed

PEERS = ROOT / "benchmarks" / "peers"
OUTPUTS = "c,python,docs"
ROUNDS = {400: 5, 10_000: 1, 100_000: 1}
"""By number of registers; what takes a minute is hardly disturbed by anything."""
FLOOR = "hand-written"


def rows() -> Iterator[Row]:
    """The rows, by number of registers."""
    took: dict[int, dict[str, list[Took]]] = {}
    for count, rounds in ROUNDS.items():
        with tempfile.TemporaryDirectory() as folder:
            took[count] = in_turns(_commands(count, Path(folder)), rounds, FIELDSPEC_CACHE=folder)
        yield from _of(count, took[count])
    few, many = (median(measured.work for measured in took[count]["all"]) for count in (10_000, 100_000))
    yield limited("100,000 registers", "time, times that of 10,000", many / few, "x", 11)


def _of(count: int, took: dict[str, list[Took]]) -> Iterator[Row]:
    group = f"{count:,} registers"
    yield compared(group, "C, Python, Markdown and HTML", took, "all", FLOOR, at_most=2.0)
    yield compared(group, "reading and checking alone", took, "check", FLOOR)
    if count == 100_000:
        yield limited(group, "memory", max(measured.memory for measured in took["all"]) / 1e6, "MB", 1000)
    peakrdl, html, hdl, page = _names()
    if count == 400:
        yield compared(group, "C header and self-test", took, "c", peakrdl, at_most=0.12)
        yield compared(group, "C header and self-test", took, "c", hdl, at_most=0.75)
        yield compared(group, "HTML and Markdown", took, "docs", html, at_most=0.10)
        yield compared(group, "HTML and Markdown", took, "docs", page)
    elif count == 10_000:
        yield compared(group, "C header and self-test", took, "c", peakrdl)
        yield compared(group, "C header and self-test", took, "c", hdl)


def _names() -> tuple[str, str, str, str]:
    peakrdl, hdl = f"PeakRDL {version('peakrdl')}", f"hdl-registers {version('hdl-registers')}"
    return f"{peakrdl}, C header", f"{peakrdl}, HTML", f"{hdl}, C header", f"{hdl}, HTML"


def _commands(count: int, folder: Path) -> dict[str, tuple[str, ...]]:
    """The commands for so many registers."""
    for path, text in registers.spec(count).items():
        (folder / "specs" / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / "specs" / path).write_text(text, encoding="utf-8")
    rdl, toml, out = folder / "large.rdl", folder / "large.toml", folder / "out"
    build = (*FIELDSPEC, "build", "--no-cache", "--specs", str(folder / "specs"), "--out", str(out))
    commands = {
        "all": (*build, "--to", OUTPUTS),
        "check": (*FIELDSPEC, "check", "--specs", str(folder / "specs")),
        FLOOR: (*PYTHON, str(PEERS / "floor.py"), str(folder / "specs"), str(folder / "floor")),
    }
    if count == 100_000:
        return commands
    rdl.write_text(registers.systemrdl(count), encoding="utf-8")
    toml.write_text(registers.toml(count), encoding="utf-8")
    peakrdl, html, hdl, page = _names()
    commands |= {
        "c": (*build, "--to", "c"),
        peakrdl: (*PYTHON, str(BIN / "peakrdl"), "c-header", str(rdl), "-o", str(folder / "large.h")),
        hdl: (*PYTHON, str(PEERS / "hdl_registers_header.py"), str(toml), str(folder / "hdl")),
    }
    if count == 400:
        commands |= {
            "docs": (*build, "--to", "docs"),
            html: (*PYTHON, str(BIN / "peakrdl"), "html", str(rdl), "-o", str(folder / "html")),
            page: (*PYTHON, str(PEERS / "hdl_registers_header.py"), str(toml), str(folder / "hdl"), "html"),
        }
    return commands


if __name__ == "__main__":
    if sys.argv[1:]:
        ROUNDS = {count: ROUNDS[count] for count in map(int, sys.argv[1:])}
        for wanted in ROUNDS:
            with tempfile.TemporaryDirectory() as place:
                printed(_of(wanted, in_turns(_commands(wanted, Path(place)), ROUNDS[wanted], FIELDSPEC_CACHE=place)))
    else:
        printed(rows())
