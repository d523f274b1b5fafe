"""The states of specs that a user compares: a version, a folder of specs, or a git revision."""

from __future__ import annotations

import posixpath
import subprocess
from pathlib import Path

from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.rendering.finding_text import place
from fieldspec.command.sources import specs
from fieldspec.foundation.classes import dataclass
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.model.device import Device
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.findings import MAIN, PROTOCOLS, VERSIONS
from fieldspec.language.reading.project import Project, read

_NONE = "there is no device, no folder and no git revision"
_INSTEAD = "write DEVICE@VERSION, a folder of specs, or a revision such as HEAD~1"


class NoRevision(UsageError):
    """The name is not that of a revision."""


@dataclass(frozen=True, slots=True)
class Tree:
    """The spec files of a folder at a revision, by path below it. `path` is the path of the folder in the repository,
    empty for its root; `device` is the requested device, empty for all."""

    path: str
    device: str
    files: dict[str, bytes]


def tree(revision: str, path: str | None, specs: Path | None) -> Tree:
    """The specs at a revision: in a folder of the repository, or where the folder `specs` is in it. Raises UsageError.

    The folder may contain all specs, or be the folder of a device, or contain the folder `specs`.
    """
    directory = specs if specs is not None and path is None else Path.cwd()
    _verified(directory, revision)
    folder = path if path is not None else _git(directory, "rev-parse", "--show-prefix").decode().strip("\n/")
    blobs = _contents(directory, revision, folder)
    if MAIN in blobs and folder:
        above, _, device = folder.rpartition("/")
        return Tree(above, device, _read_blobs(directory, _contents(directory, revision, above)))
    if not _devices(blobs) and _devices(_below(blobs, "specs")):
        folder, blobs = posixpath.join(folder, "specs"), _below(blobs, "specs")
    if not _devices(blobs):
        place_text = f"{revision}:{folder}" if folder else revision
        raise UsageError(f"{place_text} contains no specs; a device is a folder with a {MAIN}: give REVISION:FOLDER")
    return Tree(folder, "", _read_blobs(directory, blobs))


def _devices(blobs: dict[str, str]) -> set[str]:
    """The folders of devices among some files."""
    return {path.partition("/")[0] for path in blobs if path.partition("/")[2] == MAIN}


def _below(blobs: dict[str, str], folder: str) -> dict[str, str]:
    start = folder + "/"
    return {path.removeprefix(start): blob for path, blob in blobs.items() if path.startswith(start)}


def _verified(directory: Path, revision: str) -> None:
    """Refuses a name that is not a revision. Raises NoRevision."""
    try:
        _git(directory, "rev-parse", "--git-dir")
    except _Failed:
        text = f"{revision} is not a device and no folder, and {directory} is in no git repository"
        raise NoRevision(text) from None
    try:
        _git(directory, "rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}^{{tree}}")
    except _Failed:
        raise NoRevision(f"{_NONE} {revision}; {_INSTEAD}") from None


def _contents(directory: Path, revision: str, path: str) -> dict[str, str]:
    """The YAML files below a folder at a revision: the names of their contents, by path."""
    try:
        folder = (
            _git(directory, "rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}:{path}")
            .decode()
            .strip()
        )
        lines = _git(directory, "ls-tree", "-r", "-z", "--full-tree", folder).decode("utf-8", "replace")
    except _Failed:
        raise UsageError(f"the revision {revision} has no folder {path}") from None
    blobs = {}
    for line in filter(None, lines.split("\0")):
        mode, kind, blob = line.partition("\t")[0].split()
        name = line.partition("\t")[2]
        if kind == "blob" and mode != "120000" and name.endswith(".yaml") and not _hidden(name):
            blobs[name] = blob
    return blobs


def _hidden(path: str) -> bool:
    return posixpath.basename(path).startswith(".")


def _read_blobs(directory: Path, blobs: dict[str, str]) -> dict[str, bytes]:
    """The contents of the spec files among some files."""
    specs = {path: blob for path, blob in blobs.items() if _of_specs(path.split("/"))}
    blob_names = "".join(f"{blob}\n" for blob in specs.values()).encode()
    answer = _git(directory, "cat-file", "--batch", data=blob_names)
    files = {}
    offset = 0
    for path in specs:
        end = answer.index(b"\n", offset)
        size = int(answer[offset:end].split()[-1])
        files[path] = answer[end + 1 : end + 1 + size]
        offset = end + size + 2
    return files


def _of_specs(steps: list[str]) -> bool:
    """Whether a path is that of a spec file: `device/file.yaml` or `device/versions/file.yaml`."""
    return len(steps) == 2 or (len(steps) == 3 and steps[1] == VERSIONS)


class _Failed(Exception):
    """Git has reported an error."""


def _git(directory: Path, *arguments: str, data: bytes = b"") -> bytes:
    try:
        ran = subprocess.run(["git", "-C", str(directory), *arguments], input=data, capture_output=True, check=False)
    except FileNotFoundError:
        raise UsageError("git is not installed, so there are no revisions to compare") from None
    if ran.returncode:
        raise _Failed
    return ran.stdout


