"""What a process remembers that builds again and again."""

from __future__ import annotations

from fieldspec.foundation.classes import dataclass, field
from fieldspec.language.reading.memory import Memory
from fieldspec.targets.pieces import Pieces


@dataclass(frozen=True, slots=True)
class BuildMemory:
    """What was read, so that it is not read again, and the pieces of outputs, so that they are not made again."""

    reading: Memory = field(default_factory=lambda: Memory(strict=True))
    pieces: Pieces = field(default_factory=Pieces)
