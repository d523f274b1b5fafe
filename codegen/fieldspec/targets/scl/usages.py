"""How programs use the generated SCL."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.diagnostics import has_errors
from fieldspec.targets.controllers.structured import usages as structured
from fieldspec.targets.scl.project import declared_for_portal
from fieldspec.targets.usages import Usage, VersionUsages, spelling


def usages(versions: Sequence[DeviceLayout]) -> dict[str, VersionUsages]:
    """The code for the newest version of a device, which is the one that the output has."""
    layout = versions[-1]
    return {layout.device.version: VersionUsages("SCL", {}, spelling("scl", layout, partial(usage_rows, layout)))}


def usage_rows(layout: DeviceLayout) -> Iterator[Usage]:
    """The code that reads or writes each fact, with the names of the project; none where it cannot be."""
    declared = declared_for_portal(layout)
    for row in structured.usages(declared) if not has_errors(declared.findings) else ():
        yield Usage(*row)
