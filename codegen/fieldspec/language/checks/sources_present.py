"""Every fact states where the manual prints it: a section, and lines that exist in the manual.

Why: the manual is the authority. Without a source, the fact cannot be verified, and a line after the end of
the text is a mistake.

Example: a register without `source`, or `source: 8.2 L16222` where the text has 3100 lines.

Fix: Add the section and the line. Facts of a protocol are cited in the entry of the same name in the device. A row may
omit the section if its group has one, under `section` or in its `source`. If the manual prints the rows of a copied
block, each row cites its own line. A fact that a version adds needs no source if the manual does not print it: the
entry that adds it states the reason.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.facts import facts
from fieldspec.language.checks.finding import Findings, enumeration, finding, is_imported
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device, Manual
from fieldspec.language.model.enums import Bit, Member, State
from fieldspec.language.model.fact import Citation, Place
from fieldspec.language.model.link import Part
from fieldspec.language.model.record import Case, Field
from fieldspec.language.model.registers import Parameter, Register, RegisterGroup, Subindex
from fieldspec.language.model.task import Task

_INHERITING = (RegisterGroup, Part, Field, Case, Member, Bit, State, Parameter, Subindex)
"""These take the source of what holds them, where a finding says it once; a group need not have one."""


def sources_present(device: Device) -> Findings:
    manual = device.manual
    mark, extent = manual.mark, manual.lines or manual.pages
    is_cited = bool(mark or manual.url)
    imported: dict[str, list[str]] = {}
    sectionless: list[tuple[str, Place]] = []
    for subject, place, sources, needs_source in cited_places(device):
        if not sources and needs_source and is_imported(place, device):
            imported.setdefault(place.path.partition("/")[0], []).append(subject)
        elif not sources and needs_source:
            text = f"{subject} has no source"
            yield finding(place, "source", text, "add `source: <section> L<line>`")
        is_sectionless = False
        for citation in sources:
            if is_cited and not _is_within(citation, mark, extent):
                yield _wrong(manual, subject, place, citation)
            is_sectionless |= not citation.section
        if is_sectionless:
            sectionless.append((subject, place))
    if sectionless:
        yield from _without_section(device, sectionless)
    if imported:
        yield _of_protocols(device, imported)


def _of_protocols(device: Device, imported: Mapping[str, list[str]]) -> Diagnostic:
    """The finding of all facts of protocols that the device does not cite, by section."""
    count = plural(sum(len(names) for names in imported.values()), "fact")
    section, (name, *_) = next(iter(imported.items()))
    listing = "; ".join(f"{section}: {', '.join(names)}" for section, names in imported.items())
    verb = "has" if count == "1 fact" else "have"
    text = f"{count} that {device.id} takes from protocols {verb} no source: {listing}"
    fields = device.records[name].fields[:1] if section == "records" else ()  # an entry of a record has fields
    keys = "".join(f", fields: [{{name: {field.name}}}]" for field in fields)
    entry = f"{section}: [{{name: {name}, source: <section> L<line>{keys}}}]"
    help = f"add an entry with the source of each, such as `{entry}`, or state under `uses` what the device has"
    return finding(device.place, "id", text, help)


def _without_section(device: Device, cited: list[tuple[str, Place]]) -> Findings:
    """The findings of sources that name no section: one for each group, or other fact, with all that it encloses."""
    groups = {fact.place.path: group for group in device.groups for fact in (*group.registers, group)}
    enclosed: dict[str, list[tuple[str, Place]]] = {}
    for subject, place in cited:
        path = "/".join(place.path.split("/")[:2])
        holder = groups[path].place.path if path in groups else path
        enclosed.setdefault(holder, []).append((subject, place))
    for path, items in enclosed.items():
        names = [*dict.fromkeys(subject for subject, _ in items)]
        (subject, place), key = items[0], "source"
        text, help = f"the source of {subject} names no section", "add it like `8.2 L1622`, or add it to the group"
        if len(names) > 1:
            if path in groups:
                subject, place = f"the group {groups[path].name}", groups[path].place
                key = "source" if "source" in place else "group"
            text = f"the sources of {enumeration(names)} name no section"
            help = f"add `section` to {subject}, or the section to each source like `8.2 L1622`"
        yield finding(place, key, text, help)


def cited_places(device: Device) -> Iterator[tuple[str, Place, tuple[Citation, ...], bool]]:
    """Everything that has sources: its name, its place, its sources, and whether it must have some."""
    free = _copied_as_blocks(device) | _added(device)
    for fact in facts(device):
        needs_source = not isinstance(fact, _INHERITING) and fact.place.path not in free
        if isinstance(fact, Task):
            needs_source = bool(fact.steps)  # what is not printed has no place
            for step in fact.steps:
                yield f"a step of {fact.name}", step.place, step.sources, False
        yield fact.name, fact.place, fact.sources, needs_source
        for claim in fact.restated:
            yield fact.name, claim.place, claim.sources, True
        if isinstance(fact, Register):
            yield fact.name, fact.place, fact.element_sources, False
        if isinstance(fact, Member):
            for cause in fact.causes:
                yield fact.name, fact.place, cause.sources, False
    for group in device.groups:
        for gap in group.gaps:
            yield f"a gap of {group.name}", gap.place, gap.sources, False
    for table in device.tables.values():
        for element in table.elements:
            yield f"element {element.index} of {table.name}", element.place, element.sources, True
    for lookup in device.lookups:
        for row in lookup.rows:
            yield f"a row of {lookup.name}", row.place, row.sources, True
    for link in device.links.values():
        if link.unit_addresses is not None:
            yield f"the stations of {link.name}", link.unit_addresses.place, link.unit_addresses.sources, False
    for example in device.examples.values():
        yield example.id, example.place, example.sources, example.origin == "printed"
    for erratum in device.errata:
        yield erratum.id, erratum.place, erratum.sources, True
    for note in device.notes:
        yield note.name, note.place, note.sources, False
        for statement in note.statements:
            yield f"a statement of {note.name}", statement.place, statement.sources, True


def _copied_as_blocks(device: Device) -> set[str]:
    """The paths of the registers of blocks that the manual does not print again row by row."""
    return {
        row.place.path
        for group in device.groups
        if not any(row.sources for row in group.registers)
        for row in group.registers
        if row.copy_of
    }


def _added(device: Device) -> set[str]:
    """The paths of the facts that overlays of versions add, each with a reason."""
    return {entry.path for entry in device.stated_changes if entry.kind == "adds"}


def _is_within(citation: Citation, mark: str, extent: int) -> bool:
    """Whether a citation has the mark of the manual, and lines or pages that the manual has."""
    for first, last in citation.lines:
        if not 1 <= first <= last <= extent:
            return False
    return citation.mark == mark


def _wrong(manual: Manual, subject: str, place: Place, citation: Citation) -> Diagnostic:
    if citation.mark != manual.mark:
        unit = manual.unit or "sections alone"
        form = f"a section and a {unit[:-1]}, as in `8.2 {manual.mark}17`" if manual.mark else "a section, as in `8.2`"
        text = f"the source of {subject} is {citation.text()}; the manual has {unit}"
        return finding(place, "source", text, f"write {form}")
    extent = f"the manual's text has the lines 1 to {manual.lines}"
    if not manual.lines:
        extent = f"the manual has {manual.pages} pages"
    text = f"the source of {subject} is {citation.text()}; {extent}"
    return finding(place, "source", text, f"correct the {manual.unit}")
