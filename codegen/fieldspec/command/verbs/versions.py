"""`fieldspec versions`: the versions of a device and what depends on them."""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterator

from fieldspec.command.console.terminal import print_blocks
from fieldspec.command.rendering.blocks import Line, Table
from fieldspec.command.sources import specs
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, children
from fieldspec.language.reading.versions import named

_HEADINGS = ("version", "outputs", "based on", "facts since", "until", "only", "what is known of it")
_BOUNDS = ("since", "until", "only")


def run(arguments: argparse.Namespace) -> int:
    """Prints a table for each line, the oldest version first. Raises UsageError."""
    spec, version = specs.spec_at(arguments.specs, arguments.device)
    device, _ = spec.at(version)
    counts = {bound: Counter(_named(spec.tree, bound)) for bound in _BOUNDS}
    if not device.lines:
        print_blocks([Line(f"{device.name} has one version, {version}: its manual mentions no other")])
        return 0
    for number, line in enumerate(device.lines):
        rows = [
            (
                version.id,
                "yes" if version.id in spec.versions() else "shared" if version.id in spec.lines.alike else "",
                spec.bases.get(version.id, ""),
                *(str(counts[bound][version.id] or "") for bound in _BOUNDS),
                version.doc or version.inferred or version.title,
            )
            for version in line.versions
        ]
        title = Line(line.title or line.name, "bold")
        print_blocks([*([Line("")] if number else []), title, Table(_HEADINGS, tuple(rows))])
    return 0


def _named(node: Node, bound: str) -> Iterator[str]:
    """The versions that a bound names, once for each fact with that bound."""
    if isinstance(node, Mapping):
        yield from (scalar.text for scalar in named(node.values.get(bound)))
    for _, inner in children(node):
        if not isinstance(inner, Scalar):
            yield from _named(inner, bound)


def each(spec: DeviceSpec) -> list[str]:
    """Every version of a device; versions of lines without outputs are joined with the newest version."""
    built = spec.versions()
    other_versions = [version for version in spec.lines.place if version not in built]
    return [*built, *(other if other in spec.lines.alike else f"{built[-1]}+{other}" for other in other_versions)]