@dataclass(frozen=True, slots=True)
class SpecState:
    """The old or the new state of a comparison, by the name that the user gave it.

    `device` and `version` are empty where all are meant. `wide` says that it is a state of specs, not a version.
    """

    name: str
    project: Project
    device: str
    version: str
    wide: bool

    def spec(self, device: str) -> DeviceSpec:
        """The spec of a device. Raises UsageError where there is none."""
        if device not in self.project.devices:
            raise UsageError(f"{self.name} holds no device {device}; choose from {', '.join(self.project.devices)}")
        return self.project.devices[device]

    def at(self, device: str, version: str) -> Device:
        """A device at a version. Raises UsageError for a spec that cannot be read."""
        spec = self.spec(device)
        model, findings = spec.at(specs.picked(spec, version))
        _sound(self.name, Project({}, findings))
        return model

    def label(self, device: str, version: str = "") -> str:
        """What this state is called for a device, at a version or at several."""
        version_text = f"@{version}" if version else ""
        if not self.wide:
            return f"{device}{version_text}"
        if self.device:
            return self.name if self.version else f"{self.name}{version_text}"
        return f"{self.name} {device}{version_text}"


def spec_state(text: str, specs_option: str | None, bare_paths: bool) -> SpecState:
    """The state that `DEVICE[@VERSION]`, `FOLDER[@VERSION]` or `REVISION[:FOLDER][@VERSION]` means, in this order.

    With `bare_paths`, files of a revision are shown by their paths in the repository, without the revision.
    Raises UsageError for a state that does not exist.
    """
    try:
        specs_folder: Path | None = specs.folder(specs_option)
    except UsageError:
        if specs_option:
            raise
        specs_folder = None
    name, version = specs.split(text)
    if (
        specs_folder is not None
        and (specs_folder / name / MAIN).is_file()
        and "/" not in name
        and name not in ("", ".", "..")
    ):
        return _named(text, specs.project(specs_option, frozenset([name])), name, version)
    for path, picked in ((text, ""), text.rpartition("@")[::2]):
        if path and Path(path).is_dir():
            return _folder(text, Path(path), picked)

    try:
        return _revision(text, specs_folder, bare_paths)
    except NoRevision:
        if specs_folder is not None and name and version and "{" not in version:
            raise unknown("device", name, (file.parent.name for file in specs_folder.glob(f"*/{MAIN}"))) from None
        raise


def _named(text: str, project: Project, device: str, version: str) -> SpecState:
    _sound(text, project)
    if device not in project.devices:
        raise UsageError(f"the spec of {device} has findings; see them with: fieldspec check {device}")
    return SpecState(text, project, device, specs.picked(project.devices[device], version), wide=False)


def _folder(text: str, path: Path, version: str) -> SpecState:
    """A folder of specs, the folder of a device, or one that contains the folder `specs`."""
    device = ""
    if (path / MAIN).is_file():
        path = path.resolve()
        device, path = path.name, path.parent
    elif not any(path.glob(f"*/{MAIN}")) and any(path.glob(f"{specs.FOLDER}/*/{MAIN}")):
        path = path / specs.FOLDER
    if not any(path.glob(f"*/{MAIN}")):
        raise UsageError(f"the folder {text} contains no specs; a device is a folder with a {MAIN}")
    only = frozenset([device]) if device else frozenset[str]()
    files = specs.with_protocols(_of_devices(specs.files(path, only)))
    return _wide(text, read(files, only, specs.relative_path(path), specs.origins(files)), device, version)


def _revision(text: str, specs_folder: Path | None, bare_paths: bool) -> SpecState:

    name, version = text, ""
    before, joint, after = text.rpartition("@")
    if joint and before and not after.startswith("{"):
        name, version = before, after
    revision, colon, path = name.partition(":")
    if not revision:
        raise UsageError(f"{_NONE} {text}; {_INSTEAD}")
    spec_tree = tree(revision, path.strip("/") if colon else None, specs_folder)
    folder = spec_tree.path if bare_paths else f"{revision}:{spec_tree.path}"
    only = frozenset([spec_tree.device]) if spec_tree.device else frozenset[str]()
    files = specs.with_protocols(_of_devices(spec_tree.files))
    return _wide(text, read(files, only, folder, specs.origins(files)), spec_tree.device, version)


def _of_devices(files: dict[str, bytes]) -> dict[str, bytes]:
    """The spec files in folders of devices and of protocols."""
    folders = {path.partition("/")[0] for path in files if path.partition("/")[2] == MAIN} | {PROTOCOLS}
    return {path: data for path, data in files.items() if path.partition("/")[0] in folders}


def _wide(text: str, project: Project, device: str, version: str) -> SpecState:
    _sound(text, project)
    return SpecState(text, project, device, version, wide=True)


def _sound(name: str, project: Project) -> None:
    """Refuses specs that cannot be read, right or wrong. Raises UsageError."""
    if has_errors(project.findings):
        first = project.findings[0]
        raise UsageError(f"the specs of {name} cannot be read: {place(first.span)}: {first.message}")
