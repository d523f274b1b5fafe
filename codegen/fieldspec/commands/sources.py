"""Finds the specs' folder and reads its files. Nothing of the compiler is needed for that, so that it takes no time."""

from __future__ import annotations

import os

from fieldspec.classes import TYPE_CHECKING
from fieldspec.commands.usage import UsageError, unknown
from fieldspec.reading.findings import MAIN, PROTOCOLS, VERSIONS

if TYPE_CHECKING:
    from collections.abc import Iterator

FOLDER = "specs"
VARIABLE = "FIELDSPEC_SPECS"
INDEX = "manual.index"
"""The file of a device with the index of its manual, which audits are made from."""


def folder(given: str | None) -> str:
    """The specs' folder: as given, by the environment, here or in a folder above, or the installed one."""
    named = given or os.environ.get(VARIABLE)
    if named:
        if not os.path.isdir(named):
            raise UsageError(f"there is no folder {named}; give the folder of the specs with --specs")
        return named
    above, last = os.getcwd(), ""
    while above != last:
        path = os.path.join(above, FOLDER)
        if devices(path):
            return path
        above, last = os.path.dirname(above), above
    path = os.path.join(os.path.dirname(os.path.dirname(os.path.realpath(__file__))), "_specs")
    if os.path.isdir(path):
        return path
    raise UsageError(f"there is no folder {FOLDER} here or above; give it with --specs, or set {VARIABLE}")


def devices(path: str | os.PathLike[str]) -> list[str]:
    """The devices of a folder of specs, each of them a folder with a file of a fixed name."""
    try:
        return sorted(name for name in _folder_entries(path) if os.path.isfile(os.path.join(path, name, MAIN)))
    except OSError:  # which nobody may look into
        return []


def files(path: str | os.PathLike[str], only: frozenset[str] = frozenset()) -> dict[str, bytes]:
    """The files of specs below a folder by relative path; of all devices' folders, or of `only` some."""
    found: dict[str, bytes] = {}
    try:
        for device in sorted(_folder_entries(path)):
            if only and device not in only and device != PROTOCOLS:
                continue
            for inner in sorted(_of_specs(os.path.join(path, device))):
                with open(os.path.join(path, device, inner), "rb") as file:
                    found[f"{device}/{inner}"] = file.read()
    except OSError as error:
        raise UsageError(f"cannot read {error.filename}: {error.strerror}") from None
    return found


def _of_specs(path: str) -> Iterator[str]:
    """The files of a device's folder that are specs, or the index of its manual."""
    for folder in ("", VERSIONS):
        for name in _folder_entries(os.path.join(path, folder)):
            hidden = name.startswith(".")  # what editors leave beside a file
            if not hidden and (name.endswith(".yaml") or (name == INDEX and not folder)):
                yield f"{folder}/{name}" if folder else name


def _folder_entries(path: str | os.PathLike[str]) -> list[str]:
    """The names in a folder; none where there is no such folder."""
    try:
        return os.listdir(path)
    except (FileNotFoundError, NotADirectoryError):
        return []


def of_devices(given: str | None, wanted: frozenset[str] = frozenset()) -> tuple[str, dict[str, bytes]]:
    """The specs' folder and its files; devices that are asked for must be there."""
    path = folder(given)
    known = devices(path)
    for device in sorted(wanted.difference(known)):
        raise unknown("device", device, known)
    if not known:
        raise UsageError(f"the folder {path} holds no device; a device is a folder with a {MAIN}")
    return path, files(path, wanted)


def relative_path(path: str | os.PathLike[str]) -> str:
    """The folder as findings show it: from here, so that editors and code reviews find the files."""
    text, here = os.path.realpath(path), os.getcwd()
    if text == here:
        return ""
    text = text[len(here) :].lstrip(os.sep) if text.startswith(os.path.join(here, "")) else os.fspath(path)
    return text.replace(os.sep, "/")


def split(text: str) -> tuple[str, str]:
    """`drive@2.0` as device and version; the version is empty where none is given."""
    device, _, version = text.partition("@")
    return device, version
