"""How a device treats each value outside its range: refused according to the manual, or not printed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.behaviour.part import Behaviour, Part
from fieldspec.language.model.access import narrowed, writable
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.value import Value
from fieldspec.tools.audit.section import Cell, Figure, SectionTable

REFUSED, UNPRINTED = "refused", "not printed"


@dataclass(frozen=True, slots=True)
class Bounded:
    """A value that a request writes and whose range is narrower than its type, and the links of the request."""

    fact: Fact
    ranges: Ranges
    links: tuple[str, ...]


def beyond_ranges(layout: DeviceLayout, behaviour: Behaviour) -> tuple[list[Figure], SectionTable]:
    """A statement for each value whose range is narrower than its type, and how many there are of each kind."""
    part = next((part for part in behaviour.of_kind("refuse") if part.subject == "value_invalid"), None)
    rows: list[tuple[Cell, ...]] = []
    for bounded in _bounded_values(layout):
        fact = bounded.fact
        answers = {_answer(layout, link, part) for link in bounded.links} or {UNPRINTED}
        answer = UNPRINTED if UNPRINTED in answers else REFUSED
        source = part.sources[0] if part is not None and part.sources and answer == REFUSED else None
        rows.append((fact.place.path, bounded.ranges.text(), answer, source, fact.sources[0] if fact.sources else None))
    counts = Counter(row[2] for row in rows)
    figures = [
        Figure("values beyond their ranges are refused, as the manual says", counts[REFUSED], len(rows)),
        Figure("values beyond their ranges have no answer that the manual prints", counts[UNPRINTED], len(rows)),
    ]
    title = "How the device treats a value outside its range"
    marks = tuple("warning" if row[2] == UNPRINTED else "" for row in rows)
    return figures, SectionTable(
        "beyond", title, ("fact", "range", "answer", "says", "source"), tuple(rows), marks, True
    )


def _answer(layout: DeviceLayout, link: str, part: Part | None) -> str:
    """Whether a link has a response that refuses a value."""
    if part is None:
        return UNPRINTED
    marked = str(part.get("mark") or "").startswith(f"links/{link}/")
    excepted = "with" in part.keys and layout.links[link].link.exception_response is not None
    return REFUSED if marked or excepted else UNPRINTED


def _bounded_values(layout: DeviceLayout) -> Iterator[Bounded]:
    device = layout.device
    addressed = tuple(name for name, link in layout.links.items() if link.link.exception_response is not None)
    for register in device.registers():
        if writable(register.access) and not register.reserved:
            yield from _bounded(register, register.value, addressed)
    for table in device.tables.values():
        for field in device.records[table.record].fields:
            if writable(narrowed(table.access, field.access)) and not field.reserved:
                yield from _bounded(field, field.value, addressed)
    for parameter_set in device.parameters.values():
        for parameter in parameter_set.parameters:
            if writable(parameter.access):
                yield from _bounded(parameter, parameter.value, addressed or tuple(layout.links))
    for message in device.messages.values():
        links = tuple(name for name, link in layout.links.items() if message.name in link.carried("request"))
        for field in message.request.fields if links else ():
            if not field.reserved:
                yield from _bounded(field, field.value, links)


def _bounded(fact: Fact, value: Value | None, links: tuple[str, ...]) -> Iterator[Bounded]:
    if value is None or not is_count(value.encoding) or value.const is not None:
        return
    ranges = value.writable_ranges
    if ranges is not None and (ranges.low > value.low or ranges.high < value.high or len(ranges.intervals) > 1):
        yield Bounded(fact, ranges, links)
