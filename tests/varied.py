"""The made-up drive with some lines of its spec changed, and the Python module of that."""

from __future__ import annotations

from collections.abc import Sequence
from types import ModuleType

from fieldspec.diagnostics import has_errors
from fieldspec.layout.device import DeviceLayout, device_layout
from fieldspec.reading.project import read
from laid_out import MADE_UP
from python_package import module_apart

NAME = "glider-x/device.yaml"


def varied(name: str, changes: Sequence[tuple[str, str]]) -> tuple[DeviceLayout, ModuleType]:
    """The drive without its examples, with what is old in each change replaced by what is new."""
    text = (MADE_UP / NAME).read_text(encoding="utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    text = text[: text.index("\nexamples:")] + "\n"
    device, found = read({NAME: text.encode()}).devices["glider-x"].at("1.1")
    assert not has_errors(found), found[0].message
    layout = device_layout(device)
    return layout, module_apart(layout, f"glider_{name}")
