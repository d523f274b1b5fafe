"""Links within a page lead to anchors that are there."""

from __future__ import annotations

from collections.abc import Container, Iterator

from fieldspec.backends.docs.document import Bits, Cell, Facts, Item, Line, Paragraph, Section, Table, cell, paths


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


def paths_of(section: Section) -> frozenset[str]:
    """Where the links in a section lead that lead within the page."""
    found = set(paths(section.title))
    for block in section.blocks:
        if isinstance(block, Table):
            found.update(path for row in block.rows for one in row.cells for path in one.paths)
            found.update(path for note in block.footnotes for path in paths(note.line))
        elif isinstance(block, Paragraph):
            found.update(paths(block.line))
        elif isinstance(block, Facts):
            found.update(path for _, lines in block.rows for line in lines for path in paths(line))
        elif isinstance(block, Bits):
            found.update(box.link[1:] for row in block.rows for box in row.boxes if box.link)
    return frozenset(found).union(*map(paths_of, section.sections))


class Anchors:
    """The anchors of a page. Links lead to what encloses a fact, where the fact has no anchor of its own."""

    def __init__(self, sections: tuple[Section, ...]) -> None:
        self._known = frozenset(every(sections))

    def have(self, paths: frozenset[str]) -> bool:
        """Whether some links lead to anchors as they are."""
        return paths <= self._known

    def target(self, link: str) -> str:
        """A link to the innermost anchor of a path; no link where there is none."""
        if not link.startswith("#"):
            return link
        path = innermost(link[1:], self._known)
        return f"#{path}" if path else ""

    def line(self, held: Line) -> Line:
        """A line with its links."""
        if self._known.issuperset(paths(held)):
            return held
        return tuple([piece._replace(link=self.target(piece.link)) for piece in held])

    def cell(self, held: Cell) -> Cell:
        """A cell with its links."""
        if not held.paths or self._known.issuperset(held.paths):
            return held
        items = [Item(self.line(item.line), tuple(map(self.line, item.inner))) for item in held.items]
        return cell(*map(self.line, held.lines), items=items)
