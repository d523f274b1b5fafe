"""Links within a page lead to anchors that are there."""

from __future__ import annotations

from collections.abc import Container, Iterator

from fieldspec.backends.docs.document import (
    BitRow,
    Bits,
    Block,
    Cell,
    Facts,
    Footnote,
    Item,
    Line,
    Paragraph,
    Piece,
    Row,
    Section,
    Table,
)
from fieldspec.classes import replace


def linked(sections: tuple[Section, ...]) -> tuple[Section, ...]:
    """Sections whose links lead to what encloses a fact, where the fact has no anchor of its own."""
    anchors = _Anchors(frozenset(every(sections)))
    return tuple(anchors.section(section) for section in sections)


def innermost(path: str, known: Container[str]) -> str:
    """The innermost of some anchors that encloses a path; an empty one where none does."""
    while path and path not in known:
        path = path.rpartition("/")[0]
    return path


def headings(sections: tuple[Section, ...]) -> Iterator[str]:
    """The anchors of sections, and of those within them."""
    for section in sections:
        yield section.anchor
        yield from headings(section.sections)


def every(sections: tuple[Section, ...]) -> Iterator[str]:
    """The anchors of sections, and of the tables, rows and footnotes in them."""
    for section in sections:
        yield section.anchor
        for block in section.blocks:
            if isinstance(block, Table):
                yield block.anchor
                yield from (row.anchor for row in block.rows)
                yield from (footnote.anchor for footnote in block.footnotes)
        yield from every(section.sections)


class _Anchors:
    """The anchors of a page, and its parts with links to them. Most have the right ones already, and are kept."""

    def __init__(self, known: frozenset[str]) -> None:
        self.known = known

    def target(self, link: str) -> str:
        """A link to the innermost anchor of a path; no link where there is none."""
        if not link.startswith("#"):
            return link
        path = innermost(link[1:], self.known)
        return f"#{path}" if path else ""

    def right(self, line: Line) -> bool:
        """Whether all links of a line lead to anchors."""
        return not any(piece.link and piece.link[1:] not in self.known and piece.link[0] == "#" for piece in line)

    def piece(self, held: Piece) -> Piece:
        """A piece with its link."""
        return replace(held, link=self.target(held.link)) if held.link else held

    def line(self, held: Line) -> Line:
        """A line with its links."""
        return held if self.right(held) else tuple(map(self.piece, held))

    def lines(self, held: tuple[Line, ...]) -> tuple[Line, ...]:
        """Lines with their links."""
        return tuple(map(self.line, held))

    def row(self, held: Row) -> Row:
        """A row with its links."""
        return replace(held, cells=tuple(map(self.cell, held.cells)))

    def cell(self, held: Cell) -> Cell:
        """A cell with its links."""
        if not held.items and all(map(self.right, held.lines)):
            return held
        items = tuple(Item(self.line(item.line), self.lines(item.inner)) for item in held.items)
        return replace(held, lines=self.lines(held.lines), items=items)

    def bits(self, held: BitRow) -> BitRow:
        """Drawn bits with their links."""
        return replace(held, boxes=tuple(replace(box, link=self.target(box.link)) for box in held.boxes))

    def block(self, held: Block) -> Block:
        """A block with its links."""
        if isinstance(held, Table):
            notes = tuple(Footnote(note.mark, note.anchor, self.line(note.line)) for note in held.footnotes)
            return replace(held, rows=tuple(map(self.row, held.rows)), footnotes=notes)
        if isinstance(held, Paragraph):
            return replace(held, line=self.line(held.line))
        if isinstance(held, Facts):
            return Facts(tuple((term, self.lines(lines)) for term, lines in held.rows))
        if isinstance(held, Bits):
            return replace(held, rows=tuple(map(self.bits, held.rows)))
        return held

    def section(self, held: Section) -> Section:
        """A section with its links."""
        return Section(
            held.anchor,
            self.line(held.title),
            tuple(map(self.block, held.blocks)),
            tuple(map(self.section, held.sections)),
        )
