"""Errata, added to the rows of the facts that they are about."""

from __future__ import annotations

from fieldspec.facts.row import Row, row
from fieldspec.model.device import Device


def with_errata(device: Device, found: list[Row]) -> list[Row]:
    """The rows with every erratum at the innermost fact that it is about.

    A fact of which there is no row, because it does not hold for this version, gets one of the kind `fact`.
    """
    by_path: dict[str, int] = {}
    for number, listed in enumerate(found):
        by_path.setdefault(str(listed["path"]), number)
    for erratum in device.errata:
        path = erratum.fact
        while path and path not in by_path:
            path = path.rpartition("/")[0]
        if path not in by_path:
            path = erratum.fact
            by_path[path] = len(found)
            found.append(row("fact", path, erratum.sources, name=path.rpartition("/")[2]))
        held = found[by_path[path]]
        ids, before = held["errata"], held["printed"]
        assert isinstance(ids, list)
        added: Row = {"errata": [*ids, erratum.id]}
        if erratum.printed:
            added["printed"] = {**(before if isinstance(before, dict) else {}), **erratum.printed}
        found[by_path[path]] = {**held, **added}  # others may share the row
    return found
