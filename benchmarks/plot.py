"""Draws rows of benchmarks: how many times what we take the peers take, on a logarithmic axis."""

from __future__ import annotations

from pathlib import Path

import matplotlib as mpl

mpl.use("svg")
mpl.rcParams["svg.hashsalt"] = "fieldspec"  # so that the same rows are the same file
mpl.rcParams["svg.fonttype"] = "none"
mpl.rcParams["font.size"] = 8

from matplotlib import pyplot  # noqa: E402
from rows import Row  # noqa: E402

OURS, PEERS, GOAL = "#0b5fff", "#b04a00", "#777777"


def drawn(rows: list[Row], path: Path) -> None:
    """Writes the plot of the rows that have a peer, as SVG."""
    rows = [row for row in rows if row.ours > 0 and row.peers > 0]
    figure, axes = pyplot.subplots(figsize=(10, 0.22 * len(rows) + 1.2), layout="constrained")
    for at, row in enumerate(rows):
        axes.plot([1, row.peers / row.ours], [at, at], color="#cccccc", linewidth=1, zorder=1)
        if limit := _limit(row):
            axes.plot([limit], [at], "|", color=GOAL, markersize=9, zorder=2)
        axes.plot([row.peers / row.ours], [at], "o", color=PEERS, markersize=5, zorder=3)
    axes.axvline(1, color=OURS, linewidth=1.5, zorder=0)
    axes.set_xscale("log")
    axes.set_yticks(range(len(rows)), [f"{row.group}: {row.name} / {row.peer}" for row in rows])
    axes.set_ylim(len(rows) - 0.4, -0.6)
    axes.set_xlabel(
        "what the peer takes, in times of what we take (blue line: ours; tick: where the goal puts the peer)"
    )
    axes.grid(axis="x", which="major", color="#e5e5e5")
    figure.savefig(path, format="svg", metadata={"Date": None, "Creator": None})
    pyplot.close(figure)


def _limit(row: Row) -> float:
    """Where the goal puts the peer; 0 where there is none."""
    return row.at_least or (1 / row.at_most if row.at_most else 0)
