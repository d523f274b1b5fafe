"""The memory of a process that builds repeatedly."""

from __future__ import annotations

from fieldspec.command.builds.remembered_outputs import RememberedOutputs
from fieldspec.foundation.classes import dataclass, field
from fieldspec.language.reading.memory import Memory
from fieldspec.targets.pieces import Pieces


@dataclass(frozen=True, slots=True)
class BuildMemory:
    """Parsed files, outputs, and pieces of outputs, for reuse in the next build."""

    reading: Memory = field(default_factory=lambda: Memory(strict=True))
    outputs: RememberedOutputs = field(default_factory=RememberedOutputs)
    pieces: Pieces = field(default_factory=lambda: Pieces(remembered=True))
