"""The made-up oven, whose tables have records in records: its layout, its generated code in a folder, and frames."""

from __future__ import annotations

import importlib
import sys
import tempfile
from functools import cache
from pathlib import Path
from typing import Any

from fieldspec.codec.reference.records import encoded
from fieldspec.command.pipeline import load
from fieldspec.targets import OUTPUTS
from fieldspec.targets.python.backend import PACKAGE
from layouts import SPECS, layout_at

FOLDER = Path(__file__).with_name("nested")
_NAME = "nested_devices"
_FOLDER = tempfile.TemporaryDirectory(prefix="fieldspec-nested-")


def _files() -> dict[str, bytes]:
    protocols = {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in SPECS.glob("protocols/*.yaml")}
    return protocols | {path.relative_to(FOLDER).as_posix(): path.read_bytes() for path in FOLDER.rglob("*.yaml")}


LAYOUT = layout_at(load(_files()).devices["oven"], "1")

PROGRAM = {
    "number": 7,
    "steps": [
        {
            "begin": {"hour": 6, "minute": 30},
            "target": 1805,
            "limits": [{"exponent": -1, "low": 125, "power": 3}, {"exponent": 2, "low": -4, "power": -3}],
        },
        {
            "begin": {"hour": 22, "minute": 5},
            "target": 4000,
            "limits": [{"exponent": 0, "low": 0, "power": 0}, {"exponent": 3, "low": 9, "power": 1}],
        },
    ],
    "changed": {"hour": 1, "minute": 2},
    "owner": {"tag": "ab12"},
    "level": 5,
}
"""The values of an element of `programs`."""

DATA = encoded(LAYOUT.tables["programs"].record, PROGRAM, LAYOUT.device)
"""The bytes of these values, as the reference codec writes them."""

RAW = {
    "number": 7,
    "steps[0].begin.hour": 6,
    "steps[0].begin.minute": 30,
    "steps[0].target": 1805,
    "steps[0].limits[0].exponent": -1,
    "steps[0].limits[0].low": 125,
    "steps[0].limits[0].power": 3,
    "steps[0].limits[1].exponent": 2,
    "steps[0].limits[1].low": -4,
    "steps[0].limits[1].power": -3,
    "steps[1].begin.hour": 22,
    "steps[1].begin.minute": 5,
    "steps[1].target": 4000,
    "steps[1].limits[0].exponent": 0,
    "steps[1].limits[0].low": 0,
    "steps[1].limits[0].power": 0,
    "steps[1].limits[1].exponent": 3,
    "steps[1].limits[1].low": 9,
    "steps[1].limits[1].power": 1,
    "changed.hour": 1,
    "changed.minute": 2,
    "owner.tag": b"ab12",
    "level": 5,
    "mark": 0x5A,
}
"""The same values by the paths that people write."""


def read_frames(first: int, data: bytes) -> tuple[bytes, bytes]:
    """A request that reads registers, and the response with their bytes."""
    request = bytes.fromhex(f"0001 0000 0006 01 03 {first:04X} {len(data) // 2:04X}")
    return request, bytes.fromhex(f"0001 0000 {len(data) + 3:04X} 01 03 {len(data):02X} {data.hex()}")


@cache
def output_folder(name: str) -> Path:
    """The folder with the files of an output."""
    folder = Path(_FOLDER.name) / name
    for path, text in (OUTPUTS[name].shared() | OUTPUTS[name].files([LAYOUT])).items():
        assert isinstance(text, str)
        place = folder / (path.replace(PACKAGE, _NAME, 1) if name == "python" else path)
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text, "utf-8", newline="\n")
    return folder


def module(name: str) -> Any:
    """A module of the generated package, such as `oven.v1`."""
    folder = str(output_folder("python"))
    if folder not in sys.path:
        sys.path.insert(0, folder)
    return importlib.import_module(f"{_NAME}.{name}")
