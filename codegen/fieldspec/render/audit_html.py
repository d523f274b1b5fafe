"""The audit report of a device as an HTML page."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from fieldspec.audit.section import Cell, Figure, Report, Section, SectionTable
from fieldspec.backends.docs.site import SCRIPTS, PagePlace, panel, policy, scripts
from fieldspec.backends.templates import fill, text
from fieldspec.diagnostics import Diagnostic, Severity, in_order
from fieldspec.html_text import clean, escaped
from fieldspec.model.device import Device
from fieldspec.model.fact import Citation
from fieldspec.render.audit_formats import SIGNS, cell_text
from fieldspec.render.audit_map import Box, Drawing, maps, states
from fieldspec.source import Span

BROAD = 8
"""A table with this many columns or more gets column widths, as it would be wider than paper without them."""

_WORD, _MOST, _WHOLE, _EDGES = 11, 60, 205, 4
"""For column widths, in letters: the longest word that is never broken, the most that counts of a text, the width of a
table, and the room for the edges of a cell and for bold letters."""

_LETTERS = re.compile(r"[A-Za-z]+")
_WIDTH = re.compile(r'<col class="w([0-9]+)-([0-9])">')


def table_html(section: str, table: SectionTable, links: Mapping[str, str]) -> Iterator[str]:
    """A table in pieces; `links` lead from paths of facts to where they are documented."""
    anchor, title = f"{section}-{table.name}", escaped(clean(table.title))
    marked = any(table.kinds)
    full = [index for index in range(len(table.columns)) if any(row[index] not in (None, "") for row in table.rows)]
    texts = {index: [clean(cell_text(row[index])) for row in table.rows] for index in full}
    column_widths = _column_widths(table, texts, marked) if len(full) >= BROAD else ()
    widths = "".join([f'<col class="w{share}">' for share in column_widths])
    headings = "".join([f'<th scope="col">{escaped(clean(_heading(table, index)))}</th>' for index in full])
    standing = '<th scope="col"><span class="said">standing</span></th>' if marked else ""
    broad = ' class="broad"' if column_widths else ""
    yield f'<div class="scroll" role="group" aria-labelledby="{anchor}-title" tabindex="0">\n'
    yield f'<table id="{anchor}"{broad}>\n<caption id="{anchor}-title">{title}</caption>\n'
    yield f"<colgroup>{widths}</colgroup>\n" if column_widths else ""
    yield f"<thead><tr>{standing}{headings}</tr></thead>\n<tbody>\n"
    yield from _rows(anchor, table, texts, marked, links)
    yield "</tbody>\n</table>\n</div>\n"


def _heading(table: SectionTable, index: int) -> str:
    return table.columns[index].replace("_", " ")


def _column_widths(table: SectionTable, cell_texts: Mapping[int, Sequence[str]], marked: bool) -> tuple[str, ...]:
    """The width of each column in percent, as `12-5`: room for its longest word, and more the longer its texts are."""
    needs, wishes = ([_EDGES], [0]) if marked else ([], [])
    for index, cells in cell_texts.items():
        texts = [_heading(table, index), *cells]
        longest = max(map(len, _LETTERS.findall(" ".join(texts))), default=0)
        room = min(longest, _WORD)
        needs.append(room + _EDGES)
        wishes.append(max(min(sum(map(len, texts)) // len(texts), _MOST) - room, 0))
    spare = max(_WHOLE - sum(needs), 0) / max(sum(wishes), 1)
    widths = [need + wish * spare for need, wish in zip(needs, wishes, strict=True)]
    return tuple(f"{100 * width / sum(widths):.1f}".replace(".", "-") for width in widths)


def _counts(table: SectionTable, index: int) -> bool:
    """Whether a column has only numbers."""
    cells = [row[index] for row in table.rows if row[index] is not None]
    return bool(cells) and all(isinstance(cell, int) for cell in cells)


def _rows(
    anchor: str, table: SectionTable, texts: Mapping[int, Sequence[str]], marked: bool, links: Mapping[str, str]
) -> Iterator[str]:
    """The rows, with the columns that are not empty."""
    columns = []
    for index, column_texts in texts.items():
        style = ' class="number"' if _counts(table, index) else ""
        cells = zip((cells[index] for cells in table.rows), column_texts, strict=True)
        columns.append([f"<td{style}>{_cell(cell, text, links)}</td>" for cell, text in cells])
    for number, row in enumerate(zip(*columns, strict=True)):
        kind = table.kinds[number] if table.kinds else ""
        style = f' class="{kind}"' if kind else ""
        yield f'<tr id="{anchor}-{number + 1}"{style}>{_sign(kind) if marked else ""}{"".join(row)}</tr>\n'


def _sign(kind: str) -> str:
    sign, description = SIGNS[kind]
    return f'<td class="sign"><span aria-hidden="true">{sign}</span><span class="said">{description}</span></td>'


def _cell(cell: Cell, text: str, links: Mapping[str, str]) -> str:
    """The HTML of a cell with a text."""
    if cell is None or isinstance(cell, int):
        return text
    text = escaped(text)
    if isinstance(cell, Span):
        return f"<code>{text}</code>"
    if isinstance(cell, Citation):
        return f'<span class="source">{text}</span>'
    link = links.get(cell)
    return text if link is None else f'<a href="{escaped(clean(link))}"><code>{text}</code></a>'


OPEN = 100
"""A table of details with at most this many rows is open, and printed; a longer one is folded."""

_GOOD = {True: "good", False: "bad", None: ""}


def rendered(report: Report, device: Device, links: Mapping[str, str], place: PagePlace | None = None) -> str:
    """The page; `links` lead from paths of facts to where they are documented, where there is such a place.

    `place` is that of the page among the documentation; none where it stands alone.
    """
    section_findings = [(section, finding) for section in report.sections for finding in in_order(section.findings)]
    rows = {section.name: _rows_by_place(section) for section in report.sections if section.findings}
    findings = [
        _finding(number, section, finding, rows[section.name])
        for number, (section, finding) in enumerate(section_findings, 1)
    ]
    parts = "".join([part for section in report.sections for part in _part(section, links)])
    style = text("backends/page.css") + text("render/audit.css") + _width_rules(parts)
    return fill(
        "audit.html.j2",
        title=clean(f"Audit of {report.title}"),
        identity=clean(report.identity),
        style=style,
        policy=policy(style, scripts=place is not None),
        panel=panel(place) if place is not None else "",
        scripts=scripts(place, SCRIPTS[:1]) if place is not None else "",
        contents="".join(map(_entry, report.sections)),
        head=_head(report, device, [finding for _, finding in section_findings]),
        glance="".join(map(_glance, report.sections)),
        findings="".join(['<ol class="findings">\n', *findings, "</ol>\n"]) if findings else "<p>There is none.</p>\n",
        parts=parts,
    )


def _width_rules(page: str) -> str:
    """The style of the columns of some tables: elements have no style of their own, which the page's policy forbids."""
    widths = sorted(set(_WIDTH.findall(page)))
    return "".join([f".w{whole}-{tenth} {{ width: {whole}.{tenth}%; }}\n" for whole, tenth in widths])


