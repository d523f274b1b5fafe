"""The choices of a project: outputs, versions and folders."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from fieldspec.foundation.classes import dataclass

PROJECT_FILE = "fieldspec.yaml"
"""The name of the project file, beside the folder of the specs."""
DEFAULT_FOLDER = "generated"
ALL, NEWEST, NONE = "all", "newest", "none"


@dataclass(frozen=True, slots=True)
class VersionChoice:
    """Which versions: all, the newest of each line, none, or those with the `identifiers`."""

    word: str = ALL
    identifiers: tuple[str, ...] = ()

    def includes(self, version: str, newest: Collection[str]) -> bool:
        """Whether a version is chosen; `newest` are those that are the newest of their lines."""
        if self.identifiers:
            return version in self.identifiers
        return self.word == ALL or (self.word == NEWEST and version in newest)


@dataclass(frozen=True, slots=True)
class OutputChoice:
    """The versions of an output, and those with self-tests and fuzz targets, of headers in C."""

    versions: VersionChoice = VersionChoice()
    tests: VersionChoice = VersionChoice()


@dataclass(frozen=True, slots=True)
class BlockChoice:
    """The blocks of a controller's program: tasks, messages, registers, groups and tables by name, on some links.

    Without `links`, all links have them.
    """

    tasks: tuple[str, ...] = ()
    messages: tuple[str, ...] = ()
    registers: tuple[str, ...] = ()
    links: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Choice:
    """The chosen outputs of a device. `outputs` is None for all of them, and `versions` is the choice of any other.

    `blocks` is None for all blocks of controllers.
    """

    outputs: Mapping[str, OutputChoice] | None = None
    versions: VersionChoice = VersionChoice()
    folder: str = DEFAULT_FOLDER
    blocks: BlockChoice | None = None

    def of(self, output: str) -> OutputChoice:
        """The choice of an output, also of one that is not among them."""
        return (self.outputs or {}).get(output) or OutputChoice(self.versions)
