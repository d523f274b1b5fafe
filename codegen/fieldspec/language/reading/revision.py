"""Reads a file of which little has changed: of the lists that the change is in, only the items that have changed.

The tree is equal to that of the whole text, places included. Nodes of what has not changed are the same objects, moved
to their new places, so that whatever depends on them alone need not be made again. Where anything is doubtful or
wrong, there is no such tree, and the whole text is read.
"""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from collections.abc import Iterator

from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.source import SourceFile
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, children
from fieldspec.language.reading.scalars import typed_item
from fieldspec.language.reading.yaml_reader import LARGEST_TREE, parsed_items, size

_ANCHOR = re.compile(r"(?:^|[\s\[{,:])&\S")
"""What may be an anchor: what it names is in several places of a tree."""
_NO_ITEM = re.compile(r"^(?:---|\.\.\.|%)|\t|\ufeff", re.MULTILINE)
"""What may end a document, or mean something else at the beginning of one."""
_ALIAS = re.compile(r"(?:^|[\s\[{,:])\*\S")
_DASH = re.compile(r" *- +")
_SIZES: ByIdentity[Mapping, int] = ByIdentity(limit=10)
"""The limit of the number of values in these trees, whose texts are long."""


@dataclass(frozen=True, slots=True)
class _Change:
    """Some items of a list, with the keys and numbers that lead to the list, and the lines that they fill.

    Characters `start` to `end` of the old text are these lines. `column` is that of the dashes, `next` the place of
    what follows: the next dash, or what ends the list.
    """

    holders: tuple[Mapping | Sequence, ...]
    keys: tuple[str | int, ...]
    first: int
    last: int
    start: int
    end: int
    column: int
    next: int


def revised(file: SourceFile, tree: Mapping) -> Mapping | None:
    """The typed tree of a file, made of the sound `tree` of an earlier text; None where the whole has to be read."""
    old, new = tree.file.text, file.text
    if any("&" in text and _ANCHOR.search(text) for text in (new, old)):
        return None
    before = equal_start(old, new)
    after = min(equal_start(old[::-1], new[::-1]), len(old) - before, len(new) - before)
    shift = len(new) - len(old)
    for change in _changes(tree, before, len(old) - after):
        items = _items(file, change, shift, tree)
        if items is not None:
            result = _replaced(tree, file, change, items, shift)
            if tree in _SIZES:
                _SIZES[result] = _SIZES[tree] + len(file.text[change.start : change.end + shift])
            return result
    return None


def equal_start(left: str, other: str) -> int:
    """How many characters two texts have in common at their beginning."""
    low, high = 0, min(len(left), len(other))
    while low < high:
        middle = (low + high + 1) // 2
        if left[low:middle] == other[low:middle]:
            low = middle
        else:
            high = middle - 1
    return low


def _changes(tree: Mapping, start: int, end: int) -> list[_Change]:
    """The items of lists that characters of the old text are in, the innermost list first."""
    changes: list[_Change] = []
    node: Node = tree
    holders: tuple[Mapping | Sequence, ...] = ()
    keys: tuple[str | int, ...] = ()
    while not isinstance(node, Scalar):
        holders = (*holders, node)
        number: str | int | None = None
        if isinstance(node, Mapping):
            inner_keys = (key for key, value in node.values.items() if value.start <= start and end <= value.end)
            number = next(inner_keys, None)
        else:
            change = _in_list(node, holders, keys, start, end)
            if change is None:
                break
            changes.append(change)
            item = node.items[change.first]
            if change.first == change.last and item.start <= start and end <= item.end:
                number = change.first
        if number is None:
            break
        keys = (*keys, number)
        node = node.items[number] if isinstance(number, int) else node.values[number]  # type: ignore[union-attr]
    return changes[::-1]


