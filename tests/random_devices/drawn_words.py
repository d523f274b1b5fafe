"""Random enums, words of bits, and signals."""

from __future__ import annotations

from decimal import Decimal
from itertools import pairwise

from random_devices.draft import (
    BOUNDS,
    ODD_COUNTS,
    ODD_INTEGERS,
    SIZES,
    Draft,
    EnumDraft,
    Spec,
    bounds,
    number,
    range_text,
)
from random_devices.drawn_values import value


def enums(draft: Draft) -> list[Spec]:
    """Enums whose members fit some integer type; closed and open, with gaps and members that are not available."""
    return [_enum(draft) for _ in range(draft.number(1, 4))]


def _enum(draft: Draft) -> Spec:
    kinds = ("u24", "i24", "u40", "i48") if draft.chance(15) else ("u8", "u8", "i8", "u16", "i16", "u32", "i64")
    low, high = bounds(draft.pick(kinds))
    numbers = sorted({draft.edge(low, high) for _ in range(draft.number(1, 5))})
    if draft.chance(50):
        numbers = list(range(draft.number(0, 2), draft.number(3, 6)))
    enum = draft.fact(members=[])
    if draft.chance(30):
        enum["open"] = True
    if draft.chance(20):
        enum["kind"] = draft.pick(("alarm", "fault", "error", "type", "enum", "warning"))
    for at in numbers:
        member: Spec = {"value": at, "name": draft.name()}
        if at == numbers[-1] and len(numbers) > 1:
            draft.bounded(member, 10)
        if draft.chance(5) and at != numbers[0]:
            member["unavailable"] = True
        if draft.chance(20):
            member["aliases"] = [draft.name() for _ in range(draft.number(1, 2))]
        enum["members"].append(member)
    gaps = [f"{a + 1}..{b - 1}" for a, b in pairwise(numbers) if b > a + 1]
    if gaps and draft.chance(50):
        enum["sparse"] = True
    elif gaps:
        enum["gaps"] = f"{', '.join(gaps)}: the manual leaves them out"
    members = {m["name"]: m["value"] for m in enum["members"] if not ({"unavailable"} | BOUNDS) & set(m)}
    everything = {m["name"]: m["value"] for m in enum["members"]}
    draft.enums.append(EnumDraft(enum["name"], members if len(members) > 1 else everything, bool(enum.get("open"))))
    return enum


def flags(draft: Draft) -> list[Spec]:
    """Words of bits: bits, fields of several bits with and without an enum, reserved ones, states."""
    return [_flags(draft) for _ in range(draft.number(0, 3))]


def _flags(draft: Draft, kind: str = "") -> Spec:
    kind = kind or draft.pick(ODD_COUNTS if draft.chance(30) else ("u16", "u8", "u32", "u64"))
    word = draft.fact(type=kind, bits=[])
    at = draft.number(0, 2)
    while at < 8 * SIZES[kind] and len(word["bits"]) < 6:
        bit, width = _bit(draft, at, 8 * SIZES[kind])
        word["bits"].append(bit)
        at += width + (draft.number(0, 9) if draft.chance(40) else 0)
    if draft.chance(25):
        _move_apart(draft, word)
    if draft.chance(20):
        word["bits"].reverse()
    single = [bit["name"] for bit in word["bits"] if "bit" in bit and not ({"reserved"} | BOUNDS) & set(bit)]
    if len(single) > 1 and draft.chance(25):
        word["states"] = [draft.fact(set=single[:1], clear=single[1:2]), draft.fact(set=single[1:2], clear=single[:1])]
    draft.flags[word["name"]] = kind
    if draft.chance(25):
        _count_from_most(word)
    if any({"range", "unit_range"} & set(bit) for bit in word["bits"]):
        draft.ranged.add(word["name"])
    return word


def _count_from_most(word: Spec) -> None:
    """Numbers the bits of a word from the most significant one, as some manuals do."""
    highest = 8 * SIZES[word["type"]] - 1
    word["bit_0"] = "most"
    for bit in word["bits"]:
        count_from_other_end(bit, highest)


def count_from_other_end(bit: Spec, highest: int) -> None:
    """Numbers the bits of an entry from the other end of its word, whose last bit is `highest`."""
    if "bit" in bit:
        bit["bit"] = highest - bit["bit"]
    else:
        bit["bits"] = pieces_text([highest - place for place in reversed(places_of(bit))])


def _move_apart(draft: Draft, word: Spec) -> None:
    """Lets some bits of a word change their places, so that those of a number lie apart."""
    places = list(range(8 * SIZES[word["type"]]))
    for _ in range(draft.number(1, 4)):
        first, second = draft.pick(places), draft.pick(places)
        places[first], places[second] = places[second], places[first]
    for bit in word["bits"]:
        moved = [places[place] for place in places_of(bit)]
        if "bit" in bit:
            bit["bit"] = moved[0]
        else:
            bit["bits"] = pieces_text(moved)


def places_of(bit: Spec) -> list[int]:
    """The bits of a word that an entry names, in its order."""
    if "bit" in bit:
        return [bit["bit"]]
    runs = [piece.strip().partition("..") for piece in bit["bits"].split(",")]
    return [place for first, _, last in runs for place in range(int(first), int(last or first) + 1)]


