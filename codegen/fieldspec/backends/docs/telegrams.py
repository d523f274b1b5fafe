"""Messages that are nothing but words of data, word by word beside each other."""

from __future__ import annotations

from fieldspec.backends.docs.context import Context
from fieldspec.backends.docs.document import Cell, Column, Row, Section, Table, cell, code, label, plain, styled, table
from fieldspec.layout.frame import LinkLayout
from fieldspec.layout.message import MessageLayout
from fieldspec.layout.record import FieldLayout, RecordLayout

DIRECTIONS = ("request", "response")
MOST_WORDS = 64


def telegrams(context: Context) -> Section:
    """A table for each link whose frames are words of data only, with one column for each message and direction."""
    blocks = [made for link in context.layout.links.values() if (made := _table(link)) is not None]
    names = sorted({link.link.message_name for link in context.layout.links.values() if _worded(link)})
    title = " and ".join(f"{name.capitalize()}s" for name in names) or "Telegrams"
    return Section("words", (plain(f"{title} word by word"),), tuple(blocks))


def _worded(link: LinkLayout) -> bool:
    """Whether a link has messages that only their number tells apart, all of whole words."""
    bare = all(not link.frame(direction).head and not link.frame(direction).tail for direction in DIRECTIONS)
    numbered = [laid for laid in link.messages.values() if laid.message.number is not None]
    return bare and bool(numbered) and all(_words(laid.data(d)) is not None for laid in numbered for d in DIRECTIONS)


def _words(record: RecordLayout) -> int | None:
    """The words of a record of whole words that is not too long to be shown."""
    whole = record.size is not None and all(field.offset % 2 == 0 for field in record.fields)
    words = (record.size or 0) // 2
    return words if whole and record.size == 2 * words and words <= MOST_WORDS else None


def _table(link: LinkLayout) -> Table | None:
    if not _worded(link):
        return None
    columns = [Column("Word", "number", kept=True)]
    shown: list[RecordLayout] = []
    numbered = [laid for laid in link.messages.values() if laid.message.number is not None]
    for laid in sorted(numbered, key=lambda laid: laid.message.number or 0):
        for direction in DIRECTIONS:
            columns.append(Column(_title(link, laid, direction), kept=True))
            shown.append(laid.data(direction))
    most = max((_words(record) or 0 for record in shown), default=0)
    rows = [Row((cell(str(word + 1)), *(_at(record, word) for record in shown))) for word in range(most)]
    return table(f"Words of {link.link.title or link.name}", columns, rows)


def _title(link: LinkLayout, laid: MessageLayout, direction: str) -> str:
    return f"{laid.message.number} {link.link.direction_name(direction)}"


def _at(record: RecordLayout, word: int) -> Cell:
    """What lies in a word: the field that starts there, or that goes on there."""
    field = next((one for one in record.fields if one.offset <= 2 * word < (one.end or 0)), None)
    if field is None:
        return Cell()
    if field.offset < 2 * word:
        return cell(styled("goes on", "quiet"))
    if field.field.reserved:
        return cell(styled("reserved", "badge"))
    return _named(field)


def _named(field: FieldLayout) -> Cell:
    link = f"#{field.field.place.path}"
    printed = [(label(field.field.printed_name),)] if field.field.printed_name else []
    return cell((code(field.name, link),), *printed)
