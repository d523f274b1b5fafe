"""A document as HTML: every text escaped, every block as lines. The template has what is on every page."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

from fieldspec.foundation.html_text import escaped
from fieldspec.targets.docs.document import (
    REUSED,
    Anchors,
    BitRow,
    Block,
    Cell,
    Document,
    DocumentTable,
    Facts,
    Line,
    Paragraph,
    Piece,
    RenderedSection,
    Section,
    StateDrawing,
    Strips,
    paths_of,
)
from fieldspec.targets.docs.drawing import state_drawing
from fieldspec.targets.docs.site import SCRIPTS, PagePlace, policy
from fieldspec.targets.templates import fill, style_sheet

_TAGS = {
    "": ("", ""),
    "code": ("<code>", "</code>"),
    "strong": ("<strong>", "</strong>"),
    "changed": ("<mark><code>", "</code></mark>"),
    "mark": ("<sup>", "</sup>"),
}


def page(document: Document, place: PagePlace) -> str:
    """The text of a whole page in HTML."""
    writer = _Page(document)
    subtitle = f'<p class="subtitle">{escaped(document.subtitle)}</p>\n' if document.subtitle else ""
    style = style_sheet("targets/page.css")
    summary = "".join([f"<li>{_writer(document.language).line(line)}</li>" for line in document.summary])
    return fill(
        "docs/page.html.j2",
        title=document.title,
        identity=document.identity,
        style=style,
        policy=policy(style, scripts=True),
        place=place,
        scripts=SCRIPTS,
        head=subtitle + (f'<ul class="summary">{summary}</ul>\n' if summary else ""),
        contents="".join(map(writer.entry, document.sections)),
        sections="".join([piece for section in document.sections for piece in writer.section(section, 2)]),
    )


def _attribute(name: str, value: str) -> str:
    """An attribute with a blank before it; nothing where it has no value."""
    return f' {name}="{escaped(value)}"' if value else ""


@lru_cache(maxsize=1)
def _writer(language: str) -> _Writer:
    """The writer of pages whose labels are in a language; the last one is used again, with what it has stored."""
    return _Writer(language)


class _Writer:
    """Writes lines and cells of pages whose labels are in one language."""

    def __init__(self, language: str) -> None:
        self._tags = _TAGS | {"label": (f"<i{_attribute('lang', language)}>", "</i>")}
        self.line = lru_cache(maxsize=REUSED)(self._line)
        self.cell = lru_cache(maxsize=REUSED)(self._cell)
        self.strip = lru_cache(maxsize=REUSED)(self._strip)

    def _line(self, pieces: Line) -> str:
        return "".join(map(self._piece, pieces))

    def _strip(self, pieces: Line) -> str:
        return "".join([f"{self._piece(piece)} " for piece in pieces])

    def _piece(self, piece: Piece) -> str:
        style = piece.style
        opening, closing = self._tags.get(style) or (f'<span class="{escaped(style)}">', "</span>")
        text = f"{opening}{escaped(piece.text)}{closing}"
        return f'<a href="{escaped(piece.link)}">{text}</a>' if piece.link else text

    def _cell(self, cell: Cell) -> str:
        text = "<br>".join(map(self.line, cell.lines))
        return text + self._items(cell) if cell.items else text

    def _items(self, cell: Cell) -> str:
        items = []
        for item in cell.items:
            inner = "".join(f"<li>{self.line(line)}</li>" for line in item.inner)
            items.append(f"<li>{self.line(item.line)}{f'<ul>{inner}</ul>' if inner else ''}</li>")
        return f"<ul>{''.join(items)}</ul>"


class _Page:
    """Writes the parts of a page, with links that lead to its anchors."""

    def __init__(self, document: Document) -> None:
        self._anchors = Anchors(document.sections)
        self._writer = _writer(document.language)
        self._form = f"html {document.language}"

    def entry(self, section: Section) -> str:
        """A section in the table of contents, with those within it."""
        inner = [
            f'<li><a href="#{escaped(part.anchor)}">{"".join(escaped(piece.text) for piece in part.title)}</a></li>\n'
            for part in section.sections
        ]
        nested = f"<ul>\n{''.join(inner)}</ul>\n" if inner else ""
        return f'<li><a href="#{escaped(section.anchor)}">{self._line(section.title)}</a>\n{nested}</li>\n'

    def section(self, section: Section, level: int) -> Iterator[str]:
        """A section, and those within it, under a heading of a level."""
        if section.rendered is None:
            yield from self._section(section, level)
            return
        before = section.rendered.get(self._form)
        if before is not None and self._anchors.have(before.paths):
            yield before.text
            return
        text, links = "".join(self._section(section, level)), paths_of(section)
        if self._anchors.have(links):
            section.rendered[self._form] = RenderedSection(text, links)
        yield text

    def _section(self, section: Section, level: int) -> Iterator[str]:
        heading = f"<h{level}>{self._line(section.title)}</h{level}>"
        yield f'<section id="{escaped(section.anchor)}">\n{heading}\n'
        for block in section.blocks:
            yield from self._block(block)
        yield "\n"
        for inner_section in section.sections:
            yield from self.section(inner_section, level + 1)
        yield "</section>\n"

    def _line(self, pieces: Line) -> str:
        return self._writer.line(self._anchors.line(pieces))

    def _block(self, block: Block) -> Iterator[str]:
        if isinstance(block, DocumentTable):
            yield from self._table(block)
        elif isinstance(block, Paragraph):
            yield f"<p{_attribute('class', block.style)}>{self._line(block.line)}</p>\n"
        elif isinstance(block, Facts):
            yield '<dl class="facts">\n'
            for term, lines in block.rows:
                terms = "".join(f"<dd>{self._line(line)}</dd>" for line in lines)
                yield f"<div><dt>{escaped(term)}</dt>{terms}</div>\n"
            yield "</dl>\n"
        elif isinstance(block, Strips):
            yield '<dl class="strips">\n'
            for strip in block.rows:
                terms = self._writer.strip(strip.bytes)
                yield f"<div><dt>{escaped(strip.title)}</dt><dd>{terms}</dd></div>\n"
            yield "</dl>\n"
        elif isinstance(block, StateDrawing):
            yield state_drawing(block)
        else:
            yield '<div class="scroll">\n'
            yield from map(self._bits, block.rows)
            yield "</div>\n\n"

    def _table(self, table: DocumentTable) -> Iterator[str]:
        classes = [_attribute("class", column.style) for column in table.columns]
        titles = (
            f'<th scope="col"{style}>{escaped(column.title)}</th>'
            for style, column in zip(classes, table.columns, strict=True)
        )
        yield f'<div class="scroll">\n<table{_attribute("id", table.anchor)}{_attribute("class", table.style)}>\n'
        yield f"<caption>{escaped(table.caption)}</caption>\n"
        yield f"<thead><tr>{''.join(titles)}</tr></thead>\n<tbody>\n"
        # HTML needs no end tags of cells and rows, which are a tenth of such a page.
        tags = [f"<td{style}>" for style in classes]
        if table.heading >= 0:
            tags[table.heading] = f'<th scope="row"{classes[table.heading]}>'
        cell_text, right = self._writer.cell, self._anchors.cell
        for row in table.rows:
            style = ' class="element"' if row.element else ""
            cells = [
                f"{tag}{cell_text(right(cell) if cell.paths else cell)}"
                for cell, tag in zip(row.cells, tags, strict=True)
            ]
            yield f"<tr{_attribute('id', row.anchor)}{style}>{''.join(cells)}\n"
        yield "</tbody>\n</table>\n"
        if table.footnotes:
            yield '<ul class="footnotes">\n'
            for note in table.footnotes:
                mark = f"<sup>{escaped(note.mark)}</sup>"
                yield f'<li id="{escaped(note.anchor)}">{mark} {self._line(note.line)}</li>\n'
            yield "</ul>\n"
        yield "</div>\n\n"

    def _bits(self, row: BitRow) -> str:
        numbers = "".join(f'<th scope="col">{number}</th>' for number in row.numbers)
        boxes = "".join(
            f'<td colspan="{box.width}" class="{escaped(box.style)}">'
            + (
                f'<a href="{escaped(self._anchors.target(box.link))}">{escaped(box.text)}</a>'
                if box.text
                else '<span class="quiet">\u2013</span>'
            )
            + "</td>"
            for box in row.boxes
        )
        return (
            f'<table class="bits">\n<caption>{escaped(row.caption)}</caption>\n'
            f"<thead><tr>{numbers}</tr></thead>\n<tbody><tr>{boxes}</tr></tbody>\n</table>\n"
        )