def _in_list(
    node: Sequence, holders: tuple[Mapping | Sequence, ...], keys: tuple[str | int, ...], start: int, end: int
) -> _Change | None:
    """The items of a list in block style that characters of its text are in; None for other lists and characters."""
    text = node.file.text
    if not all(isinstance(item, Mapping) for item in node.items):
        return None
    starts = [item.start for item in node.items]
    first = max(bisect_left(starts, start) - 1, 0)
    last = max(bisect_right(starts, end) - 1, first)
    if first and _line(text, starts[first]) >= start:
        first -= 1
    if last + 1 < len(starts) and _line(text, starts[last + 1]) <= end:
        last += 1
    line = _line(text, starts[first])
    match = _DASH.fullmatch(text, line, starts[first])
    if match is None or start <= line:
        return None
    column = match[0].index("-")
    if last + 1 < len(starts):
        following = _line(text, starts[last + 1])
        next_place = following + column
        if _DASH.fullmatch(text, following, starts[last + 1]) is None or text[next_place] != "-":
            return None
    else:
        next_place = node.end
        following = _line(text, next_place) if next_place < len(text) else next_place
    if following < end or (following < len(text) and text[following - 1] != "\n"):
        return None
    return _Change(holders, keys, first, last, line, following, column, next_place)


def _line(text: str, offset: int) -> int:
    """The start of the line of a character."""
    return text.rfind("\n", 0, offset) + 1


def _items(file: SourceFile, change: _Change, shift: int, tree: Mapping) -> tuple[Node, ...] | None:
    """The typed items of the new lines; None where they are not items of the list, or where anything is wrong."""
    lines = file.text[change.start : change.end + shift]
    if _NO_ITEM.search(lines) or _ALIAS.search(lines) or (change.end + shift < len(file.text) and lines[-1:] != "\n"):
        return None
    if len(file.text) > LARGEST_TREE and _SIZES.get_or_compute(tree, size) + len(lines) > LARGEST_TREE:
        return None
    items = parsed_items(file, lines, len(change.keys))
    if items is None or items.start != change.column or not all(isinstance(item, Mapping) for item in items.items):
        return None
    for node in _below(items):
        if node.end == len(lines) and not isinstance(node, Scalar):
            node.end = change.next + shift - change.start  # a block ends where the next token is
        node.start += change.start
        node.end += change.start
    if not all(typed_item(item, change.keys) for item in items.items):
        return None
    return items.items


def _below(node: Node) -> Iterator[Node]:
    """All nodes below a node."""
    for _, inner in children(node):
        yield inner
        yield from _below(inner)


def _replaced(tree: Mapping, file: SourceFile, change: _Change, items: tuple[Node, ...], shift: int) -> Mapping:
    """The tree with other items in a list. What holds the list is copied, the rest is moved."""
    *outer, own = change.holders
    assert isinstance(own, Sequence)
    new: Node
    remaining = own.items[: change.first], own.items[change.last + 1 :]
    for item in (*remaining[0], *remaining[1]):
        _move(item, file, change.end, shift)
    new = Sequence(file, own.start, own.end + shift, (*remaining[0], *items, *remaining[1]))
    for holder, key in zip(reversed(outer), reversed(change.keys), strict=True):
        place = (file, holder.start, holder.end + shift)
        for other, inner in children(holder):
            if other != key:
                _move(inner, file, change.end, shift)
        if isinstance(holder, Mapping):
            new = Mapping(*place, {**holder.values, str(key): new}, holder.keys)
        else:
            number = int(key)
            new = Sequence(*place, (*holder.items[:number], new, *holder.items[number + 1 :]))
    assert isinstance(new, Mapping)
    return new


def _move(node: Node, file: SourceFile, end: int, shift: int) -> None:
    """Moves a node and all below it to their places in a file: what was after the `end` of the old lines."""
    node.file = file
    if node.end >= end:
        node.end += shift
        if node.start >= end:
            node.start += shift
    if node.__class__ is not Scalar:
        for inner in node.items if isinstance(node, Sequence) else node.values.values():  # type: ignore[union-attr]
            _move(inner, file, end, shift)
