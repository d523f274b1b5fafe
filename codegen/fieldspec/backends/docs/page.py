"""The page of a device at one version: its sections in order."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.docs.context import Context
from fieldspec.backends.docs.document import Document, Line, Section, clean, code, plain
from fieldspec.backends.docs.enums import codes, enums
from fieldspec.backends.docs.errata import errata
from fieldspec.backends.docs.examples import examples
from fieldspec.backends.docs.holding import Holding
from fieldspec.backends.docs.identity import identity, version_title
from fieldspec.backends.docs.links import links
from fieldspec.backends.docs.lists import limits, lookups, notes
from fieldspec.backends.docs.messages import messages
from fieldspec.backends.docs.parameters import parameters
from fieldspec.backends.docs.places import places
from fieldspec.backends.docs.registers import registers
from fieldspec.backends.docs.signals import conversions, signals
from fieldspec.backends.docs.tables import records, tables
from fieldspec.backends.docs.tasks import tasks
from fieldspec.backends.docs.telegrams import telegrams
from fieldspec.backends.docs.words import words
from fieldspec.classes import replace
from fieldspec.layout.device import DeviceLayout

SECTIONS = (
    identity,
    tasks,
    links,
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
    notes,
    examples,
    errata,
    places,
)


def page(layout: DeviceLayout, holding: Holding) -> Document:
    """The page of a device at one version. Sections in which nothing would stand are left out."""
    context = Context(layout, holding)
    device = layout.device
    made = [section(context) for section in SECTIONS]
    sections = tuple(_shared(section, holding) for section in made if section.blocks or section.sections)
    title = f"{device.name}, {version_title(device)}" if device.lines else device.name
    return Document(
        clean(title),
        clean(device.title),
        layout.identity,
        device.manual.language,
        tuple(_summary(layout)),
        sections,
    )


def _shared(section: Section, holding: Holding) -> Section:
    """A section in which those stand that the version before has too."""
    return replace(section, sections=tuple(map(holding.same, section.sections)))


def _summary(layout: DeviceLayout) -> Iterator[Line]:
    device = layout.device
    counts = (
        ("registers", sum(register.count for register in device.registers()), "registers"),
        ("messages", len(device.messages), "messages"),
        ("parameters", sum(len(held.parameters) for held in device.parameters.values()), "parameters"),
        ("example frames", len(device.examples), "examples"),
        ("errata", len(device.errata), "errata"),
    )
    for title, number, anchor in counts:
        if number:
            yield (plain(f"{number} {title}", f"#{anchor}"),)
    yield (plain("identity "), code(layout.identity))