def pieces_text(places: list[int]) -> str:
    """Places as `bits` of an entry: `8..14, 0`"""
    runs: list[list[int]] = []
    for place in places:
        if runs and place == runs[-1][1] + 1:
            runs[-1][1] = place
        else:
            runs.append([place, place])
    return ", ".join(str(first) if first == last else f"{first}..{last}" for first, last in runs)


_BARE = {"name", "at", "type", "access", "source", "checked", "label", "doc", "notes"}


def place_bits(draft: Draft) -> None:
    """Some registers of whole numbers without any meaning state bits in place."""
    for group in draft.spec.get("registers", ()):
        for row in group["rows"]:
            if row.get("type") in ("u8", "u16", "u32", "u64", *ODD_COUNTS) and set(row) <= _BARE and draft.chance(60):
                row["bits"] = _flags(draft, row["type"])["bits"]


def derived_enums(draft: Draft) -> list[Spec]:
    """Enums whose members are the masks of the bits of a word, or the second numbers of the members of another enum."""
    drawn = []
    for word in draft.spec["flags"]:
        own = [bit for bit in word["bits"] if "bit" in bit and "name" in bit]
        barred = {"reserved"} | BOUNDS
        if len(own) > 1 and draft.chance(25) and not any(barred & set(bit) for bit in own):
            highest = 8 * SIZES[word["type"]] - 1
            places = [highest - bit["bit"] if word.get("bit_0") == "most" else bit["bit"] for bit in own]
            members = {bit["name"]: 1 << place for bit, place in zip(own, places, strict=True)}
            drawn.append(_derived(draft, {"flags": word["name"]}, members))
    for enum in draft.spec["enums"]:
        own = enum["members"]
        if len(own) > 1 and draft.chance(15) and not any(BOUNDS & set(member) for member in own):
            numbers = sorted({draft.number(0, 200) for _ in own})
            if len(numbers) == len(own):
                for member, number in zip(own, numbers, strict=True):
                    member["number"] = number
                members = {member["name"]: member["number"] for member in own if not member.get("unavailable")}
                drawn.append(_derived(draft, {"enum": enum["name"]}, members))
    return drawn


def _derived(draft: Draft, source: Spec, members: dict[str, int]) -> Spec:
    enum = draft.fact(derived=source, sparse=True)
    if draft.chance(30) and 0 not in members.values():
        enum["members"] = [{"value": 0, "name": draft.name()}]
        members = {enum["members"][0]["name"]: 0, **members}
    if draft.chance(50):
        enum["open"] = True
    draft.enums.append(EnumDraft(enum["name"], members, bool(enum.get("open"))))
    return enum


def _bit(draft: Draft, at: int, most: int) -> tuple[Spec, int]:
    bit = draft.bounded(draft.fact(), 3)
    width = min(draft.number(2, 9), most - at)
    if draft.chance(30) and width > 1:
        bit["bits"] = f"{at}..{at + width - 1}"
        fitting = [e for e in draft.enums if all(0 <= n < 1 << width for n in e.members.values())]
        if fitting and draft.chance(40):
            enum = draft.pick(fitting)
            bit["enum"] = enum.name
            if draft.chance(30):
                bit["default"] = draft.pick(tuple(enum.members.values()))
        elif draft.chance(60):
            _number(draft, bit, width)
        return bit, width
    bit["bit"] = at
    if draft.chance(15):
        bit["active"] = draft.pick(("low", "high"))
    if draft.chance(15):
        bit["edge"] = draft.pick(("rising", "falling"))
    if draft.chance(10):
        bit |= {"zero": "off", "one": "on"}
    if draft.chance(8):
        bit["reserved"] = True
    elif draft.chance(15):
        bit["default"] = draft.number(0, 1)
    return bit, 1


def _number(draft: Draft, bit: Spec, width: int) -> None:
    """A sign, a scale, a range and a default for a field of bits."""
    if draft.chance(50):
        bit["signed"] = True
    high = (1 << (width - ("signed" in bit))) - 1
    intervals = draft.intervals(-high - 1 if "signed" in bit else 0, high)
    if draft.chance(30):
        bit |= {"scale": 0.5, "unit": "mm"}
        bit["unit_range"] = ", ".join(f"{low / 2}..{high / 2}" for low, high in intervals)
        if draft.chance(40):
            bit["unit_default"] = number(Decimal(draft.number(*intervals[-1])) / 2)
    else:
        bit["range"] = range_text(intervals)
        if draft.chance(40):
            bit["default"] = draft.number(*intervals[0])


def signals(draft: Draft, most: int = 4) -> list[Spec]:
    """Values that telegrams carry."""
    drawn = [draft.fact(**value(draft, "signal")) for _ in range(draft.number(1, most))]
    draft.signals = {signal["name"]: signal for signal in drawn}
    return drawn


def conversions(draft: Draft) -> list[Spec]:
    """Counts of signals that are fractions of a reference."""
    counts = [
        name
        for name, signal in draft.signals.items()
        if signal["type"] in ("i16", "u16", "i32", *ODD_INTEGERS) and len(signal) == 3
    ]
    return [draft.fact(signals=[name], full_scale=draft.number(1, 0x4000)) for name in counts if draft.chance(60)]
