"""How an audit reads a manual: the section `audit` of a spec.

It says nothing about the device, so it is not in the model.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from operator import attrgetter

from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import dataclass
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.fact import Place
from fieldspec.language.reading.building.context import Entry
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.nodes import Mapping
from fieldspec.tools.audit.pattern import PatternError, RowPattern, Template, row, template

HEADINGS = "Headings of the sections."

Lines = tuple[tuple[int, int], ...]


@dataclass(frozen=True, slots=True)
class ManualSection:
    """A section of the manual, from the line of its heading to the last line before the next heading."""

    name: str
    title: str
    first: int
    last: int


_first = attrgetter("first")


@dataclass(frozen=True, slots=True)
class Pattern:
    """What looks like a fact: a row, or any part of a line. The manual prints the first and the last of a `series`.

    `access` is what a match says of the access in words, empty where it says nothing.
    """

    name: str
    kind: str
    place: Place
    lines: Lines
    row: RowPattern | None
    each: Template | None
    series: bool
    access: str


@dataclass(frozen=True, slots=True)
class Omission:
    """Lines that the spec leaves out, with the reason: all of `lines`, or those that match `template` as a whole.

    `like` is the template as the spec writes it.
    """

    place: Place
    lines: Lines
    like: str
    template: Template | None
    reason: str

    @property
    def exact(self) -> bool:
        """Whether it names single lines for their text, so that it does not apply to a line with another text."""
        return self.template is None and all(first == last for first, last in self.lines)


@dataclass(frozen=True, slots=True)
class Unprinted:
    """Paths of facts, with `*` for any text, that the cited lines do not print literally, and the reason."""

    place: Place
    facts: tuple[str, ...]
    reason: str


@dataclass(frozen=True, slots=True)
class Plan:
    """The sections of the manual, the patterns, and the omissions.

    `headings` is the omission of the lines with which sections begin. `without_behaviour` are lines that state
    facts, and nothing of what the device does.
    """

    place: Place
    sections: tuple[ManualSection, ...]
    patterns: tuple[Pattern, ...]
    left_out: tuple[Omission, ...]
    headings: Omission
    unprinted: tuple[Unprinted, ...]
    without_behaviour: tuple[Omission, ...]

    def section(self, line: int) -> str:
        """The name of the section of a line; empty before the first one."""
        index = bisect_right(self.sections, line, key=_first)
        return self.sections[index - 1].name if index else ""


def plan_of(spec: DeviceSpec, lines: int) -> tuple[Plan | None, list[Diagnostic]]:
    """The plan of a device, None where the spec has none, and the findings about it; `lines` is the manual's length."""
    findings: list[Diagnostic] = []
    node = spec.tree.values.get("audit")
    if not isinstance(node, Mapping):
        return None, findings
    plans = _PLANS.get_or_compute(node, lambda _: {})
    if lines not in plans:
        plan = _plan(Entry(node, "audit", findings), lines)
        if findings:
            return plan, findings
        plans[lines] = plan
    return plans[lines], findings


_PLANS: ByIdentity[Mapping, dict[int, Plan]] = ByIdentity(limit=16)
"""The plans without findings, by the section of a spec and the length of the manual."""


def _plan(entry: Entry, lines: int) -> Plan:
    sections = _sections(entry, lines)
    return Plan(
        entry.place(),
        sections,
        tuple(_patterns(entry, sections, lines)),
        tuple(_omissions(entry, "left_out", sections, lines)),
        Omission(entry.place(), tuple((section.first, section.first) for section in sections), "", None, HEADINGS),
        tuple(unprinted.built(Unprinted) for unprinted in entry.entries("unprinted")),
        tuple(_omissions(entry, "without_behaviour", sections, lines)),
    )


def _sections(entry: Entry, lines: int) -> tuple[ManualSection, ...]:
    """The sections in their order; one that begins before the previous one, or after the last line, is a finding."""
    sections: list[ManualSection] = []
    entries = list(entry.entries("sections", "section"))
    starts = [inner.integer("line") or 1 for inner in entries]
    for inner, first, after in zip(entries, starts, [*starts[1:], lines + 1], strict=True):
        if (sections and first < sections[-1].first) or first > lines:
            text = f"section {inner.text('section')} begins at line {first}, which is not in the order of the manual"
            inner.refuse("audit_sound", "line", text, "correct the line or the order of the sections")
        sections.append(ManualSection(inner.text("section"), inner.text("title"), first, after - 1))
    return tuple(sections)


def _patterns(entry: Entry, sections: tuple[ManualSection, ...], lines: int) -> Iterator[Pattern]:
    for inner in entry.entries("patterns"):
        try:
            rows = row(inner.texts("row")) if "row" in inner.node.values else None
            line_template = template(inner.text("each")) if rows is None else None
            if line_template is not None and not line_template.pieces:
                raise PatternError("it contains only `*`; say what the line looks like")
        except PatternError as error:
            key = "row" if "row" in inner.node.values else "each"
            inner.refuse("audit_sound", key, f"the pattern is not understood: {error}", "see docs/audit.md")
            continue
        line_intervals = _lines(inner, sections, lines)
        name, kind, access = inner.text("name"), inner.text("kind"), inner.text("access")
        yield Pattern(name, kind, inner.place(), line_intervals, rows, line_template, inner.flag("series"), access)


def _omissions(entry: Entry, key: str, sections: tuple[ManualSection, ...], lines: int) -> Iterator[Omission]:
    for inner in entry.entries(key):
        like = inner.text("like")
        try:
            form = template(like) if like else None
        except PatternError as error:
            inner.refuse("audit_sound", "like", f"the pattern is not understood: {error}", "see docs/audit.md")
            continue
        yield Omission(inner.place(), _lines(inner, sections, lines), like, form, inner.text("reason"))


def _lines(entry: Entry, sections: tuple[ManualSection, ...], lines: int) -> Lines:
    """The lines of an entry: of `lines`, of `sections`, of both at once, or all lines."""
    intervals: list[tuple[int, int]] = []
    for part in filter(None, entry.text("lines").split(", ")):
        low, _, high = part.partition("-")
        intervals.append((int(low), int(high or low)))
    for first, last in intervals:
        if not 1 <= first <= last <= lines:
            text = f"there are no lines {first} to {last}; the manual has the lines 1 to {lines}"
            entry.refuse("audit_sound", "lines", text, "put the lines right")
    names = entry.texts("sections")
    whole = [
        (section.first, section.last)
        for section in sections
        if any(section.name == name or section.name.startswith(f"{name}.") for name in names)
    ]
    for name in names:
        if not any(section.name == name or section.name.startswith(f"{name}.") for section in sections):
            entry.refuse("audit_sound", "sections", f"there is no section {name}", "list it under `audit: sections`")
    if not names:
        return tuple(intervals) or ((1, lines),)
    if not intervals:
        return tuple(whole)
    overlaps = ((max(a, c), min(b, d)) for a, b in intervals for c, d in whole)
    return tuple((first, last) for first, last in overlaps if first <= last)
