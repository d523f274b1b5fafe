"""Compiled devices: the layouts that verbs use which do not judge a spec, kept from one call to the next.

What is kept is found by a hash of the compiler, of the device and version that are asked for, and of every byte of the
spec files that they are read from, so that it never is that of another spec.
"""

from __future__ import annotations

from fieldspec.classes import TYPE_CHECKING
from fieldspec.commands import caching, sources
from fieldspec.commands.layout_json import from_json
from fieldspec.source import SourceFile

if TYPE_CHECKING:
    import argparse

    from fieldspec.layout.device import DeviceLayout

KIND = "devices"
MARK = b"\xef\xbb\xbf"
"""What some editors write in front of UTF-8."""


def asked(arguments: argparse.Namespace) -> DeviceLayout:
    """The layout of the device that the arguments of a verb name."""
    return layout(arguments.specs, arguments.device, arguments.no_cache)


def layout(given: str | None, text: str, anew: bool = False) -> DeviceLayout:
    """The layout of `DEVICE` or `DEVICE@VERSION`; `anew` says to look at nothing that is kept, and to keep nothing."""
    name, version = sources.split(text)
    path, held = sources.of_devices(given, frozenset([name]))
    files = {one: content for one, content in held.items() if not one.endswith(f"/{sources.INDEX}")}
    folder = sources.relative_path(path)

    def source(path: str) -> SourceFile:
        return SourceFile(f"{folder}/{path}" if folder else path, files[path].removeprefix(MARK).decode())

    key = "" if anew else _key(text, files)
    content = caching.cached(KIND, key) if key else None
    if content is not None:
        try:
            kept: DeviceLayout = from_json(content, source)
            return kept
        except ValueError:
            pass  # somebody else has written it
    content = _compiled(name, version, files)
    if key:
        caching.store(KIND, key, content)
    made: DeviceLayout = from_json(content, source)
    return made


def _key(text: str, files: dict[str, bytes]) -> str:
    """Under which name a compiled device is kept; empty where the compiler cannot be told."""
    try:
        named = [one for path, content in files.items() for one in (path.encode(), content)]
        return caching.checksum(caching.state().encode(), text.encode(), *named)
    except OSError:
        return ""


def _compiled(name: str, version: str, files: dict[str, bytes]) -> bytes:
    """A device as it is kept."""
    from fieldspec.commands.layout_json import to_json
    from fieldspec.commands.specs import layout_of, picked, unsound
    from fieldspec.diagnostics import has_errors
    from fieldspec.reading.project import read

    project = read(files, frozenset([name]))
    if name not in project.devices or has_errors(project.findings):
        raise unsound(name)
    spec = project.devices[name]
    return to_json(layout_of(spec, picked(spec, version)))
