"""What the compiler itself is made of, as a hash: with another compiler, nothing that it made before is fresh."""

from __future__ import annotations

import os
import sys
from importlib.machinery import PathFinder

from fieldspec.classes import TYPE_CHECKING
from fieldspec.commands.caching import checksum

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

LIBRARIES = {
    "construct": "construct",
    "jinja2": "jinja2",
    "jsonschema_rs": "jsonschema_rs",
    "markupsafe": "markupsafe",
    "openpyxl": "openpyxl",
    "xlsxwriter": "xlsxwriter",
    "yaml": "pyyaml",
}
"""The libraries that outputs and findings depend on: what is imported, and the name of the distribution."""


LAYING_OUT = (
    *("checks", "commands", "layout", "model", "reading", "schema"),
    *("classes.py", "diagnostics.py", "names.py", "reserved.py", "source.py"),
)
"""What takes part when the specs of a device become its layout."""
WHOLE = ("",)
"""All of the compiler."""

_PACKAGE = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
_OTHERS = ("__pycache__", "_specs")
"""Folders of the package that are not of the compiler."""


def identity() -> str:
    """A hash of every file of the compiler, of the versions of its libraries, and of Python.

    It is that of the files as they are on disk now. Raises OSError where they cannot be read.
    """
    contents = [_python()]
    for path in _files(_PACKAGE):
        with open(path, "rb") as file:
            contents += [os.path.relpath(path, _PACKAGE).encode(), file.read()]
    contents += [f"{module} {_version(module, distribution)}".encode() for module, distribution in LIBRARIES.items()]
    return checksum(*contents)


def state(parts: Sequence[str] = LAYING_OUT) -> str:
    """A hash of the names, sizes and times of some files of the compiler, of the folders of libraries, and of Python.

    It is another one whenever one of them is, and takes a tenth of the time of `identity`; that it is another one may
    mean no more than that files were copied. Raises OSError where they cannot be looked at.
    """
    lines: list[str] = []
    for name in parts:
        path = os.path.join(_PACKAGE, name)
        lines += _states(path, name) if os.path.isdir(path) else [_state(name, os.stat(path))]
    for folder in sys.path[1:]:  # the first is that of the script, or the current one
        if os.path.isdir(folder):
            lines.append(f"{folder} {os.stat(folder).st_mtime_ns}")
    return checksum(_python(), "\n".join(lines).encode("utf-8", "surrogateescape"))


def _python() -> bytes:
    return f"{sys.version} {sys.flags.optimize}".encode()


def _states(folder: str, within: str) -> Iterator[str]:
    with os.scandir(folder) as entries:
        for entry in sorted(entries, key=lambda one: one.name):
            if entry.is_dir():
                if entry.name not in _OTHERS:
                    yield from _states(entry.path, f"{within}/{entry.name}")
            else:
                yield _state(f"{within}/{entry.name}", entry.stat())


def _state(name: str, held: os.stat_result) -> str:
    return f"{name} {held.st_size} {held.st_mtime_ns} {held.st_ctime_ns} {held.st_ino}"


def _files(package: str) -> list[str]:
    """All files of the compiler but those that Python makes of them, in order."""
    found = []
    for folder, inner, names in os.walk(package, onerror=_raised):
        inner[:] = sorted(name for name in inner if name not in _OTHERS)
        found += [os.path.join(folder, name) for name in sorted(names) if not name.endswith((".pyc", ".pyo"))]
    return found


def _raised(error: OSError) -> None:
    raise error


def _version(module: str, distribution: str) -> str:
    """The version of a library: the name of the folder that its installer left beside it, or its first file."""
    spec = PathFinder.find_spec(module)
    if spec is None or not spec.origin:
        return ""
    around, name = os.path.split(spec.origin)
    around = os.path.dirname(around) if name.startswith("__init__.") else around
    for name in sorted(os.listdir(around)):
        plain = name.lower().replace("-", "_")
        if plain.startswith(f"{distribution}_") and plain.endswith("_info"):
            return name
    with open(spec.origin, "rb") as file:
        return checksum(file.read())
