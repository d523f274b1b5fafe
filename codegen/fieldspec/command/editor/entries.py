"""New entries of lists of a device: errata with a printed value."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.command.editor.cursor import Cursor
from fieldspec.command.editor.edits import source_text
from fieldspec.foundation.caches import ByIdentity
from fieldspec.language.checks.facts import facts
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact
from fieldspec.language.reading.nodes import Mapping, Scalar, mappings, with_checked_keys
from fieldspec.language.reading.references import PlaceInFile, place_in_file

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
