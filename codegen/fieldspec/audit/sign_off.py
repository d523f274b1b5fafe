"""The section of the report about sign-off: who has compared which section with the manual, and what changed since."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.audit.review import Review, Reviewed, Since, reviewed, reviews, states, uncited
from fieldspec.audit.section import Cell, Figure, Section, SectionTable
from fieldspec.audit.sourcing import section_order
from fieldspec.audit.subject import Subject

_SAYS = (
    "Who has compared which section of the manual with the spec, and which of its facts have been added or say "
    "something else since. A correction after a review is no fault: it is what a next reader should look at first."
)


def sign_off(subject: Subject) -> Section:
    """The reviews of each section."""
    found, wrong = reviews(subject.spec)
    now = states(subject.facts)
    held = sorted(reviewed(now, found, subject.device.manual.sha256), key=lambda one: section_order(one.section))
    compared = [one for one in held if one.reviews]
    same = [one for one in compared if one.reviews[0][1].same]
    twice = [one for one in compared if len({review.by for review, _ in one.reviews}) > 1]
    figures = (
        Figure("sections compared with the manual", len(compared), len(held), len(compared) == len(held)),
        Figure("sections compared by two readers or more", len(twice), len(held)),
        Figure("sections as they were when last compared", len(same), len(compared)),
    )
    tables = (_readings(found), _sections(held), _changed(held))
    return Section("sign_off", "Sign-off", (_SAYS,), figures, tables, (*wrong, *uncited(now, found)))


def _readings(found: Sequence[Review]) -> SectionTable:
    rows = tuple(
        (one.by, one.date, len(one.sections), one.edition or None, one.manual[:12], one.doc, one.place["by"])
        for one in found
    )
    columns = ("by", "date", "sections", "edition", "manual", "how", "spec")
    return SectionTable("readings", "Readings", columns, rows)


def _sections(held: Sequence[Reviewed]) -> SectionTable:
    rows: list[tuple[Cell, ...]] = []
    kinds = []
    for one in held:
        if not one.reviews:
            rows.append((one.section, one.facts, "", "", "nobody has compared it"))
            kinds.append("warning")
        for review, since in one.reviews:
            rows.append((one.section, one.facts, review.by, review.date, _text(since)))
            kinds.append("good" if since.same else "")
    return SectionTable(
        "reviewed", "By section", ("section", "facts", "by", "date", "since"), tuple(rows), tuple(kinds)
    )


def _text(since: Since) -> str:
    """What has changed since a review, in a few words."""
    if since.same:
        return "as it was"
    texts = [f"{len(since.changed)} facts are new or say something else" if since.changed else ""]
    texts.append(f"{since.gone} are gone or said something else" if since.gone else "")
    texts.append("compared with another text of the manual" if since.other_manual else "")
    return "; ".join(text for text in texts if text)


def _changed(held: Sequence[Reviewed]) -> SectionTable:
    """The facts that have changed since the last review of their section."""
    rows = tuple(
        (one.section, path, review.by, review.date)
        for one in held
        for review, since in one.reviews[:1]
        for path in since.changed
    )
    title = "Facts that are new or say something else since their section was last compared"
    return SectionTable("changed_since", title, ("section", "fact", "by", "date"), rows, detail=len(rows) > 20)
