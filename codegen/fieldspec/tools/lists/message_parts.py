"""The messages of a list, as lines of a spec, with the links that carry them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from fieldspec.tools.lists.entries import Entry
from fieldspec.tools.lists.message_entries import place_of
from fieldspec.tools.lists.own_parts import Line
from fieldspec.tools.lists.row_reading import MESSAGE, SIGNAL

_LINKS = {False: ("standard", 11, "u16"), True: ("extended", 29, "u32")}
"""The name of a link, how many bits its identifiers have, and their type, by whether they are wide."""

_IDENTIFIERS = (1 << 29) - 1


def links(entries: Sequence[Entry]) -> Iterator[Line]:
    """The section of links: a bus for each length of identifiers."""
    messages = [entry for entry in entries if entry.kind == MESSAGE]
    if messages:
        yield "links:", 0
    for is_wide in sorted({place_of(entry.row).is_wide for entry in messages}):
        name, bits, type_name = _LINKS[is_wide]
        row = next(entry.row.row for entry in messages if place_of(entry.row).is_wide is is_wide)
        yield f"  - name: {name}", row
        yield f"    source: 1 L{row}", 0
        yield "    unverified: true", 0
        yield "    byte_order: big", 0
        yield "    word_order: big", 0
        yield f"    can: {{identifier: {bits}}}", 0
        for direction in ("request", "response"):
            yield f"    {direction}:", 0
            yield f"      - {{name: identifier, role: code, type: {type_name}, bits: 0..{bits - 1}}}", 0
            yield "      - {name: data, role: body}", 0


def messages(entries: Sequence[Entry], fact: Callable[[int], str]) -> Iterator[Line]:
    """The section of messages. `fact` gives the keys of the field at a place among the entries."""
    if any(entry.kind == MESSAGE for entry in entries):
        yield "messages:", 0
    fields: dict[int, list[int]] = {}
    for place, entry in enumerate(entries):
        if entry.kind == SIGNAL:
            fields.setdefault(entry.row.address, []).append(place)
    for place, entry in enumerate(entries):
        if entry.kind != MESSAGE:
            continue
        row, data = entry.row, place_of(entry.row)
        is_response = data.direction == "response"
        only = "requested: false" if is_response else "answered_on: []"
        code = f"code: 0x{row.address & _IDENTIFIERS:X}, links: [{_LINKS[data.is_wide][0]}]"
        yield f"  - {{{fact(place)}, {code}, {only}, {'response' if is_response else 'request'}: [", row.row
        end, last = 0, row.row
        for number in fields.get(row.address, ()):
            part_place = place_of(entries[number].row)
            yield from _unused(end, part_place.first_byte, last)
            yield f"      {{{fact(number)}}},", entries[number].row.row
            end, last = part_place.last_byte + 1, entries[number].row.row
        yield from _unused(end, data.size // 8, last)
        yield "    ]}", 0


def _unused(first: int, end: int, row: int) -> Iterator[Line]:
    """A field of bytes that no signal is in."""
    if end > first:
        yield (
            f"      {{name: unused_{first}, type: bytes, length: {end - first}, reserved: true, source: 1 L{row}}},",
            row,
        )
