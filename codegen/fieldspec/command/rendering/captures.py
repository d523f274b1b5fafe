"""The summary of bulk decoding as text."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.command.rendering.blocks import Block, Line, Table

_NOT_FAULTS = ("ok",)


def summary_blocks(
    totals: Mapping[str, Mapping[str, int]], files: int, parts: int, faults: Mapping[str, str]
) -> Iterator[Block]:
    """The result of a run: the share of the decoded bytes, and everything that could not be decoded, by reason.

    `totals` are counts by kind, `faults` the files that could not be read with the reason of each.
    """
    frames, sizes = totals["frames"], totals["bytes_of"]
    total_size = sum(sizes.values())
    share = f"{100 * sizes.get('ok', 0) / total_size:.2f} %" if total_size else "none"
    counts = (
        _number_of(files, "file"),
        _number_of(sum(frames.values()), "frame"),
        _number_of(sum(totals["values"].values()), "value"),
        _number_of(parts, "part"),
    )
    yield Line(", ".join(counts), "bold")
    yield Line(f"valid: {share} of {total_size:,} bytes on the line")
    wrong = [(reason, frames[reason], sizes.get(reason, 0)) for reason in frames if reason not in _NOT_FAULTS]
    if wrong:
        rows = tuple((reason, f"{count:,}", f"{size:,}") for reason, count, size in wrong)
        yield Table(("not valid", "frames", "bytes"), rows)
    odd = [(reason, count) for reason, count in totals["values"].items() if reason not in _NOT_FAULTS]
    if odd:
        yield Table(("values", "number"), tuple((reason, f"{count:,}") for reason, count in odd))
    if totals["units"]:
        units = sorted(totals["units"].items(), key=lambda item: int(item[0]))
        yield Table(("unit address", "valid frames"), tuple((unit, f"{count:,}") for unit, count in units))
    for counter, count in (*totals["counters"].items(), *(("clock: " + key, n) for key, n in totals["clock"].items())):
        if count:
            yield Line(f"{counter}: {count:,}", "yellow")
    for name, fault in faults.items():
        yield Line(f"{name} could not be read: {fault}", "red")


def _number_of(number: int, noun: str) -> str:
    return f"{number:,} {noun}{'' if number == 1 else 's'}"
