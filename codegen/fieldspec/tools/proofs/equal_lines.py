"""Version lines that are equal on the wire to a line with outputs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.codec.layout.device import device_layout
from fieldspec.foundation.caches import ObjectsKey
from fieldspec.language.checks.layout_conditions import has_layout
from fieldspec.language.diagnostics import Diagnostic, has_errors
from fieldspec.language.model.device import Device
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.nodes import identity, mappings


def equal_versions(spec: DeviceSpec, identities: Mapping[str, str]) -> dict[str, str]:
    """By version of a line that is `like` another one, the version whose outputs it shares; empty where none is equal.

    `identities` maps the versions with outputs to the identities of their layouts.
    """
    equal = {}
    known = {_wire(spec.at(version)[0]): own for version, own in identities.items()}
    for version, line in spec.lines.alike.items():
        device, broken = spec.at(version)
        if has_errors(broken):
            continue
        own = known.get(_wire(device))
        if own is None:
            if not has_layout(device):
                continue
            own = device_layout(device).identity
        same = [other for other in _members(spec, line.text) if identities.get(other) == own]
        equal[version] = same[0] if same else ""
    return equal


def _wire(device: Device) -> ObjectsKey:
    """All objects that can decide what is on the wire. Versions share those that do not differ."""
    sections = (
        device.links,
        device.messages,
        device.records,
        device.enums,
        device.flags,
        device.tables,
        device.parameters,
        device.signals,
        device.conversions,
    )
    return ObjectsKey((*(content for contents in sections for content in contents.values()), *device.groups))


def _members(spec: DeviceSpec, line: str) -> list[str]:
    lines = (line_node for line_node in mappings(spec.tree.values.get("versions")) if identity(line_node) == line)
    return [identity(member) or "" for line_node in lines for member in mappings(line_node.values.get("members"))]


def lines_alike(spec: DeviceSpec, shared: Mapping[str, str]) -> Iterator[Diagnostic]:
    """A finding for every version that equals no version of the line that its own line is `like`.

    `shared` is the result of `equal_versions`.
    """
    for version, other in shared.items():
        if not other:
            line = spec.lines.alike[version]
            text = f"on the wire, `{version}` differs from every version of the line `{line.text}`"
            help = "build separate outputs for the line of this version, or correct the bounds in which the two differ"
            yield Diagnostic("lines_alike", text, line.span, help=help)
