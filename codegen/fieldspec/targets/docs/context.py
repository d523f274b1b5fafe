"""The common data of all parts of a page: the layout, the notes about each fact, and the sections that
versions share.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cached_property

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import replace
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Citation, Fact, Place
from fieldspec.language.model.value import UNSPECIFIED, Handling, Value
from fieldspec.targets.docs.document import (
    Block,
    Cell,
    Line,
    Paragraph,
    Piece,
    Section,
    TableRow,
    cell,
    code,
    joined,
    label,
    styled,
    text_piece,
)
from fieldspec.targets.docs.sources import Holder, holders, provenance_lines, reasons


class Holding:
    """The versions of a device that have each of its examples, notes and errata, and the sections of their pages."""

    def __init__(self, layouts: Sequence[DeviceLayout]) -> None:
        self.all = tuple(layout.device.version for layout in layouts)
        self.by_path: dict[str, list[str]] = {}
        self._sections: dict[str, Section] = {}
        self._made: dict[str, tuple[object, Section]] = {}
        for layout in layouts:
            device = layout.device
            for facts in (device.examples.values(), device.notes, device.errata):
                for fact in facts:
                    self.by_path.setdefault(fact.place.path, []).append(device.version)

    def section(self, anchor: str, subject: object, make: Callable[[], Section]) -> Section:
        """A section built from `subject`; the section of the version before, where it was built from an equal one."""
        before = self._made.get(anchor)
        if before is None or before[0] != subject:
            before = self._made[anchor] = subject, make()
        return before[1]

    def same(self, section: Section) -> Section:
        """A section, or the same one of the version before it, where that has it too."""
        if len(self.all) < 2:
            return section
        before = self._sections.get(section.anchor)
        if before != section:
            before = self._sections[section.anchor] = replace(section, rendered={})
        return before

    def of(self, path: str) -> tuple[str, ...]:
        """The versions that have a fact, the oldest first."""
        return tuple(self.by_path.get(path, ()))

    def badges(self, path: str) -> tuple[Line, ...]:
        """The badges of a fact that not all versions have; none for other facts."""
        versions = self.of(path)
        return () if versions == self.all else ((styled(f"only {', '.join(versions)}", "badge"),),)

    def lines(self, path: str) -> tuple[Line, ...]:
        """The versions for which a fact holds; empty for a device with one version."""
        versions = self.of(path)
        if len(self.all) < 2:
            return ()
        return ((text_piece("all"),),) if versions == self.all else ((text_piece(", ".join(versions)),),)


_MEMORY = {"volatile": " It is lost when the power is switched off.", "nonvolatile": " It is nonvolatile."}
_ENDURANCE = {
    "limited": "It may be written a limited number of times; the number is not printed.",
    "unlimited": "It may be written any number of times.",
}


def handled(handling: Handling) -> Iterator[Line]:
    """The lines on the handling of a value; none for most values."""
    if handling == UNSPECIFIED:
        return
    if handling.clears_on_read:
        yield (styled("cleared by reading", "badge"), text_piece(" Only the first reader gets it."))
    if handling.memory:
        yield (styled(handling.memory, "badge"), text_piece(_MEMORY[handling.memory]))
    if handling.saved_by:
        yield (text_piece("Saved by "), code(handling.saved_by, f"#{handling.saved_by}"))
    if handling.endurance:
        yield (text_piece(_ENDURANCE.get(handling.endurance, f"It may be written {handling.endurance} times.")),)
    if handling.opposite_of:
        yield (text_piece("The opposite sense of "), code(handling.opposite_of, f"#{handling.opposite_of}"))


class Context:
    """A device at one version, with errata and notes by the fact that they are about, and users of enums and flags."""

    def __init__(self, layout: DeviceLayout, holding: Holding | None = None) -> None:
        self.layout = layout
        self.holding = holding or Holding([layout])
        self.device: Device = layout.device
        self._errata: dict[str, list[str]] = defaultdict(list)
        for erratum in self.device.errata:
            self._errata[erratum.fact.partition("/restated/")[0]].append(erratum.id)
        self._notes: dict[str, list[tuple[str, str]]] = defaultdict(list)
        for note in self.device.notes:
            for path in note.about:
                self._notes[path].append((note.place.path, note.title))

    @cached_property
    def holders(self) -> dict[str, Holder]:
        """The facts of the device by path."""
        return holders(self.device)

    @cached_property
    def _users(self) -> dict[str, list[tuple[str, str]]]:
        return _users(self.holders.values())

    def section_title(self, title: str, fact: Fact) -> Line:
        """A title in English with what the manual prints."""
        return (text_piece(title), *_printed(fact))

    def about(self, fact: Fact) -> Iterator[Line]:
        """The lines about a fact: its documentation, the versions that have it, notes, errata."""
        if fact.doc:
            yield (text_piece(fact.doc),)
        if fact.unverified:
            yield (styled("unverified", "badge"), text_piece(" Not compared with the manual yet."))
        if fact.since:
            yield (styled(f"since {', '.join(fact.since)}", "badge"),)
        if fact.until:
            yield (styled(f"until {', '.join(fact.until)}", "badge"),)
        if fact.only:
            yield (styled(f"only {', '.join(fact.only)}", "badge"),)
        yield from provenance_lines(fact)
        if fact.roles:
            yield (styled("Role: ", "quiet"), *joined((text_piece(role),) for role in fact.roles))
        yield from handled(getattr(fact, "handling", UNSPECIFIED))
        yield from (_note(note) for note in fact.notes)
        yield from self.beside(fact.place)

    def beside(self, place: Place) -> Iterator[Line]:
        """The errata and the notes of the device that are about a fact."""
        if notes := self._notes.get(place.path):
            yield (styled("See: ", "quiet"), *joined((text_piece(title, f"#{path}"),) for path, title in notes))
        if ids := self._errata.get(place.path):
            yield (
                styled("Erratum: ", "quiet"),
                *joined((text_piece(erratum_id, f"#errata/{erratum_id}"),) for erratum_id in ids),
            )

    def users(self, path: str) -> Line:
        """The facts whose values an enum, a word of flags or a record names."""
        return joined((code(name, f"#{user}"),) for name, user in self._users.get(path, ()))

    def opening(self, fact: Fact) -> list[Block]:
        """The blocks at the beginning of a section on a fact."""
        blocks: list[Block] = [Paragraph(line) for line in self.about(fact)]
        return blocks + [Paragraph(line, "note") for line in reasons(fact.inferred)]

    def link_to(self, path: str) -> Piece:
        """A link to a fact."""
        return code(path, f"#{path}")


_ORDER = {"messages": 1, "records": 2, "signals": 3, "registers": 4, "tables": 5, "parameters": 6, "flags": 7}
"""The places of sections in a list of the facts that use another one."""


def _users(all_of_them: Iterable[Holder]) -> dict[str, list[tuple[str, str]]]:
    """Names and paths of the facts that use an enum, a word of flags or a record, by that one's path."""
    users_by_path: dict[str, list[tuple[str, str]]] = defaultdict(list)
    facts = (holder for holder in all_of_them if isinstance(holder, Fact))
    for holder in sorted(facts, key=lambda fact: _ORDER.get(fact.place.path.partition("/")[0], 0)):
        path = holder.place.path
        value = getattr(holder, "value", None)
        names = {"enums": "", "flags": "", "records": str(getattr(holder, "record", ""))}
        if isinstance(value, Value):
            names |= {"enums": value.enum, "flags": value.flags}
        elif enum := getattr(holder, "enum", ""):
            names["enums"] = enum
        for section, name in names.items():
            if name:
                users_by_path[f"{section}/{name}"].append((_short(path), path))
    return users_by_path


