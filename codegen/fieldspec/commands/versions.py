"""`fieldspec versions`: the versions of a device, and what depends on them."""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterator

from fieldspec.commands import specs
from fieldspec.commands.output import print_blocks
from fieldspec.reading.nodes import Mapping, Node, Scalar, children
from fieldspec.reading.project import DeviceSpec
from fieldspec.reading.versions import named
from fieldspec.render.blocks import Line, Table

_HEADINGS = ("version", "outputs", "based on", "facts since", "until", "only", "what is known of it")
_BOUNDS = ("since", "until", "only")


def run(arguments: argparse.Namespace) -> int:
    """Prints a table for each line, the oldest version first."""
    spec, version = specs.spec_at(arguments.specs, arguments.device)
    device, _ = spec.at(version)
    counts = {bound: Counter(_named(spec.tree, bound)) for bound in _BOUNDS}
    if not device.lines:
        print_blocks([Line(f"{device.name} has one version, {version}: its manual speaks of no other")])
        return 0
    for number, line in enumerate(device.lines):
        rows = [
            (
                held.id,
                "yes" if held.id in spec.versions() else "shared" if held.id in spec.lines.alike else "",
                spec.bases.get(held.id, ""),
                *(str(counts[bound][held.id] or "") for bound in _BOUNDS),
                held.doc or held.inferred or held.title,
            )
            for held in line.versions
        ]
        title = Line(line.title or line.name, "bold")
        print_blocks([*([Line("")] if number else []), title, Table(_HEADINGS, tuple(rows))])
    return 0


def _named(node: Node, bound: str) -> Iterator[str]:
    """The versions that a bound names, once for each fact that has it."""
    if isinstance(node, Mapping):
        yield from (held.text for held in named(node.values.get(bound)))
    for _, inner in children(node):
        if not isinstance(inner, Scalar):
            yield from _named(inner, bound)


def each(spec: DeviceSpec) -> list[str]:
    """Every version of a device on its own; of lines without outputs, which say what it is too, beside the newest."""
    built = spec.versions()
    others = [version for version in spec.lines.place if version not in built]
    return [*built, *(one if one in spec.lines.alike else f"{built[-1]}+{one}" for one in others)]
