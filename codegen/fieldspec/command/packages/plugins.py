"""Outputs, checks, protocols and codecs of installed packages, which declare them as entry points.

The environment is searched once; the cache folder remembers what was there, so that a run without any plug-in loads
nothing for them. `plugin_loading` imports their code, when an output or a check of theirs is first used.
"""

from __future__ import annotations

import json
import os
import re
import sys
from importlib.util import find_spec

from fieldspec.command.console.usage import UsageError
from fieldspec.command.files import cache_folder
from fieldspec.command.files.regular_file import content
from fieldspec.foundation.classes import TYPE_CHECKING, attributes, dataclass

if TYPE_CHECKING:
    from collections.abc import Collection, Iterator
    from importlib.machinery import ModuleSpec
    from importlib.metadata import Distribution, EntryPoint

OUTPUTS, CHECKS, PROTOCOLS, CODECS = GROUPS = (
    "fieldspec.outputs",
    "fieldspec.checks",
    "fieldspec.protocols",
    "fieldspec.codecs",
)
KINDS = {OUTPUTS: "output", CHECKS: "check", PROTOCOLS: "protocol", CODECS: "codec"}
KIND = "plugins"
LARGEST_FILE = 64 << 20
"""Bytes of one file of a plug-in."""
FAILURES = (Exception, SystemExit)
"""What code of a package may raise. An end of the program would otherwise pass for the end of the verb."""
_NAME = re.compile("[a-z][a-z0-9_]*")
_SKIPPED = ("__pycache__",)


@dataclass(frozen=True, slots=True)
class Plugin:
    """One entry point: its group and name, the module or object that it refers to, and the package it comes from."""

    group: str
    name: str
    value: str
    package: str
    version: str

    def error(self, reason: str) -> UsageError:
        """The error that says why the plug-in cannot be used."""
        subject = f"the {KINDS[self.group]} {self.name} of the installed package {self.package} {self.version}"
        return UsageError(f"{subject} cannot be used: {' '.join(reason.split())}")

    def failed(self, error: BaseException) -> UsageError:
        """That code of the plug-in has raised an exception."""
        return self.error(f"{type(error).__name__}: {error}")


def plugins(group: str, reserved: Collection[str], anew: bool = False) -> dict[str, Plugin]:
    """The plug-ins of a group by name. Raises UsageError for a name that is `reserved`, malformed, or declared twice.

    With `anew`, the cache folder is neither read nor written.
    """
    result: dict[str, Plugin] = {}
    for plugin in _installed(anew):
        if plugin.group != group:
            continue
        if plugin.name in reserved:
            raise plugin.error(
                f"fieldspec has its own {KINDS[group]} {plugin.name}; the package must choose another name"
            )
        if not _NAME.fullmatch(plugin.name):
            raise plugin.error("a name begins with a small letter, and has small letters, digits and underscores")
        if (other := result.get(plugin.name)) is not None:
            raise plugin.error(f"the package {other.package} has one of this name; uninstall one of the packages")
        result[plugin.name] = plugin
    return result


_known: dict[str, tuple[Plugin, ...]] = {}
"""The installed plug-ins, by the state of the import folders."""


def _installed(anew: bool) -> tuple[Plugin, ...]:
    """All plug-ins, ordered by group, name and package."""
    try:
        state = cache_folder.state(())
    except OSError:
        return _searched()
    if state not in _known:
        stored = None if anew else _stored(state)
        _known[state] = _searched() if stored is None else stored
        if stored is None and not anew:
            rows = [[getattr(plugin, name) for name in attributes(Plugin)] for plugin in _known[state]]
            cache_folder.store(KIND, state, json.dumps(rows).encode())
    return _known[state]


def _stored(state: str) -> tuple[Plugin, ...] | None:
    """The result of an earlier run; None where nothing is stored, or another program has written it."""
    content = cache_folder.cached(KIND, state)
    try:
        rows = json.loads(content or b"")
        if not isinstance(rows, list) or not all(
            isinstance(row, list) and all(isinstance(text, str) for text in row) for row in rows
        ):
            return None
        return tuple(Plugin(*row) for row in rows)
    except (ValueError, TypeError, RecursionError):
        return None


