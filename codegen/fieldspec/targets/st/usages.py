"""How programs use the generated Structured Text."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.diagnostics import has_errors
from fieldspec.targets.controllers.structured import usages as structured
from fieldspec.targets.controllers.structured.program import declared_in_text, newest
from fieldspec.targets.usages import Usage, VersionUsages


def usages(versions: Sequence[DeviceLayout]) -> dict[str, VersionUsages]:
    """The code for the newest version of a device, which is the one that the output has."""
    layout = newest(versions)
    declared = declared_in_text(layout)
    rows = () if has_errors(declared.findings) else tuple(Usage(*row) for row in structured.usages(declared))
    return {layout.device.version: VersionUsages("Structured Text", {}, rows)}
