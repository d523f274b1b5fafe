"""The audit of a device as a page that stands on its own, to be read, printed and handed on.

The template has the page; the rows of its tables and the boxes of its drawings are written here, as a template takes
eight times as long.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from fieldspec.audit.address_map import Space
from fieldspec.audit.section import Cell, Figure, Report, Section, SectionTable
from fieldspec.backends.docs.document import clean
from fieldspec.backends.docs.html import escaped
from fieldspec.backends.templates import fill
from fieldspec.classes import dataclass
from fieldspec.diagnostics import Diagnostic, Severity, in_order
from fieldspec.model.device import Device
from fieldspec.model.fact import Citation
from fieldspec.render.audit_cells import cell_text
from fieldspec.render.audit_map import Box, Drawing, maps, states
from fieldspec.source import Span

_SIGNS = {"good": ("✓", "right"), "bad": ("✗", "wrong"), "warning": ("!", "to be looked at"), "": ("", "")}
OPEN = 100
"""A long table of so many rows is open, and printed; one that has more is folded until somebody opens it."""

BROAD = 8
"""A table of so many columns shares out the width, as it would else be wider than paper."""

_WORD, _MOST, _WHOLE, _EDGES = 11, 60, 205, 4
"""When the width is shared out, in letters: the longest word that is never broken, how long a text counts at most, how
much there is to share, and what the edges of a cell and bold letters take."""

_LETTERS = re.compile(r"[A-Za-z]+")

_GOOD = {True: "good", False: "bad", None: ""}


@dataclass(frozen=True, slots=True)
class _Number:
    """A figure: the number, the whole, what it counts, and how it stands, as a word and as a sign."""

    number: str
    whole: str
    what: str
    kind: str
    sign: str
    said: str


@dataclass(frozen=True, slots=True)
class _Table:
    """A table: its rows are written already."""

    anchor: str
    title: str
    short: str
    count: str
    headings: tuple[str, ...]
    marked: bool
    rows: str
    detail: bool
    open: bool
    shares: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _Drawn:
    """A drawing, whose boxes and marks are written already."""

    drawing: Drawing
    shapes: str


@dataclass(frozen=True, slots=True)
class _Map:
    """The drawings of a space."""

    title: str
    drawings: tuple[_Drawn, ...]


@dataclass(frozen=True, slots=True)
class _Part:
    """A section: its figures, its texts, its tables, and its drawings."""

    anchor: str
    title: str
    says: tuple[str, ...]
    figures: tuple[_Number, ...]
    tables: tuple[_Table, ...]
    folded: tuple[_Table, ...]
    maps: tuple[_Map, ...]
    legend: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class _Finding:
    """A finding: how grave it is, what it says, what would make it right, and where it shows."""

    anchor: str
    kind: str
    sign: str
    severity: str
    rule: str
    message: str
    help: str
    place: str
    link: str
    section: str
    labels: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _Head:
    """What the report is about, and what it comes to; `questions` has a link and a text for each part with any."""

    title: str
    subtitle: str
    identity: str
    rows: tuple[tuple[str, str], ...]
    verdict: str
    kind: str
    sign: str
    questions: tuple[tuple[str, str], ...]


def rendered(report: Report, device: Device, links: Mapping[str, str]) -> str:
    """The page; `links` leads from paths of facts to where they are documented, where there is such a place."""
    found = [(section, one) for section in report.sections for one in in_order(section.findings)]
    parts = [_part(section, links) for section in report.sections]
    rows = {section.name: _rows_by_place(section) for section in report.sections if section.findings}
    findings = [_finding(number, section, one, rows[section.name]) for number, (section, one) in enumerate(found, 1)]
    return fill("audit.html.j2", head=_head(report, device, [one for _, one in found]), parts=parts, findings=findings)


def _head(report: Report, device: Device, found: Sequence[Diagnostic]) -> _Head:
    manual = device.manual
    edition = f", {manual.edition}" if manual.edition else ""
    rows = (
        ("Device", device.name),
        ("Vendor", device.vendor),
        ("Version", report.version),
        ("Identity of the spec", report.identity),
        ("Manual", f"{manual.title}{edition}"),
        ("Text of the manual", f"{manual.file}, {manual.lines} lines, SHA-256 {manual.sha256}"),
    )
    errors = sum(1 for one in found if one.severity is Severity.ERROR)
    warnings = len(found) - errors
    if errors:
        verdict, kind = f"{_many(errors, 'error')} and {_many(warnings, 'warning')} are open.", "bad"
    elif warnings:
        verdict, kind = f"No error; {_many(warnings, 'warning')} to be looked at.", "warning"
    else:
        verdict, kind = "No finding in any part of the audit.", "good"
    return _Head(
        clean(f"Audit of {report.title}"),
        clean(device.title),
        clean(report.identity),
        tuple((term, clean(text)) for term, text in rows),
        verdict,
        kind,
        _SIGNS[kind][0],
        tuple((one.name, clean(_questions(one))) for one in report.sections if one.questions),
    )


def _questions(section: Section) -> str:
    return f"The manual leaves {_many(section.questions, 'question')} open"


def _many(number: int, what: str) -> str:
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


def _part(section: Section, links: Mapping[str, str]) -> _Part:
    tables = [_table(section.name, table, links) for table in section.tables if table.rows]
    drawn = section.drawn if isinstance(section.drawn, tuple) else ()
    spaces = tuple(space for space in drawn if isinstance(space, Space))
    return _Part(
        section.name,
        clean(section.title),
        tuple(map(clean, section.says)),
        tuple(map(_number, section.figures)),
        tuple(table for table in tables if not table.detail),
        tuple(table for table in tables if table.detail),
        tuple(_Map(held.title, tuple(map(_drawn, held.drawings))) for held in maps(spaces)),
        tuple(states(spaces)),
    )


def _number(figure: Figure) -> _Number:
    kind = _GOOD[figure.good]
    whole = "" if figure.whole is None else f"of {figure.whole}"
    return _Number(str(figure.number), whole, clean(figure.what), kind, *_SIGNS[kind])


def _drawn(drawing: Drawing) -> _Drawn:
    marks = [
        f'<text class="address" x="{mark.x}" y="{mark.y}" text-anchor="{mark.anchor}">{escaped(mark.text)}</text>\n'
        for mark in drawing.marks
    ]
    return _Drawn(drawing, "".join([*marks, *map(_box, drawing.boxes)]))


def _box(box: Box) -> str:
    rect = f'<rect class="{box.state}" x="{box.x}" y="{box.y}" width="{box.width}" height="{box.height}"/>'
    texts = [f'<text class="name" x="{one.x}" y="{one.y}">{escaped(one.text)}</text>' for one in box.texts]
    return f"<g><title>{escaped(box.title)}</title>{rect}{''.join(texts)}</g>\n"


def _table(section: str, table: SectionTable, links: Mapping[str, str]) -> _Table:
    marked = any(table.kinds)
    full = [at for at in range(len(table.columns)) if any(row[at] not in (None, "") for row in table.rows)]
    texts = {at: [clean(cell_text(row[at])) for row in table.rows] for at in full}
    many = len(table.rows)
    return _Table(
        f"{section}-{table.name}",
        clean(table.title),
        clean(table.title.partition(". ")[0]),
        f"{many} row" if many == 1 else f"{many} rows",
        tuple(clean(table.columns[at].replace("_", " ")) for at in full),
        marked,
        "".join(_rows(f"{section}-{table.name}", table, texts, marked, links)),
        table.detail,
        many <= OPEN,
        _shares(table, texts, marked) if len(full) >= BROAD else (),
    )


def _shares(table: SectionTable, held: Mapping[int, Sequence[str]], marked: bool) -> tuple[str, ...]:
    """How much of the width each column gets, in percent: room for its words, and more where there is more to read."""
    needs, wishes = ([_EDGES], [0]) if marked else ([], [])
    for at, cells in held.items():
        texts = [table.columns[at].replace("_", " "), *cells]
        longest = max(map(len, _LETTERS.findall(" ".join(texts))), default=0)
        room = min(longest, _WORD)
        needs.append(room + _EDGES)
        wishes.append(max(min(sum(map(len, texts)) // len(texts), _MOST) - room, 0))
    spare = max(_WHOLE - sum(needs), 0) / max(sum(wishes), 1)
    widths = [need + wish * spare for need, wish in zip(needs, wishes, strict=True)]
    return tuple(f"{100 * width / sum(widths):.1f}" for width in widths)


def _counts(table: SectionTable, at: int) -> bool:
    """Whether a column holds numbers alone."""
    held = [row[at] for row in table.rows if row[at] is not None]
    return bool(held) and all(isinstance(cell, int) for cell in held)


def _rows(
    anchor: str, table: SectionTable, texts: Mapping[int, Sequence[str]], marked: bool, links: Mapping[str, str]
) -> Iterator[str]:
    """The rows, with the cells of the columns that have texts."""
    columns = []
    for at, held in texts.items():
        style = ' class="number"' if _counts(table, at) else ""
        cells = zip((cells[at] for cells in table.rows), held, strict=True)
        columns.append([f"<td{style}>{_cell(cell, text, links)}</td>" for cell, text in cells])
    for number, row in enumerate(zip(*columns, strict=True)):
        kind = table.kinds[number] if table.kinds else ""
        style = f' class="{kind}"' if kind else ""
        yield f'<tr id="{anchor}-{number + 1}"{style}>{_sign(kind) if marked else ""}{"".join(row)}</tr>\n'


def _sign(kind: str) -> str:
    sign, said = _SIGNS[kind]
    return f'<td class="sign"><span aria-hidden="true">{sign}</span><span class="said">{said}</span></td>'


def _cell(cell: Cell, text: str, links: Mapping[str, str]) -> str:
    """A cell with its text."""
    if cell is None or isinstance(cell, int):
        return text
    text = escaped(text)
    if isinstance(cell, Span):
        return f"<code>{text}</code>"
    if isinstance(cell, Citation):
        return f'<span class="source">{text}</span>'
    link = links.get(cell)
    return text if link is None else f'<a href="{escaped(clean(link))}"><code>{text}</code></a>'


def _place(span: Span) -> str:
    return f"{span.file.path}:{span.position()[0]}"


def _rows_by_place(section: Section) -> dict[str, str]:
    """The anchors of the rows that show a place of a file."""
    anchors: dict[str, str] = {}
    for table in section.tables:
        for number, row in enumerate(table.rows, 1):
            for cell in row:
                if isinstance(cell, Span):
                    anchors.setdefault(_place(cell), f"{section.name}-{table.name}-{number}")
    return anchors


def _finding(number: int, section: Section, found: Diagnostic, rows: Mapping[str, str]) -> _Finding:
    kind = "bad" if found.severity is Severity.ERROR else "warning"
    places = [_place(found.span), *(_place(label.span) for label in found.labels)]
    link = next((rows[place] for place in places if place in rows), section.name)
    return _Finding(
        f"finding-{number}",
        kind,
        _SIGNS[kind][0],
        found.severity.value,
        found.code,
        clean(found.message),
        clean(found.help),
        clean(places[0]),
        link,
        clean(section.title),
        tuple(_labels(found)),
    )


def _labels(found: Diagnostic) -> Iterator[str]:
    for label in found.labels:
        yield clean(f"{_place(label.span)}: {label.text}")
