"""Changes as an HTML page without other files."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.templates import fill
from fieldspec.classes import dataclass
from fieldspec.render.changes import Difference, Group, groups, places, remark, summary, title


@dataclass(frozen=True, slots=True)
class _Row:
    rule: str
    path: str
    message: str
    remark: str
    old: str
    new: str
    places: str


@dataclass(frozen=True, slots=True)
class _Table:
    kind: str
    heading: str
    rows: list[_Row]


@dataclass(frozen=True, slots=True)
class _Section:
    title: str
    summary: str
    tables: list[_Table]


def rendered(differences: Sequence[Difference]) -> str:
    """The page. Texts of specs are escaped by the template."""
    sections = [
        _Section(title(difference), summary(difference), [_table(group) for group in groups(difference)])
        for difference in differences
    ]
    return fill("changes.html.j2", title=", ".join(section.title for section in sections), sections=sections)


def _table(group: Group) -> _Table:
    rows = [
        _Row(
            entry.change.rule,
            entry.change.path,
            entry.change.message,
            remark(entry),
            entry.change.old,
            entry.change.new,
            places(entry.change),
        )
        for entry in group.changes
    ]
    return _Table(group.effect.value if group.effect else "accepted", group.heading, rows)
