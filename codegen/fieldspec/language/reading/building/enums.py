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
    return entry.built(
        Enum,
        kind=entry.text("kind") or "enum",
        derived=(derived.text("flags") or derived.text("enum")) if derived else "",
        members=tuple(_member(inner) for inner in entry.named("members", entry.path)),
    )


def _member(entry: Entry) -> Member:
    return entry.built(Member, causes=tuple(inner.built(Cause) for inner in entry.entries("causes")))


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
        states=tuple(inner.built(State) for inner in entry.entries("states")),
        bit_0=bit_0,
    )


def _bit(entry: Entry, highest: int | None) -> Bit:
    """A bit. Where the manual counts from the most significant bit, `highest` is the number of that one."""
    pieces = bit_pieces(entry)
    if highest is not None:
        pieces = [(highest - last, highest - first) for first, last in reversed(pieces)]
    first, last = min(first for first, _ in pieces), max(last for _, last in pieces)
    if first < 0:
        text = f"the word has no bit {entry.text('bits') or entry.integer('bit')}"
        entry.refuse("wrong_value", "bits" if entry.text("bits") else "bit", text, "correct the number or the type")
        first, last, pieces = 0, 0, pieces[:1]
    scale = scale_of(entry)
    offset = entry.decimal("offset") or Decimal(0)
    default = default_of(entry, scale if scale is not None else Decimal(1), offset)
    reserved = entry.flag("reserved")
    arguments = entry.fact()
    if not arguments["name"]:
        if not reserved:
            entry.refuse("missing_key", "bit", "a bit with a meaning needs a name", "add a `name`")
        arguments["name"] = f"reserved_{first}"
    return entry.built(
        Bit,
        **arguments,
        first=first,
        last=last,
        active=entry.text("active") or "high",
        reserved=reserved,
        handling=entry.handling(),
        scale=scale if scale is not None else Decimal(1),
        scale_text=scale_text(entry.value("scale")),
        offset=offset,
        ranges=counts_of(entry, scale if scale is not None else Decimal(1), offset),
        default=default if isinstance(default, int) else None,
        pieces=tuple(pieces) if len(pieces) > 1 else (),
    )


def bit_pieces(entry: Entry) -> list[tuple[int, int]]:
    """The first and the last bit of each run of adjacent bits, as the manual counts; one unless they lie apart."""
    number, text = entry.integer("bit"), entry.text("bits")
    if text and number is not None:
        entry.refuse("wrong_form", "bit", "`bit` has no effect beside `bits`", "remove one of them")
    if not text:
        if number is None:
            entry.refuse("wrong_form", "bits", "the bit has no number", "add `bit`, or `bits` as low..high")
        return [(number or 0, number or 0)]
    pieces: list[tuple[int, int]] = []
    for piece in text.split(","):
        low, _, high = piece.strip().partition("..")
        first, last = int(low), int(high or low)
        if last < first:
            entry.refuse("wrong_form", "bits", "`bits` ends before it starts", f"write {last}..{first}")
            first, last = last, first
        if pieces and first == pieces[-1][1] + 1:
            joined = f"{pieces[-1][0]}..{last}"
            entry.refuse("wrong_form", "bits", f"bit {first} follows bit {first - 1}", f"write {joined}")
        if any(first <= other_last and other_first <= last for other_first, other_last in pieces):
            entry.refuse("wrong_form", "bits", f"`bits` has bit {first} twice", "name each bit once")
            continue
        pieces.append((first, last))
    return pieces
