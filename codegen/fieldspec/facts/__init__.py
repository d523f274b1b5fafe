"""One row a fact, for audits and other programs. The columns are documented in docs/facts.md and stable."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.facts.codes import codes
from fieldspec.facts.errata import with_errata
from fieldspec.facts.memory import memory
from fieldspec.facts.row import COLUMNS, Cell, Kept, Row
from fieldspec.facts.texts import texts
from fieldspec.facts.wire import wire
from fieldspec.layout.device import DeviceLayout

__all__ = ["COLUMNS", "Cell", "Row", "of_versions", "rows"]


def rows(layout: DeviceLayout) -> list[Row]:
    """All facts of a device at one version, in the order of the spec's sections."""
    return of_versions([layout])[0]


def of_versions(layouts: Sequence[DeviceLayout]) -> list[list[Row]]:
    """All facts of a device at each of some versions. Rows that these share are the same objects, and nobody's own."""
    kept = Kept()
    return [
        with_errata(
            layout.device,
            [*wire(layout), *memory(layout, kept), *codes(layout.device, kept), *texts(layout, kept)],
        )
        for layout in layouts
    ]
