"""What a user wants to compare: a version, a folder of specs, or a git revision."""

from __future__ import annotations

from pathlib import Path

from fieldspec.classes import dataclass
from fieldspec.commands import specs
from fieldspec.commands.usage import UsageError, unknown
from fieldspec.diagnostics import has_errors
from fieldspec.model.device import Device
from fieldspec.reading.folders import MAIN, PROTOCOLS
from fieldspec.reading.project import DeviceSpec, Project, read
from fieldspec.render.text import place


@dataclass(frozen=True, slots=True)
class Side:
    """One side of a comparison, by the name that the user gave it.

    `device` and `version` are empty where all are meant. `wide` says that it is a state of specs, not a version.
    """

    name: str
    project: Project
    device: str
    version: str
    wide: bool

    def spec(self, device: str) -> DeviceSpec:
        """The spec of a device, which must be there."""
        if device not in self.project.devices:
            raise UsageError(f"{self.name} holds no device {device}; there are {', '.join(self.project.devices)}")
        return self.project.devices[device]

    def at(self, device: str, version: str) -> Device:
        """A device at a version. Its spec must be one that can be read."""
        spec = self.spec(device)
        model, found = spec.at(specs.picked(spec, version))
        _sound(self.name, Project({}, found))
        return model

    def label(self, device: str, version: str = "") -> str:
        """How this side is called for a device, at a version or at several."""
        at = f"@{version}" if version else ""
        if not self.wide:
            return f"{device}{at}"
        if self.device:
            return self.name if self.version else f"{self.name}{at}"
        return f"{self.name} {device}{at}"


def side(text: str, given: str | None, plain: bool) -> Side:
    """The side that `DEVICE[@VERSION]`, `FOLDER[@VERSION]` or `REVISION[:FOLDER][@VERSION]` means, tried in this order.

    With `plain`, the files of a revision are shown by their paths in the repository, without the revision.
    """
    try:
        here: Path | None = specs.folder(given)
    except UsageError:
        if given:
            raise
        here = None
    name, version = specs.split(text)
    if here is not None and (here / name / MAIN).is_file() and "/" not in name and name not in ("", ".", ".."):
        return _named(text, specs.project(given, frozenset([name])), name, version)
    for path, picked in ((text, ""), text.rpartition("@")[::2]):
        if path and Path(path).is_dir():
            return _folder(text, Path(path), picked)
    from fieldspec.commands.revisions import NoRevision

    try:
        return _revision(text, here, plain)
    except NoRevision:
        if here is not None and name and version and "{" not in version:
            raise unknown("device", name, (file.parent.name for file in here.glob(f"*/{MAIN}"))) from None
        raise


def _named(text: str, project: Project, device: str, version: str) -> Side:
    _sound(text, project)
    if device not in project.devices:
        raise UsageError(f"the spec of {device} has findings; see them with: fieldspec check {device}")
    return Side(text, project, device, specs.picked(project.devices[device], version), wide=False)


def _folder(text: str, path: Path, version: str) -> Side:
    """A folder of specs, that of one device, or one with the folder `specs` in it."""
    device = ""
    if (path / MAIN).is_file():
        path = path.resolve()
        device, path = path.name, path.parent
    elif not any(path.glob(f"*/{MAIN}")) and any(path.glob(f"{specs.FOLDER}/*/{MAIN}")):
        path = path / specs.FOLDER
    if not any(path.glob(f"*/{MAIN}")):
        raise UsageError(f"the folder {text} holds no specs; a device is a folder with a {MAIN}")
    only = frozenset([device]) if device else frozenset[str]()
    files = _of_devices(specs.files(path, only))
    return _wide(text, read(files, only, specs.shown(path)), device, version)


def _revision(text: str, here: Path | None, plain: bool) -> Side:
    from fieldspec.commands.revisions import tree

    name, version = text, ""
    before, joint, after = text.rpartition("@")
    if joint and before and not after.startswith("{"):
        name, version = before, after
    revision, colon, path = name.partition(":")
    if not revision:
        raise UsageError(f"there is no device, no folder and no git revision {text}")
    found = tree(revision, path.strip("/") if colon else None, here)
    folder = found.path if plain else f"{revision}:{found.path}"
    only = frozenset([found.device]) if found.device else frozenset[str]()
    return _wide(text, read(_of_devices(found.files), only, folder), found.device, version)


def _of_devices(files: dict[str, bytes]) -> dict[str, bytes]:
    """Spec files without those of folders that are no device, or none yet."""
    folders = {path.partition("/")[0] for path in files if path.partition("/")[2] == MAIN} | {PROTOCOLS}
    return {path: held for path, held in files.items() if path.partition("/")[0] in folders}


def _wide(text: str, project: Project, device: str, version: str) -> Side:
    _sound(text, project)
    return Side(text, project, device, version, wide=True)


def _sound(name: str, project: Project) -> None:
    """Refuses specs that cannot be read; whether they are right is not asked."""
    if has_errors(project.found):
        first = project.found[0]
        raise UsageError(f"the specs of {name} cannot be read: {place(first.span)}: {first.message}")
