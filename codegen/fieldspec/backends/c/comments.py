"""What the comments of a header say of a fact and of a value."""

from __future__ import annotations

from fieldspec.backends.c.text import comment
from fieldspec.model.fact import Fact
from fieldspec.model.value import Value


def told(fact: Fact, *more: str) -> list[str]:
    """The comment of a fact: what it is, what the manual calls it, and where it stands."""
    printed = " ".join(text for text in (fact.printed_name, fact.label) if text)
    sources = "; ".join(citation.text() for citation in fact.sources)
    return comment(
        fact.doc,
        f"Printed as {printed}." if printed else "",
        *more,
        *(f"Note: {note}" for note in fact.notes),
        f"Source: {sources}" if sources else "",
    )


def of_value(value: Value | None) -> str:
    """What a count of a value is, which counts it may be, and what some of them stand for."""
    if value is None:
        return ""
    facts = []
    if value.scaled or value.unit:
        scale = value.scale_text or str(value.scale)
        offset = f", then {value.offset} added" if value.offset else ""
        facts.append(f"One count is {scale} {value.unit}".rstrip() + f"{offset}.")
    if value.ranges is not None:
        facts.append(f"Range: {value.ranges.text()}.")
    if value.write_ranges is not None:
        facts.append(f"May be written: {value.write_ranges.text()}.")
    if value.enum or value.flags:
        facts.append(f"See {value.enum or value.flags}.")
    facts += [f"{sentinel.text} is {sentinel.name}." for sentinel in value.sentinels]
    return " ".join(facts)
