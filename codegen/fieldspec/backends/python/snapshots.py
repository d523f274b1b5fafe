"""How a word of flags tells all its bits at once: those of one byte come from a table, in one step."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from fieldspec.model.flags import Bit

LEAST = 3
"""Single bits of one byte from which on the table is faster than a test of each."""


def from_tables(named: Sequence[tuple[Bit, str]]) -> tuple[list[str], frozenset[str]]:
    """Lines that bind bits of `raw` to locals of their names, and which bits those are."""
    lines: list[str] = []
    bound: set[str] = set()
    single = {bit.first: name for bit, name in named if bit.width == 1}
    for start in range(0, max(single, default=0) + 1, 8):
        names = [single.get(place) for place in range(start, start + 8)]
        taken = [name for name in names if name]
        if len(taken) >= LEAST:
            lines.append(f"{_targets(names)} = _BITS_OF[{f'raw >> {start}' if start else 'raw'} & 255]")
            bound.update(taken)
    return lines, frozenset(bound)


def _targets(names: Iterable[str | None]) -> str:
    return ", ".join(name or "_" for name in names)
