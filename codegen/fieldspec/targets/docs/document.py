"""A document before it is HTML or Markdown: sections, tables, lines of styled text, and anchors."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Sequence
from functools import lru_cache
from typing import ClassVar, NamedTuple, TypeAlias

from fieldspec.foundation.classes import dataclass, field, replace
from fieldspec.foundation.html_text import clean

# Both forms are written from this, so that they say the same. Text that comes from a spec enters through `plain`,
# `code` and their like, which leave no control characters in it; each form then escapes it in its own way.
#
# What a page has by the ten thousand, from pieces to rows, are tuples: they are made in a third of the time of other
# classes, and each form can look up what it has written before, as most lines stand on a page often, and on the pages
# of all versions.


class Piece(NamedTuple):
    """Some text in one style. `link` is where it leads: `#path` on this page, or another page; or nowhere.

    The styles: empty, `code`, `strong`, `label` (in the manual's language), `quiet`, `unknown`, `badge`, `wrong`,
    `right`, `open`, `changed` (a byte that differs), and `mark` (the sign of a footnote).
    """

    text: str
    style: str = ""
    link: str = ""


Line: TypeAlias = tuple[Piece, ...]

REUSED = 1 << 16
"""How many texts are remembered as they were written."""


class Item(NamedTuple):
    """A line of a list, and the lines of the list below it."""

    line: Line
    inner: tuple[Line, ...] = ()


class Cell(NamedTuple):
    """Lines below each other, none of them empty, then a list. `paths` are where its links within the page lead."""

    lines: tuple[Line, ...] = ()
    items: tuple[Item, ...] = ()
    paths: tuple[str, ...] = ()

    @property
    def empty(self) -> bool:
        """Whether the cell has neither lines nor items."""
        return not self.items and not self.lines


@dataclass(frozen=True, slots=True)
class TableColumn:
    """A column; `unbroken` says that it stays where all of its cells are empty.

    `search` is `key` where its cells identify rows, such as addresses, and `text` where their words are searched; cells
    of the style `wide` always are.
    """

    title: str
    style: str = ""
    unbroken: bool = False
    search: str = ""


class TableRow(NamedTuple):
    """A row of a table, to which `anchor` leads. An `element` is one of several that the row above stands for."""

    cells: tuple[Cell, ...]
    anchor: str = ""
    element: bool = False


@dataclass(frozen=True, slots=True)
class Footnote:
    """The text below a table that a mark in its cells refers to."""

    mark: str
    anchor: str
    line: Line


@dataclass(frozen=True, slots=True)
class DocumentTable:
    """Rows below titles of columns; its footnotes are below it. `anchor` leads to it, where it has one.

    Its style is `frame` where its rows are the bytes of a frame in order, else empty.

    The cells of the column with the number `heading` name their rows; of none, where it is -1.
    """

    kind: ClassVar[str] = "table"
    caption: str
    columns: tuple[TableColumn, ...]
    heading: int
    rows: tuple[TableRow, ...]
    footnotes: tuple[Footnote, ...] = ()
    anchor: str = ""
    style: str = ""


@dataclass(frozen=True, slots=True)
class Paragraph:
    """A line of text; `style` is empty, `note` or `erratum`."""

    kind: ClassVar[str] = "paragraph"
    line: Line
    style: str = ""


@dataclass(frozen=True, slots=True)
class Facts:
    """Terms with their lines, for what is said once."""

    kind: ClassVar[str] = "facts"
    rows: tuple[tuple[str, tuple[Line, ...]], ...]


@dataclass(frozen=True, slots=True)
class Box:
    """One bit, or the bits of one field, in a drawing, `width` bits wide. Its style is `bit`, `field` or `free`."""

    width: int
    text: str
    link: str
    style: str


@dataclass(frozen=True, slots=True)
class BitRow:
    """Up to sixteen bits, the highest first."""

    caption: str
    numbers: tuple[int, ...]
    boxes: tuple[Box, ...]


@dataclass(frozen=True, slots=True)
class Bits:
    """A word, drawn bit by bit: as boxes, and in characters."""

    kind: ClassVar[str] = "bits"
    rows: tuple[BitRow, ...]
    characters: str


@dataclass(frozen=True, slots=True)
class Strip:
    """Bytes under a title, each in its style."""

    title: str
    bytes: Line


@dataclass(frozen=True, slots=True)
class Strips:
    """Rows of bytes below each other, to be compared."""

    kind: ClassVar[str] = "strips"
    rows: tuple[Strip, ...]


class Arrow(NamedTuple):
    """What leads from a state to another one, by their numbers. An `assumed` one is not printed in the manual."""

    origin: int
    target: int
    text: str
    assumed: bool


@dataclass(frozen=True, slots=True)
class StateDrawing:
    """States below each other, the first one at power-on, with arrows between them; a table says the same."""

    kind: ClassVar[str] = "states"
    title: str
    states: tuple[str, ...]
    arrows: tuple[Arrow, ...]


Block: TypeAlias = DocumentTable | Paragraph | Facts | Bits | Strips | StateDrawing


@dataclass(frozen=True, slots=True)
class RenderedSection:
    """The text of a section in one form.

    `paths` are where its links within the page lead; `lost` are the details that the form has left out.
    """

    text: str
    paths: frozenset[str]
    lost: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class Section:
    """A heading with what stands under it, and the sections within it.

    `written` has what each form has written of it, by the form; there is none where it stands on one page only.
    """

    anchor: str
    title: Line
    blocks: tuple[Block, ...] = ()
    sections: tuple[Section, ...] = ()
    rendered: dict[str, RenderedSection] | None = field(default=None, repr=False, compare=False)


@dataclass(frozen=True, slots=True)
class Document:
    """A page. `language` is that of the manual's labels, a BCP 47 tag or empty."""

    title: str
    subtitle: str
    identity: str
    language: str
    summary: tuple[Line, ...]
    sections: tuple[Section, ...] = field(repr=False)


@lru_cache(maxsize=REUSED)
def _piece(text: str, style: str, link: str) -> Piece:
    return Piece(clean(text), style, link)


def text_piece(text: str, link: str = "") -> Piece:
    """A piece of running text that is not an identifier, with a link if it has one."""
    return _piece(text, "", link)


def code(text: str, link: str = "") -> Piece:
    """An identifier, a number or bytes."""
    return _piece(text, "code", link)


def label(text: str) -> Piece:
    """A label of the manual, in its language."""
    return _piece(text, "label", "")


def styled(text: str, style: str, link: str = "") -> Piece:
    """Text in any style."""
    return _piece(text, style, link)


UNKNOWN = Piece("unknown", "unknown")


def joined(lines: Iterable[Line], between: str = ", ") -> Line:
    """Lines in one, with a text between each two."""
    pieces: list[Piece] = []
    for line in lines:
        pieces += [Piece(between), *line] if pieces else line
    return tuple(pieces)


def cell(*lines: Line | Piece | str, items: Sequence[Item] = ()) -> Cell:
    """A cell of lines, empty ones left out."""
    return _cell(lines, tuple(items))


@lru_cache(maxsize=REUSED)
def _cell(contents: tuple[Line | Piece | str, ...], items: tuple[Item, ...]) -> Cell:
    lines = tuple([line for line in map(_line, contents) if any(piece.text for piece in line)])
    all_lines = [*lines, *(line for item in items for line in (item.line, *item.inner))]
    return Cell(lines, items, tuple([path for line in all_lines for path in paths(line)]))


def _line(content: Line | Piece | str) -> Line:
    if isinstance(content, str):
        return (text_piece(content),)
    return (content,) if isinstance(content, Piece) else content


@lru_cache(maxsize=REUSED)
def paths(line: Line) -> tuple[str, ...]:
    """Where the links of a line lead that lead within the page."""
    return tuple([piece.link[1:] for piece in line if piece.link.startswith("#")])


def table(
    caption: str,
    columns: Sequence[TableColumn],
    rows: Iterable[TableRow],
    footnotes: Sequence[Footnote] = (),
    heading: int = 0,
) -> DocumentTable:
    """A table without the columns that nothing stands in; the cell of column `heading` names its row."""
    rows = list(rows)
    used_columns = [
        n for n, column in enumerate(columns) if column.unbroken or any(not row.cells[n].empty for row in rows)
    ]
    if len(used_columns) < len(columns):
        rows = [row._replace(cells=tuple([row.cells[n] for n in used_columns])) for row in rows]
    return DocumentTable(
        clean(caption),
        tuple([_cleaned(columns[n]) for n in used_columns]),
        used_columns.index(heading) if heading in used_columns else -1,
        tuple(rows),
        tuple(footnotes),
    )


def _cleaned(column: TableColumn) -> TableColumn:
    title = clean(column.title)
    return column if title == column.title else replace(column, title=title)


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
            if isinstance(block, DocumentTable):
                yield block.anchor
                yield from (row.anchor for row in block.rows)
                yield from (footnote.anchor for footnote in block.footnotes)
        yield from every(section.sections)


def paths_of(section: Section) -> frozenset[str]:
    """Where the links in a section lead that lead within the page."""
    linked_paths = set(paths(section.title))
    for block in section.blocks:
        if isinstance(block, DocumentTable):
            linked_paths.update(path for row in block.rows for table_cell in row.cells for path in table_cell.paths)
            linked_paths.update(path for note in block.footnotes for path in paths(note.line))
        elif isinstance(block, Paragraph):
            linked_paths.update(paths(block.line))
        elif isinstance(block, Facts):
            linked_paths.update(path for _, lines in block.rows for line in lines for path in paths(line))
        elif isinstance(block, Bits):
            linked_paths.update(box.link[1:] for row in block.rows for box in row.boxes if box.link)
    return frozenset(linked_paths).union(*map(paths_of, section.sections))


class Anchors:
    """The anchors of a page. A link to a fact without an anchor leads to the fact that encloses it."""

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

    def line(self, pieces: Line) -> Line:
        """A line with its links."""
        if self._known.issuperset(paths(pieces)):
            return pieces
        return tuple([piece._replace(link=self.target(piece.link)) for piece in pieces])

    def cell(self, own: Cell) -> Cell:
        """A cell with its links."""
        if not own.paths or self._known.issuperset(own.paths):
            return own
        items = [Item(self.line(item.line), tuple(map(self.line, item.inner))) for item in own.items]
        return cell(*map(self.line, own.lines), items=items)
