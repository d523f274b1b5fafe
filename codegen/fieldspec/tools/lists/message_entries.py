"""Messages and their signals as entries: each signal is a field of whole bytes, or bits in a word with others."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from fieldspec.foundation.classes import replace
from fieldspec.language.model.encoding import is_real
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.tools.lists.assumption import Refusal
from fieldspec.tools.lists.entries import Bit, Entry
from fieldspec.tools.lists.row_reading import MESSAGE, ListRow, SignalPlace
from fieldspec.tools.lists.shapes import Shape
from fieldspec.tools.lists.type_words import Typed

_WIDEST = 8
_MOST_SIGNIFICANT_LAST = "DCBA"


def message_entries(rows: Sequence[ListRow], refused_before: Mapping[int, str], refused: list[Refusal]) -> list[Entry]:
    """The messages among some rows, each before its fields."""
    messages: dict[int, ListRow] = {}
    signals: dict[int, list[ListRow]] = {}
    for row in rows:
        if row.row in refused_before:
            continue
        if row.kind != MESSAGE:
            signals.setdefault(row.address, []).append(row)
        elif row.address in messages:
            refused.append(Refusal(row.row, "", "", f"has the identifier of row {messages[row.address].row}"))
        else:
            messages[row.address] = row
    result: list[Entry] = []
    for identifier, message in messages.items():
        result.append(Entry(message, Shape("bytes", 0), message.space))
        for group in _groups(signals.pop(identifier, ())):
            result += _fields(group, refused)
    refused += [
        Refusal(row.row, "", "", "belongs to a message that is not taken") for rows in signals.values() for row in rows
    ]
    return result


def place_of(row: ListRow) -> SignalPlace:
    """The place of a signal or of the data of a message."""
    assert row.place is not None
    return row.place


def _groups(signals: Sequence[ListRow]) -> Iterator[list[ListRow]]:
    """The signals that share bytes with each other, in the order of the bytes."""
    group: list[ListRow] = []
    last = -1
    for row in sorted(signals, key=lambda row: (place_of(row).first_byte, place_of(row).last_byte)):
        if group and place_of(row).first_byte > last:
            yield group
            group = []
        group.append(row)
        last = max(last, place_of(row).last_byte)
    if group:
        yield group


def _fields(group: Sequence[ListRow], refused: list[Refusal]) -> Iterator[Entry]:
    """The field of signals that share bytes; none if the language has no such word."""
    places = [place_of(row) for row in group]
    first, last = places[0].first_byte, max(place.last_byte for place in places)
    size = last - first + 1
    orders = {place.order for place in places if place.first_byte != place.last_byte} or {places[0].order}
    reals = [row for row in group if row.type is not None and is_real(PRIMITIVES[row.type.name].encoding)]
    reason = ""
    if size > _WIDEST:
        reason = f"is among signals that share {size} bytes, and a word has {_WIDEST}"
    elif len(orders) > 1:
        reason = "shares bytes with signals in the other byte order"
    elif reals and (len(group) > 1 or places[0].size != size * 8):
        reason = "is a real number that shares bytes"
    if reason:
        refused += [Refusal(row.row, "", "", reason) for row in group]
        return
    order = next(iter(orders))
    word = SignalPlace(first * 8, size * 8, order)
    orders_text = _MOST_SIGNIFICANT_LAST if order == "little" and size > 1 else ""
    row = replace(group[0], place=word, order=orders_text)
    if len(group) == 1 and places[0].size == size * 8:
        name = row.type.name if row.type is not None else "u64"
        own_type = name if reals else f"{name[0]}{size * 8}"
        yield Entry(replace(row, type=Typed(own_type)), Shape(own_type, (size + 1) // 2), row.space)
        return
    bits = tuple(Bit(*_bits(place_of(row), word), "", row) for row in group)
    whole = ListRow(row.row, row.address, names=(), kind=row.kind, space=row.space, place=word, order=orders_text)
    shape = Shape(f"u{size * 8}", (size + 1) // 2)
    yield Entry(whole, shape, row.space, tuple(sorted(bits, key=lambda bit: bit.low)), is_own=False)


def _bits(place: SignalPlace, word: SignalPlace) -> tuple[int, int]:
    """The lowest and the highest bit of a signal in its word, counted from the least significant one."""
    first, order = place.first, word.order
    if place.order != order:  # a signal within one byte, whose bits are counted from the other end
        first = place.first_byte * 8 + 8 - place.first % 8 - place.size
    start = first - word.first
    low = start if order == "little" else word.size - start - place.size
    return low, low + place.size - 1
