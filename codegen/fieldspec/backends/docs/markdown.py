"""A document as Markdown: every text escaped, every block as lines."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache

from fieldspec.backends.docs.anchors import headings
from fieldspec.backends.docs.document import (
    Bits,
    Block,
    Cell,
    Document,
    Facts,
    Line,
    Paragraph,
    Piece,
    Section,
    Strips,
    Table,
)
from fieldspec.classes import dataclass

_ENTITIES = {"&": "&amp;", "<": "&lt;", ">": "&gt;"}
_SPECIAL = re.compile(r"[&<>]|[\\`*\[\]|~$!]|(?<![0-9A-Za-z])_|_(?![0-9A-Za-z])|:(?=\w)|@(?=\w)")
# What begins a heading, a quote, a list or a rule at the start of a line.
_BLOCK = re.compile(r"^(?:[#+\-=]|\d+(?=[.)](?:\s|$)))")


@dataclass(frozen=True, slots=True)
class Entry:
    """A line of the table of contents."""

    indent: str
    text: str
    anchor: str


@dataclass(frozen=True, slots=True)
class Part:
    """A heading with its blocks, each a text of whole lines."""

    hashes: str
    title: str
    anchor: str
    blocks: tuple[str, ...]


def contents(document: Document) -> tuple[Entry, ...]:
    """The sections, and those within them."""
    return tuple(_entries(document.sections, ""))


def _entries(sections: tuple[Section, ...], indent: str) -> Iterator[Entry]:
    for section in sections:
        yield Entry(indent, _line(section.title, frozenset()), section.anchor)
        yield from _entries(section.sections, indent + "  ")


def parts(document: Document) -> tuple[Part, ...]:
    """All sections in order, those within a section behind it."""
    anchors = frozenset(headings(document.sections))
    return tuple(_parts(document.sections, "##", anchors))


def _parts(sections: tuple[Section, ...], hashes: str, anchors: frozenset[str]) -> Iterator[Part]:
    for section in sections:
        blocks = tuple("\n".join(_block(block, anchors)) for block in section.blocks)
        yield Part(hashes, _line(section.title, frozenset()), section.anchor, blocks)
        yield from _parts(section.sections, hashes + "#", anchors)


@lru_cache(maxsize=1 << 16)  # most texts stand on a page often, and on the pages of all versions
def escaped(text: str) -> str:
    """Text that means itself, anywhere in a line."""
    text = _SPECIAL.sub(lambda found: _ENTITIES.get(found[0], f"\\{found[0]}"), text)
    return _BLOCK.sub(_at_start, text)


def _at_start(found: re.Match[str]) -> str:
    return f"{found[0]}\\" if found[0].isdigit() else f"\\{found[0]}"


def line(pieces: Line) -> str:
    """A line of text outside of any page, without links into one."""
    return _line(pieces, frozenset())


def _line(pieces: Line, anchors: frozenset[str]) -> str:
    return "".join([_piece(piece, anchors) for piece in pieces])


def _piece(piece: Piece, anchors: frozenset[str]) -> str:
    text = _styled(piece.text, piece.style)
    if not piece.link or not text.strip():
        return text
    if piece.link.startswith("#") and piece.link[1:] not in anchors:
        return text
    return f"[{text}]({piece.link})"


@lru_cache(maxsize=1 << 16)
def _styled(text: str, style: str) -> str:
    if style in ("code", "changed"):
        shown = f"`{text}`" if text and not set(text) & set("`|\\") else escaped(text)
        return f"**{shown}**" if style == "changed" else shown
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


def _block(block: Block, anchors: frozenset[str]) -> Iterator[str]:
    if isinstance(block, Table):
        yield from _table(block, anchors)
    elif isinstance(block, Paragraph):
        yield ("> " if block.style else "") + _line(block.line, anchors)
    elif isinstance(block, Facts):
        for term, lines in block.rows:
            yield f"- {escaped(term)}: {'; '.join(_line(held, anchors) for held in lines)}"
    elif isinstance(block, Bits):
        yield from ("```text", block.characters, "```")
    elif isinstance(block, Strips):
        for strip in block.rows:
            shown = " ".join(_piece(piece, anchors) for piece in strip.bytes)
            yield f"- {escaped(strip.title)}: {shown}"


def _table(table: Table, anchors: frozenset[str]) -> Iterator[str]:
    yield f"*{escaped(table.caption)}*"
    yield ""
    yield f"| {' | '.join(escaped(column.title) for column in table.columns)} |"
    yield f"|{'|'.join('---' for _ in table.columns)}|"
    for row in table.rows:
        yield f"| {' | '.join(_cell(cell, anchors) for cell in row.cells)} |"
    if table.footnotes:
        yield ""
    for note in table.footnotes:
        yield f"- ({note.mark}) {_line(note.line, anchors)}"


def _cell(cell: Cell, anchors: frozenset[str]) -> str:
    lines = [_line(held, anchors) for held in cell.lines]
    for item in cell.items:
        lines.append(f"• {_line(item.line, anchors)}")
        lines += [f"◦ {_line(held, anchors)}" for held in item.inner]
    return "<br>".join(lines)
