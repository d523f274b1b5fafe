"""How programs use the generated Structured Text."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.diagnostics import has_errors
from fieldspec.targets.controllers.structured import usages as structured
from fieldspec.targets.controllers.structured.program import declared_in_text, newest
from fieldspec.targets.usages import Usage, VersionUsages, spelling


def usages(versions: Sequence[DeviceLayout]) -> dict[str, VersionUsages]:
    """The code for the newest version of a device, which is the one that the output has."""
    layout = newest(versions)
    rows = spelling("st", layout, partial(usage_rows, layout))
    return {layout.device.version: VersionUsages("Structured Text", {}, rows)}


def usage_rows(layout: DeviceLayout) -> Iterator[Usage]:
    """The code that reads or writes each fact, with the names of the program; none where there is no program."""
    declared = declared_in_text(layout)
    for row in structured.usages(declared) if not has_errors(declared.findings) else ():
        yield Usage(*row)
