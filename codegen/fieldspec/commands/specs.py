"""Finds the specs' folder, reads its files, and picks devices and versions."""

from __future__ import annotations

import os
from pathlib import Path

from fieldspec.checks.records_finite import records_finite
from fieldspec.checks.references_resolve import references_resolve
from fieldspec.checks.repeat_last import repeat_last
from fieldspec.commands.usage import UsageError, unknown
from fieldspec.diagnostics import has_errors
from fieldspec.layout.device import DeviceLayout, device_layout
from fieldspec.model.device import Device
from fieldspec.reading.project import JOINT, MAIN, PROTOCOLS, VERSIONS, DeviceSpec, Project, read

FOLDER = "specs"
VARIABLE = "FIELDSPEC_SPECS"


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
    """The spec files below a folder by relative path; of all devices' folders, or of `only` some."""
    found: dict[str, bytes] = {}
    try:
        for file in sorted([*path.glob("*/*.yaml"), *path.glob(f"*/{VERSIONS}/*.yaml")]):
            inner = file.relative_to(path)
            hidden = file.name.startswith(".")  # what editors leave beside a file
            if not hidden and (not only or inner.parts[0] in only or inner.parts[0] == PROTOCOLS):
                found[inner.as_posix()] = file.read_bytes()
    except OSError as error:
        raise UsageError(f"cannot read {error.filename}: {error.strerror}") from None
    return found


def project(given: str | None, devices: frozenset[str] = frozenset()) -> Project:
    """The project in the specs' folder; devices that are asked for must be there."""
    path = folder(given)
    known = {file.parent.name for file in path.glob(f"*/{MAIN}")}
    for device in sorted(devices - known):
        raise unknown("device", device, known)
    if not known:
        raise UsageError(f"the folder {path} holds no device; a device is a folder with a {MAIN}")
    return read(files(path, devices), devices, shown(path))


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


def picked(spec: DeviceSpec, version: str) -> str:
    """The version that is asked for, or the newest."""
    known = spec.versions()
    if not version:
        return known[-1]
    for one in version.split(JOINT):
        if one not in spec.lines.place and version not in known:
            raise unknown(f"version of {spec.id}", one, spec.lines.place)
    return version


def spec_at(given: str | None, text: str) -> tuple[DeviceSpec, str]:
    """The spec of `DEVICE` or `DEVICE@VERSION` and the version, for verbs that look at the spec as it is written."""
    name, version = split(text)
    found = project(given, frozenset([name]))
    if name not in found.devices:
        raise UsageError(f"the spec of {name} has findings; see them with: fieldspec check {name}")
    spec = found.devices[name]
    return spec, picked(spec, version)


def layout(given: str | None, text: str) -> DeviceLayout:
    """The layout of `DEVICE` or `DEVICE@VERSION`, for verbs that use a spec and do not judge it."""
    name, version = split(text)
    found = project(given, frozenset([name]))
    if name not in found.devices or has_errors(found.found):
        raise UsageError(f"the spec of {name} has findings; see them with: fieldspec check {name}")
    spec = found.devices[name]
    return laid(spec, picked(spec, version))


def laid(spec: DeviceSpec, version: str) -> DeviceLayout:
    """The layout of a device at a version."""
    device, broken = spec.at(version)
    if has_errors(broken) or not _sound(device):
        raise UsageError(f"the spec of {spec.id} has findings; see them with: fieldspec check {spec.id}")
    return device_layout(device)


def _sound(device: Device) -> bool:
    """Whether a device can be laid out: what it names is there, and its records end."""
    return not any(True for check in (references_resolve, records_finite, repeat_last) for _ in check(device))
