"""Reviews: who has compared which section of the manual with the spec, and what has changed since."""

from __future__ import annotations

import binascii
import hashlib
import re
from base64 import b64decode, b64encode
from calendar import monthrange
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain
from operator import itemgetter

from fieldspec.foundation.classes import dataclass, field, replace
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.fact import Place
from fieldspec.language.reading.building.context import Entry
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.tools.audit.section import Cell, Figure, Section, SectionTable, Subject
from fieldspec.tools.audit.sources import section_order
from fieldspec.tools.facts import FactRow

# The state of a section is a hash of its facts in all versions, as `fieldspec facts` has them: their values, names and
# errata, but not the lines that print them.

FILE = "review.yaml"
"""The file of reviews in the folder of a device."""

# The columns of a fact that a review is about. With a new column here, all that was ever reviewed would look changed.
_STATED = (
    "kind",
    "code",
    "address",
    "words",
    "bytes",
    "bit",
    "name",
    "printed_name",
    "label",
    "type",
    "access",
    "unit",
    "scale",
    "min",
    "max",
    "ranges",
    "default",
    "printed",
    "errata",
    "number",
    "count",
    "position",
    "direction",
    "restart",
)
_stated = itemgetter(*_STATED)
_RENAMED = {"kind=unit_address": "kind=station", "name=unit_addresses": "name=stations"}
"""What facts were called when sections were reviewed: another word for the kind of a fact does not change it."""
_SIZE = 4
_DAY = re.compile("([0-9]{4})-([0-9]{2})-([0-9]{2})")


@dataclass(frozen=True, slots=True)
class State:
    """The facts of a section: a short hash of each, with the paths of the facts with this hash."""

    facts: Mapping[str, tuple[str, ...]]

    @property
    def digests(self) -> list[str]:
        """The sorted hashes, each as often as there are facts with it."""
        return sorted(digest for digest, paths in self.facts.items() for _ in paths)

    @property
    def hash(self) -> str:
        """A hash of all facts of the state."""
        return state_hash(self.digests)


@dataclass(frozen=True, slots=True)
class SignedSection:
    """A section in a review. `state` and `facts` are the hashes at that time, of the section and of its facts."""

    section: str
    place: Place
    state: str
    facts: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Review:
    """Sections that a person has compared with a manual on one day. `manual` is the hash of its text."""

    place: Place
    by: str
    date: str
    manual: str
    edition: str
    doc: str
    sections: tuple[SignedSection, ...]


@dataclass(frozen=True, slots=True)
class SectionChanges:
    """The changes of a section: the paths of new or changed facts, and the numbers of removed and changed facts."""

    changed: tuple[str, ...] = ()
    gone: int = 0
    other_manual: bool = False

    @property
    def same(self) -> bool:
        """Whether no fact has changed."""
        return not self.changed and not self.gone and not self.other_manual


@dataclass(frozen=True, slots=True)
class ReviewedSection:
    """A section of the manual, its number of facts, and its reviews, the latest first, with the changes since."""

    section: str
    facts: int
    reviews: tuple[tuple[Review, SectionChanges], ...] = field(default=())


def is_day(text: str) -> bool:
    """Whether a text is a date such as 2026-01-31."""
    match = _DAY.fullmatch(text)
    if match is None:
        return False
    year, month, day = map(int, match.groups())
    return year > 0 and 1 <= month <= 12 and 1 <= day <= monthrange(year, month)[1]


def state_hash(digests: Iterable[str]) -> str:
    """The hash of the digests of a state."""
    return hashlib.sha256(" ".join(digests).encode()).hexdigest()[:16]


def states(facts: Iterable[Iterable[FactRow]]) -> dict[str, State]:
    """The state of each section that facts cite; `facts` are the rows of each version."""
    by_section: dict[str, dict[str, dict[str, None]]] = {}
    digests: dict[str, str] = {}
    visited: dict[int, FactRow] = {}
    for row in chain.from_iterable(facts):
        if row["section"] is not None and id(row) not in visited:
            visited[id(row)] = row
            fact_text = _fact_text(row)
            digest = digests.get(fact_text) or digests.setdefault(fact_text, _digest(fact_text))
            by_section.setdefault(str(row["section"]), {}).setdefault(digest, {})[str(row["path"])] = None
    return {
        section: State({digest: tuple(paths) for digest, paths in facts.items()})
        for section, facts in by_section.items()
    }