def _visible(text: str) -> str:
    return escaped(clean(text))


def _entry(section: Section) -> str:
    """A section in the table of contents, with its tables, those of details last."""
    inner = [
        f'<li><a href="#{_anchor(section, table)}{ending}">{_visible(table.title.partition(". ")[0])}</a></li>\n'
        for table, ending in (
            *((table, "") for table in _tables(section, False)),
            *((table, "-folded") for table in _tables(section, True)),
        )
    ]
    inner_list = f"<ul>\n{''.join(inner)}</ul>\n" if inner else ""
    return f'<li><a href="#{section.name}">{_visible(section.title)}</a>\n{inner_list}</li>\n'


def _tables(section: Section, folded: bool) -> list[SectionTable]:
    return [table for table in section.tables if table.rows and table.detail is folded]


def _anchor(section: Section, table: SectionTable) -> str:
    return f"{section.name}-{table.name}"


def _head(report: Report, device: Device, findings: Sequence[Diagnostic]) -> str:
    """What the report is about, its verdict, and links to the sections with open questions."""
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
    errors = sum(1 for finding in findings if finding.severity is Severity.ERROR)
    warnings = len(findings) - errors
    if errors:
        verdict, kind = f"{_many(errors, 'error')} and {_many(warnings, 'warning')} are open.", "bad"
    elif warnings:
        verdict, kind = f"No error; {_many(warnings, 'warning')} to be examined.", "warning"
    else:
        verdict, kind = "No finding in any part of the audit.", "good"
    subtitle = f'<p class="subtitle">{_visible(device.title)}</p>\n' if clean(device.title) else ""
    facts = "".join([f"<div><dt>{term}</dt><dd>{_visible(value)}</dd></div>\n" for term, value in rows])
    questions = "".join(
        [
            f' <span class="questions"><a href="#{section.name}">{_questions(section)}</a>.</span>'
            for section in report.sections
            if section.questions
        ]
    )
    verdict_line = (
        f'<p class="verdict {kind}"><span aria-hidden="true">{SIGNS[kind][0]}</span> {verdict}{questions}</p>\n'
    )
    return f'{subtitle}<dl class="facts">\n{facts}</dl>\n{verdict_line}'


def _questions(section: Section) -> str:
    return f"The manual leaves {_many(section.questions, 'question')} open"


def _many(number: int, noun: str) -> str:
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def _glance(section: Section) -> str:
    """The figures of a section, for the top of the page."""
    if not section.figures:
        return ""
    title = f'<h3><a href="#{section.name}">{_visible(section.title)}</a></h3>'
    return f"<section>\n{title}\n{_figures(section)}\n</section>\n"


def _figures(section: Section) -> str:
    return "".join(['<ul class="figures">\n', *map(_figure, section.figures), "</ul>\n"])


