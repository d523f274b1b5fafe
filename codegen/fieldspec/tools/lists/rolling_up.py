"""Rolls up the rows of a list that repeat: equal registers whose names end in a number, and equal groups of them.

Only what is certain is rolled up: at least three times the same facts, at one distance, with numbers that follow each
other. A list of what is rolled up, expanded, has the same registers as the list.
"""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence

from fieldspec.foundation.classes import dataclass, replace
from fieldspec.tools.lists.entries import Entry
from fieldspec.tools.lists.naming import named, snake
from fieldspec.tools.lists.row_reading import FIELD, REGISTER, ListRow
from fieldspec.tools.lists.shapes import BIT
from fieldspec.tools.lists.words import folded

_FEWEST = 3
_NUMBER = re.compile(r"[0-9]+")
_OWN_TEXTS = ("address", "name", "printed_name")
"""The cells in which repeated rows differ."""


@dataclass(frozen=True, slots=True)
class _Numbered:
    """A register whose name and printed name have a number: the parts of both around it, and its facts."""

    entry: Entry
    number: int
    before: str
    behind: str
    printed: tuple[str, str]
    facts: object


@dataclass(frozen=True, slots=True)
class _Run:
    """Registers that repeat, in their order."""

    members: tuple[_Numbered, ...]
    stride: int

    @property
    def first(self) -> _Numbered:
        """The first of them."""
        return self.members[0]

    @property
    def words(self) -> int:
        """The words of each."""
        return self.first.entry.shape.words


def rolled_up(entries: Sequence[Entry]) -> list[Entry]:
    """The entries in their order, those that repeat as arrays, or as fields of tables, in the place of the first."""
    names = [named(entry.row.names, entry.row.address) if entry.is_own else "" for entry in entries]
    times = Counter(names)
    scales = {folded(entry.row.texts["scale"]) for entry in entries if "scale" in entry.row.texts}
    numbered: dict[object, list[_Numbered]] = defaultdict(list)
    for entry, name in zip(entries, names, strict=True):
        if times[name] == 1 and _may_repeat(entry) and scales.isdisjoint(map(folded, entry.row.names)):
            for part in _numbered(entry, name):
                numbered[entry.space, part.before, part.behind, part.printed, part.facts].append(part)
    runs = [run for parts in numbered.values() for run in _runs(parts)]
    rolled: dict[int, Entry] = {}
    for table in _tables(runs, times, entries):
        _replace(table, rolled)
    for run in sorted(runs, key=lambda run: -len(run.members)):
        base = run.first.before.rstrip("_")
        if not run.first.behind and base and base not in times and run.first.before == f"{base}_":
            _replace({run.first.entry.row.row: (_array(run, base), run)}, rolled)
    return [rolled.get(entry.row.row, entry) for entry in entries if rolled.get(entry.row.row, entry) is not _GONE]


_GONE = Entry(ListRow(0), shape=None, space="")  # type: ignore[arg-type]
"""Stands for a row that an earlier one has."""


def _replace(parts: Mapping[int, tuple[Entry, _Run]], rolled: dict[int, Entry]) -> None:
    """Puts entries in the places of the first rows of runs, unless another run has one of the rows."""
    rows = [member.entry.row.row for _, run in parts.values() for member in run.members]
    if not any(row in rolled for row in rows):
        rolled |= dict.fromkeys(rows, _GONE)
        rolled |= {row: entry for row, (entry, _) in parts.items()}


def _may_repeat(entry: Entry) -> bool:
    row = entry.row
    can_repeat = entry.kind == REGISTER and entry.is_own and not row.is_own and not entry.bits and row.const is None
    return can_repeat and entry.shape.count == 1 and row.place is None and entry.shape.type != BIT


