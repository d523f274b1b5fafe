"""What every part of a page needs: the layout, and what else is said about each fact."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator

from fieldspec.backends.docs.document import (
    Block,
    Cell,
    Line,
    Paragraph,
    Piece,
    cell,
    code,
    joined,
    label,
    plain,
    styled,
)
from fieldspec.backends.docs.handling import handled
from fieldspec.backends.docs.holders import Holder, holders
from fieldspec.backends.docs.holding import Holding
from fieldspec.backends.docs.inferences import provenance_lines, reasons
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.device import Device
from fieldspec.model.fact import Citation, Fact
from fieldspec.model.handling import NOTHING_SAID
from fieldspec.model.place import Place
from fieldspec.model.value import Value


class Context:
    """A device at one version, with errata and notes by the fact that they are about, and users of enums and flags."""

    def __init__(self, layout: DeviceLayout, holding: Holding | None = None) -> None:
        self.layout = layout
        self.holding = holding or Holding([layout])
        self.device: Device = layout.device
        self.holders: dict[str, Holder] = holders(layout.device)
        self._errata: dict[str, list[str]] = defaultdict(list)
        for erratum in self.device.errata:
            self._errata[erratum.fact.partition("/restated/")[0]].append(erratum.id)
        self._notes: dict[str, list[tuple[str, str]]] = defaultdict(list)
        for note in self.device.notes:
            for path in note.about:
                self._notes[path].append((note.place.path, note.title))
        self._users = _users(self.holders.values())

    def section_title(self, title: str, fact: Fact) -> Line:
        """A title in English with what the manual prints."""
        return (plain(title), *_printed(fact))

    def about(self, fact: Fact) -> Iterator[Line]:
        """What is said of a fact beside its numbers: what it is, for which versions, notes, errata."""
        if fact.doc:
            yield (plain(fact.doc),)
        if fact.unverified:
            yield (styled("unverified", "badge"), plain(" Nobody has compared it with the manual yet."))
        if fact.since:
            yield (styled(f"since {', '.join(fact.since)}", "badge"),)
        if fact.until:
            yield (styled(f"until {', '.join(fact.until)}", "badge"),)
        if fact.only:
            yield (styled(f"only {', '.join(fact.only)}", "badge"),)
        yield from provenance_lines(fact)
        if fact.roles:
            yield (styled("Role: ", "quiet"), *joined((plain(role),) for role in fact.roles))
        yield from handled(getattr(fact, "handling", NOTHING_SAID))
        yield from (_note(note) for note in fact.notes)
        yield from self.beside(fact.place)

    def beside(self, place: Place) -> Iterator[Line]:
        """The errata and the notes of the device that are about a fact."""
        if notes := self._notes.get(place.path):
            yield (styled("See: ", "quiet"), *joined((plain(title, f"#{path}"),) for path, title in notes))
        if ids := self._errata.get(place.path):
            yield (styled("Erratum: ", "quiet"), *joined((plain(found, f"#errata/{found}"),) for found in ids))

    def users(self, path: str) -> Line:
        """The facts whose values an enum, a word of flags or a record names."""
        return joined((code(name, f"#{user}"),) for name, user in self._users.get(path, ()))

    def opening(self, fact: Fact) -> list[Block]:
        """What a section on a fact begins with."""
        said: list[Block] = [Paragraph(line) for line in self.about(fact)]
        return said + [Paragraph(line, "note") for line in reasons(fact.inferred)]

    def link_to(self, path: str) -> Piece:
        """A link to a fact."""
        return code(path, f"#{path}")


def _users(all_of_them: Iterable[Holder]) -> dict[str, list[tuple[str, str]]]:
    """Names and paths of the facts that use an enum, a word of flags or a record, by that one's path."""
    found: dict[str, list[tuple[str, str]]] = defaultdict(list)
    for holder in all_of_them:
        if not isinstance(holder, Fact):
            continue
        path = holder.place.path
        value = getattr(holder, "value", None)
        names = {"enums": "", "flags": "", "records": str(getattr(holder, "record", ""))}
        if isinstance(value, Value):
            names |= {"enums": value.enum, "flags": value.flags}
        elif enum := getattr(holder, "enum", ""):
            names["enums"] = enum
        for section, name in names.items():
            if name:
                found[f"{section}/{name}"].append((_short(path), path))
    return found


def _short(path: str) -> str:
    """A path without its section, as users know it: `point.mode`, `stop.request.speed`."""
    return ".".join(path.split("/")[1:])


def _printed(fact: Fact) -> Iterator[Piece]:
    for text in (fact.printed_name, fact.label):
        if text:
            yield plain(" ")
            yield label(text)


def _note(text: str) -> Line:
    return (styled("Note: ", "strong"), plain(text))


def names(fact: Fact, name: str, *more: Line, mark: Iterable[Piece] = ()) -> Cell:
    """A cell with the name of a fact and what the manual prints for it."""
    first: Line = (code(name), *mark)
    printed = [(label(text),) for text in dict.fromkeys((fact.printed_name, fact.label)) if text]
    return cell(first, *printed, *more)


def sources(fact: Fact) -> Cell:
    """A cell with the places of the manual that print a fact, and those that print it again."""
    own = [(plain(citation.text()),) for citation in fact.sources]
    again = [citation.text() for claim in fact.restated for citation in claim.sources]
    more = [(styled(f"again {'; '.join(dict.fromkeys(again))}", "quiet"),)] if again else []
    return cell(*own, *more)


def cited(citations: Iterable[Citation]) -> Line:
    """The places of the manual in one line."""
    return (plain("; ".join(citation.text() for citation in citations)),)


def many(number: int, noun: str) -> str:
    """`1 byte`, `4 bytes`"""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def address(number: int) -> str:
    """`0x2011`"""
    return f"0x{number:04X}"
