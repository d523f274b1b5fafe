"""The generated Python code of a device, imported from its texts: the framers of all streams of bytes come from it."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from functools import cache
from importlib import import_module
from importlib.abc import InspectLoader, MetaPathFinder
from importlib.machinery import ModuleSpec
from importlib.util import spec_from_loader
from itertools import count
from types import ModuleType
from typing import Any, Protocol

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.targets.python.backend import PACKAGE, files, shared

_numbers = count()
_modules: dict[tuple[str, str, str], ModuleType] = {}
"""The modules that have been imported, by device, version and identity."""


class Framer(Protocol):
    """Cuts bytes into frames like the framers of generated code."""

    dropped: int

    def feed(self, data: bytes) -> list[bytes]:
        """The frames that some bytes complete."""

    def idle(self) -> list[bytes]:
        """The frames in the bytes so far, after a silence."""

    def pause(self) -> list[bytes]:
        """The frames that `idle` would return. It drops nothing."""

    @property
    def ends_with_silence(self) -> bool:
        """Whether a silence may show a frame in the bytes so far."""

    def reset(self) -> None:
        """Drops all bytes so far."""


class _Texts(MetaPathFinder, InspectLoader):
    """Imports the modules of one package from their texts. The package has a name of its own, so that several can be
    imported, and none takes the place of an installed one."""

    def __init__(self, texts: Mapping[str, str], name: str) -> None:
        self.texts = {
            path.removesuffix(".py").removesuffix("/__init__").replace("/", ".").replace(PACKAGE, name, 1): text
            for path, text in texts.items()
            if path.endswith(".py")
        }
        self.packages = {
            path.removesuffix("/__init__.py").replace("/", ".").replace(PACKAGE, name, 1)
            for path in texts
            if path.endswith("/__init__.py")
        }

    def find_spec(self, fullname: str, path: Any, target: ModuleType | None = None) -> ModuleSpec | None:
        """The spec of a module of the package; None for any other module."""
        if fullname not in self.texts:
            return None
        return spec_from_loader(fullname, self, is_package=fullname in self.packages)

    def get_source(self, fullname: str) -> str:
        """The source text of a module."""
        return self.texts[fullname]

    def is_package(self, fullname: str) -> bool:
        """Whether a module is a package."""
        return fullname in self.packages


def device_module(layout: DeviceLayout) -> ModuleType:
    """The generated module of a device at a version, imported once."""
    key = (layout.device.id, layout.device.version, layout.identity)
    if key not in _modules:
        _modules[key] = _imported(layout)
    return _modules[key]


def _imported(layout: DeviceLayout) -> ModuleType:

    name = f"{PACKAGE}_{next(_numbers)}"
    own = files([layout])
    finder = _Texts({**shared(), **own}, name)
    module = next(path for path in own if not path.endswith("__init__.py"))
    sys.meta_path.append(finder)
    try:
        return import_module(module.removesuffix(".py").replace("/", ".").replace(PACKAGE, name, 1))
    finally:
        sys.meta_path.remove(finder)


def framer(module: ModuleType, link: str, direction: str) -> Framer | None:
    """A framer of a link; None where the frames of the link come whole and need none."""
    make = _framer_class(module, link, direction)
    return make() if make is not None else None


@cache
def _framer_class(module: ModuleType, link: str, direction: str) -> Callable[[], Framer] | None:
    return getattr(link_codec(module, link), f"{direction}_framer", None)


def link_codec(module: ModuleType, link: str) -> Any:
    """The object of a link in a generated module; None where it has none."""
    return next((item for name, item in vars(module).items() if name.lower().strip("_") == link.lower()), None)
