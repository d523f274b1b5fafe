"""Changes as text, JSON, Markdown and an HTML page."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from fieldspec.command.rendering.blocks import Block, Line
from fieldspec.command.rendering.changes import (
    AcceptedChange,
    Difference,
    Group,
    groups,
    places,
    remark,
    summary,
    title,
)
from fieldspec.foundation.html_text import clean
from fieldspec.foundation.line_text import visible_json, visible_text
from fieldspec.foundation.source import Span
from fieldspec.language.changes.change import Change, Effect
from fieldspec.targets.templates import fill

_TEXT_STYLES = {Effect.WIRE: "red", Effect.SOURCE: "red", Effect.BEHAVIOUR: "yellow", Effect.DOCS: "", None: "dim"}


def blocks(differences: Sequence[Difference]) -> Iterator[Block]:
    """Text for people: a part for each comparison, with a paragraph for each class."""
    for number, difference in enumerate(differences):
        if number:
            yield Line("")
        yield Line(f"{title(difference)}: {summary(difference)}", "bold")
        for group in groups(difference):
            yield Line("")
            yield Line(group.heading, _TEXT_STYLES[group.effect])
            for entry in group.changes:
                remark_text = remark(entry)
                yield Line(
                    f"  {entry.change.rule}: {entry.change.message}" + (f" ({remark_text})" if remark_text else "")
                )
                yield Line(f"    {entry.change.path}, {places(entry.change)}".rstrip(", "), "dim")


def json_text(differences: Sequence[Difference]) -> str:
    """JSON: a list of comparisons, each with its changes. Lines and columns count from 1.

    `accepted` is null where nothing accepts a change.
    """
    data = [
        {"old": difference.old, "new": difference.new, "changes": [_json_change(entry) for entry in difference.changes]}
        for difference in differences
    ]
    return visible_json(data, 1) + "\n"


def _json_change(entry: AcceptedChange) -> dict[str, object]:
    change, accepted = entry.change, entry.accepted
    return {
        "rule": change.rule,
        "class": change.effect.value,
        "breaking": change.effect.breaking,
        "kind": change.what,
        "path": change.path,
        "message": change.message,
        "old": change.old,
        "new": change.new,
        "before": _json_place(change.before),
        "after": _json_place(change.after),
        "outputs": list(change.outputs),
        "versions": list(entry.versions),
        "reason": change.reason or None,
        "accepted": {"reason": accepted.reason, "date": accepted.date} if accepted else None,
    }


def _json_place(span: Span | None) -> dict[str, object] | None:
    if span is None:
        return None
    line, column = span.position()
    return {"file": span.file.path, "line": line, "column": column}


_MARKDOWN_ENTITIES = {"&": "&amp;", "<": "&lt;", ">": "&gt;"}
_MARKDOWN_SPECIAL = re.compile(r"[&<>\\`*\[\]|~$!#]|(?<![0-9A-Za-z])_|_(?![0-9A-Za-z])|:(?=//)|@(?=\w)")


def markdown_text(differences: Sequence[Difference]) -> str:
    """Markdown: a table for each class, for reviews and release notes."""
    return "\n".join(line for difference in differences for line in _markdown_lines(difference))


def _markdown_lines(difference: Difference) -> Iterator[str]:
    yield f"## {_escape_markdown(title(difference))}\n"
    yield f"{summary(difference).capitalize()}.\n"
    for group in groups(difference):
        yield f"### {group.heading.capitalize()}\n"
        yield "| change | fact | what happened | where |"
        yield "|---|---|---|---|"
        yield from map(_markdown_row, group.changes)
        yield ""


def _markdown_row(entry: AcceptedChange) -> str:
    change, remark_text = entry.change, remark(entry)
    text = f"{change.message} ({remark_text})" if remark_text else change.message
    cells = (change.rule, change.path, text, places(change))
    return f"| {' | '.join(map(_escape_markdown, cells))} |"


def _escape_markdown(text: str) -> str:
    """A text in which nothing is markup."""
    return _MARKDOWN_SPECIAL.sub(lambda match: _MARKDOWN_ENTITIES.get(match[0], "\\" + match[0]), visible_text(text))


def html_page(differences: Sequence[Difference]) -> str:
    """An HTML page without other files. Texts of specs are escaped by the template."""
    sections = [
        (title(difference), summary(difference), [(group, _html_rows(group)) for group in groups(difference)])
        for difference in differences
    ]
    return fill("changes.html.j2", title=", ".join(clean(heading) for heading, _, _ in sections), sections=sections)


def _html_rows(group: Group) -> list[tuple[Change, str, str]]:
    return [(entry.change, remark(entry), places(entry.change)) for entry in group.changes]


_FORMATS = {"json": json_text, "markdown": markdown_text, "html": html_page}


def format_changes(differences: Sequence[Difference], form: str) -> str:
    """Changes as `json`, `markdown` or `html`."""
    return _FORMATS[form](differences)
