"""Finds the specs' folder and reads its files. Nothing of the compiler is needed for that, so that it takes no time."""

from __future__ import annotations

import os
from pathlib import Path

from fieldspec.commands.usage import UsageError, unknown
from fieldspec.reading.folders import MAIN, PROTOCOLS, VERSIONS

FOLDER = "specs"
VARIABLE = "FIELDSPEC_SPECS"
INDEX = "manual.index"
"""The file of a device with the index of its manual, which audits are made from."""


def folder(given: str | None) -> Path:
    """The specs' folder: as given, by the environment, here or in a folder above, or the installed one."""
    named = given or os.environ.get(VARIABLE)
    if named:
        path = Path(named)
        if not path.is_dir():
            raise UsageError(f"there is no folder {named}; give the folder of the specs with --specs")
        return path
    here = Path.cwd()
    for above in (here, *here.parents):
        path = above / FOLDER
        if path.is_dir() and any(path.glob(f"*/{MAIN}")):
            return path
    installed = Path(__file__).resolve().parent.parent / "_specs"
    if installed.is_dir():
        return installed
    raise UsageError(f"there is no folder {FOLDER} here or above; give it with --specs, or set {VARIABLE}")


def files(path: Path, only: frozenset[str] = frozenset()) -> dict[str, bytes]:
    """The files of specs below a folder by relative path; of all devices' folders, or of `only` some."""
    found: dict[str, bytes] = {}
    try:
        patterns = ("*/*.yaml", f"*/{VERSIONS}/*.yaml", f"*/{INDEX}")
        for file in sorted(file for pattern in patterns for file in path.glob(pattern)):
            inner = file.relative_to(path)
            hidden = file.name.startswith(".")  # what editors leave beside a file
            if not hidden and (not only or inner.parts[0] in only or inner.parts[0] == PROTOCOLS):
                found[inner.as_posix()] = file.read_bytes()
    except OSError as error:
        raise UsageError(f"cannot read {error.filename}: {error.strerror}") from None
    return found


def of_devices(given: str | None, devices: frozenset[str] = frozenset()) -> tuple[Path, dict[str, bytes]]:
    """The specs' folder and its files; devices that are asked for must be there."""
    path = folder(given)
    known = {file.parent.name for file in path.glob(f"*/{MAIN}")}
    for device in sorted(devices - known):
        raise unknown("device", device, known)
    if not known:
        raise UsageError(f"the folder {path} holds no device; a device is a folder with a {MAIN}")
    return path, files(path, devices)


def shown(path: Path) -> str:
    """The folder as findings show it: from here, so that editors and code reviews find the files."""
    try:
        text = path.resolve().relative_to(Path.cwd()).as_posix()
    except ValueError:
        text = path.as_posix()
    return "" if text == "." else text


def split(text: str) -> tuple[str, str]:
    """`drive@2.0` as device and version; the version is empty where none is given."""
    device, _, version = text.partition("@")
    return device, version
