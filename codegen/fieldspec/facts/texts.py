"""Facts without bytes: lookup tables, limits, notes, examples, and errata beside the facts that they correct."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from fieldspec.facts.row import FactRow, SharedRows, of_fact, row
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.device import Device
from fieldspec.model.texts import Lookup


def texts(layout: DeviceLayout, shared: SharedRows) -> Iterator[FactRow]:
    """The rows of look-up tables, limits, notes, examples and versions."""
    device = layout.device
    for lookup in device.lookups:
        yield from shared.rows(lookup, partial(_lookup, lookup))
    yield from _limits(device)
    for note in device.notes:
        yield row("note", note.place.path, note.sources, name=note.name, label=note.title)
    yield from _examples(layout)
    yield from _versions(device)


def _lookup(lookup: Lookup) -> Iterator[FactRow]:
    yield from of_fact("lookup", lookup)
    for number, line in enumerate(lookup.rows):
        first = line.cells[0] if line.cells else None
        cells: FactRow = {
            "name": f"{lookup.name}_{number + 1}",
            "label": " | ".join("" if cell is None else str(cell) for cell in line.cells),
            "code": first if isinstance(first, int) and not isinstance(first, bool) else None,
        }
        yield row(lookup.kind, line.place.path, line.sources or lookup.sources, **cells)


def _limits(device: Device) -> Iterator[FactRow]:
    for limit in device.limits:
        low = limit.low if limit.value is None else limit.value
        high = limit.high if limit.value is None else limit.value
        yield from of_fact(limit.kind, limit, unit=limit.unit, min=low, max=high, ranges=limit.text)


def _examples(layout: DeviceLayout) -> Iterator[FactRow]:
    for example in layout.device.examples.values():
        message = layout.messages.get(example.message)
        code = message.message.code if message else None
        cells: FactRow = {
            "code": message.message.number if message and code is None else code,
            "bytes": len(example.frame),
            "name": example.id,
            "printed_name": example.frame.hex(" ").upper(),
            "label": example.title,
            "direction": example.direction,
        }
        yield row("example", example.place.path, example.sources, **cells)


def _versions(device: Device) -> Iterator[FactRow]:
    for line in device.lines:
        for version in line.versions:
            path = f"versions/{line.name}/{version.id}"
            yield row("version", path, version.sources, name=version.id, label=version.title)


def with_errata(device: Device, rows: list[FactRow]) -> list[FactRow]:
    """The rows with every erratum at the innermost fact that it is about.

    A fact of which there is no row, because it does not hold for this version, gets one of the kind `fact`.
    """
    by_path: dict[str, int] = {}
    for number, fact_row in enumerate(rows):
        by_path.setdefault(str(fact_row["path"]), number)
    for erratum in device.errata:
        path = erratum.fact
        while path and path not in by_path:
            path = path.rpartition("/")[0]
        if path not in by_path:
            path = erratum.fact
            by_path[path] = len(rows)
            rows.append(row("fact", path, erratum.sources, name=path.rpartition("/")[2]))
        held = rows[by_path[path]]
        ids, before = held["errata"], held["printed"]
        assert isinstance(ids, list)
        added: FactRow = {"errata": [*ids, erratum.id]}
        if erratum.printed:
            added["printed"] = {**(before if isinstance(before, dict) else {}), **erratum.printed}
        rows[by_path[path]] = {**held, **added}  # others may share the row
    return rows
