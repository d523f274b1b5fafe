"""The values of a dump as evidence. All of them were read at one moment."""

from __future__ import annotations

from collections.abc import Collection

from fieldspec.audit.register_dump import DumpReport, DumpValue
from fieldspec.evidence.observables import READ, Observable, Observables
from fieldspec.evidence.series import SeriesValue
from fieldspec.evidence.unit_evidence import UnitEvidence


def add_dump(unit: UnitEvidence, observables: Observables, report: DumpReport, source: str, moment: int) -> None:
    """Adds the values of a dump."""
    by_name = {item.path: item for item in observables.registers.values()}
    for read in report.read:
        item = by_name.get(read.name)
        if item is None or item.fact.place.path != read.fact.place.path:
            item = observables.parameters.get(read.fact.place.path)
        place_text = f"{source}, row {read.rows[0]}"
        if item is not None and read.number is not None:
            _add(unit, item, read, place_text, moment)
    for entry in report.unknown:
        space = entry.space or observables.layout.device.space_name("")
        for offset, value in enumerate(entry.values):
            unit.add_unlisted(space, entry.address + offset, str(value), f"{source}, row {entry.row}")


def add_scan(unit: UnitEvidence, observables: Observables, space: str, refused: Collection[int]) -> None:
    """Adds the registers of a scan of which the unit has refused the first word."""
    for item in observables.registers.values():
        if item.space == space and item.address is not None and item.address in refused and item.access != "wo":
            unit.add_refusal(item, item.path, READ, "an exception")


def _add(unit: UnitEvidence, item: Observable, read: DumpValue, place_text: str, moment: int) -> None:
    number = read.number
    value: SeriesValue = number if isinstance(number, int | float) else read.text or str(number)
    unit.add(item, read.name, READ, value, moment, place_text)
    if read.unread:
        return
    if read.decoded.reason:
        unit.add_trouble(item, read.name, read.decoded.reason, str(value), place_text)
    elif read.spare:
        unit.add_trouble(item, read.name, "unlisted_bits", str(value), place_text)
    elif isinstance(number, int) and item.value.enum:
        enum = unit.layout.device.enums.get(item.value.enum)
        if enum is not None and enum.member(number) is None and item.value.sentinel(number) is None:
            unit.add_trouble(item, read.name, "unlisted_member", str(value), place_text)
