"""The tables and the parameters of an exported list, as lines of a spec."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, TypeAlias

from fieldspec.tools.lists.entries import FIELD, PARAMETER, Entry
from fieldspec.tools.lists.item import REGISTERS
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
        width = max(row.address + (row.words or 1) for row in rows) - base
        own_space = "" if space == REGISTERS else f"space: {space}, "
        numbers = f"base: 0x{base:04X}, stride: {first.stride or width}, count: {first.count}"
        index = f", index_from: {first.texts['first']}" if first.texts.get("first") else ""
        area = f"{own_space}{numbers}{index}"
        line = f"  - {{name: {table}, {area}, record: {table}, source: 1 L{first.row}, unverified: true}}"
        yield line, first.row


def _record(name: str, tree: _Tree, entries: Sequence[Entry], fact: Callable[[int], str]) -> Iterator[Line]:
    """A record, behind those within it."""
    for key, inner in tree.items():
        if isinstance(inner, dict):
            yield from _record(f"{name}_{key}", inner, entries, fact)
    first = entries[next(_places(tree))].row.row
    yield f"  - name: {name}", first
    yield f"    source: 1 L{first}", 0
    yield "    unverified: true", 0
    yield "    fields:", 0
    for key, inner in tree.items():
        if isinstance(inner, dict):
            row = entries[next(_places(inner))].row.row
            yield f"      - {{name: {key}, record: {name}_{key}, source: L{row}, unverified: true}}", row
        else:
            yield f"      - {{{fact(inner)}}}", entries[inner].row.row


def _places(tree: Mapping[str, Any]) -> Iterator[int]:
    for inner in tree.values():
        if isinstance(inner, dict):
            yield from _places(inner)
        else:
            yield inner


def parameters(entries: Sequence[Entry], fact: Callable[[int], str]) -> Iterator[Line]:
    """The sections of parameters, a set for each space."""
    spaces = dict.fromkeys(entry.space for entry in entries if entry.kind == PARAMETER)
    if spaces:
        yield "parameters:", 0
    for space in spaces:
        places = [place for place, entry in enumerate(entries) if entry.kind == PARAMETER and entry.space == space]
        places.sort(key=lambda place: entries[place].row.address)
        yield f"  - name: {space}", entries[places[0]].row.row
        yield f"    source: 1 L{entries[places[0]].row.row}", 0
        yield "    unverified: true", 0
        numbers = [entries[place].row.address for place in places]
        if numbers[-1] - numbers[0] >= len(numbers):
            yield f"    numbers: {numbers[0]}..{numbers[-1]}", 0
        yield "    rows:", 0
        yield from ((f"      - {{{fact(place)}}}", entries[place].row.row) for place in places)


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
