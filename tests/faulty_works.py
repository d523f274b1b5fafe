"""Works on files that faults strike, done in a folder."""

from __future__ import annotations

from pathlib import Path

from fieldspec.cli import main
from fieldspec.command.builds import freshness
from fieldspec.command.files.placement import Staging

NEW = {"a/one": b"11", "b/three": b"33", "c/d/five": b"5", "six": b"6"}
GONE = ["a/two", "gone/four"]


def placed(folder: Path) -> None:
    """Places new files, and removes others."""
    with Staging(folder) as beside:
        for path, content in NEW.items():
            beside.write(path, content)
        beside.place([*NEW], GONE)


def repaired(folder: Path) -> None:
    """Repairs what a killed process has left."""
    with Staging(folder):
        pass


def built(folder: Path, *more: str) -> int:
    """Builds outputs."""
    freshness._at_start.clear()
    words = ["build", "--specs", str(folder / "specs"), "--out", str(folder / "out"), "--to", "vectors,c"]
    return main([*words, *more])


def imported(folder: Path) -> int:
    """Makes a spec of a list."""
    return main(["import", str(folder / "list.csv"), "--to", str(folder / "specs/pump/device.yaml")])


def signed(folder: Path) -> int:
    """Writes signatures into a spec."""
    who = ("--sign", "all", "--by", "second reader", "--on", "2026-01-31")
    return main(["audit", "gadget", *who, "--specs", str(folder / "specs")])


def new(folder: Path) -> int:
    """Makes a spec of a protocol."""
    return main(["new", "device", "pump", "--protocol", "packet", "--specs", str(folder / "specs")])


def exported(folder: Path) -> int:
    """Writes a list of a device."""
    return main(["export", "gadget", "--out", str(folder / "list.csv"), "--specs", str(folder / "specs")])


WORKS = {work.__name__: work for work in (placed, repaired, built, imported, signed, new, exported)}
