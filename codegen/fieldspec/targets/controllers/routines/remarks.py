"""What comments say of facts and values."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from fieldspec.codec.layout.omissions import Omission, listing
from fieldspec.foundation.names import Name
from fieldspec.language.model.enums import Member
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value
from fieldspec.targets.controllers.routines.printer import comment_text


def source(fact: Fact) -> str:
    """The places of a fact in the manual, for a comment: `[8.2 L1622]`"""
    return f"[{'; '.join(citation.text() for citation in fact.sources)}]" if fact.sources else ""


def printed(fact: Fact) -> str:
    """The names of a fact in the manual: its printed name, and its label."""
    return " ".join(text for text in (fact.printed_name, fact.label) if text)


def member_remark(member: Member) -> str:
    """The names of a member in the manual, its aliases, and its source."""
    aliases = f"also {', '.join(member.aliases)}" if member.aliases else ""
    return cited(" ".join(text for text in (printed(member), aliases) if text), member)


def cited(text: str, fact: Fact) -> str:
    """A text, and after it where the manual states the fact."""
    return " ".join(part for part in (*text.split(), source(fact)) if part)


def left_out(omissions: Sequence[Omission]) -> list[str]:
    """The lines that say what the functions leave out, and why."""
    lines = listing(omissions, comment_text)
    return ["", *lines] if lines else []


def without_block(missing: Iterable[tuple[str, str]]) -> list[str]:
    """The lines that say which tasks have no block, and why; `missing` are their names and the reasons."""
    lines = [comment_text(f"{name}: {reason}") for name, reason in missing]
    return ["", "No block:", *(f"    {line}" for line in lines)] if lines else []


def of_value(value: Value | None) -> str:
    """The meaning of a count of a value, the permitted counts, and the special values.

    Enums and bit fields are identified by the common part of the names of their types, functions and constants.
    """
    if value is None:
        return ""
    facts = []
    if value.scaled or value.unit:
        facts.append(f"1 count = {count_of(value)}.")
    if value.ranges is not None and (value.ranges.low, value.ranges.high) != (value.type.low, value.type.high):
        facts.append(f"{value.ranges.text()}.")
    if value.write_ranges is not None:
        facts.append(f"Writing: {value.write_ranges.text()}.")
    facts += [f"The {value.write_order_text}."] if value.write_word_order else []
    if value.enum:
        facts.append(f"See {Name.of(value.enum).pascal()}.")
    if value.flags:
        facts.append(f"Bits: {Name.of(value.flags).upper()}_...")
    facts += [f"{sentinel.text} is {sentinel.name}." for sentinel in value.sentinels]
    return " ".join(facts)


def count_of(value: Value) -> str:
    """The quantity of one count: `0.01 mm`, `100/2^14 %, then -40 added`"""
    offset = f", then {value.offset} added" if value.offset else ""
    return f"{value.scale_text or value.scale} {value.unit}".rstrip() + offset
