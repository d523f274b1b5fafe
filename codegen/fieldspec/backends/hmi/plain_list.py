"""All codes as one table, for panels and programs of any maker."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.hmi.codes import lists
from fieldspec.layout.device import DeviceLayout
from fieldspec.spreadsheet import Cell

COLUMNS = (
    "kind",
    "list",
    "code",
    "hex",
    "number",
    "name",
    "printed_name",
    "text",
    "cause",
    "remedy",
    "label",
    "source",
    "identity",
)


def rows(layout: DeviceLayout) -> Iterator[tuple[Cell, ...]]:
    """The rows below the heading."""
    for _, codes in lists(layout.device):
        for code in codes:
            member = code.member
            yield (
                code.kind,
                code.list,
                member.value,
                f"0x{member.value:X}",
                member.number,
                member.name,
                member.printed_name or None,
                code.text,
                code.cause or None,
                code.remedy or None,
                member.label or None,
                "; ".join(source.text() for source in member.sources) or None,
                layout.identity,
            )