def _fact_text(row: FactRow) -> str:
    """The text of a fact that is hashed. A constant counts as a default, as when the first facts were reviewed."""
    if row["const"] is not None:
        row = {**row, "default": row["const"]}
    cells = zip(_STATED, _stated(row), strict=True)
    texts = [f"{key}={cell}" for key, cell in cells if cell is not None and cell != []]
    return "\x1f".join([_RENAMED.get(text, text) for text in texts])


def _digest(fact_text: str) -> str:
    """Three bytes of the hash of a fact, as four characters of Base64."""
    return b64encode(hashlib.sha256(fact_text.encode()).digest()[:3]).decode()


def reviews_of(spec: DeviceSpec) -> tuple[list[Review], list[Diagnostic]]:
    """The reviews of a device in the order of the spec, and what is wrong with them.

    A section in a state that another review has already recorded has the facts of that one.
    """
    findings: list[Diagnostic] = []
    entries = [_review(entry) for entry in Entry(spec.tree, "", findings).named("reviews", "reviews")]
    known = {section.state: section.facts for review in entries for section in review.sections if section.facts}
    reviews = []
    for review in entries:
        sections = []
        for section in review.sections:
            facts = section.facts or known.get(section.state, ())
            state = state_hash(sorted(facts))
            if state != section.state:
                text = f"the state of section {section.section} is {section.state}, that of its facts {state}"
                help = "remove the entry, and record the review with `fieldspec audit --sign`"
                findings.append(Diagnostic("reviews_sound", text, section.place["state"], help=help))
            sections.append(replace(section, facts=facts))
        reviews.append(replace(review, sections=tuple(sections)))
    return reviews, findings


def _review(entry: Entry) -> Review:
    day = entry.text("date")
    if not is_day(day):
        entry.refuse("reviews_sound", "date", f"there is no date {day}", "write it as in 2026-01-31")
    return entry.built(
        Review, date=day, sections=tuple(_signed(inner) for inner in entry.entries("sections", "section"))
    )


def _signed(entry: Entry) -> SignedSection:
    text = "".join(entry.text("facts").split())
    try:
        b64decode(text, validate=True)
    except binascii.Error:
        help = "remove the entry, and record the review with `fieldspec audit --sign`"
        entry.refuse("reviews_sound", "facts", "these are not the hashes of facts", help)
        text = ""
    digests = tuple(text[start : start + _SIZE] for start in range(0, len(text), _SIZE))
    return entry.built(SignedSection, facts=digests)


def reviewed(now: Mapping[str, State], reviews: Iterable[Review], manual: str) -> list[ReviewedSection]:
    """Every section that facts cite, with its reviews; `manual` is the hash of the text that the spec cites."""
    latest = sorted(enumerate(reviews), key=lambda numbered: (numbered[1].date, numbered[0]), reverse=True)
    return [
        ReviewedSection(
            section,
            len(state.digests),
            tuple(
                (review, since(state, signed, review.manual != manual))
                for _, review in latest
                for signed in review.sections
                if signed.section == section
            ),
        )
        for section, state in now.items()
    ]


def since(state: State, signed: SignedSection, other_manual: bool) -> SectionChanges:
    """The changes of a section since a review."""
    if state.hash == signed.state:
        return SectionChanges(other_manual=other_manual)
    before, now = Counter(signed.facts), Counter(state.digests)
    changed = [path for digest in now - before for path in state.facts[digest]]
    return SectionChanges(tuple(dict.fromkeys(changed)), sum((before - now).values()), other_manual)


def uncited(now: Mapping[str, State], reviews: Iterable[Review]) -> Iterator[Diagnostic]:
    """Findings about reviews of sections that no fact cites."""
    for review in reviews:
        for signed_section in review.sections:
            if signed_section.section not in now:
                text = f"no fact cites the section {signed_section.section} that {review.by} has compared"
                help = "correct the section, or remove the entry"
                yield Diagnostic("reviews_sound", text, signed_section.place["section"], help=help)


