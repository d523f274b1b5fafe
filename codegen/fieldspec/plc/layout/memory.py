"""How controllers lay out memory: one row of facts each."""

from __future__ import annotations

from fieldspec.classes import dataclass


@dataclass(frozen=True, slots=True)
class Memory:
    """A model of memory. A value begins at a multiple of its size, or of `pack` where that is less.

    `order` is that of the bytes of a number. `composite` is the least alignment of arrays and structs in bytes, and
    `even` the multiple to which they are filled up beside their own alignment. `bits` says that BOOLs which follow
    each other share bytes; else each takes one.
    """

    name: str
    title: str
    order: str
    pack: int
    composite: int = 1
    even: int = 1
    bits: bool = False

    def aligned(self, at: int, to: int) -> int:
        """The next place from `at` on that is a multiple of an alignment."""
        return -(-at // to) * to


MEMORIES = {
    memory.name: memory
    for memory in (
        Memory("s7", "S7-300 to S7-1500, standard access", "big", 2, composite=2, even=2, bits=True),
        *(Memory(f"tc3:{pack}", f"TwinCAT 3 with pack_mode {pack}", "little", pack) for pack in (1, 2, 4, 8)),
        Memory("codesys", "CODESYS without pack_mode", "little", 8),
        Memory("c", "C of a little-endian machine, without packing", "little", 8),
    )
}
"""The models by the names that people give on the command line."""
