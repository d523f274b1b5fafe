"""The rows of benchmarks: what was measured, of us and of a peer. README.md describes their form."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass


@dataclass(frozen=True)
class Row:
    """One measurement. `ratio` is ours by the peer's; `goal` is the most that the ratio may be, None where there is none."""

    name: str
    ours: float
    unit: str
    peer: float | None = None
    peer_name: str = ""
    peer_version: str = ""
    goal: float | None = None
    note: str = ""

    @property
    def ratio(self) -> float | None:
        """Ours by the peer's."""
        return None if self.peer is None or self.peer == 0 else self.ours / self.peer

    @property
    def met(self) -> bool | None:
        """Whether the goal is met, None where there is none."""
        return None if self.goal is None or self.ratio is None else self.ratio <= self.goal


def print_rows(benchmark: str, rows: list[Row]) -> None:
    """Prints the rows, one JSON object a line."""
    for row in rows:
        held = {"benchmark": benchmark, **asdict(row), "ratio": row.ratio, "met": row.met}
        print(json.dumps({key: round(one, 4) if isinstance(one, float) else one for key, one in held.items()}))