def _figure(figure: Figure) -> str:
    kind = _GOOD[figure.good]
    sign, description = SIGNS[kind]
    whole = "" if figure.whole is None else f'<span class="whole">of {figure.whole}</span> '
    standing = f'<span class="said">: {description}</span>' if description else ""
    mark = f'<span class="mark" aria-hidden="true">{sign}</span><b>{figure.number}</b>'
    return f'<li class="{kind}">{mark}<span>{whole}{_visible(figure.what)}{standing}</span></li>\n'


def _part(section: Section, links: Mapping[str, str]) -> Iterator[str]:
    """A section: its texts, figures, drawings and tables, those of details last."""
    yield f'<section id="{section.name}">\n<h2>{_visible(section.title)}</h2>\n'
    yield from (f"<p>{_visible(paragraph)}</p>\n" for paragraph in section.paragraphs)
    yield f"{_figures(section)}\n" if section.figures else ""
    yield from _drawn(section)
    for table in _tables(section, False):
        yield from table_html(section.name, table, links)
        yield "\n"
    for table in _tables(section, True):
        row_count = len(table.rows)
        yield f'<details id="{_anchor(section, table)}-folded"{" open" if row_count <= OPEN else ""}>\n'
        yield f"<summary>{_visible(table.title)} ({_many(row_count, 'row')})</summary>\n"
        yield from table_html(section.name, table, links)
        yield "\n</details>\n"
    yield "</section>\n"


def _drawn(section: Section) -> Iterator[str]:
    """The legend, and the drawings of each address space under its title."""
    legend = [
        '<li><svg viewBox="0 0 38 20" aria-hidden="true" focusable="false">'
        f'<rect class="{state}" x="1" y="1" width="36" height="18"/></svg>{escaped(words)}</li>\n'
        for state, words in states(section.spaces)
    ]
    if legend:
        yield "".join(['<ul class="legend" aria-label="Legend">\n', *legend, "</ul>\n"])
    for space_map in maps(section.spaces):
        yield f"<h3>{escaped(space_map.title)}</h3>\n"
        for drawing in space_map.drawings:
            yield from _drawing(drawing)


def _drawing(drawing: Drawing) -> Iterator[str]:
    anchor, caption = escaped(drawing.anchor), escaped(drawing.caption)
    yield f'<figure id="{anchor}">\n<figcaption>{caption}</figcaption>\n'
    yield f'<div tabindex="0" role="region" aria-label="{caption}">\n'
    yield f'<svg role="img" viewBox="0 0 {drawing.width} {drawing.height}"'
    yield f' aria-labelledby="{anchor}-title {anchor}-text">\n'
    yield f'<title id="{anchor}-title">{escaped(drawing.title)}</title>\n'
    yield f'<desc id="{anchor}-text">{escaped(drawing.description)}</desc>\n'
    for mark in drawing.marks:
        place = f'x="{mark.x}" y="{mark.y}" text-anchor="{mark.anchor}"'
        yield f'<text class="address" {place}>{escaped(mark.text)}</text>\n'
    yield from map(_box, drawing.boxes)
    yield "</svg>\n</div>\n</figure>\n\n"


def _box(box: Box) -> str:
    rect = f'<rect class="{box.state}" x="{box.x}" y="{box.y}" width="{box.width}" height="{box.height}"/>'
    texts = [f'<text class="name" x="{text.x}" y="{text.y}">{escaped(text.text)}</text>' for text in box.texts]
    return f"<g><title>{escaped(box.title)}</title>{rect}{''.join(texts)}</g>\n"


def _place(span: Span) -> str:
    return f"{span.file.path}:{span.position()[0]}"


def _rows_by_place(section: Section) -> dict[str, str]:
    """The anchors of rows by the places in files that they show."""
    anchors: dict[str, str] = {}
    for table in section.tables:
        for number, row in enumerate(table.rows, 1):
            for cell in row:
                if isinstance(cell, Span):
                    anchors.setdefault(_place(cell), f"{section.name}-{table.name}-{number}")
    return anchors


def _finding(number: int, section: Section, finding: Diagnostic, rows: Mapping[str, str]) -> str:
    """A finding: severity, message and help, with a link to the row that shows its place."""
    kind = "bad" if finding.severity is Severity.ERROR else "warning"
    places = [_place(finding.span), *(_place(label.span) for label in finding.labels)]
    link = next((rows[place] for place in places if place in rows), section.name)
    labels = [f"; <code>{_visible(f'{_place(label.span)}: {label.text}')}</code>" for label in finding.labels]
    mark = f'<span class="mark" aria-hidden="true">{SIGNS[kind][0]}</span>'
    message = f"<strong>{finding.severity.value}</strong> <code>{finding.code}</code>: {_visible(finding.message)}"
    return "".join(
        [
            f'<li id="finding-{number}" class="{kind}">\n<p>{mark} {message}</p>\n',
            f'<p class="quiet"><code>{_visible(places[0])}</code>{"".join(labels)}.',
            f' See <a href="#{link}">{_visible(section.title)}</a>.</p>\n',
            f"<p>{_visible(finding.help)}</p>\n" if clean(finding.help) else "",
            "</li>\n",
        ]
    )
