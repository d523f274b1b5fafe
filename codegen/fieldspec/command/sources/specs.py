"""Reads specs, and selects devices and versions. It imports the compiler; `spec_files` does not."""

from __future__ import annotations

from pathlib import Path

from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.command.console.streams import print_line
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.files import cache_folder, regular_file, storage
from fieldspec.command.sources import spec_files
from fieldspec.command.sources.spec_files import (
    FOLDER,
    VARIABLE,
    entry_key,
    files,
    installed_protocols,
    of_devices,
    origins,
    relative_path,
    split,
    with_protocols,
)
from fieldspec.language.checks.layout_conditions import has_layout
from fieldspec.language.diagnostics import Severity, has_errors, in_order
from fieldspec.language.reading.device_spec import JOINT, DeviceSpec
from fieldspec.language.reading.findings import LARGEST_FILE
from fieldspec.language.reading.project import Project, read
from fieldspec.language.schema import ADDRESS, PROJECT_ADDRESS, project_schema_text, schema_text

__all__ = [
    "FOLDER",
    "VARIABLE",
    "bring_project_schema",
    "bring_schema",
    "editor_line",
    "files",
    "folder",
    "layout_of",
    "origins",
    "picked",
    "project",
    "relative_path",
    "sound",
    "sound_at",
    "spec_at",
    "split",
    "unsound",
    "with_protocols",
    "writable_folder",
]


def folder(specs_option: str | None) -> Path:
    """The folder with the specs. Raises UsageError."""
    return Path(spec_files.folder(specs_option))


def writable_folder(specs_option: str | None) -> Path:
    """The folder with the specs, for a verb that writes there. Raises UsageError."""
    return Path(spec_files.writable_folder(specs_option))


def editor_line(levels: int = 1) -> str:
    """The line at the top of a spec file that leads editors to the schema, some levels of folders above the file."""
    return f"# yaml-language-server: $schema={'../' * levels}{ADDRESS}\n"


def bring_schema(folder: Path) -> None:
    """Writes the schema into a folder of specs, for editors, unless it is there as it is now. Raises UsageError."""
    _bring(folder / ADDRESS, schema_text())


def bring_project_schema(folder: Path) -> None:
    """Writes the schema of project files into a folder of specs in the same way. Raises UsageError."""
    _bring(folder / PROJECT_ADDRESS, project_schema_text())


def _bring(path: Path, text: str) -> None:
    content = text.encode("utf-8")
    try:
        if regular_file.content(path, LARGEST_FILE) == content:
            return
    except FileNotFoundError:
        pass
    except OSError as error:
        raise UsageError(f"cannot read {path}: {error.strerror}") from None
    storage.write(path, content)
    print_line(relative_path(path))


def project(specs_option: str | None, devices: frozenset[str] = frozenset()) -> Project:
    """The project in the folder with the specs. Raises UsageError for unknown devices."""
    return _read(*of_devices(specs_option, devices), devices)


def _read(path: str, contents: dict[str, bytes], devices: frozenset[str]) -> Project:
    return read(contents, devices, relative_path(path), origins(contents), installed_protocols)


def picked(spec: DeviceSpec, version: str) -> str:
    """The requested version, or the newest. Raises UsageError for an unknown one."""
    known = spec.versions()
    if not version:
        return known[-1]
    for part in version.split(JOINT):
        if part not in spec.lines.place and version not in known:
            raise unknown(f"version of {spec.id}", part, spec.lines.place or known)
    return version


def spec_at(specs_option: str | None, text: str) -> tuple[DeviceSpec, str]:
    """The spec of `DEVICE` or `DEVICE@VERSION`, and the version, for a verb that looks at the spec itself.

    The spec may have errors as long as it can be read. Raises UsageError.
    """
    name, version = split(text)
    read_specs = project(specs_option, frozenset([name]))
    if name not in read_specs.devices:
        raise unsound(name)
    spec = read_specs.devices[name]
    return spec, picked(spec, version)


def sound_at(specs_option: str | None, text: str) -> tuple[DeviceSpec, str]:
    """As `spec_at`, for a verb that reads, makes or answers frames: bytes of a spec with an error may be wrong.

    Raises UsageError, also where `check` has an error for the device at any of its versions.
    """
    name, version = split(text)
    path, contents = of_devices(specs_option, frozenset([name]))
    spec = sound(_read(path, contents, frozenset([name])), name, entry_key(name, contents))
    return spec, picked(spec, version)


SOUND = "sound"
"""The kind of cache entries for devices that have been judged without an error."""


def sound(project: Project, name: str, key: str = "") -> DeviceSpec:
    """The spec of a device for which `check` has no error. Raises UsageError.

    With a `key` in the cache, a device is judged once, unless packages decide what is right: the key says nothing of
    these.
    """
    from fieldspec.codec.layout.package_codecs import coded_facts
    from fieldspec.command.packages.plugin_loading import load_checks
    from fieldspec.language.checks.table import INSTALLED
    from fieldspec.tools.proofs.running import outcome

    spec = project.devices.get(name)
    if key and spec is not None and not has_errors(project.findings) and cache_folder.cached(SOUND, key) is not None:
        return spec
    load_checks()
    outcomes = [outcome(spec) for spec in project.devices.values()]
    findings = [*project.findings, *(finding for outcome in outcomes for finding in outcome.findings)]
    errors = sum(finding.severity is Severity.ERROR for finding in in_order(findings))
    if errors or spec is None:
        raise unsound(name, errors)
    layouts = (layout for outcome in outcomes for layout in outcome.layouts.values())
    if key and not INSTALLED and not any(True for layout in layouts for _ in coded_facts(layout)):
        cache_folder.store(SOUND, key, b"")
    return spec


def unsound(name: str, errors: int = 0) -> UsageError:
    """The error of a verb that cannot use a spec with errors; `errors` is their number where it is known."""
    number = f"{errors} errors" if errors > 1 else "1 error" if errors else "errors"
    return UsageError(f"the spec of {name} has {number}; see them with: fieldspec check {name}")


def layout_of(spec: DeviceSpec, version: str) -> DeviceLayout:
    """The layout of a device at a version. Raises UsageError for a spec with errors."""
    device, broken = spec.at(version)
    if has_errors(broken) or not has_layout(device):
        raise unsound(spec.id)
    return device_layout(device)
