"""Fields that say whether others are sent, how many elements they have or which is the last, for random devices."""

from __future__ import annotations

from random_devices.draft import Draft, Spec
from random_devices.drawn_values import COUNT_DIGITS, size_of, value


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
    bits = [_deciding_bits(draft, 8 * size_of(decider)) for _ in range(3)]
    return decider, [{"by": decider["name"], **own, **({"is": 0} if draft.chance(20) else {})} for own in bits]


def _deciding_bits(draft: Draft, width: int) -> Spec:
    """A bit of a number, or several: next to each other, and apart now and then."""
    low = draft.number(0, width - 1)
    if low > width - 2 or draft.chance(65):
        return {"bit": low}
    high = draft.number(low + 1, width - 1)
    apart = f", {draft.number(high + 2, width - 1)}" if high < width - 2 and draft.chance(50) else ""
    return {"bits": f"{low}..{high}{apart}"}


def more_ways(draft: Draft, ways: list[Spec]) -> list[Spec]:
    """The ways in which a number that can say whether a field is sent says whether another element follows."""
    numbers = [{key: own for key, own in way.items() if key != "by"} for way in ways]
    return [{**own, "when": own["when"][:1]} if "when" in own and draft.chance(80) else own for own in numbers]


def continued_list(draft: Draft, presence: Spec | None) -> Spec:
    """A list whose elements say which of them is the last: numbers, or records that were drawn for this."""
    keys: Spec = {"repeat": f"1..{draft.number(2, 5)}", **({"present_if": presence} if presence is not None else {})}
    if draft.elements and draft.chance(60):
        name, ways = draft.pick(draft.elements)
        return draft.fact(record=name, more_if=draft.pick(ways), **keys)
    decider, ways = presence_decider(draft)
    return {**decider, **keys, "more_if": draft.pick(more_ways(draft, ways))}


def count_type(draft: Draft, kinds: tuple[str, ...]) -> Spec:
    """The type of a number of elements or bytes, or the digits that it is sent as."""
    return draft.pick(COUNT_DIGITS)[0] if draft.digits(15) else {"type": draft.pick(kinds)}


def list_counter(draft: Draft, repeated: Spec, measure: Spec, kinds: tuple[str, ...]) -> Spec:
    """A field that counts a list, or a text of varying length: as a whole, or now and then in some of its bits."""
    kind = draft.pick(kinds)
    if not draft.chance(30):
        return draft.fact(**count_type(draft, (kind,)), measures=measure)
    has_bytes = "bytes" in measure and "record" not in repeated
    size = size_of(repeated) if has_bytes and "varies" not in repeated else 1
    plus = {key: own for key, own in measure.items() if key == "plus"}
    elements = repeated["length"] if "varies" in repeated else int(repeated["repeat"].rpartition(".")[2]) * size
    most = elements + plus.get("plus", 0)
    width = most.bit_length() + draft.number(0, 1)
    kinds = ("u8", "u16", "u24", *["u32"] * draft.chance(20))
    kind = draft.pick([own for own in kinds if 8 * size_of({"type": own}) >= width])
    low = draft.number(0, 8 * size_of({"type": kind}) - width)
    # The bytes of a record are not known here.
    unit = "items" if size == 1 and "varies" not in repeated else "bytes"
    return draft.fact(type=kind, measures={unit: repeated["name"], **plus, "bits": f"{low}..{low + width - 1}"})


def text_counter(draft: Draft, text: Spec) -> Spec:
    """The field with the number of bytes of a text."""
    plus = {"plus": draft.number(1, 9)} if draft.chance(25) else {}
    count = list_counter(draft, text, {"bytes": text["name"], **plus}, ("u8", "u16"))
    if "bits" in count["measures"]:
        return count
    if count["type"] == "u16" and draft.chance(25):
        count["byte_order"] = draft.pick(("big", "little"))
    if draft.chance(15):
        count["range"] = f"{plus.get('plus', 0)}..{text['length'] + plus.get('plus', 0)}"
    return count


def optional_field(draft: Draft, presence: Spec) -> Spec:
    """A field that another one says is sent or not."""
    nested = [*(record.name for record in draft.records if not record.apart), *draft.differing]
    if nested and draft.chance(20):
        return draft.fact(record=draft.pick(nested), present_if=presence)
    keys = value(draft, "field")
    keys = {key: own for key, own in keys.items() if key not in ("const", "default", "unit_default", "parameter")}
    return draft.fact(**keys, present_if=presence)
