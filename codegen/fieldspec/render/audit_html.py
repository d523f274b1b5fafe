"""The audit of a device as a page that stands on its own, to be read, printed and handed on.

The form has what is on every page.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from fieldspec.audit.address_map import Space
from fieldspec.audit.section import Figure, Report, Section, SectionTable
from fieldspec.backends.docs.document import clean
from fieldspec.backends.docs.html import escaped
from fieldspec.backends.forms import filled, text
from fieldspec.diagnostics import Diagnostic, Severity, in_order
from fieldspec.model.device import Device
from fieldspec.render.audit_cells import SIGNS
from fieldspec.render.audit_map import Box, Drawing, maps, states
from fieldspec.render.audit_rows import table_html
from fieldspec.source import Span

OPEN = 100
"""A long table of so many rows is open, and printed; one that has more is folded until somebody opens it."""

_GOOD = {True: "good", False: "bad", None: ""}


def rendered(report: Report, device: Device, links: Mapping[str, str]) -> str:
    """The page; `links` leads from paths of facts to where they are documented, where there is such a place."""
    found = [(section, one) for section in report.sections for one in in_order(section.findings)]
    rows = {section.name: _rows_by_place(section) for section in report.sections if section.findings}
    findings = [_finding(number, section, one, rows[section.name]) for number, (section, one) in enumerate(found, 1)]
    return filled(
        "render/audit.html.in",
        title=_shown(f"Audit of {report.title}"),
        identity=_shown(report.identity),
        style=text("backends/docs/page.css") + text("render/audit.css"),
        contents=map(_entry, report.sections),
        head=_head(report, device, [one for _, one in found]),
        glance=map(_glance, report.sections),
        findings=['<ol class="findings">\n', *findings, "</ol>\n"] if findings else "<p>There is none.</p>\n",
        parts=[held for section in report.sections for held in _part(section, links)],
    )


def _shown(held: str) -> str:
    return escaped(clean(held))


def _entry(section: Section) -> str:
    """A section in the table of contents, with its tables, the folded ones behind the others."""
    inner = [
        f'<li><a href="#{_anchor(section, table)}{ending}">{_shown(table.title.partition(". ")[0])}</a></li>\n'
        for table, ending in (
            *((table, "") for table in _tables(section, False)),
            *((table, "-folded") for table in _tables(section, True)),
        )
    ]
    within = f"<ul>\n{''.join(inner)}</ul>\n" if inner else ""
    return f'<li><a href="#{section.name}">{_shown(section.title)}</a>\n{within}</li>\n'


def _tables(section: Section, folded: bool) -> list[SectionTable]:
    return [table for table in section.tables if table.rows and table.detail is folded]


def _anchor(section: Section, table: SectionTable) -> str:
    return f"{section.name}-{table.name}"


def _head(report: Report, device: Device, found: Sequence[Diagnostic]) -> str:
    """What the report is about, and what it comes to, with a link to each part that has questions."""
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
    subtitle = f'<p class="subtitle">{_shown(device.title)}</p>\n' if clean(device.title) else ""
    facts = "".join([f"<div><dt>{term}</dt><dd>{_shown(held)}</dd></div>\n" for term, held in rows])
    questions = "".join(
        [
            f' <span class="questions"><a href="#{one.name}">{_questions(one)}</a>.</span>'
            for one in report.sections
            if one.questions
        ]
    )
    said = f'<p class="verdict {kind}"><span aria-hidden="true">{SIGNS[kind][0]}</span> {verdict}{questions}</p>\n'
    return f'{subtitle}<dl class="facts">\n{facts}</dl>\n{said}'


def _questions(section: Section) -> str:
    return f"The manual leaves {_many(section.questions, 'question')} open"


def _many(number: int, what: str) -> str:
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


def _glance(section: Section) -> str:
    """The figures of a section, for the top of the page."""
    if not section.figures:
        return ""
    title = f'<h3><a href="#{section.name}">{_shown(section.title)}</a></h3>'
    return f"<section>\n{title}\n{_figures(section)}\n</section>\n"


def _figures(section: Section) -> str:
    return "".join(['<ul class="figures">\n', *map(_figure, section.figures), "</ul>\n"])


def _figure(figure: Figure) -> str:
    kind = _GOOD[figure.good]
    sign, said = SIGNS[kind]
    whole = "" if figure.whole is None else f'<span class="whole">of {figure.whole}</span> '
    standing = f'<span class="said">: {said}</span>' if said else ""
    mark = f'<span class="mark" aria-hidden="true">{sign}</span><b>{figure.number}</b>'
    return f'<li class="{kind}">{mark}<span>{whole}{_shown(figure.what)}{standing}</span></li>\n'


def _part(section: Section, links: Mapping[str, str]) -> Iterator[str]:
    """A section: its texts, its figures, its drawings, and its tables, the folded ones behind the others."""
    yield f'<section id="{section.name}">\n<h2>{_shown(section.title)}</h2>\n'
    yield from (f"<p>{_shown(said)}</p>\n" for said in section.says)
    yield f"{_figures(section)}\n" if section.figures else ""
    yield from _drawn(section)
    for table in _tables(section, False):
        yield from table_html(section.name, table, links)
        yield "\n"
    for table in _tables(section, True):
        many = len(table.rows)
        yield f'<details id="{_anchor(section, table)}-folded"{" open" if many <= OPEN else ""}>\n'
        yield f"<summary>{_shown(table.title)} ({_many(many, 'row')})</summary>\n"
        yield from table_html(section.name, table, links)
        yield "\n</details>\n"
    yield "</section>\n"


def _drawn(section: Section) -> Iterator[str]:
    """The legend, and the drawings of each space under its title."""
    drawn = section.drawn if isinstance(section.drawn, tuple) else ()
    spaces = tuple(space for space in drawn if isinstance(space, Space))
    legend = [
        '<li><svg viewBox="0 0 38 20" aria-hidden="true" focusable="false">'
        f'<rect class="{state}" x="1" y="1" width="36" height="18"/></svg>{escaped(words)}</li>\n'
        for state, words in states(spaces)
    ]
    if legend:
        yield "".join(['<ul class="legend" aria-label="Legend">\n', *legend, "</ul>\n"])
    for held in maps(spaces):
        yield f"<h3>{escaped(held.title)}</h3>\n"
        for drawing in held.drawings:
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
    texts = [f'<text class="name" x="{one.x}" y="{one.y}">{escaped(one.text)}</text>' for one in box.texts]
    return f"<g><title>{escaped(box.title)}</title>{rect}{''.join(texts)}</g>\n"


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


def _finding(number: int, section: Section, found: Diagnostic, rows: Mapping[str, str]) -> str:
    """A finding: how grave it is, what it says, what would make it right, and where it shows."""
    kind = "bad" if found.severity is Severity.ERROR else "warning"
    places = [_place(found.span), *(_place(label.span) for label in found.labels)]
    link = next((rows[place] for place in places if place in rows), section.name)
    labels = [f"; <code>{_shown(f'{_place(label.span)}: {label.text}')}</code>" for label in found.labels]
    mark = f'<span class="mark" aria-hidden="true">{SIGNS[kind][0]}</span>'
    said = f"<strong>{found.severity.value}</strong> <code>{found.code}</code>: {_shown(found.message)}"
    return "".join(
        [
            f'<li id="finding-{number}" class="{kind}">\n<p>{mark} {said}</p>\n',
            f'<p class="quiet"><code>{_shown(places[0])}</code>{"".join(labels)}.',
            f' See <a href="#{link}">{_shown(section.title)}</a>.</p>\n',
            f"<p>{_shown(found.help)}</p>\n" if clean(found.help) else "",
            "</li>\n",
        ]
    )
