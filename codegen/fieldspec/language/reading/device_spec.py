"""A device as its spec has it, with all its versions."""

from __future__ import annotations

from collections.abc import Mapping as Table

from fieldspec.foundation.classes import dataclass, field
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.reading.building.context import Reused
from fieldspec.language.reading.building.device import built
from fieldspec.language.reading.findings import bounded
from fieldspec.language.reading.nodes import Mapping
from fieldspec.language.reading.unchanged_nodes import with_unchanged
from fieldspec.language.reading.versions import Lines, selected

JOINT = "+"
"""The separator of versions of different lines that are picked together."""


@dataclass(frozen=True, slots=True)
class DeviceSpec:
    """The joined tree of a device, with its protocols, before a version is picked.

    `trees` are the trees of the versions that are written as changes of others, `bases` the versions that they change.
    A version is the identifier of one, or of several of different lines with a `+` between them. `files` are the paths
    of all files that it was read from, including protocols. `earlier` has the trees that were kept when the device was
    read before: for each version, and with each misprint. `reused` and the following attributes cache results.
    """

    id: str
    tree: Mapping
    lines: Lines
    trees: Table[str, Mapping]
    bases: Table[str, str]
    files: frozenset[str]
    earlier: Table[str, Mapping] = field(default_factory=dict, repr=False, compare=False)
    reused: Reused = field(default_factory=dict, repr=False, compare=False)
    picked: dict[str, Mapping] = field(default_factory=dict, repr=False, compare=False)
    built: dict[str, tuple[Device, list[Diagnostic]]] = field(default_factory=dict, repr=False, compare=False)

    def versions(self) -> list[str]:
        """The versions that outputs are written for, the oldest first."""
        return self.lines.versions()

    def at(self, version: str) -> tuple[Device, list[Diagnostic]]:
        """The model at one version."""
        if version not in self.built:
            device, findings = built(self.tree_at(version), version, self.reused)
            self.built[version] = device, bounded(findings)
        return self.built[version]

    def tree_at(self, version: str) -> Mapping:
        """The tree with the facts of one version."""
        if version not in self.picked:
            picked = tuple(version.split(JOINT))
            whole = next((self.trees[identifier] for identifier in picked if identifier in self.trees), self.tree)
            tree = selected(whole, picked, self.lines)
            assert isinstance(tree, Mapping)
            self.with_earlier_nodes(version, tree)
        return self.picked[version]

    def with_earlier_nodes(self, name: str, tree: Mapping) -> Mapping:
        """A tree with the unchanged nodes of the tree of the same name when the device was read before."""
        self.picked[name] = with_unchanged(tree, self.earlier.get(name))
        return self.picked[name]
