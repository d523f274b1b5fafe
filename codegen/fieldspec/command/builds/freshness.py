"""Which outputs of an earlier build are still up to date, and the manifest that a build leaves among them.

A build records hashes of the compiler, of the spec files that it read, and of the files that it wrote. An output of a
device is up to date where all of these are unchanged. Times of files are compared only within a process, with those
that it has seen itself.
"""

from __future__ import annotations

import hashlib
import json
import os
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any, TypeVar

from fieldspec.command.files import cache_folder
from fieldspec.command.files.regular_file import content
from fieldspec.command.packages.plugins import package_hashes
from fieldspec.command.sources.project_choices import ProjectChoices
from fieldspec.foundation.classes import TYPE_CHECKING, attributes, dataclass, field
from fieldspec.language.model.choice import PROJECT_FILE
from fieldspec.language.reading.findings import PROTOCOLS

if TYPE_CHECKING:
    from fieldspec.language.diagnostics import Diagnostic

KIND = "builds"
LARGEST_OUTPUT = 1 << 30
"""The most bytes of an output; a larger file was not written by a build."""
Hashes = dict[str, str]


@dataclass(frozen=True, slots=True)
class Built:
    """A device as it was built: hashes of its spec files, identities of its versions, and hashes of its outputs.

    `warned` says that it has warnings; it is then checked in every build, so that they are shown.
    """

    inputs: Hashes
    identities: Hashes
    warned: bool
    outputs: dict[str, Hashes]


@dataclass(frozen=True, slots=True)
class BuildRequest:
    """The selection for a build: outputs, and devices with their versions; no version means all, no device means all.

    Outputs that are `required` must express each device. `project` has the choices of the project file. A request that
    `adds` builds versions in addition to the chosen ones, so that files of several versions keep all of them.
    """

    outputs: tuple[str, ...]
    devices: dict[str, frozenset[str]]
    required: bool = False
    project: ProjectChoices = field(default_factory=lambda: ProjectChoices(None, ""))
    adds: bool = False

    def outputs_of(self, device: str) -> tuple[str, ...]:
        """The outputs of a device: those that are named, or else those that the project file chooses."""
        chosen = self.project.choice(device).outputs
        if self.required or chosen is None:
            return self.outputs
        return tuple(name for name in self.outputs if name in chosen)

    @property
    def whole(self) -> bool:
        """Whether all devices are built, so that the files of others can be removed."""
        return not self.devices

    @property
    def picked(self) -> bool:
        """Whether devices are built at some of their versions only."""
        return any(self.devices.values())


@dataclass(frozen=True, slots=True)
class BuildResult:
    """The findings of a build, the current devices, and the files that were out of date.

    `shared` are the files that belong to no device. `quiet` says that nothing at all was found in the files. `broken`
    are the devices with errors, whose files stay as they are; they are not among `devices`.
    """

    findings: list[Diagnostic]
    devices: dict[str, Built]
    shared: dict[str, Hashes]
    stale: list[str]
    quiet: bool
    broken: tuple[str, ...] = ()


def digest(data: bytes) -> str:
    """The hash by which files are compared, as the manifest has it."""
    return hashlib.sha256(data).hexdigest()


_DIGESTS: dict[tuple[int, ...], str] = {}
"""The hashes of files that this process has read, by all that the system changes when it changes a file."""
_MOST_DIGESTS = 100_000
_SETTLED = 3_000_000_000
"""The nanoseconds after which the clock of any file system has moved on."""


def file_digest(output_folder: Path, path: str) -> str | None:
    """The hash of a file of a folder as it is now; None where it cannot be read. Only changed files are read again."""
    name = f"{output_folder}/{path}"
    try:
        status, now = os.stat(name), time.time_ns()
        state = status.st_dev, status.st_ino, status.st_size, status.st_mtime_ns, status.st_ctime_ns
        file_hash = _DIGESTS.get(state) or digest(content(name, LARGEST_OUTPUT))
    except OSError:
        return None
    if max(state[-2:]) + _SETTLED < now:
        if len(_DIGESTS) == _MOST_DIGESTS:
            _DIGESTS.clear()
        _DIGESTS[state] = file_hash
    return file_hash


