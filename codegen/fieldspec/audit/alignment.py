"""Finds the lines of one edition of a manual in another, by the hashes of the lines."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import SequenceMatcher

from fieldspec.audit.manual_index import ManualIndex
from fieldspec.classes import dataclass


@dataclass(frozen=True, slots=True)
class Aligned:
    """A manual whose lines are known by their numbers in the edition that the spec cites.

    `known` gives for each line of the text at hand the cited number, `here` the line at hand for a cited number. A line
    that only the text at hand has is known by the cited line before it, and is in `new`. Cited lines that are gone are
    in `gone`; those that say something else at the same place, in `changed`. `same` is how many of the `whole` lines
    with text are there unchanged.
    """

    index: ManualIndex
    known: Sequence[int]
    here: dict[int, int]
    new: frozenset[int]
    gone: frozenset[int]
    changed: frozenset[int]
    same: int
    whole: int

    def line(self, cited: int) -> str:
        """What stands on a line that the spec cites; nothing where it is gone."""
        at = self.here.get(cited)
        return self.index.lines[at - 1] if at else ""


def unmoved(index: ManualIndex) -> Aligned:
    """A manual in the edition that the spec cites."""
    numbers = range(1, len(index.lines) + 1)
    whole = sum(map(bool, index.digests))
    return Aligned(index, numbers, {one: one for one in numbers}, frozenset(), frozenset(), frozenset(), whole, whole)


def aligned(cited: ManualIndex, index: ManualIndex) -> Aligned:
    """The lines of `index`, a text at hand, by those of `cited`, the edition that the spec cites."""
    if list(cited.digests) == list(index.digests):
        return unmoved(index)
    old = [number for number, digest in enumerate(cited.digests, 1) if digest]
    new = [number for number, digest in enumerate(index.digests, 1) if digest]
    here: dict[int, int] = {}
    changed: set[int] = set()
    added: set[int] = set()
    same = 0
    matcher = SequenceMatcher(
        None, [cited.digests[at - 1] for at in old], [index.digests[at - 1] for at in new], autojunk=False
    )
    for tag, first, last, begin, end in matcher.get_opcodes():
        here.update(zip(old[first:last], new[begin:end], strict=False))
        if tag == "equal":
            same += last - first
        else:
            changed.update(old[first : first + min(last - first, end - begin)])
            added.update(new[begin + min(last - first, end - begin) : end])
    by_line = {line: number for number, line in here.items()}
    known = []
    before = 1
    for number in range(1, len(index.lines) + 1):
        before = by_line.get(number, before)
        known.append(before)
    gone = frozenset(old) - here.keys()
    return Aligned(index, known, here, frozenset(added), gone, frozenset(changed), same, len(old))
