"""The outputs of a process that builds repeatedly, with all that was read of the devices that they were made of."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.observation import is_same_device, read_of_layout
from fieldspec.command.builds.freshness import Hashes
from fieldspec.foundation.classes import dataclass, field
from fieldspec.language.model.choice import BlockChoice
from fieldspec.language.reading.memory import Memory
from fieldspec.targets.pieces import Pieces
from fieldspec.targets.usages import Rows


@dataclass(frozen=True, slots=True)
class _Basis:
    """A version of a device as an output has read it."""

    identity: str
    equal_versions: tuple[str, ...]
    blocks: BlockChoice | None
    attributes: dict[str, object]

    def applies(self, layout: DeviceLayout) -> bool:
        """Whether the output would read the same of another layout."""
        return (self.identity, self.equal_versions, self.blocks) == (
            layout.identity,
            layout.equal_versions,
            layout.blocks,
        ) and is_same_device(self.attributes, layout.device)


@dataclass(frozen=True, slots=True)
class RememberedOutput:
    """The hashes of an output's files, and the code for facts that it has spelled, by version.

    `request` has everything that it was made of except the devices.
    """

    request: object
    bases: tuple[_Basis, ...]
    hashes: Hashes
    spellings: dict[str, Rows]


class RememberedOutputs:
    """The outputs by device and name."""

    def __init__(self) -> None:
        self._outputs: dict[tuple[str, str], RememberedOutput] = {}

    def unchanged(
        self,
        device: str,
        name: str,
        request: object,
        layouts: Sequence[DeviceLayout],
        hash_of: Callable[[str], str | None],
    ) -> RememberedOutput | None:
        """An output that was made of the same, and whose files are as they were written; else None."""
        output = self._outputs.get((device, name))
        if output is None or output.request != request or len(output.bases) != len(layouts):
            return None
        if not all(basis.applies(layout) for basis, layout in zip(output.bases, layouts, strict=True)):
            return None
        return output if all(hash_of(path) == expected for path, expected in output.hashes.items()) else None

    def remember(
        self,
        device: str,
        name: str,
        request: object,
        layouts: Sequence[DeviceLayout],
        hashes: Hashes,
        spellings: dict[str, Rows],
    ) -> None:
        """Remembers an output that was made of observed layouts."""
        bases = tuple(
            _Basis(layout.identity, layout.equal_versions, layout.blocks, read_of_layout(layout)) for layout in layouts
        )
        self._outputs[device, name] = RememberedOutput(request, bases, hashes, spellings)


@dataclass(frozen=True, slots=True)
class BuildMemory:
    """Parsed files, outputs, and pieces of outputs, for reuse in the next build."""

    reading: Memory = field(default_factory=lambda: Memory(strict=True))
    outputs: RememberedOutputs = field(default_factory=RememberedOutputs)
    pieces: Pieces = field(default_factory=lambda: Pieces(remembered=True))
