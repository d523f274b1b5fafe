"""Changes as text for people, and in a short form for tests."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from fieldspec.changes.change import Change, Effect
from fieldspec.render.blocks import Block, Line, visible_text
from fieldspec.render.changes import Difference, groups, places, remark, summary, title

_STYLES = {Effect.WIRE: "red", Effect.SOURCE: "red", Effect.BEHAVIOUR: "yellow", Effect.DOCS: "", None: "dim"}


def blocks(differences: Sequence[Difference]) -> Iterator[Block]:
    """A part for each comparison, with a paragraph for each class: the rule, the change, and its place."""
    for number, difference in enumerate(differences):
        if number:
            yield Line("")
        yield Line(f"{title(difference)}: {summary(difference)}", "bold")
        for group in groups(difference):
            yield Line("")
            yield Line(group.heading, _STYLES[group.effect])
            for entry in group.changes:
                remark_text = remark(entry)
                yield Line(
                    f"  {entry.change.rule}: {entry.change.message}" + (f" ({remark_text})" if remark_text else "")
                )
                yield Line(f"    {entry.change.path}, {places(entry.change)}".rstrip(", "), "dim")


def concise(changes: Iterable[Change]) -> str:
    """Two lines a change: class, rule, path and message; then the values, the places and the outputs."""
    text = ""
    for change in changes:
        text += visible_text(f"{change.effect.value} {change.rule} {change.path}: {change.message}") + "\n"
        values = f"{change.old or '-'} -> {change.new or '-'}"
        outputs = f"; {', '.join(change.outputs)}" if change.outputs else ""
        text += visible_text(f"  {values}; {places(change)}{outputs}") + "\n"
    return text
