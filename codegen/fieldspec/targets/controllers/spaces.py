"""Address spaces whose registers functions for programmable controllers do not convert."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import replace
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic
from fieldspec.language.model.address_space import BYTE
from fieldspec.targets.controllers.dialects import Dialect


def with_supported_spaces(layout: DeviceLayout, dialect: Dialect) -> tuple[DeviceLayout, list[Diagnostic]]:
    """The layout without the groups of registers in spaces of bytes, and a finding for each of these."""
    device, findings = layout.device, []
    for group in device.groups:
        if device.space(group.space).unit == BYTE:
            text = f"an address of the registers in {group.name} is a byte; there are no functions for that in "
            text += dialect.title
            findings.append(Diagnostic("plc_spaces_supported", text, group.place["group"], help=LEAVE_OUT))
    if not findings:
        return layout, []
    groups = tuple(group for group in device.groups if device.space(group.space).unit != BYTE)
    registers = tuple(register for register in layout.registers if register.register.unit_size > 1)
    return replace(layout, device=replace(device, groups=groups), registers=registers), findings
