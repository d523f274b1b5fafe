"""What an earlier build has left, and how much of it still holds.

A build notes from which bytes of specs, by which compiler, it has made which bytes of outputs, all as hashes. An output
of a device is fresh where all of these are the same now: the compiler, every spec file that the device is read from,
and every file of the output as it lies there. Times of files play no part in it, so there is nothing to be misled by.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from fieldspec.classes import attributes, dataclass
from fieldspec.commands import caching
from fieldspec.commands.regular_file import content
from fieldspec.reading.findings import PROTOCOLS

KIND = "builds"
LARGEST_OUTPUT = 1 << 30
"""Bytes of an output; a file that has more was not written by a build."""
Hashes = dict[str, str]


@dataclass(frozen=True, slots=True)
class Built:
    """A device as it was built: from which files, with which identities of versions, and each of its outputs.

    `warned` says that it has findings that do not stop a build: they are worked out and shown again.
    """

    inputs: Hashes
    identities: Hashes
    warned: bool
    outputs: dict[str, Hashes]


def digest(data: bytes) -> str:
    """The hash by which files are compared, as the manifest has it."""
    return hashlib.sha256(data).hexdigest()


def lying(out: Path, path: str) -> str | None:
    """The hash of a file of a folder as it is now; None where it cannot be read."""
    try:
        return digest(content(f"{out}/{path}", LARGEST_OUTPUT))
    except OSError:
        return None


class Earlier:
    """What is known of an earlier build into a folder. `now` are the hashes of the spec files as they are.

    Where it is not `trusted`, nothing is known, and nothing is noted.
    """

    def __init__(self, out: Path, files: Mapping[str, bytes], trusted: bool = True) -> None:
        self.now = {path: digest(held) for path, held in files.items()}
        self.devices: dict[str, Built] = {}
        self.shared: dict[str, Hashes] = {}
        self.out = out
        self._name = str(out.resolve())
        self._specs: Hashes = {}
        self._held: dict[str, Any] = {}
        self._found: dict[str, str | None] = {}
        self.trusted = trusted
        self._compiler = _running() if trusted else ""
        kept = caching.cached(KIND, self._name) if self._compiler else None
        held = json.loads(kept) if kept else {}
        if held.get("compiler") == self._compiler:
            self._held = held
            self._specs, self.shared = held["specs"], held["shared"]
            self.devices = {name: Built(**one) for name, one in held["devices"].items()}

    def changed(self, device: str) -> list[str]:
        """The files for which a device must be read again: changed, new or gone; `*` where nothing is known of it."""
        if device not in self.devices:
            return ["*"]
        before = self.devices[device].inputs
        now = {path for path in self.now if path.startswith(f"{device}/")}
        return sorted(path for path in now | set(before) if before.get(path) != self.now.get(path))

    def unspoilt(self, files: Hashes | None) -> Hashes | None:
        """The files of an output with their hashes, where there is one and all of it lies there as it was built."""
        if files is None or any(self.hash_of(path) != one for path, one in files.items()):
            return None
        return files

    def hash_of(self, path: str) -> str | None:
        """The hash of a file of the outputs as it is now; None where it cannot be read."""
        if path not in self._found:
            self._found[path] = lying(self.out, path)
        return self._found[path]

    def confined(self) -> bool:
        """Whether all that has changed are files of devices that are known, so that the others need not be read."""
        paths = {path for path in self._specs.keys() | self.now.keys() if self._specs.get(path) != self.now.get(path)}
        folders = {path.partition("/")[0] for path in paths}
        return bool(self._specs) and PROTOCOLS not in folders and folders <= {*self.devices} & {*devices_in(self.now)}

    def keep(self, devices: Mapping[str, Built], shared: Mapping[str, Hashes], whole: bool, quiet: bool) -> None:
        """Notes a build for the next one. `quiet` says that nothing was found in any file.

        What is made while the compiler changes is not noted, as nobody can tell which one has made it.
        """
        if not self._compiler or _running() != self._compiler:
            return
        others = {} if whole else self.devices
        data: dict[str, Any] = {
            "compiler": self._compiler,
            "specs": (self.now if quiet else {}) if whole else self._specs,
            "devices": {
                name: {key: getattr(one, key) for key in attributes(Built)}
                for name, one in {**others, **devices}.items()
            },
            "shared": {**self.shared, **shared},
        }
        if data != self._held:
            caching.store(KIND, self._name, json.dumps(data, separators=(",", ":")).encode())


def devices_in(paths: Iterable[str]) -> list[str]:
    """The folders of devices that hold some spec files."""
    return sorted({folder for path in paths if (folder := path.partition("/")[0]) != PROTOCOLS})


_at_start: dict[str, str] = {}
"""The compiler that this process began with, by the state of its files, once it is known."""


def _running() -> str:
    """The compiler that runs; empty where it cannot be told, as its files are not those any more that it began with."""
    try:
        state = caching.state(caching.WHOLE)
        if not _at_start:
            _at_start[state] = caching.identity()
    except OSError:
        return ""
    return _at_start.get(state, "")
