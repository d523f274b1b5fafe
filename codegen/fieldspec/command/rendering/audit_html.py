"""The audit report of a device as an HTML page: what its template prints."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterator, Mapping, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.rendering.audit_formats import SIGNS, cell_text
from fieldspec.command.rendering.audit_map import Map, maps, states
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.html_text import clean
from fieldspec.foundation.line_text import plural
from fieldspec.foundation.source import Span
from fieldspec.language.diagnostics import Diagnostic, Severity, in_order
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Citation
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.targets import PageLink
from fieldspec.targets.docs.site import SCRIPTS, PagePlace, device_place, policy
from fieldspec.targets.pieces import latest_piece
from fieldspec.targets.templates import fill, style_sheet
from fieldspec.tools.audit.manual_lines import ManualIndex
from fieldspec.tools.audit.report import report
from fieldspec.tools.audit.section import Cell, Figure, Report, Section, SectionTable, Subject
from fieldspec.tools.facts import of_versions
from fieldspec.tools.proofs.running import Outcome, errata_proofs

BROAD = 8
"""A table with this many columns or more gets column widths, as it would be wider than paper without them."""

OPEN = 100
"""A table of details with at most this many rows is open, and printed; a longer one is folded."""

_WORD, _MOST, _WHOLE, _EDGES = 11, 60, 205, 4
"""For column widths, in letters: the longest word that is never broken, the most that counts of a text, the width of a
table, and the room for the edges of a cell and for bold letters."""

_LETTERS = re.compile(r"[A-Za-z]+")


@dataclass(frozen=True, slots=True)
class _Column:
    heading: str
    is_number: bool
    texts: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _Table:
    """A table as it is printed, its entry in the list of contents, and the widths of its columns."""

    anchor: str
    title: str
    entry: str
    size: str
    is_open: bool
    widths: tuple[str, ...]
    text: str


@dataclass(frozen=True, slots=True)
class _Section:
    """A section with its tables, with detail tables in `folded`, and the drawings with their legend."""

    name: str
    title: str
    paragraphs: tuple[str, ...]
    figures: tuple[Figure, ...]
    questions: str
    legend: tuple[tuple[str, str], ...]
    maps: tuple[Map, ...]
    tables: tuple[_Table, ...]
    folded: tuple[_Table, ...]


@dataclass(frozen=True, slots=True)
class _Finding:
    """A finding with the places in files that it names, and the anchor of the row that shows one of them."""

    kind: str
    severity: str
    code: str
    message: str
    help: str
    place: str
    labels: tuple[str, ...]
    row: str
    section: str


@dataclass(frozen=True, slots=True)
class _Verdict:
    kind: str
    text: str


def rendered(report: Report, device: Device, links: Mapping[str, str], place: PagePlace | None = None) -> str:
    """The page; `links` lead from paths of facts to where they are documented, where there is such a place.

    `place` is that of the page among the documentation; none where it stands alone.
    """
    linked = device.id, hashlib.sha256(json.dumps([*links.items()]).encode()).hexdigest()
    sections = [_section(section, links, linked) for section in report.sections]
    findings = [finding for section in report.sections for finding in _findings(section)]
    style = style_sheet("targets/page.css", "command/rendering/audit.css") + _width_rules(sections)
    return fill(
        "audit.html.j2",
        title=clean(f"Audit of {report.title}"),
        identity=clean(report.identity),
        style=style,
        policy=policy(style, scripts=place is not None),
        place=place,
        scripts=SCRIPTS[:1] if place is not None else (),
        subtitle=clean(device.title),
        facts=_facts(report, device),
        verdict=_verdict(findings),
        sections=sections,
        findings=findings,
        signs=SIGNS,
    )


def _section(section: Section, links: Mapping[str, str], linked: tuple[str, str]) -> _Section:
    return _Section(
        section.name,
        section.title,
        section.paragraphs,
        section.figures,
        plural(section.questions, "question") if section.questions else "",
        tuple(states(section.spaces)),
        maps(section.spaces),
        *(
            tuple(
                _table(section.name, table, links, linked)
                for table in section.tables
                if table.rows and table.detail is are_details
            )
            for are_details in (False, True)
        ),
    )


def _table(section: str, table: SectionTable, links: Mapping[str, str], linked: tuple[str, str]) -> _Table:
    """A table. `linked` is the device, and a hash of the links."""
    device, links_hash = linked
    anchor = f"{section}-{table.name}"
    data = (links_hash, table.title, table.columns, table.kinds, [[*map(_cell_data, row)] for row in table.rows])
    return latest_piece(("audit table", device, anchor), data, lambda: _printed(anchor, table, links))


def _cell_data(cell: Cell) -> object:
    """A cell as plain data."""
    return cell if cell is None or isinstance(cell, str | int) else (_form(cell, {}), cell_text(cell))


def _printed(anchor: str, table: SectionTable, links: Mapping[str, str]) -> _Table:
    """A table with the columns that are not empty. A row is its mark, and its cells as column, form and text.

    The form is `text`, `place`, `source`, or the link to where the fact that the cell names is documented.
    """
    full = [number for number in range(len(table.columns)) if any(row[number] not in (None, "") for row in table.rows)]
    columns = tuple(_column(table, number) for number in full)
    kinds = table.kinds or ("",) * len(table.rows)
    is_marked = any(table.kinds)
    widths = _column_widths(columns, is_marked) if len(full) >= BROAD else ()
    rows = [
        (
            kinds[number],
            [
                (column, _form(row[place], links), column.texts[number])
                for column, place in zip(columns, full, strict=True)
            ],
        )
        for number, row in enumerate(table.rows)
    ]
    text = fill(
        "audit_table.html.j2",
        anchor=anchor,
        title=clean(table.title),
        widths=widths,
        is_marked=is_marked,
        columns=columns,
        rows=rows,
        signs=SIGNS,
    )
    size, is_open = plural(len(table.rows), "row"), len(table.rows) <= OPEN
    return _Table(anchor, clean(table.title), clean(table.title.partition(". ")[0]), size, is_open, widths, text)


def _column(table: SectionTable, number: int) -> _Column:
    cells = [row[number] for row in table.rows]
    return _Column(
        clean(table.columns[number].replace("_", " ")),
        all(cell is None or isinstance(cell, int) for cell in cells),
        tuple(clean(cell_text(cell, table.columns[number])) for cell in cells),
    )


def _form(cell: Cell, links: Mapping[str, str]) -> str:
    if isinstance(cell, Span):
        return "place"
    if isinstance(cell, Citation):
        return "source"
    return clean(links.get(cell, "text")) if isinstance(cell, str) else "text"


def _column_widths(columns: Sequence[_Column], is_marked: bool) -> tuple[str, ...]:
    """The width of each column in percent, as `12-5`: room for its longest word, and more the longer its texts are."""
    needs, wishes = ([_EDGES], [0]) if is_marked else ([], [])
    for column in columns:
        texts = [column.heading, *column.texts]
        longest = max(map(len, _LETTERS.findall(" ".join(texts))), default=0)
        room = min(longest, _WORD)
        needs.append(room + _EDGES)
        wishes.append(max(min(sum(map(len, texts)) // len(texts), _MOST) - room, 0))
    spare = max(_WHOLE - sum(needs), 0) / max(sum(wishes), 1)
    widths = [need + wish * spare for need, wish in zip(needs, wishes, strict=True)]
    return tuple(f"{100 * width / sum(widths):.1f}".replace(".", "-") for width in widths)


def _width_rules(sections: Sequence[_Section]) -> str:
    """The style of the columns of some tables: elements have no style of their own, which the page's policy forbids."""
    tables = [table for section in sections for table in (*section.tables, *section.folded)]
    widths = sorted({tuple(width.split("-")) for table in tables for width in table.widths})
    return "".join([f".w{whole}-{tenth} {{ width: {whole}.{tenth}%; }}\n" for whole, tenth in widths])