class EarlierBuild:
    """The record of an earlier build into a folder. `now` has the hashes of the spec files as they are.

    `packages` are the installed packages with outputs, checks and protocols.

    Where it is not `trusted`, the record is neither read nor written.
    """

    def __init__(
        self,
        output_folder: Path,
        files: Mapping[str, bytes],
        packages: Hashes | None = None,
        trusted: bool = True,
        project_file: bytes | None = None,
    ) -> None:
        self.now = {path: digest(data) for path, data in files.items()}
        if project_file is not None:
            self.now[PROJECT_FILE] = digest(project_file)
        self.devices: dict[str, Built] = {}
        self.shared: dict[str, Hashes] = {}
        self.out = output_folder
        self._name = str(output_folder.resolve())
        self._specs: Hashes = {}
        self._note: dict[str, Any] = {}
        self.trusted = trusted
        self._compiler = _running(packages or {}) if trusted else ""
        note = cache_folder.cached(KIND, self._name) if self._compiler else None
        with suppress(*_WRONG_SHAPE):  # another program has written it
            data = json.loads(note or b"{}")
            if data["compiler"] == self._compiler:
                specs, shared, devices = _hashes(data["specs"]), _by_name(data["shared"], _hashes), data["devices"]
                self.devices = _by_name(devices, _built)
                self._note, self._specs, self.shared = data, specs, shared

    def changed(self, device: str) -> list[str]:
        """The files for which a device must be read again: changed, new or gone; `*` where nothing is known of it."""
        if device not in self.devices:
            return ["*"]
        before = self.devices[device].inputs
        now = {path for path in self.now if path.startswith(f"{device}/") or path == PROJECT_FILE}
        return sorted(path for path in now | set(before) if before.get(path) != self.now.get(path))

    def unchanged(self, files: Hashes | None) -> Hashes | None:
        """The hashes of an output whose files are all as they were built, else None."""
        if files is None or any(self.hash_of(path) != expected for path, expected in files.items()):
            return None
        return files

    def hash_of(self, path: str) -> str | None:
        """The hash of a file of the outputs as it is now; None where it cannot be read."""
        return file_digest(self.out, path)

    def confined(self) -> bool:
        """Whether only files of known devices have changed, so that the others need not be read."""
        paths = {path for path in self._specs.keys() | self.now.keys() if self._specs.get(path) != self.now.get(path)}
        folders = {path.partition("/")[0] for path in paths}
        return bool(self._specs) and PROTOCOLS not in folders and folders <= {*self.devices} & {*devices_in(self.now)}

    def key(self, device: str, files: Iterable[str]) -> str:
        """The key of what the compiler makes of these files for a device; empty where nothing is cached."""
        if not self._compiler:
            return ""
        parts = [device, self._compiler, *(part for path in sorted(files) for part in (path, self.now[path]))]
        return cache_folder.checksum(*(os.fsencode(part) for part in parts))

    def keep(self, result: BuildResult, whole: bool) -> None:
        """Records a build for the next one, and of devices with errors what was recorded before.

        A build during which the compiler changed is not recorded.
        """
        if not self._compiler or _running(package_hashes()) != self._compiler:
            return
        remaining = {name: built for name, built in self.devices.items() if not whole or name in result.broken}
        data: dict[str, Any] = {
            "compiler": self._compiler,
            "specs": (self.now if result.quiet else {}) if whole else self._specs,
            "devices": {
                name: {key: getattr(built, key) for key in attributes(Built)}
                for name, built in {**remaining, **result.devices}.items()
            },
            "shared": {**self.shared, **result.shared},
        }
        if data != self._note:
            cache_folder.store(KIND, self._name, json.dumps(data, separators=(",", ":")).encode())


_WRONG_SHAPE = (ValueError, KeyError, TypeError, AttributeError, RecursionError)
"""What reading data of another shape raises."""
_Entry = TypeVar("_Entry")


def _by_name(data: Any, entry: Callable[[Any], _Entry]) -> dict[str, _Entry]:
    """Entries by their names. Raises what is in `_WRONG_SHAPE`."""
    return {name: entry(value) for name, value in data.items()}


def _checked_text(data: Any) -> str:
    if not isinstance(data, str):
        raise TypeError("not a text")
    return data


def _hashes(data: Any) -> Hashes:
    return _by_name(data, _checked_text)


def _paths(data: Any) -> list[str]:
    if not isinstance(data, list):
        raise TypeError("not a list")
    return [_checked_text(path) for path in data]


def _built(data: Any) -> Built:
    return Built(
        _hashes(data["inputs"]), _hashes(data["identities"]), data["warned"] is True, _by_name(data["outputs"], _hashes)
    )


def devices_in(paths: Iterable[str]) -> list[str]:
    """The devices that some spec files belong to."""
    return sorted({path.partition("/")[0] for path in paths if path != PROJECT_FILE} - {PROTOCOLS})


_at_start: dict[str, str] = {}
"""The compiler that this process began with, by the state of its files."""


def _running(packages: Hashes) -> str:
    """The compiler that runs, with its plug-ins; empty where its files have changed since it began."""
    try:
        installed = [text.encode() for pair in sorted(packages.items()) for text in pair]
        state = cache_folder.checksum(cache_folder.state(cache_folder.WHOLE).encode(), *installed)
        if not _at_start:
            identity = cache_folder.identity()
            _at_start[state] = cache_folder.checksum(identity.encode(), *installed) if installed else identity
    except OSError:
        return ""
    return _at_start.get(state, "")


MANIFEST = "manifest.json"
_NAMED = 3