def _searched() -> tuple[Plugin, ...]:
    from importlib.metadata import distributions

    rows = set()
    folders = sys.path[1:]  # the first is the folder of the script, or the current one
    for distribution in distributions(path=folders):
        if not _entries(distribution):
            continue  # reading the name as well would take longer than all else
        package = distribution.metadata["Name"]
        imported = next(iter(distributions(name=package, path=folders)), distribution)  # an older copy may be after
        for entry in _entries(imported):
            rows.add((entry.group, entry.name, entry.value, package, imported.version))
    return tuple(Plugin(*row) for row in sorted(rows))


def _entries(distribution: Distribution) -> list[EntryPoint]:
    """The entry points for fieldspec of an installed package. Raises UsageError where they cannot be read."""
    try:
        return [entry for entry in distribution.entry_points if entry.group in GROUPS]
    except Exception as error:
        text = distribution.read_text("entry_points.txt") or ""
        if not any(f"[{group}]" in text for group in GROUPS):
            return []  # what is wrong with it is no matter of ours
        package = f"{distribution.metadata['Name']} {distribution.version}"
        reason = f"each line of entry_points.txt is `name = module` ({' '.join(str(error).split())})"
        raise UsageError(f"the entry points of the installed package {package} cannot be read: {reason}") from None


def package_hashes(anew: bool = False) -> dict[str, str]:
    """The version of every package with plug-ins, and a hash of its files, by the name of the package.

    Raises UsageError for a package whose files cannot be read.
    """
    contents: dict[str, list[bytes]] = {}
    versions = {}
    for plugin in _installed(anew):
        versions[plugin.package] = plugin.version
        parts = contents.setdefault(plugin.package, [])
        parts.append(f"{plugin.group} {plugin.name} {plugin.value}".encode())
        try:
            for name, path in _files(plugin):
                parts += [name.encode("utf-8", "surrogateescape"), content(path, LARGEST_FILE)]
        except OSError as error:
            raise plugin.error(f"cannot read {error.filename}: {error.strerror}") from None
    return {name: f"{versions[name]} {cache_folder.checksum(*parts)}" for name, parts in sorted(contents.items())}


def _files(plugin: Plugin) -> Iterator[tuple[str, str]]:
    """The files of the top-level package, or the module, that a plug-in is in: names below it, and paths."""
    top = re.split(r"[.:]", plugin.value, maxsplit=1)[0]
    spec = _module_spec(plugin, top)
    for folder in spec.submodule_search_locations or ():
        for inner, folders, names in os.walk(folder):
            folders[:] = sorted(name for name in folders if name not in _SKIPPED)
            for name in sorted(names):
                path = os.path.join(inner, name)
                yield os.path.relpath(path, folder).replace(os.sep, "/"), path
    if not spec.submodule_search_locations and spec.origin:
        yield top, spec.origin


def _module_spec(plugin: Plugin, name: str) -> ModuleSpec:
    """Where a module is. Raises UsageError where there is none."""
    try:
        spec = find_spec(name)
    except FAILURES as error:  # the package around it may raise anything
        raise plugin.failed(error) from None
    if spec is None:
        raise plugin.error(f"there is no module {name}")
    return spec


def protocol_paths(reserved: Collection[str]) -> dict[str, str]:
    """The files of the protocols of installed packages, by name. Raises UsageError."""
    paths = {}
    for name, plugin in plugins(PROTOCOLS, reserved).items():
        spec = _module_spec(plugin, plugin.value)
        file = f"{name}.yaml"
        candidates = [os.path.join(folder, file) for folder in spec.submodule_search_locations or ()]
        path = next(filter(os.path.lexists, candidates), None)
        if path is None:
            raise plugin.error(f"the package {plugin.value} has no file {file}")
        paths[name] = path
    return paths
