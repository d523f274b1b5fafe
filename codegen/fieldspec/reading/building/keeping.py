"""Keeps what is built of entries and rows: versions share the nodes that do not differ, and what is built of them."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias, TypeVar, cast

from fieldspec.reading.building.context import Entry
from fieldspec.reading.nodes import Mapping, Scalar, Sequence

Noun = TypeVar("Noun")

Kept: TypeAlias = dict[object, dict[int, tuple[object, object]]]
"""What is built, by all that it depends on beside its own node, and by the identity of that node in memory.

The node is kept too: as long as it is there, no other one has its identity.
"""


def rows(
    entry: Entry,
    path: str,
    defaults: Mapping | None,
    kept: Kept,
    build: Callable[[Entry], Noun],
    *more: object,
    key: str = "rows",
) -> tuple[Noun, ...]:
    """What is built of the rows of an entry, each under a path with its name; `more` is what else it depends on."""
    same = kept.setdefault((id(defaults), path, entry.section, entry.sources, *more), {})
    if defaults is not None:
        same[id(defaults)] = defaults, None
    return listed(entry, key, path, "name", defaults, same, build)


def listed(
    entry: Entry,
    key: str,
    path: str,
    name: str,
    defaults: Mapping | None,
    same: dict[int, tuple[object, object]],
    build: Callable[[Entry], Noun],
) -> tuple[Noun, ...]:
    """What is built of the list under a key of an entry; `same` has what is built of its items already."""
    held = entry.node.values.get(key)
    made: list[Noun] = []
    for number, item in enumerate(held.items if isinstance(held, Sequence) else ()):
        if not isinstance(item, Mapping):
            continue
        before = same.get(id(item))
        if before is not None:
            made.append(cast("Noun", before[1]))
            continue
        named = item.values.get(name)
        step = named.text if isinstance(named, Scalar) else str(number)
        quiet = len(entry.found)
        noun = build(Entry(item, f"{path}/{step}", entry.found, entry.section, entry.sources, defaults))
        made.append(noun)
        if isinstance(named, Scalar) and len(entry.found) == quiet:  # a finding is for every version
            same[id(item)] = item, noun
    return tuple(made)