@dataclass(frozen=True, slots=True)
class Manifest:
    """Identities of versions, hashes of spec files by device, and hashes of the files that were made of them.

    `owned` are the files of each device, `stale` the files of devices with errors. `packages` are versions and hashes
    of installed packages that bring outputs, checks and protocols.
    """

    identities: Hashes
    specs: dict[str, Hashes]
    files: Hashes
    packages: Hashes
    owned: dict[str, list[str]]
    stale: list[str]

    def text(self) -> bytes:
        """The text of the file of the manifest."""
        specs = {device: dict(sorted(files.items())) for device, files in sorted(self.specs.items())}
        data = {
            "identities": dict(sorted(self.identities.items())),
            "specs": specs,
            "files": dict(sorted(self.files.items())),
            "devices": {device: sorted(paths) for device, paths in sorted(self.owned.items()) if paths},
            **({"stale": self.stale} if self.stale else {}),
            **({"packages": self.packages} if self.packages else {}),
        }
        return (json.dumps(data, indent=1) + "\n").encode("utf-8")

    def remaining(self, build_request: BuildRequest, result: BuildResult) -> Hashes:
        """The files of the requested outputs that stay as they are, since their devices have errors."""
        names = build_request.outputs
        paths = (path for device in result.broken for path in self.owned.get(device, ()) if _output_of(path) in names)
        return {path: self.files[path] for path in paths if path in self.files}

    def renewed(
        self, build_request: BuildRequest, result: BuildResult, hashes: Hashes, removed: Sequence[str], packages: Hashes
    ) -> Manifest:
        """The manifest after a build whose files have the given hashes, and which removes others."""
        whole, broken = build_request.whole, result.broken
        identities = {key: value for key, value in self.identities.items() if not whole or key.split("@")[0] in broken}
        specs = {device: files for device, files in self.specs.items() if not whole or device in broken}
        for name, device in result.devices.items():
            identities |= device.identities
            specs[name] = device.inputs
        remaining = (_output_of(path) for path in self.files if path not in removed)
        if build_request.picked or not set(build_request.outputs).issuperset(remaining):
            specs = self.specs  # some files are still from other specs
            packages = self.packages
        files = {path: digest for path, digest in self.files.items() if path not in removed} | hashes
        stale = {*self.stale, *self.remaining(build_request, result)}.difference(removed, hashes)
        return Manifest(identities, specs, files, packages, self._owned(build_request, result, files), sorted(stale))

    def _owned(self, build_request: BuildRequest, result: BuildResult, files: Hashes) -> dict[str, list[str]]:
        """The files of each device, where a build has left these files."""
        owned = {device: [path for path in paths if path in files] for device, paths in self.owned.items()}
        for device, built in result.devices.items():
            paths_of_device = [path for hashes in built.outputs.values() for path in hashes if path in files]
            owned[device] = [*dict.fromkeys([*paths_of_device, *owned.get(device, ())])]
        return owned

    def gone(self, hashes: Hashes, names: Sequence[str]) -> list[str]:
        """Files of an earlier build that the requested outputs no longer have."""
        ours = (path for path in self.files if _output_of(path) in names and path not in hashes)
        return sorted(path for path in ours if ".." not in path.split("/"))

    def reason(self, path: str, result: BuildResult, earlier: EarlierBuild, packages: Hashes) -> str:
        """The reason why a file differs from what a build would write."""
        if path not in self.files:
            return "it is new"
        if earlier.hash_of(path) is None:
            return "it is missing"
        if earlier.hash_of(path) != self.files[path]:
            return "it was edited"
        makers = [
            name for name, built in result.devices.items() if any(path in files for files in built.outputs.values())
        ]
        for name in makers:
            before, now = self.specs.get(name, {}), result.devices[name].inputs
            changed = sorted(file for file in before.keys() | now.keys() if before.get(file) != now.get(file))
            if before and changed:
                return f"changed: {_enumerated(changed)}"
        if changed := sorted(
            name for name in self.packages.keys() | packages.keys() if self.packages.get(name) != packages.get(name)
        ):
            return f"changed: {_enumerated([f'the package {name}' for name in changed])}"
        return "another version of the compiler wrote it"


def _output_of(path: str) -> str:
    """The name of the output that a file belongs to."""
    return path.partition("/")[0]


def _enumerated(names: Sequence[str]) -> str:
    """The first few names, and how many more there are."""
    rest_text = f" and {len(names) - _NAMED} more" if len(names) > _NAMED else ""
    return f"{', '.join(names[:_NAMED])}{rest_text}"


def read_manifest(output_folder: Path) -> Manifest:
    """The manifest of the last build; an empty one where it cannot be read."""
    try:
        data = json.loads(content(output_folder / MANIFEST, LARGEST_OUTPUT))
        specs, packages = _by_name(data.get("specs", {}), _hashes), _hashes(data.get("packages", {}))
        owned = _by_name(data.get("devices", {}), _paths)
        stale = _paths(data.get("stale", []))
        return Manifest(_hashes(data["identities"]), specs, _hashes(data["files"]), packages, owned, stale)
    except (OSError, *_WRONG_SHAPE):
        return Manifest({}, {}, {}, {}, {}, [])
