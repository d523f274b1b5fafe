"""Random fields whose type another field decides, or some bits of it."""

from __future__ import annotations

from random_devices.draft import BOUNDS, SIZES, Draft, EnumDraft, Spec
from random_devices.drawn_presences import count_type
from random_devices.drawn_values import value, varying_text


def closed_enums(draft: Draft) -> list[EnumDraft]:
    """The enums that may decide the type of a field."""
    return [e for e in draft.enums if len(e.members) > 1 and all(0 <= n <= 0xFFFF for n in e.members.values())]


def deciding_fields(draft: Draft) -> tuple[Spec, Spec] | None:
    """A field with an enum, maybe in some of its bits, and one whose type that decides; None where no enum can."""
    words = _deciding_bits(draft)
    if words and draft.chance(60):
        word, bits, enum = draft.pick(words)
        selector = draft.fact(type=draft.flags[word], flags=word)
        return selector, draft.fact(choice={"by": selector["name"], "bits": bits, "cases": _cases(draft, enum)})
    closed = closed_enums(draft)
    if not closed:
        return None
    enum = draft.pick(closed)
    wide = any(n > 0xFF for n in enum.members.values())
    kind = draft.pick(("u16", "u32")) if wide else draft.pick(("u8", "u16"))
    selector = draft.fact(type=kind, enum=enum.name)
    return selector, draft.fact(choice={"by": selector["name"], "cases": _cases(draft, enum)})


def _deciding_bits(draft: Draft) -> list[tuple[str, str, EnumDraft]]:
    """Words with some bits whose enum may decide the type of a field."""
    enums = {enum.name: enum for enum in draft.enums if len(enum.members) > 1}
    return [
        (word["name"], bit["bits"], enums[bit["enum"]])
        for word in draft.spec.get("flags", ())
        if SIZES[word["type"]] <= 4 and "bit_0" not in word
        for bit in word["bits"]
        if bit.get("enum") in enums and "bits" in bit and "," not in bit["bits"] and not BOUNDS & set(bit)
    ]


def _cases(draft: Draft, enum: EnumDraft) -> list[Spec]:
    """Types for the members of an enum."""
    left = list(enum.members)
    cases = []
    while left and len(cases) < 4:
        width = draft.number(1, 2)
        cases.append(draft.fact(when=left[:width], **value(draft, "case")))
        left = left[width:]
    return cases


def leave_empty(draft: Draft, choice: Spec) -> None:
    """Lets the last case of a field with several types have no bytes, now and then."""
    cases = choice["choice"]["cases"]
    if len(cases) > 1 and draft.chance(25):
        _retype(cases[-1], {"type": "bytes", "length": 0})


def _retype(case: Spec, keys: Spec) -> None:
    """Gives a case another type."""
    stated = {key: case[key] for key in ("name", "when", "source", "doc", "label") if key in case}
    case.clear()
    case |= {**stated, **keys}


def choice_counter(draft: Draft, choice: Spec) -> Spec:
    """The number of bytes of a field with several types: now and then, texts or bytes of varying length."""
    for case in choice["choice"]["cases"][: draft.number(0, 2)]:
        varying_bytes = {"type": "bytes", "length": draft.number(1, 9), "varies": True}
        _retype(case, varying_bytes if draft.chance(50) else varying_text(draft))
    plus = {"plus": draft.pick((1, 2, 5))} if draft.chance(25) else {}
    count = draft.fact(**count_type(draft, ("u8", "u16")), measures={"bytes": choice["name"], **plus})
    if count["type"] == "u16" and draft.chance(25):
        count["byte_order"] = draft.pick(("big", "little"))
    return count
