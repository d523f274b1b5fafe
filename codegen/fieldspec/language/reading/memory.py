"""What reading remembers of files and devices, for a project that is read again and again."""

from __future__ import annotations

from collections.abc import Container

from fieldspec.foundation.classes import dataclass, field
from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.reading.building.context import Reused
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.nodes import Mapping
from fieldspec.language.reading.revision import revised
from fieldspec.language.reading.scalars import typed
from fieldspec.language.reading.unchanged_nodes import with_unchanged
from fieldspec.language.reading.yaml_reader import decoded, parsed

MOST_TURNS = 100
"""How often a device is reread before all objects of its model are created again."""


@dataclass(frozen=True, slots=True)
class FileRead:
    """A file as it was read: its bytes, its text, what is wrong with its text or else its nodes, and its typed tree.

    Where something is wrong, the tree is that of an earlier text, if there is one in memory.
    """

    data: bytes
    file: SourceFile
    unread: list[Diagnostic]
    findings: list[Diagnostic]
    tree: Mapping | None


@dataclass(frozen=True, slots=True)
class DeviceRead:
    """A device as it was read: its files and all protocol files, their results, and whether they have errors.

    The `trees` are those that its files gave, and `joined` are the findings of these together. `turns` counts the
    rereads since its objects were created.
    """

    files: dict[str, bytes]
    spec: DeviceSpec | None
    findings: list[Diagnostic]
    is_broken: bool
    turns: int = 0
    trees: dict[str, Mapping | None] = field(default_factory=dict)
    joined: list[Diagnostic] = field(default_factory=list)

    def has(self, trees: dict[str, Mapping | None], protocols: dict[str, bytes]) -> bool:
        """Whether it was read of these very trees and protocols."""
        known = {path: data for path, data in self.files.items() if path not in self.trees}
        same = trees.keys() == self.trees.keys() and all(trees[path] is self.trees[path] for path in trees)
        return same and known == protocols

    def reused(self) -> Reused:
        """The objects of the model that the next reading takes again; none now and then, so that old ones go."""
        return self.spec.reused if self.spec is not None and self.turns < MOST_TURNS else {}


@dataclass(frozen=True, slots=True)
class Memory:
    """What reading remembers for a project that is read again and again: what has not changed is not read again.

    For a file that cannot be used, the tree of its last valid text is used, so that the rest is checked all the same:
    findings and places in a text other than `files` belong to that text. A device is judged without a file that is new
    to it and has never been sound. If memory is `strict`, the findings equal the findings without it.
    """

    files: dict[str, FileRead] = field(default_factory=dict)
    devices: dict[str, DeviceRead] = field(default_factory=dict)
    strict: bool = False

    def forget_others(self, paths: Container[str]) -> None:
        """Forgets the files that are not there any more."""
        for path in [path for path in self.files if path not in paths]:
            del self.files[path]


def file_read(path: str, data: bytes, earlier: FileRead | None) -> FileRead:
    """A file as it is read; with the tree of an earlier text where something is wrong."""
    file, unread = decoded(path, data)
    before = earlier.tree if earlier is not None else None
    if unread:
        return FileRead(data, file, unread, [], before)
    if before is not None and file.path == before.file.path:
        tree = revised(file, before)
        if tree is not None:
            before.file.past = True
            return FileRead(data, file, [], [], tree)
    node, findings = parsed(file)
    if node is None and not findings:
        help = "write a section, or remove the file"
        findings = [Diagnostic("file_empty", "the file is empty", Span(file, 0, 0), help=help)]
    elif node is not None:
        result, type_findings = typed(node)
        findings += type_findings
        if isinstance(result, Mapping) and not findings:
            if before is not None:
                before.file.past = True
            return FileRead(data, file, [], [], with_unchanged(result, before))
    return FileRead(data, file, [], findings, before)
