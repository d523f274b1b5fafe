"""The tables and the parameters of a list, as lines of a spec."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, TypeAlias

from fieldspec.tools.lists.entries import Entry
from fieldspec.tools.lists.item import REGISTERS
from fieldspec.tools.lists.row_reading import FIELD, PARAMETER
from fieldspec.tools.lists.shapes import BIT

Line: TypeAlias = tuple[str, int]
_Tree: TypeAlias = dict[str, Any]


def tables(entries: Sequence[Entry], fact: Callable[[int], str], used_records: Sequence[str]) -> Iterator[Line]:
    """The sections of records and tables, with the lines of records that a protocol gives.

    `fact` gives the keys of the field at a place among the entries.
    """
    trees: dict[tuple[str, str], _Tree] = {}
    for place, entry in enumerate(entries):
        if entry.kind == FIELD:
            table, *inner, last = entry.row.texts["name"].split(".")
            tree = trees.setdefault((entry.space, table), {})
            for name in inner:
                tree = tree.setdefault(name, {})
            tree[last] = place
    if trees or used_records:
        yield "records:", 0
    yield from ((line, 0) for line in used_records)
    for (_, table), tree in trees.items():
        yield from _record(table, tree, entries, fact)
    if trees:
        yield "tables:", 0
    for (space, table), tree in trees.items():
        rows = [entries[place].row for place in _places(tree)]
        first = rows[0]
        base = min(row.address for row in rows)
        width = max(entries[place].row.address + entries[place].shape.words for place in _places(tree)) - base
        own_space = "" if space == REGISTERS else f"space: {space}, "
        numbers = f"base: 0x{base:04X}, stride: {first.stride or width}, count: {first.count}"
        index = f", index_from: {first.texts['first']}" if first.texts.get("first") else ""
        area = f"{own_space}{numbers}{index}"
        lowest = min((entries[place] for place in _places(tree)), key=lambda entry: entry.row.address)
        cited = ", ".join([*first.source(), *_elements(lowest)])
        line = f"  - {{name: {table}, {area}, record: {table}, {cited}}}"
        yield line, first.row


def _elements(entry: Entry) -> Iterator[str]:
    """The elements of a table whose rows are rolled up, with the addresses of the lowest field, which the list has."""
    if entry.rows:
        first = int(entry.row.texts["first"])
        numbered = enumerate(entry.rows, first)
        elements = (f'{{index: {n}, at: "0x{row.address:04X}", source: 1 L{row.row}}}' for n, row in numbered)
        yield f"elements: [{', '.join(elements)}]"


def _record(name: str, tree: _Tree, entries: Sequence[Entry], fact: Callable[[int], str]) -> Iterator[Line]:
    """A record, after those within it."""
    for key, inner in tree.items():
        if isinstance(inner, dict):
            yield from _record(f"{name}_{key}", inner, entries, fact)
    first_row = entries[next(_places(tree))].row
    yield f"  - name: {name}", first_row.row
    yield from ((f"    {key}", 0) for key in first_row.source())
    yield "    fields:", 0
    ordered = sorted(tree.items(), key=lambda item: entries[next(_places({"": item[1]}))].row.address)
    end = entries[next(_places({"": ordered[0][1]}))].row.address
    for key, inner in ordered:
        if isinstance(inner, int) and entries[inner].rows:
            part = entries[inner].row
            if part.address > end:
                keys = ["type: bytes", f"length: {2 * (part.address - end)}", "reserved: true", *part.source("")]
                yield f"      - {{name: unused_{end:04x}, {', '.join(keys)}}}", part.row
            end = part.address + entries[inner].shape.words
        if isinstance(inner, dict):
            row = entries[next(_places(inner))].row
            yield f"      - {{name: {key}, record: {name}_{key}, {', '.join(row.source(''))}}}", row.row
        else:
            yield f"      - {{{fact(inner)}}}", entries[inner].row.row


def _places(tree: Mapping[str, Any]) -> Iterator[int]:
    for inner in tree.values():
        if isinstance(inner, dict):
            yield from _places(inner)
        else:
            yield inner


def parameters(
    entries: Sequence[Entry], fact: Callable[[int], str], protocol_names: Mapping[tuple[int, int | None], str]
) -> Iterator[Line]:
    """The sections of parameters, a set for each space, with the elements that have meanings of their own.

    `protocol_names` has the parameters that a protocol gives every device, which stay among the others in their order.
    """
    spaces = dict.fromkeys(entry.space for entry in entries if entry.kind == PARAMETER)
    if spaces:
        yield "parameters:", 0
    for space in spaces:
        places = [place for place, entry in enumerate(entries) if entry.kind == PARAMETER and entry.space == space]
        first_row = entries[places[0]].row
        yield f"  - name: {space}", first_row.row
        yield from ((f"    {key}", 0) for key in first_row.source())
        wholes = {entries[place].row.address: place for place in places if entries[place].row.subindices is None}
        elements: dict[int, list[int]] = {}
        for place in places:
            if entries[place].row.subindices is not None:
                elements.setdefault(entries[place].row.address, []).append(place)
        common = {number: name for (number, subindex), name in protocol_names.items() if subindex is None}
        if not common and max(wholes) - min(wholes) >= len(wholes):
            yield f"    numbers: {min(wholes)}..{max(wholes)}", 0
        yield "    rows:", 0
        for number in sorted({*wholes, *common}):
            if number in wholes:
                names = {subindex: name for (index, subindex), name in protocol_names.items() if index == number}
                yield from _parameter(entries, fact, wholes[number], elements.get(number, ()), names)
            else:
                yield f"      - {{number: {number}, name: {common[number]}, source: 1 L1, unverified: true}}", 0


def _parameter(
    entries: Sequence[Entry],
    fact: Callable[[int], str],
    place: int,
    elements: Sequence[int],
    protocol_names: Mapping[int | None, str],
) -> Iterator[Line]:
    """A parameter, and its elements by their subindices. Those that the file leaves out have no meaning."""
    row = entries[place].row
    if not elements:
        yield f"      - {{{fact(place)}}}", row.row
        return
    yield f"      - {{{fact(place)}, subindices: [", row.row
    yield from ((f"          {{{fact(n)}}},", entries[n].row.row) for n in elements)
    for subindex in _gaps([entries[n].row.subindices or (0, 0) for n in elements], row.count):
        name = f"name: {protocol_names[subindex]}, " if subindex in protocol_names else ""
        yield f"          {{index: {subindex}, {name}reserved: true}},", row.row
    yield "        ]}", 0


def _gaps(indices: Sequence[tuple[int, int]], count: int) -> Iterator[int]:
    """The subindices below `count` that a file leaves out."""
    following = 0
    for first, last in (*sorted(indices), (count, count)):
        yield from range(following, first)
        following = max(following, last + 1)


def spaces(entries: Sequence[Entry]) -> Iterator[str]:
    """The address spaces of registers and tables, where they are not the usual ones: each with its unit."""
    units = {REGISTERS: ""}
    for entry in entries:
        if entry.kind != PARAMETER:
            unit = ", unit: bit" if entry.shape.type == BIT else "" if entry.row.words else ", unit: byte"
            units[entry.space] = unit
    if units != {REGISTERS: ""}:
        allowed = ", allow: {spaces_reachable: The list has no frames.}"
        yield "spaces:"
        yield from (
            f"  - {{name: {name}{unit}{allowed}, source: 1 L1, unverified: true}}" for name, unit in units.items()
        )
