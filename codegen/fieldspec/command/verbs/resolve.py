"""`fieldspec resolve`: the complete spec of a version, with the place of each value."""

from __future__ import annotations

import argparse

from fieldspec.command.console.streams import print_document
from fieldspec.command.rendering.resolved import resolved
from fieldspec.command.sources import specs
from fieldspec.foundation.classes import replace
from fieldspec.language.reading.nodes import Mapping, Sequence

# Keys whose content the tree contains already, expanded; read again, it would be expanded twice.
_EXPANDED = {"registers": "copies", "enums": "derived"}


def run(arguments: argparse.Namespace) -> int:
    """Prints the spec as YAML: with protocols, overlays and copies, and only the facts of the version.

    Raises UsageError.
    """
    spec, version = specs.spec_at(arguments.specs, arguments.device)
    # What the versions state of their changes is in the tree, applied.
    tree = spec.tree_at(version).without("uses").without("changes")
    for section, key in _EXPANDED.items():
        section_items = tree.values.get(section)
        if isinstance(section_items, Sequence):
            items = tuple(item.without(key) if isinstance(item, Mapping) else item for item in section_items.items)
            tree = tree.with_value(section, replace(section_items, items=items))
    print_document(resolved(tree))
    return 0