def _numbered(entry: Entry, name: str) -> Iterator[_Numbered]:
    """A register by each number in its name that its printed name has too."""
    row = entry.row
    printed = row.texts.get("printed_name") or next(iter(row.names), "")
    texts = tuple(sorted((role, text) for role, text in row.texts.items() if role not in _OWN_TEXTS))
    facts = (entry.shape, texts, row.doubts, row.unit, row.scale, row.offset, row.order, row.access)
    if "{" in printed or "}" in printed:
        return
    for match in _NUMBER.finditer(name):
        digits = match[0]
        places = [other for other in _NUMBER.finditer(printed) if other[0] == digits]
        if len(places) == 1 and digits == str(int(digits)):
            printed_parts = printed[: places[0].start()], printed[places[0].end() :]
            yield _Numbered(entry, int(digits), name[: match.start()], name[match.end() :], printed_parts, facts)


def _runs(parts: Sequence[_Numbered]) -> Iterator[_Run]:
    """The longest runs of rows in their order, with numbers that follow each other and addresses at one distance."""
    run: list[_Numbered] = []
    stride = 0
    for part in parts:
        step = part.entry.row.address - run[-1].entry.row.address if run else 0
        follows = bool(run) and part.number == run[-1].number + 1 and step >= part.entry.shape.words
        if follows and (len(run) == 1 or step == stride):
            run, stride = [*run, part], step
            continue
        if len(run) >= _FEWEST:
            yield _Run(tuple(run), stride)
        run, stride = ([run[-1], part], step) if follows else ([part], 0)
    if len(run) >= _FEWEST:
        yield _Run(tuple(run), stride)


def _array(run: _Run, base: str) -> Entry:
    """The registers of a run as one with a count."""
    return _rolled(run, REGISTER, base, base, "{n}".join(run.first.printed))


def _tables(
    runs: Sequence[_Run], times: Mapping[str, int], entries: Sequence[Entry]
) -> Iterator[dict[int, tuple[Entry, _Run]]]:
    """The fields of each table, by the rows that they are in the place of. No other row is between its elements."""
    groups: dict[object, list[_Run]] = defaultdict(list)
    for run in runs:
        first = run.first
        groups[first.entry.space, first.before, first.number, len(run.members), run.stride].append(run)
    for group in groups.values():
        table = group[0].first.before.strip("_")
        fields = [snake(run.first.behind.strip("_")) for run in group]
        ends = sorted((run.first.entry.row.address, run.words) for run in group)
        size = ends[-1][0] + ends[-1][1] - ends[0][0]
        is_certain = len(group) > 1 and all(fields) and len({*fields}) == len(fields) and size <= group[0].stride
        is_certain = is_certain and not _has_others(group, ends[0][0], entries)
        if is_certain and table and table not in times:
            yield {
                run.first.entry.row.row: (
                    _rolled(run, FIELD, f"{table}.{name}", run.first.printed[1].strip(" _-.:") or name, ""),
                    run,
                )
                for run, name in zip(group, fields, strict=True)
            }


def _has_others(group: Sequence[_Run], start: int, entries: Sequence[Entry]) -> bool:
    """Whether rows lie among the elements of a table that are not in it."""
    end = start + group[0].stride * len(group[0].members)
    rows = {member.entry.row.row for run in group for member in run.members}
    space = group[0].first.entry.space
    return any(
        entry.space == space and start <= entry.row.address < end and entry.row.row not in rows for entry in entries
    )


def _rolled(run: _Run, kind: str, name: str, printed: str, element_name: str) -> Entry:
    """The first entry of a run for all of them."""
    entry, count = run.first.entry, len(run.members)
    texts = {role: text for role, text in entry.row.texts.items() if role != "printed_name"}
    texts |= {"name": name, "first": str(run.first.number)}
    row = replace(entry.row, kind=kind, count=count, stride=run.stride, names=(printed,), texts=texts)
    rows = tuple(member.entry.row for member in run.members)
    shape = replace(entry.shape, count=count if kind == REGISTER else 1)
    return replace(entry, row=row, shape=shape, rows=rows, element_name=element_name)