def _short(path: str) -> str:
    """A path without its section, as users know it: `point.mode`, `stop.request.speed`."""
    return ".".join(path.split("/")[1:])


def _printed(fact: Fact) -> Iterator[Piece]:
    for text in (fact.printed_name, fact.label):
        if text:
            yield text_piece(" ")
            yield label(text)


def _note(text: str) -> Line:
    return (styled("Note: ", "strong"), text_piece(text))


def names(fact: Fact, name: str, *lines: Line, mark: Iterable[Piece] = ()) -> Cell:
    """A cell with the name of a fact and what the manual prints for it."""
    first: Line = (code(name), *mark)
    printed = [(label(text),) for text in dict.fromkeys((fact.printed_name, fact.label)) if text]
    return cell(first, *printed, *lines)


def sources(fact: Fact) -> Cell:
    """A cell with the places of the manual that print a fact, and those that print it again."""
    own = [(text_piece(citation.text()),) for citation in fact.sources]
    repeated = [citation.text() for claim in fact.restated for citation in claim.sources]
    repeated_lines = [(styled(f"again {'; '.join(dict.fromkeys(repeated))}", "quiet"),)] if repeated else []
    return cell(*own, *repeated_lines)


def fact_row(fact: Fact, *cells: Cell, element: bool = False) -> TableRow:
    """The row of a fact, to which links to the fact lead: its cells, the last one with its sources."""
    return TableRow((*cells, sources(fact)), fact.place.path, element)


def cited(citations: Iterable[Citation]) -> Line:
    """The places of the manual in one line."""
    return (text_piece("; ".join(citation.text() for citation in citations)),)


def address(number: int) -> str:
    """`0x2011`"""
    return f"0x{number:04X}"
