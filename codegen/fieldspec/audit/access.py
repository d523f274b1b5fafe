"""The section of the report about reading and writing: what may go wrong, kind by kind."""

from __future__ import annotations

from fieldspec.audit.hazards import KINDS, Hazard, Kind, hazards, undivided
from fieldspec.audit.section import Figure, Section, SectionTable
from fieldspec.audit.subject import Subject

COLUMNS = ("where", "fact", "why", "spec", "source")
_LONG = 30

_SAYS = (
    "What may go wrong although every address and every value is right. It says what the manual says, and nothing "
    "where the manual says nothing."
)


def access(subject: Subject) -> Section:
    """The hazards of reading and writing."""
    found = hazards(subject.layout)
    unsafe = {hazard.path for hazard in found if hazard.kind.unsafe}
    says = [_SAYS]
    open_ones = undivided(subject.device)
    if open_ones:
        names = ", ".join(register.name for register in open_ones[:6]) + (", …" if len(open_ones) > 6 else "")
        says.append(
            f"Of {len(open_ones)} registers with several words the manual does not say whether they may be read in "
            f"parts ({names}); no poll block divides them."
        )
    figures = [Figure("facts cannot be read and written back safely", len(unsafe))]
    tables = []
    for kind in KINDS.values():
        held = [hazard for hazard in found if hazard.kind == kind]
        if held:
            figures.append(Figure(f"{'hazard' if len(held) == 1 else 'hazards'}: {kind.title.lower()}", len(held)))
            tables.append(_table(kind, held))
    return Section("access", "Access hazards", tuple(says), tuple(figures), tuple(tables))


def _table(kind: Kind, held: list[Hazard]) -> SectionTable:
    rows = tuple(
        (
            hazard.where,
            hazard.path,
            hazard.why,
            hazard.place[hazard.key],
            hazard.sources[0] if hazard.sources else None,
        )
        for hazard in held
    )
    kinds = ("warning" if kind.unsafe else "",) * len(rows)
    return SectionTable(kind.name, f"{kind.title}. {kind.advice}", COLUMNS, rows, kinds, detail=len(rows) > _LONG)
