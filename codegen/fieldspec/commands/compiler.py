"""What the compiler itself is made of, as a hash: with another compiler, nothing that it made before is fresh."""

from __future__ import annotations

import hashlib
import os
import sys
from importlib.machinery import PathFinder
from pathlib import Path

LIBRARIES = {
    "construct": "construct",
    "jinja2": "jinja2",
    "jsonschema_rs": "jsonschema_rs",
    "markupsafe": "markupsafe",
    "openpyxl": "openpyxl",
    "yaml": "pyyaml",
}
"""The libraries that outputs and findings depend on: what is imported, and the name of the distribution."""


def identity() -> str:
    """A hash of every file of the compiler, of the versions of its libraries, and of Python.

    It is that of the files as they are on disk now. Raises OSError where they cannot be read.
    """
    made = hashlib.sha256(f"{sys.version}\n{sys.flags.optimize}\n".encode())
    package = Path(__file__).resolve().parent.parent
    for path in _files(package):
        content = path.read_bytes()
        made.update(f"{path.relative_to(package)} {len(content)}\n".encode())
        made.update(content)
    for module, distribution in LIBRARIES.items():
        made.update(f"{module} {_version(module, distribution)}\n".encode())
    return made.hexdigest()


def _files(package: Path) -> list[Path]:
    """All files of the compiler but those that Python makes of them, in order."""
    found = []
    for folder, inner, names in os.walk(package, onerror=_raised):
        inner[:] = sorted(name for name in inner if name not in ("__pycache__", "_specs"))
        found += [Path(folder, name) for name in sorted(names) if not name.endswith((".pyc", ".pyo"))]
    return found


def _raised(error: OSError) -> None:
    raise error


def _version(module: str, distribution: str) -> str:
    """The version of a library: the name of the folder that its installer left beside it, or its first file."""
    spec = PathFinder.find_spec(module)
    if spec is None or not spec.origin:
        return ""
    here = Path(spec.origin)
    around = here.parent.parent if here.name.startswith("__init__.") else here.parent
    for name in sorted(os.listdir(around)):
        plain = name.lower().replace("-", "_")
        if plain.startswith(f"{distribution}_") and plain.endswith("_info"):
            return name
    return hashlib.sha256(here.read_bytes()).hexdigest()
