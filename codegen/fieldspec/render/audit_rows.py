"""The tables of an audit as HTML."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from fieldspec.audit.section import Cell, SectionTable
from fieldspec.backends.docs.document import clean
from fieldspec.backends.docs.html import escaped
from fieldspec.model.fact import Citation
from fieldspec.render.audit_cells import SIGNS, cell_text
from fieldspec.source import Span

BROAD = 8
"""A table of so many columns shares out the width, as it would else be wider than paper."""

_WORD, _MOST, _WHOLE, _EDGES = 11, 60, 205, 4
"""When the width is shared out, in letters: the longest word that is never broken, how long a text counts at most, how
much there is to share, and what the edges of a cell and bold letters take."""

_LETTERS = re.compile(r"[A-Za-z]+")


def table_html(section: str, table: SectionTable, links: Mapping[str, str]) -> Iterator[str]:
    """A table, piece by piece; `links` leads from paths of facts to where they are documented."""
    anchor, title = f"{section}-{table.name}", escaped(clean(table.title))
    marked = any(table.kinds)
    full = [at for at in range(len(table.columns)) if any(row[at] not in (None, "") for row in table.rows)]
    texts = {at: [clean(cell_text(row[at])) for row in table.rows] for at in full}
    shares = _shares(table, texts, marked) if len(full) >= BROAD else ()
    widths = "".join([f'<col style="width: {share}%">' for share in shares])
    headings = "".join([f'<th scope="col">{escaped(clean(_heading(table, at)))}</th>' for at in full])
    standing = '<th scope="col"><span class="said">standing</span></th>' if marked else ""
    broad = ' class="broad"' if shares else ""
    yield f'<div class="scroll" role="region" aria-labelledby="{anchor}-title" tabindex="0">\n'
    yield f'<table id="{anchor}"{broad}>\n<caption id="{anchor}-title">{title}</caption>\n'
    yield f"<colgroup>{widths}</colgroup>\n" if shares else ""
    yield f"<thead><tr>{standing}{headings}</tr></thead>\n<tbody>\n"
    yield from _rows(anchor, table, texts, marked, links)
    yield "</tbody>\n</table>\n</div>\n"


def _heading(table: SectionTable, at: int) -> str:
    return table.columns[at].replace("_", " ")


def _shares(table: SectionTable, held: Mapping[int, Sequence[str]], marked: bool) -> tuple[str, ...]:
    """How much of the width each column gets, in percent: room for its words, and more where there is more to read."""
    needs, wishes = ([_EDGES], [0]) if marked else ([], [])
    for at, cells in held.items():
        texts = [_heading(table, at), *cells]
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
    sign, said = SIGNS[kind]
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
