"""Changes as Markdown: a table for each class, for reviews and release notes."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from fieldspec.render.blocks import visible_text
from fieldspec.render.changes import AcceptedChange, Difference, groups, places, remark, summary, title

_ENTITIES = {"&": "&amp;", "<": "&lt;", ">": "&gt;"}
_SPECIAL = re.compile(r"[&<>\\`*\[\]|~$!#]|(?<![0-9A-Za-z])_|_(?![0-9A-Za-z])|:(?=//)|@(?=\w)")


def rendered(differences: Sequence[Difference]) -> str:
    """The Markdown text."""
    return "\n".join(line for difference in differences for line in _lines(difference))


def _lines(difference: Difference) -> Iterator[str]:
    yield f"## {_text(title(difference))}\n"
    yield f"{summary(difference).capitalize()}.\n"
    for group in groups(difference):
        yield f"### {group.heading.capitalize()}\n"
        yield "| change | fact | what happened | where |"
        yield "|---|---|---|---|"
        yield from map(_row, group.changes)
        yield ""


def _row(entry: AcceptedChange) -> str:
    change, remark_text = entry.change, remark(entry)
    text = f"{change.message} ({remark_text})" if remark_text else change.message
    return f"| {_text(change.rule)} | {_text(change.path)} | {_text(text)} | {_text(places(change))} |"


def _text(text: str) -> str:
    """A text in which nothing is markup."""
    return _SPECIAL.sub(lambda match: _ENTITIES.get(match[0], "\\" + match[0]), visible_text(text))
