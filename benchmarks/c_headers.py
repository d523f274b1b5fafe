"""Writes the C headers that benchmarks measure."""

from __future__ import annotations

import subprocess
from pathlib import Path

from fieldspec.backends.c.backend import files
from fieldspec.layout.device import DeviceLayout
from fieldspec.pipeline import layouts, load

SPECS = Path(__file__).resolve().parent.parent / "specs"


def devices() -> dict[str, list[DeviceLayout]]:
    """The layouts of all versions of the real devices, the oldest first."""
    project = load({path.relative_to(SPECS).as_posix(): path.read_bytes() for path in sorted(SPECS.rglob("*.yaml"))})
    return {name: list(layouts(spec)) for name, spec in project.devices.items()}


def write_headers(folder: Path) -> None:
    """Writes the headers of all devices into a folder."""
    for versions in devices().values():
        for path, text in files(versions).items():
            (folder / path).write_text(text, encoding="utf-8", newline="\n")


def compiler_version(compiler: str) -> str:
    """What a compiler says that it is."""
    return subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True).stdout.splitlines()[0]
