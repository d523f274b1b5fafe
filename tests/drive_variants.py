"""Variants of the made-up drive: some lines of its spec are changed, and the Python module is generated from it."""

from __future__ import annotations

from collections.abc import Sequence
from types import ModuleType

from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.reading.project import read
from layouts import TEST_SPECS
from python_package import module_apart

NAME = "glider-x/device.yaml"


def drive_variant(name: str, changes: Sequence[tuple[str, str]]) -> tuple[DeviceLayout, ModuleType]:
    """The layout and the Python module of the drive without its examples; a change is an old text and a new one."""
    text = (TEST_SPECS / NAME).read_text(encoding="utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    text = text[: text.index("\nexamples:")] + "\n"
    device, findings = read({NAME: text.encode()}).devices["glider-x"].at("1.1")
    assert not has_errors(findings), findings[0].message
    layout = device_layout(device)
    return layout, module_apart(layout, f"glider_{name}")
