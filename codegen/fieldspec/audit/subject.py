"""What an audit looks at."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from fieldspec.facts import Row
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.device import Device
from fieldspec.reading.project import DeviceSpec


@dataclass(frozen=True, slots=True)
class Subject:
    """A device at one version: its spec as written, its layout, and its facts, one row each."""

    spec: DeviceSpec
    layout: DeviceLayout
    facts: Sequence[Row]

    @property
    def device(self) -> Device:
        """The model of the device."""
        return self.layout.device
