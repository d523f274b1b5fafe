"""The check of a frame is computed in another way, or over other parts, or a length counts other parts.

Why: each side refuses the frames of the other.

Example: `algorithm: sum8` that becomes `algorithm: lrc`, or `counts: {plus: 2}` that becomes `counts: {plus: 3}`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.model.link import Part


def check_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Part):
        old, new = pair.old.algorithm, pair.new.algorithm
        if old != new:
            text = f"{named(pair.new)}: {turned('the algorithm', old, new)}"
            yield change("check_changed", Effect.WIRE, pair, "algorithm", text, old, new)
        old, new = _counted(pair.old), _counted(pair.new)
        if old != new:
            check = "check" in (pair.old.role, pair.new.role)
            what, key = ("what it covers", "covers") if check else ("what it counts", "counts")
            yield change(
                "check_changed", Effect.WIRE, pair, key, f"{named(pair.new)}: {turned(what, old, new)}", old, new
            )


def _counted(part: Part) -> str:
    """`words from command to body plus 2`, or `from command to body`"""
    span = part.span
    words = [f"from {span.first}"] if span.first else []
    words += [f"to {span.last}"] if span.last else []
    if part.role == "check":
        return " ".join(words) or "all before it"
    counted = " ".join(["words" if part.unit_size == 2 else "bytes", *(words or ["of the frame"])])
    return f"{counted} {'plus' if part.plus > 0 else 'minus'} {abs(part.plus)}" if part.plus else counted
