"""Fields that say whether others are sent, or how many elements they have, for random devices."""

from __future__ import annotations

from random_devices.draft import Draft, Spec
from random_devices.drawn_values import size_of


def presence_decider(draft: Draft) -> tuple[Spec, list[Spec]]:
    """A field, and ways in which it can say whether others are sent: by its bits, or by the members of its enum."""
    named = [enum for enum in draft.enums if all(0 <= number <= 0xFFFF for number in enum.members.values())]
    kind = draft.pick(("u8", "u8", "u16", "u16", "u24" if draft.chance(20) else "u8"))
    if named and draft.chance(40):
        enum = draft.pick(named)
        wide = any(number > 0xFF for number in enum.members.values())
        decider = draft.fact(type="u16" if wide else kind, enum=enum.name)
        members = list(enum.members)
        return decider, [{"by": decider["name"], "when": members[: draft.number(1, len(members))]} for _ in range(2)]
    decider = draft.fact(type=kind)
    bits = [draft.number(0, 8 * size_of(decider) - 1) for _ in range(3)]
    return decider, [{"by": decider["name"], "bit": bit, **({"is": 0} if draft.chance(20) else {})} for bit in bits]


def list_counter(draft: Draft, repeated: Spec, measure: Spec, kinds: tuple[str, ...]) -> Spec:
    """A field that counts a list: as a whole, or now and then in some of its bits."""
    kind = draft.pick(kinds)
    if not draft.chance(30):
        return draft.fact(type=kind, measures=measure)
    size = size_of(repeated) if "bytes" in measure and "record" not in repeated else 1
    plus = {key: own for key, own in measure.items() if key == "plus"}
    most = int(repeated["repeat"].rpartition(".")[2]) * size + plus.get("plus", 0)
    width = most.bit_length() + draft.number(0, 1)
    kinds = ("u8", "u16", "u24", *["u32"] * draft.chance(20))
    kind = draft.pick([own for own in kinds if 8 * size_of({"type": own}) >= width])
    low = draft.number(0, 8 * size_of({"type": kind}) - width)
    unit = "items" if size == 1 else "bytes"  # the bytes of a record are not known here
    return draft.fact(type=kind, measures={unit: repeated["name"], **plus, "bits": f"{low}..{low + width - 1}"})
