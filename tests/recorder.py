"""The made-up recorder, whose tables begin where registers say: its layout, and its generated code in a folder."""

from __future__ import annotations

import importlib
import sys
import tempfile
from functools import cache
from pathlib import Path
from typing import Any

from fieldspec.command.pipeline import load
from fieldspec.targets import OUTPUTS
from fieldspec.targets.python.backend import PACKAGE
from layouts import SPECS, layout_at

FOLDER = Path(__file__).with_name("moving")
_NAME = "moving_devices"
_FOLDER = tempfile.TemporaryDirectory(prefix="fieldspec-moving-")


def _files() -> dict[str, bytes]:
    protocols = {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in SPECS.glob("protocols/*.yaml")}
    return protocols | {path.relative_to(FOLDER).as_posix(): path.read_bytes() for path in FOLDER.rglob("*.yaml")}


LAYOUT = layout_at(load(_files()).devices["recorder"], "1")


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
    """A module of the generated package, such as `recorder.v1`."""
    folder = str(output_folder("python"))
    if folder not in sys.path:
        sys.path.insert(0, folder)
    return importlib.import_module(f"{_NAME}.{name}")
