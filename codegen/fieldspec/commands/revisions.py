"""Reads spec files of git revisions, through the program git."""

from __future__ import annotations

import posixpath
import subprocess
from pathlib import Path

from fieldspec.classes import dataclass
from fieldspec.commands.usage import UsageError
from fieldspec.reading.folders import MAIN, VERSIONS


class NoRevision(UsageError):
    """A name that is that of no revision."""


@dataclass(frozen=True, slots=True)
class Tree:
    """The spec files of a folder at a revision, by path below it. `path` is the folder's own in the repository, empty
    for its root, and `device` the one that was asked for, empty for all."""

    path: str
    device: str
    files: dict[str, bytes]


def tree(revision: str, path: str | None, specs: Path | None) -> Tree:
    """The specs at a revision: in a folder of the repository, or where `specs`, the folder of the specs, lies in it.

    The folder may be that of all specs, that of one device, or one that has the folder `specs`.
    """
    here = specs if specs is not None and path is None else Path.cwd()
    _verified(here, revision)
    found = path if path is not None else _git(here, "rev-parse", "--show-prefix").decode().strip("\n/")
    listed = _listed(here, revision, found)
    if MAIN in listed and found:
        above, _, device = found.rpartition("/")
        return Tree(above, device, _read(here, _listed(here, revision, above)))
    if not _devices(listed) and _devices(_below(listed, "specs")):
        found, listed = posixpath.join(found, "specs"), _below(listed, "specs")
    if not _devices(listed):
        where = f"{revision}:{found}" if found else revision
        raise UsageError(f"{where} holds no specs; a device is a folder with a {MAIN}: give REVISION:FOLDER")
    return Tree(found, "", _read(here, listed))


def _devices(listed: dict[str, str]) -> set[str]:
    """The folders of devices."""
    return {path.partition("/")[0] for path in listed if path.partition("/")[2] == MAIN}


def _below(listed: dict[str, str], folder: str) -> dict[str, str]:
    start = folder + "/"
    return {path.removeprefix(start): blob for path, blob in listed.items() if path.startswith(start)}


def _verified(here: Path, revision: str) -> None:
    """Refuses what is no revision."""
    try:
        _git(here, "rev-parse", "--git-dir")
    except _Failed:
        text = f"{revision} is no device and no folder, and {here} is in no git repository"
        raise NoRevision(text) from None
    try:
        _git(here, "rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}^{{tree}}")
    except _Failed:
        raise NoRevision(f"there is no device, no folder and no git revision {revision}") from None


def _listed(here: Path, revision: str, path: str) -> dict[str, str]:
    """The YAML files below a folder at a revision: the names of their contents, by path."""
    try:
        folder = (
            _git(here, "rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}:{path}").decode().strip()
        )
        lines = _git(here, "ls-tree", "-r", "-z", "--full-tree", folder).decode("utf-8", "replace")
    except _Failed:
        raise UsageError(f"the revision {revision} has no folder {path}") from None
    found = {}
    for line in filter(None, lines.split("\0")):
        mode, kind, blob = line.partition("\t")[0].split()
        name = line.partition("\t")[2]
        if kind == "blob" and mode != "120000" and name.endswith(".yaml") and not _hidden(name):
            found[name] = blob
    return found


def _hidden(path: str) -> bool:
    return posixpath.basename(path).startswith(".")


def _read(here: Path, listed: dict[str, str]) -> dict[str, bytes]:
    """The contents of the spec files among some files."""
    specs = {path: blob for path, blob in listed.items() if _of_specs(path.split("/"))}
    asked = "".join(f"{blob}\n" for blob in specs.values()).encode()
    answer = _git(here, "cat-file", "--batch", given=asked)
    files = {}
    at = 0
    for path in specs:
        end = answer.index(b"\n", at)
        size = int(answer[at:end].split()[-1])
        files[path] = answer[end + 1 : end + 1 + size]
        at = end + size + 2
    return files


def _of_specs(steps: list[str]) -> bool:
    """Whether a path is that of a spec file: `device/file.yaml` or `device/versions/file.yaml`."""
    return len(steps) == 2 or (len(steps) == 3 and steps[1] == VERSIONS)


class _Failed(Exception):
    """Git did not do what it was asked for."""


def _git(here: Path, *arguments: str, given: bytes = b"") -> bytes:
    try:
        ran = subprocess.run(["git", "-C", str(here), *arguments], input=given, capture_output=True, check=False)
    except FileNotFoundError:
        raise UsageError("git is not installed, so there are no revisions to compare") from None
    if ran.returncode:
        raise _Failed
    return ran.stdout
