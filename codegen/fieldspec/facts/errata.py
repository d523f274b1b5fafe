"""Errata, added to the rows of the facts that they are about."""

from __future__ import annotations

from fieldspec.facts.row import Row, row
from fieldspec.model.device import Device


def with_errata(device: Device, found: list[Row]) -> list[Row]:
    """The rows with every erratum at the innermost fact that it is about.

    A fact of which there is no row, because it does not hold for this version, gets one of the kind `fact`.
    """
    by_path: dict[str, Row] = {}
    for listed in found:
        by_path.setdefault(str(listed["path"]), listed)
    added: list[Row] = []
    for erratum in device.errata:
        path = erratum.fact
        while path and path not in by_path:
            path = path.rpartition("/")[0]
        held = by_path.get(path)
        if held is None:
            held = row("fact", erratum.fact, erratum.sources, name=erratum.fact.rpartition("/")[2])
            by_path[erratum.fact] = held
            added.append(held)
        ids = held["errata"]
        assert isinstance(ids, list)
        ids.append(erratum.id)
        if erratum.printed:
            before = held["printed"]
            held["printed"] = {**(before if isinstance(before, dict) else {}), **erratum.printed}
    return [*found, *added]
