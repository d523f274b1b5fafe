"""One row a fact, for audits and other programs. The columns are documented in docs/facts.md and stable."""

from __future__ import annotations

from fieldspec.facts.codes import codes
from fieldspec.facts.errata import with_errata
from fieldspec.facts.memory import memory
from fieldspec.facts.row import COLUMNS, Cell, Row
from fieldspec.facts.texts import texts
from fieldspec.facts.wire import wire
from fieldspec.layout.device import DeviceLayout

__all__ = ["COLUMNS", "Cell", "Row", "rows"]


def rows(layout: DeviceLayout) -> list[Row]:
    """All facts of a device at one version, in the order of the spec's sections."""
    device = layout.device
    return with_errata(device, [*wire(layout), *memory(layout), *codes(device), *texts(layout)])