def review_entry(
    spec: DeviceSpec, signed: Mapping[str, State], reviewer: str, day: str, manual: str, edition: str, doc: str
) -> str:
    """The YAML of a new review, to be appended to the list. Facts are left out where a review has the same state."""
    known = {section.state for review in reviews_of(spec)[0] for section in review.sections}
    lines = [f"  - by: {_quoted(reviewer)}", f"    date: {day}", f"    manual: {manual}"]
    lines += [f"    edition: {_quoted(edition)}"] if edition else []
    lines += [f"    doc: {_quoted(doc)}"] if doc else []
    lines.append("    sections:")
    for section, state in signed.items():
        lines += [f"      - section: {_quoted(section)}", f"        state: {_quoted(state.hash)}"]
        if state.hash not in known:
            known.add(state.hash)
            text = "".join(state.digests)
            lines.append("        facts: >-")
            lines += [f"          {text[start : start + 100]}" for start in range(0, len(text), 100)]
    return "\n".join(lines) + "\n"


def _quoted(text: str) -> str:
    """Any text as YAML in double quotes."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + "".join(sign if sign.isprintable() else f"\\U{ord(sign):08x}" for sign in escaped) + '"'


_INTRODUCTION = (
    "Who compared which section of the manual with the spec, and which of its facts are new or "
    "changed since then. A change after a review is not a fault, but the next reader should look at "
    "it first."
)


def sign_off(subject: Subject) -> Section:
    """The section with the reviews of each section of the manual."""
    reviews, wrong = reviews_of(subject.spec)
    now = states(subject.facts)
    sections = sorted(
        reviewed(now, reviews, subject.device.manual.sha256), key=lambda section: section_order(section.section)
    )
    compared = [section for section in sections if section.reviews]
    same = [section for section in compared if section.reviews[0][1].same]
    twice = [section for section in compared if len({review.by for review, _ in section.reviews}) > 1]
    figures = (
        Figure("sections compared with the manual", len(compared), len(sections), len(compared) == len(sections)),
        Figure("sections compared by at least two readers", len(twice), len(sections)),
        Figure("sections unchanged since they were last compared", len(same), len(compared)),
    )
    tables = (_readings(reviews), _sections(sections), _changed_facts(sections))
    return Section("sign_off", "Sign-off", (_INTRODUCTION,), figures, tables, (*wrong, *uncited(now, reviews)))


def _readings(reviews: Sequence[Review]) -> SectionTable:
    rows = tuple(
        (
            review.by,
            review.date,
            len(review.sections),
            review.edition or None,
            review.manual[:12],
            review.doc,
            review.place["by"],
        )
        for review in reviews
    )
    columns = ("by", "date", "sections", "edition", "manual", "how", "spec")
    return SectionTable("readings", "Readings", columns, rows)


def _sections(sections: Sequence[ReviewedSection]) -> SectionTable:
    rows: list[tuple[Cell, ...]] = []
    kinds = []
    for section in sections:
        if not section.reviews:
            rows.append((section.section, section.facts, "", "", "it is not compared with the manual"))
            kinds.append("warning")
        for review, since in section.reviews:
            rows.append((section.section, section.facts, review.by, review.date, _changes_text(since)))
            kinds.append("good" if since.same else "")
    return SectionTable(
        "reviewed", "By section", ("section", "facts", "by", "date", "since"), tuple(rows), tuple(kinds)
    )


def _changes_text(since: SectionChanges) -> str:
    """The changes since a review in a few words."""
    if since.same:
        return "as it was"
    texts = [f"{len(since.changed)} facts are new or changed" if since.changed else ""]
    texts.append(f"{since.gone} were removed or changed" if since.gone else "")
    texts.append("compared with another text of the manual" if since.other_manual else "")
    return "; ".join(text for text in texts if text)


def _changed_facts(sections: Sequence[ReviewedSection]) -> SectionTable:
    """The facts that have changed since the last review of their section."""
    rows = tuple(
        (section.section, path, review.by, review.date)
        for section in sections
        for review, since in section.reviews[:1]
        for path in since.changed
    )
    title = "Facts that are new or changed since their section was last compared"
    return SectionTable("changed_since", title, ("section", "fact", "by", "date"), rows, detail=len(rows) > 20)
