"""Builds enums and bit fields."""

from __future__ import annotations

from decimal import Decimal

from fieldspec.language.model.enums import Bit, Cause, Enum, Flags, Member, State
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.language.reading.building.context import Entry
from fieldspec.language.reading.building.values import counts_of, default_of, scale_of, scale_text


def enum(entry: Entry) -> Enum:
    """The enum, or the table of codes, that an entry states."""
    derived = entry.entry("derived")
    if not entry.get("members"):
        entry.refuse("missing_key", "name", "an enum needs members", "list them under `members`")
    return Enum(
        **entry.fact(),
        kind=entry.text("kind") or "enum",
        title=entry.text("title"),
        open=entry.flag("open"),
        gaps=entry.text("gaps"),
        printed_as=entry.text("printed_as"),
        derived=(derived.text("flags") or derived.text("enum")) if derived else "",
        sparse=entry.flag("sparse"),
        members=tuple(_member(inner) for inner in entry.named("members", entry.path)),
    )


def _member(entry: Entry) -> Member:
    return Member(
        **entry.fact(),
        value=entry.integer("value") or 0,
        number=entry.integer("number"),
        unavailable=entry.flag("unavailable"),
        problem=entry.text("problem"),
        causes=tuple(
            Cause(inner.text("cause"), inner.texts("remedies"), inner.sources) for inner in entry.entries("causes")
        ),
        remedies=entry.texts("remedies"),
        aliases=entry.texts("aliases"),
    )


def flags(entry: Entry) -> Flags:
    """A bit field. Its bits are put in order, the lowest first: the order in which a spec lists them means nothing."""
    primitive = PRIMITIVES[entry.text("type")]
    bit_0 = entry.text("bit_0") or "least"
    highest = 8 * primitive.size - 1 if bit_0 == "most" else None
    bits = [_bit(inner, highest) for inner in entry.named("bits", entry.path)]
    return Flags(
        **entry.fact(),
        type=primitive,
        ranges=entry.whole_ranges("range"),
        bits=tuple(sorted(bits, key=lambda bit: bit.first)),
        states=tuple(
            State(**inner.fact(), set=inner.texts("set"), clear=inner.texts("clear"))
            for inner in entry.entries("states")
        ),
        bit_0=bit_0,
    )


def _bit(entry: Entry, highest: int | None) -> Bit:
    """A bit. Where the manual counts from the most significant bit, `highest` is the number of that one."""
    first = entry.integer("bit")
    last = first
    if span := entry.text("bits"):
        if first is not None:
            entry.refuse("wrong_form", "bit", "`bit` has no effect beside `bits`", "remove one of them")
        low, _, high = span.partition("..")
        first, last = int(low), int(high)
        if last < first:
            entry.refuse("wrong_form", "bits", "`bits` ends before it starts", f"write {last}..{first}")
            first, last = last, first
    if first is None or last is None:
        entry.refuse("wrong_form", "bits", "the bit has no number", "add `bit`, or `bits` as low..high")
        first = last = 0
    if highest is not None:
        first, last = highest - last, highest - first
    if first < 0:
        text = f"the word has no bit {entry.text('bits') or entry.integer('bit')}"
        entry.refuse("wrong_value", "bits" if entry.text("bits") else "bit", text, "correct the number or the type")
        first = last = 0
    scale = scale_of(entry)
    offset = entry.decimal("offset") or Decimal(0)
    default = default_of(entry, scale if scale is not None else Decimal(1), offset)
    reserved = entry.flag("reserved")
    arguments = entry.fact()
    if not arguments["name"]:
        if not reserved:
            entry.refuse("missing_key", "bit", "a bit with a meaning needs a name", "add a `name`")
        arguments["name"] = f"reserved_{first}"
    return Bit(
        **arguments,
        first=first,
        last=last,
        zero=entry.text("zero"),
        one=entry.text("one"),
        enum=entry.text("enum"),
        edge=entry.text("edge"),
        active=entry.text("active") or "high",
        reserved=reserved,
        handling=entry.handling(),
        when=entry.text("when"),
        signed=entry.flag("signed"),
        scale=scale if scale is not None else Decimal(1),
        scale_text=scale_text(entry.value("scale")),
        offset=offset,
        unit=entry.text("unit"),
        ranges=counts_of(entry, scale if scale is not None else Decimal(1), offset),
        default=default if isinstance(default, int) else None,
    )
