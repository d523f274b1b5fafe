"""What an audit looks at."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.audit.manual_index import ManualIndex
from fieldspec.classes import dataclass
from fieldspec.facts import Row
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.device import Device
from fieldspec.proofs.errata import Proof
from fieldspec.proofs.running import Outcome
from fieldspec.reading.project import DeviceSpec


@dataclass(frozen=True, slots=True)
class Subject:
    """A device at one version: its spec as written, its layout, and the proofs of its errata, those of all versions.

    `layouts` are those of all versions that are built, the oldest first, `facts` the rows of each of them. `recorded`
    is the index of the manual that stands beside the spec, `manual` that of the text at hand; either may be missing.
    `known` is what running everything on the device has given, where that has happened.
    """

    spec: DeviceSpec
    layout: DeviceLayout
    layouts: Sequence[DeviceLayout]
    facts: Sequence[Sequence[Row]]
    proofs: Sequence[Proof] = ()
    recorded: ManualIndex | None = None
    manual: ManualIndex | None = None
    known: Outcome | None = None

    @property
    def device(self) -> Device:
        """The model of the device."""
        return self.layout.device
