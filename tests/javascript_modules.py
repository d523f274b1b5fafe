"""The generated JavaScript of a device that no build has written."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.targets.js.declaration import Names
from fieldspec.targets.js.module import declarations, module_texts
from fieldspec.targets.js.naming import module_scope


def module_code(layout: DeviceLayout) -> str:
    """The module of a version."""
    return module_texts(layout, declarations(Names(layout, module_scope())))[0]
