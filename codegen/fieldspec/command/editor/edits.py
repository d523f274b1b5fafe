"""Edits of documents: keys, items and errata that are added to the text, in the form that it has."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Sequence as Lines

from fieldspec.command.editor.cursor import Cursor
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.checks.facts import facts
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact
from fieldspec.language.reading.memory import FileRead
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, mappings, with_checked_keys
from fieldspec.language.reading.references import PlaceInFile, place_in_file, unanchored
from fieldspec.language.reading.yaml_reader import key_spans


@dataclass(frozen=True, slots=True)
class Edit:
    """A text in place of a span."""

    span: Span
    text: str


def line_end(file: SourceFile) -> str:
    """The end of the lines of a file."""
    return "\r\n" if "\r\n" in file.text else "\n"


def source_text(value: Scalar) -> str:
    """The text of a scalar as its file has it, with quotation marks."""
    return value.file.text[value.start : value.end]


def with_key(mapping: Mapping, key: str, value: str) -> Edit:
    """A mapping with one more key: within its braces, or on a line of its own."""
    text, last = mapping.file.text, _last(mapping)
    if _opens(mapping) == "{":
        inner = text[mapping.start : last - 1].rstrip()
        comma = "" if inner.endswith(("{", ",")) else ", "
        offset = mapping.start + len(inner)
        return Edit(Span(mapping.file, offset, offset), f"{comma}{key}: {value}")
    first = next(span.start for _, span in key_spans(mapping))
    column = first - text.rfind("\n", 0, first) - 1
    offset = _end_of_line(text, last)
    return Edit(Span(mapping.file, offset, offset), f"{line_end(mapping.file)}{' ' * column}{key}: {value}")


def with_item(read: FileRead, section: str, lines: Lines[str]) -> Edit:
    """A document with one more item in the list of a section, which is begun where there is none."""
    assert read.tree is not None
    file, text = read.tree.file, read.tree.file.text
    end = line_end(file)
    node = read.tree.values.get(section)
    if not isinstance(node, Sequence) or not node.items:
        offset = len(text.rstrip())
        items = end.join(f"  {'  ' if number else '- '}{line}" for number, line in enumerate(lines))
        return Edit(Span(file, offset, offset), f"{end}{end}{section}:{end}{items}")
    last = _last(node)
    if _opens(node) == "[":
        inner = len(text[: last - 1].rstrip())
        return Edit(Span(file, inner, inner), f", {{{', '.join(lines)}}}")
    column = " " * (node.start - text.rfind("\n", 0, node.start) - 1)
    offset = _end_of_line(text, last)
    items = end.join(f"{column}{'  ' if number else '- '}{line}" for number, line in enumerate(lines))
    return Edit(Span(file, offset, offset), f"{end}{items}")


def _opens(node: Node) -> str:
    """The first character of a node after its anchor: a bracket, or that of a block."""
    return node.file.text[unanchored(node)]


def _last(node: Node) -> int:
    """Where the text of a node ends, without the blank lines and comments after it."""
    lines = node.file.text[node.start : node.end].rstrip().split("\n")
    while len(lines) > 1 and (lines[-1].lstrip().startswith("#") or not lines[-1].strip()):
        lines.pop()
    return node.start + len("\n".join(lines).rstrip())


def _end_of_line(text: str, offset: int) -> int:
    end = text.find("\n", offset)
    return len(text[: end if end >= 0 else len(text)].rstrip())


def holding_section(place: Cursor, section: str) -> FileRead:
    """The document that has a section of a device: the one of the place, or else the first other one, or itself."""
    open_file = place.read
    reads = [open_file]
    for spec in place.specs:
        reads += (place.project.memory.files[path] for path in sorted(spec.files) if path.startswith(f"{spec.id}/"))
    return next((read for read in reads if read.tree is not None and section in read.tree.values), open_file)


_BY_PLACE: ByIdentity[Device, dict[PlaceInFile, Fact]] = ByIdentity(limit=50)
"""The facts of a device by the places that state them."""


def stated_fact(place: Cursor, mapping: Mapping) -> Fact | None:
    """The fact that a mapping of a document states; None for any other mapping."""
    for spec in place.specs:
        for version in reversed(spec.versions()):
            fact = _BY_PLACE.get_or_compute(spec.at(version)[0], _by_place).get(place_in_file(mapping))
            if fact is not None:
                return fact
    return None


def _by_place(device: Device) -> dict[PlaceInFile, Fact]:
    wholes = ((fact.place.whole, fact) for fact in facts(device))
    return {(whole.file.path, whole.start, whole.end): fact for whole, fact in wholes}


def erratum_lines(place: Cursor, fact: Mapping, key: str, proof: str = "judgement") -> list[str] | None:
    """The lines of an erratum: the manual prints for a key of a fact what stands there now. None without a path."""
    stated, value = stated_fact(place, fact), with_checked_keys(fact).values.get(key)
    if stated is None or not isinstance(value, Scalar):
        return None
    path = stated.place.path
    return [
        f"id: {_new_identifier(place, path, key)}",
        f"fact: {path}",
        f"printed: {{{key}: {source_text(value)}}}",
        'reason: ""',
        "confidence: certain",
        "effect: bytes",
        f"proof: {proof}",
        f"source: {'; '.join(citation.text() for citation in stated.sources)}",
    ]


def _new_identifier(place: Cursor, path: str, key: str) -> str:
    words = f"{path.rpartition('/')[2]}-{key}".replace("_", "-")
    return new_name(words, {*identifiers(place, "errata")})


def new_name(words: str, used_names: set[str]) -> str:
    """Words, with a number where they are in use already."""
    number = 1
    name = words
    while name in used_names:
        number += 1
        name = f"{words}-{number}"
    return name


def identifiers(place: Cursor, section: str) -> Iterator[str]:
    """The identifiers of the items of a section."""
    for spec in place.specs:
        for item in mappings(spec.tree.values.get(section)):
            if isinstance(name := item.values.get("id"), Scalar):
                yield name.text
