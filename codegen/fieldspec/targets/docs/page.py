"""The page of a device version: its sections in order, and the sections of the manual that it cites."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import partial

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import replace
from fieldspec.foundation.html_text import clean
from fieldspec.language.model.fact import Citation
from fieldspec.language.model.ranges import merged
from fieldspec.targets.docs.bit_fields import words
from fieldspec.targets.docs.context import Context, Holding
from fieldspec.targets.docs.device import identity, version_title
from fieldspec.targets.docs.document import (
    Document,
    Line,
    Paragraph,
    Section,
    TableColumn,
    TableRow,
    cell,
    code,
    table,
    text_piece,
)
from fieldspec.targets.docs.enums import codes, enums
from fieldspec.targets.docs.errata import errata
from fieldspec.targets.docs.examples import examples
from fieldspec.targets.docs.links import links
from fieldspec.targets.docs.lookups import limits, lookups, notes, units
from fieldspec.targets.docs.machines import state_machines
from fieldspec.targets.docs.messages import conversions, messages, signals, telegrams
from fieldspec.targets.docs.parameters import parameters
from fieldspec.targets.docs.records import records, tables
from fieldspec.targets.docs.registers import registers, spaces
from fieldspec.targets.docs.tasks import tasks
from fieldspec.targets.pieces import version_piece

COLUMNS = (TableColumn("Section", unbroken=True), TableColumn("Facts", "number", unbroken=True))

_PARTS = re.compile(r"[0-9]+|[^0-9.]+")


def places(context: Context) -> Section:
    """The sections of the manual with the lines that are cited, and how many facts cite them."""
    manual = context.device.manual
    facts: dict[str, int] = {}
    lines: dict[str, set[tuple[int, int]]] = {}
    for holder in context.holders.values():
        for citation in holder.sources:
            facts[citation.section] = facts.get(citation.section, 0) + 1
            lines.setdefault(citation.section, set()).update(citation.lines)
    rows = [
        TableRow((cell(section or "none"), cell(str(facts[section])), cell(_merged(lines[section], manual.mark))))
        for section in sorted(facts, key=_order)
    ]
    numbers = TableColumn(manual.unit.capitalize(), "wide", unbroken=True)
    text = f"Sections of {manual.file or manual.url}" + (f", with the {manual.unit} that" if manual.unit else " that")
    text += " the facts on this page cite."
    return Section(
        "sources",
        (text_piece("Sources"),),
        (Paragraph((text_piece(text),)), table("Sources", (*COLUMNS, numbers), rows)),
    )


def _order(section: str) -> list[tuple[int, str]]:
    """A key that puts 9.2 before 9.10."""
    return [(int(part), "") if part.isdigit() else (-1, part) for part in _PARTS.findall(section)]


def _merged(lines: set[tuple[int, int]], mark: str) -> str:
    """Intervals of lines or pages, those that touch in one."""
    return Citation("", tuple(merged(lines)), mark).text()


SECTIONS = (
    identity,
    tasks,
    links,
    spaces,
    registers,
    tables,
    telegrams,
    messages,
    signals,
    conversions,
    parameters,
    records,
    words,
    enums,
    codes,
    lookups,
    limits,
    state_machines,
    units,
    notes,
    examples,
    errata,
    places,
)


def page(layout: DeviceLayout, holding: Holding) -> Document:
    """The page of a device at one version. Sections in which nothing would stand are left out."""
    device = layout.device
    contexts: ByIdentity[DeviceLayout, Context] = ByIdentity()

    def section_of(make: Callable[[Context], Section], own: DeviceLayout) -> Section:
        section = make(contexts.get_or_compute(own, lambda own: Context(own, holding)))
        return replace(section, sections=tuple(map(holding.same, section.sections)), rendered={})

    all_sections = [
        version_piece(f"section {make.__name__}", layout, (holding.all, holding.by_path), partial(section_of, make))
        for make in SECTIONS
    ]
    sections = tuple(section for section in all_sections if section.blocks or section.sections)
    title = f"{device.name}, {version_title(device)}" if device.lines else device.name
    return Document(
        clean(title),
        clean(device.title),
        layout.identity,
        device.manual.language,
        tuple(_summary(layout)),
        sections,
    )


def _summary(layout: DeviceLayout) -> Iterator[Line]:
    device = layout.device
    counts = (
        ("registers", sum(register.count for register in device.registers()), "registers"),
        ("messages", len(device.messages), "messages"),
        (
            "parameters",
            sum(len(parameter_set.parameters) for parameter_set in device.parameters.values()),
            "parameters",
        ),
        ("example frames", len(device.examples), "examples"),
        ("errata", len(device.errata), "errata"),
    )
    for title, number, anchor in counts:
        if number:
            yield (text_piece(f"{number} {title}", f"#{anchor}"),)
    yield (text_piece("identity "), code(layout.identity))
