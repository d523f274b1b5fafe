"""The facts and errata that cite each line of a manual."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from operator import itemgetter

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import dataclass, field
from fieldspec.language.model.fact import Citation
from fieldspec.language.model.texts import Erratum
from fieldspec.language.reading.building.citations import citations
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.nodes import Node, Scalar, children
from fieldspec.tools.facts import COLUMNS, FactRow

_OUR_WORDS = ("cause", "remedy", "statement", "task", "step", "step_value")
_NO_CITATIONS = frozenset(
    ("audit", "behaviour", "cells", "device", "label", "literal", "name", "printed", "printed_name", "title", "values")
)
"""Keys of a spec below which an L with a number is not a line of the manual, or is not evidence of a fact."""
_BESIDE = ("errata", "printed", "provenance", "inferred", "standard", "evidence", "roles")
_cells = itemgetter(*(column for column in COLUMNS if column not in _BESIDE))
_IN_TEXT = re.compile(r"(?:[0-9A-Za-z.]+ )?L[0-9]{1,6}(?:-[0-9]{1,6})?(?:, [0-9]{1,6}(?:-[0-9]{1,6})?)*")


@dataclass(slots=True)
class LineFacts:
    """The rows of facts and the errata that cite a line."""

    facts: list[FactRow] = field(default_factory=list)
    errata: list[Erratum] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class LineCitations:
    """The facts of each line, and all `lines` that any text of the spec cites, remarks included.

    `elided` are the paths of examples of which the manual does not print all bytes.
    """

    by_line: Mapping[int, LineFacts]
    lines: frozenset[int]
    elided: frozenset[str]

    def at(self, line: int) -> LineFacts:
        """The facts and errata of a line."""
        return self.by_line.get(line) or LineFacts()


_CITATIONS: ByIdentity[Sequence[Sequence[FactRow]], LineCitations] = ByIdentity(limit=1)


def line_citations(
    spec: DeviceSpec, layouts: Sequence[DeviceLayout], facts: Sequence[Sequence[FactRow]]
) -> LineCitations:
    """The citations of all versions by line; `facts` are the rows of each layout. Two sections of an audit ask."""
    return _CITATIONS.get_or_compute(facts, lambda facts: _line_citations(spec, layouts, facts))


def _line_citations(
    spec: DeviceSpec, layouts: Sequence[DeviceLayout], facts: Sequence[Sequence[FactRow]]
) -> LineCitations:
    by_line: dict[int, LineFacts] = defaultdict(LineFacts)
    known: set[object] = set()
    shared: set[int] = set()
    for layout, rows in zip(layouts, facts, strict=True):
        printed = [row for row in rows if row["kind"] not in _OUR_WORDS]
        for own, row in zip(printed, _completed(printed), strict=True):
            if row is own:
                if id(row) in shared:
                    continue
                shared.add(id(row))
            key = _cells(row), row["printed"] is None
            if key not in known:
                known.add(key)
                for line in lines_of(citations(str(row["sources"] or ""), "")):
                    by_line[line].facts.append(row)
        for erratum in layout.device.errata:
            if f"erratum {erratum.id}" not in known:
                known.add(f"erratum {erratum.id}")
                for line in lines_of(erratum.sources):
                    by_line[line].errata.append(erratum)
    cited_lines = frozenset[int]().union(*map(_lines_in, (spec.tree, *spec.trees.values())))
    elided = frozenset(
        example.place.path for layout in layouts for example in layout.device.examples.values() if example.elided
    )
    return LineCitations(dict(by_line), cited_lines | by_line.keys(), elided)


def _completed(rows: Sequence[FactRow]) -> Iterator[FactRow]:
    """The rows. One that restates a fact gets the other values of the fact, as its place may print any of them."""
    by_path = {str(row["path"]): row for row in rows}
    for row in rows:
        path, separator, _ = str(row["path"]).rpartition("/restated/")
        fact = by_path.get(path) if separator else None
        yield row if fact is None else {key: fact[key] if cell is None else cell for key, cell in row.items()}


def lines_of(sources: Sequence[Citation]) -> Iterator[int]:
    """All lines of some citations."""
    for citation in sources:
        for first, last in citation.lines:
            yield from range(first, last + 1)


_LINES: ByIdentity[Node, frozenset[int]] = ByIdentity(limit=100_000)
"""The lines that nodes cite. Versions share most nodes, and the next spec that is read has most of them, too."""


def _lines_in(node: Node) -> frozenset[int]:
    """The lines that texts of a node cite."""
    if isinstance(node, Scalar):
        matches = _IN_TEXT.finditer(node.text) if "L" in node.text else ()
        return frozenset(line for match in matches for line in lines_of(citations(match[0], "")))
    return _LINES.get_or_compute(node, _lines_below)


def _lines_below(node: Node) -> frozenset[int]:
    return frozenset[int]().union(*[_lines_in(inner) for key, inner in children(node) if key not in _NO_CITATIONS])
