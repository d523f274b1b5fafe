"""What an audit looks at."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from fieldspec.audit.manual_index import ManualIndex
from fieldspec.classes import dataclass, field
from fieldspec.diagnostics import Diagnostic
from fieldspec.facts import Row
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.device import Device
from fieldspec.proofs.errata import Proof
from fieldspec.reading.project import DeviceSpec


@dataclass(frozen=True, slots=True)
class Subject:
    """A device at one version: its spec as written, its layout, and the proofs of its errata, those of all versions.

    `layouts` are those of all versions that are built, the oldest first, `facts` the rows of each of them. `recorded`
    is the index of the manual that stands beside the spec, `manual` that of the text at hand; either may be missing.
    `findings` are those of versions whose checks have run already.
    """

    spec: DeviceSpec
    layout: DeviceLayout
    layouts: Sequence[DeviceLayout]
    facts: Sequence[Sequence[Row]]
    proofs: Sequence[Proof] = ()
    recorded: ManualIndex | None = None
    manual: ManualIndex | None = None
    findings: Mapping[str, Sequence[Diagnostic]] = field(default_factory=dict)

    @property
    def device(self) -> Device:
        """The model of the device."""
        return self.layout.device
