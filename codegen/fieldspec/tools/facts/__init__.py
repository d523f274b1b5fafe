"""One row for each fact, for audits and other programs. docs/facts.md documents the columns, which are stable."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.tools.facts.memory import memory
from fieldspec.tools.facts.row import COLUMNS, Cell, FactRow, SharedRows
from fieldspec.tools.facts.texts import texts, with_errata
from fieldspec.tools.facts.wire import codes, wire

__all__ = ["COLUMNS", "Cell", "FactRow", "of_versions", "rows"]


def rows(layout: DeviceLayout) -> list[FactRow]:
    """All facts of a device at one version, in the order of the spec's sections."""
    return of_versions([layout])[0]


def of_versions(layouts: Sequence[DeviceLayout]) -> list[list[FactRow]]:
    """The facts of a device at several versions, which share the rows of what they share. A row must not be changed."""
    shared = SharedRows()
    return [
        with_errata(
            layout.device,
            [*wire(layout), *memory(layout, shared), *codes(layout.device, shared), *texts(layout, shared)],
        )
        for layout in layouts
    ]
