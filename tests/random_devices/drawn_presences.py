"""Fields that say whether others are sent, for random devices."""

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
