"""The C output of all devices, printed once for all tests of it."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from fieldspec.targets.c.backend import files
from layouts import SPECS, TEST_SPECS, layouts
from shared_results import shared

DEVICES = {name: versions[-1] for root in (SPECS, TEST_SPECS) for name, versions in layouts(root).items()}
"""The newest versions of all devices."""


@cache
def newest_texts() -> dict[str, dict[str, str]]:
    """The files of the newest version of each device."""
    return shared("newest_headers", lambda: {name: files([layout]) for name, layout in DEVICES.items()})


def write_newest(device: str, folder: Path) -> None:
    """Writes the files of the newest version of a device into a folder."""
    for path, text in newest_texts()[device].items():
        (folder / path).write_text(text, encoding="utf-8", newline="\n")