def _facts(report: Report, device: Device) -> tuple[tuple[str, str], ...]:
    """The subject of the report."""
    manual = device.manual
    edition = f", {manual.edition}" if manual.edition else ""
    return (
        ("Device", device.name),
        ("Vendor", device.vendor),
        ("Version", report.version),
        ("Identity of the spec", report.identity),
        ("Manual", f"{manual.title}{edition}"),
        ("Text of the manual", manual.extent + (f", SHA-256 {manual.sha256}" if manual.sha256 else "")),
    )


def _verdict(findings: Sequence[_Finding]) -> _Verdict:
    errors = sum(1 for finding in findings if finding.kind == "bad")
    warnings = len(findings) - errors
    if errors:
        return _Verdict("bad", f"{plural(errors, 'error')} and {plural(warnings, 'warning')} are open.")
    if warnings:
        return _Verdict("warning", f"No error; {plural(warnings, 'warning')} to be examined.")
    return _Verdict("good", "No finding in any part of the audit.")


def _place(span: Span) -> str:
    return f"{span.file.path}:{span.position()[0]}"


def _findings(section: Section) -> Iterator[_Finding]:
    rows = _rows_by_place(section) if section.findings else {}
    for finding in in_order(section.findings):
        yield _finding(section, finding, rows)


def _rows_by_place(section: Section) -> dict[str, str]:
    """The anchors of rows by the places in files that they show."""
    anchors: dict[str, str] = {}
    for table in section.tables:
        for number, row in enumerate(table.rows, 1):
            for cell in row:
                if isinstance(cell, Span):
                    anchors.setdefault(_place(cell), f"{section.name}-{table.name}-{number}")
    return anchors


def _finding(section: Section, finding: Diagnostic, rows: Mapping[str, str]) -> _Finding:
    places = [_place(finding.span), *(_place(label.span) for label in finding.labels)]
    return _Finding(
        "bad" if finding.severity is Severity.ERROR else "warning",
        finding.severity.value,
        finding.code,
        finding.message,
        finding.help,
        places[0],
        tuple(f"{_place(label.span)}: {label.text}" for label in finding.labels),
        next((rows[place] for place in places if place in rows), section.name),
        section.title,
    )


LINK = PageLink("audit", "audit.html")
"""The entry of the page in the index of a device's documentation."""


def pages(
    spec: DeviceSpec,
    layouts: Sequence[DeviceLayout],
    recorded: ManualIndex | None,
    links: Mapping[str, str],
    known: Outcome | None = None,
) -> dict[str, bytes]:
    """The page of a device's audit, by its path below the folder of all outputs.

    `layouts` are the layouts of all versions, the oldest first; the audit is of the last one. `recorded` is the index
    of the manual, where there is one. `links` lead from paths of facts to where they are documented. `known` is the
    outcome of all checks and proofs of the device, where they have run.
    """
    newest = layouts[-1]
    proofs = known.proofs if known is not None else errata_proofs(spec)
    subject = Subject(spec, newest, layouts, of_versions(layouts), proofs, recorded, known=known)
    page = rendered(report(subject), newest.device, links, device_place(clean(newest.device.name)))
    return {f"docs/{spec.id}/{LINK.file}": page.encode("utf-8")}
