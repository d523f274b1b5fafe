"""What is said of an item in words, key by key: sources, caveats, errata, examples."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.layout.explaining.row import citations
from fieldspec.model.device import Device
from fieldspec.model.erratum import Erratum
from fieldspec.model.example import Example
from fieldspec.model.fact import Claim, Fact
from fieldspec.model.handling import NOTHING_SAID, Handling
from fieldspec.model.note import Note

Details = Iterator[tuple[str, str]]

_MEMORY = {"volatile": "lost with the power", "nonvolatile": "kept without power"}
_ENDURANCE = {"limited": "a limited number of writes, which is not printed", "unlimited": "as many writes as one likes"}


def fact_details(device: Device, fact: Fact) -> Details:
    """What every fact has: its text, the versions that it holds for, its places in the manual, and the caveats."""
    yield "doc", fact.doc
    yield "since", ", ".join(fact.since)
    yield "until", ", ".join(fact.until)
    yield "only", ", ".join(fact.only)
    yield from _handling(getattr(fact, "handling", NOTHING_SAID))
    yield "source", citations(fact.sources)
    for claim in fact.restated:
        yield "also", _claim(claim)
    for note in fact.notes:
        yield "note", note
    for key, reason in fact.inferred.items():
        yield "inferred", f"{key}: {reason}"
    if fact.unverified:
        yield "unverified", "nobody has compared it with the manual yet"
    for key, reason in fact.allowed.items():
        yield "allowed", f"{key}: {reason}"
    for general in device.notes:
        if fact.place.path in general.about:
            yield "note", f"{general.title}: {general.text}"
    for erratum in device.errata:
        if erratum.fact == fact.place.path or erratum.fact.startswith(f"{fact.place.path}/"):
            yield "erratum", f"{erratum.id}: {_printed(erratum)}{erratum.reason}"


def _handling(said: Handling) -> Details:
    """What whoever reads or writes the value must know."""
    yield "reading", "clears it: only the first reader gets it" if said.clears_on_read else ""
    yield "memory", _MEMORY.get(said.memory, "")
    yield "saved by", said.saved_by
    yield "endurance", _ENDURANCE.get(said.endurance, f"{said.endurance} writes" if said.endurance else "")
    yield "opposite of", said.opposite_of


def erratum_details(erratum: Erratum) -> Details:
    """What an erratum says."""
    yield "fact", erratum.fact
    yield "printed", _printed(erratum).removesuffix(". ").removeprefix("printed ")
    yield "literally", erratum.literal
    yield "reason", erratum.reason
    yield "sure", erratum.confidence
    yield "effect", erratum.effect
    yield "proof", erratum.proof
    yield "source", citations(erratum.sources)


def example_details(example: Example) -> Details:
    """What an example says; `decode` explains its bytes."""
    yield "title", example.title
    yield "message", f"{example.message or 'unknown'} {'refusal' if example.error else example.direction}"
    yield "link", example.link
    yield "frame", example.frame.hex(" ").upper()
    yield "answers", example.reply_to
    yield "refused", example.refused
    yield "values", ", ".join(f"{name} {value}" for name, value in example.values.items())
    yield "source", citations(example.sources)
    for note in example.notes:
        yield "note", note


def note_details(note: Note) -> Details:
    """What a note says."""
    yield "title", note.title
    yield "text", note.text
    yield "about", ", ".join(note.about)
    yield "source", citations(note.sources)


def _printed(erratum: Erratum) -> str:
    keys = ", ".join(f"{key} {'absent' if value is None else value}" for key, value in erratum.printed.items())
    return f"printed {keys}. " if keys else ""


def _claim(claim: Claim) -> str:
    said = ", ".join(f"{key} {value}" for key, value in claim.values.items())
    return f"{citations(claim.sources)}" + (f": {said}" if said else "")
