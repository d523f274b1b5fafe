"""The evidence of all units as a section of an audit, and what a baseline says of it."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence

from fieldspec.codec.explain.values import range_in_unit
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.checks.finding import range_key
from fieldspec.language.diagnostics import Diagnostic, Severity
from fieldspec.language.model.fact import Fact
from fieldspec.tools.audit.section import Cell, Figure, Report, Section, SectionTable
from fieldspec.tools.evidence.judgement import (
    CONSISTENT,
    CONTRADICTED,
    NEVER,
    NOTHING,
    OBSERVED,
    RANGE,
    STATES,
    UNSEEN,
    Aspect,
    Observation,
    aspects,
    observations,
    strongest,
)
from fieldspec.tools.evidence.observables import Observables
from fieldspec.tools.evidence.unit_evidence import UnitEvidence

AGREES = "evidence_agrees"
NOT_LOST = "evidence_not_lost"
COLUMNS = ("fact", "aspect", "state", "count", "values", "units", "where", "remark")
_KINDS = {CONTRADICTED: "bad", NOTHING: "warning", OBSERVED: "good"}
_RANKS = {NEVER: 0, NOTHING: 1, CONSISTENT: 2, OBSERVED: 3}


@dataclass(frozen=True, slots=True)
class Baseline:
    """The states that an earlier report had, and its file."""

    file: SourceFile
    states: Mapping[Aspect, str]


class BaselineError(Exception):
    """A file that is not a baseline. The message completes a sentence that begins with its name."""


def baseline(path: str, text: str) -> Baseline:
    """The baseline in a file: the table `evidence` as JSON. Raises BaselineError."""
    try:
        rows = json.loads(text)
        states = {(row["fact"], row["aspect"]): row["state"] for row in rows}
        is_right = all(
            isinstance(fact, str) and isinstance(aspect, str) and state in STATES
            for (fact, aspect), state in states.items()
        )
    except (ValueError, KeyError, TypeError, RecursionError):
        is_right = False
    if not is_right:
        raise BaselineError("is not a table of evidence; write one with --table evidence --format json --out FILE")
    return Baseline(SourceFile(path, text), states)


@dataclass(frozen=True, slots=True)
class _Row:
    """One aspect of a fact: the state over all units, and what each unit says."""

    aspect: Aspect
    fact: Fact
    whole: Observation
    by_unit: tuple[Observation, ...]


def evidence_report(
    layout: DeviceLayout, units: Sequence[UnitEvidence], other_rows: Sequence[tuple[str, ...]], old: Baseline | None
) -> tuple[Report, tuple[Diagnostic, ...]]:
    """The report, and its findings. `other_rows` are the rows of units that do not count."""
    observables = Observables(layout)
    observed = [observations(unit, observables) for unit in units]
    rows = []
    for aspect, fact in aspects(observables).items():
        own = tuple(of_unit.get(aspect, UNSEEN) for of_unit in observed)
        rows.append(_Row(aspect, fact, strongest(own), own))
    findings = (*_contradictions(rows, units, old), *_lost(rows, old))
    section = _section(rows, units, other_rows, findings)
    device = layout.device
    return Report(device.id, device.name, device.version, layout.identity, (section,)), findings


def _section(
    rows: Sequence[_Row],
    units: Sequence[UnitEvidence],
    other_rows: Sequence[tuple[str, ...]],
    findings: tuple[Diagnostic, ...],
) -> Section:
    names = tuple(unit.note.name for unit in units)
    total = len(rows)
    count = {state: sum(row.whole.state == state for row in rows) for state in STATES}
    figures = (
        Figure("aspects of facts were observed", count[OBSERVED], total),
        Figure("are consistent with what was seen", count[CONSISTENT], total),
        Figure("were seen, which proves nothing", count[NOTHING], total),
        Figure("are contradicted", count[CONTRADICTED], total, not count[CONTRADICTED]),
        Figure("were never seen", count[NEVER], total),
        Figure("units", len(units)),
    )
    unlisted = tuple(
        (unit.note.name, space, f"0x{address:04X}", trouble.count, ", ".join(trouble.values), trouble.where)
        for unit in units
        for (space, address), trouble in sorted(unit.unlisted.items())
    )
    columns = ("unit", "model", "firmware", "files", "remark")
    return Section(
        "evidence",
        "Evidence from real units",
        paragraphs=(
            "The wire shows which values occur. A person has to decide what they mean, and who is right if the wire "
            "contradicts the manual.",
        ),
        figures=figures,
        tables=(
            SectionTable("evidence_units", "Units", columns, (*map(_unit, units), *other_rows)),
            _disagreements(rows, units),
            SectionTable(
                "unlisted",
                "Addresses that answer, and that the spec does not have",
                ("unit", "space", "address", "count", "values", "where"),
                unlisted,
                ("warning",) * len(unlisted),
            ),
            _table("unproven", "Values that prove nothing", rows, names, (NOTHING,)),
            _table("evidence", "All facts", rows, names, STATES),
            SectionTable(
                "units_matrix",
                "Facts by units",
                ("fact", "aspect", *(f"unit {name}" for name in names)),
                tuple((*row.aspect, *(own.state for own in row.by_unit)) for row in rows if row.whole.state != NEVER),
                detail=True,
            ),
        ),
        findings=findings,
    )


def _unit(unit: UnitEvidence) -> tuple[Cell, ...]:
    return unit.note.name, unit.note.model, unit.note.firmware, ", ".join(unit.sources), unit.note.remarks


def _table(name: str, title: str, rows: Sequence[_Row], names: Sequence[str], states: Sequence[str]) -> SectionTable:
    chosen = [row for row in rows if row.whole.state in states]
    cells = tuple(
        (
            *row.aspect,
            row.whole.state,
            row.whole.count,
            row.whole.values,
            _names(row, names),
            row.whole.where,
            row.whole.remark,
        )
        for row in chosen
    )
    kinds = tuple(_KINDS.get(row.whole.state, "") for row in chosen)
    return SectionTable(name, title, COLUMNS, cells, kinds, detail=True)


def _names(row: _Row, names: Sequence[str]) -> str:
    """The units that have the state of the row."""
    state = row.whole.state
    unit_names = [name for name, own in zip(names, row.by_unit, strict=True) if own.state == state != NEVER]
    return ", ".join(unit_names)


def _disagreements(rows: Sequence[_Row], units: Sequence[UnitEvidence]) -> SectionTable:
    """The disagreements between the manual and the wire, each as an entry for the ledger."""
    cells: list[tuple[Cell, ...]] = []
    for row in rows:
        cells += [
            (
                *row.aspect,
                _spec_text(row),
                observation.remark,
                observation.values,
                observation.count,
                unit.note.name,
                observation.where,
                row.fact.sources[0] if row.fact.sources else None,
                "open",
            )
            for unit, observation in zip(units, row.by_unit, strict=True)
            if observation.state == CONTRADICTED
        ]
    columns = ("fact", "aspect", "spec", "wire", "values", "count", "unit", "where", "manual", "decision")
    title = "Where the wire and the spec disagree"
    return SectionTable("disagreements", title, columns, tuple(cells), ("bad",) * len(cells))


def _spec_text(row: _Row) -> str:
    """The statement of the spec about an aspect, in a few words."""
    value = getattr(row.fact, "value", None)
    ranges = getattr(value, "ranges", None)
    if row.aspect[1] == RANGE and value is not None and ranges is not None:
        return range_in_unit(value, ranges)
    for key in ("const", "enum", "flags"):
        own = getattr(value, key, None)
        if row.aspect[1] == "value" and own not in (None, ""):
            return f"{key} {own}"
    return str(getattr(row.fact, "access", "")) if row.aspect[1] == "access" else ""


def _contradictions(rows: Sequence[_Row], units: Sequence[UnitEvidence], old: Baseline | None) -> Iterator[Diagnostic]:
    for row in rows:
        if row.whole.state != CONTRADICTED:
            continue
        is_known = old is not None and old.states.get(row.aspect) == CONTRADICTED
        names = _names(row, [unit.note.name for unit in units])
        key = range_key(row.fact.place) if row.aspect[1] == RANGE else "name"
        whole = row.whole
        values = f": {whole.values}" if whole.values else ""
        place_text = f" ({whole.where})" if whole.where else ""
        text = f"unit {names} contradicts the {row.aspect[1]} of {row.fact.name}: {whole.remark}{values}{place_text}"
        help = "decide who is right: correct the spec, with an erratum if the manual is wrong, or report the unit"
        severity = Severity.WARNING if is_known else Severity.ERROR
        yield Diagnostic(AGREES, text, row.fact.place[key], help=help, severity=severity)


def _lost(rows: Sequence[_Row], old: Baseline | None) -> Iterator[Diagnostic]:
    """The facts in a baseline that the present evidence lacks."""
    if old is None:
        return
    now = {row.aspect: row.whole.state for row in rows}
    for aspect, state in old.states.items():
        rank = _RANKS.get(state, 0)
        new = now.get(aspect)
        if not rank or (new is not None and _RANKS.get(new, rank) >= rank):
            continue
        text = f"the {aspect[1]} of {aspect[0]} was `{state}`; "
        text += f"it is now `{new}`" if new is not None else "the spec has no such fact any more"
        help = "bring back the files that showed it, or record the table `evidence` again as the baseline"
        yield Diagnostic(NOT_LOST, text, _row_span(old.file, aspect), help=help)


def _row_span(file: SourceFile, aspect: Aspect) -> Span:
    """The row of an aspect in the text of a baseline."""
    fact = f'"fact": {json.dumps(aspect[0], ensure_ascii=False)}'
    start = file.text.find(fact)
    while start >= 0:
        end = file.text.find("}", start)
        if f'"aspect": {json.dumps(aspect[1])}' in file.text[start : end if end >= 0 else len(file.text)]:
            return Span(file, start, start + len(fact))
        start = file.text.find(fact, start + 1)
    return Span(file, 0, 0)
