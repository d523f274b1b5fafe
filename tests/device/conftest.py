"""Each spec is read once for all tests of simulated devices; a TC100 that several tests use."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any

import pytest

from fieldspec.command.sources import specs
from fieldspec.testing import SimulatedDevice, simulation
from simulators import SPECS

_sound_at, _layout_of = cache(specs.sound_at), specs.layout_of
_layouts: dict[tuple[str, str], Any] = {}


def _cached_layout(spec: Any, version: str) -> Any:
    key = (spec.tree.file.path, version)
    if key not in _layouts:
        _layouts[key] = _layout_of(spec, version)
    return _layouts[key]


@pytest.fixture(autouse=True)
def read_specs_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(specs, "sound_at", _sound_at)
    monkeypatch.setattr(specs, "layout_of", _cached_layout)


@pytest.fixture
def tc100() -> Iterator[SimulatedDevice]:
    with simulation("tc100", ports={"rtu": "tcp://127.0.0.1:0"}, folder=SPECS) as device:
        yield device
