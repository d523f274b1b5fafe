"""A document as Markdown: every text escaped, every block as lines."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache

from fieldspec.targets.docs.document import (
    REUSED,
    Anchors,
    Bits,
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
    Strips,
    headings,
    paths,
    paths_of,
)
from fieldspec.targets.templates import fill

_ENTITIES = {"&": "&amp;", "<": "&lt;", ">": "&gt;"}
_SPECIAL = re.compile(r"[&<>]|[\\`*\[\]|~$!]|(?<![0-9A-Za-z])_|_(?![0-9A-Za-z])|:(?=\w)|@(?=\w)")
# What begins a heading, a quote, a list or a rule at the start of a line.
_BLOCK = re.compile(r"^(?:[#+\-=]|\d+(?=[.)](?:\s|$)))")


def page(document: Document) -> str:
    """The text of a whole page in Markdown."""
    subtitle = f"{escaped(document.subtitle)}\n\n" if document.subtitle else ""
    summary = "".join([f"- {line(pieces)}\n" for pieces in document.summary])
    return fill(
        "docs/page.md.j2",
        title=escaped(document.title),
        identity=document.identity,
        head=subtitle + (f"{summary}\n" if summary else ""),
        contents="".join(_contents(document.sections, "")),
        sections="".join(_sections(document.sections, "##", _Page(document))),
    )


def _contents(sections: tuple[Section, ...], indent: str) -> Iterator[str]:
    """The table of contents: the sections, and those within them."""
    for section in sections:
        yield f"{indent}- [{line(section.title)}](#{section.anchor})\n"
        yield from _contents(section.sections, indent + "  ")


def _sections(sections: tuple[Section, ...], hashes: str, page: _Page) -> Iterator[str]:
    """All sections in order, those within a section after it."""
    for section in sections:
        yield page.section(section, hashes)
        yield from _sections(section.sections, hashes + "#", page)


@lru_cache(maxsize=REUSED)
def escaped(text: str) -> str:
    """Text that means itself, anywhere in a line."""
    text = _SPECIAL.sub(lambda match: _ENTITIES.get(match[0], f"\\{match[0]}"), text)
    return _BLOCK.sub(_at_start, text)


def _at_start(match: re.Match[str]) -> str:
    return f"{match[0]}\\" if match[0].isdigit() else f"\\{match[0]}"


def line(pieces: Line) -> str:
    """A line of text outside of any page, without links into one."""
    return _line(pieces, paths(pieces))


@lru_cache(maxsize=REUSED)
def _line(pieces: Line, lost: tuple[str, ...]) -> str:
    """A line without the links to some paths within the page."""
    return "".join([_piece(piece, lost) for piece in pieces])


@lru_cache(maxsize=REUSED)
def _strip(pieces: Line) -> str:
    return " ".join([_piece(piece, ()) for piece in pieces])


def _piece(piece: Piece, lost: tuple[str, ...]) -> str:
    text = _styled(piece.text, piece.style)
    if not piece.link or not text.strip() or (piece.link[0] == "#" and piece.link[1:] in lost):
        return text
    return f"[{text}]({piece.link})"


@lru_cache(maxsize=REUSED)
def _styled(text: str, style: str) -> str:
    if style in ("code", "changed"):
        monospaced = f"`{text}`" if text and not set(text) & set("`|\\") else escaped(text)
        return f"**{monospaced}**" if style == "changed" else monospaced
    if style in ("strong", "wrong", "open"):
        return _wrapped(text, "**")
    if style in ("badge", "unknown"):
        return _wrapped(text, "*")
    if style == "mark":
        return f" ({escaped(text)})"
    return escaped(text)


def _wrapped(text: str, marks: str) -> str:
    """Emphasis, with the blanks at the ends outside of it."""
    inner = text.strip()
    if not inner:
        return text
    before, _, after = text.partition(inner)
    return f"{before}{marks}{escaped(inner)}{marks}{after}"


@lru_cache(maxsize=REUSED)
def _cell(cell: Cell, lost: tuple[str, ...] = ()) -> str:
    lines = [_line(pieces, lost) for pieces in cell.lines]
    for item in cell.items:
        lines.append(f"• {_line(item.line, lost)}")
        lines += [f"◦ {_line(pieces, lost)}" for pieces in item.inner]
    return "<br>".join(lines)


class _Page:
    """Writes the blocks of a page. Links within the page are kept if they lead to headings: it has no other anchors."""

    def __init__(self, document: Document) -> None:
        self._anchors = Anchors(document.sections)
        self._headings = frozenset(headings(document.sections))

    def section(self, section: Section, hashes: str) -> str:
        """A section without those within it."""
        if section.rendered is None:
            return self._section(section, hashes)
        before = section.rendered.get("markdown")
        if before is not None and self._anchors.have(before.paths) and before.paths - self._headings == before.lost:
            return before.text
        text, links = self._section(section, hashes), paths_of(section)
        if self._anchors.have(links):
            section.rendered["markdown"] = RenderedSection(text, links, links - self._headings)
        return text

    def _section(self, section: Section, hashes: str) -> str:
        heading = f'\n<a id="{section.anchor}"></a>\n\n{hashes} {line(section.title)}\n'
        return "".join([heading, *("\n".join(["", *self._block(block), ""]) for block in section.blocks)])

    def _block(self, block: Block) -> Iterator[str]:
        if isinstance(block, DocumentTable):
            yield from self._table(block)
        elif isinstance(block, Paragraph):
            yield ("> " if block.style else "") + self._line(block.line)
        elif isinstance(block, Facts):
            for term, lines in block.rows:
                yield f"- {escaped(term)}: {'; '.join(map(self._line, lines))}"
        elif isinstance(block, Bits):
            yield from ("```text", block.characters, "```")
        elif isinstance(block, Strips):
            for strip in block.rows:
                yield f"- {escaped(strip.title)}: {_strip(strip.bytes)}"

    def _table(self, table: DocumentTable) -> Iterator[str]:
        yield _wrapped(table.caption, "*").strip()
        yield ""
        yield f"| {' | '.join([escaped(column.title) for column in table.columns])} |"
        yield f"|{'|'.join(['---'] * len(table.columns))}|"
        for row in table.rows:
            cells = [self._linked(cell) if cell.paths else _cell(cell) for cell in row.cells]
            yield f"| {' | '.join(cells)} |"
        if table.footnotes:
            yield ""
        for note in table.footnotes:
            yield f"- ({note.mark}) {self._line(note.line)}"

    def _line(self, pieces: Line) -> str:
        pieces = self._anchors.line(pieces)
        return _line(pieces, self._lost(paths(pieces)))

    def _linked(self, linked_cell: Cell) -> str:
        linked_cell = self._anchors.cell(linked_cell)
        return _cell(linked_cell, self._lost(linked_cell.paths))

    def _lost(self, links: tuple[str, ...]) -> tuple[str, ...]:
        return tuple([path for path in links if path not in self._headings]) if links else links
